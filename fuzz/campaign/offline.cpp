// SPDX-License-Identifier: MIT
#include "fuzz/campaign/offline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "base/exit_code.hpp"
#include "base/json.hpp"
#include "base/usage_error.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

/// The source of a question begins with this. A seed, a colon, a blank and FAMILY/INDEX follow.
constexpr std::string_view asked_by = "daylight ask --seed ";
/// The family of pairs that no campaign drew.
constexpr const char* given_family = "given";

/// Lines between two calls of on_progress: some tens of milliseconds.
constexpr std::uint64_t progress_lines = 512;

std::string family_in(const Case& question) {
  const std::string_view source = question.source;
  if (!source.starts_with(asked_by)) return given_family;
  const auto colon = source.find(": "), slash = source.find('/');
  if (colon == source.npos || slash == source.npos || slash < colon + 2) return given_family;
  return std::string(source.substr(colon + 2, slash - colon - 2));
}

std::uint32_t index_in(std::vector<std::string>& names, const std::string& name) {
  const auto at = std::find(names.begin(), names.end(), name) - names.begin();
  if (static_cast<std::size_t>(at) == names.size()) names.push_back(name);
  return static_cast<std::uint32_t>(at);
}

/// Returns the id of an answer, which is a string or a whole number, or nothing if the line has none.
std::optional<std::string> id_of(const nlohmann::json& line) {
  const auto found = line.find("id");
  if (found == line.end()) return {};
  if (found->is_string()) return found->get<std::string>();
  if (found->is_number_integer()) return found->dump();
  return {};
}

/// Removes "line 3, " from the text, because the message names the line itself.
std::string without_line(const std::string& error) {
  const auto comma = error.find(", ");
  return error.starts_with("line ") && comma != error.npos ? error.substr(comma + 2) : error;
}

}  // namespace

Case question_at(const Workload& workload, std::uint64_t seed, std::uint64_t index) {
  const FamilyIndex drawn = family_index_of(workload, index);
  Case question;
  question.id = std::to_string(index + 1);
  question.source =
      fmt::format("{}{}: {}/{}", asked_by, seed, family_name(workload, drawn.family), drawn.index);
  question.pair = pair_at(workload, seed, drawn);
  return question;
}

Questions::Questions(const std::string& file, const OnBadLine& on_bad_line) : file_(file) {
  std::ifstream in(file);
  if (!in || in.peek() == std::istream::traits_type::eof()) throw InputError(file + " is empty");
  CaseReader reader(in);
  while (std::optional<CaseLine> c = reader.next()) {
    if (!c->value) {
      on_bad_line(file, c->line, without_line(c->error));
      continue;
    }
    c->value->line = c->line;
    if (c->value->id.empty()) c->value->id = std::to_string(c->line);
    if (const auto [at, is_new] = by_id_.try_emplace(c->value->id, all_.size()); !is_new) {
      on_bad_line(
          file, c->line,
          fmt::format("id {} stands on line {} already", quote_json(at->first), all_[at->second].asked.line));
      continue;
    }
    const std::uint32_t family = index_in(families_, family_in(*c->value));
    all_.push_back({std::move(*c->value), family});
  }
  if (in.bad()) throw std::runtime_error(file + " cannot be read");
}

Questions::Question* Questions::find(const std::string& id) {
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? nullptr : &all_[found->second];
}

OfflineJudge::OfflineJudge(std::string name, std::optional<double> relative, Questions* questions,
                           OnBadLine on_bad_line)
    : relative_(relative),
      questions_(questions),
      on_bad_line_(std::move(on_bad_line)),
      name_(std::move(name)),
      certifying_(certifying_method()) {
  if (questions_) families_ = questions_->families();
  claim_.relative = relative.value_or(0);
}

Counts& OfflineJudge::counts(std::uint32_t family) {
  counts_.resize(std::max(counts_.size(), families_.size()));
  judged_.resize(counts_.size());
  return counts_[family];
}

void OfflineJudge::skip(const std::string& file, std::size_t line, const std::string& what) {
  ++passed_over_;
  on_bad_line_(file, line, what);
}

void OfflineJudge::judge_all(std::istream& in, const std::string& file,
                             const std::function<void(std::uint64_t)>& on_progress) {
  LineReader reader(in);
  for (std::uint64_t n = 0; reader.next(); ++n) {
    if (on_progress && n % progress_lines == 0) on_progress(n);
    take(file, reader.line(), reader.text());
  }
  if (in.bad()) throw std::runtime_error("reading failed");
  if (name_.empty()) throw UsageError("the answers do not name their method: give --name");
  if (!questions_) return;
  for (const Questions::Question& question : questions_->all()) {
    if (question.answered != 0) continue;
    on_bad_line_(questions_->file(), question.asked.line, "no answer");
    judge_answer(question.asked, 0, question.family, failed_answer(Failure::malformed, "no answer"));
  }
}

void OfflineJudge::take(const std::string& file, std::size_t line, std::string_view text) {
  const bool first = !std::exchange(begun_, true);
  GuestLine said = parse_guest_line(text.size() > line_cap ? std::string_view() : text);
  if (text.size() > line_cap) said.error = "longer than a line may be";
  if (first && said.hello) {
    if (name_.empty()) name_ = said.hello->name;
    depth_at_most_ = said.hello->depth_at_most;
    if (relative_) return;
    claim_source_ = said.hello->claim_source;
    claim_ = {said.hello->relative, said.hello->absolute, claim_source_};
    return;
  }
  if (said.hello) said.error = "a second hello, or one that is not the first line";
  nlohmann::json object = nlohmann::json::parse(text, nullptr, false);
  if (!object.is_object()) return skip(file, line, said.error.empty() ? "no object" : said.error);
  const std::optional<std::string> id = id_of(object);
  const MethodAnswer answer = said.answer ? method_answer(*said.answer, depth_at_most_)
                                          : failed_answer(Failure::malformed, said.error);
  if (!questions_) {  // a whole number as an id is legal here
    if (id) object["id"] = *id;
    const CaseLine own = parse_case(id ? object.dump() : std::string(text), line);
    if (!own.value) return skip(file, line, without_line(own.error));
    if (!said.answer) on_bad_line_(file, line, said.error);
    return judge_answer(*own.value, line, family_of(*own.value), answer);
  }
  if (!id) return skip(file, line, "no id, a string or a whole number, of a question");
  Questions::Question* question = questions_->find(*id);
  if (!question) return skip(file, line, fmt::format("id {} is of no question", quote_json(*id)));
  if (question->answered != 0) {
    const std::string twice = fmt::format("answered on line {} already", question->answered);
    on_bad_line_(file, line, fmt::format("id {} was {}", quote_json(*id), twice));
    return judge_answer(question->asked, line, question->family, failed_answer(Failure::malformed, twice),
                        true);
  }
  question->answered = line;
  if (!said.answer) on_bad_line_(file, line, said.error);
  judge_answer(question->asked, line, question->family, answer);
}

std::uint32_t OfflineJudge::family_of(const Case& question) {
  return index_in(families_, family_in(question));
}

// As a batch does: verdicts first, and only a pair of a finding that is kept again, with its certificate.
void OfflineJudge::judge_answer(const Case& question, std::size_t line, std::uint32_t family,
                                const MethodAnswer& answer, bool again) {
  const MethodAnswer offered[] = {answer, certifying_->ask(question.pair)};
  Trial trial(question.pair, judge_verdict(question.pair, offered));
  Counts& tally = counts(family);
  tally.asked += !again;
  judged_[family].asked += !again;
  tally.declined += answer.status == Status::declined;
  tally.undecided += answer.status == Status::answered && answer.verdict == Verdict::undecided;
  judged_[family].undecided += !again && trial.truth.verdict == Verdict::undecided;
  const std::optional<Finding> wrong = compare(trial, claim_, answer);
  if (!wrong) return;
  tally.failed += is_failure(wrong->kind);
  tally.contract += !is_failure(wrong->kind) && wrong->severity == Severity::contract;
  tally.resolution += !is_failure(wrong->kind) && wrong->severity == Severity::resolution;
  FindingRecord record;
  record.method = name_;
  record.family = families_[family];
  record.kind = wrong->kind;
  record.severity = wrong->severity;
  record.margin = wrong->margin;
  if (!kept_.admit(record)) return;
  trial.truth = judge(question.pair, offered);
  if (trial.decided()) trial.distance_at(gap_width_tol);
  trial.narrow_distance();
  findings_.push_back({*wrong, families_[family], question, line, answer, trial.truth, trial.distance});
}

int OfflineJudge::exit_code() const {
  Counts all;
  for (const Counts& c : counts_) all += c;
  if (all.contract + all.failed + passed_over_ > 0) return exit_findings;
  const auto is_undecided = [](const Counts& c) { return c.undecided > 0; };
  return std::ranges::any_of(judged_, is_undecided) ? exit_undecided : exit_pass;
}

std::vector<TallyRecord> OfflineJudge::tallies() const {
  std::vector<TallyRecord> rows;
  for (std::size_t f = 0; f < counts_.size(); ++f)
    if (counts_[f].asked > 0) rows.push_back({name_, families_[f], counts_[f]});
  for (std::size_t f = 0; f < judged_.size(); ++f)
    if (judged_[f].asked > 0) rows.push_back({referee_row, families_[f], judged_[f]});
  return rows;
}

}  // namespace cyl
