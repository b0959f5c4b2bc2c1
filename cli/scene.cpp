// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "base/files.hpp"
#include "base/number_text.hpp"
#include "base/times.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "reports/scene/scene_report.hpp"
#include "scenes/read/scene_files.hpp"
#include "scenes/study/scene_study.hpp"

namespace cyl {
namespace {

struct SceneArguments {
  std::string json, srdf, srdf_out, budget;
  std::vector<std::string> at, files_from;
  bool table = false;
  SceneOptions question;
};

/// Reads "elbow=0.5". Throws UsageError if the text has another form.
std::pair<std::string, double> parse_joint(const std::string& text) {
  if (const auto sign = text.find('='); sign != text.npos)
    if (const auto value = number_in<double>(text.substr(sign + 1)); value && std::isfinite(*value))
      return {text.substr(0, sign), *value};
  throw UsageError("--at: '" + text + "' is not JOINT=VALUE");
}

void check_length(const char* option, double length) {
  if (length >= 0 && std::isfinite(length)) return;
  throw UsageError(fmt::format("{}: {} is not a length: give a finite number, 0 or more", option, length));
}

/// Shows how far the study is.
SceneStudy study_with_progress(const Scene& scene, SceneOptions question, const std::string& budget) {
  if (!budget.empty())
    question.workforce.deadline = std::chrono::steady_clock::now() + parse_duration(budget);
  ProgressLine line;
  question.workforce.show = [&](double share, const std::string& results) {
    if (line.due()) line.show(share, results);
  };
  return study_scene(scene, question);
}

int study(SceneArguments& arguments) {
  SceneOptions& question = arguments.question;
  check_length("--clearance", question.clearance);
  check_length("--tolerate", question.tolerated);
  if (question.file.empty()) throw UsageError("which scene? Give a FILE");
  for (const std::string& text : arguments.at) question.at.push_back(parse_joint(text));
  if (!arguments.srdf_out.empty()) {
    if (!question.at.empty())
      throw UsageError(
          "--srdf-out covers all motions, but --at covers one configuration: give only one of them");
    question.prove = question.prove_others = true;
  }
  Scene scene;
  try {
    scene = read_scene(question.file, arguments.srdf, arguments.files_from);
  } catch (const std::runtime_error& error) {
    throw InputError(error.what());
  }
  const SceneStudy s = study_with_progress(scene, question, arguments.budget);
  fmt::print("{}", study_text(scene, question, s, arguments.table));
  if (!arguments.srdf_out.empty()) write_file(arguments.srdf_out, srdf_text(scene, question, s));
  if (!arguments.json.empty()) write_file(arguments.json, study_json(scene, question, s));
  if (s.verification.wrong > 0) return exit_findings;
  const auto is_refuted = [](const ExemptionProof& e) { return e.verdict == MotionVerdict::refuted; };
  const auto is_open = [](const auto& proof) { return proof.verdict == MotionVerdict::open; };
  if (s.motions && (s.motions->contradicted > 0 || std::ranges::any_of(s.motions->exemptions, is_refuted)))
    return exit_findings;
  const bool left_open = s.motions && (std::ranges::any_of(s.motions->pairs, is_open) ||
                                       std::ranges::any_of(s.motions->exemptions, is_open));
  const bool not_proved = left_open || s.undecided > 0 || s.verification.undecided > 0;
  const bool not_known = !s.motions && std::ranges::any_of(s.pairs, cyl::is_open);
  const bool not_seen = !scene.left_out.empty() || !joints_held_between(scene, s).empty();
  return not_proved || not_known || not_seen ? exit_undecided : exit_pass;
}

}  // namespace

void add_scene(Program& program) {
  auto arguments = std::make_shared<SceneArguments>();
  SceneOptions& question = arguments->question;
  Command command = program.command(
      "Measure", "scene",
      "Reports which simpler shapes can replace a robot's cylinders, and the time each takes");
  command.option("FILE", question.file, "scene: .urdf, .xml (MJCF), or solids in .jsonl").readable();
  command.section("Question");
  command.option("--clearance LENGTH", question.clearance,
                 "gaps up to this are too near; in the scene's unit (URDF, MJCF: metres)");
  command.option("--tolerate LENGTH", question.tolerated,
                 "false alarms up to this far beyond the clearance are harmless");
  command.section("Configurations");
  command.number("--configurations N", question.configurations,
                 "configurations to draw within the limits of the joints", 1, 1'000'000);
  command.number("--seed N", question.seed, "seed; the same seed gives the same configurations");
  command.option("--at JOINT=VALUE", arguments->at, "one configuration; the other joints are at 0");
  command.section("Proofs");
  command.flag("--prove", question.prove,
               "prove over all motions which pairs stay clear, or show where they do not");
  command.option("--for DURATION", arguments->budget,
                 "wall time, such as 90s: fewer configurations, and pairs without a proof are open");
  command.section("Pairs");
  command
      .option("--srdf FILE", arguments->srdf,
              "SRDF with the pairs that are not checked; default: FILE.srdf beside FILE.urdf")
      .readable();
  command.section("Input");
  command
      .option("--files-from DIR", arguments->files_from,
              "read meshes and includes also from DIR, not only from the folder or ROS package of FILE")
      .existing_folder()
      .one_each();
  command.section("Output");
  command
      .option("--srdf-out FILE", arguments->srdf_out,
              "write an SRDF that disables neighbours and proved pairs; implies --prove")
      .writable();
  command.flag("--table", arguments->table,
               "also list each model, and the pairs that are proved or need more");
  command.option("--json FILE", arguments->json, "write everything as JSON").writable();
  command.examples(
      "  daylight scene robot.urdf --clearance 0.01 --json robot.json\n"
      "  daylight scene robot.urdf --prove --srdf-out robot.srdf",
      "Exit code 2 of scene means that a proof refutes a recommended answer, or that --prove shows\n"
      "contact of links that the SRDF disables as \"Never\". 3 also means that --prove left a pair open,\n"
      "shapes were not examined, only a bounding solid of a mesh or ellipsoid is known to be near, or "
      "joints\n"
      "were not moved.");
  command.run([arguments] { return study(*arguments); });
}

}  // namespace cyl
