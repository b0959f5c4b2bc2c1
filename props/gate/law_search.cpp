// SPDX-License-Identifier: MIT
#include "props/gate/law_search.hpp"

#include <rapidcheck.h>
#include <rapidcheck/detail/Configuration.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <utility>

#include "base/usage_error.hpp"
#include "props/gate/pair_generators.hpp"

namespace cyl {
namespace {

/// By source.
constexpr std::array generators{pairs_of_one_kind, close_pairs_of_one_kind, rounded_pairs_of_one_kind};

/// The most draws that RapidCheck may try while it shrinks one case. They take some seconds at most.
/// simplify() does the rest.
constexpr int shrink_cap = 400;

class Silent : public rc::detail::TestListener {
  void onTestCaseFinished(const rc::detail::CaseDescription&) override {}
  void onShrinkTried(const rc::detail::CaseDescription&, bool) override {}
  void onTestFinished(const rc::detail::TestMetadata&, const rc::detail::TestResult&) override {}
};

/// RapidCheck prints the seed of its configuration when it loads this. No draw of ours uses that seed. A
/// configuration that the user gives is printed, and so is its fault.
void load_configuration() {
  if (std::getenv("RC_PARAMS") != nullptr) return;
  std::streambuf* const printed = std::cerr.rdbuf(nullptr);
  rc::detail::configuration();
  std::cerr.rdbuf(printed);
}

class LawSearch {
 public:
  LawSearch(std::span<const std::unique_ptr<Method>> methods, const LawFilter& wanted,
            const WorthShrinking& is_worth_shrinking, PairSource source, Asker& asker)
      : methods_(methods), wanted_(wanted), is_news_(is_worth_shrinking), source_(source), asker_(asker) {
    round_.counts.resize(methods.size());
  }

  SearchRound run(const rc::detail::TestParams& params) {
    load_configuration();
    Silent listener;
    const auto result = rc::detail::checkTestable(
        [this] {
          const PairsDrawn drawn = *generators[static_cast<std::size_t>(source_)](pairs_per_draw);
          RC_TAG(drawn.from);
          if (stopped_)
            shrink(drawn);
          else
            examine_drawn(drawn);
        },
        rc::detail::TestMetadata{}, params, listener);
    if (result.is<rc::detail::FailureResult>()) {
      LawFailure& last = round_.failures.back();
      if (!last.shrunk) last.shrunk = last.pair;
    } else if (result.is<rc::detail::Error>()) {
      throw UsageError(result.get<rc::detail::Error>().description);
    }
    return std::move(round_);
  }

 private:
  void examine_drawn(const PairsDrawn& drawn) {
    const Examined examined = examine(methods_, drawn.pairs, wanted_, asker_);
    round_.drawn[drawn.from] += drawn.pairs.size();
    round_.pairs.insert(round_.pairs.end(), drawn.pairs.begin(), drawn.pairs.end());
    for (std::size_t m = 0; m < methods_.size(); ++m) round_.counts[m] += examined.counts[m];
    for (const LawViolation& b : examined.violations) {
      round_.failures.push_back({b.method, b.law, b.violation, drawn.pairs[b.pair], drawn.from, {}});
      if (b.violation.severity != Severity::contract || !is_news_(round_.failures.back())) continue;
      stopped_ = true;
      RC_FAIL(b.violation.what);
    }
  }

  // Runs while RapidCheck shrinks. Only the failure that stopped the round counts.
  void shrink(const PairsDrawn& drawn) {
    LawFailure& last = round_.failures.back();
    if (++shrinks_ > shrink_cap || !is_news_(last)) return;
    const auto same = [&](std::size_t method, const Law& law) {
      return method == last.method && law.number == last.law->number;
    };
    for (const LawViolation& b : examine(methods_, drawn.pairs, same, asker_).violations) {
      if (b.violation.severity != Severity::contract) continue;
      last.violation = b.violation;
      last.shrunk = drawn.pairs[b.pair];
      RC_FAIL(b.violation.what);
    }
  }

  std::span<const std::unique_ptr<Method>> methods_;
  const LawFilter& wanted_;
  const WorthShrinking& is_news_;
  const PairSource source_;
  Asker& asker_;
  SearchRound round_;
  bool stopped_ = false;
  int shrinks_ = 0;
};

}  // namespace

SearchRound find_violations(std::span<const std::unique_ptr<Method>> methods, const LawFilter& wanted,
                            const WorthShrinking& is_worth_shrinking, PairSource source, std::uint64_t seed,
                            int draws, Asker& asker) {
  rc::detail::TestParams params;
  params.seed = seed;
  params.maxSuccess = draws;
  const WorthShrinking nothing = [](const LawFailure&) { return false; };
  SearchRound round = LawSearch(methods, wanted, nothing, source, asker).run(params);
  const auto news = std::find_if(round.failures.begin(), round.failures.end(), [&](const LawFailure& c) {
    return c.violation.severity == Severity::contract && is_worth_shrinking(c);
  });
  if (news == round.failures.end()) return round;
  // The same draws again, but for that law alone, because RapidCheck shrinks at the first failure.
  const LawFilter same = [&](std::size_t method, const Law& law) {
    return method == news->method && law.number == news->law->number;
  };
  const SearchRound again = LawSearch(methods, same, is_worth_shrinking, source, asker).run(params);
  if (again.failures.empty() || !again.failures.back().shrunk) return round;  // it comes and goes
  news->shrunk = again.failures.back().shrunk;
  return round;
}

SearchRound find_violations(std::span<const std::unique_ptr<Method>> methods, const LawFilter& wanted,
                            const WorthShrinking& is_worth_shrinking, PairSource source, std::uint64_t seed,
                            int draws, const Caps& caps) {
  Asker asker(methods, caps);
  return find_violations(methods, wanted, is_worth_shrinking, source, seed, draws, asker);
}

}  // namespace cyl
