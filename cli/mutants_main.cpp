// SPDX-License-Identifier: MIT
// daylight-mutants measures the harness. It lists the mutants and runs each detector on each one. It exits
// with 0 if the unchanged program survives all detectors, and if each mutant that is not argued equivalent is
// detected. It exits with 2 if a mutant is not detected, and with 1 if the harness itself fails.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/exit_code.hpp"
#include "base/files.hpp"
#include "base/json.hpp"
#include "base/process/process.hpp"
#include "base/source_tree.hpp"
#include "base/usage_error.hpp"
#include "cli/options.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/store/batch_bytes.hpp"
#include "corpus/store/case_files.hpp"
#include "fuzz/campaign/batch.hpp"
#include "fuzz/campaign/climbed.hpp"
#include "fuzz/campaign/self_check.hpp"
#include "oracles/trial/compare.hpp"
#include "props/gate/gate.hpp"
#include "props/mutants/kill_matrix.hpp"

namespace {

using namespace cyl;

/// A campaign with its own seed, which is examined after each step. A finding beyond a claim, or a truth
/// that cannot be proved, ends it.
constexpr std::uint64_t fuzz_seed = 7, fuzz_indices = 12'288, fuzz_step = 512;

Evidence finding(const Mutant& mutant) {
  const auto methods = select_methods(all_methods(), mutant.asks);
  for (std::uint64_t at = 0; at < fuzz_indices; at += fuzz_step) {
    const BatchRecord batch = run_batch({methods, families(), {}}, fuzz_seed, at, at + fuzz_step);
    for (const FindingRecord& f : batch.findings)
      if (f.severity != Severity::resolution)
        return {
            fmt::format("{}: {} on {} {}; {}", f.method, to_string(f.kind), f.family, f.family_index, f.pair),
            is_method_row(f.method) ? std::optional(f.family_index) : std::nullopt};
  }
  return {};
}

/// The gate as a merge meets it, but with a twentieth of the pairs. A fault that it misses here may still
/// show in all pairs.
constexpr std::uint64_t gate_pairs_each = 31'250;

std::string gate_closed(const Mutant& mutant, std::span<const Case> cases) {
  const auto methods = select_methods(all_methods(), mutant.asks);
  GateOptions options;
  options.pairs = gate_pairs_each;
  const GateReport report = run_gate(methods, cases, options);
  if (exit_code(report) == exit_pass) return {};
  for (const GateFailure& f : report.failures)
    if (f.severity == Severity::contract)
      return fmt::format("{}: law {}, {}; {}", f.method, f.law->number, f.what, format_pair(f.simplest));
  return "undecided";
}

/// Becomes the unit tests, which read the number of the mutant from the environment.
std::string failing_test(const std::string& program, const Mutant& mutant) {
  if (mutant.tests.empty()) return {};
  setenv("DAYLIGHT_MUTANT", std::to_string(mutant.number).c_str(), 1);
  setenv("RC_PARAMS", "seed=20261121 max_success=500", 1);
  setenv("DAYLIGHT_LAW_PAIRS", "200", 1);
  setenv("DAYLIGHT_DISTANCE_PAIRS", "300", 1);
  become_program({program, "--gtest_filter=" + std::string(mutant.tests), "--gtest_fail_fast"});
}

using json = nlohmann::ordered_json;

json cell_of(const Detection& d) {
  json cell = {{"fate", to_string(d.outcome)},
               {"seconds", std::round(d.seconds * 1000) / 1000},
               {"what", d.evidence.failure_message}};
  if (d.evidence.family_index) cell["family_index"] = *d.evidence.family_index;
  return cell;
}

/// Returns the row of a mutant, with the cells of `before` that were asked of the same mutant.
json row_of(const Mutant& mutant, const json& before) {
  json row = {{"mutant", mutant.number},
              {"file", mutant.file},
              {"what", mutant.what},
              {"like", mutant.like},
              {"asks", mutant.asks}};
  if (!mutant.equivalent.empty()) row["equivalent"] = mutant.equivalent;
  if (before.value("what", "") != mutant.what || before.value("asks", "") != mutant.asks) return row;
  for (const auto& [name, value] : before.items())
    if (value.is_object()) row[name] = value;
  return row;
}

/// Returns the rows of an earlier matrix by number. Empty if there is no file.
std::map<int, json> rows_before(const std::string& file) {
  std::map<int, json> rows;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    json row = parse_ordered_json(line);
    rows.emplace(row.at("mutant").get<int>(), std::move(row));
  }
  return rows;
}

void write_rows(const std::string& file, const std::map<int, json>& rows) {
  if (file.empty()) return;
  std::string text;
  for (const auto& [number, row] : rows)
    text += row.dump(-1, ' ', true, json::error_handler_t::replace) + '\n';
  write_file(file + ".part", text);
  std::filesystem::rename(file + ".part", file);
}

void print(const KillRow& row) {
  std::string line = fmt::format("{:4}", row.mutant.number);
  for (const Detection& d : row.detections)
    line += fmt::format("  {:8} {:6.2f}", to_string(d.outcome), d.seconds);
  fmt::print("{}  {}\n", line, row.mutant.what);
  if (row.mutant.number == 0)
    for (const Detection& d : row.detections)
      if (!d.evidence.failure_message.empty()) fmt::print("      {}\n", d.evidence.failure_message);
  std::fflush(stdout);
}

void list() {
  for (const Mutant& m : all_mutants())
    fmt::print("{:4}  {:30}  {}{}\n", m.number, m.file, m.what, m.equivalent.empty() ? "" : " (equivalent)");
}

/// Returns the cases of a folder, or those of the project if it is empty.
std::vector<Case> read_cases(const std::string& folder) {
  return read_case_folder(folder.empty() ? in_source_tree("corpus/cases") : folder);
}

struct MatrixArguments {
  std::vector<int> only;
  std::vector<std::string> detectors;
  bool first = false;
  std::string json, cases;
};

int matrix(const MatrixArguments& arguments) {
  // This is not a structured binding, because clang 14 cannot capture one.
  const std::vector<int>& only = arguments.only;
  const std::vector<std::string>& wanted = arguments.detectors;
  const std::string& file = arguments.json;
  const std::vector<Case> cases = read_cases(arguments.cases);
  std::vector<Detector> detectors = law_detectors(cases);
  detectors.push_back({"fuzz", finding});
  detectors.push_back({"gate", [&](const Mutant& mutant) { return gate_closed(mutant, cases); }});
  const std::string tests = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "mutant_tests";
  detectors.push_back({"tests", [&](const Mutant& mutant) { return failing_test(tests, mutant); }});

  for (const std::string& name : wanted)
    if (std::none_of(detectors.begin(), detectors.end(), [&](const Detector& d) { return d.name == name; }))
      throw UsageError("there is no detector " + name);
  if (!wanted.empty())
    std::erase_if(detectors, [&](const Detector& d) {
      return std::find(wanted.begin(), wanted.end(), d.name) == wanted.end();
    });

  std::map<int, json> rows = rows_before(file);
  const auto run = [&](const Mutant& mutant, json& row) {
    KillRow found{mutant, {}};
    for (const Detector& detector : detectors) {
      Detection d;
      if (const auto cell = row.find(detector.name); cell != row.end()) {
        d.outcome = from_word<Detection::Outcome>(cell->at("fate").get<std::string>()).value();
        d.seconds = cell->at("seconds");
      } else if (!arguments.first || !found.killed()) {
        d = run_detectors(mutant, {&detector, 1}, select_mutant).detections.front();
        row[detector.name] = cell_of(d);
      }
      found.detections.push_back(d);
    }
    print(found);
    return found.killed();
  };

  fmt::print("    ");
  for (const Detector& detector : detectors) fmt::print("  {:15}", detector.name);
  fmt::print("\n");
  // Each set of methods runs once without a fault if any question about it is left. All tests that any
  // mutant names run together.
  std::vector<Mutant> chosen, controls;
  for (const Mutant& m : all_mutants())
    if (only.empty() || std::find(only.begin(), only.end(), m.number) != only.end()) chosen.push_back(m);
  if (chosen.empty()) throw UsageError("no fault has such a number; daylight mutants list shows all");
  for (const Mutant& m : chosen) {
    json& row = rows[m.number];
    row = row_of(m, row.is_null() ? json::object() : row);
    const auto asked = [&](const Detector& detector) { return row.contains(detector.name); };
    const auto same = [&](const Mutant& c) { return c.asks == m.asks && c.tests == m.tests; };
    if (!std::all_of(detectors.begin(), detectors.end(), asked) &&
        std::none_of(controls.begin(), controls.end(), same))
      controls.push_back({0, "", "the program as it is", "", m.asks, m.tests, ""});
  }
  for (const Mutant& control : controls)
    if (json row; run(control, row)) throw std::runtime_error("a detector fires without a fault");
  std::size_t killed = 0;
  std::string survivors, not_equivalent;
  for (const Mutant& m : chosen) {
    const bool detected = run(m, rows[m.number]);
    write_rows(file, rows);
    killed += detected;
    if (!detected && m.equivalent.empty()) survivors += fmt::format(" {}", m.number);
    if (detected && !m.equivalent.empty()) not_equivalent += fmt::format(" {}", m.number);
  }
  fmt::print("{} of {} mutants detected\n", killed, chosen.size());
  if (!survivors.empty()) fmt::print("neither detected nor equivalent:{}\n", survivors);
  if (!not_equivalent.empty()) fmt::print("called equivalent, but detected:{}\n", not_equivalent);
  return survivors.empty() && not_equivalent.empty() ? exit_pass : exit_findings;
}

/// Faults of each part. The first few are always of different parts. Each is caught within a second or two.
constexpr int smoke_mutants[] = {103, 301, 110, 204, 120};

int smoke(std::size_t count, const std::string& folder) {
  const std::vector<Case> cases = read_cases(folder);
  const std::vector<Detector> detectors = law_detectors(cases);
  count = std::min(count, std::size(smoke_mutants));
  std::size_t detected = 0;
  std::string missed;
  for (const int number : std::span(smoke_mutants, count)) {
    const auto mutants = all_mutants();
    const auto mutant =
        std::find_if(mutants.begin(), mutants.end(), [&](const Mutant& m) { return m.number == number; });
    if (mutant == mutants.end()) throw std::runtime_error(fmt::format("there is no mutant {}", number));
    const bool killed = std::any_of(detectors.begin(), detectors.end(), [&](const Detector& detector) {
      return run_detectors(*mutant, {&detector, 1}, select_mutant).killed();
    });
    detected += killed;
    if (!killed) missed += fmt::format(", not {} ({})", number, mutant->what);
  }
  fmt::print("{} of {} detected{}\n", detected, count, missed);
  return detected == count ? exit_pass : exit_findings;
}

struct Planted {
  int number = 0;
  std::uint64_t seed = 0, first = 0, pairs = 0;
  std::string methods, weights;
  std::vector<std::string> families;
};

/// Runs a campaign's pairs with one fault until it is found. Number 0 is the program without a fault.
int self_check(const Planted& planted) {
  const auto mutants = all_mutants();
  const auto is_it = [&](const Mutant& m) { return m.number == planted.number; };
  if (planted.number != 0 && std::none_of(mutants.begin(), mutants.end(), is_it))
    throw std::invalid_argument(fmt::format("there is no mutant {}", planted.number));
  const auto methods = select_methods(all_methods(), planted.methods);
  std::vector<Family> drawn;
  for (const std::string& name : planted.families)
    for (const Family& family : campaign_families())
      if (family.name == name) drawn.push_back(family);
  if (drawn.size() != planted.families.size()) throw std::invalid_argument("no such family");
  const std::vector<unsigned> weights = parse_weights(planted.weights);
  select_mutant(planted.number);
  const BatchRecord found =
      run_until_found({methods, drawn, {}, weights}, planted.seed, planted.first, planted.pairs);
  const std::string bytes = format_batch(found);
  return std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size() ? exit_pass : exit_harness_failed;
}

constexpr const char* mutants_exit_codes = "Exit code 2 means that a fault was not detected.";

void case_folder(Command& command, std::string& folder) {
  command.option("--cases,--corpus DIR", std::ref(folder), "folder of case files (default: corpus/cases/)");
}

void add_list(Program& program) {
  program.command("Measure", "list", "Lists the faults").run([] {
    list();
    return exit_pass;
  });
}

void add_matrix(Program& program) {
  const auto arguments = std::make_shared<MatrixArguments>();
  Command command = program.command("Measure", "matrix",
                                    "Runs every detector on every fault, after the program without a fault");
  command
      .option("--only LIST", std::ref(arguments->only),
              "numbers of the faults, separated by commas (default: all)")
      .separated_by(',');
  command
      .option("--detectors LIST", std::ref(arguments->detectors),
              "laws, corpus, differential, fuzz, gate or tests, separated by commas (default: all)")
      .separated_by(',');
  command.flag("--first", arguments->first, "stop at the first detector of each fault");
  command.option("--json FILE", std::ref(arguments->json),
                 "write one JSON object per fault; a second call continues the file");
  case_folder(command, arguments->cases);
  command.examples("  daylight mutants matrix --only 101,102 --json kills.jsonl", mutants_exit_codes);
  command.run([arguments] { return matrix(*arguments); });
}

void add_smoke(Program& program) {
  struct Arguments {
    unsigned count = std::size(smoke_mutants);
    std::string cases;
  };
  const auto arguments = std::make_shared<Arguments>();
  Command command = program.command("Measure", "smoke", "Plants a few faults that must be detected at once");
  command.number("--count N", std::ref(arguments->count), "number of faults", 1, std::size(smoke_mutants));
  case_folder(command, arguments->cases);
  command.examples("  daylight mutants smoke --count 2", mutants_exit_codes);
  command.run([arguments] { return smoke(arguments->count, arguments->cases); });
}

void add_self_check(Program& program) {
  const auto planted = std::make_shared<Planted>();
  Command command = program.command("Called by campaigns", "self-check",
                                    "Runs a fault on the pairs of a campaign until it is found");
  command.number("--mutant N", std::ref(planted->number), "number of the fault; 0 for none").required();
  command.number("--seed N", std::ref(planted->seed), "seed of the campaign").required();
  command.number("--first N", std::ref(planted->first), "index of the first pair").required();
  command.number("--pairs N", std::ref(planted->pairs), "number of pairs").required();
  command.option("--methods LIST", std::ref(planted->methods), "methods of the campaign").required();
  command.option("--families LIST", std::ref(planted->families), "families of the campaign")
      .separated_by(',')
      .required();
  command.option("--weights LIST", std::ref(planted->weights), "weights of the families");
  command.run([planted] { return self_check(*planted); });
}

}  // namespace

int main(int argc, char** argv) {
  try {
    Program program("daylight-mutants",
                    "Plants one fault at a time in this program, and reports which checks detect it.",
                    "daylight " DAYLIGHT_VERSION " with planted faults");
    for (const auto add : {add_list, add_matrix, add_smoke, add_self_check}) add(program);
    return program.run(argc, argv);
  } catch (const UsageError& error) {
    std::cerr << "daylight-mutants: " << error.what() << '\n';
    return exit_usage;
  } catch (const std::exception& error) {
    std::cerr << "daylight-mutants: " << error.what() << '\n';
    return exit_harness_failed;
  }
}
