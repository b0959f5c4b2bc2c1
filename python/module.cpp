// SPDX-License-Identifier: MIT
// The Python module `daylight`: the solver on NumPy arrays, and campaigns over a Python callable. A solid is
// eight float64 (center (3), axis (3), radius, height), or nine with its rounding. Arithmetic runs without
// the interpreter's lock. C-contiguous float64 is read in place.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/referee/decide_exactly.hpp"
#include "oracles/trial/trial.hpp"
#include "solver/distance.hpp"
#include "solver/intersect_batch.hpp"

namespace py = pybind11;

namespace cyl {

/// The names in Python.
constexpr auto words_of(Proof) noexcept { return std::array{"none", "direction", "point", "points"}; }

}  // namespace cyl

namespace {

using namespace cyl;
using Doubles = py::array_t<double, py::array::c_style>;

Doubles array_of(const Cylinder& c) {
  const auto numbers = numbers_of(c);
  const std::size_t count = c.rounding == 0 ? core_number_count : cylinder_number_count;
  Doubles array(static_cast<py::ssize_t>(count));
  std::copy_n(numbers.begin(), count, array.mutable_data());
  return array;
}

py::ssize_t width_of(const Doubles& solids) { return solids.shape(solids.ndim() - 1); }

Doubles solids(const std::string& name, const py::object& given) {
  Doubles array = Doubles::ensure(given);
  if (!array) {
    PyErr_Clear();
    const py::array found = py::array::ensure(given);
    PyErr_Clear();
    throw py::value_error(name +
                          (found ? " has dtype " + py::str(found.dtype()).cast<std::string>()
                                 : std::string(" is not an array")) +
                          ", not float64 or a type that NumPy casts to it safely");
  }
  if (array.ndim() == 0 || width_of(array) < py::ssize_t{core_number_count} ||
      width_of(array) > py::ssize_t{cylinder_number_count})
    throw py::value_error(name + " has shape " + py::str(array.attr("shape")).cast<std::string>() +
                          ", not (.., 8) or (.., 9): center (3), axis (3), radius, height, rounding");
  return array;
}

// Two sets of solids of the same shape, or one solid against a set.
class Pairs {
 public:
  Pairs(const py::object& a, const py::object& b) : a_(solids("a", a)), b_(solids("b", b)) {
    const bool one_a = a_.ndim() == 1, one_b = b_.ndim() == 1;
    const Doubles& longer = one_a ? b_ : a_;
    shape_.assign(longer.shape(), longer.shape() + longer.ndim() - 1);
    if (!one_a && !one_b &&
        !(a_.ndim() == b_.ndim() && std::equal(a_.shape(), a_.shape() + a_.ndim() - 1, b_.shape())))
      throw py::value_error("a has shape " + py::str(a_.attr("shape")).cast<std::string>() + " and b " +
                            py::str(b_.attr("shape")).cast<std::string>() +
                            ": they must be as many, or one of them (8,) or (9,)");
    size = longer.size() / width_of(longer);
    a_data_ = a_.data();
    b_data_ = b_.data();
    a_width_ = static_cast<std::size_t>(width_of(a_));
    b_width_ = static_cast<std::size_t>(width_of(b_));
    a_step_ = one_a ? 0 : width_of(a_);
    b_step_ = one_b ? 0 : width_of(b_);
  }
  Cylinder a(py::ssize_t i) const { return cylinder_of(a_data_ + i * a_step_, a_width_); }
  Cylinder b(py::ssize_t i) const { return cylinder_of(b_data_ + i * b_step_, b_width_); }
  bool single() const { return shape_.empty(); }
  /// Returns an array with one number per pair, or with `width` numbers per pair.
  template <class Number>
  py::array_t<Number> results(py::ssize_t width = 0) const {
    std::vector<py::ssize_t> shape = shape_;
    if (width > 0) shape.push_back(width);
    return py::array_t<Number>(shape);
  }

  py::ssize_t size = 0;

 private:
  Doubles a_, b_;
  std::vector<py::ssize_t> shape_;
  const double *a_data_ = nullptr, *b_data_ = nullptr;
  py::ssize_t a_step_ = 0, b_step_ = 0;
  std::size_t a_width_ = 0, b_width_ = 0;
};

using Codes = py::array_t<std::int8_t>;

// Returns a Verdict or Hull for one pair, and int8 for many.
py::object enum_of(const char* enumeration, const Pairs& pairs, const Codes& codes) {
  if (pairs.single())
    return py::module_::import("daylight").attr(enumeration)(static_cast<int>(*codes.data()));
  return codes;
}
py::object verdicts_of(const Pairs& pairs, const Codes& codes) { return enum_of("Verdict", pairs, codes); }
// Returns a float for one pair, and float64 for many.
py::object numbers_of(const Pairs& pairs, const Doubles& numbers) {
  if (pairs.single()) return py::float_(*numbers.data());
  return numbers;
}

void put(double* to, py::ssize_t i, const Vector3& x) {
  for (py::ssize_t k = 0; k < 3; ++k) to[3 * i + k] = x[k];
}

// The number of solids prepared at a time, which stay in the first cache.
constexpr py::ssize_t block_cap = 128;

py::object intersect_arrays(const py::object& a, const py::object& b) {
  const Pairs pairs(a, b);
  auto codes = pairs.results<std::int8_t>();
  std::int8_t* out = codes.mutable_data();
  {
    const py::gil_scoped_release unlocked;
    std::array<Prepared, block_cap> prepared_a, prepared_b;
    std::array<IndexPair, block_cap> same;
    std::array<Verdict, block_cap> verdicts;
    for (std::uint32_t i = 0; i < same.size(); ++i) same[i] = {i, i};
    for (py::ssize_t first = 0; first < pairs.size; first += block_cap) {
      const auto count = static_cast<std::size_t>(std::min(block_cap, pairs.size - first));
      for (std::size_t i = 0; i < count; ++i) {
        prepared_a[i] = prepare(pairs.a(first + static_cast<py::ssize_t>(i)));
        prepared_b[i] = prepare(pairs.b(first + static_cast<py::ssize_t>(i)));
      }
      intersect_batch(prepared_a, prepared_b, std::span(same).first(count), verdicts.data());
      for (std::size_t i = 0; i < count; ++i)
        out[first + static_cast<py::ssize_t>(i)] = static_cast<std::int8_t>(verdicts[i]);
    }
  }
  return verdicts_of(pairs, codes);
}

py::object within_arrays(const py::object& a, const py::object& b, double clearance) {
  const Pairs pairs(a, b);
  auto codes = pairs.results<std::int8_t>();
  std::int8_t* out = codes.mutable_data();
  {
    const py::gil_scoped_release unlocked;
    for (py::ssize_t i = 0; i < pairs.size; ++i)
      out[i] = static_cast<std::int8_t>(within(prepare(pairs.a(i)), prepare(pairs.b(i)), clearance));
  }
  return verdicts_of(pairs, codes);
}

py::object decide_exactly_arrays(const py::object& a, const py::object& b) {
  const Pairs pairs(a, b);
  auto codes = pairs.results<std::int8_t>();
  std::int8_t* out = codes.mutable_data();
  {
    const py::gil_scoped_release unlocked;
    for (py::ssize_t i = 0; i < pairs.size; ++i)
      out[i] = static_cast<std::int8_t>(decide_exactly(pairs.a(i), pairs.b(i)).verdict);
  }
  return verdicts_of(pairs, codes);
}

py::object decide_arrays(const py::object& a, const py::object& b) {
  const Pairs pairs(a, b);
  auto codes = pairs.results<std::int8_t>(), hull_a = pairs.results<std::int8_t>(),
       hull_b = pairs.results<std::int8_t>(), proof = pairs.results<std::int8_t>();
  auto direction = pairs.results<double>(3), head = pairs.results<double>(3), tail = pairs.results<double>(3);
  std::int8_t *out = codes.mutable_data(), *hull_a_out = hull_a.mutable_data(),
              *hull_b_out = hull_b.mutable_data(), *proof_out = proof.mutable_data();
  double *direction_out = direction.mutable_data(), *head_out = head.mutable_data(),
         *tail_out = tail.mutable_data();
  {
    const py::gil_scoped_release unlocked;
    for (py::ssize_t i = 0; i < pairs.size; ++i) {
      const Answer answer = decide(pairs.a(i), pairs.b(i));
      out[i] = static_cast<std::int8_t>(answer.verdict);
      put(direction_out, i, answer.direction);
      put(head_out, i, answer.point_head);
      put(tail_out, i, answer.point_tail);
      hull_a_out[i] = static_cast<std::int8_t>(answer.hull_a);
      hull_b_out[i] = static_cast<std::int8_t>(answer.hull_b);
      proof_out[i] = static_cast<std::int8_t>(answer.proof);
    }
  }
  return py::module_::import("daylight")
      .attr("Decision")(verdicts_of(pairs, codes), direction, head, tail, enum_of("Hull", pairs, hull_a),
                        enum_of("Hull", pairs, hull_b), enum_of("Proof", pairs, proof));
}

py::object distance_arrays(const py::object& a, const py::object& b) {
  const Pairs pairs(a, b);
  auto codes = pairs.results<std::int8_t>();
  auto value = pairs.results<double>(), error = pairs.results<double>();
  auto direction = pairs.results<double>(3), on_a = pairs.results<double>(3), on_b = pairs.results<double>(3);
  std::int8_t* out = codes.mutable_data();
  double *value_out = value.mutable_data(), *error_out = error.mutable_data();
  double *direction_out = direction.mutable_data(), *on_a_out = on_a.mutable_data(),
         *on_b_out = on_b.mutable_data();
  {
    const py::gil_scoped_release unlocked;
    for (py::ssize_t i = 0; i < pairs.size; ++i) {
      const Distance found = distance(pairs.a(i), pairs.b(i));
      out[i] = static_cast<std::int8_t>(found.verdict);
      value_out[i] = found.value;
      error_out[i] = found.error;
      put(direction_out, i, found.direction);
      put(on_a_out, i, found.on_a);
      put(on_b_out, i, found.on_b);
    }
  }
  return py::module_::import("daylight")
      .attr("Distance")(numbers_of(pairs, value), numbers_of(pairs, error), direction, on_a, on_b,
                        verdicts_of(pairs, codes));
}

std::optional<Verdict> verdict_from(const py::object& said) {
  if (py::isinstance<py::str>(said)) return from_word<Verdict>(said.cast<std::string>());
  // This accepts bool and numpy.bool_.
  if (said.attr("__class__").attr("__name__").cast<std::string>().starts_with("bool"))
    return said.cast<bool>() ? Verdict::intersecting : Verdict::disjoint;
  const int code = py::int_(said).cast<int>();
  if (code < 0 || code > static_cast<int>(Verdict::invalid)) return {};
  return static_cast<Verdict>(code);
}

MethodAnswer broken(Failure failure, const std::string& reason) {
  MethodAnswer answer;
  answer.status = Status::failed;
  answer.failure = failure;
  answer.set_reason(reason);
  return answer;
}

// Returns the callable's answer for a pair. An exception is an answer too, unless it ends the program.
MethodAnswer ask(const py::function& callable, const Doubles& a, const Doubles& b) {
  py::object said;
  try {
    said = callable(a, b);
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_Exception)) throw;
    return broken(Failure::exception, error.what());
  }
  MethodAnswer answer;
  if (said.is_none()) return answer;
  try {
    py::object word = said;
    if (py::isinstance<py::tuple>(said)) {
      const auto both = said.cast<py::tuple>();
      if (both.size() != 2) return broken(Failure::malformed, "a tuple is (verdict, distance)");
      word = both[0];
      answer.distance = py::float_(both[1]).cast<double>();
      answer.has_distance = true;
    }
    const std::optional<Verdict> verdict = verdict_from(word);
    if (!verdict) return broken(Failure::malformed, "no verdict: " + py::str(word).cast<std::string>());
    answer.status = Status::answered;
    answer.verdict = *verdict;
    return answer;
  } catch (const std::exception& error) {
    return broken(Failure::malformed, error.what());
  }
}

py::list campaign(const py::function& callable, std::uint64_t pairs, std::uint64_t seed, double relative,
                  double absolute) {
  for (const double part : {relative, absolute})
    if (!(part >= 0 && std::isfinite(part)))
      throw py::value_error("a claim is finite and not negative: relative " + format_double(relative) +
                            ", absolute " + format_double(absolute));
  const Claim claim{relative, absolute, "given to campaign()"};
  const py::object parse = py::module_::import("json").attr("loads");
  py::list findings;
  const auto all = families();
  for (std::uint64_t i = 0; i < pairs; ++i) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    const Family& family = all[i % all.size()];
    const std::uint64_t index = i / all.size();
    const Pair pair = family.generate(seed, index);
    const Doubles a = array_of(pair.a), b = array_of(pair.b);
    const MethodAnswer answer = ask(callable, a, b);
    Trial trial;
    std::optional<Finding> finding;
    {
      const py::gil_scoped_release unlocked;
      trial = Trial(pair);
      finding = compare(trial, claim, answer);
    }
    if (!finding) continue;
    py::dict entry;
    entry["family"] = py::str(family.name.data(), family.name.size());
    entry["index"] = index;
    entry["kind"] = to_string(finding->kind);
    entry["severity"] = to_string(finding->severity);
    entry["margin"] = py::none();
    if (finding->margin) entry["margin"] = py::make_tuple(finding->margin->lo, finding->margin->hi);
    // The arrays are made again, because the callable may have changed its own.
    entry["a"] = array_of(pair.a);
    entry["b"] = array_of(pair.b);
    entry["said"] = parse(format_method_answer(answer));
    entry["truth"] = parse(format_truth(trial.truth));
    findings.append(entry);
  }
  return findings;
}

// The text of help(daylight). It repeats units, shapes and errors of the headers.
constexpr const char* module_text = R"(Do two cylinders intersect? With proofs.

A solid is eight float64: center (3), axis (3, any finite length but 0), radius,
height (full, not half), with lengths in one unit. A ninth float64 is the
rounding: all points within that length of the cylinder belong to the solid.
Solids are closed, so solids that touch intersect. Radius 0 is a segment, and
height 0 is a disk. With rounding a segment is a capsule, and a point a sphere.

a and b have shapes (.., 8) or (.., 9) of as many solids, or one of them is a
single solid. Two single solids give a Verdict and floats. Arrays give, for each
pair, int8 (the values of Verdict) and float64. C-contiguous float64 is read in
place, without the interpreter's lock. Do not write to it meanwhile. Lists,
float32 and other types that NumPy casts safely are copied.

Other shapes and types raise ValueError. A solid that is not a cylinder (nan, a
negative radius, axis 0) raises nothing. Its verdict is `invalid`.)";

constexpr const char* intersect_text = R"(Yes or no; touching is yes.

Returns a Verdict, or an int8 array of shape (..): disjoint, intersecting or
invalid (undecided at a cap on work that no pair has reached). It is right if the
solids are 1e-13 of their size (the sum of radii and heights) or more from
touching. At smaller margins either answer is possible. Arrays use the vector
unit of the processor, with the same verdicts.)";

constexpr const char* within_text = R"(Are the solids within a clearance?

Returns the values of intersect: `intersecting` if their distance is at most the
clearance. The clearance is finite and not negative (otherwise `invalid`).)";

constexpr const char* decide_text = R"(The verdict with a proof, never wrong.

Returns Decision(verdict, direction, point_head, point_tail, hull_a, hull_b,
proof). direction and the points are float64 of shape (.., 3). The hulls are each
a Hull and proof is a Proof, or int8 of shape (..).
disjoint: `direction` points from a to b and is perpendicular to a plane that
separates them. Its length is not 1.
intersecting: if both hulls are `space`, the point point_head + point_tail (an
exact sum) is in both solids. Otherwise the proof is the nearest point to it in
both hulls: `plane`, through the solid's centre, perpendicular to its axis;
`line`, its axis; `center`. For rounded solids this holds for both cores, or proof
is `points`: a's center + point_head and b's center + point_tail are in the cores
of a and b (the nearest in its own hull), and are no farther apart than both
roundings together.
undecided: the solids are within 1e-13 of the size of touching, or are flat solids
with little in common. Use decide_exactly. Fields that do not belong to a verdict
are 0.)";

constexpr const char* decide_exactly_text = R"(The proved verdict; touching is a verdict of its own.

Returns a Verdict, or an int8 array of shape (..): disjoint, intersecting,
touching or invalid. undecided is returned only for a tangency without a proof.
The cost is that of decide if that is enough, 0.1 ms within rounding of touching,
and up to some ms for exact ties.)";

constexpr const char* distance_text = R"(The signed distance with its error.

Returns Distance(value, error, direction, on_a, on_b, verdict), in the unit of
the arguments. value and error are floats or float64 of shape (..). direction,
on_a and on_b have shape (.., 3).
value > 0, apart: the gap, |value - exact| <= error.
value <= 0: minus the depth. The exact depth is at most -value + error. It is not
proved that no direction is shallower.
direction: a unit vector from a to b. If b moves along it by -value + error, it
contains no inner point of a.
on_a, on_b: the points, as offsets from the centers of a and of b.
verdict: given by the sign of value. disjoint is proved if value > error.)";

constexpr const char* campaign_text = R"(Tests a callable on drawn pairs and returns its proved errors.

callable(a, b) gets two float64 arrays of shape (8,). It returns a bool (they
intersect), a Verdict, its value or its word, (verdict, signed distance), or None
to decline. An exception is a finding, but KeyboardInterrupt and similar ones end
the campaign.
pairs: how many. The same seed gives the same pairs, from all families in turn.
relative, absolute: the claim. If a pair is relative * size + absolute or more
from touching, the callable must be right. size is the sum of radii and heights.

Returns a list of dicts: family, index, kind ('wrong_disjoint', ...), severity
('contract' beyond the claim, 'resolution' within it, 'unresolved' if the truth
is not known), margin ((least, most) in sizes, or None), a, b, said, truth (with
its certificate). It runs in this thread, one pair at a time. It raises ValueError
for a claim that is negative or not finite.)";

}  // namespace

PYBIND11_MODULE(daylight, m) {
  m.doc() = module_text;
  const auto enumeration = [&m]<class Enum>(const char* name, Enum) {
    py::dict words;
    for (const Enum e : enum_values<Enum>) words[to_string(e)] = static_cast<int>(e);
    m.attr(name) = py::module_::import("enum").attr("IntEnum")(name, words, py::arg("module") = "daylight");
  };
  enumeration("Verdict", Verdict{});
  enumeration("Hull", Hull{});
  enumeration("Proof", Proof{});
  const auto record = [&m](const char* name, const char* fields) {
    m.attr(name) =
        py::module_::import("collections").attr("namedtuple")(name, fields, py::arg("module") = "daylight");
  };
  record("Decision", "verdict direction point_head point_tail hull_a hull_b proof");
  record("Distance", "value error direction on_a on_b verdict");

  m.def("intersect", &intersect_arrays, py::arg("a"), py::arg("b"), intersect_text);
  m.def("within", &within_arrays, py::arg("a"), py::arg("b"), py::arg("clearance"), within_text);
  m.def("decide", &decide_arrays, py::arg("a"), py::arg("b"), decide_text);
  m.def("decide_exactly", &decide_exactly_arrays, py::arg("a"), py::arg("b"), decide_exactly_text);
  m.def("distance", &distance_arrays, py::arg("a"), py::arg("b"), distance_text);
  m.def("campaign", &campaign, py::arg("callable"), py::arg("pairs") = 1000, py::arg("seed") = 0,
        py::arg("relative") = 0.0, py::arg("absolute") = 0.0, campaign_text);
}
