// SPDX-License-Identifier: MIT
#include "cli/mutants.hpp"

#include <poll.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/process/child.hpp"
#include "base/process/process.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"

namespace cyl {

std::string mutants_executable() {
  const auto beside = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "daylight-mutants";
  return std::filesystem::exists(beside) ? beside.string() : std::string();
}

void become_mutants(const std::vector<std::string>& arguments) {
  const std::string program = mutants_executable();
  if (program.empty())
    throw std::runtime_error(
        "daylight-mutants is not beside this executable; it is built in a source tree (ninja "
        "daylight-mutants) and never installed");
  std::vector<std::string> command{program};
  command.insert(command.end(), arguments.begin(), arguments.end());
  become_program(command);
}

SelfTest self_test(unsigned count, std::optional<std::chrono::milliseconds> time) {
  using Clock = std::chrono::steady_clock;
  const std::string program = mutants_executable();
  if (program.empty()) return {};
  const auto start = Clock::now();
  Child child(std::vector<std::string>{program, "smoke", "--count", std::to_string(count)},
              {.own_group = true});
  constexpr int look_interval = 20;  // milliseconds
  while (!child.advance()) {
    if (time && Clock::now() - start >= *time) return {.ran = true, .cut = true, .passed = true, .text = {}};
    pollfd end{child.end(), POLLIN, 0};
    poll(&end, 1, look_interval);
  }
  return {.ran = true, .cut = false, .passed = child.status() == 0, .text = child.bytes()};
}

void add_mutants(Program& program) {
  Command command = program.command(
      "Guard", "mutants", "Plants one fault at a time in our own code, and reports which checks detect it");
  command.examples(
      "  daylight mutants list\n"
      "  daylight mutants matrix --only 101,102 --json kills.jsonl",
      "`list` lists the faults. `matrix` runs every detector on each of them. `smoke` plants a few faults "
      "that "
      "must be\ndetected at once. Each has its own --help. The program daylight-mutants, beside this one, "
      "runs "
      "them.\nExit code 2 of mutants means that a fault was not detected.");
  command.run_unparsed([](const std::vector<std::string>& arguments) -> int { become_mutants(arguments); });
}

}  // namespace cyl
