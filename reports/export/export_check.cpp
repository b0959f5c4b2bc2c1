// SPDX-License-Identifier: MIT
#include "reports/export/export_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/support.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/proofs.hpp"
#include "reports/export/export_program.hpp"

namespace cyl {
namespace {

/// The relative width of the distance. Its direction shows that the solids are apart.
constexpr double direction_width = 1e-9;
/// A relative length that pulls a rounded nearest point into its solid.
constexpr double pull_margin = 0x1p-40;

Certificate certificate_of(CertificateKind kind, const double (&head)[3]) {
  Certificate proof{.kind = kind, .vector = {}, .second = {}};
  std::copy_n(head, 3, proof.vector.head.begin());
  return proof;
}

Certificate direction_of(const AttainedDistance& attained) {
  return certificate_of(CertificateKind::direction,
                        {attained.direction[0], attained.direction[1], attained.direction[2]});
}

bool meet(const Truth& truth) {
  return truth.verdict == Verdict::intersecting || truth.verdict == Verdict::touching;
}

/// Uses the direction of the distance if it separates, because it shows the widest gap.
std::string answer_of(const Pair& pair, Truth truth) {
  if (truth.verdict == Verdict::disjoint) {
    const Certificate widest = direction_of(attain_distance(pair, truth, direction_width));
    MethodAnswer witness;
    witness.status = Status::answered;
    witness.set_direction({widest.vector.head[0], widest.vector.head[1], widest.vector.head[2]});
    if (check_witness(pair, witness) == Verdict::disjoint) truth.certificate = widest;
  }
  return format_truth(truth);
}

/// A library gets the rotation of a box as rounded elements. Each point of a solid moves by less than this
/// times the size.
constexpr double rotation_error = 0x1p-49;

bool is_rotation_exact(const Solid& c) {
  const auto edges = edge_directions<mpq_class>(c.quaternion);
  const Eigen::Matrix3d given = rotation_of(c);
  for (int i = 0; i < 3; ++i) {
    const Vec3<mpq_class>& e = edges[static_cast<std::size_t>(i)];
    if (e.x != given(0, i) || e.y != given(1, i) || e.z != given(2, i)) return false;
  }
  return true;
}

/// Throws std::runtime_error if a rounded rotation may change the truth. No quaternion states that rotation.
void check_rotations(const Trial& asked) {
  const auto rounded = [](const Solid& c) { return is_box(c) && !is_rotation_exact(c); };
  if (!rounded(asked.pair.a) && !rounded(asked.pair.b)) return;
  const double lost = rotation_error * size_of(asked.pair);
  if (!(asked.distance.lo > lost || asked.distance.hi < -lost))
    throw std::runtime_error(
        "the library gets a rounded rotation of a box, and the solids are too near touching to blame it");
}

std::string claims(const Trial& asked, AxesGiven axes) {
  const auto line = [](const char* name, const Pair& pair, const Truth& truth) {
    return fmt::format("    {{\"name\":\"{}\",\"pair\":{},\n     \"answer\":{}}},\n", name, format_pair(pair),
                       answer_of(pair, truth));
  };
  const std::string text = line("as asked", asked.pair, asked.truth);
  if (axes == AxesGiven::of_unit_length) check_rotations(asked);
  const Pair given = axes == AxesGiven::of_unit_length ? as_given(asked.pair) : asked.pair;
  if (given.a.axis == asked.pair.a.axis && given.b.axis == asked.pair.b.axis) return text;
  const Truth truth = judge(given);
  if (meet(truth) != meet(asked.truth))
    throw std::runtime_error(fmt::format(
        "the library is right: it gets axes rounded to unit length, and for these the truth is {}",
        to_string(truth.verdict)));
  return text + line("with the axes that the library gets", given, truth);
}

/// Returns the point of the core that is nearest to the given point.
std::optional<Rational3> point_in(const Solid& c, const Vector3& point) {
  const Pair twice{c, c};
  for (const double share : {1.0, 1 - pull_margin}) {
    const auto x = project_to_hulls(twice, exact(c.center + share * (point - c.center)));
    if (x && in_both_exact(twice, *x)) return x;
  }
  return {};
}

std::string said_line(const Pair& pair, const std::string& said) {
  return fmt::format("    {{\"pair\":{},\n     \"said\":{}}},\n", format_pair(pair), said);
}

/// Returns a claim that the returned distance is impossible for the pair as asked. "" if nothing proves it.
std::string distance_claim(const Trial& asked, const Claim& claim) {
  if (!asked.finding() || asked.finding()->kind != FindingKind::distance_outside) return {};
  const double said = asked.answer().distance, tolerance = reach(claim, size_of(asked.pair));
  Certificate proof;
  if (said < asked.distance.lo) {
    proof = direction_of(attain_distance(asked.pair, asked.truth, direction_width));
  } else {
    if (asked.truth.verdict != Verdict::disjoint || !(said > tolerance)) return {};
    Solid a = asked.pair.a, b = asked.pair.b;
    a.rounding = b.rounding = 0;
    const MeasuredDistance nearest = measure_with_points({a, b});
    const auto p = point_in(a, a.center + nearest.on_a), q = point_in(b, b.center + nearest.on_b);
    if (!p || !q) return {};
    const Rational3 between = *p - *q;
    const mpq_class allowed = mpq_class(said) - mpq_class(tolerance) + contact_distance_of(asked.pair);
    if (dot(between, between) >= allowed * allowed) return {};
    proof = {.kind = CertificateKind::points, .vector = exact_vector(*p), .second = exact_vector(*q)};
  }
  return said_line(asked.pair, fmt::format("{{\"distance\":{},\"tolerance\":{},{}", format_double(said),
                                           format_double(tolerance), format_certificate(proof).substr(1)));
}

std::string witness_claim(const Trial& asked) {
  if (!asked.finding() || asked.finding()->kind != FindingKind::bad_witness) return {};
  return said_line(asked.pair, format_certificate(asked.answer().certificate()));
}

}  // namespace

bool shows_distance(const Trial& asked, const Claim& claim) { return !distance_claim(asked, claim).empty(); }

std::string exact_check(const Trial& asked, const Claim& claim, AxesGiven axes) {
  constexpr std::string_view none = "CLAIMS = []";
  std::string text(template_text("exact.py"));
  return text.replace(
      text.find(none), none.size(),
      "CLAIMS = [\n" + claims(asked, axes) + distance_claim(asked, claim) + witness_claim(asked) + "]");
}

}  // namespace cyl
