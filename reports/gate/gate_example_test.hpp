// SPDX-License-Identifier: MIT
// A result of the gate for the tests of its writers, with all that a writer may stumble over.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "base/scratch_test.hpp"
#include "reports/gate/judged_gate.hpp"

namespace cyl {

/// A file that is removed with the object.
class ScratchFile : Scratch {
 public:
  explicit ScratchFile(const std::string& content) : path(write("file", content)) {}
  const std::filesystem::path path;
};

/// Hostile text that foreign code may return: markup, quotes, line ends, controls, a character that reorders
/// text, bytes that are not UTF-8, and U+FFFF, which XML does not have.
inline const std::string hostile =
    "<a b='c'>\"]]>&amp;%0A,::error::\r\n\x1b[2J\x01\xe2\x80\xae\xff\xc3(\xef\xbf\xbf";

inline JudgedFailure example_failure(const std::string& method, int law, Severity severity) {
  JudgedFailure f;
  f.method = method;
  f.law = &law_numbered(law);
  f.what = "said disjoint";
  f.severity = severity;
  f.phase = GatePhase::laws;
  f.origin = "side-rim 1e-09, seed 1, index 17";
  f.found.a.radius = 0.1;
  f.found.b.center = {0.1, -0.0, 1e-300};
  f.simplest.a.radius = 2;
  f.kind = "law-" + std::to_string(law);
  f.cause = method + '/' + f.kind + "/side-rim";
  f.count = 1234;
  f.reruns = f.failed_again = 10;
  return f;
}

/// A report on two methods. The method intersect breaks law 1 beyond its claim on a random pair, law 2 not
/// deterministically, and law 3 within its claim. The method fake breaks law 30 on a case, with hostile
/// words. One cell of fake is wrong, one is empty.
inline JudgedGate example_gate() {
  GateReport report;
  report.seed = std::numeric_limits<std::uint64_t>::max();
  report.phases = {{GatePhase::corpus, 0, 12, std::chrono::milliseconds(250)},
                   {GatePhase::corpus_laws, 0, 7, std::chrono::milliseconds(0)},
                   {GatePhase::laws, 9, 576, std::chrono::milliseconds(1000)},
                   {GatePhase::sample, 831, 345678, std::chrono::milliseconds(30040)},
                   {GatePhase::close_laws, 5, 320, std::chrono::milliseconds(500)},
                   {GatePhase::close_sample, 70, 25200, std::chrono::milliseconds(900)}};
  report.pairs = 350'000;
  report.cap = std::chrono::milliseconds(40'000);
  report.cases = {17, 18};
  report.undecided_truths = 3;

  GateMethod intersect{.name = "intersect",
                       .version = "0.2.0",
                       .claim = {1e-13, 0, "derived bound"},
                       .counts = {},
                       .cells = {},
                       .close_cells = {},
                       .rounded = {},
                       .remark = {}};
  intersect.counts.asked = 1234567;
  intersect.counts.said[static_cast<std::size_t>(Verdict::undecided)] = 77;
  GateMethod fake{.name = "fake" + hostile,
                  .version = hostile,
                  .claim = {0, 1e-6, hostile},
                  .counts = {},
                  .cells = {},
                  .close_cells = {},
                  .rounded = {},
                  .remark = "answers intersecting to every pair" + hostile};
  for (const ContactFeature feature : {ContactFeature::side_side, ContactFeature::side_rim}) {
    for (int decade = 0; decade < 13; ++decade) {
      intersect.cells.push_back({{feature, decade}, decade < 12, 2400u + static_cast<unsigned>(decade)});
      fake.cells.push_back({{feature, decade}, decade < 3, 50});
    }
  }
  for (const CloseCell& at : close_cells) {
    intersect.close_cells.push_back({at, true, 409, 0, 408, 0, 0});
    fake.close_cells.push_back({at, at.decade < 3, 100, 0, 90, 0, 2});
  }
  intersect.close_cells[1] = {{AxesLie::generic, AngleBand::wide, 2}, true, 12, 0, 408, 0, 0};
  fake.close_cells[0] = {{AxesLie::generic, AngleBand::wide, 1}, true, 0, 0, 0, 0, 2};
  fake.close_cells[1].wrong_overlaps = 3;
  fake.cells[1].wrong = 7;
  fake.cells[2].pairs = 0;
  report.methods = {intersect, fake};

  JudgedGate gate = judged(std::move(report));
  gate.remarks.clear();  // their tests add their own
  gate.failures = {example_failure("intersect", 1, Severity::contract),
                   example_failure("intersect", 2, Severity::contract),
                   example_failure("intersect", 3, Severity::resolution),
                   example_failure(fake.name, 30, Severity::contract)};
  gate.failures[1].failed_again = 3;
  JudgedFailure& of_case = gate.failures[3];
  of_case.phase = GatePhase::corpus;
  of_case.origin = "corpus/cases/found.jsonl:2 fuzz" + hostile;
  of_case.what = hostile;
  of_case.found.a.height = std::numeric_limits<double>::quiet_NaN();
  return gate;
}

/// Cut: two lines of what was not asked, the second hostile.
inline JudgedGate cut_gate() {
  JudgedGate gate = example_gate();
  gate.failures.clear();
  gate.not_asked = {"sample of all strata: 9 of 840 rounds, since the time was over", "fake" + hostile};
  return gate;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << "nothing to replace: " << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

inline std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace cyl
