// SPDX-License-Identifier: MIT
#include "reports/export/export.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "base/own_command.hpp"
#include "base/process/child.hpp"
#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/one_failure.hpp"
#include "cli/options.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

struct ExportArguments {
  FailureOptions failure;
  std::string out;
};

/// The time limit for a build and for a program that does not end.
constexpr std::chrono::minutes build_cap{5};

/// The output of a folder's build.sh, and how it ends.
struct Ran {
  std::string printed;
  int status = 0;
};

Ran run_build(const fs::path& folder) {
  const auto deadline = std::chrono::steady_clock::now() + build_cap;
  Child child({"sh", "-c", "exec sh \"$0\" 2>&1", (folder / "build.sh").string()}, {.own_group = true});
  while (!child.advance()) {
    if (std::chrono::steady_clock::now() > deadline) child.kill_now();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return {child.bytes(), child.status()};
}

/// Returns whether the program, built and run in its own folder, shows the failure. False if it could not be
/// built. Throws std::runtime_error if it ran without a failure.
bool shows_failure(const Export& files) {
  std::string name = (fs::temp_directory_path() / "daylight-export-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + " cannot be made");
  const std::shared_ptr<void> removed(nullptr, [&](void*) {
    std::error_code none;
    fs::remove_all(name, none);
  });
  write_export(files, name);
  const Ran ran = run_build(name);
  if (!fs::exists(fs::path(name) / "reproduce")) return false;
  if (!WIFEXITED(ran.status) || WEXITSTATUS(ran.status) != 0) return true;
  throw std::runtime_error(
      "the program that would be sent does not show the failure, so nothing is written. It printed:\n" +
      ran.printed);
}

/// Writes the export and prints what it wrote. A program for a packaged library is built and run first.
int export_case(const ExportArguments& arguments) {
  const MethodSet set = methods_for_targets(arguments.failure.guests, {arguments.failure.target});
  const OneFailure failure = failure_of(arguments.failure, set.methods);
  const auto guest = std::ranges::find(set.guests, failure.method, &Guest::name);
  const bool is_guest = guest != set.guests.end();
  const Export files =
      make_export(set.methods, failure.method, failure.kind, failure.pair, is_guest ? &*guest : nullptr);
  const bool shown = is_guest || shows_failure(files);
  write_export(files, arguments.out);
  std::vector<std::string_view> names;
  for (const auto& [name, text] : files) names.push_back(name);
  fmt::print("{}, {}: {}/{}\n", failure.method, to_string(failure.kind), arguments.out,
             fmt::join(names, ", "));
  if (is_guest)
    fmt::print("ask it again: {}\n", command_for(own_command(), arguments.out + "/case.jsonl", *guest));
  else
    fmt::print("{}\n", shown ? "tested: it was built and run here, and shows the failure"
                             : "not tested: it could not be built here; sh build.sh in that folder shows the "
                               "reason");
  return shown ? exit_pass : exit_undecided;
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
