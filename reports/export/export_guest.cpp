// SPDX-License-Identifier: MIT
#include "reports/export/export_guest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <system_error>

#include "base/json.hpp"
#include "base/safe_text.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/contained.hpp"
#include "reports/export/export_program.hpp"
#include "reports/export/linked_libraries.hpp"
#include "reports/export/node_program.hpp"
#include "reports/export/program_text.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// Seconds before a program that does not return is ended, as in a campaign.
constexpr auto patience = std::chrono::duration_cast<std::chrono::seconds>(Caps{}.call_wall).count();

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

/// Returns eight numbers, or nine if one of the solids is rounded.
std::string numbers_in_c(const Cylinder& c, const Pair& of) {
  return listed(numbers_of(c).data(), is_rounded(of) ? cylinder_number_count : core_number_count);
}

bool apart(const Trial& asked) { return asked.truth.verdict == Verdict::disjoint; }

/// Returns the least and the greatest distance that the claim allows.
Enclosure allowed(const Trial& asked, const Claim& claim) {
  const double tolerance = reach(claim, size_of(asked.pair));
  const Enclosure real = asked.truth.verdict == Verdict::touching ? Enclosure{0, 0} : asked.distance;
  return {real.lo - tolerance, real.hi + tolerance};
}

std::string wrong_in_c(const Trial& asked, const Claim& claim) {
  switch (asked.finding()->kind) {
    case FindingKind::distance_outside: {
      const Enclosure real = allowed(asked, claim);
      return fmt::format("!isnan(more[0]) && !(more[0] >= {} && more[0] <= {})", bound(real.lo),
                         bound(real.hi));
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
    case FindingKind::reported:
      return "said == DAYLIGHT_FAILED";
    case FindingKind::exception:
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
      return fmt::format("'distance' in said and not {} <= said['distance'] <= {}", bound(real.lo),
                         bound(real.hi));
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
    case FindingKind::reported:
      return "'error' in said";
    case FindingKind::exception:
    case FindingKind::crash:
    case FindingKind::hang:
    case FindingKind::malformed:
    case FindingKind::non_finite:  // JSON has no such number
      return "False";
    case FindingKind::wrong_invalid:
      return "verdict == 'invalid'";
    case FindingKind::wrong_touching:
      return "verdict == 'touching'";
    default:
      return apart(asked) ? "verdict in ('intersecting', 'touching')" : "verdict == 'disjoint'";
  }
}

/// Returns a literal of Python. A string of JSON in ASCII is one.
std::string python_literal(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

std::vector<std::string> words_in(const std::string& command) {
  std::vector<std::string> words;
  std::istringstream in(command);
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// Whether the folder is on PATH, so that its programs are found by their names.
bool on_path(const fs::path& folder) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string each; std::getline(folders, each, ':');)
    if (fs::path(each).lexically_normal() == folder.lexically_normal()) return true;
  return false;
}

/// Returns the form in which a file that a command names is sent. A program of the system is sent by its
/// name alone, without a file. Other words return nothing.
std::optional<SentFile> file_of_word(const Guest& guest, const std::string& word) {
  const fs::path path = fs::path(guest.folder) / word;
  std::error_code fault;
  if (!fs::is_regular_file(path, fault)) return {};
  if (fs::path(word).is_absolute() && on_path(path.parent_path())) return SentFile{"", file_name(word)};
  const bool below =
      fs::path(word).is_relative() && !fs::path(word).lexically_normal().string().starts_with("..");
  return SentFile{path.string(), below ? fs::path(word).lexically_normal().string() : file_name(word)};
}

/// Returns the command for the folder that is sent. If blanks do not divide its words, only the folder in
/// which it ran is removed.
std::string sent_command(const Guest& guest) {
  std::string sent = guest.what;
  for (const std::string& word : words_in(guest.what)) {
    const auto file = file_of_word(guest, word);
    if (!file || file->name == word) continue;
    if (const auto at = sent.find(word); at != sent.npos) sent.replace(at, word.size(), file->name);
  }
  return without_folders(sent, guest);
}

/// Returns the files that a command names.
std::vector<SentFile> programs_of(const Guest& guest) {
  std::vector<SentFile> programs;
  for (const std::string& word : words_in(guest.what))
    if (const auto sent = file_of_word(guest, word); sent && !sent->file.empty()) programs.push_back(*sent);
  return programs;
}

/// Returns the lines of build.sh that install what Node.js programs import.
std::string npm_install(const Guest& guest) {
  std::string lines;
  for (const SentFile& program : programs_of(guest)) {
    std::string packages;
    for (const std::string& package : npm_packages({&program, 1})) packages += ' ' + shell_quoted(package);
    const std::string folder = shell_quoted(fs::path(program.name).parent_path().string());
    if (!packages.empty())
      lines +=
          fmt::format("[ -d \"$here\"/{0}/node_modules ] || npm install --silent --prefix \"$here\"/{0}{1}\n",
                      folder, packages);
  }
  return lines;
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
  Words words{{"truth", truth_for_guest(asked)}, {"WRONG", std::string(judgement(*asked.finding()))}};
  if (guest.kind == GuestKind::command) {
    words["pair"] = python_literal(format_pair(asked.pair));
    words["patience"] = std::to_string(patience);
    words["wrong"] = wrong_in_python(asked, claim);
    return filled(template_text("command.py.in"), words);
  }
  words["method"] = guest.method;
  words["a"] = numbers_in_c(asked.pair.a, asked.pair);
  words["b"] = numbers_in_c(asked.pair.b, asked.pair);
  words["before"] =
      ends_itself(asked.finding()->kind) || asked.finding()->kind == FindingKind::exception
          ? fmt::format("  puts(\"calling the method; it failed before with: {}\");\n  fflush(stdout);\n",
                        to_string(asked.finding()->kind))
          : "";
  words["helper"] = asked.finding()->kind == FindingKind::non_finite ? some_of_three : "";
  words["wrong"] = wrong_in_c(asked, claim);
  return filled(template_text("plugin.c.in"), words);
}

// The script looks for a plug-in under its given name, then beside the program, and else builds it from its
// source. Paths of this machine are not used, because others receive the folder.
std::string guest_build(const Guest& guest, FindingKind kind, std::span<const std::string> sources) {
  std::string text = "#!/bin/sh\nset -e\nhere=$(cd -- \"$(dirname -- \"$0\")\" && pwd)\n";
  if (guest.kind == GuestKind::command)
    return text + npm_install(guest) +
           fmt::format(
               "# sh build.sh [COMMAND]: asks the program in this folder. COMMAND or "
               "$DAYLIGHT_COMMAND is run "
               "in the current folder instead.\n"
               "[ $# -gt 0 ] || set -- \"${{DAYLIGHT_COMMAND:-}}\"\n"
               "[ -n \"$1\" ] || {{ cd -- \"$here\"; set -- {}; }}\n"
               "exec python3 \"$here/reproduce.py\" \"$1\"\n",
               shell_quoted(sent_command(guest)));
  const std::string library = shell_quoted(file_name(guest.what));
  text += fmt::format(
      "# sh build.sh [FILE]: builds reproduce.c and asks the plug-in FILE, else $DAYLIGHT_PLUGIN, else {}.\n"
      "file=${{1:-${{DAYLIGHT_PLUGIN:-$here/{}}}}}\n",
      library, library);
  if (!sources.empty())
    text += fmt::format(
        "# Builds the plug-in if it is missing. CXXFLAGS and LIBS add what it needs.\n"
        "[ -e \"$file\" ] || ${{CXX:-c++}} -O2 -shared -fPIC -I \"$here\" ${{CXXFLAGS:-}} \"$here/\"{} -o "
        "\"$file\" ${{LIBS:-{}}}\n",
        shell_quoted(file_name(sources.front())), linked_libraries_of(guest.what));
  return text + fmt::format(
                    "case $file in /*) ;; *) file=$PWD/$file ;; esac\n"
                    "${{CC:-cc}} -O2 \"$here/reproduce.c\" -o \"$here/reproduce\" -ldl -lm\n"
                    "exec {}\"$here/reproduce\" \"$file\"\n",
                    kind == FindingKind::hang ? fmt::format("timeout {} ", patience) : "");
}

std::vector<SentFile> guest_files(const Guest& guest, std::span<const std::string> sources) {
  std::vector<SentFile> files;
  for (const std::string& source : sources) files.push_back({source, file_name(source)});
  if (guest.kind == GuestKind::plugin) {
    if (sources.empty()) files.push_back({guest.what, file_name(guest.what)});
    return files;
  }
  for (const SentFile& program : programs_of(guest))
    for (const std::string& file : node_program(program.file).files)
      files.push_back({fs::path(program.file).replace_filename(file).string(),
                       fs::path(program.name).replace_filename(file).string()});
  return files;
}

std::set<std::string> npm_packages(std::span<const SentFile> files) {
  std::set<std::string> packages;
  for (const SentFile& file : files)
    for (const std::string& package : node_program(file.file).packages) packages.insert(package);
  return packages;
}

std::string guest_in_words(const Guest& guest) {
  return guest.kind == GuestKind::plugin ? "a plug-in, " + file_name(guest.what)
                                         : "a program, " + sent_command(guest);
}

std::string without_folders(std::string text, const Guest& guest) {
  std::error_code none;
  for (const fs::path& folder :
       {fs::path(guest.what).parent_path(), fs::path(guest.folder), fs::current_path(none)}) {
    const std::string prefix = folder.string() + '/';
    if (!folder.is_absolute() || prefix == "//") continue;
    for (std::size_t at = 0; (at = text.find(prefix, at)) != text.npos;) text.erase(at, prefix.size());
  }
  return text;
}

}  // namespace cyl
