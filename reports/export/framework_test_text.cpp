// SPDX-License-Identifier: MIT
#include "reports/export/framework_test_text.hpp"

#include <fmt/format.h>

#include <cctype>

#include "corpus/pairs/truth_io.hpp"
#include "oracles/trial/finding_text.hpp"
#include "reports/export/program_text.hpp"

namespace cyl {
namespace {

std::string ending(std::string_view framework) {
  return framework == "pytest" ? ".py" : framework == "node" ? ".mjs" : ".cpp";
}

std::string numbers(const Cylinder& c) {
  const double all[] = {c.center[0], c.center[1], c.center[2], c.axis[0], c.axis[1],
                        c.axis[2],   c.radius,    c.height,    c.rounding};
  return listed(all, 9);
}

std::string identifier(std::string text) {
  for (char& c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return text;
}

}  // namespace

const std::vector<std::string>& test_frameworks() {
  static const std::vector<std::string> all{"gtest", "doctest", "catch2", "boost", "pytest", "node"};
  return all;
}

std::string framework_test_name(std::string_view framework) {
  return framework == "pytest" ? "test_daylight.py"
         : framework == "node" ? "daylight.test.mjs"
                               : "daylight_test.cpp";
}

std::string framework_test(std::string_view framework, const Trial& asked, const Method& method) {
  const bool of_distance = asked.finding()->kind == FindingKind::distance_outside;
  const bool python = framework == "pytest", disjoint = asked.truth.verdict == Verdict::disjoint;
  const double allowed = reach(method.claim(), size_of(asked.pair));
  const std::string call = of_distance ? "signed_distance" : "collide";
  const std::string denied = disjoint ? (python ? "not " : "!") : "";
  return filled(
      template_text(fmt::format("emit_{}{}.in", framework, ending(framework))),
      {{"truth", distance_in_words(asked)},
       {"method", std::string(method.name())},
       {"kind", std::string(to_string(asked.finding()->kind))},
       {"proof", format_truth(asked.truth)},
       {"type", of_distance ? "double" : "bool"},
       {"call", call},
       {"name", identifier(fmt::format("{}_{}", method.name(), to_string(asked.finding()->kind)))},
       {"a", numbers(asked.pair.a)},
       {"b", numbers(asked.pair.b)},
       {"holds", of_distance ? fmt::format("{0}(a, b) >= {1} {3} {0}(a, b) <= {2}", call,
                                           bound(asked.distance.lo - allowed),
                                           bound(asked.distance.hi + allowed), python ? "and" : "&&")
                             : fmt::format("{}{}(a, b)", denied, call)}});
}

}  // namespace cyl
