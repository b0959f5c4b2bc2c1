// SPDX-License-Identifier: MIT
// The manual page and the shell completion, made from --help.
#pragma once

#include <string>
#include <vector>

namespace cyl {

struct OptionText {
  std::string name;            ///< "--for", or "RUN" of an argument
  std::string value;           ///< "TEXT", "N"; empty of a flag
  std::string help, standard;  ///< the default, if there is one
};

struct CommandText {
  std::string group, name, summary, footer;
  std::vector<OptionText> options;
};

/// A description of the program, and its commands in the order of --help.
struct ProgramText {
  std::string name, summary, version, footer;
  std::vector<CommandText> commands;
};

/// Returns the page for man(1), in troff with the macros of man(7).
std::string man_page(const ProgramText& program);

/// Returns a script for bash that completes commands, their options, and files.
std::string bash_completion(const ProgramText& program);

}  // namespace cyl
