// SPDX-License-Identifier: MIT
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>

#include "base/own_command.hpp"
#include "base/safe_text.hpp"
#include "base/times.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "fuzz/guided/fuzzing.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

struct FuzzArguments {
  std::string budget = "10m", target = "core", out, program;
  std::optional<std::uint64_t> seed;
  unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
};

/// Returns the path of a target: beside this executable if clang built that, else in the folder of the clang
/// build.
std::string program_of(const std::string& target) {
  const std::string name = "fuzz_" + target + "_libfuzzer";
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& folder : {here, here.parent_path() / "clang"})
    if (fs::exists(folder / name)) return folder / name;
  throw std::runtime_error(
      name + " is not built: it is no part of an installation. In a source tree `./daylight fuzz` " +
      "builds it where clang++ is; else:\n" + "    apt-get install clang libclang-rt-14-dev\n" +
      "    cmake --preset clang && ninja -C build/clang " + name);
}

std::string fuzz_numbers(const FuzzProgress& p) {
  const double seconds = std::max(1e-3, static_cast<double>(p.elapsed.count()) / 1000);
  return fmt::format("{} executions, {:.0f} a second; {} features; {} strata; findings {}, deaths {}",
                     p.executions, static_cast<double>(p.executions) / seconds, p.features, p.strata,
                     p.findings, p.deaths);
}

int fuzz(const FuzzArguments& arguments) {
  FuzzOptions options;
  options.budget = parse_duration(arguments.budget);
  options.program = arguments.program.empty() ? program_of(arguments.target) : arguments.program;
  options.target = "fuzz_" + arguments.target;
  options.seed = arguments.seed ? *arguments.seed : std::random_device()();
  options.jobs = arguments.jobs;
  options.out = arguments.out;
  if (options.out.empty())
    options.out = fmt::format("runs/fuzz-{:%Y%m%d-%H%M%S}", fmt::localtime(std::time(nullptr)));
  fmt::print("{}, seed {}, run {}\n", options.target, options.seed, options.out);
  std::fflush(stdout);

  FuzzSummary summary;
  {
    ProgressLine line;
    summary = run_fuzzing(options, [&](const FuzzProgress& progress) {
      if (line.due(progress.elapsed))
        line.show(progress.elapsed,
                  static_cast<double>(progress.elapsed.count()) / static_cast<double>(options.budget.count()),
                  fuzz_numbers(progress));
    });
  }
  fmt::print("{}", format_fuzzing(summary));
  if (!summary.findings.empty())
    fmt::print("the findings: {} replay {}\n", own_command(), shell_quoted(options.out + "/findings.jsonl"));
  if (summary.kept_inputs > 0)
    fmt::print("every method on its corpus: {} campaign --corpus {}\n", own_command(),
               shell_quoted(options.out + "/corpus"));
  if (!summary.harness_failure.empty()) fmt::print(stderr, "daylight: {}\n", summary.harness_failure);
  if (summary.interrupted)
    fmt::print(stderr, "stopped, resume with: {} fuzz --target {} --out {}\n", own_command(),
               arguments.target, shell_quoted(options.out));
  return exit_code(summary);
}

}  // namespace

void add_fuzz(Program& program) {
  Command command =
      program.command("Find", "fuzz", "Lets libFuzzer search for pairs, and proves which method is wrong");
  auto arguments = std::make_shared<FuzzArguments>();
  command.section("Limits");
  command.option("--for DURATION", arguments->budget, "wall time, such as 90s, 10m or 8h");
  command.section("Input");
  command
      .option("--target NAME", arguments->target,
              "core (solver, laws, referee), seed_methods (documents), xcheck (libraries)")
      .one_of({"core", "seed_methods", "xcheck"});
  command.section("Limits");
  command.number("--jobs N", arguments->jobs, "processes side by side", 1, 1024);
  command.section("Output");
  command.option("--out DIR", arguments->out, "run folder; an existing one continues with its corpus")
      .default_text("runs/fuzz-<date-time>");
  command.section("Input");
  command.number("--seed N", arguments->seed, "seed from which the seeds of the jobs are drawn")
      .default_text("random");
  command.option("--program FILE", arguments->program,
                 "another executable of the target, built with libFuzzer");
  command.examples(
      "  daylight fuzz --for 10m --target core --out runs/fuzz-core\n"
      "  daylight fuzz --for 8h --target xcheck --jobs 4",
      "The run folder has the findings in findings.jsonl, which daylight replay reads. Ctrl-C ends\n"
      "the run, and its inputs still come into the corpus.");
  command.run([arguments] { return fuzz(*arguments); });
}

}  // namespace cyl
