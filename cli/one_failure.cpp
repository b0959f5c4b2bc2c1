// SPDX-License-Identifier: MIT
#include "cli/one_failure.hpp"

#include <fmt/format.h>

#include "base/usage_error.hpp"
#include "oracles/trial/mechanism.hpp"
#include "reports/export/export.hpp"

namespace cyl {

FindingKind kind_of_word(const std::string& word) {
  if (const auto kind = from_word<FindingKind>(word)) return *kind;
  throw UsageError(fmt::format("'{}' is no kind of finding", word));
}

void export_failure(const Company& company, const OneFailure& failure, const std::string& folder) {
  const Export files =
      make_export(company.methods, failure.method, failure.kind, failure.pair, company.guests);
  write_export(files, folder);
  fmt::print("{}, {}: {}/issue.md, build.sh, {}, exact.py\n", failure.method, to_string(failure.kind), folder,
             files.program_name);
}

}  // namespace cyl
