// SPDX-License-Identifier: MIT
// The referee in the time of a fuzz target, which is microseconds. Costly checks run on a share of the
// pairs, drawn by the pair itself.
#pragma once

#include <span>

#include "corpus/pairs/random_stream.hpp"
#include "fuzz/guided/finding_sink.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {

/// The precision at which the referee stops beyond double: one round of MPFI.
inline constexpr int wide_bits_cap = 128;

/// Pairs for one in which a costly question is asked, so that none of them costs more than the cheap ones
/// together.
inline constexpr std::size_t wide_share = 128;       ///< the referee beyond double: 0.3 ms
inline constexpr std::size_t enclosed_share = 1024;  ///< the distance, enclosed: 1 ms, at the worst 100

class FuzzJudge {
 public:
  /// Judges in double with the returned witnesses, and beyond double if `must` or by a random share. Counts
  /// the geometry (`finely`: counters.hpp).
  FuzzJudge(const Pair& pair, std::span<const MethodAnswer> offered, bool must, FindingSink& sink,
            bool finely = true);
  FuzzJudge(const FuzzJudge&) = delete;
  FuzzJudge& operator=(const FuzzJudge&) = delete;

  const Pair& pair() const { return trial_.pair; }
  const Truth& truth() const { return trial_.truth; }
  /// Returns whether this pair has a share of one in so many; each call draws again.
  bool drawn(std::size_t share) { return draws_.below(share) == 0; }
  RandomStream& draws() { return draws_; }
  /// Records a fault of the answer beyond the claim. That includes undecided although the method claims to
  /// decide, and an error above the returned bound, which the solver's own arithmetic estimates first.
  /// Returned distances and witnesses are checked on a share only. A wrong verdict that the measured distance
  /// puts within the claim is checked on the same share as distances.
  void record(const Method& method, MethodAnswer answer);

 private:
  void check_undecided(const Method& method, const MethodAnswer& answer);
  void check_error_bound(const Method& method, const MethodAnswer& answer);

  Trial trial_;
  RandomStream draws_;
  FindingSink& sink_;
  MeasuredDistance measured_;
  bool enclose_ = false;
};

}  // namespace cyl
