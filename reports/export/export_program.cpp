// SPDX-License-Identifier: MIT
#include "reports/export/export_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <vector>

#include "base/json.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "oracles/methods/adapter.hpp"

namespace cyl {
namespace {

using Words = std::map<std::string, std::string, std::less<>>;

/// Returns `text` with every @word@ replaced.
std::string filled(std::string_view text, const Words& words) {
  std::string out;
  while (true) {
    const std::size_t begin = text.find('@');
    out += text.substr(0, begin);
    if (begin == std::string_view::npos) return out;
    text.remove_prefix(begin + 1);
    const std::size_t end = text.find('@');
    out += words.at(std::string(text.substr(0, end)));
    text.remove_prefix(end + 1);
  }
}

/// Returns literal() of a bound of doubles: the largest one if it is infinite.
std::string bound(double x) {
  constexpr double largest = std::numeric_limits<double>::max();
  return literal(std::clamp(x, -largest, largest));
}

/// Returns "1, 2.5, -0.0".
std::string listed(const double* numbers, int count) {
  std::string text = literal(numbers[0]);
  for (int i = 1; i < count; ++i) text += ", " + literal(numbers[i]);
  return text;
}

/// The solid as each library declares it. No program of a library is made for other kinds.
std::string in_fcl(const std::string& name, const Solid& c) {
  switch (kind_of(c)) {
    case SolidKind::half_space:
      return fmt::format("fcl::Halfspaced {}(fcl::Vector3d::UnitZ(), 0)", name);
    case SolidKind::sphere:
      return fmt::format("fcl::Sphered {}({})", name, literal(c.rounding));
    case SolidKind::capsule:
      return fmt::format("fcl::Capsuled {}({}, {})", name, literal(c.rounding), literal(c.height));
    case SolidKind::box:
      return fmt::format("fcl::Boxd {}({})", name, listed(c.edges.data(), 3));
    default:
      return fmt::format("fcl::Cylinderd {}({}, {})", name, literal(c.radius), literal(c.height));
  }
}
std::string in_ode(const Solid& c) {
  const Vector3 n = unit_axis(c.axis);
  switch (kind_of(c)) {
    case SolidKind::half_space:
      return fmt::format("dCreatePlane(nullptr, {}, {})", listed(n.data(), 3), literal(n.dot(c.center)));
    case SolidKind::sphere:
      return fmt::format("dCreateSphere(nullptr, {})", literal(c.rounding));
    case SolidKind::capsule:
      return fmt::format("dCreateCapsule(nullptr, {}, {})", literal(c.rounding), literal(c.height));
    case SolidKind::box:
      return fmt::format("dCreateBox(nullptr, {})", listed(c.edges.data(), 3));
    default:
      return fmt::format("dCreateCylinder(nullptr, {}, {})", literal(c.radius), literal(c.height));
  }
}
std::string half_edges(const Solid& c) {
  return listed(Vector3(c.edges[0] / 2, c.edges[1] / 2, c.edges[2] / 2).data(), 3);
}
std::string in_bullet(const std::string& name, const Solid& c) {
  const std::string radius = literal(c.radius), half = literal(c.height / 2);
  return is_box(c) ? fmt::format("btBoxShape {}(btVector3({}));", name, half_edges(c))
                   : fmt::format("btCylinderShapeZ {0}(btVector3({1}, {1}, {2}));", name, radius, half);
}
std::string hull_in_bullet(const std::string& name, const Solid& c) {
  return is_box(c) ? fmt::format("fill_box({}, {});", name, half_edges(c))
                   : fmt::format("fill({}, {}, {});", name, literal(c.radius), literal(c.height / 2));
}
std::string in_ccd(const Solid& c) {
  const Eigen::Matrix3d columns = rotation_of(c);
  const auto column = [&](int i) { return listed(columns.col(i).data(), 3); };
  if (is_box(c))
    return fmt::format("{{{}}}, {{}}, 0, 0, {}, {{{{{}}}, {{{}}}, {{{}}}}}, {{{}}}",
                       listed(c.center.data(), 3), literal(c.rounding), column(0), column(1), column(2),
                       half_edges(c));
  return fmt::format("{{{}}}, {{{}}}, {}, {}, {}, {{}}, {{}}", listed(c.center.data(), 3), column(2),
                     literal(c.radius), literal(c.height / 2), literal(c.rounding));
}
struct MujocoGeom {
  int order;  ///< the table of colliders has the lesser type first
  const char* type;
  std::string size;
};
MujocoGeom in_mujoco(const Solid& c) {
  const std::string half = literal(c.height / 2);
  switch (kind_of(c)) {
    case SolidKind::half_space:
      return {0, "mjGEOM_PLANE", "0, 0, 0"};
    case SolidKind::sphere:
      return {2, "mjGEOM_SPHERE", literal(c.rounding) + ", 0, 0"};
    case SolidKind::capsule:
      return {3, "mjGEOM_CAPSULE", literal(c.rounding) + ", " + half + ", 0"};
    case SolidKind::box:
      return {6, "mjGEOM_BOX", half_edges(c)};
    default:
      return {5, "mjGEOM_CYLINDER", literal(c.radius) + ", " + half + ", 0"};
  }
}

/// Adds @a.center@, @a.rotation@ and the other words of one solid.
void add_solid(Words& words, const std::string& name, const Solid& c) {
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = rotation_of(c);
  words[name + ".center"] = listed(c.center.data(), 3);
  words[name + ".rotation"] = listed(rows.data(), 9);
  words[name + ".rotation4"] = listed(rows.data(), 3) + ", 0, " + listed(rows.data() + 3, 3) + ", 0, " +
                               listed(rows.data() + 6, 3) + ", 0";
  words[name + ".bullet"] = in_bullet(name, c);
  words[name + ".bullet_hull"] = hull_in_bullet(name, c);
  words[name + ".ccd"] = in_ccd(c);
  words[name + ".fcl"] = in_fcl(name, c);
  words[name + ".ode"] = in_ode(c);
  words[name + ".ode_pose"] =
      is_half_space(c)
          ? ""
          : fmt::format(
                "  const dMatrix3 rotation_{0} = {{{1}}};\n  dGeomSetRotation({0}, rotation_{0});\n"
                "  dGeomSetPosition({0}, {2});\n",
                name, words[name + ".rotation4"], words[name + ".center"]);
  words[name + ".mujoco_type"] = in_mujoco(c).type;
  words[name + ".mujoco_size"] = in_mujoco(c).size;
}

/// Covers the roundings of cosine, quotient and product in a vertex of a prism, as the method does.
constexpr std::string_view outward = "(1 + 0x1p-50) / std::cos(3.141592653589793 / sides)";
constexpr std::string_view inward = "1 - 0x1p-50";

/// How a template becomes the program of a method.
struct Program {
  LibraryCall call;
  std::string source;  ///< the name of the template
  Words words;         ///< of the template, besides those of the pair and the finding
};

/// If a word has several lines, it is an array of them.
std::string text_of(const nlohmann::json& word) {
  if (word.is_string()) return word.get<std::string>();
  return fmt::format("{}", fmt::join(word.get<std::vector<std::string>>(), "\n"));
}

std::vector<Program> read_programs() {
  std::vector<Program> programs;
  for (const nlohmann::json& library : parse_json(template_text("programs.json"))) {
    for (const nlohmann::json& method : library.at("methods")) {
      Program& program = programs.emplace_back();
      program.call = {.method = method.at("method"),
                      .library = library.at("library"),
                      .call = method.at("call"),
                      .settings = method.at("settings"),
                      .flags = library.at("flags"),
                      .packages = library.at("packages")};
      program.source = method.at("template").get<std::string>() + ".cpp.in";
      program.words["version"] = text_of(library.at("version"));
      for (const auto& [word, text] : method.at("words").items()) program.words[word] = text_of(text);
    }
  }
  return programs;
}

const Program* find_program(std::string_view method) {
  static const std::vector<Program> programs = read_programs();
  const auto found = std::ranges::find(programs, method, [](const Program& p) { return p.call.method; });
  return found == programs.end() ? nullptr : &*found;
}

std::string truth_line(const Trial& asked) {
  std::string text = fmt::format("{} (python3 exact.py proves it)", to_string(asked.truth.verdict));
  if (asked.truth.verdict != Verdict::touching)
    text += fmt::format(", signed distance {} to {}", format_double(asked.distance.lo),
                        format_double(asked.distance.hi));
  return text;
}

/// Returns the code after the call, which prints and judges the answer.
std::string verdict_on(const LibraryCall& call, const Words& words, const Trial& asked,
                       const Method& method) {
  const FindingKind kind = asked.finding()->kind;
  std::string text;
  // The headers of libccd do not contain its version.
  if (call.library == "libccd") text = fmt::format("  const char version[] = \"{}\";\n", method.version());
  const auto says = [&](const std::string& format, const std::string& values) {
    text += fmt::format("  std::printf(\"{} {} answers: {}\\n\", {}, {});\n", call.library,
                        call.library == "Bullet" ? "%d.%d" : "%s", format, words.at("version"), values);
  };
  const auto is_true = [&] { text += fmt::format("  std::puts(\"truth: {}\");\n", truth_line(asked)); };
  const auto judge_by = [&](const std::string& wrong) {
    text += fmt::format("  const bool wrong = {};\n", wrong);
    text += fmt::format(
        "  std::puts(wrong ? \"{}\" : \"right\");\n  return wrong ? 1 : 0;\n",
        asked.finding()->severity == Severity::resolution ? "not as proved, within the claim" : "WRONG");
  };
  if (call.call == "fcl::distance" && (kind == FindingKind::non_finite || kind == FindingKind::bad_witness))
    text += "  const fcl::Vector3d between = result.nearest_points[1] - result.nearest_points[0];\n";
  const std::string said = "meet ? \"intersecting\" : \"disjoint\"";
  switch (kind) {
    case FindingKind::distance_outside:
      says("%s, distance %.17g", said + ", distance");
      is_true();
      text += fmt::format("  const double tolerance = {};\n", literal(method.claim().absolute));
      judge_by(fmt::format("!(distance >= {} - tolerance && distance <= {} + tolerance)",
                           bound(asked.distance.lo), bound(asked.distance.hi)));
      break;
    case FindingKind::non_finite:
      text += fmt::format("  const bool finite = std::fabs(distance) < 1.7976931348623157e308{};\n",
                          call.library == "FCL" ? " && between.allFinite()" : "");
      says("%s, distance %.17g%s", said + ", distance, finite ? \"\" : \"; not every number is finite\"");
      is_true();
      judge_by("!finite");
      break;
    case FindingKind::bad_witness:
      says("%s, distance %.17g, nearest points (%.17g, %.17g, %.17g) apart",
           said + ", distance, between[0], between[1], between[2]");
      is_true();
      text += fmt::format(
          "  // The direction that exact.py shows not to separate them.\n"
          "  const fcl::Vector3d shown({});\n",
          listed(asked.answer().head, 3));
      judge_by("between == shown");
      break;
    case FindingKind::exception:
    case FindingKind::crash:
    case FindingKind::hang:
      says("%s", said);
      is_true();
      text += "  return 0;\n";
      break;
    default:
      says("%s", said);
      is_true();
      judge_by(asked.truth.verdict == Verdict::disjoint ? "meet" : "!meet");
  }
  return text;
}

std::string announcement(FindingKind kind) {
  const char* const ends = kind == FindingKind::exception ? "throws"
                           : kind == FindingKind::crash   ? "aborts"
                           : kind == FindingKind::hang    ? "hangs"
                                                          : nullptr;
  if (!ends) return "";
  return fmt::format("  std::puts(\"calling the library: it {}\");\n  std::fflush(stdout);\n", ends);
}

}  // namespace

const LibraryCall* find_library_call(std::string_view method) {
  const Program* program = find_program(method);
  return program == nullptr ? nullptr : &program->call;
}

std::string literal(double x) {
  std::string text = format_double(x);
  const bool integer = text.find_first_of(".en") == std::string::npos;
  if (integer && (text.size() > 9 || text == "-0")) text += ".0";
  return text;
}

bool program_shows(FindingKind kind) {
  using enum FindingKind;
  constexpr std::array shown{wrong_disjoint, wrong_intersecting, bad_witness, distance_outside,
                             non_finite,     exception,          crash,       hang};
  return std::ranges::count(shown, kind) > 0;
}

bool program_takes(std::string_view library, const Pair& pair) {
  return std::ranges::all_of(std::array{kind_of(pair.a), kind_of(pair.b)}, [&](SolidKind kind) {
    if (library == "Bullet") return kind == SolidKind::cylinder || kind == SolidKind::box;
    if (library == "libccd") return kind != SolidKind::half_space;
    return kind != SolidKind::rounded && kind != SolidKind::rounded_box;
  });
}

Pair as_given(const Pair& pair) {
  Pair given = pair;
  given.a.axis = unit_axis(pair.a.axis);
  given.b.axis = unit_axis(pair.b.axis);
  return given;
}

std::string reproducing_program(const LibraryCall& call, const Trial& asked, const Method& method) {
  Words words;
  const bool swap = call.library == "MuJoCo" && in_mujoco(asked.pair.a).order > in_mujoco(asked.pair.b).order;
  add_solid(words, swap ? "b" : "a", asked.pair.a);
  add_solid(words, swap ? "a" : "b", asked.pair.b);
  const bool misses = asked.answer().verdict == Verdict::disjoint;
  words["stretch"] = misses ? outward : inward;
  words["around"] = misses ? "around" : "within";
  words["prisms"] = misses ? "are apart" : "meet";
  words["support"] = template_text("ccd_support.inc");
  const Program& program = *find_program(call.method);
  words.insert(program.words.begin(), program.words.end());
  words["before"] = announcement(asked.finding()->kind);
  words["after"] = verdict_on(call, words, asked, method);
  return fmt::format("// Asks {} ({}) about two solids: {}.\n// c++ {} reproduce.cpp -o reproduce {}\n",
                     call.library, call.call, call.settings, compiler_options, call.flags) +
         filled(template_text(program.source), words);
}

std::string reproducing_script(const Upstream& upstream, const std::string& command, const Trial& asked,
                               const Claim& claim) {
  const FindingKind kind = asked.finding()->kind;
  const bool of_distance = kind == FindingKind::distance_outside && !asked.answer().at_least;
  if (upstream.call.empty() || upstream.install.empty() || !(of_distance || is_refuted_verdict(kind)))
    return {};
  const double error = reach(claim, size_of(asked.pair));
  const std::string is_wrong =
      of_distance
          ? fmt::format(
                "echo \"$answer\" | sed 's/.*\"distance\":\\([^,}}]*\\).*/\\1/' | "
                "awk '{{ exit !($1 < {} || $1 > {}) }}'",
                format_double(asked.distance.lo - error), format_double(asked.distance.hi + error))
          : fmt::format("echo \"$answer\" | grep -q '\"verdict\":\"{}\"'", to_string(asked.answer().verdict));
  return fmt::format(
      "#!/bin/sh\n# Installs the library into this folder, and asks it about case.jsonl.\nset -e\n"
      "cd -- \"$(dirname -- \"$0\")\"\n{} >&2\nanswer=$(DAYLIGHT_MODEL=model.xml {} <case.jsonl | tail -n "
      "1)\necho \"$answer\"\n"
      "if {}; then echo WRONG; exit 1; fi\n",
      upstream.install, command, is_wrong);
}

}  // namespace cyl
