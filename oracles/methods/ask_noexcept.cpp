// SPDX-License-Identifier: MIT
#include "oracles/methods/ask_noexcept.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>

namespace cyl {
namespace {

bool all_finite(const MethodAnswer& a) {
  const auto finite = [](double x) { return std::isfinite(x); };
  return (!a.states_distance() || finite(a.distance)) &&
         (a.witness == CertificateKind::none ||
          (std::all_of(a.head, a.head + 3, finite) && std::all_of(a.tail, a.tail + 3, finite) &&
           std::all_of(a.other_head, a.other_head + 3, finite) &&
           std::all_of(a.other_tail, a.other_tail + 3, finite)));
}

bool well_formed(const MethodAnswer& a) {
  return a.status <= Status::failed && a.failure <= Failure::reported && a.verdict <= Verdict::invalid &&
         a.witness <= CertificateKind::points && a.witness != CertificateKind::near &&
         a.hulls[0] <= Hull::center && a.hulls[1] <= Hull::center && a.side_effect <= SideEffect::slow;
}

}  // namespace

MethodAnswer checked(MethodAnswer answer) {
  answer.reason[sizeof answer.reason - 1] = 0;
  if (!well_formed(answer)) {
    return failed_answer(Failure::malformed,
                         "no answer: status " + std::to_string(static_cast<int>(answer.status)) +
                             ", verdict " + std::to_string(static_cast<int>(answer.verdict)) + ", witness " +
                             std::to_string(static_cast<int>(answer.witness)));
  }
  if (answer.status == Status::answered && !all_finite(answer)) {
    answer.status = Status::failed;
    answer.failure = Failure::non_finite;
    answer.set_reason(answer.states_distance() && !std::isfinite(answer.distance)
                          ? "distance is " + std::to_string(answer.distance)
                          : "the witness is not finite");
  }
  return answer;
}

MethodAnswer ask_noexcept(Method& method, const Pair& pair, CallMode mode) {
  try {
    return checked(call(method, pair, mode));
  } catch (const std::exception& e) {
    return failed_answer(Failure::exception, e.what());
  } catch (...) {
    return failed_answer(Failure::exception, "thrown: not a std::exception");
  }
}

}  // namespace cyl
