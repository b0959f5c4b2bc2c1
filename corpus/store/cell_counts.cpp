// SPDX-License-Identifier: MIT
#include "corpus/store/cell_counts.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <iterator>
#include <stdexcept>

namespace cyl {
namespace {

constexpr std::array fields{
    &CellCounts::asked,           &CellCounts::wrong_disjoint,     &CellCounts::wrong_intersecting,
    &CellCounts::failed,          &CellCounts::undecided,          &CellCounts::declined,
    &CellCounts::within_disjoint, &CellCounts::within_intersecting};

}  // namespace

CellCounts& CellCounts::operator+=(const CellCounts& other) {
  for (const auto field : fields) this->*field += other.*field;
  return *this;
}

std::vector<CellCounts>& CellTable::at(std::string_view plane, int x, int y, std::size_t methods) {
  std::vector<CellCounts>& counts = cells_[{std::string(plane), x, y}];
  if (counts.size() < methods) counts.resize(methods);
  return counts;
}

void CellTable::add(const CellRecord& record) {
  std::vector<CellCounts>& counts = at(record.plane, record.x, record.y, record.methods.size());
  for (std::size_t m = 0; m < record.methods.size(); ++m) counts[m] += record.methods[m];
}

std::vector<CellRecord> CellTable::records() const {
  std::vector<CellRecord> all;
  for (const auto& [key, counts] : cells_)
    all.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), counts});
  return all;
}

std::string format_cell_counts(const std::vector<CellCounts>& methods) {
  std::string text;
  std::size_t waiting = 0;  // separators of methods that were not asked
  for (const CellCounts& counts : methods) {
    auto end = fields.size();
    while (end > 0 && counts.*fields[end - 1] == 0) --end;
    if (end > 0) {
      text.append(waiting, ';');
      waiting = 0;
      for (std::size_t i = 0; i < end; ++i)
        fmt::format_to(std::back_inserter(text), "{}{}", i == 0 ? "" : " ", counts.*fields[i]);
    }
    ++waiting;
  }
  return text;
}

std::vector<CellCounts> parse_cell_counts(std::string_view text) {
  const auto refuse = [&] {
    throw std::runtime_error(fmt::format("'{}' is not the counts of a cell", text));
  };
  std::vector<CellCounts> methods;
  if (text.empty()) return methods;
  const char *at = text.data(), *const end = at + text.size();
  methods.emplace_back();
  for (std::size_t field = 0; at != end;) {
    if (*at == ';') {
      methods.emplace_back();
      field = 0;
      ++at;
      continue;
    }
    if (field > 0 && *at++ != ' ') refuse();
    if (field == fields.size()) refuse();
    const auto [rest, error] = std::from_chars(at, end, methods.back().*fields[field++]);
    if (error != std::errc()) refuse();
    at = rest;
  }
  return methods;
}

void count_answer(CellCounts& counts, const MethodAnswer& answer, const std::optional<Finding>& wrong) {
  ++counts.asked;
  if (answer.status == Status::failed || (wrong && wrong->kind == FindingKind::non_finite)) {
    ++counts.failed;
  } else if (answer.status == Status::declined) {
    ++counts.declined;
  } else if (answer.verdict == Verdict::undecided || (wrong && wrong->kind == FindingKind::wrong_invalid)) {
    ++counts.undecided;
  } else if (wrong) {
    const bool disjoint = wrong->kind == FindingKind::wrong_disjoint,
               intersecting = wrong->kind == FindingKind::wrong_intersecting,
               within = wrong->severity == Severity::resolution;
    counts.wrong_disjoint += disjoint;
    counts.wrong_intersecting += intersecting;
    counts.within_disjoint += disjoint && within;
    counts.within_intersecting += intersecting && within;
  }
}

}  // namespace cyl
