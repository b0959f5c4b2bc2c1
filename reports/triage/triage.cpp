// SPDX-License-Identifier: MIT
#include "reports/triage/triage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/exit_code.hpp"
#include "base/files.hpp"
#include "base/safe_text.hpp"
#include "base/usage_error.hpp"
#include "corpus/pairs/pair_json.hpp"
#include "corpus/store/run_facts.hpp"
#include "reports/triage/changed_guests.hpp"
#include "reports/triage/group_findings.hpp"
#include "reports/triage/shown_pair.hpp"
#include "reports/triage/triage_context.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Parts of the budget after which each step ends: the classification, the questions about pairs of earlier
/// runs, then the simplification. The rest is for questions about the shown pairs.
constexpr double classify_part = 0.35, again_part = 0.4, simplify_part = 0.6;

TriagedRun read_triaged(const std::string& folder) {
  const RunStore store = RunStore::open(folder);
  TriagedRun run{folder,
                 fs::canonical(folder).filename().string(),
                 value_of(store.config(), "started"),
                 store.methods(),
                 store.tallies(),
                 {},
                 stored_part(folder)};
  for (const Json& stored : causes_json(folder)) run.causes.push_back(cause_from_json(stored));
  return run;
}

/// Returns the runs that `against` names: a run, or a folder of runs. Throws UsageError if there is none, or
/// if a named run was not triaged.
std::vector<std::string> named_runs(const std::vector<std::string>& against) {
  std::vector<std::string> runs;
  for (const std::string& folder : against) {
    const bool is_run = fs::exists(fs::path(folder) / "run.sqlite");
    const std::vector<std::string> held = is_run ? std::vector{folder} : runs_in(folder);
    if (held.empty()) throw UsageError("--against: " + folder + " holds no run");
    if (is_run && stored_summary(folder).empty())
      throw UsageError("--against: " + folder + " is not triaged yet: `daylight triage " + folder +
                       "` does it");
    runs.insert(runs.end(), held.begin(), held.end());
  }
  return runs;
}

/// Returns the triaged runs to which the run is compared, the earliest first.
std::vector<TriagedRun> earlier_runs(const TriageContext& context) {
  const std::vector<std::string>& against = context.options.against;
  std::vector<std::pair<std::string, std::string>> runs;  // when it began, folder
  const fs::path here = fs::canonical(context.options.folder);
  for (const std::string& folder :
       against.empty() ? runs_in(here.parent_path().string()) : named_runs(against)) {
    if (fs::canonical(folder) == here || stored_summary(folder).empty()) continue;
    const std::string began = value_of(RunStore::open(folder).config(), "started");
    if (!against.empty() || std::pair(began, folder) < std::pair(context.began, here.string()))
      runs.emplace_back(began, folder);
  }
  std::sort(runs.begin(), runs.end());
  std::vector<TriagedRun> earlier;
  for (const auto& [began, folder] : runs) earlier.push_back(read_triaged(folder));
  return earlier;
}

/// Asks a method of the cause about its stored pair. Returns nothing if the fault is not deterministic, or
/// if the method is not here.
std::optional<bool> fails_today(const Cause& cause, std::span<const std::unique_ptr<Method>> methods) {
  if (cause.kind == FindingKind::nondeterminism || cause.kind == FindingKind::state_dependent) return {};
  const auto method = position_of(methods, cause.method);
  if (!method || !cause.seen_again) return {};
  return fails_alone(methods, {*method, cause.kind}, cause.simplest.pair);
}

/// Writes FOLDER/causes/: the simplest pair of each cause, each in a file.
void write_pairs(const std::string& run_folder, const std::vector<Cause>& causes) {
  const fs::path folder = fs::path(run_folder) / "causes";
  if (fs::is_symlink(fs::symlink_status(folder)))
    throw std::runtime_error(folder.string() + " is a symbolic link; a run holds its own files");
  fs::create_directories(folder);
  for (const Cause& b : causes) {
    if (b.status == Recurrence::gone) continue;
    Json line = pair_json(b.simplest.pair);
    line["id"] = b.key;
    line["note"] = b.description;
    replace_file(folder / (file_name_of(b.key) + ".jsonl"), line.dump() + '\n');
  }
}

}  // namespace

Triage run_triage(const TriageOptions& options, std::span<const std::unique_ptr<Method>> methods,
                  const std::function<void(const TriageProgress&)>& on_progress) {
  TriageContext context(options, methods, on_progress);
  const std::vector<TriagedRun> earlier = earlier_runs(context);
  std::set<std::string> known;
  for (const TriagedRun& past : earlier)
    for (const Cause& b : past.causes) known.insert(b.key);
  classify_findings(context, classify_part);
  const std::vector<ChangedGuest> changed = ask_earlier_pairs(context, earlier, again_part);
  simplify_findings(context, known, simplify_part);
  Triage triage;
  triage.progress = context.progress();
  TriagedRun run = read_triaged(options.folder);
  std::erase_if(run.methods, [&](const MethodRecord& m) {
    return std::find(context.asked.begin(), context.asked.end(), m.name) == context.asked.end();
  });
  const std::size_t here = triage.progress.findings - triage.progress.absent;
  const double part =
      here == 0 ? 1 : static_cast<double>(triage.progress.classified) / static_cast<double>(here);
  const auto out_of_time = [&, shown = triage.progress]() mutable {
    shown.elapsed = context.elapsed();
    if (on_progress) on_progress(shown);
    return context.out_of_time();
  };
  run.causes = make_causes(
      {options.folder, context.findings, context.finding_groups, context.causes(), context.simples()},
      context.grouped(), run.causes, out_of_time);
  std::set<std::string> certainly_new;
  for (const ChangedGuest& guest : changed) {
    for (const auto& [key, fault] : guest.newly_wrong) {
      certainly_new.insert(key);
      if (std::ranges::find(run.causes, key, &Cause::key) == run.causes.end())
        run.causes.push_back(make_cause(key, fault, context.grouped(), options.folder, out_of_time));
    }
    if (const std::string remark = in_words(guest); !remark.empty()) triage.remarks.push_back(remark);
  }
  compare_with_earlier(
      run, earlier,
      [&](const Cause& b) { return context.out_of_time() ? std::nullopt : fails_today(b, methods); },
      certainly_new);
  triage.causes = std::move(run.causes);
  write_pairs(options.folder, triage.causes);
  context.store().set_summary(to_json(triage.causes).dump(), part);
  if (!earlier.empty())
    triage.remarks.push_back(fmt::format("compared with {}, the last of them {} of {}",
                                         counted(earlier.size(), "run"), earlier.back().id,
                                         earlier.back().started));
  for (const TriagedRun& past : earlier) {
    if (past.started > context.began)
      triage.remarks.push_back(
          fmt::format("{} began after this run: a new cause may be one that was mended in between", past.id));
    if (past.part < 1)
      triage.remarks.push_back(fmt::format("{} was looked at to {:.0f} %: of the rest nothing is compared",
                                           past.id, std::floor(100 * past.part)));
  }
  triage.findings = std::move(context.findings);
  return triage;
}

Json causes_json(const std::string& run_folder) {
  const std::string text = stored_summary(run_folder);
  return text.empty() ? Json::array() : parse_foreign_json(text);
}

int exit_code(const Triage& triage) {
  bool undecided = triage.progress.classified < triage.progress.findings;
  for (const Cause& b : triage.causes) {
    if (b.status == Recurrence::gone) continue;
    if (b.severity == Severity::contract) return exit_findings;
    undecided |= b.severity == Severity::unresolved;
  }
  return undecided ? exit_undecided : exit_pass;
}

}  // namespace cyl
