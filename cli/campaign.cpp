// SPDX-License-Identifier: MIT
#include "cli/campaign.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <cerrno>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <random>
#include <sstream>
#include <stdexcept>

#include "base/exit_code.hpp"
#include "base/number_text.hpp"
#include "base/own_command.hpp"
#include "base/safe_text.hpp"
#include "base/source_tree.hpp"
#include "base/times.hpp"
#include "base/usage_error.hpp"
#include "cli/build_info.hpp"
#include "cli/commands.hpp"
#include "cli/families.hpp"
#include "cli/fuzz.hpp"
#include "cli/known_guests.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "cli/show_run.hpp"
#include "cli/targets.hpp"
#include "fuzz/guided/mutator.hpp"
#include "fuzz/guided/record.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// The wall time of a run without a limit of its own.
constexpr std::chrono::minutes default_budget{1};

/// Holds the data that Workload refers to.
struct Selection {
  std::vector<std::unique_ptr<Method>> methods;
  std::vector<Family> families;
  std::vector<Case> cases;
  std::vector<Pair> corpus;
  Workload workload() const { return {methods, families, cases, corpus, mutate}; }
};

void print_list(const GuestOptions& guests) {
  fmt::print("methods:\n");
  for (const auto& method : with_guests(guests).methods) {
    const Claim claim = method->claim();
    fmt::print("  {:<26} {}; {} to be always right if the gap or overlap exceeds {} size + {} ({})\n",
               method->name(), method->version(), claim.assumed ? "assumed" : "claims",
               format_double(claim.relative), format_double(claim.absolute), claim.source);
  }
  fmt::print("families:\n");
  for (const Family& family : campaign_families()) fmt::print("  {:<26} {}\n", family.name, family.summary);
}

/// Reads "i/n" with i from 0 to n - 1. Throws UsageError if the text has another form.
void set_shard(const std::string& text, CampaignOptions& options) {
  const std::size_t slash = std::min(text.find('/'), text.size() - 1);
  const auto index = number_in<std::uint64_t>(text.substr(0, slash)),
             count = number_in<std::uint64_t>(text.substr(slash + 1));
  if (!index || !count || *index >= *count)
    throw UsageError("--shard: '" + text + "' is not i/n with i from 0 to n - 1");
  options.shard = *index;
  options.shards = *count;
}

/// Returns whether a campaign draws such solids: those that a method supports. If there are guests, one of
/// them has to support these, or cylinders.
bool is_drawn(const Pair& pair, const std::vector<std::unique_ptr<Method>>& methods) {
  const auto supports = [&](const auto& m) { return m->supports_kinds(pair); };
  const auto guest = [](const auto& m) { return m->guest(); };
  const auto asks = [&](const auto& m) {
    return guest(m) && (supports(m) || m->supports(SolidKind::cylinder));
  };
  return std::ranges::any_of(methods, supports) &&
         (std::ranges::none_of(methods, guest) || std::ranges::any_of(methods, asks));
}

void print_not_asked(const std::vector<std::unique_ptr<Method>>& methods) {
  for (const auto& method : methods) {
    if (!method->guest()) continue;
    std::string kinds;
    for (const SolidKind kind : enum_values<SolidKind>)
      if (!method->supports(kind)) kinds.append(kinds.empty() ? "" : ", ").append(to_string(kind));
    if (!kinds.empty()) fmt::print("unsupported by {}, so not asked: {}\n", method->name(), kinds);
  }
}

/// Plans a new run from the command line.
CampaignOptions plan_new(const CampaignArguments& arguments, Selection& selection) {
  CampaignOptions options;
  options.seed = arguments.seed ? *arguments.seed : std::random_device()();
  options.out = arguments.out;
  if (options.out.empty()) {
    options.out = fmt::format("runs/{:%Y%m%d-%H%M%S}-{}", fmt::localtime(std::time(nullptr)), options.seed);
  }
  options.cases = arguments.cases ? *arguments.cases : in_source_tree("corpus/cases");
  // The path is absolute, because the run may be resumed from another folder.
  if (!options.cases.empty()) options.cases = fs::absolute(options.cases).lexically_normal().string();
  MethodSet set = with_guests(arguments.guests, arguments.methods, true);
  options.guests = format_guests(set.guests);
  selection.methods = std::move(set.methods);
  if (!arguments.methods.empty())
    selection.methods = select_methods(std::move(selection.methods), arguments.methods);
  if (!arguments.corpus_only)
    selection.families = families_named(arguments.families,
                                        [&](const Pair& pair) { return is_drawn(pair, selection.methods); });
  if (!arguments.shard.empty()) set_shard(arguments.shard, options);
  return options;
}

/// Moves the elements that `named` names out of `all`, in that order. name_of() returns the name of one.
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

/// Returns every method and the run's guests. A guest that the command line gives replaces that of the run.
MethodSet methods_of_run(const CampaignArguments& arguments, const std::vector<std::string>& asked) {
  MethodSet set = with_guests(arguments.guests);
  for (const Guest& guest : set.guests) {
    if (std::ranges::count(asked, guest.name) == 0)
      throw UsageError(arguments.resume + " has not asked " + guest.name +
                       ": a resumed run keeps its methods");
  }
  std::string missing;
  add_guests_of_run(set, arguments.resume, arguments.guests, missing);
  if (!missing.empty()) throw std::runtime_error(arguments.resume + " cannot be resumed: " + missing);
  return set;
}

/// Plans to continue a run from its store. Limits on the command line replace those of the store.
CampaignOptions plan_resumed(const CampaignArguments& arguments, Selection& selection) {
  const RunStore store = RunStore::open(arguments.resume);
  const Config config = store.config();
  CampaignOptions options;
  options.resume = true;
  options.out = lasting_name(arguments.resume);
  options.seed = number_of(config, "seed");
  options.cases = text_of(config, "cases");
  std::vector<std::string> method_names, family_names;
  for (const MethodRecord& method : store.methods()) method_names.push_back(method.name);
  std::istringstream lines(text_of(config, "families"));
  for (std::string name; std::getline(lines, name);) family_names.push_back(name);
  MethodSet set = methods_of_run(arguments, method_names);
  options.guests = format_guests(set.guests);
  selection.methods = pick(
      std::move(set.methods), method_names, [](const auto& m) { return m->name(); }, arguments.resume);
  selection.families = pick(
      std::vector<Family>(campaign_families().begin(), campaign_families().end()), family_names,
      [](const Family& f) { return f.name; }, arguments.resume);
  const Shard shard = shard_of(config);
  options.shard = shard.index;
  options.shards = shard.count;
  options.pairs = number_of(config, "pairs");
  const std::chrono::milliseconds budget(number_of(config, "budget_milliseconds"));
  const std::chrono::milliseconds spent(store.progress().milliseconds);
  if (budget.count() != 0) options.budget = budget > spent ? budget - spent : spent_budget;
  return options;
}

double share_done(const CampaignOptions& options, const CampaignProgress& p) {
  double share = 0;
  if (p.goal != 0) share = static_cast<double>(p.done) / static_cast<double>(p.goal);
  if (options.budget.count() != 0) {
    share = std::max(
        share, static_cast<double>(p.session_time.count()) / static_cast<double>(options.budget.count()));
  }
  return share;
}

std::string numbers(const CampaignProgress& p) {
  const double seconds = std::max(1e-3, static_cast<double>(p.session_time.count()) / 1000);
  if (p.session_done == 0) return fmt::format("{:.0f} s, the first batch of pairs is under way", seconds);
  return fmt::format("{:.0f} s, {} pairs, {:.0f}/s; beyond claim {}, failed {}, within claim {}", seconds,
                     p.done, static_cast<double>(p.session_done) / seconds, p.contract, p.failed,
                     p.resolution);
}

// The parts are times by the clock in all jobs together: a call that waits for its processor counts too.
std::string cost_in_words(const CampaignCost& cost) {
  const auto seconds = [](std::chrono::nanoseconds time) { return static_cast<double>(time.count()) / 1e9; };
  std::string text = fmt::format("CPU time: {:.1f} s\nby the clock, in all jobs: methods {:.1f} s",
                                 seconds(cost.all), seconds(cost.asking));
  if (cost.hung.count() > 0) text += fmt::format(", hanging calls {:.1f} s", seconds(cost.hung));
  return text + fmt::format(", referee {:.1f} s", seconds(cost.judging));
}

/// Each limit on the command line replaces that limit of the run.
void set_limits(const CampaignArguments& arguments, CampaignOptions& options) {
  if (arguments.pairs) options.pairs = *arguments.pairs;
  if (!arguments.budget.empty()) options.budget = parse_duration(arguments.budget);
  if (options.pairs == 0 && options.budget.count() == 0) options.budget = default_budget;
  if (options.budget == spent_budget) fmt::print(stderr, "no time is left: extend it with --for\n");
}

/// Keeps others from writing to the run while this process lives. Throws UsageError if one writes to it.
void hold(const std::string& run) {
  const int folder = open(run.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);  // closed with the process
  for (int tries = 0; folder >= 0 && flock(folder, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK; ++tries) {
    if (tries == 20) throw UsageError(run + " is written by another process");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // a killed process may still be ending
  }
}

/// Makes a new run whose pairs come from a corpus, which a fuzzer may still have to find, and plans to resume
/// it.
void begin_with_corpus(const CampaignArguments& arguments, CampaignOptions& options,
                       const Selection& selection) {
  std::string from = arguments.corpus;
  const fs::path latest = fs::absolute(options.out).parent_path() / "latest" / "corpus";
  if (from.empty() && fs::is_directory(latest)) from = latest;
  if (holds_run(options.out)) throw UsageError(options.out + " already holds a run");
  if (!from.empty() && (options.fuzz.count() == 0 || fs::is_directory(from))) begin_corpus(options.out, from);
  options.create_only = true;
  run_campaign(options, selection.workload());
  options.resume = true;
  options.create_only = arguments.create_only;
  point_latest_at(options.out);
  hold(options.out);
}

/// Returns false if a signal stopped the fuzzer.
bool take_corpus(CampaignOptions& options, Selection& selection) {
  if (!options.resume) return true;
  if (!fuzz_before_campaign(options)) return false;
  if (fs::is_directory(options.out + "/corpus"))
    for (const Pair& pair : read_corpus(options.out + "/corpus"))
      if (is_drawn(pair, selection.methods)) selection.corpus.push_back(pair);
  if (!selection.families.empty()) return true;
  if (selection.corpus.empty()) throw std::runtime_error("the corpus has no pair that a guest supports");
  options.pairs = selection.corpus.size();
  return true;
}

void print_stopped(const CampaignOptions& options) {
  fmt::print(stderr, "stopped, resume with: {} campaign --resume {}\n", own_command(),
             shell_quoted(options.out));
}

}  // namespace

int campaign(const CampaignArguments& arguments) {
  if (arguments.list) {
    print_list(arguments.guests);
    return exit_pass;
  }
  Selection selection;
  CampaignOptions options =
      arguments.resume.empty() ? plan_new(arguments, selection) : plan_resumed(arguments, selection);
  if (options.resume) hold(options.out);
  set_limits(arguments, options);
  selection.cases =
      cases_in(options.cases, [&](const Pair& pair) { return is_drawn(pair, selection.methods); });
  if (!options.resume) plan_fuzzing(arguments, options);
  fmt::print("seed {}, run {}\n", options.seed, options.out);
  std::fflush(stdout);
  if (const std::string error = record_guests(parse_guests(options.guests)); !error.empty())
    fmt::print(stderr,
               "daylight: the guests of this run are not recorded: {}. Commands that read the run need "
               "--run-guests.\n",
               error);

  options.jobs = arguments.jobs;
  options.build = build_info().text();
  options.create_only = arguments.create_only;
  if (!options.resume && (!arguments.corpus.empty() || options.fuzz.count() > 0)) {
    begin_with_corpus(arguments, options, selection);
    if (options.create_only) return exit_pass;
  }
  if (!take_corpus(options, selection)) {
    print_stopped(options);
    return exit_undecided;
  }

  CampaignSummary summary;
  {
    ProgressLine line;
    bool linked = false;
    const auto require_run = [&] {
      if (!holds_run(options.out))
        throw std::runtime_error(options.out + " was removed while it was written");
    };
    try {
      summary = run_campaign(options, selection.workload(), [&](const CampaignProgress& progress) {
        require_run();
        if (!linked) {
          point_latest_at(options.out);
          if (!options.resume) hold(options.out);
        }
        linked = true;
        if (line.due()) line.show(share_done(options, progress), numbers(progress));
      });
    } catch (const std::runtime_error&) {
      if (linked) require_run();  // its file may be gone between two looks
      throw;
    }
  }
  if (options.create_only) return exit_pass;
  show_run(options.out, arguments.table);
  print_not_asked(selection.methods);
  fmt::print("{}\n", cost_in_words(summary.cost));
  if (!summary.harness_failure.empty()) fmt::print(stderr, "daylight: {}\n", summary.harness_failure);
  if (summary.interrupted) print_stopped(options);
  return exit_code(summary);
}

void add_campaign(Program& program) {
  Command command = program.command("Find", "campaign",
                                    "Draws pairs, asks every method, and proves which methods are wrong");
  auto arguments = std::make_shared<CampaignArguments>();
  auto share = std::make_shared<std::string>();
  command.section("Limits");
  command.option("--for DURATION", arguments->budget, "wall time, such as 90s, 1m or 8h")
      .default_text("1m if there is no other limit");
  command.number("--pairs N", arguments->pairs, "number of pairs; 0 for no limit");
  command.option(
      "--fuzz SHARE", *share,
      "share of the time for libFuzzer, such as 25%; afterwards its pairs take turns with drawn ones");
  command.number("--jobs N", arguments->jobs, "parallel batches; the findings do not depend on it", 1, 1024);
  command.section("Output");
  command.option("--out DIR", arguments->out, "run folder").default_text("runs/<date-time>-<seed>");
  command.option("--resume DIR", arguments->resume, "continue the run in this folder")
      .not_empty("the folder of a run is expected");
  command.flag("--create-only", arguments->create_only, "only create the run folder, for --resume");
  command.flag("--table", arguments->table, "also print the counts of each method");
  command.flag("--list", arguments->list, "only list the methods with their claims, and the families");
  command.section("Pairs");
  command.number("--seed N", arguments->seed, "seed; the same seed gives the same findings")
      .default_text("random");
  command
      .option("--families LIST", arguments->families,
              "families: names or prefixes, separated by commas; a '-' before the list excludes")
      .default_text("all");
  command
      .option("--shard I/N", arguments->shard,
              "run only part I of N, with I from 0 to N-1; daylight merge joins the parts")
      .needs("--seed")
      .needs("--out");
  command.option("--cases DIR", arguments->cases, "folder of known cases to run first; '' for none")
      .default_text("corpus/cases/");
  command.option("--corpus DIR", arguments->corpus,
                 "corpus of a fuzz run; its pairs alternate with drawn ones, and --fuzz starts from it");
  command.section("Methods");
  add_methods_option(command, arguments->methods);
  add_guest_options(command, arguments->guests);
  add_run_guests_option(command, arguments->guests, "with --resume, ");
  command.examples(
      "  daylight campaign --for 1m --methods=-nlopt\n"
      "  daylight campaign --plugin ./libmine.so --methods mine,decide --pairs 100000",
      "Ctrl-C ends a campaign and keeps all complete batches. Exit code 3 of campaign can also mean that\n"
      "the run stopped before its limit.");
  command.run([arguments, share, command] {
    for (const char* fixed : {"--seed", "--out", "--methods", "--families", "--shard", "--cases", "--corpus",
                              "--create-only", "--fuzz"}) {
      if (arguments->resume.empty() || !command.given(fixed)) continue;
      throw UsageError(
          std::string(fixed) +
          " cannot be given with --resume, because a resumed run keeps its settings. Only limits and --jobs "
          "may change");
    }
    if (!share->empty()) arguments->fuzz = parse_share(*share);
    return campaign(*arguments);
  });
}

}  // namespace cyl
