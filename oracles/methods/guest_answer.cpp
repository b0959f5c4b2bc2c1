// SPDX-License-Identifier: MIT
#include "oracles/methods/guest_answer.hpp"

#include <algorithm>

namespace cyl {

MethodAnswer method_answer(const GuestAnswer& said, bool depth_at_most) {
  if (!said.verdict && !said.declined) return failed_answer(Failure::reported, said.reason);
  MethodAnswer answer;
  if (said.declined) {
    answer.set_reason(said.reason);
    return answer;
  }
  answer.status = Status::answered;
  answer.verdict = *said.verdict;
  answer.has_distance = said.distance.has_value();
  answer.at_least = said.at_least.has_value();
  answer.distance = said.distance.value_or(said.at_least.value_or(0));
  if (depth_at_most) answer.bound_depth();
  const bool meet = answer.verdict == Verdict::intersecting || answer.verdict == Verdict::touching;
  if (said.point && (meet || !said.direction)) {
    answer.witness = CertificateKind::point;
    std::copy_n(said.point->data(), 3, answer.head);
    std::copy_n(said.point->data() + 3, 3, answer.tail);
  } else if (said.direction) {
    answer.set_direction(Vector3((*said.direction)[0], (*said.direction)[1], (*said.direction)[2]));
  }
  return answer;
}

}  // namespace cyl
