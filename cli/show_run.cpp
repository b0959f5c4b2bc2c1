// SPDX-License-Identifier: MIT
#include "cli/show_run.hpp"

#include <fmt/format.h>

#include <system_error>

#include "base/own_command.hpp"
#include "base/safe_text.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "reports/run/charts.hpp"
#include "reports/run/report_data.hpp"
#include "reports/run/run_summary.hpp"
#include "reports/run/shape_table.hpp"
#include "reports/run/tally_table.hpp"

namespace cyl {

namespace fs = std::filesystem;

void point_latest_at(const fs::path& run) {
  const fs::path folder = fs::absolute(run).parent_path(), link = folder / "latest",
                 unfinished = folder / ".latest";
  if (folder.filename() != "runs" || (fs::exists(fs::symlink_status(link)) && !fs::is_symlink(link))) return;
  std::error_code error;  // a file system without symbolic links gets none
  fs::remove(unfinished, error);
  fs::create_directory_symlink(run.filename(), unfinished, error);
  if (!error) fs::rename(unfinished, link, error);
}

void show_run(const std::string& folder, bool table) {
  RunData run = read_run(folder);
  write_charts(run, {});
  write_page(run);
  if (table) fmt::print("{}{}", format_tallies(tally_methods(run.tallies)), format_shapes(run));
  fmt::print("{}", format_summary(run));
  if (!run.findings.empty()) {
    const std::size_t first = worst_first(run).front();
    const FindingRecord* const worst = &run.findings[first];
    const std::optional<Case>& line = run.pairs[first].line;
    const bool ordinary = line && is_ordinary(line->pair);
    fmt::print("worst finding{}: {} {} ({}): {} replay {}\n", ordinary ? " at ordinary sizes" : "",
               worst->method, to_string(worst->kind), in_words(worst->severity), own_command(),
               shell_quoted(fmt::format("{}:{}", folder, worst->id)));
    fmt::print("causes: {} triage {}\n", own_command(), shell_quoted(folder));
  }
  fmt::print("page: {}/report.html\n", folder);
}

}  // namespace cyl
