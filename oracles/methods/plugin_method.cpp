// SPDX-License-Identifier: MIT
#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>

#include "base/json.hpp"
#include "base/process/confine.hpp"
#include "base/process/process.hpp"
#include "base/process/supervised_process.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/guest.hpp"
#include "oracles/plugin.h"

namespace cyl {
namespace {

/// The time in which a library must load.
constexpr int load_cap_milliseconds = 20'000;
/// The cap on the bytes of its labels. A pipe holds as many.
constexpr std::size_t label_cap = 32768;
/// The cap on the methods of one library.
constexpr std::size_t methods_cap = 32;

#ifndef __has_feature
#define __has_feature(name) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || __has_feature(address_sanitizer) || \
    __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
constexpr int own_symbols_first = 0;  // sanitizers replace functions, and forbid it
#else
constexpr int own_symbols_first = RTLD_DEEPBIND;  // a plug-in's Bullet is not ours
#endif

/// A plug-in may write the first of so many doubles. The guards behind them have this value.
constexpr std::size_t more_size = 7, guard_size = 16;
constexpr double guard = -0x1.5a5a5a5a5a5a5p+77;

bool is_untouched(const double* guards) {
  return std::all_of(guards, guards + guard_size, [](double x) { return x == guard; });
}

/// The description that a library gives of one of its methods.
struct Label {
  std::string name, version, source;
  double relative = 0, absolute = 0;
  bool batch = false, many = false;  ///< it has `ask_all` and `ask_many`
  bool rounding = false;             ///< a cylinder is nine numbers
  int shapes = 0;                    ///< the sum of its DaylightShapes
  SizeRange sizes;
  bool depth_at_most = false;  ///< its depths are upper bounds
};

/// The caps on the bytes that are read from a library's texts.
constexpr std::size_t name_cap = 63, source_cap = 255;

std::string text_of(const char* text, std::size_t cap) {
  return text ? std::string(text, strnlen(text, cap)) : "";
}

/// The bytes of a method of each interface. Later ones only add fields.
constexpr std::array interface_sizes{offsetof(DaylightMethod, reason), offsetof(DaylightMethod, shapes),
                                     offsetof(DaylightMethod, greatest_coordinate), sizeof(DaylightMethod)};
static_assert(interface_sizes.size() == DAYLIGHT_PLUGIN_ABI);

constexpr int all_shapes = DAYLIGHT_SPHERE | DAYLIGHT_CAPSULE | DAYLIGHT_CYLINDER | DAYLIGHT_ROUNDED_CYLINDER;

/// Returns the method with all fields of today's interface. A field that its own does not have is 0.
DaylightMethod checked(const DaylightMethod* given) {
  if (!given) throw std::runtime_error("its daylight_method() returns none");
  if (given->abi < 1 || given->abi > DAYLIGHT_PLUGIN_ABI)
    throw std::runtime_error("it is of interface " + std::to_string(given->abi) + ", this build's is " +
                             std::to_string(DAYLIGHT_PLUGIN_ABI) + ": build it with this oracles/plugin.h");
  DaylightMethod method{};
  std::memcpy(&method, given, interface_sizes[static_cast<std::size_t>(given->abi) - 1]);
  if (!method.name || !method.ask) throw std::runtime_error("it has no name or no `ask`");
  if (!(method.claim_relative >= 0) || !(method.claim_absolute >= 0))
    throw std::runtime_error("its claim is negative");
  if (method.shapes < 0 || method.shapes > all_shapes)
    throw std::runtime_error("its shapes are not a sum of DaylightShapes");
  if ((method.shapes & ~DAYLIGHT_CYLINDER) != 0 && method.takes_rounding != 1)
    throw std::runtime_error("it lists shapes with a rounding; set takes_rounding to 1");
  for (const double limit : {method.least_length, method.greatest_length, method.greatest_aspect})
    if (!(limit >= 0) || std::isinf(limit)) throw std::runtime_error("a limit of its sizes is not a length");
  if (method.greatest_length != 0 && method.greatest_length < method.least_length)
    throw std::runtime_error("its greatest_length is less than its least_length");
  for (const double limit : {method.greatest_coordinate, method.greatest_gap})
    if (!(limit >= 0) || std::isinf(limit))
      throw std::runtime_error("a limit of its positions is not a length");
  if (method.depth != DAYLIGHT_DEPTH_EXACT && method.depth != DAYLIGHT_DEPTH_AT_MOST)
    throw std::runtime_error("its depth is not one of DaylightDepth");
  if (method.shapes == 0) method.shapes = method.takes_rounding == 1 ? all_shapes : DAYLIGHT_CYLINDER;
  return method;
}

/// In the interface, 0 means no limit.
double limit_or_none(double limit) { return limit == 0 ? std::numeric_limits<double>::infinity() : limit; }

/// Returns all methods of a library.
std::vector<DaylightMethod> load(const std::string& file) {
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | own_symbols_first);
  if (!library) {  // dlerror() may begin with the file, which the caller names
    const std::string fault = dlerror(), named = file + ": ";
    throw std::runtime_error(fault.starts_with(named) ? fault.substr(named.size()) : fault);
  }
  const auto function = reinterpret_cast<const DaylightMethod* (*)()>(dlsym(library, "daylight_method"));
  if (!function) throw std::runtime_error("it has no function daylight_method");
  std::vector<DaylightMethod> methods{checked(function())};
  while (methods.back().next) {
    if (methods.size() == methods_cap)
      throw std::runtime_error("it has more than " + std::to_string(methods_cap) + " methods");
    methods.push_back(checked(methods.back().next));
  }
  return methods;
}

/// Returns the labels of its methods as CBOR, or a text with the reason why there are none.
nlohmann::json describe(const std::string& file) try {
  nlohmann::json labels = nlohmann::json::array();
  for (const DaylightMethod& m : load(file))
    labels.push_back({text_of(m.name, name_cap), text_of(m.version, name_cap),
                      text_of(m.claim_source, source_cap), m.claim_relative, m.claim_absolute,
                      m.ask_all != nullptr, m.ask_many != nullptr, m.takes_rounding == 1, m.shapes,
                      m.least_length, limit_or_none(m.greatest_length), limit_or_none(m.greatest_aspect),
                      m.no_zero_lengths != 1, limit_or_none(m.greatest_coordinate),
                      limit_or_none(m.greatest_gap), m.depth == DAYLIGHT_DEPTH_AT_MOST});
  return labels;
} catch (const std::exception& error) {
  return text_of(error.what(), source_cap);
}

/// Runs `work` in a process of its own, confined if the kernel supports that, and returns its bytes. Throws
/// std::runtime_error with the way in which the process ended if there are none.
std::string run_apart(const std::function<std::string()>& work) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw_errno("pipe");
  std::optional<SupervisedProcess> loading;
  try {
    loading.emplace(
        [&] {
          std::atomic<int> denied{0};
          confine(denied);
          const std::string bytes = work();
          if (write(ends[1], bytes.data(), bytes.size()) < 0) _exit(1);
        },
        KeptDescriptors{-1, -1, -1, {ends[1]}});
  } catch (...) {
    close_all({ends[0], ends[1]});
    throw;
  }
  close(ends[1]);
  pollfd ended{loading->end(), POLLIN, 0};
  const bool late = poll(&ended, 1, load_cap_milliseconds) == 0;
  if (late) loading->kill_now();
  const auto ending = loading->wait();
  std::string bytes(label_cap, '\0');
  const ssize_t got = read(ends[0], bytes.data(), bytes.size());
  close(ends[0]);
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  if (late)
    throw std::runtime_error("it did not load within " + std::to_string(load_cap_milliseconds / 1000) + " s");
  if (!ending) throw std::runtime_error("loading it was ended from outside");
  if (WIFSIGNALED(ending->status))
    throw std::runtime_error("loading it ended with " + signal_name(WTERMSIG(ending->status)));
  if (WEXITSTATUS(ending->status) == denied_code)
    throw std::runtime_error("loading it starts a process or signals another, which a method may not");
  if (bytes.empty()) throw std::runtime_error("loading it ended the process");
  return bytes;
}

/// Reads the labels in a process of its own, because the constructors of a library may do anything.
std::vector<Label> read_labels(const std::string& file) {
  const nlohmann::json read = parse_cbor(run_apart([&] { return format_cbor(describe(file)); }));
  if (read.is_string()) throw std::runtime_error(read.get<std::string>());
  std::vector<Label> labels;
  for (const nlohmann::json& of : read)
    labels.push_back({of.at(0), of.at(1), of.at(2), of.at(3), of.at(4), of.at(5), of.at(6), of.at(7),
                      of.at(8), SizeRange{of.at(9), of.at(10), of.at(11), of.at(12), of.at(13), of.at(14)},
                      of.at(15)});
  return labels;
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
  return given && *given ? text_of(given, sizeof MethodAnswer::reason) : otherwise;
}

/// Returns the part of all labels that is alike up to a '-': "mine" of "mine" and "mine-verdict".
std::string common_name(const std::vector<Label>& labels) {
  std::string common = labels[0].name;
  for (const Label& label : labels)
    while (label.name != common && !label.name.starts_with(common + '-'))
      if (const std::size_t part = common.rfind('-'); part != common.npos)
        common.resize(part);
      else
        return labels[0].name;
  return common;
}

/// A method of a library with several: the library has the name that the user gave it, else what the names of
/// its methods have in common.
MethodName name_of(const Guest& guest, const std::vector<Label>& labels) {
  if (labels.size() == 1) return {guest.name};
  std::string library = common_name(labels);
  if (guest.name != guest.method && guest.name.ends_with('-' + guest.method))
    library = guest.name.substr(0, guest.name.size() - guest.method.size() - 1);
  if (!guest.name.starts_with(library + '-')) return {guest.name};
  return {library, "", guest.name.substr(library.size() + 1)};
}

class Plugin final : public Method {
 public:
  Plugin(const Guest& guest, std::size_t place, const std::vector<Label>& labels)
      : Method(name_of(guest, labels)), guest_(guest), place_(place), label_(labels[place]) {
    version_ = label_.version + (label_.version.empty() ? "(" : " (") + fingerprint({&guest.what, 1}) + ')';
    if (label_.source.empty()) label_.source = "oracles/plugin.h's claim fields";
  }

  std::string_view version() const override { return version_; }
  Claim claim() const override {
    if (guest_.claim) return {*guest_.claim, 0, "--claim"};
    return {label_.relative, label_.absolute, label_.source};
  }
  bool guest() const override { return true; }
  using Method::supports;
  bool supports(SolidKind kind) const override {
    static_assert(1 << static_cast<int>(SolidKind::sphere) == DAYLIGHT_SPHERE &&
                  1 << static_cast<int>(SolidKind::rounded) == DAYLIGHT_ROUNDED_CYLINDER);
    // No interface has half-spaces yet.
    return kind != SolidKind::half_space && (label_.shapes >> static_cast<int>(kind) & 1) != 0;
  }
  const SizeRange* sizes() const override { return &label_.sizes; }

  void initialize() override { loaded(); }
  MethodAnswer answer(const Pair& pair) override {
    if (const auto invalid = decline_invalid(pair)) return *invalid;
    const auto a = numbers_of(pair.a), b = numbers_of(pair.b);
    // The doubles that it may write, and behind them the ones that it may not.
    double more[more_size + guard_size];
    std::fill_n(more, more_size, std::numeric_limits<double>::quiet_NaN());
    std::fill_n(more + more_size, guard_size, guard);
    const int word = loaded().ask(a.data(), b.data(), more);
    const char* const reason = word < 0 && loaded().reason ? loaded().reason() : nullptr;
    MethodAnswer answer = answer_of(pair, word, more, reason);
    if (!is_untouched(more + more_size)) {
      answer.side_effect = SideEffect::memory;
      if (answer.status == Status::answered) answer.set_reason("wrote behind more[6]");
    }
    return answer;
  }

  bool has_batch_call() const override { return label_.many; }
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
    flat_.clear();
    for (const std::size_t i : legal) append(pairs[i], flat_);
    words_.assign(legal.size(), DAYLIGHT_FAILED);
    more_.assign(more_size * legal.size(), std::numeric_limits<double>::quiet_NaN());
    more_.insert(more_.end(), guard_size, guard);
    loaded().ask_many(legal.size(), flat_.data(), words_.data(), more_.data());
    for (std::size_t i = 0; i < legal.size(); ++i)
      answers[legal[i]] = answer_of(pairs[legal[i]], words_[i], &more_[more_size * i], nullptr);
    if (!legal.empty() && !is_untouched(&more_[more_size * legal.size()]))
      answers[legal[0]].side_effect = SideEffect::memory;
    return pairs.size();
  }

  Call prepare_all(std::span<const Pair> pairs) override {
    return [flat = flatten_all(pairs), method = loaded(pairs), count = number_count()](std::size_t i) {
      double more[more_size];
      std::fill_n(more, more_size, std::numeric_limits<double>::quiet_NaN());
      const int word = method->ask(&flat[2 * count * i], &flat[2 * count * i + count], more);
      return word < 0 ? Verdict::undecided : verdict_of(word);
    };
  }

  BatchCall prepare_batch(std::span<const Pair> pairs) override {
    if (!label_.batch) return {};
    return [flat = flatten_all(pairs), method = loaded(pairs),
            words = std::vector<signed char>(pairs.size())](std::span<Verdict> verdicts) mutable {
      method->ask_all(words.size(), flat.data(), words.data());
      for (std::size_t i = 0; i < words.size(); ++i)
        verdicts[i] = words[i] < 0 ? Verdict::undecided : verdict_of(words[i]);
    };
  }

 private:
  MethodAnswer answer_of(const Pair& pair, int word, const double* more, const char* reason) const {
    MethodAnswer answer;
    if (word == DAYLIGHT_DECLINED) {
      answer.set_reason(words_or(reason, "declined"));
      return answer;
    }
    if (word == DAYLIGHT_FAILED) return failed_answer(Failure::reported, words_or(reason, "no reason given"));
    if (word == DAYLIGHT_BEYOND && !(more[0] >= 0))
      return failed_answer(Failure::malformed, "no answer: beyond what, more[0] does not state");
    if (word < DAYLIGHT_FAILED || word > DAYLIGHT_BEYOND)
      return failed_answer(Failure::malformed,
                           "no answer: " + std::to_string(word) + " is no word of plugin.h");
    answer.status = Status::answered;
    answer.verdict = verdict_of(word);
    answer.at_least = word == DAYLIGHT_BEYOND;
    answer.has_distance = !answer.at_least && !std::isnan(more[0]);
    if (answer.states_distance()) answer.distance = more[0];
    if (label_.depth_at_most) answer.bound_depth();
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
    if (!method_) method_ = load(guest_.what).at(place_);
    return *method_;
  }

  /// The bench passes no pairs, in its own process, to find out whether a method supports a way at all.
  const DaylightMethod* loaded(std::span<const Pair> pairs) { return pairs.empty() ? nullptr : &loaded(); }

  std::size_t number_count() const { return label_.rounding ? cylinder_number_count : core_number_count; }

  void append(const Pair& pair, std::vector<double>& flat) const {
    for (const Solid* c : {&pair.a, &pair.b}) {
      const auto numbers = numbers_of(*c);
      flat.insert(flat.end(), numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(number_count()));
    }
  }

  std::vector<double> flatten_all(std::span<const Pair> pairs) const {
    std::vector<double> flat;
    flat.reserve(2 * number_count() * pairs.size());
    for (const Pair& pair : pairs) append(pair, flat);
    return flat;
  }

  Guest guest_;
  std::size_t place_;  ///< among the methods of its library
  Label label_;
  std::string version_;
  std::optional<DaylightMethod> method_;
  // Buffers of ask_many().
  std::vector<double> flat_, more_;
  std::vector<int> words_;
};

}  // namespace

std::vector<OpenedGuest> open_plugins(const Guest& guest) {
  const std::vector<Label> labels = read_labels(guest.what);
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
