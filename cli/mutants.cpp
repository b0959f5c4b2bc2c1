// SPDX-License-Identifier: MIT
#include "cli/mutants.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "base/safe_text.hpp"
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
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  execv(program.c_str(), words.data());
  throw std::system_error(errno, std::generic_category(), program);
}

Smoke smoke_mutants(unsigned count) {
  const std::string program = mutants_executable();
  if (program.empty()) return {};
  Smoke smoke;
  std::FILE* pipe = popen(fmt::format("{} smoke --count {}", shell_quoted(program), count).c_str(), "re");
  if (!pipe) throw std::system_error(errno, std::generic_category(), program);
  char part[256];
  while (std::fgets(part, sizeof part, pipe)) smoke.text += part;
  const int status = pclose(pipe);
  smoke.ran = true;
  smoke.alive = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return smoke;
}

void add_mutants(Program& program) {
  Command command = program.command("Guard", "mutants",
                                    "The kill matrix: one fault planted after the other, and who catches it");
  command.examples(
      "  daylight mutants matrix --only 101,102 --json kills.jsonl",
      "Hands its arguments to daylight-mutants; `daylight mutants --help` as seen there: list, matrix, "
      "smoke.");
  command.run_unparsed([](const std::vector<std::string>& arguments) -> int { become_mutants(arguments); });
}

}  // namespace cyl
