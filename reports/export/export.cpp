// SPDX-License-Identifier: MIT
#include "reports/export/export.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "base/safe_text.hpp"
#include "base/usage_error.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/trial/finding_text.hpp"
#include "oracles/trial/hangs_on_sums.hpp"
#include "reports/export/export_check.hpp"
#include "reports/export/export_guest.hpp"
#include "reports/export/export_program.hpp"
#include "reports/export/framework_test_text.hpp"
#include "reports/export/linked_libraries.hpp"
#include "reports/export/program_text.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

std::string triple(const Vector3& v) {
  return fmt::format("({}, {}, {})", format_double(v[0]), format_double(v[1]), format_double(v[2]));
}

std::string row(const char* name, const Cylinder& c, bool rounded) {
  return fmt::format("| {} | {} | {} | {} | {} |{}\n", name, triple(c.center), triple(c.axis),
                     format_double(c.radius), format_double(c.height),
                     rounded ? fmt::format(" {} |", format_double(c.rounding)) : "");
}

/// Returns "two spheres", "a capsule and a rounded cylinder".
std::string solids_in_words(const Pair& pair) {
  const auto word = [](const Cylinder& c) {
    return std::string(to_string(kind_of(c))) + (kind_of(c) == SolidKind::rounded ? " cylinder" : "");
  };
  const std::string a = word(pair.a), b = word(pair.b);
  return a == b ? "two " + a + 's' : "a " + a + " and a " + b;
}

bool within_claim(const Trial& p) { return p.finding()->severity == Severity::resolution; }

/// The library or guest that was asked, and how to ask it again.
struct Recipient {
  std::string what;     ///< name in titles: `fcl::collide`, or the guest's name
  std::string whom;     ///< "`fcl::collide` of FCL 0.7.0, gjk_tolerance 1e-6"
  std::string hulls;    ///< the solids that replace cylinders in the question, if any do
  std::string how;      ///< steps that show the answer
  std::string closing;  ///< last lines of the issue
  AxesGiven axes = AxesGiven::of_unit_length;
  std::string program_name, program, build;
  std::vector<SentFile> files;
};

std::string what_happened(const Recipient& to, const Trial& p) {
  const std::string_view what = to.what;
  const std::string solids = solids_in_words(p.pair);
  switch (p.finding()->kind) {
    case FindingKind::wrong_disjoint:
      return fmt::format(
          "{} misses {} that {}", what, solids,
          p.truth.verdict == Verdict::touching ? "touch" : fmt::format("overlap by {:.3g}", -p.distance.hi));
    case FindingKind::wrong_intersecting:
      return fmt::format("{} reports {} that are {} as colliding", what, solids, distance_in_words(p));
    case FindingKind::distance_outside:
      return fmt::format("{} gives a distance of {} for {} that are {}", what, said_distance(p), solids,
                         distance_in_words(p));
    case FindingKind::non_finite:
      return fmt::format("{} returns numbers that are not finite for {}", what, solids);
    case FindingKind::bad_witness:
      return fmt::format("{} returns a vector for {} that does not prove its answer", what, solids);
    case FindingKind::wrong_touching:
      return fmt::format("{} reports {} as touching that overlap by {:.3g}", what, solids, -p.distance.hi);
    case FindingKind::wrong_invalid:
      return fmt::format("{} rejects {} that are valid", what, solids);
    case FindingKind::malformed:
      return fmt::format("{} returns a meaningless answer for {}", what, solids);
    case FindingKind::exception:
      return fmt::format("{} throws on {}", what, solids);
    case FindingKind::reported:
      return fmt::format("{} reports a failure on {} that {}", what, solids,
                         p.meets() ? "meet" : fmt::format("are {}", distance_in_words(p)));
    case FindingKind::hang:
      return fmt::format("{} hangs on {}", what, solids);
    default:
      return fmt::format("{} aborts on {}", what, solids);
  }
}

std::string title(const Recipient& to, const Trial& p) {
  return what_happened(to, p) + (within_claim(p) ? ", within its tolerance" : "");
}

std::string returned_text(const Trial& p, const Method& method) {
  const MethodAnswer& a = p.answer();
  const std::string miss = miss_in_words(p.pair, a);
  switch (p.finding()->kind) {
    case FindingKind::exception:
      return fmt::format("An exception: `{}`.", one_line(a.reason));
    case FindingKind::reported:
      return fmt::format("No verdict, but a failure with the reason `{}`.", one_line(a.reason));
    case FindingKind::crash:
      return fmt::format("The process ended: `{}`.", one_line(a.reason));
    case FindingKind::hang:
      return fmt::format("Nothing within {} s of CPU time. Then the process was killed.",
                         std::chrono::duration<double>(cpu_cap_of(method)).count());
    case FindingKind::distance_outside:
      return fmt::format("A signed distance of {}.", format_double(a.distance));
    case FindingKind::non_finite:
      return fmt::format("Numbers that are not finite: {}.", one_line(a.reason));
    case FindingKind::bad_witness:
      return fmt::format(
          "{}{}, which is not {}{}.",
          a.has_distance ? fmt::format("A distance of {}, and ", format_double(a.distance)) : "",
          triple({a.head[0], a.head[1], a.head[2]}),
          a.witness == CertificateKind::point ? "in both" : "square to a plane between them",
          miss.empty() ? "" : ": " + miss);
    case FindingKind::malformed:
      return fmt::format("A meaningless answer: `{}`.", one_line(a.reason));
    case FindingKind::wrong_invalid:
      return "The pair is invalid.";
    case FindingKind::wrong_touching:
      return "The solids touch.";
    default:
      return a.verdict == Verdict::disjoint ? "No collision." : "A collision.";
  }
}

std::string truth_in_words(const Trial& p) {
  std::string text = in_words(p.truth.certificate);
  if (p.truth.verdict == Verdict::disjoint)
    return "They are disjoint. " + text + " The gap is " +
           (std::isfinite(p.distance.hi)
                ? fmt::format("between {} and {} wide.", format_double(p.distance.lo),
                              format_double(p.distance.hi))
                : fmt::format("wider than {}.", format_double(p.distance.lo)));
  if (p.truth.verdict == Verdict::touching) return "They touch. Solids are closed, so they meet. " + text;
  return "They overlap. " + text + " " +
         fmt::format("To separate them, one of them must move by between {} and {}.",
                     format_double(-p.distance.hi), format_double(-p.distance.lo));
}

/// Reports if prisms replace the cylinders in the question.
std::string hull_in_words(const LibraryCall& call, const Trial& p) {
  if (call.settings.find("btConvexHullShape") == std::string_view::npos) return {};
  if (p.answer().verdict == Verdict::disjoint)
    return "\nThe hulls are prisms around the cylinders. If the cylinders meet, so do the hulls.\n";
  return "\nThe hulls are prisms inside the cylinders. If the cylinders are disjoint, so are the hulls.\n";
}

/// Answers the first question of a reader: is this not within the tolerance?
std::string tolerance_in_words(const Trial& p, const Claim& claim) {
  if (p.answer().status != Status::answered || (claim.absolute == 0 && claim.relative == 0)) return {};
  const bool within = within_claim(p);
  if (claim.relative > 0)
    return fmt::format(
        "\nThe claim: answers are right above a margin of {} of the size plus a length of {} ({}). This pair "
        "is {} "
        "it.\n",
        format_double(claim.relative), format_double(claim.absolute), one_line(claim.source),
        within ? "below" : "above");
  return fmt::format("\nThe stated tolerance is a length of {} ({}). This pair is {} it.\n",
                     format_double(claim.absolute), one_line(claim.source), within ? "within" : "beyond");
}

/// Writes a note if the library asks our support function.
std::string sums_in_words(const Method& method, const Trial& p) {
  const auto hangs = hangs_on_our_sums(method.name(), p.finding()->kind, p.pair);
  if (!hangs) return {};
  return *hangs
             ? "\nThe answer depends on the last bit. It is right if the sums of the support function have "
               "another order.\n"
             : "\nThe answer is also wrong if the sums of the support function have another order.\n";
}

std::string depth_note(const Trial& p, const Claim& claim) {
  if (p.finding()->kind == FindingKind::distance_outside && shows_distance(p, claim))
    return " and that the returned distance is impossible";
  if (p.finding()->kind == FindingKind::distance_outside)
    return " only. A search with interval arithmetic proved that the returned distance is wrong";
  if (p.truth.verdict == Verdict::intersecting)
    return " (the depth comes from a search with interval arithmetic, which it does not repeat)";
  return {};
}

std::string table_of(const Pair& pair) {
  const bool rounded = is_rounded(pair);
  return std::string("| | centre | axis | radius | height |") +
         (rounded ? " rounding |\n|---|---|---|---|---|---|\n" : "\n|---|---|---|---|---|\n") +
         row("a", pair.a, rounded) + row("b", pair.b, rounded);
}

std::string other_in_words(const Trial& p, const Trial& other) {
  const auto margin = [](const Trial& t) { return t.finding()->margin ? t.finding()->margin->lo : 0; };
  return fmt::format("\n**Another pair of the same cause** is {}. It fails there too. The solids are {}.\n\n",
                     margin(other) > margin(p) ? "the worst known" : "the simplest known",
                     distance_in_words(other)) +
         table_of(other.pair);
}

/// Returns the system that gave the answer: "Linux x86_64".
std::string system_in_words() {
  utsname system;
  return uname(&system) == 0 ? fmt::format("{} {}", system.sysname, system.machine) : "";
}

/// The headings are the ones that trackers request in a bug report.
std::string issue(const Recipient& to, const Trial& p, const Method& method, const Trial* other) {
  std::string text =
      fmt::format("# {}\n\n### Library and version\n\n{}. {}.\n\n", title(to, p), to.whom, system_in_words());
  if (within_claim(p))
    text +=
        "The claim quoted below allows this answer, because the solids are so close to touching. It may "
        "still "
        "be of interest.\n\n";
  text += fmt::format(
      "### Question\n\nDo these solids, {}, meet? Heights are full heights. {}All numbers are exact "
      "doubles.\n\n",
      solids_in_words(p.pair),
      is_rounded(p.pair) ? "A solid is all points within its rounding of the cylinder. " : "");
  text += table_of(p.pair);
  text += fmt::format("\n### Actual result\n\n{}\n", returned_text(p, method));
  text += fmt::format("\n### Expected result\n\n{}\n", truth_in_words(p));
  if (other) text += other_in_words(p, *other);
  text += to.hulls + tolerance_in_words(p, method.claim()) + sums_in_words(method, p);
  const bool repeats =
      p.finding()->kind != FindingKind::distance_outside || shows_distance(p, method.claim());
  text += fmt::format(
      "\n{}`python3 exact.py` (standard library only) proves the verdict in rational arithmetic{}.{}\n",
      repeats ? "You can check this yourself. " : "", depth_note(p, method.claim()),
      to.axes == AxesGiven::of_unit_length
          ? " It does so for the axes above. If these are not of unit length, it does so for the "
            "rounded axes that the library gets too."
          : "");
  return text + fmt::format("\n### Steps to reproduce\n\n{}\n", to.how) + to.closing;
}

constexpr std::string_view as_told = "It ends as described above.";
constexpr std::string_view by_its_exit =
    "It prints the answer. Its exit code is 1 while the answer is wrong, and 0 once it is right.";

/// A pair with less margin, in claims, is near the edge of the claim. Then another pair is shown with it.
constexpr double edge_margin = 10;

/// Whether the proved error is within the claim, or hardly more than the claim allows.
bool at_edge(const Trial& p, const Claim& claim) {
  if (within_claim(p)) return true;
  const double size = size_of(p.pair);
  return p.finding()->margin && p.finding()->margin->lo * size < edge_margin * reach(claim, size);
}

bool ends(const Trial& p) {
  return p.finding()->kind == FindingKind::crash || p.finding()->kind == FindingKind::exception ||
         p.finding()->kind == FindingKind::hang;
}

std::string build(const LibraryCall& call, FindingKind kind) {
  return fmt::format(
      "#!/bin/sh\n# Builds reproduce.cpp and runs it. On Debian: apt install g++ pkg-config {}\nset -e\n"
      "cd -- \"$(dirname -- \"$0\")\"\n"
      "${{CXX:-c++}} {} reproduce.cpp -o reproduce {}\nexec {}./reproduce\n",
      call.packages, compiler_options, call.flags, kind == FindingKind::hang ? "timeout 10 " : "");
}

Recipient ask_library(const LibraryCall& call, const Trial& p, const Method& method) {
  Recipient to;
  to.what = call.call;
  to.whom =
      fmt::format("`{}` of {} {}, {}", call.call, call.library, one_line(method.version()), call.settings);
  to.hulls = hull_in_words(call, p);
  to.how = fmt::format(
      "`sh build.sh` builds and runs `reproduce.cpp`, which needs only {} (on Debian: "
      "`apt install g++ pkg-config {}`). {}\n\n    c++ {} reproduce.cpp -o reproduce {}",
      call.library, call.packages, ends(p) ? as_told : by_its_exit, compiler_options, call.flags);
  to.closing =
      "\nThank you for the library. We found this by cross-examining several libraries on the same pairs and "
      "proving each answer right or wrong.\n";
  to.program_name = "reproduce.cpp";
  to.program = reproducing_program(call, p, method);
  to.build = build(call, p.finding()->kind);
  return to;
}

/// Returns "; this folder has its source: `mine.cpp`, to be linked with `-lmine`".
std::string sources_in_words(std::span<const SentFile> files, const std::string& flags) {
  std::string names;
  for (const SentFile& file : files) names += (names.empty() ? "`" : ", `") + file.name + '`';
  if (names.empty()) return "";
  return fmt::format("; this folder has its source: {}{}", names,
                     flags.empty() ? "" : ", to be linked with `" + flags + '`');
}

Recipient ask_guest(const Guest& guest, const Trial& p, const Method& method, const SentBeside& beside) {
  Recipient to;
  to.what = guest.name;
  to.files = guest_files(guest, beside.sources);
  to.whom = fmt::format("`{}` {}: {}{}", guest.name, one_line(method.version()), guest_in_words(guest),
                        sources_in_words(to.files, linked_libraries_of(guest.what)));
  to.axes = AxesGiven::as_they_are;
  to.program_name = guest_program_name(guest);
  const bool as_it_does = guest.kind == GuestKind::plugin && ends(p);
  const std::set<std::string> packages = npm_packages(to.files);
  to.how = fmt::format(
      "`sh build.sh` {}runs `{}`, which asks it without daylight. {}",
      packages.empty() ? "" : fmt::format("installs `{}` with npm, and ", fmt::join(packages, "`, `")),
      to.program_name, as_it_does ? as_told : by_its_exit);
  to.program = guest_program(guest, p, method.claim());
  to.build = guest_build(guest, p.finding()->kind, beside.sources);
  return to;
}

void write_file(const fs::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(file.string() + " cannot be written");
}

}  // namespace

Export make_export(std::span<const std::unique_ptr<Method>> methods, std::string_view name, FindingKind kind,
                   const Pair& pair, std::span<const Guest> guests, const SentBeside& beside) {
  const auto& method = find_method(methods, name);
  const auto guest =
      std::find_if(guests.begin(), guests.end(), [&](const Guest& g) { return g.name == name; });
  const bool is_guest = guest != guests.end();
  const LibraryCall* call = find_library_call(name);
  if (call == nullptr && !is_guest)
    throw UsageError(fmt::format(
        "export writes programs for guests and for FCL, Bullet, libccd, ODE and MuJoCo, but not for "
        "'{}'",
        name));
  if (!(is_guest ? guest_program_shows(kind) : program_shows(kind)))
    throw UsageError(fmt::format("no program can show a finding of kind {}", to_string(kind)));
  if (!is_guest && is_rounded(pair))
    throw UsageError("programs for packaged libraries do not support roundings: daylight check --method " +
                     std::string(name) + " asks about the pair");
  Trial asked = try_method(method, pair);
  if (!asked.fails(kind))
    throw UsageError(fmt::format("{} has no {} on this pair now: it answers {}", name, to_string(kind),
                                 format_method_answer(asked.answer())));
  if (!asked.decided())
    throw UsageError("the referee could not decide this pair, so there is nothing to send");
  std::optional<Trial> other;
  if (beside.worst && format_pair(*beside.worst) != format_pair(pair)) {
    other = try_method(method, *beside.worst);
    if (!other->fails(kind) || !other->decided() || !other->finding()->margin ||
        solids_in_words(other->pair) != solids_in_words(asked.pair))
      other.reset();
    else if (at_edge(asked, method->claim()) && !at_edge(*other, method->claim()))
      std::swap(asked, *other);
  }
  if (is_guest)
    for (Trial* t : {&asked, other ? &*other : nullptr})
      if (t) t->answers[0].set_reason(without_folders(t->answers[0].reason, *guest));
  Recipient how = is_guest ? ask_guest(*guest, asked, *method, beside) : ask_library(*call, asked, *method);
  std::string text = issue(how, asked, *method, other ? &*other : nullptr);
  Export files{std::move(how.program_name),
               std::move(how.program),
               std::move(how.build),
               exact_check(asked, method->claim(), how.axes),
               std::move(text),
               std::move(how.files)};
  if (!beside.framework.empty()) {
    files.test_name = framework_test_name(beside.framework);
    files.test = framework_test(beside.framework, asked, *method);
  }
  return files;
}

void write_export(const Export& files, const std::string& folder) {
  std::error_code fault;
  fs::create_directories(folder, fault);
  if (fault) throw std::runtime_error(folder + ": " + fault.message());
  const fs::path into(folder);
  write_file(into / files.program_name, files.program);
  write_file(into / "build.sh", files.build);
  write_file(into / "exact.py", files.check);
  write_file(into / "issue.md", files.issue);
  if (!files.test.empty()) write_file(into / files.test_name, files.test);
  if (files.program_name == "reproduce.c")
    write_file(into / "plugin.h", std::string(template_text("plugin.h")));
  for (const SentFile& sent : files.files) {
    fs::create_directories((into / sent.name).parent_path(), fault);
    fs::copy_file(sent.file, into / sent.name, fs::copy_options::overwrite_existing, fault);
    if (fault) throw std::runtime_error(sent.file + ", to be sent: " + fault.message());
  }
  for (const char* script : {"build.sh", "exact.py"})
    fs::permissions(into / script, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                    fs::perm_options::add, fault);
}

}  // namespace cyl
