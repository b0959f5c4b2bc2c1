// SPDX-License-Identifier: MIT
// The Python module `daylight`: the proved verdict and the distance, of one pair or of NumPy arrays. A solid
// is eight float64 (center (3), axis (3), radius, height), or nine with its rounding. Or it is a dict with
// the fields of the case files. Arithmetic runs without the interpreter's lock. C-contiguous float64 is read
// in place.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_words.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/decide_exactly.hpp"
#include "solver/distance.hpp"

namespace py = pybind11;

namespace {

using namespace cyl;
using Doubles = py::array_t<double, py::array::c_style>;

std::string shape_of(const Doubles& array) { return py::str(array.attr("shape")).cast<std::string>(); }

Doubles solids(const std::string& name, const py::object& given) {
  Doubles array = Doubles::ensure(given);
  if (!array) {
    PyErr_Clear();
    throw py::value_error(name + " is not an array of float64, or of a type that NumPy casts to it safely");
  }
  const py::ssize_t width = array.ndim() == 0 ? 0 : array.shape(array.ndim() - 1);
  if (width != py::ssize_t{core_number_count} && width != py::ssize_t{cylinder_number_count})
    throw py::value_error(name + " has shape " + shape_of(array) +
                          ", not (.., 8) or (.., 9): center (3), axis (3), radius, height, rounding");
  return array;
}

// Reads the dicts among a and b as the case files are read. A sphere takes the place of an array.
std::optional<Pair> named_solids(const py::object& a, const py::object& b) {
  const bool by_name[] = {py::isinstance<py::dict>(a), py::isinstance<py::dict>(b)};
  if (!by_name[0] && !by_name[1]) return {};
  const py::module_ json = py::module_::import("json");
  const py::cpp_function listed([](const py::object& array) { return array.attr("tolist")(); });
  const auto text_of = [&](bool named, const char* name, const py::object& given) -> std::string {
    if (!named) return R"({"shape":"sphere","center":[0,0,0],"radius":0})";
    try {
      return py::str(json.attr("dumps")(given, py::arg("default") = listed));
    } catch (const py::error_already_set&) {
      throw py::value_error(std::string(name) + " has a value that is neither a number, a list nor a word");
    }
  };
  const CaseLine line =
      parse_case("{\"a\":" + text_of(by_name[0], "a", a) + ",\"b\":" + text_of(by_name[1], "b", b) + '}', 1);
  if (!line.value) throw py::value_error(line.error.substr(line.error.find(": ") + 2));  // without the place
  return line.value->pair;
}

// Two sets of solids of the same shape, or one solid against a set.
class Pairs {
 public:
  Pairs(const py::object& a, const py::object& b)
      : named_(named_solids(a, b)),
        a_("a", a, named_ ? &named_->a : nullptr),
        b_("b", b, named_ ? &named_->b : nullptr) {
    const Side& longer = a_.step == 0 ? b_ : a_;
    const Doubles &x = a_.array, &y = b_.array;
    if (a_.step != 0 && b_.step != 0 &&
        !(x.ndim() == y.ndim() && std::equal(x.shape(), x.shape() + x.ndim() - 1, y.shape())))
      throw py::value_error("a has shape " + shape_of(x) + " and b " + shape_of(y) +
                            ": they must be as many, or one of them (8,) or (9,)");
    shape_.assign(longer.array.shape(), longer.array.shape() + longer.array.ndim() - 1);
    size = longer.array.size() / static_cast<py::ssize_t>(longer.width);
  }
  Solid a(py::ssize_t i) const { return a_.solid(i); }
  Solid b(py::ssize_t i) const { return b_.solid(i); }
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
  struct Side {
    // `read` is what a dict stands for. Its eight numbers then only give the side the form of one solid.
    Side(const char* name, const py::object& given, const Solid* read)
        : named(read && py::isinstance<py::dict>(given) ? std::optional(*read) : std::nullopt),
          array(named ? Doubles(py::ssize_t{core_number_count}) : solids(name, given)),
          data(array.data()),
          width(static_cast<std::size_t>(array.shape(array.ndim() - 1))),
          step(array.ndim() == 1 ? 0 : static_cast<py::ssize_t>(width)) {}
    Solid solid(py::ssize_t i) const { return named ? *named : cylinder_of(data + i * step, width); }
    std::optional<Solid> named;
    Doubles array;
    const double* data;
    std::size_t width;
    py::ssize_t step;
  };
  std::optional<Pair> named_;
  Side a_, b_;
  std::vector<py::ssize_t> shape_;
};

py::object check(const py::object& a, const py::object& b) {
  const Pairs pairs(a, b);
  auto codes = pairs.results<std::int8_t>();
  std::int8_t* const out = codes.mutable_data();
  {
    const py::gil_scoped_release unlocked;
    for (py::ssize_t i = 0; i < pairs.size; ++i)
      out[i] = static_cast<std::int8_t>(decide_exactly(pairs.a(i), pairs.b(i)).verdict);
  }
  if (pairs.single()) return py::module_::import("daylight").attr("Verdict")(static_cast<int>(*out));
  return codes;
}

// The solver has no distance of half-spaces and boxes, but the referee does.
Distance measured(const Solid& a, const Solid& b) {
  const Pair pair{a, b};
  if (!has_half_space(pair) && !has_box(pair)) return distance(a, b);
  Distance found;
  const Truth truth = decide_exactly(a, b);
  found.verdict = truth.verdict;
  if (truth.verdict == Verdict::invalid) return found;
  const Enclosure exact = enclose_distance(pair, truth);
  const MeasuredDistance near = measure_with_points(pair);
  found.value = exact.lo / 2 + exact.hi / 2;
  found.error = exact.hi - exact.lo;  // twice what it may be: room for the rounding of the middle
  found.direction = near.direction;
  found.on_a = near.on_a;
  found.on_b = near.on_b;
  return found;
}

py::object distance_of(const py::object& a, const py::object& b) {
  const Pairs pairs(a, b);
  auto value = pairs.results<double>(), error = pairs.results<double>();
  auto direction = pairs.results<double>(3), on_a = pairs.results<double>(3), on_b = pairs.results<double>(3);
  double *const value_out = value.mutable_data(), *const error_out = error.mutable_data();
  double* const vectors[] = {direction.mutable_data(), on_a.mutable_data(), on_b.mutable_data()};
  {
    const py::gil_scoped_release unlocked;
    for (py::ssize_t i = 0; i < pairs.size; ++i) {
      const Distance found = measured(pairs.a(i), pairs.b(i));
      value_out[i] = found.value;
      error_out[i] = found.error;
      const Vector3* const from[] = {&found.direction, &found.on_a, &found.on_b};
      for (int v = 0; v < 3; ++v) std::copy_n(from[v]->data(), 3, vectors[v] + 3 * i);
    }
  }
  const auto number = [&](const Doubles& x) -> py::object {
    if (pairs.single()) return py::float_(*x.data());
    return x;
  };
  return py::module_::import("daylight")
      .attr("Distance")(number(value), number(error), direction, on_a, on_b);
}

// The text of help(daylight). It repeats units, shapes and errors of the headers.
constexpr const char* module_text = R"(Do two solids intersect? With proofs.

A solid is eight float64: center (3), axis (3, any finite length but 0), radius,
height (full, not half), with lengths in one unit. A ninth float64 is the
rounding: all points within that length of the cylinder belong to the solid.
Solids are closed, so solids that touch intersect. Radius 0 is a segment, and
height 0 is a disk. With rounding a segment is a capsule, and a point a sphere.

Or a solid is a dict with the fields of the case files, such as
{"shape": "half_space", "point": [0, 0, 0], "normal": [0, 0, 1]}. The shapes are
cylinder, capsule, sphere, half_space and box. It counts as a single solid.

a and b have shapes (.., 8) or (.., 9) of as many solids, or one of them is a
single solid. Two single solids give a Verdict and floats. Arrays give, for each
pair, int8 (the values of Verdict) and float64. C-contiguous float64 is read in
place, without the interpreter's lock. Do not write to it meanwhile. Lists,
float32 and other types that NumPy casts safely are copied.

Other shapes and types raise ValueError. So does a dict that is not legal. An
array with a solid that is not legal (nan, a negative radius, axis 0) raises
nothing. Its verdict is `invalid`.)";

constexpr const char* check_text = R"(The proved verdict; touching is a verdict of its own.

Returns a Verdict, or an int8 array of shape (..): disjoint, intersecting,
touching or invalid. undecided is returned only for a tangency without a proof.
The cost is 0.1 us on most pairs, 0.1 ms within rounding of touching, and up to
some ms for exact ties.)";

constexpr const char* distance_text = R"(The signed distance with its error.

Returns Distance(value, error, direction, on_a, on_b), in the unit of the
arguments. value and error are floats or float64 of shape (..). direction, on_a
and on_b have shape (.., 3). All are 0 for a solid that is not legal.
value > 0, apart: the gap, |value - exact| <= error.
value <= 0: minus the depth. The exact depth is at most -value + error. It is not
proved that no direction is shallower.
direction: a unit vector from a to b. If b moves along it by -value + error, it
contains no inner point of a.
on_a, on_b: the points, as offsets from the centers of a and of b.)";

}  // namespace

PYBIND11_MODULE(daylight, m) {
  m.doc() = module_text;
  py::dict words;
  for (const Verdict v : enum_values<Verdict>) words[to_string(v)] = static_cast<int>(v);
  const py::str here("daylight");
  m.attr("Verdict") = py::module_::import("enum").attr("IntEnum")("Verdict", words, py::arg("module") = here);
  m.attr("Distance") =
      py::module_::import("collections")
          .attr("namedtuple")("Distance", "value error direction on_a on_b", py::arg("module") = here);
  m.def("check", &check, py::arg("a"), py::arg("b"), check_text);
  m.def("distance", &distance_of, py::arg("a"), py::arg("b"), distance_text);
}
