// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <initializer_list>
#include <pugixml.hpp>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "base/safe_text.hpp"
#include "reports/gate/failure_text.hpp"
#include "reports/gate/gate_writers.hpp"

namespace cyl {
namespace {

/// Replaces U+FFFE and U+FFFF in `text`, a result of one_line(). XML allows neither, even as a reference.
std::string xml(std::string text) {
  for (const std::string_view none : {"\xef\xbf\xbe", "\xef\xbf\xbf"})
    for (std::size_t at = 0; (at = text.find(none, at)) != std::string::npos;)
      text.replace(at, none.size(), "\xef\xbf\xbd");
  return text;
}

pugi::xml_node add(pugi::xml_node parent, const char* name,
                   std::initializer_list<std::pair<const char*, std::string>> attributes) {
  pugi::xml_node node = parent.append_child(name);
  for (const auto& [key, value] : attributes) node.append_attribute(key) = xml(value).c_str();
  return node;
}

/// Returns the lines that describe one failure in full.
std::string details(const FailureView& f) {
  std::string text = fmt::format("{}: {}, the first: {}\nfound: {}\nsimplest: {}\ncause: {}\n", f.what,
                                 f.pairs, f.origin, f.found, f.simplest, f.cause);
  if (!f.again.empty()) text += f.again + '\n';
  return text + "again: " + f.replay + '\n';
}

struct Counts {
  std::size_t tests = 0, failures = 0, errors = 0;
};

/// Adds the attributes that each suite has. The element of all suites has the same ones.
void add_totals(pugi::xml_node node, const std::string& name, const Counts& counts) {
  node.append_attribute("name") = xml(name).c_str();
  node.append_attribute("tests") = counts.tests;
  node.append_attribute("failures") = counts.failures;
  node.append_attribute("errors") = counts.errors;
}

pugi::xml_node add_properties(pugi::xml_node suite, const JudgedGate& gate) {
  pugi::xml_node properties = suite.append_child("properties");
  add(properties, "property", {{"name", "seed"}, {"value", std::to_string(gate.report.seed)}});
  add(properties, "property", {{"name", "pairs"}, {"value", std::to_string(gate.report.pairs)}});
  return properties;
}

struct TestCase {
  std::string name;
  std::vector<const JudgedFailure*> failures;
};

/// Returns a test for each law, and then one for each kept case on which the method failed.
std::vector<TestCase> tests_of(const GateMethod& method, const JudgedGate& gate) {
  std::vector<TestCase> tests;
  for (const Law& law : all_laws()) tests.push_back({law_title(law), {}});
  const auto fail = [&](const std::string& name, const JudgedFailure& f) {
    auto test = std::find_if(tests.begin(), tests.end(), [&](const TestCase& t) { return t.name == name; });
    if (test == tests.end()) test = tests.insert(test, {name, {}});
    test->failures.push_back(&f);
  };
  for (const JudgedFailure& f : gate.failures) {
    if (f.method != method.name || !fails_gate(f)) continue;
    fail(law_title(*f.law), f);
    if (is_from_case(f)) fail("case " + view_of(f).origin, f);
  }
  return tests;
}

Counts add_method(pugi::xml_node suites, const GateMethod& method, const JudgedGate& gate) {
  const std::vector<TestCase> tests = tests_of(method, gate);
  const std::string name = one_line(method.name);
  const auto failed =
      std::count_if(tests.begin(), tests.end(), [](const TestCase& t) { return !t.failures.empty(); });
  const Counts counts{tests.size(), static_cast<std::size_t>(failed), 0};
  pugi::xml_node suite = suites.append_child("testsuite");
  add_totals(suite, name, counts);
  add(add_properties(suite, gate), "property", {{"name", "version"}, {"value", one_line(method.version)}});
  for (const TestCase& test : tests) {
    pugi::xml_node node = add(suite, "testcase", {{"classname", name}, {"name", one_line(test.name)}});
    for (const JudgedFailure* f : test.failures) {
      const FailureView view = view_of(*f);
      add(node, "failure",
          {{"type", to_string(f->severity)}, {"message", fmt::format("{}: {}", view.law, view.what)}})
          .text() = xml(details(view)).c_str();
    }
  }
  std::string beside;
  for (const JudgedFailure& f : gate.failures)
    if (f.method == method.name && !fails_gate(f))
      beside += fmt::format("{}, {}: {}\n", f.known ? "known" : in_words(f.severity), law_title(*f.law),
                            details(view_of(f)));
  if (!method.remark.empty()) beside += one_line(method.remark) + '\n';
  if (!beside.empty()) suite.append_child("system-out").text() = xml(beside).c_str();
  return counts;
}

/// Adds a suite of the gate itself. Each missing question and each doubt is a test in error. Returns their
/// number.
std::size_t add_gate_itself(pugi::xml_node suites, const JudgedGate& gate) {
  const auto doubts = std::ranges::count(gate.remarks, exit_undecided, &GateRemark::exit_code);
  const std::size_t errors = gate.not_asked.size() + static_cast<std::size_t>(doubts);
  if (errors == 0) return 0;
  pugi::xml_node suite = suites.append_child("testsuite");
  add_totals(suite, "daylight gate", {errors, 0, errors});
  add_properties(suite, gate);
  const auto add_test = [&](const std::string& name, const char* type, const std::string& message) {
    add(add(suite, "testcase", {{"classname", "daylight gate"}, {"name", name}}), "error",
        {{"type", type}, {"message", message}});
  };
  for (const std::string& line : gate.not_asked) {
    const std::string what = one_line(line);
    add_test("asked: " + what, "not asked", "not asked: " + what);
  }
  for (const GateRemark& r : gate.remarks) {
    const std::string what = one_line(r.text);
    if (r.exit_code == exit_undecided) add_test(what, "undecided", what);
  }
  return errors;
}

}  // namespace

std::string gate_junit(const JudgedGate& gate) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node suites = document.append_child("testsuites");
  Counts all;
  for (const GateMethod& method : gate.report.methods) {
    const Counts counts = add_method(suites, method, gate);
    all.tests += counts.tests;
    all.failures += counts.failures;
  }
  all.errors = add_gate_itself(suites, gate);
  all.tests += all.errors;
  std::chrono::milliseconds time{0};
  for (const GatePhaseReport& phase : gate.report.phases) time += phase.time;
  add_totals(suites, "daylight gate", all);
  suites.append_attribute("time") = fmt::format("{}.{:03}", time.count() / 1000, time.count() % 1000).c_str();
  std::ostringstream text;
  document.save(text, " ");
  return text.str();
}

}  // namespace cyl
