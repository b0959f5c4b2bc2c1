// SPDX-License-Identifier: MIT
// What a merge gate checks beside the answers of methods: that the referee, which it believes, proves what is
// so and nothing else, and that the solver keeps what its headers promise beside verdicts. Counts decide,
// never a clock; the same seed asks the same.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "corpus/pairs/pair_io.hpp"

namespace cyl {

/// What was asked, and what of it was wrong.
class Checked {
 public:
  /// Counts a question. Where it does not hold, keeps the details of the first of its kind.
  template <class... Details>
  void expect(bool holds, const char* what, const Details&... details) {
    ++asked_;
    if (holds) return;
    Wrong& wrong = wrong_[what];
    if (++wrong.count > 1) return;
    wrong.first = what;
    ((wrong.first += fmt::format(" {}", details)), ...);
  }
  std::uint64_t asked() const { return asked_; }
  /// A line for each kind of thing that was wrong: the first one, and how many there were.
  std::vector<std::string> wrong() const {
    std::vector<std::string> lines;
    for (const auto& [what, wrong] : wrong_)
      lines.push_back(fmt::format("{} ({} times)", wrong.first, wrong.count));
    return lines;
  }

 private:
  struct Wrong {
    std::uint64_t count = 0;
    std::string first;
  };
  std::uint64_t asked_ = 0;
  std::map<std::string, Wrong> wrong_;
};

/// Intervals, numbers of MPFR and MPFI, and sums of square roots: each result holds the exact one, computed
/// in rationals, and is no wider than its rounding.
void check_arithmetic(Checked& checked, std::uint64_t seed);
/// Every way to check a direction, a point, or a point in hulls, against rationals and 512 bits of GMP: none
/// proves what is not so, and each proves what holds by more than its rounding.
void check_certificates(Checked& checked, std::uint64_t seed);
/// The referee's search and enclosure: they prove and enclose all that they are built for, in as many steps
/// as their headers say in the mean.
void check_searches(Checked& checked, std::uint64_t seed);

/// Solids that touch exactly, or only a plane between them, are proved to.
void check_touching(Checked& checked, std::uint64_t seed);
/// The referee proves of each case what its line says is true.
void check_known(Checked& checked, std::span<const Case> cases);

/// Batches of all sizes, on every instruction set that the machine has, answer as intersect() does.
void check_batches(Checked& checked, std::uint64_t seed);
/// The solver's points, errors and proxies hold, and its searches take as many steps as its headers say.
void check_promises(Checked& checked, std::uint64_t seed);

}  // namespace cyl
