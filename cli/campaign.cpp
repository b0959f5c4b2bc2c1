// SPDX-License-Identifier: MIT
#include "fuzz/campaign.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "cli/build_info.hpp"
#include "cli/commands.hpp"
#include "cli/default_cases.hpp"
#include "cli/duration.hpp"
#include "cli/progress.hpp"
#include "cli/unsigned_option.hpp"
#include "corpus/case_files.hpp"
#include "corpus/shell_words.hpp"
#include "reports/page.hpp"
#include "reports/tally_table.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// Where a run is given no limit of its own.
constexpr std::chrono::minutes default_budget{1};

struct Arguments {
  std::string budget, out, methods, families, resume;
  std::optional<std::string> cases;
  std::uint64_t pairs = 0;
  std::optional<std::uint64_t> seed;
  unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
  bool list = false;
};

/// What Subjects refers to.
struct Asked {
  std::vector<std::unique_ptr<Method>> methods;
  std::vector<Family> families;
  std::vector<Case> cases;
  Subjects subjects() const { return {methods, families, cases}; }
};

std::vector<Family> select_families(std::string_view spec) {
  std::vector<std::string> names;
  for (const Family& family : families()) names.emplace_back(family.name);
  std::vector<Family> kept;
  for (const std::size_t i : select_names(names, spec)) kept.push_back(families()[i]);
  return kept;
}

void print_list() {
  fmt::print("methods:\n");
  for (const auto& method : all_methods()) {
    const Claim claim = method->claim();
    fmt::print("  {:<26} {}; right from {} size + {} on ({})\n", method->name(), method->version(),
               format_double(claim.relative), format_double(claim.absolute), claim.source);
  }
  fmt::print("families:\n");
  for (const Family& family : families()) fmt::print("  {:<26} {}\n", family.name, family.summary);
}

/// A new run: everything from the command line.
CampaignOptions plan_new(const Arguments& arguments, Asked& asked) {
  CampaignOptions options;
  options.seed = arguments.seed ? *arguments.seed : std::random_device()();
  options.out = arguments.out;
  if (options.out.empty()) {
    options.out = fmt::format("runs/{:%Y%m%d-%H%M%S}-{}", fmt::localtime(std::time(nullptr)), options.seed);
  }
  options.cases = arguments.cases ? *arguments.cases : default_cases();
  // Absolute: who resumes the run may stand elsewhere.
  if (!options.cases.empty()) options.cases = fs::absolute(options.cases).lexically_normal().string();
  asked.methods = all_methods();
  if (!arguments.methods.empty()) asked.methods = select_methods(std::move(asked.methods), arguments.methods);
  asked.families.assign(families().begin(), families().end());
  if (!arguments.families.empty()) asked.families = select_families(arguments.families);
  return options;
}

/// Moves what `named` names, in that order, out of `all`; name_of tells the name of one.
template <class T, class NameOf>
std::vector<T> pick(std::vector<T> all, const std::vector<std::string>& named, NameOf name_of,
                    const std::string& run) {
  std::vector<T> kept;
  for (const std::string& name : named) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const T& x) { return name_of(x) == name; });
    if (found == all.end()) throw std::runtime_error(run + " cannot be resumed: this build has no " + name);
    kept.push_back(std::move(*found));
    all.erase(found);
  }
  return kept;
}

/// A run to go on with: everything from its store but the limits, where the command line has some.
CampaignOptions plan_resumed(const Arguments& arguments, Asked& asked) {
  const RunStore store = RunStore::open(arguments.resume);
  const Config config = store.config();
  CampaignOptions options;
  options.resume = true;
  const fs::path run = arguments.resume;  // where it is runs/latest, findings are named by what that is now
  options.out = fs::is_symlink(run) ? run.parent_path() / fs::read_symlink(run) : run;
  options.seed = std::stoull(config.at("seed"));
  options.cases = config.at("cases");
  std::vector<std::string> method_names, family_names;
  for (const MethodRecord& method : store.methods()) method_names.push_back(method.name);
  std::istringstream lines(config.at("families"));
  for (std::string name; std::getline(lines, name);) family_names.push_back(name);
  asked.methods = pick(
      all_methods(), method_names, [](const auto& m) { return m->name(); }, arguments.resume);
  asked.families = pick(
      std::vector<Family>(families().begin(), families().end()), family_names,
      [](const Family& f) { return f.name; }, arguments.resume);
  if (arguments.pairs == 0 && arguments.budget.empty()) {
    options.pairs = std::stoull(config.at("pairs"));
    const std::chrono::milliseconds budget(std::stoll(config.at("budget_milliseconds")));
    const std::chrono::milliseconds spent(store.progress().milliseconds);
    if (budget.count() != 0) options.budget = std::max(budget - spent, std::chrono::milliseconds(1));
  }
  return options;
}

/// runs/latest is the run that began last.
void point_latest_at(const fs::path& run) {
  const fs::path folder = fs::absolute(run).parent_path(), link = folder / "latest",
                 unfinished = folder / ".latest";
  if (folder.filename() != "runs" || (fs::exists(fs::symlink_status(link)) && !fs::is_symlink(link))) return;
  std::error_code error;  // a file system without symbolic links does without
  fs::remove(unfinished, error);
  fs::create_directory_symlink(run.filename(), unfinished, error);
  if (!error) fs::rename(unfinished, link, error);
}

/// The finding to look at first: beyond a claim before within, a wrong verdict before anything else, then by
/// margin.
std::optional<FindingRecord> worst_finding(const RunStore& store) {
  std::optional<FindingRecord> worst;
  const auto key = [](const FindingRecord& f) {
    return std::tuple(f.severity == "contract", f.severity == "resolution", f.kind.starts_with("wrong_"),
                      f.margin ? f.margin->lo : 0.0);
  };
  for (FindingRecord& f : store.findings()) {
    if (!worst || key(f) > key(*worst)) worst = std::move(f);
  }
  return worst;
}

double share_done(const CampaignOptions& options, const CampaignProgress& p) {
  double share = 0;
  if (options.pairs != 0) share = static_cast<double>(p.done) / static_cast<double>(options.pairs);
  if (options.budget.count() != 0) {
    share = std::max(
        share, static_cast<double>(p.session_time.count()) / static_cast<double>(options.budget.count()));
  }
  return share;
}

std::string numbers(const CampaignProgress& p) {
  const double seconds = std::max(1e-3, static_cast<double>(p.session_time.count()) / 1000);
  return fmt::format("{} pairs, {:.0f}/s; contract {}, failed {}, within claim {}", p.done,
                     static_cast<double>(p.session_done) / seconds, p.contract, p.failed, p.resolution);
}

int campaign(const Arguments& arguments) {
  if (arguments.list) {
    print_list();
    return exit_pass;
  }
  Asked asked;
  CampaignOptions options =
      arguments.resume.empty() ? plan_new(arguments, asked) : plan_resumed(arguments, asked);
  fmt::print("seed {}, run {}\n", options.seed, options.out);
  std::fflush(stdout);

  if (arguments.pairs != 0) options.pairs = arguments.pairs;
  if (!arguments.budget.empty()) options.budget = parse_duration(arguments.budget);
  if (options.pairs == 0 && options.budget.count() == 0) options.budget = default_budget;
  options.jobs = arguments.jobs;
  options.build = build_info().text();
  if (!options.cases.empty()) asked.cases = read_case_folder(options.cases);

  CampaignSummary summary;
  {
    ProgressLine line;
    bool linked = false;
    summary = run_campaign(options, asked.subjects(), [&](const CampaignProgress& progress) {
      if (!linked) point_latest_at(options.out);
      linked = true;
      if (line.due(progress.session_time))
        line.show(progress.session_time, share_done(options, progress), numbers(progress));
    });
  }
  write_page(options.out);
  const RunStore store = RunStore::open(options.out);
  fmt::print("{}", format_tallies(tally_methods(store)));
  fmt::print("{} pairs; page: {}/report.html\n", summary.progress.done, options.out);
  if (const auto worst = worst_finding(store)) {
    fmt::print("the worst, {} {} ({}): ./daylight replay {}\n", worst->method, worst->kind, worst->severity,
               shell_quoted(fmt::format("{}:{}", options.out, worst->id)));
  }
  if (!summary.harness_failure.empty()) fmt::print(stderr, "daylight: {}\n", summary.harness_failure);
  if (summary.interrupted)
    fmt::print(stderr, "stopped; go on with: ./daylight campaign --resume {}\n", shell_quoted(options.out));
  return exit_code(summary);
}

}  // namespace

void add_campaign(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "campaign", "Draws pairs, asks every method, proves who is wrong, and keeps the proofs");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("--for", arguments->budget,
                      "wall time, like 90s, 1m or 8h; 1m where no limit is given");
  add_unsigned(*command, "--pairs", arguments->pairs, "exactly this many pairs; 0: no such limit");
  auto* seed =
      add_unsigned(*command, "--seed", arguments->seed, "same seed, same findings; random where not given");
  auto* out =
      command->add_option("--out", arguments->out, "run folder; runs/<date-time>-<seed> where not given");
  auto* methods = command->add_option(
      "--methods", arguments->methods,
      "a,b: these; --methods=-a,b: all but these; a name stands for all that begin with it");
  auto* families = command->add_option("--families", arguments->families, "same rule");
  auto* cases = command->add_option(
      "--cases", arguments->cases, "folder of case files played first; corpus/ where not given; '' for none");
  add_unsigned(*command, "--jobs", arguments->jobs, "batches at once; does not change the findings", 1, 1024);
  auto* resume = command->add_option("--resume", arguments->resume, "go on with the run in this folder");
  for (CLI::Option* fixed : {seed, out, methods, families, cases}) resume->excludes(fixed);
  resume->check([](const std::string& run) { return run.empty() ? "the folder of a run is expected" : ""; });
  command->add_flag("--list", arguments->list, "only list the methods, with their claims, and the families");
  command->footer(
      "Example:\n  daylight campaign --for 1m --methods=-nlopt\n"
      "Exit code: 0 nothing beyond a method's claim, 2 contract findings or failures, 3 none of those, but\n"
      "undecided truth or stopped before its limit, 1 the harness failed, 64 usage. Ctrl-C keeps what is "
      "complete.");
  command->callback([arguments, &exit_code] { exit_code = campaign(*arguments); });
}

}  // namespace cyl
