// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "base/files.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "reports/scene/near_report.hpp"
#include "scenes/near/scene_generators.hpp"
#include "scenes/read/scene_files.hpp"

namespace cyl {
namespace {

/// The most nearest pairs that are written. A person may look through as many.
constexpr std::size_t nearest_cap = 1000;

struct NearArguments {
  std::string file, generate, json, csv;
  std::size_t count = 1000, listed = 10;
  std::uint64_t seed = 1;
  double clearance = 0;
  bool verify = false;
};

NearStudy read_cylinders(const NearArguments& arguments) {
  NearStudy study;
  study.clearance = arguments.clearance;
  if (!arguments.generate.empty()) {
    study.generated = arguments.generate;
    study.seed = arguments.seed;
    study.cylinders = generate_cylinders(arguments.generate, arguments.count, arguments.seed);
    fmt::print("seed {}\n", arguments.seed);
    return study;
  }
  const Scene scene = read_scene(arguments.file, "");
  if (!stands_still(scene))
    throw UsageError(arguments.file +
                     " describes bodies that move, are bounded or are no cylinders: use 'daylight scene'");
  study.file = arguments.file;
  study.cylinders = place(scene, joints_at(scene));
  for (const Body& body : scene.bodies) study.names.push_back(body.name);
  return study;
}

int near(const NearArguments& arguments) {
  if (!(arguments.clearance >= 0 && std::isfinite(arguments.clearance)))
    throw UsageError(
        fmt::format("--clearance: {} is not a length: give a finite number, 0 or more", arguments.clearance));
  if (arguments.file.empty() == arguments.generate.empty())
    throw UsageError("which cylinders? Give a FILE or --generate");
  NearStudy study;
  try {
    study = read_cylinders(arguments);
  } catch (const std::runtime_error& error) {
    throw InputError(error.what());
  }
  study.pairs = find_close_pairs(study.cylinders, study.clearance);
  if (arguments.verify) study.check = check_close_pairs(study.cylinders, study.clearance, study.pairs);
  study.nearest = nearest_pairs(study.cylinders, study.clearance, study.pairs, nearest_cap);
  fmt::print("{}", near_text(study, arguments.listed));
  if (!arguments.json.empty()) write_file(arguments.json, near_json(study));
  if (!arguments.csv.empty()) write_file(arguments.csv, near_csv(study));
  if (study.check && study.check->referee.wrong + study.check->certificates.failed > 0) return exit_findings;
  const bool not_proved = study.check && study.check->referee.undecided > 0;
  return not_proved || study.pairs.undecided > 0 ? exit_undecided : exit_pass;
}

}  // namespace

void add_near(Program& program) {
  auto arguments = std::make_shared<NearArguments>();
  Command command =
      program.command("Measure", "near", "Finds the close pairs of many cylinders that stand still");
  command.option("FILE", arguments->file, "solids, one a line: .jsonl or .csv").readable();
  command.section("Question");
  command.option("--clearance LENGTH", arguments->clearance,
                 "list pairs at this distance or nearer, in the unit of the file");
  command.flag("--verify", arguments->verify, "ask the referee about each pair, and check each certificate");
  command.section("Output");
  command.number("--list N", arguments->listed, "nearest pairs to print", 0, nearest_cap);
  command
      .option("--json FILE", arguments->json,
              "write all pairs as JSON, and the 1000 nearest with their points")
      .writable();
  command.option("--csv FILE", arguments->csv, "write the 1000 nearest pairs as CSV").writable();
  command.section("Input");
  command.option("--generate KIND", arguments->generate, "generate rods or pipes instead of reading a file");
  command.number("--count N", arguments->count, "number of cylinders to generate", 1, 10'000'000);
  command.number("--seed N", arguments->seed, "seed; the same seed gives the same cylinders");
  command.examples(
      "  daylight near parts.csv --clearance 0.01 --csv near.csv\n"
      "  daylight near --generate rods --count 100000 --verify",
      "Exit code 2 of near means that the referee refutes an answer or that a certificate fails,\n"
      "3 that a pair is undecided, and 65 that the file is not a list of solids, or that the boxes of more\n"
      "than 5,000,000 pairs meet (of more than two pairs for each solid, if that is more).");
  command.run([arguments] { return near(*arguments); });
}

}  // namespace cyl
