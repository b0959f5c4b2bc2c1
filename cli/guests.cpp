// SPDX-License-Identifier: MIT
#include "cli/guests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <stdexcept>

#include "base/process/confine.hpp"
#include "base/usage_error.hpp"
#include "cli/known_guests.hpp"
#include "cli/options.hpp"
#include "corpus/store/run_store.hpp"
#include "oracles/methods/errata.hpp"

namespace cyl {
namespace {

const Method* find(const MethodSet& set, std::string_view name) {
  const auto found = std::ranges::find(set.methods, name, [](const auto& method) { return method->name(); });
  return found == set.methods.end() ? nullptr : found->get();
}

void add(MethodSet& set, const Guest& guest) {
  for (OpenedGuest& opened : open_guest(guest)) {
    if (find(set, opened.guest.name)) {
      throw std::runtime_error("there is a method " + opened.guest.name + " already; give '" + guest.what +
                               "' another name: NAME=...");
    }
    set.methods.push_back(std::move(opened.method));
    set.guests.push_back(std::move(opened.guest));
  }
}

/// Adds the methods of documents that `spec` names, before the guests.
void add_documents(MethodSet& set, std::string_view spec) {
  auto named = named_errata(set.methods, spec);
  set.methods.insert(set.methods.end() - static_cast<std::ptrdiff_t>(set.guests.size()),
                     std::make_move_iterator(named.begin()), std::make_move_iterator(named.end()));
}

/// Throws if `spec` selects none of the guests in [first, next), which one option of this command line
/// loaded.
void refuse_if_left_out(const MethodSet& set, std::size_t first, std::size_t next, std::string_view spec) {
  if (spec.empty()) return;
  std::vector<std::string> names;
  for (const auto& method : set.methods) names.emplace_back(method->name());
  const std::size_t first_guest = set.methods.size() - set.guests.size();
  const auto selected = select_names(names, spec);
  if (std::ranges::any_of(selected,
                          [&](std::size_t i) { return i >= first_guest + first && i < first_guest + next; }))
    return;
  throw UsageError(
      fmt::format("--methods leaves out '{}': add its name, {}, or drop the option that loads it",
                  set.guests[first].what, set.guests[first].name));
}

double read_claim(const std::string& text) {
  char* end = nullptr;
  const double claim = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != 0 || !(claim >= 0) || std::isinf(claim))
    throw UsageError("--claim '" + text + "' is not a margin: give a number such as 1e-9");
  return claim;
}

/// Reads "NAME=1e-9", or "1e-9" for all guests.
void set_claim(Guest& guest, const std::vector<std::string>& claims) {
  for (const std::string& text : claims) {
    const std::size_t equals = text.find('=');
    if (equals != text.npos && text.substr(0, equals) != guest.name) continue;
    guest.claim = read_claim(text.substr(equals == text.npos ? 0 : equals + 1));
  }
}

}  // namespace

void add_methods_option(Command& command, std::string& list) {
  command
      .option(
          "--methods LIST", list,
          "names or prefixes, separated by commas; a '-' before the list excludes, as in --methods=-nlopt")
      .default_text("all");
}

void add_guest_options(Command& command, GuestOptions& options) {
  command
      .option("--plugin FILE", options.plugins,
              "also ask this shared library, which implements oracles/plugin.h; NAME=FILE names it")
      .one_each();
  command
      .option("--command COMMAND", options.commands,
              "also ask this program, which reads JSON lines; NAME=COMMAND names it")
      .one_each();
  command
      .option("--claim MARGIN", options.claims,
              "tolerance of plug-ins and commands, relative to the pair's size; NAME=MARGIN for one of them")
      .one_each();
}

void add_run_guests_option(Command& command, GuestOptions& options, const std::string& needed) {
  command.flag("--run-guests", options.of_runs,
               needed + "start the run's plug-ins and commands, even if they never ran on this machine");
}

std::vector<std::unique_ptr<Method>> MethodSet::select(std::string_view spec, std::string_view unnamed) && {
  if (!spec.empty()) return select_methods(std::move(methods), spec);
  if (guests.empty()) return select_methods(std::move(methods), unnamed);
  methods.erase(methods.begin(), methods.end() - static_cast<std::ptrdiff_t>(guests.size()));
  return std::move(methods);
}

MethodSet with_guests(const GuestOptions& options, std::string_view spec, bool refuse_left_out) {
  MethodSet set{all_methods(), {}};
  add_documents(set, spec);
  if (!options.plugins.empty() && !can_confine()) {
    fmt::print(stderr,
               "daylight: this kernel refuses a filter of system calls (seccomp): plug-ins are asked in "
               "processes of "
               "their own all the same, but nothing keeps them from starting others and sending signals\n");
  }
  try {
    std::vector<Guest> guests;
    for (const std::string& text : options.plugins) guests.push_back(read_guest(GuestKind::plugin, text));
    for (const std::string& text : options.commands) guests.push_back(read_guest(GuestKind::command, text));
    std::vector<std::size_t> loaded{set.guests.size()};
    for (Guest& guest : guests) {
      set_claim(guest, options.claims);
      add(set, guest);
      loaded.push_back(set.guests.size());
    }
    // `spec` may name any of them, so all are loaded first.
    for (std::size_t i = 0; refuse_left_out && i + 1 < loaded.size(); ++i)
      refuse_if_left_out(set, loaded[i], loaded[i + 1], spec);
  } catch (const std::runtime_error& error) {
    throw UsageError(error.what());
  }
  return set;
}

void add_guests_of_run(MethodSet& set, const std::string& run, const GuestOptions& options,
                       std::string& missing) {
  const RunStore store = RunStore::open(run);
  for (const MethodRecord& method : store.methods()) add_documents(set, method.name);
  const Config config = store.config();
  const auto stored = config.find("guests");
  if (stored == config.end()) return;
  for (const Guest& guest : parse_guests(stored->second)) {
    if (find(set, guest.name)) continue;
    if (!options.of_runs && !is_recorded(guest)) {
      missing += fmt::format(
          "{} of {} is not started: you have not started {} on this machine, and a run may "
          "come from a stranger. Its stored answers are used. To start it, add --run-guests\n",
          guest.name, run, options_for(guest));
      continue;
    }
    try {
      add(set, guest);
    } catch (const std::runtime_error& error) {
      missing += guest.name + " of " + run + " is not here: " + error.what() + '\n';
    }
  }
}

MethodSet methods_for_targets(const GuestOptions& options, const std::vector<std::string>& targets,
                              std::string_view spec) {
  MethodSet set = with_guests(options, spec);
  std::string missing;
  for (const std::string& target : targets) {
    std::error_code none;  // if the name is empty
    const auto of_causes =
        std::filesystem::absolute(target, none).parent_path().parent_path();  // RUN/causes/FILE
    for (const std::string& run : {target, target.substr(0, target.rfind(':')), of_causes.string()}) {
      if (!holds_run(run)) continue;
      add_guests_of_run(set, run, options, missing);
      break;
    }
  }
  if (!missing.empty()) fmt::print(stderr, "daylight: {}", missing);
  return set;
}

}  // namespace cyl
