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
};

int export_case(const ExportArguments& arguments) {
  const MethodSet set = methods_for_targets(arguments.failure.guests, {arguments.failure.target});
  return export_failure(set, failure_of(arguments.failure, set.methods), arguments.out);
}

}  // namespace

void add_export(Program& program) {
  Command command =
      program.command("Understand", "export",
                      "Writes a proof, an issue text and a program or case for the maintainers of a library");
  auto arguments = std::make_shared<ExportArguments>();
  add_failure_options(command, arguments->failure);
  command.section("Output");
  command.option("--out DIR", arguments->out, "folder for the files").required();
  command.examples(
      "  daylight export runs/latest:12 --out upstream\n"
      "  daylight export runs/latest fcl-libccd/hang --out upstream\n"
      "  daylight export failing.jsonl --method mine --plugin ./libmine.so --out sent",
      "A program for a packaged library is built and run first, and not written if it does not show the\n"
      "failure. Exit code 64 of export also means that the method is not wrong on that pair, and 3 that the\n"
      "program could not be built here.");
  command.run([arguments] { return export_case(*arguments); });
}

}  // namespace cyl
