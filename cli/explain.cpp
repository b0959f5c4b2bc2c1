// SPDX-License-Identifier: MIT
#include "reports/explain/explain.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/one_failure.hpp"
#include "cli/options.hpp"

namespace cyl {

void add_explain(Program& program) {
  Command command = program.command("Understand", "explain", "Reports why a method is wrong on one pair");
  auto options = std::make_shared<FailureOptions>();
  add_failure_options(command, *options);
  command.examples(
      "  daylight explain runs/latest:12\n"
      "  daylight explain runs/latest fcl-libccd/overflow\n"
      "  daylight explain failing.jsonl:3 --method fcl-libccd",
      "Exit code 64 of explain also means that the method is not wrong on that pair. 2 and 3 do not occur.");
  command.run([options] {
    const auto methods = methods_for_targets(options->guests, {options->target}).methods;
    const OneFailure failure = failure_of(*options, methods);
    fmt::print("{}", explain(methods, failure.method, failure.kind, failure.pair));
    return exit_pass;
  });
}

}  // namespace cyl
