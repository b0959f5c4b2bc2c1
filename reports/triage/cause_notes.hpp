// SPDX-License-Identifier: MIT
// What people note of causes, and who looks after one: notes.jsonl beside the runs, so that the next night's
// page has them too. One JSON object a line: {"cause":"libccd-mpr/hang","owner":"ada","note":"reported
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

/// Returns the notes by cause; a file that is not there has none. Throws UsageError with the file's name and
/// the line where one is no note.
std::map<std::string, CauseNote> read_notes(const std::string& file);

/// Writes the note of a cause, in the place of an earlier one, all at once; an empty one, without owner,
/// takes it away. Throws as read_notes() does, and std::runtime_error where it cannot.
void write_note(const std::string& file, const std::string& cause, const CauseNote& note);

}  // namespace cyl
