// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/one_failure.hpp"
#include "cli/options.hpp"

namespace cyl {
namespace {

struct ExportArguments {
  FailureOptions failure;
  std::string out;
  SendOptions sent;
};

int export_case(const ExportArguments& arguments) {
  const MethodSet set = methods_for_targets(arguments.failure.guests, {arguments.failure.target});
  return export_failure(set, failure_of(arguments.failure, set.methods), arguments.sent, arguments.out);
}

}  // namespace

void add_export(Program& program) {
  Command command = program.command(
      "Understand", "export", "Writes a program, a proof and an issue text for the maintainers of a library");
  auto arguments = std::make_shared<ExportArguments>();
  add_failure_options(command, arguments->failure);
  command.section("Output");
  command.option("--out DIR", arguments->out, "folder for the files").required();
  add_send_options(command, arguments->sent);
  command.examples(
      "  daylight export runs/latest:12 --out upstream\n"
      "  daylight export failing.jsonl --method mine --plugin ./libmine.so --source mine.cpp --out sent",
      "daylight builds and runs the program first, and does not write one that does not show the failure.\n"
      "Exit code 64 of export also means that the method is not wrong on that pair, and 3 that the "
      "program\n"
      "could not be built here.");
  command.run([arguments] { return export_case(*arguments); });
}

}  // namespace cyl
