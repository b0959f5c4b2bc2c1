// SPDX-License-Identifier: MIT
// One pair put to methods: what is proved of it, what they say, what is wrong with that.
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
  std::vector<std::optional<Finding>> findings;  ///< one an answer: what is wrong with it, if anything is
  /// The narrowest enclosure of the signed distance so far; means nothing before the first.
  Enclosure distance;
  /// The width that it was asked for at, relative to the size; infinite before the first.
  double width = std::numeric_limits<double>::infinity();
  /// Encloses the distance at a relative width; empty: the referee does.
  std::function<Enclosure(double relative_width)> enclose;

  Trial() = default;
  Trial(const Pair& about, Truth proved) : pair(about), truth(std::move(proved)) {}
  /// Judges the pair; the witnesses of the answers offered, which are not kept, are tried first.
  explicit Trial(const Pair& about, std::span<const MethodAnswer> offered = {})
      : Trial(about, judge(about, offered)) {}

  /// Whether the solids are not proved apart.
  bool meets() const { return truth.verdict != Verdict::disjoint; }
  /// Whether a verdict is proved.
  bool decided() const { return truth.verdict != Verdict::undecided && truth.verdict != Verdict::invalid; }
  /// Where one method was asked: its answer, and what is wrong with that.
  const MethodAnswer& answer() const { return answers.front(); }
  const std::optional<Finding>& finding() const { return findings.front(); }
  /// Whether what is wrong with the method's answer is of that kind.
  bool fails(FindingKind kind) const { return finding() && finding()->kind == kind; }
  /// Whether the method answered, a verdict is proved, and nothing is wrong with the answer.
  bool right() const;

  /// Returns an enclosure asked for at `relative_width` or narrower: a certified one where a verdict is
  /// proved. Encloses only where none so narrow is known. Cost: that of enclose_distance().
  const Enclosure& distance_at(double relative_width);
  /// Drops the enclosure: margins found from here on depend on nothing before.
  void forget_distance() { width = std::numeric_limits<double>::infinity(); }
  /// Encloses the distance until it is known to a thousandth of itself, as far as it can be.
  void narrow_distance();
};

/// Shorter than a campaign's: hundreds of pairs may be asked around one that hangs.
inline constexpr Caps probe_caps{
    .call_cpu = std::chrono::milliseconds(200), .call_wall = std::chrono::milliseconds(4000), .hangs = 8};

/// Asks every method about every pair, contained, `times` times in a row; judges each pair with all answers
/// to it, and compares. The trials are in the order of the pairs, the answers those of the first time; two
/// that differ are a finding where nothing else is. Distances are enclosed, coarsely where no finding needs
/// them. Throws std::system_error only where the system refuses a process or memory.
std::vector<Trial> try_methods(std::span<const std::unique_ptr<Method>> methods, std::span<const Pair> pairs,
                               const Caps& caps, std::size_t times = 1);

/// The same of one method.
std::vector<Trial> try_method(const std::unique_ptr<Method>& method, std::span<const Pair> pairs,
                              const Caps& caps = probe_caps);
/// The same of one pair, with the caps of a campaign, and the distance narrow.
Trial try_method(const std::unique_ptr<Method>& method, const Pair& pair);

/// Returns the index of the method of that name, or nothing.
std::optional<std::size_t> position_of(std::span<const std::unique_ptr<Method>> methods,
                                       std::string_view name);
/// Returns the method of that name. Throws UsageError if there is none.
const std::unique_ptr<Method>& find_method(std::span<const std::unique_ptr<Method>> methods,
                                           std::string_view name);

/// "3.1e-07 apart", "overlapping by 0.05", "touching"; if the distance said is wrong, to the digits that tell
/// the two apart.
std::string distance_in_words(const Trial& trial);

/// The distance said, to the digits that tell it from the true one.
std::string said_distance(const Trial& trial);

/// Judges the pairs of one question when first asked for them, and keeps what is proved.
class Proofs {
 public:
  /// `offered`: answers to `pair`, whose witnesses are tried before the referee searches. Not copied.
  Proofs(const Pair& pair, std::span<const MethodAnswer> offered) : pair_(pair), offered_(offered) {}
  Proofs(const Proofs&) = delete;
  Proofs& operator=(const Proofs&) = delete;

  /// Returns what is proved of the pair itself or of any other. Valid as long as this is.
  Trial& of(const Pair& pair);
  /// Returns what was found of it so far, or nullptr.
  const Trial* known(const Pair& pair) const;

 private:
  const Pair& pair_;
  std::span<const MethodAnswer> offered_;
  std::deque<Trial> proved_;  // few
};

/// Returns whether |signed distance| of the pair certainly reaches what `claim` promises: from there on the
/// method's verdict is its contract. False where no verdict is proved.
bool beyond_claim(Trial& trial, const Claim& claim);

}  // namespace cyl
