// SPDX-License-Identifier: MIT
#include "cli/show_run.hpp"

#include <fmt/format.h>

#include <optional>
#include <system_error>
#include <tuple>

#include "base/own_command.hpp"
#include "base/safe_text.hpp"
#include "base/source_tree.hpp"
#include "corpus/store/run_store.hpp"
#include "fuzz/campaign/self_check.hpp"
#include "reports/run/charts.hpp"
#include "reports/run/history.hpp"
#include "reports/run/page.hpp"
#include "reports/run/tally_table.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

void point_latest_at(const fs::path& run) {
  const fs::path folder = fs::absolute(run).parent_path(), link = folder / "latest",
                 unfinished = folder / ".latest";
  if (folder.filename() != "runs" || (fs::exists(fs::symlink_status(link)) && !fs::is_symlink(link))) return;
  std::error_code error;  // a file system without symbolic links does without
  fs::remove(unfinished, error);
  fs::create_directory_symlink(run.filename(), unfinished, error);
  if (!error) fs::rename(unfinished, link, error);
}

void show_run(const std::string& folder, std::uint64_t pairs) {
  write_charts(folder, {});
  write_page(folder, in_source_tree("props/mutants/kill_matrix.jsonl"));
  const RunStore store = RunStore::open(folder);
  fmt::print("{}", format_tallies(tally_methods(store)));
  if (const History history = compare_with_earlier(folder); history.runs + history.unreadable > 0)
    fmt::print("{}\n", format_history(history));
  if (const std::string alarms = format_alarms(store.alarms()); !alarms.empty()) fmt::print("{}\n", alarms);
  fmt::print("{} pairs; page: {}/report.html\n", pairs, folder);
  if (const auto worst = worst_finding(store)) {
    fmt::print("the worst, {} {} ({}): {} replay {}\n", worst->method, worst->kind, worst->severity,
               own_command(), shell_quoted(fmt::format("{}:{}", folder, worst->id)));
  }
}

}  // namespace cyl
