// SPDX-License-Identifier: MIT
#include "oracles/referee/decide_exactly.hpp"

#include <array>

namespace cyl {
namespace {

bool flat(const Solid& c) { return c.radius == 0 || c.height == 0; }

}  // namespace

Certificate certificate_of(const Answer& answer, const Solid& a, const Solid& b) {
  const auto doubles = [](const Vector3& v) { return std::array<double, 3>{v[0], v[1], v[2]}; };
  switch (answer.proof) {
    case Proof::none:
      break;
    case Proof::direction:
      return {CertificateKind::direction, {doubles(answer.direction), {}, {}}, {}};
    case Proof::point:
      return {CertificateKind::point,
              {doubles(answer.point_head), doubles(answer.point_tail), {}},
              {},
              {answer.hull_a, answer.hull_b}};
    case Proof::points:
      return {CertificateKind::points,
              {doubles(a.center), doubles(answer.point_head), {}},
              {doubles(b.center), doubles(answer.point_tail), {}},
              {answer.hull_a, answer.hull_b}};
  }
  return {};
}

// Two flat solids may only touch at their point, and a point in hulls must still be computed.
Truth decide_exactly(const Solid& a, const Solid& b) {
  const Answer answer = decide(a, b);
  if (answer.proof == Proof::none) return judge({a, b});
  const Certificate certificate = certificate_of(answer, a, b);
  const bool in_hulls = certificate.hulls != Certificate{}.hulls;
  const bool rounded = a.rounding > 0 || b.rounding > 0;
  if (in_hulls || (answer.proof == Proof::point && !rounded && flat(a) && flat(b))) {
    MethodAnswer witness;
    witness.status = Status::answered;
    witness.set_witness(certificate);
    return judge({a, b}, {&witness, 1});
  }
  Truth truth;
  truth.verdict = answer.verdict;
  truth.certificate = certificate;
  return truth;
}

}  // namespace cyl
