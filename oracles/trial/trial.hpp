// SPDX-License-Identifier: MIT
// One pair that methods are asked about: its proved truth, their answers and the findings.
#pragma once

#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/methods/contained.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {

struct Trial {
  Pair pair;
  Truth truth;
  std::vector<MethodAnswer> answers;             ///< of the methods that were asked, in their order
  std::vector<std::optional<Finding>> findings;  ///< one for each answer, empty if it is right
  /// The narrowest enclosure of the signed distance so far. It has no meaning before the first.
  Enclosure distance;
  /// The width at which it was computed, relative to the size. Infinite before the first.
  double width = std::numeric_limits<double>::infinity();
  /// Encloses the distance at a relative width. If empty, the referee does.
  std::function<Enclosure(double relative_width)> enclose;

  Trial() = default;
  Trial(const Pair& about, Truth proved) : pair(about), truth(std::move(proved)) {}
  /// Judges the pair. The witnesses of the offered answers, which are not kept, are tried first.
  explicit Trial(const Pair& about, std::span<const MethodAnswer> offered = {})
      : Trial(about, judge(about, offered)) {}

  /// Whether the solids are not proved apart.
  bool meets() const { return truth.verdict != Verdict::disjoint; }
  /// Whether a verdict is proved.
  bool decided() const { return truth.verdict != Verdict::undecided && truth.verdict != Verdict::invalid; }
  /// If one method was asked: its answer, and the finding.
  const MethodAnswer& answer() const { return answers.front(); }
  const std::optional<Finding>& finding() const { return findings.front(); }
  /// Whether the finding is of that kind.
  bool fails(FindingKind kind) const { return finding() && finding()->kind == kind; }
  /// Whether the method answered, a verdict is proved, and there is no finding.
  bool right() const;

  /// Returns an enclosure that was computed at `relative_width` or narrower. It is certified if a verdict is
  /// proved. A new one is computed only if none so narrow is known. Cost: that of enclose_distance().
  const Enclosure& distance_at(double relative_width);
  /// Drops the enclosure, so that later margins do not depend on earlier ones.
  void forget_distance() { width = std::numeric_limits<double>::infinity(); }
  /// Encloses the distance until its relative width is a thousandth, or as narrow as it can be.
  void narrow_distance();
};

/// Hundreds of pairs may be asked around one that hangs.
inline constexpr Caps probe_caps = attended_caps(8);

/// Asks every method about every pair, contained, `times` times in a row. Judges each pair with all its
/// answers, and compares.
/// 1. The trials are in the order of the pairs. The answers are those of the first time.
/// 2. If the answers of a method differ, and nothing else is wrong, that is a finding.
/// 3. Distances are enclosed, coarsely if no finding needs them.
/// 4. Throws std::system_error only if the system refuses a process or memory.
std::vector<Trial> try_methods(std::span<const std::unique_ptr<Method>> methods, std::span<const Pair> pairs,
                               const Caps& caps, std::size_t times = 1);

/// The same for one method.
std::vector<Trial> try_method(const std::unique_ptr<Method>& method, std::span<const Pair> pairs,
                              const Caps& caps = probe_caps);
/// The same for one pair, with the caps of a campaign and a narrow distance.
Trial try_method(const std::unique_ptr<Method>& method, const Pair& pair);

/// Returns the index of the method of that name, or nothing.
std::optional<std::size_t> position_of(std::span<const std::unique_ptr<Method>> methods,
                                       std::string_view name);
/// Returns the method of that name. Throws UsageError if there is none.
const std::unique_ptr<Method>& find_method(std::span<const std::unique_ptr<Method>> methods,
                                           std::string_view name);

/// Returns "3.1e-07 apart", "overlapping by at least 0.05" (if no more is proved) or "touching". If the
/// method's distance is wrong, it has as many digits as make the two differ.
std::string distance_in_words(const Trial& trial);

/// Returns the method's distance, with as many digits as make it differ from the true one.
std::string said_distance(const Trial& trial);

/// Judges the pairs of one question when first asked for them, and keeps what is proved.
class Proofs {
 public:
  /// `offered`: answers to `pair`, whose witnesses are tried before the referee searches. Not copied.
  Proofs(const Pair& pair, std::span<const MethodAnswer> offered) : pair_(pair), offered_(offered) {}
  Proofs(const Proofs&) = delete;
  Proofs& operator=(const Proofs&) = delete;

  /// Returns the trial of the pair itself or of any other pair. Valid as long as this object.
  Trial& of(const Pair& pair);
  /// Returns the trial if it exists already, else nullptr.
  const Trial* known(const Pair& pair) const;

 private:
  const Pair& pair_;
  std::span<const MethodAnswer> offered_;
  std::deque<Trial> proved_;  // few
};

/// The answers whose witnesses the referee may use. They do not depend on the methods of the run.
class WitnessSet {
 public:
  /// `methods` are those that the run asks.
  explicit WitnessSet(std::span<const std::unique_ptr<Method>> methods);

  /// Returns the answers to a pair. Adds the answer of our certifying method unless the run asks that method.
  /// The span is valid until the next call.
  std::span<const MethodAnswer> with_own_witness(const Pair& pair, std::span<const MethodAnswer> said);

 private:
  std::unique_ptr<Method> ours_;  ///< null if the run asks it
  std::vector<MethodAnswer> all_;
};

/// Returns whether |signed distance| of the pair certainly reaches the claim, from which on the method
/// promises the right verdict. Returns false if no verdict is proved.
bool beyond_claim(Trial& trial, const Claim& claim);

}  // namespace cyl
