// SPDX-License-Identifier: MIT
#include "oracles/trial/mechanism.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/algorithm_groups.hpp"
#include "oracles/trial/bucket.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

/// Powers of two by which a pair is made larger and smaller: more than the tolerances of libraries span in
/// one step, and far from where squares leave the doubles.
constexpr int scale_step = 20;
/// Where the size is beyond 2^+-this, products of four lengths leave the doubles or lose bits.
constexpr int extreme_exponent_margin = 200;

/// Returns the pair with the first solid at the origin and the other moved along.
Pair at_origin(Pair p) {
  const Vector3 delta = p.b.center - p.a.center;
  p.a.center.setZero();
  p.b.center = delta;
  return p;
}

bool is_far(const Pair& p) {
  const double size = size_of(p), apart = (p.b.center / 2 - p.a.center / 2).stableNorm() * 2;
  const double near = std::min(p.a.center.stableNorm(), p.b.center.stableNorm());
  return size > 0 && near > offset_size_margin * size && apart <= near;
}

/// Returns e where 2^e <= size < 2^(e+1); for two points their distance counts as the size.
int exponent_of_size(const Pair& p) {
  double size = size_of(p);
  if (size == 0) size = (p.b.center - p.a.center).stableNorm();
  return size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
}

/// Returns the first words of a text, joined by '-', without those that have a digit in them: these, and the
/// words after the first few, tell one pair from another.
std::string slug(std::string_view text) {
  constexpr int words_cap = 7;
  std::string out;
  int words = 0;
  for (std::size_t at = 0; at < text.size() && words < words_cap;) {
    const auto is_of_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
    std::size_t end = at;
    bool digits = false;
    while (end < text.size() && is_of_word(text[end])) {
      digits |= std::isdigit(static_cast<unsigned char>(text[end])) != 0;
      ++end;
    }
    if (end > at && !digits) {
      if (!out.empty()) out += '-';
      for (const char c : text.substr(at, end - at))
        out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      ++words;
    }
    at = end + 1;
  }
  return out;
}

/// Questions that are asked all together, each held against the claim given with it.
class Round {
 public:
  explicit Round(std::span<const std::unique_ptr<Method>> methods) : methods_(methods) {}

  std::size_t ask(std::size_t method, const Pair& pair, const Claim& claim) {
    questions_.push_back({method, pairs_.size()});
    pairs_.push_back(pair);
    claims_.push_back(claim);
    return questions_.size() - 1;
  }
  void run(Asker& asker) {
    for (const ContainedAnswer& said : asker.ask(pairs_, questions_)) {
      const std::size_t q = trials_.size();
      Trial& trial = trials_.emplace_back(pairs_[q], std::span(&said.answer, 1));
      trial.answers = {said.answer};
      trial.findings = {compare(trial, claims_[q], said.answer)};
    }
  }
  const Method& method(std::size_t at) const { return *methods_[at]; }
  const Trial& operator[](std::size_t question) const { return trials_[question]; }
  bool fails(std::size_t question, FindingKind kind) const { return trials_[question].fails(kind); }
  bool is_right(std::size_t question) const {
    const MethodAnswer& answer = trials_[question].answers[0];
    return !trials_[question].findings[0] && answer.status == Status::answered &&
           answer.verdict != Verdict::undecided;
  }

 private:
  std::span<const std::unique_ptr<Method>> methods_;
  std::vector<Pair> pairs_;  ///< by question
  std::vector<Question> questions_;
  std::vector<Claim> claims_;
  std::vector<Trial> trials_;
};

/// What is known of a failing pair on the way.
struct Candidate {
  Failing now;  ///< the pair as far as it is brought towards the ordinary and still fails
  Claim claim;  ///< by which it fails
  Classification found{};
  bool done = false;
  int exponent = 0;  ///< of the size before it was made ordinary
  Enclosure margin{};
  // Questions of the round at hand.
  std::size_t asked = 0;
  std::optional<std::size_t> at_origin{};
  std::size_t larger = 0, smaller = 0;
  std::vector<std::pair<std::size_t, std::size_t>> siblings{};  ///< method, question

  void end(Mechanism m) {
    found.mechanism = m;
    done = true;
  }
  bool fails(const Round& round, std::size_t question) const { return round.fails(question, now.kind); }
};

/// Whether its verdict, which is wrong, is right about other solids that it says it models.
bool is_right_about_its_model(const Method& method, const Trial& wrong) {
  const Pair model = method.modelled(wrong.pair);
  if (numbers_of(model) == numbers_of(wrong.pair) || !is_refuted_verdict(wrong.findings[0]->kind))
    return false;
  const bool said = wrong.answers[0].verdict != Verdict::disjoint;
  const Verdict truth = judge_verdict(model).verdict;
  return truth == Verdict::undecided || truth == Verdict::touching ||
         said == (truth == Verdict::intersecting);
}

/// As it is, and moved to the origin.
void ask_as_it_is(Candidate& c, Round& round) {
  c.asked = round.ask(c.now.method, c.now.pair, c.claim);
  if (is_far(c.now.pair)) c.at_origin = round.ask(c.now.method, at_origin(c.now.pair), c.claim);
}

void take_as_it_is(Candidate& c, const Round& round) {
  const Trial& seen = round[c.asked];
  c.found.capped = seen.answers[0].step_cap > 0 && seen.answers[0].steps >= seen.answers[0].step_cap;
  if (!c.fails(round, c.asked)) return c.end(Mechanism::gone);
  if (is_right_about_its_model(round.method(c.now.method), seen)) return c.end(Mechanism::model);
  if (seen.findings[0]->margin) c.margin = *seen.findings[0]->margin;
  // A claim has an absolute part: of a distance the error itself is followed instead.
  if (c.now.kind == FindingKind::distance_outside) c.claim = {.relative = c.margin.lo / 2, .source = {}};
  if (c.at_origin) {
    c.found.right_at_origin = !c.fails(round, *c.at_origin);
    if (c.found.right_at_origin) return c.end(Mechanism::offset);
    c.now.pair = at_origin(c.now.pair);
  }
  if (c.found.capped) c.end(Mechanism::iteration_cap);
}

/// At an ordinary size.
void ask_at_ordinary_size(Candidate& c, Round& round) {
  c.exponent = exponent_of_size(c.now.pair);
  c.asked = round.ask(c.now.method, scaled(c.now.pair, -c.exponent), c.claim);
}

void take_at_ordinary_size(Candidate& c, const Round& round) {
  if (c.fails(round, c.asked)) {
    c.now.pair = scaled(c.now.pair, -c.exponent);
    return;
  }
  (c.exponent < 0 ? c.found.right_larger : c.found.right_smaller) = true;
  if (std::abs(c.exponent) > extreme_exponent_margin)
    c.end(c.exponent < 0 ? Mechanism::underflow : Mechanism::overflow);
}

/// Larger, smaller; other settings.
void ask_changed(Candidate& c, Round& round, const GroupedMethods& of) {
  c.larger = round.ask(c.now.method, scaled(c.now.pair, scale_step), c.claim);
  c.smaller = round.ask(c.now.method, scaled(c.now.pair, -scale_step), c.claim);
  for (std::size_t m = 0; m < of.methods.size(); ++m)
    if (m != c.now.method && of.groups[m] == of.groups[c.now.method] &&
        differ_in_setting(of.methods[m]->name(), of.methods[c.now.method]->name()))
      c.siblings.emplace_back(m, round.ask(m, c.now.pair, c.claim));
}

void take_changed(Candidate& c, const Round& round) {
  for (const auto& [m, question] : c.siblings)
    if (!c.found.right_sibling && round.is_right(question)) c.found.right_sibling = m;
  c.found.right_larger |= !c.fails(round, c.larger);
  c.found.right_smaller |= !c.fails(round, c.smaller);
  if (c.found.right_larger || c.found.right_smaller)
    c.end(Mechanism::absolute_length);
  else if (!is_failure(c.now.kind) && c.margin.hi <= rounding_margin)
    c.end(Mechanism::rounding);
  else
    c.end(c.found.right_sibling ? Mechanism::setting : Mechanism::unclassified);
}

/// Returns the first method of the same library that shares the method's algorithm.
std::size_t first_of(const GroupedMethods& of, std::size_t method) {
  std::size_t m = of.groups[method];
  const std::string_view library = library_of(of.methods[method]->name());
  while (of.groups[m] != of.groups[method] || library_of(of.methods[m]->name()) != library) ++m;
  return m;
}

}  // namespace

std::string_view in_words(Mechanism m) noexcept {
  constexpr std::array<std::string_view, words_of(Mechanism{}).size()> words{
      "right when asked again",
      "coordinates of the scene, not of the pair: right where both solids are moved to the origin",
      "its search ends at its own cap on steps",
      "products of small lengths underflow: right at an ordinary size",
      "products of large lengths overflow: right at an ordinary size",
      "a fixed length in it, such as an absolute tolerance: right at another scale",
      "rounding of its double computation",
      "its setting: right with another",
      "no probe told",
      "its model: right about cylinders with the rounded edges that it gives them"};
  return words[static_cast<std::size_t>(m)];
}

std::vector<Classification> classify(const GroupedMethods& of, std::span<const Failing> failing,
                                     const Caps& caps) {
  Asker asker(of.methods, caps);
  return classify(of, failing, asker);
}

std::vector<Classification> classify(const GroupedMethods& of, std::span<const Failing> failing,
                                     Asker& asker) {
  std::vector<Candidate> candidates;
  for (const Failing& f : failing) candidates.push_back({f, of.methods[f.method]->claim()});
  const auto round = [&](auto ask, auto take) {
    Round asked(of.methods);
    for (Candidate& c : candidates)
      if (!c.done) ask(c, asked);
    asked.run(asker);
    for (Candidate& c : candidates)
      if (!c.done) take(c, asked);
  };
  round(ask_as_it_is, take_as_it_is);
  round(ask_at_ordinary_size, take_at_ordinary_size);
  round([&](Candidate& c, Round& asked) { ask_changed(c, asked, of); }, take_changed);
  std::vector<Classification> found;
  for (const Candidate& c : candidates) found.push_back(c.found);
  return found;
}

std::vector<std::size_t> sharers_elsewhere(const GroupedMethods& of, std::size_t method) {
  std::vector<std::size_t> sharers;
  for (std::size_t m = 0; m < of.methods.size(); ++m)
    if (of.groups[m] == of.groups[method] &&
        library_of(of.methods[m]->name()) != library_of(of.methods[method]->name()))
      sharers.push_back(m);
  return sharers;
}

std::string cause_key(const GroupedMethods& of, std::size_t method, FindingKind kind, Severity severity,
                      Mechanism mechanism, std::string_view reason, KeyForm form) {
  const Method& m = *of.methods[method];
  const std::string library(m.foreign() ? library_of(m.name()) : "own");
  const std::size_t stands_for_it = form == KeyForm::version_0_1 ? of.groups[method] : first_of(of, method);
  const std::string first(of.methods[stands_for_it]->name());
  if (severity == Severity::resolution) return library + "/within-claim";
  if (kind == FindingKind::hang) return first + '/' + to_string(kind);
  if (kind == FindingKind::nondeterminism || kind == FindingKind::state_dependent)
    return library + '/' + to_string(kind);
  if (is_failure(kind) && kind != FindingKind::non_finite)
    return library + '/' + to_string(kind) + '/' + slug(reason);
  switch (mechanism) {
    case Mechanism::gone:
      return first + "/not-again";
    case Mechanism::underflow:
    case Mechanism::overflow:
      return form == KeyForm::version_0_1 ? to_string(mechanism) : first + '/' + to_string(mechanism);
    case Mechanism::setting:
    case Mechanism::unclassified:
      return first + '/' + to_string(kind);
    default:
      return first + '/' + to_string(mechanism);
  }
}

std::string find_cause(const GroupedMethods& of, const Failing& failing, Severity severity,
                       std::string_view reason, Asker& asker) {
  const Mechanism mechanism = classify(of, {&failing, 1}, asker)[0].mechanism;
  return cause_key(of, failing.method, failing.kind, severity, mechanism, reason);
}

}  // namespace cyl
