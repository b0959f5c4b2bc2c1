// SPDX-License-Identifier: MIT
// How often each method was asked, with what result, by cell of the planes of the failure maps.
// oracles/trial/cells.hpp defines the planes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "corpus/pairs/finding.hpp"
#include "corpus/pairs/method_answer.hpp"

namespace cyl {

/// The counts of one method in one cell. Besides `asked` and the last two, an answer is counted at most once.
/// The rest were right.
struct CellCounts {
  std::uint64_t asked = 0;
  std::uint64_t wrong_disjoint = 0;
  std::uint64_t wrong_intersecting = 0;
  std::uint64_t failed = 0;     ///< exception, crash, hang, non-finite number
  std::uint64_t undecided = 0;  ///< no verdict: undecided, or called invalid
  std::uint64_t declined = 0;
  std::uint64_t within_disjoint = 0;      ///< of wrong_disjoint, those within the method's claim
  std::uint64_t within_intersecting = 0;  ///< of wrong_intersecting

  CellCounts& operator+=(const CellCounts& other);
  bool operator==(const CellCounts&) const = default;
};

/// Adds an answer and what was wrong with it, if anything. A right verdict with a wrong distance or witness
/// is right.
void count_answer(CellCounts& counts, const MethodAnswer& answer, const std::optional<Finding>& wrong);

struct CellRecord {
  std::string plane;
  int x = 0, y = 0;
  std::vector<CellCounts> methods;  ///< in the order of the run's methods; missing ones were not asked

  bool operator==(const CellRecord&) const = default;
  static constexpr const char* table = "cell";
  static auto columns(auto& c) { return std::tie(c.plane, c.x, c.y, c.methods); }
};

/// Sums of records, in any order.
class CellTable {
 public:
  /// Gives the counts of a cell, grown to `methods` methods. Valid until the next call.
  std::vector<CellCounts>& at(std::string_view plane, int x, int y, std::size_t methods);
  void add(const CellRecord& record);
  std::vector<CellRecord> records() const;  ///< by plane, x and y

 private:
  std::map<std::tuple<std::string, int, int>, std::vector<CellCounts>> cells_;
};

/// "12;12 0 3;;7": a method each, its counts in the order above, without the zeros and methods that end it.
std::string format_cell_counts(const std::vector<CellCounts>& methods);
/// Reads the output of format_cell_counts. Throws std::runtime_error on anything else.
std::vector<CellCounts> parse_cell_counts(std::string_view text);

}  // namespace cyl
