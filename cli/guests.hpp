// SPDX-License-Identifier: MIT
// The options that bring methods from outside, the same for every command that asks methods.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/methods/guest.hpp"

namespace cyl {

class Command;

struct GuestOptions {
  std::vector<std::string> plugins, commands, claims;
  bool of_runs = false;  ///< start the guests of a run even if this user has not started them before
  bool any() const { return !plugins.empty() || !commands.empty(); }
};

void add_guest_options(Command& command, GuestOptions& options);
/// Adds --methods, whose list select_methods() reads.
void add_methods_option(Command& command, std::string& list);

/// Methods, the guests last.
struct MethodSet {
  std::vector<std::unique_ptr<Method>> methods;
  std::vector<Guest> guests;  ///< with the names they are called by

  /// Selects like select_methods(). "" means the guests, or the methods that `unnamed` names if there are no
  /// guests.
  std::vector<std::unique_ptr<Method>> select(std::string_view spec, std::string_view unnamed) &&;
};

/// Returns every method of this build, the ones of errata_methods() that `spec` names, and the guests. Throws
/// UsageError if a guest does not start, its name is taken, or `spec` leaves it out and that is refused.
MethodSet with_guests(const GuestOptions& options, std::string_view spec = {}, bool refuse_left_out = false);

/// Adds the guests and errata_methods() of the run in this folder, except those that are present by that
/// name. A guest that this user has not started before (known_guests.hpp) starts only if the options allow
/// it. If a guest does not start, the reason is added to `missing`.
void add_guests_of_run(MethodSet& set, const std::string& run, const GuestOptions& options,
                       std::string& missing);

/// Adds --run-guests, for commands that read runs. `needed` begins its help.
void add_run_guests_option(Command& command, GuestOptions& options, const std::string& needed = {});

/// Returns what with_guests() does, and the guests of the runs that `targets` (of targets.hpp) name, be it by
/// a file of one. A guest of a run that cannot be had is left out, with a line on standard error.
MethodSet methods_for_targets(const GuestOptions& options, const std::vector<std::string>& targets,
                              std::string_view spec = {});

}  // namespace cyl
