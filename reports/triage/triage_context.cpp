// SPDX-License-Identifier: MIT
#include "reports/triage/triage_context.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "base/process/child.hpp"
#include "base/usage_error.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/run_facts.hpp"
#include "oracles/methods/guest.hpp"
#include "oracles/trial/algorithm_groups.hpp"

namespace cyl {
namespace {

using std::chrono::milliseconds;

/// How often this looks whether the processes have ended, and how often it shows their progress.
constexpr milliseconds poll_interval{50}, show_interval{500};

/// The page takes about as long as reading the run so many times.
constexpr int page_in_readings = 4;

milliseconds since(TriageContext::Clock::time_point start) {
  return std::chrono::duration_cast<milliseconds>(TriageContext::Clock::now() - start);
}

}  // namespace

std::string methods_line(const std::string& build, std::span<const std::unique_ptr<Method>> methods) {
  std::string text = build;
  for (const auto& method : methods)
    if (!method->guest()) text += fmt::format("\n{} {}", method->name(), method->version());
  return text;
}

TriageContext::TriageContext(const TriageOptions& how, std::span<const std::unique_ptr<Method>> all,
                             const std::function<void(const TriageProgress&)>& show)
    : options(how), on_progress(show), methods(all), asked_by(methods_line(how.build, all)) {
  const RunStore run = RunStore::open(options.folder);
  std::set<std::string, std::less<>> absent_guests;
  std::set<std::string_view> libraries;  // that have findings
  for (Guest& guest : parse_guests(value_of(run.config(), "guests")))
    if (!position_of(methods, guest.name)) absent_guests.insert(std::move(guest.name));
  began = value_of(run.config(), "started");
  findings = run.findings();
  finding_groups = run.groups();
  for (const MethodRecord& m : run.methods())
    if (!absent_guests.contains(m.name)) asked.push_back(m.name);
  for (const FindingRecord& f : findings) {
    Subject s{&f, position_of(methods, f.method), absent_guests.contains(f.method), {}};
    if (!subjects.empty() && subjects.back().record->index == f.index) {
      s.pair = subjects.back().pair;  // those of one pair follow each other
    } else {
      const CaseLine line = parse_case(f.pair, 1);
      if (!line.value) throw InputError(fmt::format("finding {}: {}", f.id, line.error));
      s.pair = line.value->pair;
    }
    if (s.absent) absent.insert(f.id);
    if (s.method) libraries.insert(methods[*s.method]->library());
    subjects.push_back(std::move(s));
  }
  for (const Subject& s : subjects) by_id[s.record->id] = &s;
  const milliseconds page = page_in_readings * since(start);
  groups = algorithm_groups(methods, [&](const Method& m) { return libraries.contains(m.library()); });
  budget = std::max(options.budget / 2, options.budget - page - since(start));
  start = Clock::now();
}

milliseconds TriageContext::elapsed() const { return since(start); }

TriageProgress TriageContext::progress() const {
  const std::vector<SimpleRecord> simple = simples();
  TriageProgress progress;
  progress.findings = subjects.size();
  progress.classified = causes().size();
  progress.absent = absent.size();
  progress.simplified = static_cast<std::size_t>(
      std::count_if(simple.begin(), simple.end(), [](const SimpleRecord& s) { return s.ended; }));
  progress.elapsed = elapsed();
  return progress;
}

void TriageContext::in_processes(const std::function<void(unsigned job)>& work) const {
  const auto show = [&] {
    if (on_progress) on_progress(progress());
  };
  std::deque<Child> running;
  for (unsigned job = 0; job < options.jobs; ++job) {
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
    throw std::runtime_error("a process of the triage failed: run it again to continue");
}

}  // namespace cyl
