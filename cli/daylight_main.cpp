// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>

#include "base/safe_text.hpp"
#include "base/usage_error.hpp"
#include "cli/build_info.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"

namespace {

/// An error may name what a stranger wrote.
void say(const std::exception& error) {
  std::cerr << "daylight: " << cyl::escaped_controls(error.what(), "\n\t") << '\n';
}

int run(int argc, char** argv) {
  cyl::Program program("daylight",
                       "Is there daylight between two solids? Answers with a proof, and finds the methods "
                       "that get it wrong.",
                       cyl::build_info().text());
  for (const auto add :
       {cyl::add_check, cyl::add_ask, cyl::add_judge, cyl::add_campaign, cyl::add_merge, cyl::add_fuzz,
        cyl::add_worst, cyl::add_replay, cyl::add_triage, cyl::add_export, cyl::add_chart, cyl::add_gate,
        cyl::add_bench, cyl::add_scene, cyl::add_families, cyl::add_vectors})
    add(program);
  try {
    return program.run(argc, argv);
  } catch (const cyl::UsageError& error) {
    say(error);
    return cyl::exit_usage;
  } catch (const cyl::InputError& error) {
    say(error);
    return cyl::exit_invalid_input;
  }
}

}  // namespace

// Only stdio writes standard output, so that one flush at the end shows whether all of it arrived.
int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_DFL);
  std::ios::sync_with_stdio(false);
  int exit_code = cyl::exit_harness_failed;
  try {
    exit_code = run(argc, argv);
  } catch (const std::exception& error) {
    say(error);
  }
  std::cout.flush();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    std::fputs("daylight: standard output could not be written\n", stderr);
    return cyl::exit_harness_failed;
  }
  return exit_code;
}
