// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "base/safe_text.hpp"
#include "corpus/pairs/pair_json.hpp"
#include "reports/triage/causes.hpp"

namespace cyl {
namespace {

/// Returns "fcl-libccd, ode and 3 more".
std::string some_of(const std::set<std::string>& names) {
  constexpr std::size_t named_cap = 4;
  std::string text;
  std::size_t named = 0;
  for (auto name = names.begin(); name != names.end() && named < named_cap; ++name, ++named)
    text += (named == 0 ? "" : ", ") + *name;
  if (names.size() > named_cap) text += fmt::format(" and {} more", names.size() - named_cap);
  return text;
}

std::string format_cause(const Cause& b) {
  std::string text =
      fmt::format("{} {}{}{}\n    {}\n", b.severity == Severity::contract ? "*" : " ", b.key,
                  b.status ? std::string(", ") + to_string(*b.status) : "",
                  is_of_new_families(b) ? ", but no earlier run tested this method on these families" : "",
                  b.description);
  text += b.count == 0 ? "    found in other runs only"
                       : fmt::format("    {}{} in {}, of {}",
                                     b.count > b.findings.size() && !b.findings.empty() ? "about " : "",
                                     counted(b.count, "finding"), counted(b.families.size(), "family"),
                                     counted(b.methods.size(), "method"));
  if (b.margin && !is_failure(b.kind))
    text += fmt::format("; margins from {:.1e} up to {:.1e} or more", b.margin->lo, b.margin->hi);
  return text + fmt::format("\n    {}, {}: {}\n", some_of(b.methods), shown_in_words(b),
                            pair_json(b.simplest.pair).dump());
}

}  // namespace

std::string format_causes(const std::vector<Cause>& causes) {
  std::string text;
  for (const Cause& b : causes) text += format_cause(b);
  return text;
}

}  // namespace cyl
