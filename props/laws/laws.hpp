// SPDX-License-Identifier: MIT
// The laws relate the answers of one method to each other, or an answer to the proved truth. A law names the
// further pairs to ask and checks the answers. It does not depend on how they are asked (examine.hpp). The
// exact and the one-sided laws need no oracle.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_words.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/trial/trial.hpp"
#include "solver/solid.hpp"

namespace cyl {

enum class LawKind : unsigned char {
  exact,        ///< bit for bit if the method claims that, else the verdict; no tolerance
  one_sided,    ///< one answer bounds another
  approximate,  ///< within an allowance that is proved
  answer        ///< its certificate holds, it arrives in time, a second call agrees
};
constexpr auto words_of(LawKind) noexcept {
  return std::array{"exact", "one-sided", "approximate", "answer"};
}

/// A pair that a law wants asked, and how.
struct LawQuery {
  Pair pair;
  CallMode mode = CallMode::usual;
};

/// One method's answers to a pair and to the questions that a law made from the pair.
struct LawCase {
  const Method& method;  ///< for its name and claim; not to be asked
  const Pair& pair;
  const MethodAnswer& first;  ///< to `pair`; a failure only for laws of failures
  std::span<const LawQuery> asked;
  std::span<const MethodAnswer> answers;  ///< to `asked`, one each
  Proofs& proofs;                         ///< of `pair` and of any other
};

/// The violation in one line. `contract` if the method claims otherwise for this pair.
struct Violation {
  std::string what;
  Severity severity = Severity::contract;
  std::optional<FindingKind> kind = {};  ///< set if compare() found it
  std::string reason = {};               ///< of a failure: the method's own words
  /// By how much a verdict or a distance is beyond the claim, relative to the size. 0 if no number shows it.
  double excess = 0;
  bool operator==(const Violation&) const = default;
};

struct Law {
  int number;  ///< kept for good: a number is never given to another law
  LawKind kind;
  std::string_view name;       ///< "swap"
  std::string_view statement;  ///< what is changed and what must hold
  std::string_view where;      ///< for which pairs and methods
  /// Returns the pairs to ask besides the pair itself, given the answer to it. If it returns none, the law
  /// does not apply to this pair. A law about the first answer alone has needs_none here, and its check
  /// decides for which pairs it applies.
  std::vector<LawQuery> (*queries)(const Method& method, const Pair& pair, const MethodAnswer& first);
  /// Returns nothing if the law holds, or if a method declines or fails (law 30 covers that).
  std::optional<Violation> (*check)(const LawCase& c);
};

/// For laws that look at the first answer alone.
inline constexpr std::vector<LawQuery> (*needs_none)(const Method&, const Pair&,
                                                     const MethodAnswer&) = nullptr;

/// That an answer comes, and that no certificate refutes its verdict.
inline constexpr int answer_law = 30, verdict_law = 31;

/// Every law, by increasing number: exact from 1, one-sided from 10, approximate from 20, of the answer
/// from 30.
std::span<const Law> all_laws();
/// Throws std::invalid_argument if there is none.
const Law& law_numbered(int number);

/// Returns how a method breaks a law on a pair, asked in this process, for tests and fuzz targets. Throws the
/// exceptions of the method.
std::optional<Violation> violation_of(Method& method, const Law& law, const Pair& pair);

}  // namespace cyl
