// SPDX-License-Identifier: MIT
#include "oracles/referee/decide_exactly.hpp"

#include "solver/decide.hpp"

namespace cyl {

Truth decide_exactly(const Cylinder& a, const Cylinder& b) {
  const Answer answer = decide(a, b);
  if (answer.proof == Proof::none) return judge({a, b});
  Truth truth;
  truth.verdict = answer.verdict;
  const bool point = answer.proof == Proof::point;
  truth.certificate.kind = point ? CertificateKind::point : CertificateKind::direction;
  const Vector3 &head = point ? answer.point_head : answer.direction, &tail = answer.point_tail;
  for (int i = 0; i < 3; ++i) {
    truth.certificate.vector.head[static_cast<std::size_t>(i)] = head[i];
    if (point) truth.certificate.vector.tail[static_cast<std::size_t>(i)] = tail[i];
  }
  return truth;
}

}  // namespace cyl
