// SPDX-License-Identifier: MIT
// Writes a finding for the maintainers of a library. It has a proof that needs only Python, and the text of
// an issue. A packaged library also gets a program that needs only this library, and a guest gets the case.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "oracles/methods/guest.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {

/// The texts of the folder, by the names of their files: exact.py and issue.md. A packaged library also has
/// reproduce.cpp, and build.sh, which builds the program beside itself and runs it. A guest has case.jsonl.
/// If it is known how to install its library, it also has its own files and reproduce.sh, which runs them.
using Export = std::map<std::string, std::string>;

/// Returns the command that asks the guest again about the case in the file. `daylight` is how the program is
/// called.
std::string command_for(const std::string& daylight, const std::string& file, const Guest& guest);

/// Asks the method again, contained. `guest` is the method's guest, or null if it is of a packaged library.
/// Throws UsageError if no method has that name, if nothing can be written for it, or if it does not fail in
/// this way on this pair now. Throws std::runtime_error if it fails only because axes are rounded. The files
/// do not contain a path of this machine.
Export make_export(std::span<const std::unique_ptr<Method>> methods, std::string_view method,
                   FindingKind kind, const Pair& pair, const Guest* guest = nullptr);

/// Returns why make_export() refuses the pair without asking the method, or an empty text.
std::string refusal(std::string_view method, FindingKind kind, const Pair& pair, bool is_guest);

/// Returns whether a failure convinces the maintainers: its proved error exceeds the claim by far.
bool is_clear(const Trial& asked, const Claim& claim);

/// Creates the folder if it does not exist, and overwrites an earlier export. Throws std::runtime_error that
/// names a file that cannot be written.
void write_export(const Export& files, const std::string& folder);

}  // namespace cyl
