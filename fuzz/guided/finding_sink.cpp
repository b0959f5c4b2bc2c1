// SPDX-License-Identifier: MIT
#include "fuzz/guided/finding_sink.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "corpus/pairs/pair_io.hpp"
#include "fuzz/guided/record.hpp"
#include "oracles/trial/failure_key.hpp"

namespace cyl {
namespace {

std::string environment(const char* name) {
  const char* text = std::getenv(name);
  return text ? text : "";
}

}  // namespace

FindingSink::FindingSink()
    : out_(environment("DAYLIGHT_FUZZ_OUT")), abort_(!environment("DAYLIGHT_FUZZ_ABORT").empty()) {
  if (out_.empty()) return;
  std::filesystem::create_directories(out_);
  for (const char* folder : {"findings", "undecided"})
    std::filesystem::create_directories(out_ + "/" + folder);
}

// Several processes may share the folder. The one that creates the file has the finding.
bool FindingSink::keep_first(const std::string& name, const Pair& pair) {
  if (!known_.insert(name).second) return false;
  if (out_.empty()) return true;
  std::FILE* const file = std::fopen((out_ + "/" + name).c_str(), "wbx");
  if (!file) return false;
  const Record record = encode_record(pair);
  std::fwrite(record.data(), 1, record.size(), file);
  std::fclose(file);
  return true;
}

// Until causes are named by what is left of a pair after shrinking: by its features and angle as they are.
std::string FindingSink::add_finding(const Pair& pair, std::string_view method, std::string_view failure,
                                     std::string_view what) {
  const std::string key = failure_key_of(method, failure, pair), letters = letter_hash(key);
  ++findings_;
  const bool first = keep_first("findings/" + letters, pair);
  if (!abort_ && !first) return {};
  std::fprintf(stderr, "%s: %s: %s\n", key.c_str(), std::string(what).c_str(), format_pair(pair).c_str());
  if (abort_) std::abort();
  return letters;
}

void FindingSink::add_broken(const Pair& pair, std::string_view method, std::string_view law,
                             std::string_view what) {
  const std::string letters = add_finding(pair, method, law, what);
  if (letters.empty() || out_.empty()) return;
  const std::string line = std::string(method).append(" breaks ").append(law).append(": ").append(what);
  std::ofstream(out_ + "/broken", std::ios::app) << line + "; record " + letters + '\n';
}

void FindingSink::add_undecided(const Pair& pair, const Stratum& stratum) {
  if (!out_.empty()) keep_first("undecided/" + letter_hash(to_string(stratum)), pair);
}

}  // namespace cyl
