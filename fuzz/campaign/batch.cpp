// SPDX-License-Identifier: MIT
#include "fuzz/campaign/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "corpus/store/representatives.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/cells.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

using Clock = std::chrono::steady_clock;

std::uint64_t nanoseconds_since(Clock::time_point start) {
  return static_cast<std::uint64_t>(std::chrono::nanoseconds(Clock::now() - start).count());
}

/// Returns the answers of the methods that were asked, in the form of FindingRecord::answers.
std::string answers_text(std::span<const std::unique_ptr<Method>> methods,
                         std::span<const MethodAnswer> answers, auto asked) {
  std::vector<std::pair<std::string, std::string>> named;  // each different answer, with names
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (!asked(m)) continue;
    const std::string answer = format_method_answer(answers[m]);
    const auto same = std::ranges::find(named, answer, &std::pair<std::string, std::string>::first);
    if (same == named.end())
      named.emplace_back(answer, quote_json(methods[m]->name()));
    else
      same->second += ',' + quote_json(methods[m]->name());
  }
  std::string text;
  for (const auto& [answer, names] : named)
    text += fmt::format("{}[{},[{}]]", text.empty() ? "" : ",", answer, names);
  return '[' + text + ']';
}

/// A method that hangs on three pairs of a batch, a second and more each, is not asked about the rest of the
/// batch. The remaining pairs count as declined.
constexpr Caps batch_caps{.hangs = 3};

/// Indices of a batch of our methods alone that are worked on together: so few that the answers stay in the
/// cache. A batch with foreign methods is worked on as a whole, so that they are asked in one go.
constexpr std::uint64_t own_stretch_size = 512;

/// The work on a batch, stretch by stretch: each step fills one of the members at the end.
class Batch {
 public:
  /// `kept_before`: of the batches before this that the same process made.
  Batch(const Workload& workload, std::uint64_t seed, Asker& asker, Representatives& kept_before)
      : workload_(workload),
        seed_(seed),
        asker_(asker),
        kept_before_(kept_before),
        offers_(workload.methods),
        foreign_(any_foreign(workload)),
        by_family_(family_count(workload)) {
    counts_.resize(rows() * by_family_.size());
  }

  void work_on(std::uint64_t first, std::uint64_t next) {
    draw_pairs(first, next);
    ask_own_methods();
    ask_foreign_methods([&](std::size_t m, std::size_t p) { return on_share(m, p); });
    for (std::size_t p = 0; p < pairs_.size(); ++p) judge_once(p), compare_all(p);
    ask_foreign_methods([&](std::size_t m, std::size_t p) { return !asked(m, p) && in_dispute(p); });
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      if (!in_dispute(p)) continue;
      // The answers of the costly methods may prove a pair that was undecided before.
      if (trials_[p].truth.verdict == Verdict::undecided) judge_once(p);
      compare_all(p);
    }
    repeat_own_methods();
    ask_findings_again();
    for (std::size_t p = 0; p < pairs_.size(); ++p) count_all(p), count_cells(p);
  }

  BatchRecord finish() {
    BatchRecord record;
    for (std::size_t row = 0; row < rows(); ++row)
      for (std::size_t family = 0; family < by_family_.size(); ++family)
        if (const Counts& tally = counts(row, family); tally.asked > 0)
          record.tallies.push_back({row_name(row), family_name(family), tally});
    record.groups = kept_.groups();
    record.findings = std::move(findings_);
    record.cells = cells_.records();
    return record;
  }

 private:
  std::size_t methods() const { return workload_.methods.size(); }
  std::size_t corpus_row_index() const { return methods(); }
  std::size_t referee_row_index() const { return methods() + 1; }
  std::size_t stage_row_index(Stage stage) const { return methods() + 2 + static_cast<std::size_t>(stage); }
  std::size_t rows() const { return methods() + 2 + stage_rows.size(); }
  std::uint64_t index_of(std::size_t p) const { return first_ + p; }
  /// Returns whether the pair is drawn for this method, for which the answers of other methods do not
  /// matter.
  bool on_share(std::size_t m, std::size_t p) const {
    return cyl::on_share(workload_.methods[m]->share(), seed_, index_of(p));
  }

  FamilyIndex family_index_of(std::uint64_t index) const { return cyl::family_index_of(workload_, index); }
  std::string family_name(std::size_t family) const { return cyl::family_name(workload_, family); }
  std::string row_name(std::size_t row) const {
    if (row < methods()) return std::string(workload_.methods[row]->name());
    if (row == corpus_row_index()) return corpus_row;
    return row == referee_row_index() ? referee_row : stage_rows[row - stage_row_index(Stage::filter)];
  }
  /// asked_ and wrong_ lie as answers_ does.
  std::size_t at(std::size_t m, std::size_t p) const { return p * methods() + m; }
  bool asked(std::size_t m, std::size_t p) const { return asked_[at(m, p)]; }
  Counts& counts(std::size_t row, std::size_t family) { return counts_[row * by_family_.size() + family]; }
  std::span<const MethodAnswer> answers_of(std::size_t p) const {
    return std::span(answers_).subspan(at(0, p), methods());
  }

  void draw_pairs(std::uint64_t first, std::uint64_t next) {
    first_ = first;
    pairs_.clear();
    for (auto& family : by_family_) family.clear();
    trials_.resize(next - first);
    for (std::uint64_t i = first; i < next; ++i) {
      by_family_[family_index_of(i).family].push_back(pairs_.size());
      trials_[i - first].pair = pairs_.emplace_back(pair_at(workload_, seed_, family_index_of(i)));
    }
    answers_.assign(pairs_.size() * methods(), {});
    asked_.assign(pairs_.size() * methods(), false);
    wrong_.assign(pairs_.size() * methods(), {});
    judging_.assign(pairs_.size(), 0);
  }

  // The clock is read once per family and method, not once per call: our calls take less than it does.
  void ask_own_methods() {
    for (std::size_t m = 0; m < methods(); ++m) {
      Method& method = *workload_.methods[m];
      if (method.foreign()) continue;
      for (std::size_t family = 0; family < by_family_.size(); ++family) {
        const auto start = Clock::now();
        for (const std::size_t p : by_family_[family]) {
          if (!on_share(m, p)) continue;
          answers_[at(m, p)] = ask_noexcept(method, pairs_[p], CallMode::usual);
          asked_[at(m, p)] = true;
        }
        counts(m, family).nanoseconds += nanoseconds_since(start);
      }
    }
  }

  void ask_foreign_methods(auto wanted) {
    std::vector<Question> questions;
    for (std::size_t m = 0; m < methods(); ++m) {
      if (!workload_.methods[m]->foreign()) continue;
      for (std::size_t family = 0; family < by_family_.size(); ++family)
        for (const std::size_t p : by_family_[family])
          if (wanted(m, p)) questions.push_back({m, p, CallMode::usual, static_cast<unsigned>(family)});
    }
    if (questions.empty()) return;
    const std::vector<ContainedAnswer> said = asker_.ask(pairs_, questions);
    // The pairs of a block that were not answered count as costly as the answered ones.
    struct Block {
      double time = 0;
      std::size_t answered = 0, all = 0;
    };
    std::map<std::pair<std::size_t, std::size_t>, Block> blocks;  // by method and family
    for (std::size_t q = 0; q < questions.size(); ++q) {
      const auto [m, p, mode, family] = questions[q];
      answers_[at(m, p)] = said[q].answer;
      asked_[at(m, p)] = true;
      Block& block = blocks[{m, family}];
      ++block.all;
      if (said[q].answer.failure == Failure::hang)
        counts(m, family).hung_nanoseconds += static_cast<std::uint64_t>(said[q].nanoseconds);
      if (said[q].answer.status == Status::failed) continue;
      ++block.answered;
      block.time += said[q].nanoseconds;
    }
    for (const auto& [of, block] : blocks)
      if (block.answered > 0)
        counts(of.first, of.second).nanoseconds += static_cast<std::uint64_t>(
            block.time / static_cast<double>(block.answered) * static_cast<double>(block.all));
  }

  /// Adds to the time of the pair, which count_all() gives to the row of the stage that had the last word.
  void judge_once(std::size_t p) {
    const auto offered = offers_.with_own_witness(pairs_[p], answers_of(p));
    const auto start = Clock::now();
    trials_[p].truth = judge_verdict(pairs_[p], offered);
    judging_[p] += nanoseconds_since(start);
  }

  void compare_all(std::size_t p) {
    trials_[p].forget_distance();
    for (std::size_t m = 0; m < methods(); ++m)
      if (asked(m, p))
        wrong_[at(m, p)] = compare(trials_[p], workload_.methods[m]->claim(), answers_of(p)[m]);
  }

  bool in_dispute(std::size_t p) const {
    if (trials_[p].truth.verdict == Verdict::undecided) return true;
    for (std::size_t m = 0; m < methods(); ++m) {
      const auto& wrong = wrong_[at(m, p)];
      if (wrong && wrong->severity == Severity::contract && is_wrong_verdict(wrong->kind)) return true;
    }
    return false;
  }

  void count_statement(std::size_t p) {
    const auto& stated = workload_.cases[index_of(p)].truth;
    if (!stated) return;
    trials_[p].forget_distance();
    Counts& tally = counts(corpus_row_index(), 0);
    ++tally.asked;
    tally.undecided += *stated == Verdict::undecided;
    if (const auto wrong = compare_statement(trials_[p], *stated)) note(p, corpus_row_index(), *wrong);
  }

  void count_all(std::size_t p) {
    const std::size_t family = family_index_of(index_of(p)).family;
    for (std::size_t m = 0; m < methods(); ++m) {
      if (!asked(m, p)) continue;
      count_answer(counts(m, family), answers_of(p)[m]);
      if (wrong_[at(m, p)]) note(p, m, *wrong_[at(m, p)]);
    }
    if (family == 0) count_statement(p);
    for (const std::size_t row : {referee_row_index(), stage_row_index(trials_[p].truth.stage)}) {
      ++counts(row, family).asked;
      counts(row, family).nanoseconds += judging_[p];
    }
    if (trials_[p].truth.verdict == Verdict::undecided) {
      ++counts(referee_row_index(), family).undecided;
      note(p, referee_row_index(), {FindingKind::undecided_truth, Severity::unresolved, {}});
    }
  }

  void count_cells(std::size_t p) {
    if (!trials_[p].decided()) return;
    const std::size_t share = !foreign_ ? own_cell_share : index_of(p) < every_cell_until ? 1 : cell_share;
    if (share > 1 && RandomStream("cells", seed_, index_of(p)).below(share) != 0) return;
    const auto cells = cells_of(pairs_[p], trials_[p].truth.verdict);
    for (std::size_t plane = 0; plane < planes.size(); ++plane) {
      auto& counts = cells_.at(to_string(planes[plane]), cells[plane].x, cells[plane].y, methods());
      for (std::size_t m = 0; m < methods(); ++m)
        if (on_share(m, p)) cyl::count_answer(counts[m], answers_of(p)[m], wrong_[at(m, p)]);
    }
  }

  static void count_answer(Counts& counts, const MethodAnswer& answer) {
    ++counts.asked;
    if (answer.status == Status::declined) ++counts.declined;
    if (answer.status == Status::answered && answer.verdict == Verdict::undecided) ++counts.undecided;
  }

  void repeat_own_methods() {
    for (std::size_t p = (repeat_share - first_ % repeat_share) % repeat_share; p < pairs_.size();
         p += repeat_share) {
      for (std::size_t m = 0; m < methods(); ++m) {
        Method& method = *workload_.methods[m];
        if (method.foreign() || !asked(m, p) || wrong_[at(m, p)]) continue;
        if (!same_answer(ask_noexcept(method, pairs_[p], CallMode::usual), answers_of(p)[m]))
          wrong_[at(m, p)] = Finding{FindingKind::nondeterminism, Severity::contract, {}};
      }
    }
  }

  // A hang of a library of this build, which keeps nothing, would cost its second once more.
  bool is_worth_asking_again(std::size_t m, const Finding& wrong) const {
    const Method& method = *workload_.methods[m];
    return wrong.severity == Severity::contract && method.foreign() &&
           (method.guest() || wrong.kind != FindingKind::hang);
  }

  /// Asks in new workers, because a worker lives longer than a batch: a library may keep state from earlier
  /// questions, and then the pair alone does not fail.
  void ask_findings_again() {
    std::vector<Question> suspects;
    for (std::size_t p = 0; p < pairs_.size(); ++p)
      for (std::size_t m = 0; m < methods(); ++m)
        if (const auto& wrong = wrong_[at(m, p)]; wrong && is_worth_asking_again(m, *wrong))
          suspects.push_back({m, p});
    if (suspects.empty()) return;
    const std::vector<ContainedAnswer> said = ask_contained(workload_.methods, pairs_, suspects);
    for (std::size_t q = 0; q < said.size(); ++q) {
      const auto& [m, p, mode, run] = suspects[q];
      std::optional<Finding>& wrong = wrong_[at(m, p)];
      const auto again = compare(trials_[p], workload_.methods[m]->claim(), said[q].answer);
      if (again && again->kind == wrong->kind) continue;
      MethodAnswer& answer = answers_[at(m, p)];
      const std::string where = fmt::format("; after indices {} to {}, not alone", first_, index_of(p));
      std::string what = to_string(wrong->kind);
      if (answer.reason[0] != 0) what.append(": ").append(answer.reason);
      answer.set_reason(what.substr(0, sizeof answer.reason - 1 - where.size()) + where);
      wrong = Finding{FindingKind::state_dependent, Severity::contract, wrong->margin};
    }
  }

  void note(std::size_t p, std::size_t row, const Finding& finding) {
    const FamilyIndex drawn = family_index_of(index_of(p));
    Counts& tally = counts(row, drawn.family);
    const bool broke =
        finding.kind == FindingKind::state_dependent && answers_of(p)[row].status == Status::failed;
    if (is_failure(finding.kind) || broke)
      ++tally.failed;
    else if (finding.severity == Severity::contract)
      ++tally.contract;
    else if (finding.severity == Severity::resolution)
      ++tally.resolution;
    FindingRecord record;
    static_cast<FindingGroup&>(record) = {row_name(row), finding.kind, finding.severity,
                                          family_name(drawn.family)};
    record.index = index_of(p);
    record.family_index = drawn.index;
    record.margin = finding.margin;
    // Both count it. The job's findings of earlier batches make most findings of a later batch needless
    // (representatives.cpp has the proof).
    const bool of_batch = kept_.admit(record), of_job = kept_before_.admit(record);
    if (!of_batch || !of_job) return;
    if (findings_.empty() || findings_.back().index != record.index) {
      record.pair = format_case_at(workload_, seed_, index_of(p), drawn, pairs_[p], trials_[p].truth);
      record.answers =
          answers_text(workload_.methods, answers_of(p), [&](std::size_t m) { return asked(m, p); });
      record.truth = format_truth(judge(pairs_[p], offers_.with_own_witness(pairs_[p], answers_of(p))));
    } else {
      const FindingRecord& same = findings_.back();
      std::tie(record.pair, record.answers, record.truth) = std::tie(same.pair, same.answers, same.truth);
    }
    const bool has_reason = is_failure(finding.kind) || finding.kind == FindingKind::side_effect ||
                            finding.kind == FindingKind::state_dependent;
    if (row < methods() && has_reason) record.reason = answers_of(p)[row].reason;
    findings_.push_back(std::move(record));
  }

  const Workload& workload_;
  const std::uint64_t seed_;
  Asker& asker_;
  Representatives& kept_before_;
  WitnessSet offers_;
  const bool foreign_;  ///< some of the methods are

  // These belong to the stretch. The answers to one pair lie together, as the referee takes them.
  std::uint64_t first_ = 0;
  std::vector<std::vector<std::size_t>> by_family_;
  std::vector<Pair> pairs_;
  std::vector<MethodAnswer> answers_;
  std::vector<bool> asked_;
  std::vector<std::optional<Finding>> wrong_;
  std::vector<Trial> trials_;           ///< whose answers and findings are those above
  std::vector<std::uint64_t> judging_;  ///< nanoseconds

  // These belong to the batch. The counts have a row for each method, the corpus and the referee, and a
  // column for each family.
  std::vector<Counts> counts_;
  Representatives kept_;
  std::vector<FindingRecord> findings_;
  CellTable cells_;
};

}  // namespace

std::function<BatchRecord(std::uint64_t, std::uint64_t)> batch_maker(const Workload& workload,
                                                                     std::uint64_t seed) {
  struct Kept {
    Asker asker;
    Representatives findings;
  };
  return [&workload, seed, kept = std::make_shared<Kept>(Kept{Asker(workload.methods, batch_caps), {}})](
             std::uint64_t first, std::uint64_t next) {
    Batch batch(workload, seed, kept->asker, kept->findings);
    const std::uint64_t stretch = any_foreign(workload) ? next - first : own_stretch_size;
    for (std::uint64_t at = first; at < next; at += stretch) batch.work_on(at, std::min(next, at + stretch));
    BatchRecord record = batch.finish();
    record.first = first;
    record.next = next;
    return record;
  };
}

}  // namespace cyl
