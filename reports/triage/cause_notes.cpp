// SPDX-License-Identifier: MIT
#include "reports/triage/cause_notes.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>

#include "base/files.hpp"
#include "base/json.hpp"
#include "base/usage_error.hpp"

namespace cyl {

namespace fs = std::filesystem;

std::string notes_file_of(const std::string& run_folder) {
  fs::path run = fs::path(run_folder).lexically_normal();
  if (!run.has_filename()) run = run.parent_path();
  if (run == "." || run.filename() == "..") run = fs::canonical(run);
  return (run.parent_path() / "notes.jsonl").string();
}

std::map<std::string, CauseNote> read_notes(const std::string& file) {
  std::map<std::string, CauseNote> notes;
  std::ifstream in(file);
  std::string text;
  for (std::size_t line = 1; std::getline(in, text); ++line) {
    if (text.find_first_not_of(" \t\r") == text.npos) continue;
    const auto told = nlohmann::json::parse(text, nullptr, false);
    const auto word = [&](const char* key) {
      const auto at = told.is_object() ? told.find(key) : told.end();
      if (!told.is_object() || at == told.end() || !at->is_string())
        throw UsageError(fmt::format("{}: line {} is not a note: {} must be a text", file, line, key));
      return at->get<std::string>();
    };
    const std::string cause = word("cause");
    notes[cause] = {word("owner"), word("note")};
  }
  return notes;
}

void write_note(const std::string& file, const std::string& cause, const CauseNote& note) {
  std::map<std::string, CauseNote> notes = read_notes(file);
  notes[cause] = note;
  std::string text;
  for (const auto& [key, of] : notes) {
    if (of.owner.empty() && of.note.empty()) continue;
    const nlohmann::ordered_json line{{"cause", key}, {"owner", of.owner}, {"note", of.note}};
    text += line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
  }
  replace_file(file, text);
}

}  // namespace cyl
