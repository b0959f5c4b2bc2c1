// SPDX-License-Identifier: MIT
#include "oracles/referee/decide_exactly.hpp"

namespace cyl {

Truth decide_exactly(const Cylinder& a, const Cylinder& b) {
  const Answer answer = decide(a, b);
  if (answer.proof == Proof::none) return judge({a, b});
  Truth truth;
  truth.verdict = answer.verdict;
  truth.certificate = certificate_of(answer);
  return truth;
}

}  // namespace cyl
