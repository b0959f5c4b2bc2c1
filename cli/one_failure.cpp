// SPDX-License-Identifier: MIT
#include "cli/one_failure.hpp"

#include <fmt/format.h>

#include "base/usage_error.hpp"
#include "cli/options.hpp"
#include "cli/targets.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/trial/mechanism.hpp"
#include "oracles/trial/trial.hpp"
#include "reports/export/export.hpp"

namespace cyl {

FindingKind kind_of_word(const std::string& word) {
  if (const auto kind = from_word<FindingKind>(word)) return *kind;
  throw UsageError(fmt::format("'{}' is no kind of finding", word));
}

void add_failure_options(Command& command, FailureOptions& options) {
  command.option("CASE", options.target, "RUN:ID, FILE:LINE, or a FILE of one case").required();
  command.option("--method", options.method, "the method that is wrong")
      .default_text("that of the stored finding");
  command.option("--kind", options.kind, "the kind of failure, like wrong_disjoint")
      .default_text("that of the stored finding; else found by asking");
  add_guest_options(command, options.guests);
  add_run_guests_option(command, options.guests);
}

OneFailure failure_of(const FailureOptions& options, std::span<const std::unique_ptr<Method>> methods) {
  const std::vector<Target> targets = targets_of(options.target);
  if (targets.size() != 1)
    throw UsageError(
        fmt::format("'{}' names {} pairs; give one: FILE:LINE or RUN:ID", options.target, targets.size()));
  const Target& target = targets.front();
  const bool stored = target.finding && (options.method.empty() || options.method == target.finding->method);
  const std::string name = stored ? target.finding->method : options.method;
  if (name.empty()) throw UsageError("which method? Give --method NAME");
  const std::string word = !options.kind.empty() ? options.kind : stored ? target.finding->kind : "";
  if (!word.empty()) return {name, kind_of_word(word), target.pair};
  const Trial now = try_method(find_method(methods, name), target.pair);
  if (!now.finding())
    throw UsageError(fmt::format("{} is not wrong on {}: it says {}, and they are {}", name, target.label,
                                 format_method_answer(now.answer()), distance_in_words(now)));
  return {name, now.finding()->kind, target.pair};
}

void add_source_option(Command& command, std::vector<std::string>& sources) {
  command
      .option("--source", sources,
              "a guest's source, sent with it and named; the first one is what a plug-in is compiled of")
      .one_each()
      .existing_file();
}

void export_failure(const MethodSet& set, const OneFailure& failure, const std::vector<std::string>& sources,
                    const std::string& folder) {
  const Export files = make_export(set.methods, failure.method, failure.kind, failure.pair, set.guests,
                                   {sources, failure.worst});
  write_export(files, folder);
  std::string more;
  for (const SentFile& sent : files.files) more += ", " + sent.name;
  fmt::print("{}, {}: {}/issue.md, build.sh, {}, exact.py{}\n", failure.method, to_string(failure.kind),
             folder, files.program_name, more);
}

}  // namespace cyl
