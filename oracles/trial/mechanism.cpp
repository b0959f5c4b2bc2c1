// SPDX-License-Identifier: MIT
#include "oracles/trial/mechanism.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "oracles/referee/referee.hpp"
#include "oracles/trial/algorithm_groups.hpp"
#include "oracles/trial/bucket.hpp"

namespace cyl {
namespace {

/// Powers of two by which a pair is made larger and smaller: more than the tolerances of libraries span in
/// one step, and far from where squares leave the doubles.
constexpr int scale_step = 20;
/// Of a size beyond 2^+-this, products of four lengths leave the doubles or lose bits.
constexpr int extreme_exponent_margin = 200;

Pair scaled(Pair p, int exponent) {
  for (Cylinder* c : {&p.a, &p.b}) {
    for (double& x : c->center) x = std::scalbn(x, exponent);
    c->radius = std::scalbn(c->radius, exponent);
    c->height = std::scalbn(c->height, exponent);
  }
  return p;
}

/// The solid that is nearer to the origin brought there, the other by the same way.
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

/// e where 2^e <= size < 2^(e+1); of two points, of their distance.
int exponent_of_size(const Pair& p) {
  double size = size_of(p);
  if (size == 0) size = (p.b.center - p.a.center).stableNorm();
  return size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
}

bool is_right(const Examination& e) {
  return !e.wrong && e.answer.status == Status::answered && e.answer.verdict != Verdict::undecided;
}

/// The first words of a text, joined by '-'; what has a digit in it, and the words after the first few, tell
/// one pair from another.
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

/// What is known of a failing pair on the way.
struct Suspect {
  Failing now;  ///< the pair as far as it is brought towards the ordinary and still fails
  Claim claim;  ///< by which it fails
  Told told{};
  bool done = false;
  int exponent = 0;  ///< of the size before it was made ordinary
  Enclosure margin{};

  void end(Mechanism m) {
    told.mechanism = m;
    done = true;
  }
};

/// Some questions about each suspect that is not done, all asked together.
class Round {
 public:
  Round(std::span<const std::unique_ptr<Method>> methods, const Caps& caps)
      : methods_(methods), caps_(caps) {}

  std::size_t ask(std::size_t method, const Pair& pair, const Claim& claim) {
    questions_.push_back({method, pairs_.size()});
    pairs_.push_back(pair);
    claims_.push_back(claim);
    return questions_.size() - 1;
  }
  void run() {
    for (const ContainedAnswer& said : ask_contained(methods_, pairs_, questions_, caps_)) {
      const std::size_t q = examined_.size();
      const Pair& pair = pairs_[q];
      const Truth truth = judge(pair, {&said.answer, 1});
      LazyDistance distance([&](double width) { return enclose_distance(pair, truth, width); });
      examined_.push_back({said.answer, compare(pair, truth, distance, claims_[q], said.answer)});
    }
  }
  const Examination& operator[](std::size_t question) const { return examined_[question]; }
  bool fails(std::size_t question, FindingKind kind) const {
    return examined_[question].wrong && examined_[question].wrong->kind == kind;
  }

 private:
  std::span<const std::unique_ptr<Method>> methods_;
  const Caps& caps_;
  std::vector<Pair> pairs_;  ///< by question
  std::vector<Question> questions_;
  std::vector<Claim> claims_;
  std::vector<Examination> examined_;
};

constexpr std::size_t not_asked = static_cast<std::size_t>(-1);

}  // namespace

std::string_view in_words(Mechanism m) noexcept {
  constexpr std::array<std::string_view, 9> words{
      "right when asked again",
      "coordinates of the scene, not of the pair: right where both solids are moved to the origin",
      "its search ends at its own cap on steps",
      "products of small lengths underflow: right at an ordinary size",
      "products of large lengths overflow: right at an ordinary size",
      "a fixed length in it, such as an absolute tolerance: right at another scale",
      "rounding of its double computation",
      "its setting: right with another",
      "no probe told"};
  return words[static_cast<std::size_t>(m)];
}

std::vector<Told> tell_mechanisms(std::span<const std::unique_ptr<Method>> methods,
                                  std::span<const std::size_t> kin, std::span<const Failing> failing,
                                  const Caps& caps) {
  std::vector<Suspect> suspects;
  for (const Failing& f : failing) suspects.push_back({f, methods[f.method]->claim()});
  std::vector<std::size_t> asked(suspects.size()), more(suspects.size());

  // As it is, and moved to the origin.
  Round first(methods, caps);
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    const Failing& f = suspects[i].now;
    asked[i] = first.ask(f.method, f.pair, suspects[i].claim);
    more[i] = is_far(f.pair) ? first.ask(f.method, at_origin(f.pair), suspects[i].claim) : not_asked;
  }
  first.run();
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    Suspect& s = suspects[i];
    const Examination& seen = first[asked[i]];
    s.told.capped = seen.answer.step_cap > 0 && seen.answer.steps >= seen.answer.step_cap;
    if (!first.fails(asked[i], s.now.kind)) {
      s.end(Mechanism::gone);
      continue;
    }
    if (seen.wrong->margin) s.margin = *seen.wrong->margin;
    // A claim has an absolute part: of a distance the error itself is followed instead.
    if (s.now.kind == FindingKind::distance_outside) s.claim = {.relative = s.margin.lo / 2, .source = {}};
    if (more[i] == not_asked) continue;
    s.told.moving_cures = !first.fails(more[i], s.now.kind);
    if (s.told.moving_cures)
      s.end(Mechanism::offset);
    else
      s.now.pair = at_origin(s.now.pair);
  }

  // At an ordinary size.
  Round second(methods, caps);
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    Suspect& s = suspects[i];
    if (s.told.capped && !s.done) s.end(Mechanism::iteration_cap);
    if (s.done) continue;
    s.exponent = exponent_of_size(s.now.pair);
    asked[i] = second.ask(s.now.method, scaled(s.now.pair, -s.exponent), s.claim);
  }
  second.run();
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    Suspect& s = suspects[i];
    if (s.done) continue;
    if (second.fails(asked[i], s.now.kind)) {
      s.now.pair = scaled(s.now.pair, -s.exponent);
      continue;
    }
    (s.exponent < 0 ? s.told.larger_cures : s.told.smaller_cures) = true;
    if (std::abs(s.exponent) > extreme_exponent_margin)
      s.end(s.exponent < 0 ? Mechanism::underflow : Mechanism::overflow);
  }

  // Larger, smaller; other settings.
  Round third(methods, caps);
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> siblings(suspects.size());
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    Suspect& s = suspects[i];
    if (s.done) continue;
    asked[i] = third.ask(s.now.method, scaled(s.now.pair, scale_step), s.claim);
    more[i] = third.ask(s.now.method, scaled(s.now.pair, -scale_step), s.claim);
    for (std::size_t m = 0; m < methods.size(); ++m)
      if (m != s.now.method && kin[m] == kin[s.now.method] &&
          differ_in_setting(methods[m]->name(), methods[s.now.method]->name()))
        siblings[i].emplace_back(m, third.ask(m, s.now.pair, s.claim));
  }
  third.run();
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    Suspect& s = suspects[i];
    if (s.done) continue;
    for (const auto& [m, question] : siblings[i])
      if (!s.told.right_sibling && is_right(third[question])) s.told.right_sibling = m;
    s.told.larger_cures |= !third.fails(asked[i], s.now.kind);
    s.told.smaller_cures |= !third.fails(more[i], s.now.kind);
    if (s.told.larger_cures || s.told.smaller_cures)
      s.end(Mechanism::absolute_length);
    else if (!is_failure(s.now.kind) && s.margin.hi <= rounding_margin)
      s.end(Mechanism::rounding);
    else
      s.end(s.told.right_sibling ? Mechanism::setting : Mechanism::untold);
  }
  std::vector<Told> told;
  for (const Suspect& s : suspects) told.push_back(s.told);
  return told;
}

std::string cause_key(std::span<const std::unique_ptr<Method>> methods, std::span<const std::size_t> kin,
                      std::size_t method, FindingKind kind, Severity severity, const Told& told,
                      std::string_view reason) {
  const Method& m = *methods[method];
  const std::string library(m.foreign() ? library_of(m.name()) : "own");
  const std::string first(methods[kin[method]]->name());
  if (severity == Severity::resolution) return library + "/within-claim";
  if (kind == FindingKind::hang) return first + '/' + cyl::to_string(kind);
  if (kind == FindingKind::nondeterminism) return library + '/' + cyl::to_string(kind);
  if (is_failure(kind) && kind != FindingKind::non_finite)
    return library + '/' + cyl::to_string(kind) + '/' + slug(reason);
  switch (told.mechanism) {
    case Mechanism::gone:
      return first + "/not-again";
    case Mechanism::underflow:
    case Mechanism::overflow:
      return std::string(to_string(told.mechanism));
    case Mechanism::setting:
    case Mechanism::untold:
      return first + '/' + cyl::to_string(kind);
    default:
      return first + '/' + std::string(to_string(told.mechanism));
  }
}

}  // namespace cyl
