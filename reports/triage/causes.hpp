// SPDX-License-Identifier: MIT
// Findings put together by their cause, with all that a reader needs to see of each cause.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/enum_words.hpp"
#include "base/json.hpp"
#include "corpus/store/run_store.hpp"
#include "oracles/methods/method.hpp"
#include "reports/triage/triage_store.hpp"

namespace cyl {

struct TriageRecords;

/// Since earlier runs.
enum class Recurrence : unsigned char {
  fresh,  ///< no earlier run has it; its word is "new"
  known,
  gone  ///< the last run has it, this one does not, and its method is right on its pair now
};
constexpr auto words_of(Recurrence) noexcept { return std::array{"new", "known", "gone"}; }

/// A pair that is shown of a cause.
struct ShownCase {
  Pair pair;
  std::optional<Enclosure> margin;  ///< |distance| / size; empty if it is not known
  std::string page;                 ///< the same with truth and answers: interface Case of the page, as JSON
};

/// A cause: the findings with this cause, and the data that is shown of them.
struct Cause {
  std::string key;
  std::string method;                              ///< of the finding that the simplest pair comes from
  FindingKind kind = FindingKind::wrong_disjoint;  ///< of the same finding
  std::set<std::string> methods, families;
  std::set<std::string> methods_of_kind;     ///< those that fail in the way of `kind`
  Severity severity = Severity::resolution;  ///< of all its findings
  std::uint64_t count = 0;                   ///< findings, kept or not
  std::vector<std::int64_t> findings;        ///< ids of the stored findings
  std::optional<Enclosure> margin;  ///< the least and the greatest lower bound, of findings of that kind
  ShownCase simplest;
  std::optional<ShownCase> worst;    ///< empty if the worst finding is another pair that hangs
  bool simplified = false;           ///< the simplest is; else it is as it was found
  bool seen_again = false;           ///< its method, asked alone, failed on the simplest
  std::string description;           ///< in words
  std::vector<std::string> labels;   ///< the cause and further labels
  std::optional<Recurrence> status;  ///< empty if there is no earlier run
  bool asked_before = false;         ///< an earlier run asked its method about its families
  std::string first_seen, last_seen;
  std::string first_version, last_version;  ///< of its method, then
};

/// The causes of a triaged run, for the comparison of runs.
struct TriagedRun {
  std::string folder, id, started;
  std::vector<MethodRecord> methods;  ///< those that are here
  std::vector<TallyRecord> tallies;
  std::vector<Cause> causes;
  double part = 1;  ///< of its findings that were looked at
};

/// In the form of the page's Cause, in which it is stored too.
nlohmann::json to_json(const Cause& cause);
nlohmann::json to_json(const std::vector<Cause>& causes);
/// Reads the output of to_json(). Throws nlohmann::json::exception if the value has another form.
Cause cause_from_json(const nlohmann::json& stored);

/// Makes the causes, by key. Status, first and last seen are not set. The
/// worst pair is that of the findings. The simplest pair is one on which its method, asked alone, fails now.
/// If there is none, it is the first that was found, with its stored answer. Asks every method about the
/// simplest and the worst pair of each cause. Once
/// `out_of_time()`, a cause is as in `last`, the result of the last triage, and of a new one only the own
/// method is asked, about the simplest pair.
std::vector<Cause> make_causes(const TriageRecords& records, const GroupedMethods& methods,
                               const std::vector<Cause>& last, const std::function<bool()>& out_of_time);

/// A failure that no stored finding of the run has: on pairs that only an earlier run drew.
struct NewFault {
  std::uint64_t pairs = 0;
  Pair pair = {};  ///< the simplest of them
  std::size_t method = 0;
  Finding finding = {};
  std::string family = {};
};
/// Makes its cause, about which every method is asked.
Cause make_cause(const std::string& key, const NewFault& fault, const GroupedMethods& methods,
                 const std::string& run_folder, const std::function<bool()>& out_of_time);

/// Returns the version of the method, or an empty text.
std::string version_in(const std::vector<MethodRecord>& methods, const std::string& name);

/// Returns whether the stored pair of an earlier run's cause fails now as it did then, or nothing if that is
/// unknown.
using FailsToday = std::function<std::optional<bool>(const Cause&)>;

/// Sets status, first and last seen of the run's causes, compared with `earlier` triaged runs, the earliest
/// first. A cause in `certainly_new` is new at any rate, even if its key is known. Adds the causes of the
/// last one that the run does not have: known if the method fails on the stored pair now, gone if it is
/// right. Methods that the run did not ask lose nothing. New causes come first, then those that are known and
/// gone. Within these, those beyond claims come first, then those of ordinary sizes, then by count.
void compare_with_earlier(TriagedRun& run, const std::vector<TriagedRun>& earlier,
                          const FailsToday& fails_today, const std::set<std::string>& certainly_new = {});

/// Returns "libccd-mpr.wrong_disjoint" for that key with '/': the name of the files of a cause's pairs,
/// without the ending. Characters that a file name should not have are replaced, and letters distinguish such
/// names.
std::string file_name_of(std::string_view key);

/// Whether the cause is new, but no earlier run tested its method on its families.
bool is_of_new_families(const Cause& cause);
/// Returns "2 new causes (1 beyond a claim), 34 known, 1 gone", without zeros, or "35 causes" without an
/// earlier run. Then states for how many is_of_new_families() holds.
std::string what_changed(const std::vector<Cause>& causes);

/// Returns how the pair is called that a cause shows: "the simplest pair" if it was simplified.
inline std::string shown_in_words(const Cause& cause) {
  return cause.simplified ? "the simplest pair" : "a pair (not simplified)";
}

/// A line a cause: findings, margins, what is wrong and the simplest pair.
std::string format_causes(const std::vector<Cause>& causes);

}  // namespace cyl
