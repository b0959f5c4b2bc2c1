// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/guest.hpp"
#include "oracles/methods/plugin_library.hpp"

namespace cyl {
namespace {

/// A plug-in may write the first of so many doubles. The guards behind them have this value.
constexpr std::size_t more_size = 7, guard_size = 16;
constexpr double guard = -0x1.5a5a5a5a5a5a5p+77;

bool is_untouched(const double* guards) {
  return std::all_of(guards, guards + guard_size, [](double x) { return x == guard; });
}

/// In the interface, 0 means no limit.
double limit_or_none(double limit) { return limit == 0 ? std::numeric_limits<double>::infinity() : limit; }

SizeRange sizes_of(const DaylightMethod& m) {
  return {m.least_length,         limit_or_none(m.greatest_length),     limit_or_none(m.greatest_aspect),
          m.no_zero_lengths != 1, limit_or_none(m.greatest_coordinate), limit_or_none(m.greatest_gap)};
}

bool any_given(const double* three) {
  return !std::all_of(three, three + 3, [](double x) { return std::isnan(x); });
}

/// Returns a value out of range for an unknown word. contained.cpp finds it.
Verdict verdict_of(int word) {
  if (word == DAYLIGHT_BEYOND) return Verdict::disjoint;
  return word >= 0 && word <= DAYLIGHT_UNDECIDED ? static_cast<Verdict>(word) : static_cast<Verdict>(255);
}

std::string words_or(const char* given, const char* otherwise) {
  return given && *given ? plugin_text(given, sizeof MethodAnswer::reason) : otherwise;
}

/// Returns the part of all labels that is alike up to a '-': "mine" of "mine" and "mine-verdict".
std::string common_name(const std::vector<PluginLabel>& labels) {
  std::string common = labels[0].name;
  for (const PluginLabel& label : labels)
    while (label.name != common && !label.name.starts_with(common + '-'))
      if (const std::size_t part = common.rfind('-'); part != common.npos)
        common.resize(part);
      else
        return labels[0].name;
  return common;
}

/// A method of a library with several: the library has the name that the user gave it, else what the names of
/// its methods have in common.
MethodName name_of(const Guest& guest, const std::vector<PluginLabel>& labels) {
  if (labels.size() == 1) return {guest.name};
  std::string library = common_name(labels);
  if (guest.name != guest.method && guest.name.ends_with('-' + guest.method))
    library = guest.name.substr(0, guest.name.size() - guest.method.size() - 1);
  if (!guest.name.starts_with(library + '-')) return {guest.name};
  return {library, "", guest.name.substr(library.size() + 1)};
}

DaylightSolid struct_of(const Solid& s) {
  DaylightSolid out{1 << static_cast<int>(kind_of(s)), {}, {}, {}, {s.radius, s.height}, s.rounding};
  std::ranges::copy(s.center, out.center);
  if (is_box(s)) {
    std::ranges::copy(s.quaternion, out.quaternion);
    std::ranges::copy(s.edges, out.lengths);
  } else {
    std::ranges::copy(s.axis, out.axis);
  }
  return out;
}

/// Pairs in the form in which a method is asked about them, and the calls that pass them.
class Questions {
 public:
  explicit Questions(const PluginLabel& label, std::span<const Pair> pairs = {})
      : structs_(label.solids()),
        width_(label.method.takes_rounding == 1 ? cylinder_number_count : core_number_count) {
    for (const Pair& pair : pairs) add(pair);
  }

  void add(const Pair& pair) {
    ++count_;
    for (const Solid* s : {&pair.a, &pair.b}) {
      const auto numbers = numbers_of(*s);
      if (structs_)
        solids_.push_back(struct_of(*s));
      else
        numbers_.insert(numbers_.end(), numbers.begin(), numbers.begin() + width_);
    }
  }

  int ask(const DaylightMethod& method, std::size_t i, double* more) const {
    if (structs_) return method.ask_solids(&solids_[2 * i], &solids_[2 * i + 1], more);
    const double* const a = &numbers_[2 * i * static_cast<std::size_t>(width_)];
    return method.ask(a, a + width_, more);
  }
  void ask_all(const DaylightMethod& method, signed char* words) const {
    structs_ ? method.ask_all_solids(count_, solids_.data(), words)
             : method.ask_all(count_, numbers_.data(), words);
  }
  void ask_many(const DaylightMethod& method, int* words, double* more) const {
    structs_ ? method.ask_many_solids(count_, solids_.data(), words, more)
             : method.ask_many(count_, numbers_.data(), words, more);
  }

 private:
  bool structs_;
  std::ptrdiff_t width_;  ///< the numbers of a solid
  std::size_t count_ = 0;
  std::vector<double> numbers_;
  std::vector<DaylightSolid> solids_;
};

class Plugin final : public Method {
 public:
  Plugin(const Guest& guest, std::size_t place, const std::vector<PluginLabel>& labels)
      : Method(name_of(guest, labels)),
        guest_(guest),
        place_(place),
        label_(labels[place]),
        sizes_(sizes_of(label_.method)) {
    version_ = label_.version + (label_.version.empty() ? "(" : " (") + fingerprint({&guest.what, 1}) + ')';
    if (label_.source.empty()) label_.source = "oracles/plugin.h's claim fields";
  }

  std::string_view version() const override { return version_; }
  Claim claim() const override {
    if (guest_.claim) return {*guest_.claim, 0, "--claim"};
    return {label_.method.claim_relative, label_.method.claim_absolute, label_.source};
  }
  bool guest() const override { return true; }
  using Method::supports;
  bool supports(SolidKind kind) const override {
    static_assert(1 << static_cast<int>(SolidKind::sphere) == DAYLIGHT_SPHERE &&
                  1 << static_cast<int>(SolidKind::rounded) == DAYLIGHT_ROUNDED_CYLINDER &&
                  1 << static_cast<int>(SolidKind::half_space) == DAYLIGHT_HALF_SPACE &&
                  1 << static_cast<int>(SolidKind::rounded_box) == DAYLIGHT_ROUNDED_BOX);
    return (label_.method.shapes >> static_cast<int>(kind) & 1) != 0;
  }
  const SizeRange* sizes() const override { return &sizes_; }

  void initialize() override { loaded(); }
  MethodAnswer answer(const Pair& pair) override {
    if (const auto invalid = decline_invalid(pair)) return *invalid;
    // The doubles that it may write, and behind them the ones that it may not.
    double more[more_size + guard_size];
    std::fill_n(more, more_size, std::numeric_limits<double>::quiet_NaN());
    std::fill_n(more + more_size, guard_size, guard);
    const int word = Questions(label_, {&pair, 1}).ask(loaded(), 0, more);
    const char* const reason = word < 0 && loaded().reason ? loaded().reason() : nullptr;
    MethodAnswer answer = answer_of(pair, word, more, reason);
    if (!is_untouched(more + more_size)) {
      answer.side_effect = SideEffect::memory;
      if (answer.status == Status::answered) answer.set_reason("wrote behind more[6]");
    }
    return answer;
  }

  bool has_batch_call() const override {
    return label_.solids() ? label_.method.ask_many_solids != nullptr : label_.method.ask_many != nullptr;
  }
  std::size_t ask_many(std::span<const Pair> pairs, std::span<MethodAnswer> answers) override {
    std::vector<std::size_t> legal;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (const auto invalid = decline_invalid(pairs[i]))
        answers[i] = *invalid;
      else if (!supports(pairs[i]))
        answers[i] = decline(pairs[i]);
      else
        legal.push_back(i);
    }
    Questions questions(label_);
    for (const std::size_t i : legal) questions.add(pairs[i]);
    words_.assign(legal.size(), DAYLIGHT_FAILED);
    more_.assign(more_size * legal.size(), std::numeric_limits<double>::quiet_NaN());
    more_.insert(more_.end(), guard_size, guard);
    questions.ask_many(loaded(), words_.data(), more_.data());
    for (std::size_t i = 0; i < legal.size(); ++i)
      answers[legal[i]] = answer_of(pairs[legal[i]], words_[i], &more_[more_size * i], nullptr);
    if (!legal.empty() && !is_untouched(&more_[more_size * legal.size()]))
      answers[legal[0]].side_effect = SideEffect::memory;
    return pairs.size();
  }

  Call prepare_all(std::span<const Pair> pairs) override {
    return [questions = Questions(label_, pairs), method = loaded(pairs)](std::size_t i) {
      double more[more_size];
      std::fill_n(more, more_size, std::numeric_limits<double>::quiet_NaN());
      const int word = questions.ask(*method, i, more);
      return word < 0 ? Verdict::undecided : verdict_of(word);
    };
  }

  BatchCall prepare_batch(std::span<const Pair> pairs) override {
    if (!(label_.solids() ? label_.method.ask_all_solids != nullptr : label_.method.ask_all != nullptr))
      return {};
    return [questions = Questions(label_, pairs), method = loaded(pairs),
            words = std::vector<signed char>(pairs.size())](std::span<Verdict> verdicts) mutable {
      questions.ask_all(*method, words.data());
      for (std::size_t i = 0; i < words.size(); ++i)
        verdicts[i] = words[i] < 0 ? Verdict::undecided : verdict_of(words[i]);
    };
  }

 private:
  MethodAnswer answer_of(const Pair& pair, int word, const double* more, const char* reason) const {
    if (word == DAYLIGHT_DECLINED) return declined_answer(words_or(reason, "declined"));
    if (word == DAYLIGHT_FAILED) return failed_answer(Failure::reported, words_or(reason, "no reason given"));
    if (word == DAYLIGHT_BEYOND && !(more[0] >= 0))
      return failed_answer(Failure::malformed, "no answer: beyond what, more[0] does not state");
    if (word < DAYLIGHT_FAILED || word > DAYLIGHT_BEYOND)
      return failed_answer(Failure::malformed,
                           "no answer: " + std::to_string(word) + " is no word of plugin.h");
    MethodAnswer answer = answered(verdict_of(word));
    answer.at_least = word == DAYLIGHT_BEYOND;
    answer.has_distance = !answer.at_least && !std::isnan(more[0]);
    if (answer.states_distance()) answer.distance = more[0];
    if (label_.method.depth == DAYLIGHT_DEPTH_AT_MOST) answer.bound_depth();
    const bool meet = word == DAYLIGHT_INTERSECTING || word == DAYLIGHT_TOUCHING;
    if (any_given(more + 4) && !is_rounded(pair) && (meet || !any_given(more + 1))) {
      answer.witness = CertificateKind::point;
      std::copy_n(more + 4, 3, answer.head);
    } else if (any_given(more + 1)) {
      answer.set_direction(Vector3(more[1], more[2], more[3]));
    }
    return answer;
  }

  /// Loads once per process, and only in the worker that asks it.
  const DaylightMethod& loaded() {
    if (!method_) method_ = load_plugin(guest_.what).at(place_);
    return *method_;
  }

  /// The bench passes no pairs, in its own process, to find out whether a method supports a way at all.
  const DaylightMethod* loaded(std::span<const Pair> pairs) { return pairs.empty() ? nullptr : &loaded(); }

  Guest guest_;
  std::size_t place_;  ///< among the methods of its library
  PluginLabel label_;
  SizeRange sizes_;
  std::string version_;
  std::optional<DaylightMethod> method_;
  // Buffers of ask_many().
  std::vector<double> more_;
  std::vector<int> words_;
};

}  // namespace

std::vector<OpenedGuest> open_plugins(const Guest& guest) {
  const std::vector<PluginLabel> labels = read_labels(guest.what);
  std::vector<OpenedGuest> opened;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    Guest each = guest;
    if (!guest.method.empty() && guest.method != labels[i].name) continue;
    if (each.name.empty())
      each.name = labels[i].name;
    else if (labels.size() > 1 && guest.method.empty())
      each.name += '-' + labels[i].name;
    if (labels.size() > 1) each.method = labels[i].name;
    auto method = std::make_unique<Plugin>(each, i, labels);
    opened.push_back({std::move(each), std::move(method)});
  }
  if (opened.empty()) throw std::runtime_error("it has no method " + guest.method + " any more");
  return opened;
}

}  // namespace cyl
