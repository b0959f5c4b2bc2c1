// SPDX-License-Identifier: MIT
#include "oracles/trial/proofs.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace cyl {
namespace {

std::array<double, 16> numbers_of(const Pair& pair) {
  std::array<double, 16> x;
  double* next = x.data();
  for (const Cylinder* c : {&pair.a, &pair.b}) {
    next = std::copy_n(c->center.data(), 3, next);
    next = std::copy_n(c->axis.data(), 3, next);
    *next++ = c->radius;
    *next++ = c->height;
  }
  return x;
}

bool same(const Pair& x, const Pair& y) {
  const auto p = numbers_of(x), q = numbers_of(y);
  return std::memcmp(p.data(), q.data(), sizeof p) == 0;
}

}  // namespace

Proved& Proofs::of(const Pair& pair) {
  for (Proved& known : proved_)
    if (same(known.pair, pair)) return known;
  const bool own = same(pair, pair_);
  Proved& added = proved_.emplace_back(
      Proved{pair, judge(pair, own ? offered_ : std::span<const MethodAnswer>{}), LazyDistance({})});
  added.distance =
      LazyDistance([&added](double width) { return enclose_distance(added.pair, added.truth, width); });
  return added;
}

const Proved* Proofs::known(const Pair& pair) const {
  for (const Proved& known : proved_)
    if (same(known.pair, pair)) return &known;
  return nullptr;
}

bool beyond_claim(Proved& proved, const Claim& claim) {
  const Truth& truth = proved.truth;
  if (truth.verdict == Verdict::undecided || truth.verdict == Verdict::invalid) return false;
  const double from = reach(claim, size_of(proved.pair));
  return magnitude_against(from, truth, proved.distance).lo >= from;
}

}  // namespace cyl
