// SPDX-License-Identifier: MIT
#include "reports/export/export.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "base/safe_text.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "reports/export/export_check.hpp"
#include "reports/export/export_program.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

Pair pair_of(const std::string& text) { return parse_case(text, 1).value.value().pair; }

std::vector<std::unique_ptr<Method>> library_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  for (auto list : {fcl_methods, bullet_methods, ccd_methods, ode_methods, mujoco_methods})
    for (auto& method : list()) methods.push_back(std::move(method));
  return methods;
}

struct Ran {
  int status;
  std::string printed;
};

/// A folder of its own, with an export in it.
class Folder {
 public:
  explicit Folder(const Export& files) {
    std::string name = (fs::temp_directory_path() / "daylight-export-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
    write_export(files, name);
  }
  ~Folder() { fs::remove_all(path_); }

  Ran run(const std::string& command) const {
    const std::string all = "cd " + shell_quoted(path_.string()) + " && { " + command + "; } >printed 2>&1";
    const int status = std::system(all.c_str());
    std::ifstream in(path_ / "printed");
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            {std::istreambuf_iterator<char>(in), {}}};
  }

 private:
  fs::path path_;
};

Export export_of(std::string_view method, FindingKind kind, const Pair& pair) {
  return make_export(select_methods(all_methods(), method), method, kind, pair);
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part << " is not in\n" << text;
  return at == std::string::npos ? text : text.replace(at, part.size(), by);
}

/// With another certificate in the last of the cases.
std::string tampered(const std::string& check, const std::string& certificate) {
  const std::size_t end = check.find("),\n]\n"), begin = check.rfind("\n     (", end) + 6;
  return check.substr(0, begin) + certificate + check.substr(end);
}

/// The program is built, shows the wrong answer and says so; the proof holds, and not with another
/// certificate.
void expect_shown(std::string_view method, FindingKind kind, const std::string& pair,
                  const std::string& no_certificate) {
  Export files = export_of(method, kind, pair_of(pair));
  {
    const Folder folder(files);
    const Ran program = folder.run("sh build.sh");
    EXPECT_EQ(program.status, 1) << program.printed;
    const bool within = has(files.issue, "within its tolerance\n");
    EXPECT_EQ(within, has(files.issue, "this is no fault")) << files.issue;
    EXPECT_EQ(within, has(files.issue, "; this is below it") || has(files.issue, "; this is within it"));
    EXPECT_TRUE(has(program.printed, within ? "\nnot as proved, within the claim\n" : "\nWRONG\n"))
        << program.printed;
    const Ran proof = folder.run("python3 exact.py");
    EXPECT_EQ(proof.status, 0) << proof.printed;
    EXPECT_TRUE(has(proof.printed, ": proved\n")) << proof.printed;
  }
  files.check = tampered(files.check, no_certificate);
  const Ran proof = Folder(files).run("python3 exact.py");
  EXPECT_EQ(proof.status, 1) << proof.printed;
  EXPECT_TRUE(has(proof.printed, "NOT PROVED")) << proof.printed;
}

const std::string huge = R"({"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1e+300,"height":4e+300},)"
                         R"("b":{"center":[0,1.5e+300,0],"axis":[1,0,0],"radius":1e+300,"height":4e+300}})";
const std::string stacked = R"({"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2},)"
                            R"("b":{"center":[0,0,2.0000005],"axis":[0,0,1],"radius":1,"height":2}})";
const std::string nearly_parallel = R"({"a":{"center":[0,0,0],"axis":[0,0,1],"radius":0,"height":1},)"
                                    R"("b":{"center":[0,1.01,0],"axis":[0,0.03,1],"radius":1,"height":1}})";
const std::string flat_on_long = R"({"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":40000},)"
                                 R"("b":{"center":[0,1,0],"axis":[0,0,1],"radius":200,"height":1}})";
const std::string tiny = R"({"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1e-9,"height":2e-9},)"
                         R"("b":{"center":[3e-9,1e-10,0],"axis":[0,0,1],"radius":1e-9,"height":2e-9}})";
const std::string least_rod = R"({"a":{"center":[0,0,0],"axis":[0,0,1],"radius":0,"height":1e-16},)"
                              R"("b":{"center":[0,0,0],"axis":[0,0,1],"radius":0,"height":1}})";

TEST(Export, FclShowsIt) { expect_shown("fcl-indep", FindingKind::wrong_intersecting, stacked, "(1, 0, 0)"); }

TEST(Export, BulletShowsIt) {
  expect_shown("bullet-cylinder-margin0", FindingKind::wrong_disjoint, flat_on_long, "(0, 0, 0.51)");
}

TEST(Export, LibccdShowsIt) {
  expect_shown("libccd-gjk", FindingKind::wrong_intersecting, tiny, "(0, 1, 0)");
}

TEST(Export, OdeShowsIt) {
  expect_shown("ode", FindingKind::wrong_disjoint, nearly_parallel, "(0, 0, 0.3941308281066029)");
}

TEST(Export, MujocoShowsIt) { expect_shown("mujoco", FindingKind::wrong_disjoint, huge, "(0, 4e+299, 0)"); }

TEST(Export, ACrashIsOnlyCalled) {
  const Export files = export_of("ode", FindingKind::crash, pair_of(least_rod));
  EXPECT_TRUE(has(files.issue, "# dCollide aborts on two cylinders\n")) << files.issue;
  const Ran program = Folder(files).run("sh build.sh");
  EXPECT_EQ(program.status, 134) << program.printed;
  EXPECT_TRUE(has(program.printed, "asking; this aborts\n")) << program.printed;
}

TEST(Export, TheIssueSaysWhatAReaderNeeds) {
  const std::string issue = export_of("ode", FindingKind::wrong_disjoint, pair_of(nearly_parallel)).issue;
  for (const char* part : {"# dCollide misses two cylinders that overlap by 0.00", "`dCollide` of ODE 0.",
                           "one contact", "| b | (0, 1.01, 0) | (0, 0.03, 1) | 1 | 1 |", "No collision.",
                           "lies in both", "this is beyond it", "exact.py", "build.sh", "libode-dev"})
    EXPECT_TRUE(has(issue, part)) << part << " is not in\n" << issue;
}

// What a program sets must be what the method claims; a method that is new must get a program.
TEST(Export, EveryMethodHasAProgram) {
  for (const auto& method : library_methods()) {
    const LibraryCall* call = find_library_call(method->name());
    ASSERT_NE(call, nullptr) << method->name();
    Trial asked(pair_of(nearly_parallel));
    asked.distance = {-0.5, -0.25};
    asked.answers.resize(1);
    asked.answers[0].status = Status::answered;
    asked.answers[0].verdict = Verdict::disjoint;
    for (const FindingKind kind : {FindingKind::wrong_disjoint, FindingKind::crash, FindingKind::hang}) {
      asked.findings = {Finding{kind, Severity::contract, {}}};
      const std::string program = reproducing_program(*call, asked, *method);
      EXPECT_FALSE(has(program, "@")) << program;
      EXPECT_TRUE(has(program, "1.01")) << program;
      EXPECT_EQ(has(program, "WRONG"), kind == FindingKind::wrong_disjoint) << program;
    }
    const bool sets_it =
        call->library == "FCL" || call->library == "MuJoCo" || call->call == "ccdMPRIntersect";
    if (!sets_it) continue;
    const double claimed = method->claim().absolute;
    const std::string program = reproducing_program(*call, asked, *method);
    const std::size_t at = program.find("tolerance = ");
    ASSERT_NE(at, std::string::npos) << program;
    EXPECT_EQ(std::strtod(program.c_str() + at + 12, nullptr), claimed) << program;
  }
}

TEST(Export, RefusesWhatCannotBeSent) {
  EXPECT_THROW(export_of("seedbook", FindingKind::wrong_disjoint, pair_of(stacked)), std::invalid_argument);
  EXPECT_THROW(export_of("ode", FindingKind::wrong_disjoint, pair_of(stacked)), std::invalid_argument);
  EXPECT_THROW(export_of("fcl-indep", FindingKind::wrong_disjoint, pair_of(stacked)), std::invalid_argument);
  EXPECT_THROW(export_of("fcl-indep", FindingKind::nondeterminism, pair_of(stacked)), std::invalid_argument);
}

// Of an axis (0, 3, 4) the library gets (0, 0.6, 0.8), whose doubles point elsewhere.
TEST(Export, TheLibraryIsNotBlamedForRoundedAxes) {
  Trial asked(pair_of(R"({"a":{"center":[0,0,0],"axis":[0,3,4],"radius":0,"height":10},)"
                      R"("b":{"center":[0,3,4],"axis":[1,0,0],"radius":0,"height":2}})"));
  asked.findings.resize(1);
  ASSERT_NE(asked.truth.verdict, Verdict::disjoint);
  ASSERT_EQ(judge(as_given(asked.pair)).verdict, Verdict::disjoint);
  try {
    exact_check(asked, {});
    FAIL() << "a check was written";
  } catch (const std::runtime_error& refused) {
    EXPECT_TRUE(has(refused.what(), "it is not to blame")) << refused.what();
  }
}

// Each way in which a distance can be shown to be impossible.
TEST(Export, AnImpossibleDistanceIsProvedImpossible) {
  const auto methods = select_methods(own_methods(), "distance");
  const auto expect_proof = [&](const Pair& pair, double said, std::string_view words) {
    Trial asked = try_method(methods[0], pair);
    asked.answers[0].distance = said;
    asked.findings = {Finding{FindingKind::distance_outside, Severity::contract, {}}};
    const Claim claim{.absolute = 1e-6, .source = "this test"};
    ASSERT_TRUE(shows_distance(asked, claim));
    Export files;
    files.program_name = "reproduce.cpp";
    files.check = exact_check(asked, claim);
    const Ran proof = Folder(files).run("python3 exact.py");
    EXPECT_EQ(proof.status, 0) << proof.printed << files.check;
    EXPECT_TRUE(has(proof.printed, words)) << proof.printed;
    // A distance that is possible cannot be refuted.
    const double real = asked.distance.lo / 2 + asked.distance.hi / 2;
    files.check = replaced(files.check, "SAID, TOLERANCE = " + format_double(said),
                           "SAID, TOLERANCE = " + format_double(real));
    EXPECT_EQ(Folder(files).run("python3 exact.py").status, 1);
  };
  const Pair apart = pair_of(R"({"a":{"center":[0,3,0],"axis":[0,0,1],"radius":0,"height":0},)"
                             R"("b":{"center":[0,0,1],"axis":[1,1,1],"radius":1,"height":0}})");
  expect_proof(apart, 1, "too small");
  expect_proof(apart, 9, "too large");
  expect_proof(pair_of(flat_on_long), -500, "too deep");
}

/// What a guest does wrong, by the height of the first solid, and how its program ends.
struct Fault {
  FindingKind kind;
  bool meet;  ///< the solids
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

/// A plug-in and a program with these faults, in a folder of their own.
class Guests {
 public:
  Guests() {
    std::string name = (fs::temp_directory_path() / "daylight-guests-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
    std::ofstream c(folder_ / "faulty.cpp"), shell(folder_ / "faulty.sh");
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
    const std::string build = "cd " + shell_quoted(name) + " && c++ -shared -fPIC -w -I " +
                              shell_quoted(DAYLIGHT_SOURCE_DIR "/oracles") + " faulty.cpp -o faulty.so";
    if (std::system(build.c_str()) != 0) throw std::runtime_error("the plug-in is not built");
  }
  ~Guests() { fs::remove_all(folder_); }

  Guest plugin() const { return {GuestKind::plugin, "", (folder_ / "faulty.so").string(), ""}; }
  Guest command() const { return {GuestKind::command, "", "sh faulty.sh", folder_.string()}; }

 private:
  fs::path folder_;
};

void expect_every_fault_shown(Guest guest) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(open_guest(guest));
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

/// Whether a text holds a path of this machine, but for that of the shell.
bool has_path(const std::string& text) {
  return has(text, fs::temp_directory_path().string() + '/') ||
         has(text, fs::current_path().string() + '/') || has(text, DAYLIGHT_SOURCE_DIR);
}

TEST(Export, NothingThatIsSentKnowsThisMachine) {
  const Guests guests;
  for (Guest guest : {guests.plugin(), guests.command()}) {
    if (guest.kind == GuestKind::command) guest.what = "/bin/sh " + guest.folder + "/faulty.sh";
    std::vector<std::unique_ptr<Method>> methods;
    methods.push_back(open_guest(guest));
    const Export files = make_export(methods, "faulty", FindingKind::reported, asked_of(7), {&guest, 1});
    for (const std::string* text : {&files.program, &files.build, &files.check, &files.issue})
      EXPECT_FALSE(has_path(*text)) << *text;
    ASSERT_EQ(files.files.size(), 1u);
    EXPECT_EQ(files.files[0].name, guest.kind == GuestKind::plugin ? "faulty.so" : "faulty.sh");
    EXPECT_TRUE(has(files.issue, "`" + files.files[0].name + "`")) << files.issue;
  }
}

TEST(Export, WordsOfAGuestLoseTheFoldersOfThisMachine) {
  const Guest guest{GuestKind::plugin, "mine", "/home/me/lib/libmine.so", ""};
  EXPECT_EQ(without_folders("/home/me/lib/gjk.cpp:30: Assertion `x' failed", guest),
            "gjk.cpp:30: Assertion `x' failed");
  EXPECT_EQ(without_folders("at " + fs::current_path().string() + "/x.c:1", guest), "at x.c:1");
}

TEST(Export, WhatAMethodReportsIsNotSaidToBeThrown) {
  const Guests guests;
  for (Guest guest : {guests.plugin(), guests.command()}) {
    std::vector<std::unique_ptr<Method>> methods;
    methods.push_back(open_guest(guest));
    const Export files = make_export(methods, "faulty", FindingKind::exception, asked_of(7), {&guest, 1});
    EXPECT_TRUE(files.issue.starts_with("# faulty says that it failed on two cylinders that are "))
        << files.issue;
    const bool command = guest.kind == GuestKind::command;
    EXPECT_TRUE(has(files.issue, command ? "Its reason: `no luck`." : "Its reason: `no reason given`."));
    for (const std::string* text : {&files.program, &files.issue}) {
      EXPECT_FALSE(has(*text, "throw")) << *text;
      EXPECT_FALSE(has(*text, "xception")) << *text;
    }
  }
}

TEST(Export, ItsSourceIsSentAndBuilt) {
  const Guests guests;
  Guest guest = guests.plugin();
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(open_guest(guest));
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

TEST(Export, AtTheEdgeOfTheClaimTheWorstIsShown) {
  std::string name = (fs::temp_directory_path() / "daylight-edge-XXXXXX").string();
  ASSERT_NE(mkdtemp(name.data()), nullptr);
  Guest guest{GuestKind::command, "", "while read -r q; do echo '{\"verdict\":\"disjoint\"}'; done", name};
  guest.what = "h='{\"claim\":{\"relative\":1e-3}}'; echo \"$h\"; " + guest.what;
  guest.name = "edge";
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(open_guest(guest));
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
  fs::remove_all(name);
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
