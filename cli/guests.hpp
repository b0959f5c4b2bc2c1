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
  std::vector<std::string> plugins, commands;
  bool any() const { return !plugins.empty() || !commands.empty(); }
};

void add_guest_options(Command& command, GuestOptions& options);

/// Every method of this build and, after them, the guests; throws UsageError where a guest cannot
/// be had or has a name that is taken.
struct Company {
  std::vector<std::unique_ptr<Method>> methods;
  std::vector<Guest> guests;  ///< with the names they are called by

  /// As select_methods; "" stands for the guests where there are any, else for what `unnamed` names.
  std::vector<std::unique_ptr<Method>> select(std::string_view spec, std::string_view unnamed) &&;
};
Company with_guests(const GuestOptions& options);

/// And the guests that the run in this folder asked, but those that are here by that name. Where one cannot
/// be had, `missing` is told why.
void add_guests_of_run(Company& company, const std::string& run, std::string& missing);

/// For `targets` of targets.hpp: with_guests, and those of the runs that are named, be it by a file of one.
/// A guest of a run that cannot be had is told of on standard error and left out.
Company company_for(const GuestOptions& options, const std::vector<std::string>& targets);

}  // namespace cyl
