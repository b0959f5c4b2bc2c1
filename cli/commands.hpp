// SPDX-License-Identifier: MIT
// The commands of the one executable, a file each: add_<command> describes it to the parser; when it runs it
// leaves its exit code behind. A wrong argument throws UsageError, what the harness cannot do any other
// std::exception: main.cpp prints the text and turns the first into exit code 64, the others into 1.
#pragma once

namespace CLI {
class App;
}

namespace cyl {

inline constexpr int exit_pass = 0;
inline constexpr int exit_harness_failed = 1;
inline constexpr int exit_findings = 2;
inline constexpr int exit_undecided = 3;
inline constexpr int exit_usage = 64;
inline constexpr int exit_invalid_input = 65;

void add_bench(CLI::App& app, int& exit_code);
void add_campaign(CLI::App& app, int& exit_code);
void add_chart(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_explain(CLI::App& app, int& exit_code);
void add_families(CLI::App& app, int& exit_code);
void add_fuzz(CLI::App& app, int& exit_code);
void add_gate(CLI::App& app, int& exit_code);
void add_merge(CLI::App& app, int& exit_code);
void add_mutants(CLI::App& app, int& exit_code);
void add_replay(CLI::App& app, int& exit_code);
void add_scene(CLI::App& app, int& exit_code);
void add_triage(CLI::App& app, int& exit_code);
void add_worst(CLI::App& app, int& exit_code);

}  // namespace cyl
