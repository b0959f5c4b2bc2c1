// SPDX-License-Identifier: MIT
#include "oracles/referee/decide_exactly.hpp"

namespace cyl {
namespace {

bool flat(const Cylinder& c) { return c.radius == 0 || c.height == 0; }

}  // namespace

// The points of two flat solids may all be of touching, and the point of a hull has yet to be found.
Truth decide_exactly(const Cylinder& a, const Cylinder& b) {
  const Answer answer = decide(a, b);
  if (answer.proof == Proof::none) return judge({a, b});
  const Certificate certificate = certificate_of(answer);
  if (answer.proof == Proof::point && (certificate.hulls != Certificate{}.hulls || (flat(a) && flat(b)))) {
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
