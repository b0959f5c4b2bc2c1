// SPDX-License-Identifier: MIT
// A program that asks a guest about one pair without daylight: in C of a plug-in, in Python of a command.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "oracles/methods/guest.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {

/// Returns whether such a program can show a finding of this kind.
bool guest_program_shows(FindingKind kind);

/// Returns "reproduce.c" or "reproduce.py".
std::string guest_program_name(const Guest& guest);

/// Returns a program that prints the guest's answer and the truth. It exits with 1 if the answer is wrong as
/// in the finding, and with 0 if it is right. The program of a plug-in ends as the plug-in does. `asked` must
/// have a finding of a kind that guest_program_shows().
std::string guest_program(const Guest& guest, const Trial& asked, const Claim& claim);

/// Returns build.sh, which asks what lies beside it (a plug-in's library, or one built of its source; a
/// command's files), or another file or command that is given.
std::string guest_build(const Guest& guest, FindingKind kind, std::span<const std::string> sources);

/// A file that is sent.
struct SentFile {
  std::string file;  ///< its path
  std::string name;  ///< in the folder that is sent
};

/// Returns the sources. Without sources it returns the plug-in's library, or the files that a command names
/// and those that these import (node_program.hpp).
std::vector<SentFile> guest_files(const Guest& guest, std::span<const std::string> sources);

/// Returns the npm packages that the files import: "cannon-es@0.20.0".
std::set<std::string> npm_packages(std::span<const SentFile> files);

/// Returns the plug-in's file, or the command, without a path of this machine.
std::string guest_in_words(const Guest& guest);

/// Returns a text, as the guest's own words, without the folders of this machine in front of files.
std::string without_folders(std::string text, const Guest& guest);

}  // namespace cyl
