// SPDX-License-Identifier: MIT
#include "cli/targets.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "base/number_text.hpp"
#include "base/safe_text.hpp"
#include "base/usage_error.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/run_facts.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

Target of_finding(const std::string& run, FindingRecord finding) {
  const CaseLine line = parse_case(finding.pair, 1);
  const std::string label = fmt::format("{}:{}", run, finding.id);
  if (!line.value) throw InputError(label + ": " + line.error);
  const auto stated = proved_verdict(finding);
  return {label, line.value->pair, std::move(finding), stated};
}

/// Returns all cases of a file, or the case on one of its lines.
std::vector<Target> of_file(const std::string& name, std::optional<std::size_t> wanted) {
  std::vector<Target> targets;
  std::ifstream file;
  if (name != "-") file.open(name);
  std::istream& in = name == "-" ? std::cin : file;
  CaseReader reader(in);
  while (const auto line = reader.next()) {
    if (wanted && line->line != *wanted) continue;
    if (!line->value) throw InputError(name + ": " + line->error);
    const std::string id = escaped_controls(line->value->id);
    targets.push_back({id.empty() ? fmt::format("{}:{}", name, line->line) : id,
                       line->value->pair,
                       {},
                       line->value->truth});
  }
  if (in.bad()) throw std::runtime_error(name + " cannot be read");
  if (wanted && targets.empty()) throw UsageError(fmt::format("{} has no case in line {}", name, *wanted));
  return targets;
}

/// Splits "NAME:17" into its two parts.
std::optional<std::pair<std::string, std::int64_t>> numbered(const std::string& name) {
  const std::size_t colon = name.rfind(':');
  if (colon == std::string::npos) return {};
  const auto number = number_in<std::int64_t>(std::string_view(name).substr(colon + 1));
  if (number.value_or(-1) < 0) return {};
  return std::pair(name.substr(0, colon), *number);
}

}  // namespace

std::string lasting_name(const std::string& folder) {
  fs::path run = folder;
  if (!run.has_filename()) run = run.parent_path();
  return fs::is_symlink(run) ? (run.parent_path() / fs::read_symlink(run)).string() : folder;
}

std::vector<Target> targets_of(const std::string& name) {
  std::vector<Target> targets;
  if (fs::is_directory(name)) {
    for (FindingRecord& f : RunStore::open(name).findings())
      targets.push_back(of_finding(lasting_name(name), std::move(f)));
    return targets;
  }
  if (name == "-" || fs::exists(name)) return of_file(name, {});
  if (const auto parts = numbered(name)) {
    const auto& [place, number] = *parts;
    if (fs::is_directory(place)) {
      auto finding = RunStore::open(place).finding(number);
      if (!finding) throw UsageError(fmt::format("{} has no finding {}", place, number));
      targets.push_back(of_finding(lasting_name(place), std::move(*finding)));
      return targets;
    }
    if (fs::exists(place)) return of_file(place, static_cast<std::size_t>(number));
  }
  throw UsageError("'" + name +
                   "' is not a run, a finding RUN:ID, a file of cases or a line FILE:LINE of one");
}

}  // namespace cyl
