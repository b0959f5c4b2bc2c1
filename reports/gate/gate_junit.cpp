// SPDX-License-Identifier: MIT
#include "reports/gate/gate_junit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/safe_text.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "reports/gate/failure_text.hpp"

namespace cyl {
namespace {

/// `text` with & < > " ' as character references; control characters but newline and tab become U+FFFD, and
/// those that reorder text are written as \u202e is.
std::string escape(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (const unsigned control = leading_bidi_control(text.substr(i))) {
      safe += escaped_code(control);
      i += 2;
      continue;
    }
    const char c = text[i];
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f) {
          safe += "\xef\xbf\xbd";
        } else {
          safe += c;
        }
    }
  }
  return safe;
}

/// Safe as content and as an attribute, where a parser would make a blank of a newline. XML has no U+FFFE and
/// no U+FFFF, not even as references.
std::string xml(std::string_view text) {
  std::string safe;
  const std::string escaped = escape(valid_utf8(text));
  for (std::size_t i = 0; i < escaped.size(); ++i) {
    if (escaped[i] == '\n') {
      safe += "&#10;";
    } else if (escaped.compare(i, 3, "\xef\xbf\xbe") == 0 || escaped.compare(i, 3, "\xef\xbf\xbf") == 0) {
      safe += "\xef\xbf\xbd";
      i += 2;
    } else {
      safe += escaped[i];
    }
  }
  return safe;
}

/// Lines that say all of one failure.
std::string details(const GateFailure& f) {
  std::string text = fmt::format("{}: {}, the first: {}\nfound: {}\nsimplest: {}\nbucket: {}\n",
                                 one_line(f.what), pairs_in_words(f.count), one_line(f.origin),
                                 format_pair(f.found), format_pair(f.simplest), one_line(f.bucket));
  if (const std::string luck = luck_in_words(f); !luck.empty()) text += luck + '\n';
  if (!f.reproduce.empty()) text += "RapidCheck: " + one_line(f.reproduce) + '\n';
  return text + "again: " + replay_command(f) + '\n';
}

struct TestCase {
  std::string name;
  std::vector<const GateFailure*> failures;
};

std::string format(const std::string& suite, const TestCase& test) {
  std::string text =
      fmt::format("  <testcase classname=\"{}\" name=\"{}\"", xml(suite), xml(one_line(test.name)));
  if (test.failures.empty()) return text + "/>\n";
  text += ">\n";
  for (const GateFailure* f : test.failures) {
    text += fmt::format("   <failure type=\"{}\" message=\"{}\">{}</failure>\n", to_string(f->severity),
                        xml(fmt::format("{}: {}", law_title(*f->law), one_line(f->what))), xml(details(*f)));
  }
  return text + "  </testcase>\n";
}

struct Suite {
  std::vector<TestCase> tests;
  std::size_t failed = 0;  ///< tests
  std::string text;
};

Suite suite_of(const GateMethod& method, const GateReport& report) {
  Suite suite;
  for (const Law& law : all_laws()) suite.tests.push_back({law_title(law), {}});
  const auto add = [&](const std::string& name, const GateFailure& f) {
    auto test = std::find_if(suite.tests.begin(), suite.tests.end(),
                             [&](const TestCase& t) { return t.name == name; });
    if (test == suite.tests.end()) test = suite.tests.insert(test, {name, {}});
    suite.failed += test->failures.empty();
    test->failures.push_back(&f);
  };
  std::string beside;
  for (const GateFailure& f : report.failures) {
    if (f.method != method.name) continue;
    if (fails_gate(f)) {
      add(law_title(*f.law), f);
      if (is_from_case(f)) add("case " + f.origin, f);
    } else {
      beside += fmt::format("{}, {}: {}\n", f.known ? "known" : to_string(f.severity), law_title(*f.law),
                            details(f));
    }
  }

  suite.text = fmt::format(
      " <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n"
      "  <properties>\n"
      "   <property name=\"seed\" value=\"{}\"/>\n"
      "   <property name=\"pairs\" value=\"{}\"/>\n"
      "   <property name=\"version\" value=\"{}\"/>\n"
      "  </properties>\n",
      xml(one_line(method.name)), suite.tests.size(), suite.failed, report.seed, report.pairs,
      xml(one_line(method.version)));
  for (const TestCase& test : suite.tests) suite.text += format(one_line(method.name), test);
  if (!method.remark.empty()) beside += one_line(method.remark) + '\n';
  if (!beside.empty()) suite.text += "  <system-out>" + xml(beside) + "</system-out>\n";
  suite.text += " </testsuite>\n";
  return suite;
}

/// A suite of the gate itself: a test that is in error for each line of what was not asked.
std::string suite_of_what_was_not_asked(const GateReport& report) {
  std::string tests;
  for (const std::string& line : report.not_asked) {
    const std::string what = xml(one_line(line));
    tests += fmt::format(
        "  <testcase classname=\"daylight gate\" name=\"asked: {}\">\n"
        "   <error type=\"not asked\" message=\"not asked: {}\"/>\n  </testcase>\n",
        what, what);
  }
  return fmt::format(
      " <testsuite name=\"daylight gate\" tests=\"{0}\" failures=\"0\" errors=\"{0}\">\n"
      "  <properties>\n   <property name=\"seed\" value=\"{1}\"/>\n"
      "   <property name=\"pairs\" value=\"{2}\"/>\n  </properties>\n{3} </testsuite>\n",
      report.not_asked.size(), report.seed, report.pairs, tests);
}

}  // namespace

std::string gate_junit(const GateReport& report) {
  std::chrono::milliseconds time{0};
  for (const GatePhaseReport& p : report.phases) time += p.time;
  std::string suites;
  std::size_t tests = 0, failed = 0;
  for (const GateMethod& m : report.methods) {
    const Suite suite = suite_of(m, report);
    tests += suite.tests.size();
    failed += suite.failed;
    suites += suite.text;
  }
  const std::size_t errors = report.not_asked.size();
  if (errors > 0) suites += suite_of_what_was_not_asked(report);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"daylight gate\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{}.{:03}\">\n"
      "{}</testsuites>\n",
      tests + errors, failed, errors, time.count() / 1000, time.count() % 1000, suites);
}

}  // namespace cyl
