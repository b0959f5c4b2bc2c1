// SPDX-License-Identifier: MIT
#include "reports/export/export.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "base/error_of_test.hpp"
#include "base/files.hpp"
#include "base/safe_text.hpp"
#include "base/scratch_test.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/methods/adapter.hpp"
#include "reports/export/export_check.hpp"
#include "reports/export/export_program.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

struct Ran {
  int status;
  std::string printed;
};

/// A folder of its own with an export in it, as its receiver has it.
class Folder : Scratch {
 public:
  explicit Folder(const Export& files) { write_export(files, folder.string()); }

  Ran run(const std::string& command) const {
    const std::string all = "cd " + shell_quoted(folder.string()) + " && { " + command + "; } >printed 2>&1";
    const int status = std::system(all.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_file(folder / "printed")};
  }
};

std::vector<std::unique_ptr<Method>> library_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  for (auto list : {fcl_methods, bullet_methods, ccd_methods, ode_methods, mujoco_methods})
    for (auto& method : list()) methods.push_back(std::move(method));
  return methods;
}

Export export_of(std::string_view method, FindingKind kind, const Pair& pair) {
  return make_export(select_methods(all_methods(), method), method, kind, pair);
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part << " is not in\n" << text;
  return at == std::string::npos ? text : text.replace(at, part.size(), by);
}

/// Adds a second certificate to the last claim. If a name occurs twice, Python takes the last one.
std::string tampered(const std::string& check, const std::string& certificate) {
  return replaced(check, "}},\n]\n", "," + certificate + "}},\n]\n");
}

/// Checks that the program is built, shows the wrong answer and reports it. The proof holds, but not with
/// another certificate.
void expect_shown(std::string_view method, FindingKind kind, const Pair& pair,
                  const std::string& no_certificate) {
  Export files = export_of(method, kind, pair);
  {
    const Folder folder(files);
    const Ran program = folder.run("sh build.sh");
    EXPECT_EQ(program.status, 1) << program.printed;
    const bool within = has(files.at("issue.md"), "within its tolerance\n");
    EXPECT_EQ(within, has(files.at("issue.md"), "The claim quoted below allows this answer"))
        << files.at("issue.md");
    EXPECT_EQ(within, has(files.at("issue.md"), "This pair is below it") ||
                          has(files.at("issue.md"), "This pair is within it"));
    EXPECT_TRUE(has(program.printed, within ? "\nnot as proved, within the claim\n" : "\nWRONG\n"))
        << program.printed;
    const Ran proof = folder.run("python3 exact.py");
    EXPECT_EQ(proof.status, 0) << proof.printed;
    EXPECT_TRUE(has(proof.printed, ": proved\n")) << proof.printed;
  }
  files["exact.py"] = tampered(files["exact.py"], no_certificate);
  const Ran proof = Folder(files).run("python3 exact.py");
  EXPECT_EQ(proof.status, 1) << proof.printed;
  EXPECT_TRUE(has(proof.printed, "NOT PROVED")) << proof.printed;
}

const Pair huge{{{0, 0, 0}, {0, 0, 1}, 1e300, 4e300}, {{0, 1.5e300, 0}, {1, 0, 0}, 1e300, 4e300}};
const Pair stacked{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{0, 0, 2.0000005}, {0, 0, 1}, 1, 2}};
const Pair nearly_parallel{{{0, 0, 0}, {0, 0, 1}, 0, 1}, {{0, 1.01, 0}, {0, 0.03, 1}, 1, 1}};
const Pair flat_on_long{{{0, 0, 0}, {0, 0, 1}, 1, 40000}, {{0, 1, 0}, {0, 0, 1}, 200, 1}};
const Pair tiny{{{0, 0, 0}, {0, 0, 1}, 1e-9, 2e-9}, {{3e-9, 1e-10, 0}, {0, 0, 1}, 1e-9, 2e-9}};
const Pair least_rod{{{0, 0, 0}, {0, 0, 1}, 0, 1e-16}, {{0, 0, 0}, {0, 0, 1}, 0, 1}};
const Pair ball_and_capsule{{{0, 0, 0}, {0, 0, 1}, 0, 0, 1}, {{3, 0, 0}, {0, 0, 1}, 0, 2, 1}};
const Pair coins{{{0, 0, 0}, {1, 2, 2}, 3, 1}, {{-4, -2, 2}, {1, 2, 2}, 3, 1}};

TEST(Export, FclShowsIt) {
  expect_shown("fcl-indep", FindingKind::wrong_intersecting, stacked, R"("direction":[1,0,0])");
}

TEST(Export, BulletShowsIt) {
  expect_shown("bullet-cylinder-margin0", FindingKind::wrong_disjoint, flat_on_long, R"("point":[0,0,0.51])");
}

// GJK answers intersecting for the coins if the support function sums from the left, as ours does.
TEST(Export, LibccdShowsIt) {
  expect_shown("libccd-gjk", FindingKind::wrong_intersecting, coins, R"("direction":[0,1,0])");
  expect_shown("libccd-gjk", FindingKind::wrong_intersecting, tiny, R"("direction":[0,1,0])");
}

TEST(Export, OdeShowsIt) {
  expect_shown("ode", FindingKind::wrong_disjoint, nearly_parallel, R"("point":[0,0,0.3941308281066029])");
}

TEST(Export, WhatIsFartherThanAnyDoubleIsShown) {
  expect_shown("bullet-cylinder", FindingKind::distance_outside,
               {{{-1.7e308, 0, 0}, {0, 0, 1}, 1, 2}, {{1.7e308, 0, 0}, {0, 1, 0}, 1, 2}},
               R"("direction":[0,1,0])");
}

TEST(Export, MujocoShowsIt) {
  expect_shown("mujoco", FindingKind::wrong_disjoint, huge, R"("point":[0,4e+299,0])");
}

TEST(Export, ACrashIsOnlyCalled) {
  const Export files = export_of("ode", FindingKind::crash, least_rod);
  EXPECT_TRUE(has(files.at("issue.md"), "# dCollide aborts on two cylinders\n")) << files.at("issue.md");
  const Ran program = Folder(files).run("sh build.sh");
  EXPECT_EQ(program.status, 134) << program.printed;
  EXPECT_TRUE(has(program.printed, "calling the library: it aborts\n")) << program.printed;
}

TEST(Export, TheIssueSaysWhatAReaderNeeds) {
  const std::string issue = export_of("ode", FindingKind::wrong_disjoint, nearly_parallel).at("issue.md");
  for (const char* part :
       {"# dCollide misses two cylinders that overlap by 0.00", "`dCollide` of ODE 0.", "one contact",
        "| b | (0, 1.01, 0) | (0, 0.03, 1) | 1 | 1 |", "No collision.", "lies in both",
        "The assumed tolerance is", "This pair is beyond it", "exact.py", "build.sh", "libode-dev"})
    EXPECT_TRUE(has(issue, part)) << part << " is not in\n" << issue;
}

// A program must set what the method claims. A new method must get a program.
TEST(Export, EveryMethodHasAProgram) {
  for (const auto& method : library_methods()) {
    const LibraryCall* call = find_library_call(method->name());
    ASSERT_NE(call, nullptr) << method->name();
    // All numbers differ. The unit axes are (3, 2, 6) / 7 and (4, 4, 7) / 9.
    Trial asked({{{0.11, 0.12, 0.13}, {3, 2, 6}, 0.21, 0.62}, {{1.01, 1.12, 1.13}, {4, 4, 7}, 0.41, 1.46}});
    asked.distance = {-0.5, -0.25};
    asked.answers.resize(1);
    asked.answers[0].status = Status::answered;
    asked.answers[0].verdict = Verdict::disjoint;
    for (const FindingKind kind : {FindingKind::wrong_disjoint, FindingKind::crash, FindingKind::hang}) {
      asked.findings = {Finding{kind, Severity::contract, {}}};
      const std::string program = reproducing_program(*call, asked, *method);
      EXPECT_FALSE(has(program, "@")) << program;
      const bool full = call->library == "FCL" || call->library == "ODE";
      for (const Solid* c : {&asked.pair.a, &asked.pair.b}) {
        const Vector3 axis = unit_axis(c->axis);
        std::vector<double> numbers{c->radius, full ? c->height : c->height / 2};
        for (const Vector3* v : {&c->center, &axis}) numbers.insert(numbers.end(), v->begin(), v->end());
        for (const double x : numbers) EXPECT_TRUE(has(program, literal(x))) << literal(x) << program;
        EXPECT_FALSE(has(program, literal(full ? c->height / 2 : c->height))) << program;
        const std::string shape = literal(c->radius) + ", " + literal(c->height);
        EXPECT_EQ(has(program, shape), full) << "radius, height" << program;
      }
      if (call->library == "Bullet") {
        const bool hull = method->name().starts_with("bullet-hull"),
                   margins = method->name() == "bullet-cylinder" || method->name() == "bullet-box";
        EXPECT_EQ(has(program, "stretch = (1 + 0x1p-50)"), hull) << program;
        EXPECT_EQ(has(program, "  a.setMargin(0);\n  b.setMargin(0);\n"), !hull && !margins) << program;
      }
      EXPECT_EQ(has(program, "WRONG"), kind == FindingKind::wrong_disjoint) << program;
    }
    if (call->library != "FCL" && call->library != "MuJoCo" && call->call != "ccdMPRIntersect") continue;
    const double claimed = method->claim().absolute;
    const std::string program = reproducing_program(*call, asked, *method);
    const std::size_t at = program.find("tolerance = ");
    ASSERT_NE(at, std::string::npos) << program;
    EXPECT_EQ(std::strtod(program.c_str() + at + 12, nullptr), claimed) << program;
  }
}

TEST(Export, RefusesWhatCannotBeSent) {
  EXPECT_THROW(export_of("seedbook", FindingKind::wrong_disjoint, stacked), std::invalid_argument);
  EXPECT_THROW(export_of("ode", FindingKind::wrong_disjoint, stacked), std::invalid_argument);
  EXPECT_THROW(export_of("fcl-indep", FindingKind::wrong_disjoint, stacked), std::invalid_argument);
  EXPECT_THROW(export_of("fcl-indep", FindingKind::nondeterminism, stacked), std::invalid_argument);
}

TEST(Export, APairWithRoundingsIsNotSentOfALibrary) {
  Pair rounded = nearly_parallel;
  rounded.a.radius = rounded.a.rounding = 0.001;
  EXPECT_TRUE(
      has(refusal("ode", FindingKind::wrong_disjoint, rounded, false), "no program of ODE has these solids"));
  EXPECT_EQ(refusal("ode", FindingKind::wrong_disjoint, rounded, true), "");
}

// For an axis (0, 3, 4) the library gets (0, 0.6, 0.8), and the doubles of this point elsewhere.
TEST(Export, TheLibraryIsNotBlamedForRoundedAxes) {
  Trial asked({{{0, 0, 0}, {0, 3, 4}, 0, 10}, {{0, 3, 4}, {1, 0, 0}, 0, 2}});
  asked.findings.resize(1);
  ASSERT_NE(asked.truth.verdict, Verdict::disjoint);
  ASSERT_EQ(judge(as_given(asked.pair)).verdict, Verdict::disjoint);
  EXPECT_TRUE(has(error_of([&] { exact_check(asked, {}); }), "the library is right"));
}

// Checks each way of showing that a distance is impossible.
TEST(Export, AnImpossibleDistanceIsProvedImpossible) {
  const auto methods = select_methods(own_methods(), "distance");
  const auto expect_proof = [&](const Pair& pair, double said, std::string_view words,
                                double tolerance = 1e-6) {
    Trial asked = try_method(methods[0], pair);
    asked.answers[0].distance = said;
    asked.findings = {Finding{FindingKind::distance_outside, Severity::contract, {}}};
    // A claim with an absolute length also gets the floor of a relative one.
    const double size = size_of(pair);
    const Claim claim{.relative = size > 0 ? tolerance / size : 0,
                      .absolute = size > 0 ? 0 : tolerance,
                      .source = "this test"};
    ASSERT_TRUE(shows_distance(asked, claim));
    Export files;
    std::string& check = files["exact.py"];
    check = exact_check(asked, claim);
    const Ran proof = Folder(files).run("python3 exact.py");
    EXPECT_EQ(proof.status, 0) << proof.printed << check;
    EXPECT_TRUE(has(proof.printed, words)) << proof.printed;
    // A possible distance cannot be refuted.
    const double real = asked.distance.lo / 2 + asked.distance.hi / 2;
    check = replaced(check, "\"distance\":" + format_double(said), "\"distance\":" + format_double(real));
    EXPECT_EQ(Folder(files).run("python3 exact.py").status, 1);
  };
  const Pair apart{{{0, 3, 0}, {0, 0, 1}, 0, 0}, {{0, 0, 1}, {1, 1, 1}, 1, 0}};
  expect_proof(apart, 1, "too small");
  expect_proof(apart, 9, "too large");
  expect_proof(flat_on_long, -500, "too deep");
  expect_proof(ball_and_capsule, 1.0000000000001, "too large", 1e-15);
  expect_proof(ball_and_capsule, 0.9999999999999, "too small", 1e-15);
}

/// A fault of a guest, chosen by the height of the first solid.
struct Fault {
  FindingKind kind;
  bool meet;  ///< whether the solids meet
  const char* in_shell;
};

const Fault faults[] = {
    {FindingKind::wrong_disjoint, true, R"(echo '{"verdict":"disjoint"}')"},
    {FindingKind::wrong_intersecting, false, R"(echo '{"verdict":"touching"}')"},
    {FindingKind::wrong_touching, true, R"(echo '{"verdict":"touching"}')"},
    {FindingKind::distance_outside, false, R"(echo '{"verdict":"disjoint","distance":100}')"},
    {FindingKind::bad_witness, false, R"(echo '{"verdict":"disjoint","direction":[0,1,0]}')"},
    {FindingKind::bad_witness, true, R"(echo '{"verdict":"intersecting","point":[0,0,[50,0.1]]}')"},
    {FindingKind::reported, false, R"(echo '{"error":"no luck"}')"},
    {FindingKind::malformed, false, "echo loading"},
    {FindingKind::crash, false, "exit 3"},
};

/// A program with these faults, in its own folder.
class FaultyGuest : Scratch {
 public:
  FaultyGuest() {
    std::ofstream shell(folder / "faulty.sh");
    shell << "while read -r q; do case $q in\n";
    for (std::size_t i = 0; i < std::size(faults); ++i)
      shell << "*'\"height\":" << i + 1 << "},\"b\"'*) " << faults[i].in_shell << ";;\n";
    shell << "*) echo '{\"verdict\":\"disjoint\"}';; esac; done\n";
    shell.close();
    OpenedGuest opened = std::move(open_guest(command("sh faulty.sh")).front());
    methods_.push_back(std::move(opened.method));
  }

  Guest command(const std::string& what) const {
    return {GuestKind::command, "faulty", what, folder.string()};
  }
  Guest plugin() const { return {GuestKind::plugin, "faulty", (folder / "libfaulty.so").string(), ""}; }

  Export exported(std::size_t fault, const Guest& guest) const {
    const auto& [kind, meet, in_shell] = faults[fault];
    const double height = static_cast<double>(fault + 1);
    const Pair pair{{{0, 0, 0}, {0, 0, 2}, 1, height}, {{meet ? 1.0 : 4.0, 0, 0}, {0, 0, 1}, 1, 2}};
    return make_export(methods_, "faulty", kind, pair, &guest);
  }

 private:
  std::vector<std::unique_ptr<Method>> methods_;
};

/// The place of a kind among the faults.
std::size_t place_of(FindingKind kind) {
  return static_cast<std::size_t>(std::ranges::find(faults, kind, &Fault::kind) - std::begin(faults));
}

TEST(Export, EveryFaultOfAGuestIsProved) {
  const FaultyGuest faulty;
  for (std::size_t i = 0; i < std::size(faults); ++i) {
    const Export files = faulty.exported(i, faulty.command("sh faulty.sh"));
    const Ran proof = Folder(files).run("python3 exact.py");
    EXPECT_EQ(proof.status, 0) << i << ' ' << proof.printed;
    const bool of_its_answer =
        faults[i].kind == FindingKind::bad_witness || faults[i].kind == FindingKind::distance_outside;
    EXPECT_EQ(has(proof.printed, "said"), of_its_answer) << i << ' ' << proof.printed;
    EXPECT_FALSE(has(files.at("exact.py"), "that the library gets")) << "a guest gets the axes as they are";
    EXPECT_TRUE(has(files.at("issue.md"), "# faulty")) << files.at("issue.md");
    EXPECT_TRUE(parse_case(files.at("case.jsonl"), 1).value) << files.at("case.jsonl");
  }
}

TEST(Export, NothingThatIsSentKnowsThisMachine) {
  const FaultyGuest faulty;
  const std::size_t reported = place_of(FindingKind::reported);
  const std::string script = faulty.command("").folder + "/faulty.sh";
  for (const auto& [guest, option] : std::vector<std::pair<Guest, std::string>>{
           {faulty.plugin(), "--plugin faulty=libfaulty.so"},
           {faulty.command("/bin/sh " + script), "--command 'faulty=sh faulty.sh'"}}) {
    const Export files = faulty.exported(reported, guest);
    for (const auto& [name, text] : files)
      for (const std::string& path : {fs::temp_directory_path().string() + '/',
                                      fs::current_path().string() + '/', std::string(DAYLIGHT_SOURCE_DIR)})
        EXPECT_FALSE(has(text, path)) << name << '\n' << text;
    EXPECT_TRUE(
        has(files.at("issue.md"), "\n    daylight replay case.jsonl --methods faulty " + option + "\n"))
        << files.at("issue.md");
  }
}

TEST(Export, WhatAMethodReportsIsNotSaidToBeThrown) {
  const FaultyGuest faulty;
  const std::string issue =
      faulty.exported(place_of(FindingKind::reported), faulty.command("sh faulty.sh")).at("issue.md");
  EXPECT_TRUE(issue.starts_with("# faulty reports a failure on two cylinders that are ")) << issue;
  EXPECT_TRUE(has(issue, "with the reason `no luck`."));
  EXPECT_FALSE(has(issue, "throw")) << issue;
  EXPECT_FALSE(has(issue, "xception")) << issue;
}

/// A program with a claim of 1e-3 that always gives this answer.
Guest constant(const char* name, const std::string& answer, const Scratch& scratch) {
  return {GuestKind::command, name,
          "echo '{\"claim\":{\"relative\":1e-3}}'; while read -r q; do echo '" + answer + "'; done",
          scratch.folder.string()};
}

TEST(Export, AtTheEdgeOfTheClaimNothingIsClear) {
  const Scratch scratch;
  const Guest guest = constant("edge", R"({"verdict":"disjoint"})", scratch);
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::move(open_guest(guest).front().method));
  const auto overlap = [](double depth) {
    return Pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{2 - depth, 0, 0}, {0, 0, 1}, 1, 2}};
  };
  const auto clear = [&](double depth) {
    return is_clear(try_method(methods[0], overlap(depth)), methods[0]->claim());
  };
  EXPECT_TRUE(clear(0.5));
  EXPECT_FALSE(clear(0.0078125));
  const auto sent = [&](double depth) {
    return make_export(methods, "edge", FindingKind::wrong_disjoint, overlap(depth), &guest).at("issue.md");
  };
  EXPECT_TRUE(has(sent(0.0078125), "\nThe exit code is 2 while the answer is wrong beyond the claim"));
  const std::string within = sent(0.001953125);
  EXPECT_TRUE(has(within, "within its tolerance")) << within;
  EXPECT_TRUE(has(within, "The exit code is 0, because the claim allows this answer.")) << within;
  EXPECT_FALSE(has(within, "exit code is 2")) << within;
}

// The margin of a touching pair is 0. It is the error of the distance that exceeds the claim.
TEST(Export, OfAWrongDistanceTheErrorIsBeyondTheClaim) {
  const Scratch scratch;
  const Guest guest = constant("far", R"({"verdict":"touching","distance":9})", scratch);
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::move(open_guest(guest).front().method));
  const Pair touching{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{2, 0, 0}, {0, 0, 1}, 1, 2}};
  const std::string issue =
      make_export(methods, "far", FindingKind::distance_outside, touching, &guest).at("issue.md");
  EXPECT_TRUE(has(issue, "The error of this one is beyond it.")) << issue;
  EXPECT_FALSE(has(issue, "This pair is")) << issue;
}

}  // namespace
}  // namespace cyl
