// SPDX-License-Identifier: MIT
#include "reports/triage/triage_context.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <thread>

#include "base/process/child.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "fuzz/campaign/campaign.hpp"
#include "oracles/methods/guest.hpp"
#include "oracles/trial/algorithm_groups.hpp"

namespace cyl {
namespace {

using std::chrono::milliseconds;

/// How often the processes' end is looked for, and how far they are.
constexpr milliseconds poll_interval{50}, show_interval{500};

std::optional<std::size_t> index_of(std::span<const std::unique_ptr<Method>> methods, std::string_view name) {
  for (std::size_t m = 0; m < methods.size(); ++m)
    if (methods[m]->name() == name) return m;
  return {};
}

milliseconds since(TriageContext::Clock::time_point start) {
  return std::chrono::duration_cast<milliseconds>(TriageContext::Clock::now() - start);
}

}  // namespace

std::string askers(const std::string& build, std::span<const std::unique_ptr<Method>> methods) {
  std::string text = build;
  for (const auto& method : methods)
    if (!method->guest()) text += fmt::format("\n{} {}", method->name(), method->version());
  return text;
}

TriageContext::TriageContext(const TriageOptions& options, std::span<const std::unique_ptr<Method>> methods,
                             const std::function<void(const TriageProgress&)>& on_progress)
    : options_(options),
      on_progress_(on_progress),
      methods_(methods),
      asked_by_(askers(options.build, methods)),
      groups_(algorithm_groups(methods)) {
  const RunStore run = RunStore::open(options.folder);
  std::set<std::string, std::less<>> absent_guests;
  for (Guest& guest : parse_guests(value_of(run.config(), "guests")))
    if (!index_of(methods_, guest.name)) absent_guests.insert(std::move(guest.name));
  began_ = value_of(run.config(), "started");
  findings_ = run.findings();
  finding_groups_ = run.groups();
  for (const MethodRecord& m : run.methods())
    if (!absent_guests.contains(m.name)) asked_.push_back(m.name);
  for (const FindingRecord& f : findings_) {
    subjects_.push_back(subject_of(f, absent_guests.contains(f.method)));
    if (subjects_.back().absent) absent_.insert(f.id);
  }
  for (const Subject& s : subjects_) by_id_[s.record->id] = &s;
}

Subject TriageContext::subject_of(const FindingRecord& f, bool absent) const {
  Subject s{&f,
            index_of(methods_, f.method),
            absent,
            from_word<FindingKind>(f.kind),
            from_word<Severity>(f.severity).value_or(Severity::contract),
            {}};
  const CaseLine line = parse_case(f.pair, 1);
  if (!line.value) throw std::runtime_error(fmt::format("finding {}: {}", f.id, line.error));
  s.pair = line.value->pair;
  return s;
}

milliseconds TriageContext::elapsed() const { return since(start_); }

TriageProgress TriageContext::progress() const {
  const std::vector<SimpleRecord> simple = simples();
  TriageProgress progress;
  progress.findings = subjects_.size();
  progress.classified = causes().size();
  progress.absent = absent_.size();
  progress.simplified = static_cast<std::size_t>(
      std::count_if(simple.begin(), simple.end(), [](const SimpleRecord& s) { return s.ended; }));
  progress.searched = store().worsts().size();
  progress.elapsed = elapsed();
  return progress;
}

void TriageContext::in_processes(const std::function<void(unsigned job)>& work) const {
  const auto show = [&] {
    if (on_progress_) on_progress_(progress());
  };
  std::deque<Child> running;
  for (unsigned job = 0; job < options_.jobs; ++job) {
    const auto run = [&work, job] {
      work(job);
      return std::string();
    };
    running.emplace_back(run, ChildOptions{.failure = "triage"});
  }
  const auto advance = [](Child& child) { return child.ended() || child.advance(); };
  for (Clock::time_point shown = Clock::now(); !std::all_of(running.begin(), running.end(), advance);) {
    std::this_thread::sleep_for(poll_interval);
    if (since(shown) < show_interval) continue;
    shown = Clock::now();
    show();
  }
  show();
  if (std::any_of(running.begin(), running.end(), [](const Child& child) { return child.status() != 0; }))
    throw std::runtime_error("a process of the triage failed; run it again to go on");
}

}  // namespace cyl
