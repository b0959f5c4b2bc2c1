// SPDX-License-Identifier: MIT
// A campaign of two halves: its pairs are written down, answered elsewhere (another machine, another system,
// a GPU), and the answers judged here as a campaign judges them. Questions are lines of pair_io, answers
// lines of guest_protocol.hpp with the `id` of their question, in any order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "corpus/pairs/finding.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/representatives.hpp"
#include "fuzz/campaign/batch.hpp"
#include "oracles/methods/guest_protocol.hpp"

namespace cyl {

/// Pair `index` of a campaign with this seed and workload, for a method elsewhere. Its id is index + 1. It
/// does not contain the truth.
Case question_at(const Workload& workload, std::uint64_t seed, std::uint64_t index);

/// Called for an invalid line, which is skipped.
using OnBadLine = std::function<void(const std::string& file, std::size_t line, const std::string& what)>;

/// The pairs of a file, by id. About 400 bytes a pair.
class Questions {
 public:
  /// Reads the whole file. A line that is not a pair, or that repeats an id, is reported and skipped. The id
  /// of a line without one is its line number. Throws std::runtime_error if the file cannot be read.
  Questions(const std::string& file, const OnBadLine& on_bad_line);

  struct Question {
    Case asked;
    std::uint32_t family;      ///< index into families()
    std::size_t answered = 0;  ///< line of the answer; 0 if there is none yet
  };
  /// Returns the question of that id, or nullptr.
  Question* find(const std::string& id);
  const std::vector<Question>& all() const { return all_; }
  const std::vector<std::string>& families() const { return families_; }
  const std::string& file() const { return file_; }

 private:
  std::string file_;
  std::vector<Question> all_;
  std::unordered_map<std::string, std::size_t> by_id_;
  std::vector<std::string> families_;
};

/// A finding that is kept: the first of each kind, and each with a larger error than all earlier ones.
struct JudgedFinding {
  Finding finding;
  std::string family;
  Case question;
  std::size_t line;  ///< line of the answer; 0 if none came
  MethodAnswer answer;
  Truth truth;  ///< with its certificate
  Enclosure distance;
};

class OfflineJudge {
 public:
  /// `name` and `relative` are of the method and its claim. If they are empty, they are read from a hello
  /// line in the answers. `questions` is null if each answer has its own a and b.
  OfflineJudge(std::string name, std::optional<double> relative, Questions* questions, OnBadLine on_bad_line);

  /// Judges all answers of a stream, and then the pairs without an answer. Messages call the stream `file`.
  /// Calls `on_progress` often, with the number of lines read.
  void judge_all(std::istream& in, const std::string& file,
                 const std::function<void(std::uint64_t lines)>& on_progress = {});

  const std::string& name() const { return name_; }
  const Claim& claim() const { return claim_; }
  std::vector<TallyRecord> tallies() const;  ///< of the method and the referee, by family
  std::vector<GroupRecord> groups() const { return kept_.groups(); }
  const std::vector<JudgedFinding>& findings() const { return findings_; }
  std::uint64_t lines_passed_over() const { return passed_over_; }  ///< reported, but without a pair
  /// As for a campaign. 2: contract findings, failures, or lines without a pair. 3: undecided truth. Else 0.
  int exit_code() const;

 private:
  void take(const std::string& file, std::size_t line, std::string_view text);
  void judge_answer(const Case& question, std::size_t line, std::uint32_t family, const MethodAnswer& answer,
                    bool again = false);
  void skip(const std::string& file, std::size_t line, const std::string& what);
  std::uint32_t family_of(const Case& question);
  Counts& counts(std::uint32_t family);

  const std::optional<double> relative_;
  Questions* questions_;
  OnBadLine on_bad_line_;
  bool depth_at_most_ = false;  ///< as the hello states
  std::string name_, claim_source_;
  Claim claim_;
  bool begun_ = false;
  std::unique_ptr<Method> certifying_;
  std::vector<std::string> families_;
  std::vector<Counts> counts_, judged_;  // a family each
  Representatives kept_;
  std::vector<JudgedFinding> findings_;
  std::uint64_t passed_over_ = 0;
};

}  // namespace cyl
