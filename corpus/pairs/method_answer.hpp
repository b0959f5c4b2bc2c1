// SPDX-License-Identifier: MIT
// The answer of a method for a pair, as plain data: its verdict, its distance, its witness.
#pragma once

#include <array>
#include <string_view>

#include "corpus/pairs/certificate.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "solver/solid.hpp"

namespace cyl {

enum class Status : unsigned char {
  answered,
  declined,  ///< cannot or does not want to answer this pair; no fault
  failed     ///< tried and failed; `failure` has the kind
};

/// `reported`: the method itself reports a failure. Runs store these numbers, so new values go at the end.
enum class Failure : unsigned char { none, exception, crash, hang, non_finite, malformed, reported };
constexpr auto words_of(Failure) noexcept {
  return std::array{"none", "exception", "crash", "hang", "non_finite", "malformed", "reported"};
}

/// A side effect of a call, as the worker noticed it.
enum class SideEffect : unsigned char {
  none,
  rounding_mode,  ///< left the processor rounding, or treating small numbers, in another way
  memory,         ///< wrote behind what it was given to write to
  thread          ///< left a thread running
};
constexpr auto words_of(SideEffect) noexcept {
  return std::array{"none", "rounding_mode", "memory", "thread"};
}

/// The answer of a method. Plain bytes, so that a contained worker can leave it in shared memory.
struct MethodAnswer {
  Status status = Status::declined;
  Failure failure = Failure::none;
  Verdict verdict = Verdict::undecided;  ///< meaningful if status == answered
  bool has_distance = false;
  /// The signed distance is at least `distance`, and has_distance is false. The method stops measuring there,
  /// or its depth is an upper bound.
  bool at_least = false;
  CertificateKind witness = CertificateKind::none;  ///< never `near` or `near_points`
  double distance = 0;  ///< signed, > 0 apart, in the scene's unit; meaningful if states_distance()
  /// The method's own bound of its distance error, or 0. It holds in both directions for disjoint solids. For
  /// overlapping solids it bounds how much deeper they are than returned.
  double error_bound = 0;
  double head[3] = {0, 0, 0};  ///< direction, or point = head + tail exactly, in the scene's frame
  double tail[3] = {0, 0, 0};
  double other_head[3] = {0, 0, 0};  ///< of `points`, the point of b. That of a is head + tail.
  double other_tail[3] = {0, 0, 0};
  Hull hulls[2] = {Hull::space, Hull::space};  ///< of a and b. A `point` is the nearest one in both. Each of
                                               ///< `points` is the nearest one in its own.
  int steps = 0, step_cap = 0;                 ///< steps of its searches and their maximum; 0 if not reported
  SideEffect side_effect = SideEffect::none;
  char reason[120] = {};  ///< why it declined or failed, else what the side effect was; zero-terminated

  bool states_distance() const noexcept { return has_distance || at_least; }
  void forget_distance() noexcept { has_distance = at_least = false; }
  /// Takes the depth, if there is one, as an upper bound.
  void bound_depth() noexcept;
  void set_reason(std::string_view text) noexcept;  ///< truncates
  /// The first effect counts. It is the reason if there is no other.
  void note(SideEffect effect, std::string_view what) noexcept;
  void set_direction(const Vector3& d) noexcept;  ///< as the witness
  /// Sets the witness if doubles can represent it, else none.
  void set_witness(const Certificate& certificate) noexcept;
  Certificate certificate() const;  ///< the witness, as it was offered
};

/// Returns an answer with this verdict and nothing else.
MethodAnswer answered(Verdict verdict) noexcept;
/// Returns an answer that declines, for this reason.
MethodAnswer declined_answer(std::string_view reason) noexcept;
/// Returns the answer of a method that has no shape for such a solid.
MethodAnswer declined_shape(SolidKind kind) noexcept;
/// Returns the answer of a method that does not support solids of such sizes.
MethodAnswer declined_size() noexcept;

/// Returns an answer of a method that failed.
MethodAnswer failed_answer(Failure failure, std::string_view reason) noexcept;

}  // namespace cyl
