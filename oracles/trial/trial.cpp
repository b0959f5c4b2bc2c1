// SPDX-License-Identifier: MIT
#include "oracles/trial/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/usage_error.hpp"
#include "corpus/pairs/pair_numbers.hpp"

namespace cyl {
namespace {

/// The relative widths of a distance that is only shown, and the part of it that may stay unsure.
constexpr double shown_widths[] = {1e-6, 1e-9, 1e-12, 1e-15};
constexpr double shown_share = 1e-3;
/// A length whose enclosure is wider than this part of it is shown as a bound: its third digit is not known.
constexpr double bound_share = 1e-2;

bool same(const Pair& x, const Pair& y) {
  const auto p = numbers_of(x), q = numbers_of(y);
  return std::memcmp(p.data(), q.data(), sizeof p) == 0;
}

/// Returns x to three digits, or to as many more as distinguish it from y.
std::string told_from(double x, double y) {
  int digits = 3;
  while (digits < 17 && fmt::format("{:.{}g}", x, digits) == fmt::format("{:.{}g}", y, digits)) ++digits;
  return fmt::format("{:.{}g}", x, digits);
}

/// The end of the enclosure that is nearer to touching.
double nearer_end(const Trial& trial) { return trial.meets() ? trial.distance.hi : trial.distance.lo; }

}  // namespace

bool Trial::right() const {
  return decided() && !finding() && answer().status == Status::answered &&
         answer().verdict != Verdict::undecided;
}

const Enclosure& Trial::distance_at(double relative_width) {
  if (relative_width < width) {
    distance = enclose ? enclose(relative_width) : enclose_distance(pair, truth, relative_width);
    width = relative_width;
  }
  return distance;
}

void Trial::narrow_distance() {
  if (!decided() || truth.verdict == Verdict::touching) return;
  for (const double next : shown_widths) {
    const double least = std::min(std::abs(distance.lo), std::abs(distance.hi));
    const bool one_sign = (distance.lo > 0) == (distance.hi > 0);
    if (one_sign && distance.hi - distance.lo <= shown_share * least) return;
    distance_at(next);
  }
}

std::vector<Trial> try_methods(std::span<const std::unique_ptr<Method>> methods, std::span<const Pair> pairs,
                               const Caps& caps, std::size_t times) {
  std::vector<Question> questions;
  for (std::size_t p = 0; p < pairs.size(); ++p)
    for (std::size_t m = 0; m < methods.size(); ++m) questions.insert(questions.end(), times, Question{m, p});
  const std::vector<ContainedAnswer> said = ask_contained(methods, pairs, questions, caps);
  std::vector<Trial> trials;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const auto of_pair = std::span(said).subspan(p * methods.size() * times, methods.size() * times);
    std::vector<MethodAnswer> answers;
    for (std::size_t q = 0; q < of_pair.size(); q += times) answers.push_back(of_pair[q].answer);
    Trial& trial = trials.emplace_back(pairs[p], answers);
    trial.answers = std::move(answers);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      auto wrong = compare(trial, methods[m]->claim(), trial.answers[m]);
      if (!wrong && !same_answer(trial.answers[m], of_pair[(m + 1) * times - 1].answer))
        wrong = Finding{FindingKind::nondeterminism, Severity::contract, {}};
      trial.findings.push_back(std::move(wrong));
    }
    if (trial.decided()) trial.distance_at(shown_widths[0]);
  }
  return trials;
}

std::vector<Trial> try_method(const std::unique_ptr<Method>& method, std::span<const Pair> pairs,
                              const Caps& caps) {
  return try_methods({&method, 1}, pairs, caps);
}

Trial try_method(const std::unique_ptr<Method>& method, const Pair& pair) {
  Trial trial = std::move(try_method(method, {&pair, 1}, Caps{}).front());
  trial.narrow_distance();
  return trial;
}

std::optional<std::size_t> position_of(std::span<const std::unique_ptr<Method>> methods,
                                       std::string_view name) {
  for (std::size_t m = 0; m < methods.size(); ++m)
    if (methods[m]->name() == name) return m;
  return {};
}

const std::unique_ptr<Method>& find_method(std::span<const std::unique_ptr<Method>> methods,
                                           std::string_view name) {
  if (const auto m = position_of(methods, name)) return methods[*m];
  throw UsageError(fmt::format("no method is named '{}'", name));
}

std::string distance_in_words(const Trial& trial) {
  if (!trial.decided()) return "of unproved distance";
  if (trial.truth.verdict == Verdict::touching) return "touching";
  const bool said =
      !trial.findings.empty() && trial.finding() && trial.finding()->kind == FindingKind::distance_outside;
  const double true_one = nearer_end(trial), other = said ? trial.answer().distance : 0;
  const double sign = trial.meets() ? -1 : 1;
  if (true_one == 0) {  // a gap of less than the least double has no other lower bound
    return trial.meets() ? fmt::format("overlapping by at most {:.3g}", -trial.distance.lo)
                         : fmt::format("at most {:.3g} apart", trial.distance.hi);
  }
  const bool beyond_doubles = !(std::abs(true_one) < std::numeric_limits<double>::max());
  const std::string length = beyond_doubles ? "more than 1.79e308"  // which is below the largest double
                                            : told_from(sign * true_one, sign * other);
  const bool is_bound =
      !beyond_doubles && trial.distance.hi - trial.distance.lo > bound_share * std::abs(true_one);
  const std::string shown = (is_bound ? "at least " : "") + length;
  return trial.meets() ? "overlapping by " + shown : shown + " apart";
}

std::string said_distance(const Trial& trial) {
  return told_from(trial.answer().distance, nearer_end(trial));
}

Trial& Proofs::of(const Pair& pair) {
  for (Trial& known : proved_)
    if (same(known.pair, pair)) return known;
  return proved_.emplace_back(pair, same(pair, pair_) ? offered_ : std::span<const MethodAnswer>{});
}

const Trial* Proofs::known(const Pair& pair) const {
  for (const Trial& known : proved_)
    if (same(known.pair, pair)) return &known;
  return nullptr;
}

WitnessSet::WitnessSet(std::span<const std::unique_ptr<Method>> methods) {
  auto ours = certifying_method();
  const auto is_ours = [&](const auto& method) { return method->name() == ours->name(); };
  if (std::none_of(methods.begin(), methods.end(), is_ours)) ours_ = std::move(ours);
}

std::span<const MethodAnswer> WitnessSet::with_own_witness(const Pair& pair,
                                                           std::span<const MethodAnswer> said) {
  if (!ours_) return said;
  all_.assign(said.begin(), said.end());
  all_.push_back(ours_->ask(pair));
  return all_;
}

bool beyond_claim(Trial& trial, const Claim& claim) {
  if (!trial.decided()) return false;
  const double from = reach(claim, size_of(trial.pair));
  return magnitude_against(from, trial).lo >= from;
}

}  // namespace cyl
