// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>

#include "base/usage_error.hpp"
#include "cli/build_info.hpp"
#include "cli/commands.hpp"

namespace {

int run(int argc, char** argv) {
  CLI::App app{"Is there daylight between two cylinders? Answers with a proof, and finds who gets it wrong."};
  int exit_code = cyl::exit_pass;
  app.name("daylight");
  app.require_subcommand(1);
  app.set_version_flag("--version", cyl::build_info().text());
  app.footer("daylight COMMAND --help tells more, with an example.");
  cyl::add_check(app, exit_code);
  cyl::add_campaign(app, exit_code);
  cyl::add_merge(app, exit_code);
  cyl::add_replay(app, exit_code);
  cyl::add_triage(app, exit_code);
  cyl::add_explain(app, exit_code);
  cyl::add_fuzz(app, exit_code);
  cyl::add_gate(app, exit_code);
  cyl::add_worst(app, exit_code);
  cyl::add_scene(app, exit_code);
  cyl::add_mutants(app, exit_code);
  cyl::add_families(app, exit_code);
  cyl::add_bench(app, exit_code);
  cyl::add_chart(app, exit_code);
  try {
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0 && app.get_subcommands().empty()) {
      std::cerr << "daylight: "
                << (argc > 1 ? "no command '" + std::string(argv[1]) + "'" : "no command given") << "\n\n"
                << app.help();
      return cyl::exit_usage;
    }
    return app.exit(error) == 0 ? cyl::exit_pass : cyl::exit_usage;  // 0: --help, --version
  } catch (const cyl::UsageError& error) {
    std::cerr << "daylight: " << error.what() << '\n';
    return cyl::exit_usage;
  }
}

}  // namespace

// Standard output is written through stdio alone, so that one flush at the end tells whether all of it
// arrived.
int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_DFL);
  std::ios::sync_with_stdio(false);
  int exit_code = cyl::exit_harness_failed;
  try {
    exit_code = run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "daylight: " << error.what() << '\n';
  }
  std::cout.flush();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    std::fputs("daylight: standard output could not be written\n", stderr);
    return cyl::exit_harness_failed;
  }
  return exit_code;
}
