// SPDX-License-Identifier: MIT
#include "oracles/methods/plugin_library.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <functional>
#include <optional>
#include <stdexcept>

#include "base/json.hpp"
#include "base/process/confine.hpp"
#include "base/process/process.hpp"
#include "base/process/supervised_process.hpp"

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

/// The caps on the bytes that are read from a library's texts.
constexpr std::size_t name_cap = 63, source_cap = 255;

/// The bytes of a method of each interface. Later ones only add fields.
constexpr std::array interface_sizes{offsetof(DaylightMethod, reason), offsetof(DaylightMethod, shapes),
                                     offsetof(DaylightMethod, greatest_coordinate), sizeof(DaylightMethod)};
static_assert(interface_sizes.size() == DAYLIGHT_PLUGIN_ABI);

constexpr int cylinder_shapes =
    DAYLIGHT_SPHERE | DAYLIGHT_CAPSULE | DAYLIGHT_CYLINDER | DAYLIGHT_ROUNDED_CYLINDER;
constexpr int all_shapes = cylinder_shapes | DAYLIGHT_HALF_SPACE | DAYLIGHT_BOX | DAYLIGHT_ROUNDED_BOX;

/// Returns the method with all fields of today's interface. A field that its own does not have is 0.
DaylightMethod checked(const DaylightMethod* given) {
  if (!given) throw std::runtime_error("its daylight_method() returns none");
  if (given->abi < 1 || given->abi > DAYLIGHT_PLUGIN_ABI)
    throw std::runtime_error("it is of interface " + std::to_string(given->abi) + ", this build's is " +
                             std::to_string(DAYLIGHT_PLUGIN_ABI) + ": build it with this oracles/plugin.h");
  DaylightMethod method{};
  std::memcpy(&method, given, interface_sizes[static_cast<std::size_t>(given->abi) - 1]);
  if (!method.name || !(method.ask || method.ask_solids))
    throw std::runtime_error("it has no name or no `ask`");
  if (!(method.claim_relative >= 0) || !(method.claim_absolute >= 0))
    throw std::runtime_error("its claim is negative");
  if (method.shapes < 0 || method.shapes > all_shapes || (given->abi < 4 && method.shapes > cylinder_shapes))
    throw std::runtime_error("its shapes are not a sum of DaylightShapes");
  if (method.shapes == DAYLIGHT_HALF_SPACE)
    throw std::runtime_error("it lists half-spaces alone, and no pair has two");
  if (method.shapes > cylinder_shapes && !method.ask_solids)
    throw std::runtime_error("it lists half-spaces or boxes; set ask_solids");
  if ((method.shapes & ~DAYLIGHT_CYLINDER) != 0 && method.takes_rounding != 1 && !method.ask_solids)
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
  if (method.shapes == 0) method.shapes = method.takes_rounding == 1 ? cylinder_shapes : DAYLIGHT_CYLINDER;
  return method;
}

/// Returns the labels of its methods as CBOR, or a text with the reason why there are none.
nlohmann::json describe(const std::string& file) try {
  nlohmann::json labels = nlohmann::json::array();
  for (const DaylightMethod& m : load_plugin(file))
    labels.push_back({plugin_text(m.name, name_cap), plugin_text(m.version, name_cap),
                      plugin_text(m.claim_source, source_cap),
                      std::string(reinterpret_cast<const char*>(&m), sizeof m)});
  return labels;
} catch (const std::exception& error) {
  return plugin_text(error.what(), source_cap);
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

}  // namespace

std::string plugin_text(const char* text, std::size_t cap) {
  return text ? std::string(text, strnlen(text, cap)) : "";
}

std::vector<DaylightMethod> load_plugin(const std::string& file) {
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

std::vector<PluginLabel> read_labels(const std::string& file) {
  const nlohmann::json read = parse_cbor(run_apart([&] { return format_cbor(describe(file)); }));
  if (read.is_string()) throw std::runtime_error(read.get<std::string>());
  std::vector<PluginLabel> labels;
  for (const nlohmann::json& of : read) {
    labels.push_back({of.at(0), of.at(1), of.at(2), {}});
    const std::string bytes = of.at(3);
    bytes.copy(reinterpret_cast<char*>(&labels.back().method), sizeof(DaylightMethod));
  }
  return labels;
}

}  // namespace cyl
