// SPDX-License-Identifier: MIT
#include "reports/export/export.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <cctype>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "base/files.hpp"
#include "base/safe_text.hpp"
#include "base/usage_error.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/trial/finding_text.hpp"
#include "oracles/trial/mechanism.hpp"
#include "reports/export/export_check.hpp"
#include "reports/export/export_program.hpp"
#include "reports/export/pair_in_words.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

bool within_claim(const Trial& p) { return p.finding()->severity == Severity::resolution; }

/// The library or guest that was asked, and how to ask it again.
struct Recipient {
  std::string what;          ///< name in titles: `fcl::collide`, or the guest's name
  std::string whom;          ///< "`fcl::collide` of FCL 0.7.0, gjk_tolerance 1e-6"
  std::string hulls = {};    ///< the solids that replace cylinders in the question, if any do
  std::string how;           ///< steps that show the answer
  std::string closing = {};  ///< last lines of the issue
  AxesGiven axes;
  Export files;  ///< what these steps need
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
      return fmt::format("{} returns no usable number for {}", what, solids);
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
    case FindingKind::crash:
      return fmt::format("{} aborts on {}", what, solids);
    default:
      return fmt::format("{}: {} for {}", what, to_string(p.finding()->kind), solids);
  }
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
      return fmt::format("A signed distance of {}{}.", a.at_least ? "at least " : "",
                         format_double(a.distance));
    case FindingKind::non_finite:
      return a.status == Status::failed ? fmt::format("Numbers that are not finite: {}.", one_line(a.reason))
                                        : fmt::format("A signed distance of {}.", format_double(a.distance));
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
  if (is_box(p.pair.a) && is_box(p.pair.b)) return {};
  if (p.answer().verdict == Verdict::disjoint)
    return "\nThe hull of a cylinder is a prism around it. If the solids meet, so do the hulls.\n";
  return "\nThe hull of a cylinder is a prism inside it. If the solids are disjoint, so are the hulls.\n";
}

/// Answers the first question of a reader: is this not within the tolerance?
std::string tolerance_in_words(const Trial& p, const Claim& claim) {
  const char* const stated = claim.assumed ? "assumed" : "stated";
  if (p.answer().status != Status::answered || (claim.absolute == 0 && claim.relative == 0)) return {};
  const bool within = within_claim(p), length_only = claim.relative == 0;
  const std::string tolerance =
      length_only ? fmt::format("a length of {}", format_double(claim.absolute))
                  : fmt::format("{} of the size plus a length of {}", format_double(claim.relative),
                                format_double(claim.absolute));
  if (p.finding()->kind == FindingKind::distance_outside)
    return fmt::format("\nThe {} tolerance of a distance is {} ({}). The error of this one is {} it.\n",
                       stated, tolerance, one_line(claim.source), within ? "within" : "beyond");
  if (length_only)
    return fmt::format("\nThe {} tolerance is {} ({}). This pair is {} it.\n", stated, tolerance,
                       one_line(claim.source), within ? "within" : "beyond");
  return fmt::format(
      "\nThe {} claim: answers are always right if the gap or overlap exceeds {} ({}). This pair is {} it.\n",
      stated, tolerance, one_line(claim.source), within ? "below" : "above");
}

/// Writes a note if the library asks our support function.
std::string sums_in_words(const Method& method, const Trial& p) {
  const auto depends = depends_on_last_bit(method.name(), p.finding()->kind, p.pair);
  if (!depends) return {};
  return *depends
             ? "\nThe answer depends on the last bit. It is right if the sums of the support function have "
               "another order.\n"
             : "\nThe answer is also wrong if the sums of the support function have another order.\n";
}

std::string depth_note(const Trial& p, const Claim& claim) {
  if (p.fails(FindingKind::distance_outside))
    return shows_distance(p, claim)
               ? " and that the returned distance is impossible"
               : " only. A search with interval arithmetic proved that the returned distance is wrong";
  if (p.truth.verdict == Verdict::intersecting)
    return " (the depth comes from a search with interval arithmetic, which it does not repeat)";
  return {};
}

/// Returns the system that gave the answer: "Linux x86_64".
std::string system_in_words() {
  utsname system;
  return uname(&system) == 0 ? fmt::format("{} {}", system.sysname, system.machine) : "";
}

/// The headings are the ones that trackers request in a bug report.
std::string issue(const Recipient& to, const Trial& p, const Method& method) {
  std::string text = fmt::format("# {}\n\n### Library and version\n\n{}. {}.\n\n",
                                 what_happened(to, p) + (within_claim(p) ? ", within its tolerance" : ""),
                                 to.whom, system_in_words());
  if (within_claim(p))
    text +=
        "The claim quoted below allows this answer, because the solids are so close to touching. It may "
        "still "
        "be of interest.\n\n";
  text += "### Question\n\n" + question_of(p.pair);
  text += fmt::format("\n### Actual result\n\n{}\n", returned_text(p, method));
  text += fmt::format("\n### Expected result\n\n{}\n", truth_in_words(p));
  text += to.hulls + tolerance_in_words(p, method.claim()) + sums_in_words(method, p);
  const bool repeats = !p.fails(FindingKind::distance_outside) || shows_distance(p, method.claim());
  text += fmt::format(
      "\n{}`python3 exact.py` (standard library only) proves the verdict in rational arithmetic{}.{}\n",
      repeats ? "You can check this yourself. " : "", depth_note(p, method.claim()),
      to.axes == AxesGiven::of_unit_length
          ? " It does so for the axes above. If these are not of unit length, it does so for the "
            "rounded axes that the library gets too."
          : "");
  return text + fmt::format("\n### Steps to reproduce\n\n{}\n", to.how) + to.closing;
}

/// A pair with less margin, in claims, is near the edge of the claim.
constexpr double edge_margin = 10;

bool ends(const Trial& p) {
  return p.fails(FindingKind::crash) || p.fails(FindingKind::exception) || p.fails(FindingKind::hang);
}

std::string build(const LibraryCall& call, FindingKind kind) {
  return fmt::format(
      "#!/bin/sh\n# Builds reproduce.cpp and runs it. On Debian: apt install g++ pkg-config {}\nset -e\n"
      "cd -- \"$(dirname -- \"$0\")\"\n"
      "${{CXX:-c++}} {} reproduce.cpp -o reproduce {}\nexec {}./reproduce\n",
      call.packages, compiler_options, call.flags, kind == FindingKind::hang ? "timeout 10 " : "");
}

constexpr const char* thanks =
    "\nThank you for the library. We found this by cross-examining several libraries on the same pairs and "
    "proving each answer right or wrong.\n";

Recipient ask_library(const LibraryCall& call, const Trial& p, const Method& method) {
  return {
      .what = call.call,
      .whom = fmt::format("`{}` of {} {}, {}", call.call, call.library, one_line(method.version()),
                          call.settings),
      .hulls = hull_in_words(call, p),
      .how = fmt::format(
          "`sh build.sh` builds and runs `reproduce.cpp`, which needs only {} (on Debian: "
          "`apt install g++ pkg-config {}`). {}\n\n    c++ {} reproduce.cpp -o reproduce {}",
          call.library, call.packages,
          ends(p)
              ? "It ends as described above."
              : "It prints the answer. Its exit code is 1 while the answer is wrong, and 0 once it is right.",
          compiler_options, call.flags),
      .closing = thanks,
      .axes = AxesGiven::of_unit_length,
      .files = {{"reproduce.cpp", reproducing_program(call, p, method)},
                {"build.sh", build(call, p.finding()->kind)}}};
}

/// Returns a text without the folders of this machine in front of files.
std::string without_folders(std::string text, const Guest& guest) {
  std::error_code none;
  std::vector<fs::path> folders{
      guest.kind == GuestKind::plugin ? fs::path(guest.what).parent_path() : fs::path(guest.folder),
      fs::current_path(none)};
  std::istringstream words(guest.what);
  for (fs::path word; words >> word;)
    if (word.is_absolute() && fs::exists(word, none)) folders.push_back(word.parent_path());
  for (const fs::path& folder : folders) {
    const std::string prefix = folder.string() + '/';
    if (!folder.is_absolute() || prefix == "//") continue;
    for (std::size_t at = 0; (at = text.find(prefix, at)) != text.npos;) {
      if (at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0)
        ++at;  // in the middle of another path
      else
        text.erase(at, prefix.size());
    }
  }
  return text;
}

Recipient ask_guest(const Guest& guest, const Trial& p, const Method& method) {
  Guest elsewhere = guest;
  elsewhere.what = without_folders(guest.what, guest);
  const std::string kind = guest.kind == GuestKind::plugin ? "plug-in" : "program";
  const Upstream& upstream = guest.upstream;
  if (const std::string script = reproducing_script(upstream, elsewhere.what, p, method.claim());
      !script.empty()) {
    const std::string package = upstream.install.substr(upstream.install.rfind(' ') + 1);
    Export files{{"reproduce.sh", script}, {"case.jsonl", format_pair(p.pair) + '\n'}};
    for (const fs::path file : upstream.files) files[file.filename()] = read_file(file);
    return {.what = upstream.call,
            .whom = fmt::format("`{}` of {}, called by `{}`", upstream.call, package, elsewhere.what),
            .how = fmt::format(
                "`sh reproduce.sh` installs {} into its folder and asks it about `case.jsonl`. "
                "Its exit code is 1 while the answer is wrong, and 0 once it is right.{}",
                package, package.starts_with("@mujoco/") ? " It writes the MJCF to `model.xml`." : ""),
            .closing = thanks,
            .axes = AxesGiven::as_they_are,
            .files = std::move(files)};
  }
  return {.what = guest.name,
          .whom = fmt::format("`{}` {}: a {}, `{}`", guest.name, one_line(method.version()), kind,
                              elsewhere.what),
          .how = fmt::format(
              "With daylight, in a folder that has the {} and `case.jsonl`:\n\n    {}\n\n{}", kind,
              command_for("daylight", "case.jsonl", elsewhere),
              within_claim(p)
                  ? "It prints the answer, with \"within its claim\" while it is wrong. The exit code is 0, "
                    "because the claim allows this answer."
                  : "The exit code is 2 while the answer is wrong beyond the claim, and 0 once it is right."),
          .axes = AxesGiven::as_they_are,
          .files = {{"case.jsonl", format_pair(p.pair) + '\n'}}};
}

/// Whether a guest's answer to the pair alone shows a finding of this kind.
bool one_call_shows(FindingKind kind) {
  return kind != FindingKind::nondeterminism && kind != FindingKind::state_dependent &&
         kind != FindingKind::undecided_truth;
}

}  // namespace

std::string command_for(const std::string& daylight, const std::string& file, const Guest& guest) {
  return fmt::format("{} replay {} --methods {} {}", daylight, shell_quoted(file), shell_quoted(guest.name),
                     options_for(guest));
}

bool is_clear(const Trial& asked, const Claim& claim) {
  const double size = size_of(asked.pair);
  return asked.decided() && asked.finding() && !within_claim(asked) && asked.finding()->margin &&
         asked.finding()->margin->lo * size >= edge_margin * reach(claim, size);
}

std::string refusal(std::string_view name, FindingKind kind, const Pair& pair, bool is_guest) {
  if (find_library_call(name) == nullptr && !is_guest)
    return fmt::format("export knows guests and FCL, Bullet, libccd, ODE and MuJoCo, but not '{}'", name);
  if (!(is_guest ? one_call_shows(kind) : program_shows(kind)))
    return fmt::format("one call cannot show a finding of kind {}", to_string(kind));
  if (is_guest || program_takes(find_library_call(name)->library, pair)) return {};
  return fmt::format("no program of {} has these solids: daylight check --method {} asks about the pair",
                     find_library_call(name)->library, name);
}

Export make_export(std::span<const std::unique_ptr<Method>> methods, std::string_view name, FindingKind kind,
                   const Pair& pair, const Guest* guest) {
  const auto& method = find_method(methods, name);
  const LibraryCall* call = find_library_call(name);
  if (std::string why = refusal(name, kind, pair, guest != nullptr); !why.empty()) throw UsageError(why);
  Trial asked = try_method(method, pair);
  if (!asked.fails(kind))
    throw UsageError(fmt::format("{} has no {} on this pair now: it answers {}", name, to_string(kind),
                                 format_method_answer(asked.answer())));
  if (!asked.decided())
    throw UsageError("the referee could not decide this pair, so there is nothing to send");
  if (guest) asked.answers[0].set_reason(without_folders(asked.answers[0].reason, *guest));
  Recipient to = guest ? ask_guest(*guest, asked, *method) : ask_library(*call, asked, *method);
  to.files["exact.py"] = exact_check(asked, method->claim(), to.axes);
  to.files["issue.md"] = issue(to, asked, *method);
  return std::move(to.files);
}

void write_export(const Export& files, const std::string& folder) {
  std::error_code fault;
  fs::create_directories(folder, fault);
  if (fault) throw std::runtime_error(folder + ": " + fault.message());
  for (const auto& [name, text] : files) {
    const fs::path file = fs::path(folder) / name;
    write_file(file, text);
    if (text.starts_with("#!"))
      fs::permissions(file, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                      fs::perm_options::add, fault);
  }
}

}  // namespace cyl
