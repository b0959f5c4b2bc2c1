// SPDX-License-Identifier: MIT
// What a method says of a pair, as plain data: its verdict, its distance, the witness it offers.
#pragma once

#include <array>
#include <string_view>

#include "corpus/pairs/certificate.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

enum class Status : unsigned char {
  answered,
  declined,  ///< cannot or does not want to answer this pair; no fault
  failed     ///< tried and broke; `failure` says how
};

/// `reported`: the method itself says that it failed. Numbers of these are stored: new ones stand at the end.
enum class Failure : unsigned char { none, exception, crash, hang, non_finite, malformed, reported };
constexpr auto words_of(Failure) noexcept {
  return std::array{"none", "exception", "crash", "hang", "non_finite", "malformed", "reported"};
}

/// What a call did besides answering, as the worker noticed.
enum class SideEffect : unsigned char {
  none,
  rounding_mode,  ///< left the processor rounding, or treating small numbers, in another way
  memory,         ///< wrote behind what it was given to write to
  thread,         ///< left a thread running
  slow            ///< slept or waited for long
};
constexpr auto words_of(SideEffect) noexcept {
  return std::array{"none", "rounding_mode", "memory", "thread", "slow"};
}

/// What a method said. Plain bytes, so that a contained worker can leave it in shared memory.
struct MethodAnswer {
  Status status = Status::declined;
  Failure failure = Failure::none;
  Verdict verdict = Verdict::undecided;  ///< meaningful where status == answered
  bool has_distance = false;
  CertificateKind witness = CertificateKind::none;  ///< never `near` or `near_points`
  double distance = 0;  ///< signed: > 0 apart, in the scene's unit; meaningful where has_distance
  /// Its own bound of the distance's error, 0 where it tells none: apart both ways; where it says that they
  /// overlap, of how much deeper they are than it says.
  double error_bound = 0;
  double head[3] = {0, 0, 0};  ///< direction, or point = head + tail exactly, in the scene's frame
  double tail[3] = {0, 0, 0};
  double other_head[3] = {0, 0, 0};  ///< of points: that of b; head + tail is that of a
  double other_tail[3] = {0, 0, 0};
  Hull hulls[2] = {
      Hull::space,
      Hull::space};             ///< of a and b: the point is the nearest in both; of points: each in its own
  int steps = 0, step_cap = 0;  ///< that its searches took, and the most they may; 0: not told
  SideEffect side_effect = SideEffect::none;
  char reason[120] = {};  ///< why it declined or failed, else what the side effect was; zero-terminated

  void set_reason(std::string_view text) noexcept;  ///< truncates
  /// The first one counts; it is the reason, where there is no other.
  void note(SideEffect effect, std::string_view what) noexcept;
  void set_direction(const Vector3& d) noexcept;  ///< as the witness
  /// As the witness, where doubles hold it; else none.
  void set_witness(const Certificate& certificate) noexcept;
  Certificate certificate() const;  ///< the witness, as it was offered
};

/// Returns the answer of a method that has no shape for such a solid.
MethodAnswer declined_shape(SolidKind kind) noexcept;
/// Returns the answer of a method that does not support solids of such sizes.
MethodAnswer declined_size() noexcept;

/// Returns an answer of a method that failed.
MethodAnswer failed_answer(Failure failure, std::string_view reason) noexcept;

}  // namespace cyl
