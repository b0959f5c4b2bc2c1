// SPDX-License-Identifier: MIT
#include "cli/fuzz.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

#include "base/number_text.hpp"
#include "base/safe_text.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "corpus/store/run_facts.hpp"
#include "fuzz/guided/fuzzing.hpp"
#include "fuzz/guided/record.hpp"
#include "oracles/methods/guest.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

/// A program that fuzzes, and its part of the corpus.
struct FuzzTarget {
  std::string name, program, plugin;
};

/// Returns the plug-ins of a run, each in a process of its own, or else the targets that the run names.
std::vector<FuzzTarget> targets_of_run(const Config& config) {
  std::vector<FuzzTarget> targets;
  for (const Guest& guest : parse_guests(value_of(config, "guests")))
    if (guest.kind == GuestKind::plugin)
      targets.push_back({"plugin-" + guest.name, fuzz_program("xcheck"), guest.what});
  if (!targets.empty()) return targets;
  const std::string names = value_of(config, "fuzz_targets");
  for (const char* name : {"core", "xcheck"})
    if (names.find(name) != names.npos) targets.push_back({name, fuzz_program(name), ""});
  return targets;
}

}  // namespace

std::string fuzz_program(const std::string& target) {
  const std::string name = "fuzz_" + target + "_libfuzzer";
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& folder : {here, here.parent_path() / "clang"})
    if (fs::exists(folder / name)) return folder / name;
  throw std::runtime_error(
      name + " is not built: it is no part of an installation. In a source tree `./daylight fuzz` " +
      "builds it where clang++ is; else:\n" + "    apt-get install clang libclang-rt-14-dev\n" +
      "    cmake --preset clang && ninja -C build/clang " + name);
}

unsigned parse_share(const std::string& text) {
  const auto percent = number_in<unsigned>(text.substr(0, text.size() - text.ends_with('%')));
  if (!text.ends_with('%') || percent.value_or(0) == 0 || *percent >= 100)
    throw UsageError("--fuzz: '" + text + "' is not a share from 1% to 99%");
  return *percent;
}

void plan_fuzzing(const CampaignArguments& arguments, CampaignOptions& options) {
  if (arguments.fuzz == 0) return;
  if (options.budget.count() <= 0)
    throw UsageError("--fuzz is a share of the time: give --for, and not --pairs alone");
  try {
    if (!arguments.guests.plugins.empty())
      fuzz_program("xcheck");
    else
      for (const std::string& target : arguments.fuzz_targets) fuzz_program(target);
  } catch (const std::runtime_error& error) {
    if (arguments.corpus_only) throw;
    options.fuzzing = "not fuzzed: no fuzzer is built here, which needs clang\n";
    fmt::print(stderr, "daylight: not fuzzed: {}\n", error.what());
    return;
  }
  options.fuzz_targets = fmt::format("{}", fmt::join(arguments.fuzz_targets, " "));
  options.fuzz = options.budget * arguments.fuzz / 100;
  options.budget -= options.fuzz;
}

void begin_corpus(const std::string& run, const std::string& from) {
  read_corpus(from);
  fs::create_directories(run);
  fs::copy(from, fs::path(run) / "corpus",
           fs::copy_options::recursive | fs::copy_options::overwrite_existing);
}

bool fuzz_before_campaign(const CampaignOptions& options) {
  RunStore store = RunStore::open(options.out);
  const Config config = store.config();
  const std::string given = value_of(config, "fuzz_milliseconds");
  if (given.empty() || given == "0") return true;
  milliseconds left(number_of(config, "fuzz_milliseconds"));
  std::string fuzzing = value_of(config, "fuzzing");
  bool failed = false;
  const std::vector<FuzzTarget> targets = targets_of_run(config);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const milliseconds budget = left / static_cast<int>(targets.size() - i);
    FuzzSummary summary;
    {
      ProgressLine line;
      summary = run_fuzzing(
          {.program = targets[i].program,
           .target = targets[i].name,
           .plugin = targets[i].plugin,
           .out = options.out,
           .budget = budget,
           .jobs = options.jobs,
           .seed = options.seed + options.shard},
          [&](const FuzzProgress& progress) {
            store.set("fuzz_milliseconds", std::to_string((left - progress.elapsed).count()));
            if (line.due())
              line.show(static_cast<double>(progress.elapsed.count()) / static_cast<double>(budget.count()),
                        "fuzzing " + targets[i].name + ": " + format_progress(progress));
          });
    }
    if (!summary.harness_failure.empty())
      throw std::runtime_error("fuzzing " + targets[i].name + ": " + summary.harness_failure);
    left -= std::min(left, summary.progress.elapsed);
    fuzzing += format_fuzzing(summary);
    failed = failed || !summary.failures.empty();
    store.set("fuzzing", fuzzing);
    if (failed) store.set(fuzz_failed_key, "1");
    store.set("fuzz_milliseconds", std::to_string(left.count()));
    if (summary.interrupted) return false;
  }
  store.set("fuzz_milliseconds", "0");
  return true;
}

void add_fuzz(Program& program) {
  Command command = program.command(
      "Find", "fuzz", "Lets libFuzzer search for pairs, then asks every method, and proves which are wrong");
  auto arguments = std::make_shared<CampaignArguments>();
  arguments->budget = "10m";
  arguments->fuzz = 100;
  arguments->corpus_only = true;
  arguments->cases = "";
  auto target = std::make_shared<std::string>();
  command.section("Limits");
  command.option("--for DURATION", arguments->budget, "wall time of the search, such as 90s, 10m or 8h");
  command.number("--jobs N", arguments->jobs, "processes side by side", 1, 1024);
  command.section("Input");
  command.option("--target NAME", *target, "core (solver, laws, referee) or xcheck (libraries, literature)")
      .one_of({"core", "xcheck"})
      .default_text("both in turn; with --plugin, the plug-in");
  command.number("--seed N", arguments->seed, "seed from which the seeds of the jobs are drawn")
      .default_text("random");
  command.option("--corpus DIR", arguments->corpus, "corpus of an earlier run to begin with")
      .default_text("runs/latest/corpus, if there is one");
  command.section("Methods");
  add_guest_options(command, arguments->guests);
  command.section("Output");
  command.option("--out DIR", arguments->out, "run folder").default_text("runs/<date-time>-<seed>");
  command.flag("--table", arguments->table, "also print the counts of each method");
  command.examples(
      "  daylight fuzz --for 10m\n"
      "  daylight fuzz --for 1h --plugin ./libmine.so --out runs/mine",
      "The run is one of a campaign: triage, replay, export and `campaign --resume` work on it. Ctrl-C ends\n"
      "the search, and its inputs still come into the corpus.");
  command.run([arguments, target] {
    if (!target->empty()) arguments->fuzz_targets = {*target};
    if (*target == "core" && !arguments->guests.any())  // its corpus is about our methods
      for (const auto& method : own_methods())
        arguments->methods.append(arguments->methods.empty() ? "" : ",").append(method->name());
    return campaign(*arguments);
  });
}

}  // namespace cyl
