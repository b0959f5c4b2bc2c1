// SPDX-License-Identifier: MIT
#include "reports/export/export_guest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/json.hpp"
#include "base/safe_text.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/plugin.h"
#include "reports/export/program_text.hpp"

namespace cyl {
namespace {

/// Seconds after which a program that does not come back is ended.
constexpr int patience = 20;

constexpr std::string_view some_of_three = R"(/* Given, but not as finite numbers. */
static int some_of(const double* v) {
  const int given = !isnan(v[0]) || !isnan(v[1]) || !isnan(v[2]);
  return given && !(isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]));
}

)";

std::string truth_for_guest(const Trial& asked) {
  if (!asked.decided()) return "not known";
  std::string text = fmt::format("{} (python3 exact.py proves it)", to_string(asked.truth.verdict));
  if (asked.truth.verdict != Verdict::touching)
    text += fmt::format(", signed distance {} to {}", format_double(asked.distance.lo),
                        format_double(asked.distance.hi));
  return text;
}

std::string eight_numbers(const Cylinder& c) { return listed(numbers_of(c).data(), cylinder_number_count); }

bool apart(const Trial& asked) { return asked.truth.verdict == Verdict::disjoint; }

/// The least and the most that a distance may be said to be.
Enclosure allowed(const Trial& asked, const Claim& claim) {
  const double tolerance = reach(claim, size_of(asked.pair));
  const Enclosure real = asked.truth.verdict == Verdict::touching ? Enclosure{0, 0} : asked.distance;
  return {real.lo - tolerance, real.hi + tolerance};
}

std::string wrong_in_c(const Trial& asked, const Claim& claim) {
  switch (asked.finding()->kind) {
    case FindingKind::distance_outside: {
      const Enclosure real = allowed(asked, claim);
      return fmt::format("!isnan(more[0]) && !(more[0] >= {} && more[0] <= {})", literal(real.lo),
                         literal(real.hi));
    }
    case FindingKind::bad_witness: {
      const int first = asked.answer().witness == CertificateKind::point ? 4 : 1;
      std::string text;
      for (int i = 0; i < 3; ++i)
        text +=
            fmt::format("{}more[{}] == {}", i == 0 ? "" : " && ", first + i, literal(asked.answer().head[i]));
      return text;
    }
    case FindingKind::non_finite:
      return "isinf(more[0]) || some_of(more + 1) || some_of(more + 4)";
    case FindingKind::exception:
      return "said == DAYLIGHT_FAILED";
    case FindingKind::malformed:
    case FindingKind::crash:
    case FindingKind::hang:
      return "0";
    case FindingKind::wrong_touching:
      return "said == DAYLIGHT_TOUCHING";
    default:
      return apart(asked) ? "said == DAYLIGHT_INTERSECTING || said == DAYLIGHT_TOUCHING"
                          : "said == DAYLIGHT_DISJOINT";
  }
}

std::string wrong_in_python(const Trial& asked, const Claim& claim) {
  switch (asked.finding()->kind) {
    case FindingKind::distance_outside: {
      const Enclosure real = allowed(asked, claim);
      return fmt::format("'distance' in said and not {} <= said['distance'] <= {}", format_double(real.lo),
                         format_double(real.hi));
    }
    case FindingKind::bad_witness: {
      const MethodAnswer& a = asked.answer();
      if (a.witness == CertificateKind::direction)
        return fmt::format("said.get('direction') == [{}]", listed(a.head, 3));
      std::string text = "[x if isinstance(x, list) else [x, 0] for x in said.get('point', [])] == [";
      for (int i = 0; i < 3; ++i)
        text += fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", literal(a.head[i]), literal(a.tail[i]));
      return text + "]";
    }
    case FindingKind::exception:
      return "'error' in said";
    case FindingKind::crash:
    case FindingKind::hang:
    case FindingKind::malformed:
    case FindingKind::non_finite:  // no number of JSON
      return "False";
    case FindingKind::wrong_invalid:
      return "verdict == 'invalid'";
    case FindingKind::wrong_touching:
      return "verdict == 'touching'";
    default:
      return apart(asked) ? "verdict in ('intersecting', 'touching')" : "verdict == 'disjoint'";
  }
}

/// As a literal of Python: JSON's strings are, in ASCII.
std::string python_literal(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

bool ends_itself(FindingKind kind) { return kind == FindingKind::crash || kind == FindingKind::hang; }

}  // namespace

bool guest_program_shows(FindingKind kind) {
  return kind != FindingKind::nondeterminism && kind != FindingKind::state_dependent &&
         kind != FindingKind::undecided_truth;
}

std::string guest_program_name(const Guest& guest) {
  return guest.kind == GuestKind::plugin ? "reproduce.c" : "reproduce.py";
}

std::string guest_program(const Guest& guest, const Trial& asked, const Claim& claim) {
  Words words{{"truth", truth_for_guest(asked)}};
  if (guest.kind == GuestKind::command) {
    words["pair"] = python_literal(format_pair(asked.pair));
    words["patience"] = std::to_string(patience);
    words["wrong"] = wrong_in_python(asked, claim);
    return filled(template_text("command.py.in"), words);
  }
  words["a"] = eight_numbers(asked.pair.a);
  words["b"] = eight_numbers(asked.pair.b);
  words["abi"] = std::to_string(DAYLIGHT_PLUGIN_ABI);
  words["before"] = ends_itself(asked.finding()->kind) || asked.finding()->kind == FindingKind::exception
                        ? fmt::format("  puts(\"asking; it had this: {}\");\n  fflush(stdout);\n",
                                      to_string(asked.finding()->kind))
                        : "";
  words["helper"] = asked.finding()->kind == FindingKind::non_finite ? some_of_three : "";
  words["wrong"] = wrong_in_c(asked, claim);
  return filled(template_text("plugin.c.in"), words);
}

std::string guest_build(const Guest& guest, FindingKind kind) {
  std::string text = "#!/bin/sh\nset -e\nhere=$(cd -- \"$(dirname -- \"$0\")\" && pwd)\n";
  if (guest.kind == GuestKind::command)
    return text + fmt::format(
                      "# sh build.sh [COMMAND]: asks the program; another that is given, from where one "
                      "stands.\n[ $# -gt 0 ] || cd -- {}\n[ $# -gt 0 ] || set -- {}\n"
                      "exec python3 \"$here/reproduce.py\" \"$1\"\n",
                      shell_quoted(guest.folder), shell_quoted(guest.what));
  return text + fmt::format(
                    "# sh build.sh [FILE]: builds reproduce.c and asks the plug-in, or another that is "
                    "given.\nfile={}\n[ $# = 0 ] || file=$(cd -- \"$(dirname -- \"$1\")\" && pwd)/$(basename "
                    "-- \"$1\")\n"
                    "${{CC:-cc}} -O2 \"$here/reproduce.c\" -o \"$here/reproduce\" -ldl -lm\n"
                    "exec {}\"$here/reproduce\" \"$file\"\n",
                    shell_quoted(guest.what),
                    kind == FindingKind::hang ? fmt::format("timeout {} ", patience) : "");
}

std::string guest_in_words(const Guest& guest) {
  return guest.kind == GuestKind::plugin
             ? "a plug-in, " + std::filesystem::path(guest.what).filename().string()
             : "a program, " + guest.what;
}

}  // namespace cyl
