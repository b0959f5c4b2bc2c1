// SPDX-License-Identifier: MIT
#include "fuzz/ledger.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "corpus/pair_io.hpp"
#include "fuzz/record.hpp"

namespace cyl {
namespace {

#ifdef DAYLIGHT_FUZZ_ABORT
constexpr bool always_abort = true;
#else
constexpr bool always_abort = false;
#endif

std::string environment(const char* name) {
  const char* text = std::getenv(name);
  return text ? text : "";
}

}  // namespace

// Until buckets are named by what is left of a pair after shrinking: by its features and angle as they are.
std::string bucket_key(std::string_view method, std::string_view failure, const Pair& pair) {
  std::string key(method);
  key.append("/").append(failure).append("/");
  const Distance measured = distance(pair.a, pair.b);
  if (measured.verdict == Verdict::invalid) return key + "invalid";
  Stratum s = stratum_of(pair, measured);
  s.decade = 0;
  const std::string stratum = to_string(s);  // "side-rim <1e-7 1e-0"
  const std::size_t first = stratum.find(' '), second = stratum.rfind(' ');
  return key + stratum.substr(0, first) + '/' + stratum.substr(first + 1, second - first - 1);
}

// The low 48 bits of FNV-1a, four a letter, the highest first.
std::string letters_only(std::string_view key) {
  std::uint64_t h = 0xcbf29ce484222325;
  for (const char c : key) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::string letters;
  for (int shift = 44; shift >= 0; shift -= 4) letters += static_cast<char>('a' + (h >> shift & 15));
  return letters;
}

Ledger::Ledger(std::string_view target)
    : target_(target),
      out_(environment("DAYLIGHT_FUZZ_OUT")),
      abort_(always_abort || !environment("DAYLIGHT_FUZZ_ABORT").empty()) {
  if (out_.empty()) return;
  for (const char* folder : {"findings", "undecided"}) {
    std::filesystem::create_directories(out_ + "/" + folder);
    for (const auto& entry : std::filesystem::directory_iterator(out_ + "/" + folder))
      known_.insert(std::string(folder) + "/" + entry.path().filename().string());
  }
}

bool Ledger::is_new(const char* folder, const std::string& letters) {
  return known_.insert(std::string(folder) + "/" + letters).second;
}

void Ledger::keep(const char* folder, const std::string& letters, const Pair& pair) const {
  const Record record = encode_record(pair);
  std::ofstream(out_ + "/" + folder + "/" + letters, std::ios::binary)
      .write(reinterpret_cast<const char*>(record.data()), std::ssize(record));
}

void Ledger::add_finding(const Pair& pair, std::string_view method, std::string_view failure,
                         std::string_view what) {
  const std::string key = bucket_key(method, failure, pair), letters = letters_only(key);
  ++findings_;
  if (!abort_ && !is_new("findings", letters)) return;
  Case c;
  c.pair = pair;
  c.id = letters;
  c.source = target_;
  c.note = key + ": " + std::string(what);
  const std::string line = format_case(c);
  std::fprintf(stderr, "%s\n", line.c_str());
  if (!out_.empty()) {
    keep("findings", letters, pair);
    std::ofstream(out_ + "/findings.jsonl", std::ios::app) << line << '\n';
  }
  if (!abort_) return;
  std::fprintf(stderr, "DEDUP_TOKEN: %s\n", letters.c_str());
  std::abort();
}

void Ledger::add_undecided(const Pair& pair, const Stratum& stratum) {
  if (out_.empty()) return;
  const std::string letters = letters_only(to_string(stratum));
  if (is_new("undecided", letters)) keep("undecided", letters, pair);
}

}  // namespace cyl
