// SPDX-License-Identifier: MIT
// Writes a finding for the maintainers of a library. It has a program that needs only their library (or the
// guest), a proof that needs only Python, and the text of an issue.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/methods/guest.hpp"
#include "oracles/trial/trial.hpp"
#include "reports/export/export_guest.hpp"

namespace cyl {

/// The files of the folder.
struct Export {
  std::string program_name;  ///< reproduce.cpp; of guests see guest_program_name()
  std::string program;
  std::string build;                ///< build.sh: builds the program beside itself and runs it
  std::string check;                ///< exact.py
  std::string issue;                ///< issue.md
  std::vector<SentFile> files{};    ///< copied beside them: what a guest is made of
  std::string test_name{}, test{};  ///< in the framework of SentBeside, if it has one
};

/// Further inputs of an export.
struct SentBeside {
  std::vector<std::string> sources;  ///< of a guest; the first is what a plug-in is compiled of
  std::optional<Pair> worst;         ///< on which it fails of the same cause by the greatest margin known
  std::string framework{};           ///< one of test_frameworks(), in which a test is written too
};

/// Asks the method again, contained. Throws UsageError if no method has that name, if no program can be
/// written for it, or if it does not fail in this way on this pair now. Throws std::runtime_error if it
/// fails only because axes are rounded. If the pair is at the edge of the claim and the worst is not,
/// the export is about the worst and mentions the pair. The files do not contain a path of this
/// machine.
Export make_export(std::span<const std::unique_ptr<Method>> methods, std::string_view method,
                   FindingKind kind, const Pair& pair, std::span<const Guest> guests = {},
                   const SentBeside& beside = {});

/// Creates the folder if it does not exist, and overwrites an earlier export. Throws std::runtime_error that
/// names a file that cannot be written.
void write_export(const Export& files, const std::string& folder);

}  // namespace cyl
