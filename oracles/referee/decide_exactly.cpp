// SPDX-License-Identifier: MIT
#include "oracles/referee/decide_exactly.hpp"

#include <array>

namespace cyl {

Certificate certificate_of(const Answer& answer) {
  const auto doubles = [](const Vector3& v) { return std::array<double, 3>{v[0], v[1], v[2]}; };
  switch (answer.proof) {
    case Proof::none:
      break;
    case Proof::direction:
      return {CertificateKind::direction, {doubles(answer.direction), {}, {}}, {}};
    case Proof::point:
      return {CertificateKind::point, {doubles(answer.point_head), doubles(answer.point_tail), {}}, {}};
  }
  return {};
}

Truth decide_exactly(const Cylinder& a, const Cylinder& b) {
  const Answer answer = decide(a, b);
  if (answer.proof == Proof::none) return judge({a, b});
  Truth truth;
  truth.verdict = answer.verdict;
  truth.certificate = certificate_of(answer);
  return truth;
}

}  // namespace cyl
