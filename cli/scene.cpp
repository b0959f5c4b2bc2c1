// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "base/files.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "reports/scene/scene_report.hpp"
#include "reports/web/page_template.hpp"
#include "scenes/scene_files.hpp"
#include "scenes/scene_study.hpp"

namespace cyl {
namespace {

/// The number of cylinders of which a page has all pairs: 20 thousand, in ten configurations, some 40 MB.
constexpr std::size_t page_cap = 200;

struct SceneArguments {
  std::string json, page, srdf, srdf_out;
  std::vector<std::string> at;
  SceneQuestion question;
};

/// Reads "elbow=0.5". Throws UsageError where the text is no such thing.
std::pair<std::string, double> parse_joint(const std::string& text) {
  const auto sign = text.find('=');
  double value = 0;
  if (sign != text.npos) {
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data() + sign + 1, end, value);
    if (error == std::errc() && rest == end && std::isfinite(value)) return {text.substr(0, sign), value};
  }
  throw UsageError("--at: '" + text + "' is not JOINT=VALUE");
}

void check_length(const char* option, double length) {
  if (length >= 0 && std::isfinite(length)) return;
  throw UsageError(fmt::format("{}: {} is no length; give a finite number, 0 or more", option, length));
}

/// Throws UsageError, before any work, if there are too many cylinders for a study or for its page.
void check_count(const SceneArguments& arguments, const Scene& scene) {
  const std::size_t cylinders = scene.bodies.size();
  if (cylinders > study_cap)
    throw UsageError(
        fmt::format("{} cylinders; a study holds up to {}{}", cylinders, study_cap,
                    stands_still(scene) ? "; 'daylight near' finds the close pairs of more" : ""));
  if (!arguments.page.empty() && cylinders > page_cap)
    throw UsageError(fmt::format("--page shows up to {} cylinders, not {}; take --json{}", page_cap,
                                 cylinders, stands_still(scene) ? ", or 'daylight near'" : ""));
}

void write_results(const SceneArguments& arguments, const Scene& scene, const SceneStudy& s) {
  if (!arguments.srdf_out.empty()) write_file(arguments.srdf_out, srdf_text(scene, arguments.question, s));
  if (arguments.json.empty() && arguments.page.empty()) return;
  const std::string json = study_json(scene, arguments.question, s);
  if (!arguments.json.empty()) write_file(arguments.json, json);
  if (!arguments.page.empty()) write_file(arguments.page, fill_template(json));
}

int study(SceneArguments& arguments) {
  SceneQuestion& question = arguments.question;
  check_length("--clearance", question.clearance);
  check_length("--tolerate", question.tolerated);
  if (!(question.rate > 0 && question.rate <= 1)) throw UsageError("--rate is a share: above 0, 1 at most");
  if (question.file.empty()) throw UsageError("which scene? Give a FILE");
  for (const std::string& text : arguments.at) question.at.push_back(parse_joint(text));
  if (!arguments.srdf_out.empty()) {
    if (!question.at.empty())
      throw UsageError(
          "--srdf-out is about all motions, --at about one configuration; leave one of them out");
    question.prove = question.prove_others = true;
  }
  Scene scene;
  try {
    scene = read_scene(question.file, arguments.srdf);
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "daylight: {}\n", error.what());
    return exit_invalid_input;
  }
  check_count(arguments, scene);
  const SceneStudy s = study_scene(scene, question);
  fmt::print("{}", study_text(scene, question, s));
  write_results(arguments, scene, s);
  if (s.verification && s.verification->wrong > 0) return exit_findings;
  const auto is_refuted = [](const ExemptionProof& e) { return e.verdict == MotionVerdict::refuted; };
  const auto is_open = [](const auto& proof) { return proof.verdict == MotionVerdict::open; };
  if (s.motions && (s.motions->gainsaid > 0 || std::ranges::any_of(s.motions->exemptions, is_refuted)))
    return exit_findings;
  const bool left_open = s.motions && (std::ranges::any_of(s.motions->pairs, is_open) ||
                                       std::ranges::any_of(s.motions->exemptions, is_open));
  const bool not_proved = left_open || s.undecided > 0 || (s.verification && s.verification->undecided > 0);
  const bool not_known =
      !std::ranges::all_of(s.pairs, [&](const PairStudy& p) { return is_known(scene, p); });
  const bool not_seen = !scene.left_out.empty() || !held_between(scene, s).empty();
  return not_proved || not_known || not_seen ? exit_undecided : exit_pass;
}

}  // namespace

void add_scene(Program& program) {
  auto arguments = std::make_shared<SceneArguments>();
  SceneQuestion& question = arguments->question;
  question.rate = 0.003;  // the rule of three on 1000 draws
  Command command = program.command(
      "Measure", "scene", "Reports which model of its shapes a scene or robot needs, and at what cost");
  command.option("FILE", question.file, "a scene: .urdf, .xml (MJCF), .jsonl or .csv of solids").readable();
  command.option("--clearance", question.clearance,
                 "solids at this distance or nearer are too near; in the scene's unit (URDF, MJCF: metres)");
  command.option("--tolerate", question.tolerated,
                 "distance beyond the clearance up to which a false alarm does no harm");
  command.number("--configurations", question.configurations,
                 "configurations to draw within the joints' limits", 1, 1'000'000);
  command.option(
      "--rate", question.rate,
      "draw more for a pair whose model was not seen wrong, until at 95 % it is wrong in no more than this "
      "share");
  command.number("--most", question.most, "--rate: configurations to draw, at most", 1, 100'000'000);
  command.number("--seed", question.seed, "same seed, same configurations");
  command.option("--at", arguments->at, "JOINT=VALUE..: one configuration, the other joints at 0");
  command.flag("--all-pairs", question.all_pairs,
               "also adjacent links and those that the description disables");
  command.flag("--each-link", question.each_link,
               "take links that fixed joints join for bodies of their own, and check them too");
  command.flag("--verify", question.verify, "put every recommended answer before the referee");
  command.flag("--prove", question.prove,
               "prove over all motions that pairs stay clear, or show where not; also for pairs that the "
               "SRDF disables");
  command.number("--boxes", question.motion_boxes, "--prove: boxes of joint values to look at for a pair", 1,
                 100'000'000);
  command.number("--against", question.against,
                 "--prove: other configurations to draw, to look for bodies nearer than was proved", 0,
                 1'000'000'000);
  command
      .option("--srdf", arguments->srdf,
              "the pairs of links not to be checked; without it, FILE.srdf beside FILE.urdf")
      .readable();
  command
      .option(
          "--srdf-out", arguments->srdf_out,
          "write an SRDF that disables neighbours and pairs that are proved never to touch; implies --prove")
      .writable();
  command.option("--json", arguments->json, "write everything as JSON, a line of results for each pair")
      .writable();
  command
      .option("--page", arguments->page,
              "write it as one HTML file: the robot in 3D, its pairs, cost against wrong answers")
      .writable();
  command.examples(
      "  daylight scene robot.urdf --clearance 0.01 --verify --page robot.html",
      "Here 2: the referee refutes a recommended answer, or --prove shows contact of links that the SRDF "
      "disables\nas \"Never\". 3 also: an open pair of --prove, shapes that were not examined, pairs near "
      "only "
      "by the bound\naround a box or mesh, joints that were not moved. 65: the file is not a scene.");
  command.run([arguments] { return study(*arguments); });
}

}  // namespace cyl
