// SPDX-License-Identifier: MIT
// The notes and owners of causes. notes.jsonl beside the runs stores them, so the next run's page has
// them too. One JSON object a line: {"cause":"libccd-mpr/hang","owner":"ada","note":"reported
// upstream"}.
#pragma once

#include <map>
#include <string>

namespace cyl {

struct CauseNote {
  std::string owner, note;
};

/// Returns the name of the file that the run in a folder shares with those beside it.
std::string notes_file_of(const std::string& run_folder);

/// Returns the notes by cause, which are empty if the file does not exist. Throws UsageError with the file's
/// name and line if a line is not a note.
std::map<std::string, CauseNote> read_notes(const std::string& file);

/// Replaces the note of a cause, atomically. An empty note without owner removes it. Throws like
/// read_notes(), and std::runtime_error if it cannot write.
void write_note(const std::string& file, const std::string& cause, const CauseNote& note);

}  // namespace cyl
