// SPDX-License-Identifier: MIT
#include "reports/export.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "corpus/finding_words.hpp"
#include "corpus/pair_io.hpp"
#include "reports/export_check.hpp"
#include "reports/export_program.hpp"
#include "reports/gate_words.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

std::string triple(const Vector3& v) {
  return fmt::format("({}, {}, {})", format_double(v[0]), format_double(v[1]), format_double(v[2]));
}

std::string row(const char* name, const Cylinder& c) {
  return fmt::format("| {} | {} | {} | {} | {} |\n", name, triple(c.center), triple(c.axis),
                     format_double(c.radius), format_double(c.height));
}

std::string title(const LibraryCall& call, const Probe& p) {
  const std::string_view what = call.call;
  switch (p.finding->kind) {
    case FindingKind::wrong_disjoint:
      return fmt::format(
          "{} misses two cylinders that {}", what,
          p.truth.verdict == Verdict::touching ? "touch" : fmt::format("overlap by {:.3g}", -p.distance.hi));
    case FindingKind::wrong_intersecting:
      return fmt::format("{} reports two cylinders that are {} as colliding", what, distance_in_words(p));
    case FindingKind::distance_outside:
      return fmt::format("{} gives a distance of {:.6g} for two cylinders that are {}", what,
                         p.answer.distance, distance_in_words(p));
    case FindingKind::non_finite:
      return fmt::format("{} returns numbers that are not finite for two cylinders", what);
    case FindingKind::bad_witness:
      return fmt::format("{}: the nearest points of two cylinders do not separate them", what);
    case FindingKind::exception:
      return fmt::format("{} throws on two cylinders", what);
    case FindingKind::hang:
      return fmt::format("{} does not come back from two cylinders", what);
    default:
      return fmt::format("{} aborts on two cylinders", what);
  }
}

std::string came_back(const Probe& p) {
  const MethodAnswer& a = p.answer;
  switch (p.finding->kind) {
    case FindingKind::exception:
      return fmt::format("An exception: `{}`.", one_line(a.reason));
    case FindingKind::crash:
      return fmt::format("The process ended: `{}`.", one_line(a.reason));
    case FindingKind::hang:
      return fmt::format("Nothing, in {} s of CPU time: the call was then ended from outside.",
                         std::chrono::duration<double>(call_cpu_cap).count());
    case FindingKind::distance_outside:
      return fmt::format("A signed distance of {}.", format_double(a.distance));
    case FindingKind::non_finite:
      return fmt::format("Numbers that are not finite: {}.", one_line(a.reason));
    case FindingKind::bad_witness:
      return fmt::format("A distance of {}, and nearest points that are {} apart.", format_double(a.distance),
                         triple({a.head[0], a.head[1], a.head[2]}));
    default:
      return a.verdict == Verdict::disjoint ? "No collision." : "A collision.";
  }
}

std::string truth_in_words(const Probe& p) {
  std::string text = describe_truth(format_truth(p.truth)).certificate;
  if (p.truth.verdict == Verdict::disjoint)
    return "They are disjoint. " + text + " " +
           fmt::format("The gap is between {} and {} wide.", format_double(p.distance.lo),
                       format_double(p.distance.hi));
  if (p.truth.verdict == Verdict::touching) return "They touch, and solids are closed: they meet. " + text;
  return "They overlap. " + text + " " +
         fmt::format("To part them one of them must move by between {} and {}.",
                     format_double(-p.distance.hi), format_double(-p.distance.lo));
}

/// Prisms are asked in place of cylinders.
std::string hull_in_words(const LibraryCall& call, const Probe& p) {
  if (call.settings.find("btConvexHullShape") == std::string_view::npos) return {};
  if (p.answer.verdict == Verdict::disjoint)
    return "\nThe hulls asked are prisms around the cylinders: where the cylinders meet, so do the hulls.\n";
  return "\nThe hulls asked are prisms within the cylinders: where the cylinders are apart, so are the "
         "hulls.\n";
}

/// What a reader might think of first: is this not within the tolerance?
std::string tolerance_in_words(const Probe& p, const Claim& claim) {
  if (p.answer.status != Status::answered || claim.absolute == 0) return {};
  const bool within = p.finding->severity == Severity::resolution;
  return fmt::format("\nThe tolerance that we found stated is a length of {} ({}); this is {} it.\n",
                     format_double(claim.absolute), one_line(claim.source), within ? "within" : "beyond");
}

std::string depth_note(const Probe& p, const Claim& claim) {
  if (p.finding->kind == FindingKind::distance_outside && shows_distance(p, claim))
    return " and that the distance told is impossible";
  if (p.truth.verdict == Verdict::intersecting)
    return " (the depth comes from a search with interval arithmetic, which it does not repeat)";
  return {};
}

std::string issue(const LibraryCall& call, const Probe& p, const Method& method) {
  const bool ends = p.finding->kind == FindingKind::crash || p.finding->kind == FindingKind::exception ||
                    p.finding->kind == FindingKind::hang;
  std::string text = fmt::format("# {}\n\n", title(call, p));
  text += fmt::format("`{}` of {} {}, {}.\n\n", call.call, call.library, one_line(method.version()),
                      call.settings);
  text +=
      "**What was asked.** Do these two solid cylinders meet? Heights are full heights; all numbers are "
      "exact doubles.\n\n";
  text += "| | centre | axis | radius | height |\n|---|---|---|---|---|\n";
  text += row("a", p.pair.a) + row("b", p.pair.b);
  text += fmt::format("\n**What came back.** {}\n", came_back(p));
  text += fmt::format("\n**What is true, and why.** {}\n", truth_in_words(p));
  text += hull_in_words(call, p) + tolerance_in_words(p, method.claim());
  text += fmt::format(
      "\nNobody needs to be trusted with this: `python3 exact.py` (standard library only) proves the verdict "
      "in rational arithmetic{}. It does so for the axes above and, where they are not of unit length, for "
      "the rounded ones that the library gets.\n",
      depth_note(p, method.claim()));
  text += fmt::format(
      "\n**How to see it.** `sh build.sh` builds and runs `reproduce.cpp`, which needs only {} (on Debian: "
      "`apt install g++ pkg-config {}`)",
      call.library, call.packages);
  text += ends ? "; it ends as told above.\n"
               : "; it prints the answer and exits with 1 while the answer is wrong, 0 once it is right.\n";
  text += fmt::format("\n    c++ {} reproduce.cpp -o reproduce {}\n", compiler_options, call.flags);
  return text +
         "\nThank you for the library. We found this by cross-examining several libraries on the same "
         "pairs and proving each answer right or wrong.\n";
}

std::string build(const LibraryCall& call, FindingKind kind) {
  return fmt::format(
      "#!/bin/sh\n# Builds reproduce.cpp and runs it. On Debian: apt install g++ pkg-config {}\nset -e\n"
      "cd -- \"$(dirname -- \"$0\")\"\n"
      "${{CXX:-c++}} {} reproduce.cpp -o reproduce {}\nexec {}./reproduce\n",
      call.packages, compiler_options, call.flags, kind == FindingKind::hang ? "timeout 10 " : "");
}

void write_file(const fs::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(file.string() + " cannot be written");
}

}  // namespace

Export make_export(std::span<const std::unique_ptr<Method>> methods, std::string_view name, FindingKind kind,
                   const Pair& pair) {
  const auto& method = find_method(methods, name);
  const LibraryCall* call = find_library_call(name);
  if (call == nullptr)
    throw std::invalid_argument(
        fmt::format("no program can be written for '{}': only for FCL, Bullet, "
                    "libccd, ODE and MuJoCo",
                    name));
  if (!program_shows(kind))
    throw std::invalid_argument(fmt::format("no program can show a finding of kind {}", to_string(kind)));
  const Probe asked = probe_one(method, pair);
  if (!asked.fails(kind))
    throw std::invalid_argument(fmt::format("{} has no {} on this pair today: it says {}", name,
                                            to_string(kind), format_method_answer(asked.answer)));
  if (!asked.decided())
    throw std::invalid_argument("what is true of this pair could not be proved: there is nothing to send");
  return {reproducing_program(*call, asked, *method), build(*call, kind), exact_check(asked, method->claim()),
          issue(*call, asked, *method)};
}

void write_export(const Export& files, const std::string& folder) {
  std::error_code fault;
  fs::create_directories(folder, fault);
  if (fault) throw std::runtime_error(folder + ": " + fault.message());
  const fs::path into(folder);
  write_file(into / "reproduce.cpp", files.program);
  write_file(into / "build.sh", files.build);
  write_file(into / "exact.py", files.check);
  write_file(into / "issue.md", files.issue);
  for (const char* script : {"build.sh", "exact.py"})
    fs::permissions(into / script, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                    fs::perm_options::add, fault);
}

}  // namespace cyl
