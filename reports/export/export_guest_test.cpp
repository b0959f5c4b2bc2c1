// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/scratch_test.hpp"
#include "reports/export/export.hpp"
#include "reports/export/exported_folder_test.hpp"
#include "reports/export/node_program.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// A fault of a guest, chosen by the height of the first solid, and how its program ends.
struct Fault {
  FindingKind kind;
  bool meet;  ///< whether the solids meet
  const char *in_c, *in_shell;
  int status = 1;
};

const Fault faults[] = {
    {FindingKind::wrong_disjoint, true, "return 0;", R"(echo '{"verdict":"disjoint"}')"},
    {FindingKind::wrong_intersecting, false, "return 2;", R"(echo '{"verdict":"touching"}')"},
    {FindingKind::wrong_touching, true, "return 2;", R"(echo '{"verdict":"touching"}')"},
    {FindingKind::distance_outside, false, "more[0] = 100; return 0;",
     R"(echo '{"verdict":"disjoint","distance":100}')"},
    {FindingKind::bad_witness, false, "more[1] = more[3] = 0; more[2] = 1; return 0;",
     R"(echo '{"verdict":"disjoint","direction":[0,1,0]}')"},
    {FindingKind::bad_witness, true, "more[4] = more[5] = 0; more[6] = 0.1 + 50; return 1;",
     R"(echo '{"verdict":"intersecting","point":[0,0,[50,0.1]]}')"},
    {FindingKind::non_finite, false, "more[1] = 1; return 0;", nullptr},
    {FindingKind::reported, false, "return -2;", R"(echo '{"error":"no luck"}')"},
    {FindingKind::malformed, false, "return 9;", "echo loading"},
    {FindingKind::crash, false, "std::abort();", "exit 3", 134},
};

Pair asked_of(std::size_t fault) {
  const double height = static_cast<double>(fault + 1);
  return {{{0, 0, 0}, {0, 0, 2}, 1, height}, {{faults[fault].meet ? 1.0 : 4.0, 0, 0}, {0, 0, 1}, 1, 2}};
}

/// A plug-in and a program with these faults, in their own folder.
class Guests : Scratch {
 public:
  Guests() {
    std::ofstream c(folder / "faulty.cpp"), shell(folder / "faulty.sh");
    c << "#include <cstdlib>\n#include \"plugin.h\"\n"
         "static int ask(const double* a, const double*, double* more) {\n  switch (int(a[7])) {\n";
    shell << "while read -r q; do case $q in\n";
    for (std::size_t i = 0; i < std::size(faults); ++i) {
      c << "    case " << i + 1 << ": " << faults[i].in_c << '\n';
      if (faults[i].in_shell)
        shell << "*'\"height\":" << i + 1 << "},\"b\"'*) " << faults[i].in_shell << ";;\n";
    }
    c << "  }\n  return 0;\n}\n"
         "static const DaylightMethod faulty{DAYLIGHT_PLUGIN_ABI, \"faulty\", \"1\", 0, 0, 0, ask, 0};\n"
         "const DaylightMethod* daylight_method() { return &faulty; }\n";
    shell << "*) echo '{\"verdict\":\"disjoint\"}';; esac; done\n";
    c.close();
    shell.close();
    const std::string build = "cd " + shell_quoted(folder.string()) + " && c++ -shared -fPIC -w -I " +
                              shell_quoted(DAYLIGHT_SOURCE_DIR "/oracles") + " faulty.cpp -o faulty.so";
    if (std::system(build.c_str()) != 0) throw std::runtime_error("the plug-in is not built");
  }

  Guest plugin() const { return {GuestKind::plugin, "", (folder / "faulty.so").string(), ""}; }
  Guest command() const { return {GuestKind::command, "", "sh faulty.sh", folder.string()}; }
};

/// Opens a guest and gives it the name that it is called by.
std::vector<std::unique_ptr<Method>> opened(Guest& guest) {
  OpenedGuest found = std::move(open_guest(guest).front());
  guest = found.guest;
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::move(found.method));
  return methods;
}

void expect_every_fault_shown(Guest guest) {
  const auto methods = opened(guest);
  for (std::size_t i = 0; i < std::size(faults); ++i) {
    const bool plugin = guest.kind == GuestKind::plugin;
    if (!plugin && !faults[i].in_shell) continue;
    const Export files = make_export(methods, "faulty", faults[i].kind, asked_of(i), {&guest, 1});
    const Folder folder(files);
    const Ran program = folder.run("sh build.sh");
    EXPECT_EQ(program.status, plugin ? faults[i].status : 1) << i << ' ' << program.printed;
    EXPECT_EQ(has(program.printed, "WRONG"), program.status == 1) << i << ' ' << program.printed;
    const Ran proof = folder.run("python3 exact.py");
    EXPECT_EQ(proof.status, 0) << i << ' ' << proof.printed << files.check;
    const bool of_its_witness = faults[i].kind == FindingKind::bad_witness;
    EXPECT_EQ(has(proof.printed, "said"), of_its_witness || faults[i].kind == FindingKind::distance_outside)
        << i << ' ' << proof.printed;
    EXPECT_FALSE(has(files.check, "that the library gets")) << "a guest gets the axes as they are";
    EXPECT_TRUE(has(files.issue, "# faulty")) << files.issue;
  }
}

/// Whether a text holds a path of this machine, except that of the shell.
bool has_path(const std::string& text) {
  return has(text, fs::temp_directory_path().string() + '/') ||
         has(text, fs::current_path().string() + '/') || has(text, DAYLIGHT_SOURCE_DIR);
}

TEST(Export, NothingThatIsSentKnowsThisMachine) {
  const Guests guests;
  for (Guest guest : {guests.plugin(), guests.command()}) {
    if (guest.kind == GuestKind::command) guest.what = "/bin/sh " + guest.folder + "/faulty.sh";
    const auto methods = opened(guest);
    const Export files = make_export(methods, "faulty", FindingKind::reported, asked_of(7), {&guest, 1});
    for (const std::string* text : {&files.program, &files.build, &files.check, &files.issue})
      EXPECT_FALSE(has_path(*text)) << *text;
    ASSERT_EQ(files.files.size(), 1u);
    EXPECT_EQ(files.files[0].name, guest.kind == GuestKind::plugin ? "faulty.so" : "faulty.sh");
    EXPECT_TRUE(has(files.issue, "`" + files.files[0].name + "`")) << files.issue;
  }
}

TEST(Export, WordsOfAGuestLoseTheFoldersOfThisMachine) {
  const Guest guest{GuestKind::plugin, "mine", "/some/where/lib/libmine.so", ""};
  EXPECT_EQ(without_folders("/some/where/lib/gjk.cpp:30: Assertion `x' failed", guest),
            "gjk.cpp:30: Assertion `x' failed");
  EXPECT_EQ(without_folders("at " + fs::current_path().string() + "/x.c:1", guest), "at x.c:1");
}

TEST(Export, WhatAMethodReportsIsNotSaidToBeThrown) {
  const Guests guests;
  for (Guest guest : {guests.plugin(), guests.command()}) {
    const auto methods = opened(guest);
    const Export files = make_export(methods, "faulty", FindingKind::reported, asked_of(7), {&guest, 1});
    EXPECT_TRUE(files.issue.starts_with("# faulty reports a failure on two cylinders that are "))
        << files.issue;
    const bool command = guest.kind == GuestKind::command;
    EXPECT_TRUE(
        has(files.issue, command ? "with the reason `no luck`." : "with the reason `no reason given`."));
    for (const std::string* text : {&files.program, &files.issue}) {
      EXPECT_FALSE(has(*text, "throw")) << *text;
      EXPECT_FALSE(has(*text, "xception")) << *text;
    }
  }
}

TEST(Export, ItsSourceIsSentAndBuilt) {
  const Guests guests;
  Guest guest = guests.plugin();
  const auto methods = opened(guest);
  const std::string source = fs::path(guest.what).replace_extension(".cpp").string();
  const Export files =
      make_export(methods, "faulty", FindingKind::wrong_disjoint, asked_of(0), {&guest, 1}, {{source}, {}});
  EXPECT_TRUE(has(files.issue, "`faulty.cpp`")) << files.issue;
  const Folder folder(files);
  EXPECT_NE(folder.run("test -e faulty.so").status, 0) << "the library is built, not sent";
  const Ran program = folder.run("CXXFLAGS=-w sh build.sh");
  EXPECT_EQ(program.status, 1) << program.printed;
  EXPECT_TRUE(has(program.printed, "\nWRONG\n")) << program.printed;
  EXPECT_EQ(
      folder.run("mv faulty.so other.so; sed -i 's/ask(.*/& return 1;/' faulty.cpp; sh build.sh").status, 0);
  EXPECT_EQ(folder.run("sh build.sh ./other.so").status, 1) << "one that is named";
  EXPECT_EQ(folder.run("DAYLIGHT_PLUGIN=other.so sh build.sh").status, 1) << "likewise";
}

TEST(Export, ANodeProgramIsSentWithItsImportsAndInstallsItsPackages) {
  const Scratch scratch;
  fs::create_directories(scratch.folder / "sub");
  std::ofstream(scratch.folder / "sub/package.json")
      << R"({"dependencies":{"@engines/round":"1.2.0","unused":"3.0.0"}})";
  std::ofstream(scratch.folder / "sub/lines.mjs") << "export const answer = '{\"verdict\":\"disjoint\"}';\n";
  std::ofstream(scratch.folder / "sub/mine.mjs") << "import { turn } from '@engines/round';\n"
                                                    "import { answer } from './lines.mjs';\n"
                                                    "import { createInterface } from 'node:readline';\n"
                                                    "for await (const q of createInterface({ input: "
                                                    "process.stdin })) console.log(turn(q, answer));\n";
  // An npm that needs no network. It checks what it is asked for, and makes the package.
  const std::string npm =
      "mkdir -p bin; cat >bin/npm <<'END'\n#!/bin/sh\n"
      "case $5 in @engines/round@1.2.0) ;; *) exit 9 ;; esac\n"
      "mkdir -p \"$4/node_modules/@engines/round\" && cd \"$4/node_modules/@engines/round\"\n"
      "echo '{\"name\":\"@engines/round\",\"type\":\"module\",\"exports\":\"./i.js\"}' >package.json\n"
      "echo 'export const turn = (q, answer) => answer;' >i.js\nEND\nchmod +x bin/npm; PATH=$PWD/bin:$PATH; ";
  ASSERT_EQ(std::system(("cd " + shell_quoted(scratch.folder.string()) + " && " + npm +
                         "npm install --silent --prefix sub @engines/round@1.2.0")
                            .c_str()),
            0);
  Guest guest{GuestKind::command, "mine", "node sub/mine.mjs", scratch.folder.string()};
  const auto methods = opened(guest);
  const Export files =
      make_export(methods, "mine", FindingKind::wrong_disjoint, asked_of(0), {&guest, 1}, {});
  EXPECT_TRUE(has(files.issue, "installs `@engines/round@1.2.0` with npm")) << files.issue;
  const Folder folder(files);
  const Ran ran = folder.run(npm + "sh build.sh");
  EXPECT_EQ(ran.status, 1) << ran.printed;
  EXPECT_TRUE(has(ran.printed, "\nWRONG\n")) << ran.printed;
}

TEST(NodeProgram, ImportsWhatLiesInItsFolderAndNoFileAbove) {
  const Scratch scratch;
  const fs::path at = scratch.folder / "in";
  fs::create_directories(at / "lib");
  std::ofstream(at / "package.json") << R"({"dependencies":{"a":"1.0.0","b":7,"c":"2.0.0"}})";
  std::ofstream(scratch.folder / "above.mjs") << "";
  std::ofstream(at / "lib/one.mjs") << "import './two.mjs'; import '../main.mjs'; import '../../above.mjs';";
  std::ofstream(at / "lib/two.mjs") << "const a = require('a'), b = require(\"b\");";
  std::ofstream(at / "main.mjs") << "export * from './lib/one.mjs'; import('./none.mjs'); import 'node:fs';";
  const NodeProgram program = node_program(at / "main.mjs");
  EXPECT_EQ(program.files, (std::vector<std::string>{"main.mjs", "lib/one.mjs", "lib/two.mjs"}));
  EXPECT_EQ(program.packages, std::vector<std::string>{"a@1.0.0"});
  std::ofstream(at / "package.json") << "[";
  EXPECT_EQ(node_program(at / "main.mjs").packages.size(), 0u);
}

TEST(Export, AtTheEdgeOfTheClaimTheWorstIsShown) {
  const Scratch scratch;
  Guest guest{GuestKind::command, "", "while read -r q; do echo '{\"verdict\":\"disjoint\"}'; done",
              scratch.folder.string()};
  guest.what = "h='{\"claim\":{\"relative\":1e-3}}'; echo \"$h\"; " + guest.what;
  guest.name = "edge";
  const auto methods = opened(guest);
  const auto overlap = [](double depth) {
    return Pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{2 - depth, 0, 0}, {0, 0, 1}, 1, 2}};
  };
  const auto centre = [&](double simplest, std::optional<double> worst) {
    SentBeside beside;
    if (worst) beside.worst = overlap(*worst);
    return make_export(methods, "edge", FindingKind::wrong_disjoint, overlap(simplest), {&guest, 1}, beside)
        .issue;
  };
  const std::string at_edge = centre(0.0078125, 1.0);
  EXPECT_LT(at_edge.find("| b | (1, 0, 0)"), at_edge.find("| b | (1.9921875, 0, 0)")) << at_edge;
  EXPECT_TRUE(has(at_edge, "the simplest known")) << at_edge;
  const std::string plain = centre(0.5, 1.0);
  EXPECT_LT(plain.find("| b | (1.5, 0, 0)"), plain.find("| b | (1, 0, 0)")) << plain;
  EXPECT_TRUE(has(plain, "the worst known")) << plain;
  EXPECT_FALSE(has(centre(0.0078125, {}), "Another pair"));
  EXPECT_TRUE(has(centre(0.001953125, {}), "within its tolerance")) << "within the claim";
}

TEST(Export, APluginShowsIt) {
  const Guests guests;
  expect_every_fault_shown(guests.plugin());
}

TEST(Export, AProgramShowsIt) {
  const Guests guests;
  expect_every_fault_shown(guests.command());
}

}  // namespace
}  // namespace cyl
