// SPDX-License-Identifier: MIT
#include "cli/guests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "base/usage_error.hpp"
#include "cli/options.hpp"
#include "corpus/store/run_store.hpp"

namespace cyl {
namespace {

const Method* find(const MethodSet& set, std::string_view name) {
  const auto found = std::find_if(set.methods.begin(), set.methods.end(),
                                  [&](const auto& method) { return method->name() == name; });
  return found == set.methods.end() ? nullptr : found->get();
}

void add(MethodSet& set, Guest guest) {
  auto method = open_guest(guest);
  if (find(set, guest.name)) {
    throw std::runtime_error("there is a method " + guest.name + " already; give '" + guest.what +
                             "' another name: NAME=...");
  }
  set.methods.push_back(std::move(method));
  set.guests.push_back(std::move(guest));
}

}  // namespace

void add_guest_options(Command& command, GuestOptions& options) {
  command
      .option("--plugin", options.plugins,
              "ask this shared library too (oracles/plugin.h); NAME=FILE gives it another name")
      .one_each();
  command
      .option("--command", options.commands,
              "ask this program too, by lines of JSON, like 'python3 mine.py'; NAME=COMMAND gives it another "
              "name")
      .one_each();
}

std::vector<std::unique_ptr<Method>> MethodSet::select(std::string_view spec, std::string_view unnamed) && {
  if (!spec.empty()) return select_methods(std::move(methods), spec);
  if (guests.empty()) return select_methods(std::move(methods), unnamed);
  methods.erase(methods.begin(), methods.end() - static_cast<std::ptrdiff_t>(guests.size()));
  return std::move(methods);
}

MethodSet with_guests(const GuestOptions& options) {
  MethodSet set{all_methods(), {}};
  try {
    for (const std::string& text : options.plugins) add(set, read_guest(GuestKind::plugin, text));
    for (const std::string& text : options.commands) add(set, read_guest(GuestKind::command, text));
  } catch (const std::runtime_error& error) {
    throw UsageError(error.what());
  }
  return set;
}

void add_guests_of_run(MethodSet& set, const std::string& run, std::string& missing) {
  const Config config = RunStore::open(run).config();
  const auto stored = config.find("guests");
  if (stored == config.end()) return;
  for (const Guest& guest : parse_guests(stored->second)) {
    if (find(set, guest.name)) continue;
    try {
      add(set, guest);
    } catch (const std::runtime_error& error) {
      missing += guest.name + " of " + run + " is not here: " + error.what() + '\n';
    }
  }
}

MethodSet methods_for_targets(const GuestOptions& options, const std::vector<std::string>& targets) {
  MethodSet set = with_guests(options);
  std::string missing;
  for (const std::string& target : targets) {
    std::error_code none;  // of no name at all
    const auto of_buckets =
        std::filesystem::absolute(target, none).parent_path().parent_path();  // RUN/buckets/FILE
    for (const std::string& run : {target, target.substr(0, target.rfind(':')), of_buckets.string()}) {
      if (!holds_run(run)) continue;
      add_guests_of_run(set, run, missing);
      break;
    }
  }
  if (!missing.empty()) fmt::print(stderr, "daylight: {}", missing);
  return set;
}

}  // namespace cyl
