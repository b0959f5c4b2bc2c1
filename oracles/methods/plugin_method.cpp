// SPDX-License-Identifier: MIT
#include <dlfcn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "base/json.hpp"
#include "base/process/child.hpp"
#include "base/process/process.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/guest.hpp"
#include "oracles/methods/guest_answer.hpp"
#include "oracles/plugin.h"

namespace cyl {
namespace {

/// Seconds in which a library must have loaded.
constexpr unsigned load_cap = 20;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int own_symbols_first = 0;  // sanitizers replace functions, and forbid it
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
constexpr int own_symbols_first = 0;
#else
constexpr int own_symbols_first = RTLD_DEEPBIND;
#endif
#else
constexpr int own_symbols_first = RTLD_DEEPBIND;  // a plug-in's Bullet is not ours
#endif

/// What a library says of itself.
struct Label {
  std::string name, version, source;
  double relative = 0, absolute = 0;
  bool batch = false;
};

/// Bytes that are read of a text of a library's.
constexpr std::size_t name_cap = 63, source_cap = 255;

std::string text_of(const char* text, std::size_t cap) {
  return text ? std::string(text, strnlen(text, cap)) : "";
}

const DaylightMethod& load(const std::string& file) {
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | own_symbols_first);
  if (!library) throw std::runtime_error(dlerror());
  const auto function = reinterpret_cast<const DaylightMethod* (*)()>(dlsym(library, "daylight_method"));
  if (!function) throw std::runtime_error("it has no function daylight_method");
  const DaylightMethod* method = function();
  if (!method || method->abi != DAYLIGHT_PLUGIN_ABI) {
    throw std::runtime_error("it is of interface " + std::to_string(method ? method->abi : 0) +
                             ", this build's is " + std::to_string(DAYLIGHT_PLUGIN_ABI) +
                             ": build it with this oracles/plugin.h");
  }
  if (!method->name || !method->ask) throw std::runtime_error("it has no name or no `ask`");
  return *method;
}

/// The label as CBOR, or a text that says why there is none.
nlohmann::json describe(const std::string& file) try {
  const DaylightMethod& method = load(file);
  if (!(method.claim_relative >= 0) || !(method.claim_absolute >= 0))
    throw std::runtime_error("its claim is negative");
  return {text_of(method.name, name_cap),
          text_of(method.version, name_cap),
          text_of(method.claim_source, source_cap),
          method.claim_relative,
          method.claim_absolute,
          method.ask_all != nullptr};
} catch (const std::exception& error) {
  return text_of(error.what(), source_cap);
}

/// Reads it in a process of its own: the constructors of a library may do anything.
Label read_label(const std::string& file) {
  Child loading([&] {
    alarm(load_cap);
    return format_cbor(describe(file));
  });
  const int status = loading.wait();
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    throw std::runtime_error("it did not load within " + std::to_string(load_cap) + " s");
  if (WIFSIGNALED(status)) throw std::runtime_error("loading it ended with " + signal_name(WTERMSIG(status)));
  if (loading.bytes().empty()) throw std::runtime_error("loading it ended the process");
  const nlohmann::json read = parse_cbor(loading.bytes());
  if (read.is_string()) throw std::runtime_error(read.get<std::string>());
  return {read.at(0), read.at(1), read.at(2), read.at(3), read.at(4), read.at(5)};
}

bool any_given(const double* three) {
  return !std::all_of(three, three + 3, [](double x) { return std::isnan(x); });
}

/// Out of range where it is none, which contained.cpp finds.
Verdict verdict_of(int word) {
  return word >= 0 && word <= DAYLIGHT_UNDECIDED ? static_cast<Verdict>(word) : static_cast<Verdict>(255);
}

class Plugin final : public Method {
 public:
  explicit Plugin(const Guest& guest) : guest_(guest), label_(read_label(guest.what)) {
    if (guest_.name.empty()) guest_.name = label_.name;
    version_ = label_.version + (label_.version.empty() ? "(" : " (") + fingerprint({&guest.what, 1}) + ')';
    if (label_.source.empty()) label_.source = "oracles/plugin.h's claim fields";
  }

  std::string_view name() const override { return guest_.name; }
  std::string_view version() const override { return version_; }
  Claim claim() const override { return {label_.relative, label_.absolute, label_.source}; }
  bool guest() const override { return true; }

  MethodAnswer ask(const Pair& pair) override {
    if (const auto invalid = decline_invalid(pair)) return *invalid;
    const auto a = numbers_of(pair.a), b = numbers_of(pair.b);
    double more[7];
    std::fill_n(more, 7, std::numeric_limits<double>::quiet_NaN());
    const int word = loaded().ask(a.data(), b.data(), more);
    MethodAnswer answer;
    if (word == DAYLIGHT_DECLINED) {
      answer.set_reason("declined");
      return answer;
    }
    if (word == DAYLIGHT_FAILED) return failed_answer(Failure::reported, "no reason given");
    if (word < DAYLIGHT_FAILED || word > DAYLIGHT_UNDECIDED)
      return failed_answer(Failure::malformed,
                           "no answer: " + std::to_string(word) + " is no word of plugin.h");
    answer.status = Status::answered;
    answer.verdict = verdict_of(word);
    answer.has_distance = !std::isnan(more[0]);
    if (answer.has_distance) answer.distance = more[0];
    const bool meet = word == DAYLIGHT_INTERSECTING || word == DAYLIGHT_TOUCHING;
    if (any_given(more + 4) && (meet || !any_given(more + 1))) {
      answer.witness = CertificateKind::point;
      std::copy_n(more + 4, 3, answer.head);
    } else if (any_given(more + 1)) {
      answer.set_direction(Vector3(more[1], more[2], more[3]));
    }
    return answer;
  }

  Call prepare_all(std::span<const Pair> pairs) override {
    return [flat = flatten_all(pairs), method = loaded(pairs)](std::size_t i) {
      double more[7];
      std::fill_n(more, 7, std::numeric_limits<double>::quiet_NaN());
      const int word = method->ask(&flat[16 * i], &flat[16 * i + 8], more);
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
  /// Loads once a process, and only where it is asked: in a worker.
  const DaylightMethod& loaded() {
    if (!method_) method_ = &load(guest_.what);
    return *method_;
  }

  /// The bench asks whether there is such a way at all by no pairs, in its own process.
  const DaylightMethod* loaded(std::span<const Pair> pairs) { return pairs.empty() ? nullptr : &loaded(); }

  static std::vector<double> flatten_all(std::span<const Pair> pairs) {
    std::vector<double> flat;
    flat.reserve(16 * pairs.size());
    for (const Pair& pair : pairs) std::ranges::copy(numbers_of(pair), std::back_inserter(flat));
    return flat;
  }

  Guest guest_;
  Label label_;
  std::string version_;
  const DaylightMethod* method_ = nullptr;
};

}  // namespace

std::unique_ptr<Method> open_plugin(const Guest& guest) { return std::make_unique<Plugin>(guest); }

}  // namespace cyl
