// SPDX-License-Identifier: MIT
#include "corpus/pairs/method_answer.hpp"

#include <algorithm>
#include <cstring>

namespace cyl {

void MethodAnswer::set_reason(std::string_view text) noexcept {
  const std::size_t length = std::min(text.size(), sizeof reason - 1);
  std::memcpy(reason, text.data(), length);
  std::memset(reason + length, 0, sizeof reason - length);
}

void MethodAnswer::bound_depth() noexcept {
  if (!has_distance || distance > 0 || verdict == Verdict::disjoint) return;
  has_distance = false;
  at_least = true;
}

void MethodAnswer::note(SideEffect effect, std::string_view what) noexcept {
  if (side_effect != SideEffect::none) return;
  side_effect = effect;
  if (status == Status::answered) set_reason(what);
}

void MethodAnswer::set_direction(const Vector3& d) noexcept {
  witness = CertificateKind::direction;
  std::copy_n(d.data(), 3, head);
}

void MethodAnswer::set_witness(const Certificate& certificate) noexcept {
  const ExactVector& v = certificate.vector;
  if (certificate.kind == CertificateKind::near || certificate.kind == CertificateKind::near_points ||
      !v.in_doubles() || !certificate.second.in_doubles())
    return;
  witness = certificate.kind;
  std::copy_n(v.head.data(), 3, head);
  std::copy_n(v.tail.data(), 3, tail);
  std::copy_n(certificate.second.head.data(), 3, other_head);
  std::copy_n(certificate.second.tail.data(), 3, other_tail);
  std::copy_n(certificate.hulls.data(), 2, hulls);
}

Certificate MethodAnswer::certificate() const {
  const auto vector = [](const double(&x)[3], const double(&y)[3]) {
    return ExactVector{{x[0], x[1], x[2]}, {y[0], y[1], y[2]}, {}};
  };
  return {witness, vector(head, tail), vector(other_head, other_tail), {hulls[0], hulls[1]}};
}

MethodAnswer answered(Verdict verdict) noexcept {
  MethodAnswer answer;
  answer.status = Status::answered;
  answer.verdict = verdict;
  return answer;
}

MethodAnswer declined_answer(std::string_view reason) noexcept {
  MethodAnswer answer;
  answer.set_reason(reason);
  return answer;
}

MethodAnswer declined_shape(SolidKind kind) noexcept {
  static constexpr std::array reasons{
      "it has no sphere",     "it has no capsule", "it has no cylinder",   "it has no rounded cylinder",
      "it has no half-space", "it has no box",     "it has no rounded box"};
  static_assert(reasons.size() == words_of(SolidKind{}).size());
  return declined_answer(reasons[static_cast<std::size_t>(kind)]);
}

MethodAnswer declined_size() noexcept {
  return declined_answer("it does not support these sizes or positions");
}

MethodAnswer failed_answer(Failure failure, std::string_view reason) noexcept {
  MethodAnswer answer;
  answer.status = Status::failed;
  answer.failure = failure;
  answer.set_reason(reason);
  return answer;
}

}  // namespace cyl
