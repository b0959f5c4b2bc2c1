// SPDX-License-Identifier: MIT
#include "oracles/trial/mechanism.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/algorithm_groups.hpp"
#include "oracles/trial/failure_key.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

/// If a size is beyond 2^+-this, products of eight lengths, such as squares of a determinant, leave the
/// range of doubles.
constexpr int product_exponent = 128;
/// A library has no fixed length beyond 2^+-this. A method that is right only there is right by accident,
/// such as by numbers that vanish in single precision.
constexpr int length_exponent = 64;

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
  return near > offset_size_margin * size && apart <= near;
}

/// Returns e with 2^e <= size < 2^(e+1). The distance of two points counts as their size.
int exponent_of_size(const Pair& p) {
  double size = size_of(p);
  if (size == 0) size = (p.b.center - p.a.center).stableNorm();
  return size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
}

/// Returns whether a number after the word is a code, as in "exit status 139" or "GjkEpaResultState 1".
/// Codes distinguish causes. Other numbers distinguish pairs.
bool announces_code(std::string_view lower_word) {
  constexpr std::array words{"code", "error", "errno", "exception", "state", "status"};
  return std::any_of(words.begin(), words.end(), [&](const char* w) { return lower_word.ends_with(w); });
}

/// Returns the first few words of a text, joined by '-'. It omits words that contain a digit, except codes.
/// Like the later words, they distinguish pairs, not causes.
std::string slug(std::string_view text) {
  constexpr int words_cap = 7;
  std::string out;
  int words = 0;
  for (std::size_t at = 0; at < text.size() && words < words_cap;) {
    const auto is_of_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
    std::size_t end = at;
    std::size_t digits = 0;
    for (; end < text.size() && is_of_word(text[end]); ++end)
      digits += std::isdigit(static_cast<unsigned char>(text[end])) != 0;
    const bool code = digits == end - at && (text.size() == digits || announces_code(out));
    if (end > at && (digits == 0 || code)) {
      if (!out.empty()) out += '-';
      for (const char c : text.substr(at, end - at))
        out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      ++words;
    }
    at = end + 1;
  }
  return out;
}

/// Returns the exponents k of the factors 2^k that are tried, from the nearest on. Each is twice the one
/// before. Others bring the size to 1, or to the limits at which products begin to leave the doubles.
std::vector<int> scales_to_try(const Pair& pair, bool larger) {
  std::vector<int> steps;
  for (int k = 1; k <= 1024; k *= 2) steps.push_back(k);
  for (const int size : {-product_exponent, 0, product_exponent})
    if (const int k = size - exponent_of_size(pair); k != 0 && (k > 0) == larger)
      steps.push_back(std::abs(k));
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  if (!larger)
    for (int& k : steps) k = -k;
  return steps;
}

/// Questions that are asked together.
class Round {
 public:
  explicit Round(std::span<const std::unique_ptr<Method>> methods) : methods_(methods) {}

  std::size_t ask(std::size_t method, const Pair& pair) {
    questions_.push_back({method, pairs_.size()});
    pairs_.push_back(pair);
    return questions_.size() - 1;
  }
  void run(Asker& asker) {
    for (const ContainedAnswer& said : asker.ask(pairs_, questions_)) {
      const std::size_t q = trials_.size();
      Trial& trial = trials_.emplace_back(pairs_[q], std::span(&said.answer, 1));
      trial.answers = {said.answer};
      trial.findings = {compare(trial, methods_[questions_[q].method]->claim(), said.answer)};
    }
  }
  Trial& operator[](std::size_t question) { return trials_[question]; }

 private:
  std::span<const std::unique_ptr<Method>> methods_;
  std::vector<Pair> pairs_;  ///< by question
  std::vector<Question> questions_;
  std::vector<Trial> trials_;
};

/// A question about the pair times 2^k.
struct Scaling {
  int k;
  std::size_t question;
};

/// Asks until a scaled pair cannot be built exactly. A rounded one would be another pair.
std::vector<Scaling> ask_scaled(Round& round, std::size_t method, const Pair& pair, std::span<const int> ks) {
  std::vector<Scaling> asked;
  for (const int k : ks) {
    const auto other = scaled_exactly(pair, k);
    if (!other || !is_legal(*other)) break;
    asked.push_back({k, round.ask(method, *other)});
  }
  return asked;
}

/// Returns whether the method is right on the pair of `after`, the failing pair after a change that keeps its
/// truth.
/// 1. Another failure, or no answer, is not a cure.
/// 2. A distance must be right by the claim, and its error at most half as large, relative to the size.
/// Both are trials of one method.
bool cures(const Trial& failing, Trial& after) {
  if (!after.right() || after.meets() != failing.meets()) return false;
  if (failing.finding()->kind != FindingKind::distance_outside) return true;
  // A claim has an absolute part, so the error itself must shrink too.
  const Claim half{.relative = failing.finding()->margin->lo / 2, .source = {}};
  return after.answer().has_distance && !compare(after, half, after.answer());
}

/// Returns the exponent of the first factor that cures the failure.
std::optional<int> first_cure(Round& round, const Trial& failing, std::span<const Scaling> asked) {
  for (const auto& [k, question] : asked)
    if (cures(failing, round[question])) return k;
  return {};
}

/// Returns whether its wrong verdict is right about the solids that it models instead.
bool is_right_about_its_model(const Method& method, const Trial& wrong) {
  const Pair model = method.modelled(wrong.pair);
  if (numbers_of(model) == numbers_of(wrong.pair) || !is_refuted_verdict(wrong.finding()->kind)) return false;
  const Verdict truth = judge_verdict(model).verdict;
  return truth == Verdict::touching ||
         truth == (wrong.answer().verdict == Verdict::disjoint ? Verdict::disjoint : Verdict::intersecting);
}

/// Asks about larger and smaller pairs, and asks other settings.
Mechanism probe(std::span<const std::unique_ptr<Method>> methods, std::size_t method, const Trial& failing,
                Asker& asker, Classification& found) {
  const Pair& pair = failing.pair;
  Round round(methods);
  const auto larger = ask_scaled(round, method, pair, scales_to_try(pair, true));
  const auto smaller = ask_scaled(round, method, pair, scales_to_try(pair, false));
  std::vector<std::pair<std::size_t, std::size_t>> siblings;  // method, question
  for (std::size_t m = 0; m < methods.size(); ++m)
    if (differ_in_setting(*methods[m], *methods[method])) siblings.emplace_back(m, round.ask(m, pair));
  round.run(asker);
  for (const auto& [m, question] : siblings)
    if (!found.right_sibling && round[question].right()) found.right_sibling = m;
  found.larger = first_cure(round, failing, larger);
  found.smaller = first_cure(round, failing, smaller);
  const int size = exponent_of_size(pair);
  if (found.smaller && size + *found.smaller <= -length_exponent) found.smaller.reset();
  if (found.larger && size + *found.larger >= length_exponent) found.larger.reset();
  const auto& [kind, severity, margin] = *failing.finding();
  if (found.smaller && size + *found.smaller >= product_exponent) return Mechanism::overflow;
  if (found.larger && size + *found.larger <= -product_exponent) return Mechanism::underflow;
  if (found.larger || found.smaller) return Mechanism::absolute_length;
  if (!is_failure(kind) && margin && margin->hi <= rounding_margin) return Mechanism::rounding;
  return found.right_sibling ? Mechanism::setting : Mechanism::unclassified;
}

/// Asks about the pair as it is and moved to the origin, and then goes on from the one that still fails.
Mechanism find_mechanism(std::span<const std::unique_ptr<Method>> methods, const Failing& failing,
                         Asker& asker, Classification& found) {
  const bool far = is_far(failing.pair);
  Round round(methods);
  round.ask(failing.method, failing.pair);
  if (far) round.ask(failing.method, at_origin(failing.pair));
  round.run(asker);
  const Trial& as_it_is = round[0];
  found.capped = as_it_is.answer().step_cap > 0 && as_it_is.answer().steps >= as_it_is.answer().step_cap;
  if (!as_it_is.fails(failing.kind)) return Mechanism::gone;
  if (is_right_about_its_model(*methods[failing.method], as_it_is)) return Mechanism::model;
  found.right_at_origin = far && cures(as_it_is, round[1]);
  if (found.right_at_origin) return Mechanism::offset;
  if (found.capped) return Mechanism::iteration_cap;
  const bool moved = far && round[1].fails(failing.kind);
  return probe(methods, failing.method, round[moved ? 1 : 0], asker, found);
}

bool of_one_library(const Method& x, const Method& y) {
  return x.guest() == y.guest() && x.library() == y.library();
}

/// Returns the first method of the same library that shares the method's algorithm.
std::size_t group_representative(const GroupedMethods& of, std::size_t method) {
  std::size_t m = of.groups[method];
  while (of.groups[m] != of.groups[method] || !of_one_library(*of.methods[m], *of.methods[method])) ++m;
  return m;
}

/// Returns the library's name in keys of causes. A guest may have the name of a packaged library.
std::string library_in_keys(const GroupedMethods& of, const Method& method) {
  if (!method.foreign()) return "own";
  const std::string library(method.library());
  const bool is_packaged = method.guest() && std::ranges::any_of(of.methods, [&](const auto& other) {
                             return !other->guest() && other->library() == library;
                           });
  return is_packaged ? library + "-guest" : library;
}

}  // namespace

bool fails_alike(const Trial& failing, const Trial& other) {
  const FindingKind kind = failing.finding()->kind;
  const bool beyond = failing.finding()->severity == Severity::contract;
  if (!other.fails(kind) || (beyond && other.finding()->severity != Severity::contract)) return false;
  const bool broke = is_failure(kind) && kind != FindingKind::non_finite;
  return !broke || slug(other.answer().reason) == slug(failing.answer().reason);
}

std::string_view in_words(Mechanism m) noexcept {
  constexpr std::array words{
      "right when asked again",
      "coordinates of the scene, not of the pair: right where both solids are moved to the origin",
      "its search ends at its own cap on steps",
      "small lengths, or products of them, underflow: right at a larger size",
      "large lengths, or products of them, overflow: right at a smaller size",
      "a fixed length in it, such as an absolute tolerance: right at another scale",
      "rounding of its numbers: right at no size that was tried between 2^-64 and 2^64",
      "its setting: right with another",
      "no probe changed the answer",
      "its model: right about solids with the rounded edges that it gives them"};
  static_assert(words.size() == words_of(Mechanism{}).size());
  return words[static_cast<std::size_t>(m)];
}

Classification classify(std::span<const std::unique_ptr<Method>> methods, const Failing& failing,
                        Asker& asker) {
  Classification found;
  found.mechanism = find_mechanism(methods, failing, asker, found);
  return found;
}

std::optional<bool> depends_on_last_bit(std::string_view method, FindingKind kind, const Pair& pair) {
  for (const auto& m : ccd_methods_of_other_sums())
    if (m->name() == method) return !try_method(m, pair).fails(kind);
  return {};
}

std::vector<std::size_t> methods_sharing_algorithm(const GroupedMethods& of, std::size_t method) {
  std::vector<std::size_t> sharers;
  for (std::size_t m = 0; m < of.methods.size(); ++m)
    if (of.groups[m] == of.groups[method] && !of_one_library(*of.methods[m], *of.methods[method]))
      sharers.push_back(m);
  return sharers;
}

std::string cause_key(const GroupedMethods& of, const Failing& failing, Severity severity,
                      Mechanism mechanism, std::string_view reason) {
  const auto& [method, kind, pair] = failing;
  const Method& m = *of.methods[method];
  const std::string library = library_in_keys(of, m);
  const std::string first(of.methods[group_representative(of, method)]->name());
  if (severity == Severity::resolution) return library + "/within-claim";
  if (kind == FindingKind::hang) return first + '/' + to_string(kind);
  if (kind == FindingKind::nondeterminism || kind == FindingKind::state_dependent)
    return library + '/' + to_string(kind);
  if (is_failure(kind) && kind != FindingKind::non_finite)
    return library + '/' + to_string(kind) + '/' + slug(reason);
  switch (mechanism) {
    case Mechanism::gone:
      return first + "/not-again";
    case Mechanism::setting:
    case Mechanism::unclassified:
      return first + '/' + to_string(kind) + (is_ordinary(pair) ? "" : "/extreme");
    default:
      return first + '/' + to_string(mechanism);
  }
}

std::string find_cause(const GroupedMethods& of, const Failing& failing, Severity severity,
                       std::string_view reason, Asker& asker) {
  const Mechanism mechanism = classify(of.methods, failing, asker).mechanism;
  return cause_key(of, failing, severity, mechanism, reason);
}

}  // namespace cyl
