// SPDX-License-Identifier: MIT
#include "reports/gate/failure_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "base/own_command.hpp"
#include "base/safe_text.hpp"
#include "base/source_tree.hpp"
#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// Returns the origin. If a guest fails on a case of ours, it contains the path from our folder.
std::string origin_of(const JudgedFailure& failure) {
  const fs::path ours = fs::path(in_source_tree("corpus")).parent_path();
  if (failure.options.empty() || ours.empty() || !is_from_case(failure)) return one_line(failure.origin);
  const std::string prefix = ours.string() + '/';
  return one_line(failure.origin.starts_with(prefix) ? "daylight's " + failure.origin.substr(prefix.size())
                                                     : failure.origin);
}

/// Returns "fails 10 of 10 times", or "fails 3 of 10 times, not deterministically". Empty if not run again.
std::string again_in_words(const JudgedFailure& failure) {
  if (failure.reruns == 0) return {};
  return fmt::format("fails {} of {} times{}", failure.failed_again, failure.reruns,
                     failure.failed_again < failure.reruns ? ", not deterministically" : "");
}

}  // namespace

bool is_from_case(const JudgedFailure& failure) {
  return failure.phase == GatePhase::corpus || failure.phase == GatePhase::corpus_laws;
}

std::vector<Alike> alike_failures(const JudgedGate& gate, bool failing) {
  std::vector<Alike> all;
  for (const JudgedFailure& f : gate.failures) {
    if (fails_gate(f) != failing) continue;
    const auto at = std::find_if(all.begin(), all.end(), [&](const Alike& alike) {
      const JudgedFailure& g = *alike.front();
      if (g.method != f.method || g.known != f.known) return false;
      if (g.failed || f.failed)
        return g.failed == f.failed && g.reason == f.reason && g.severity == f.severity;
      return g.law == f.law && g.kind == f.kind;
    });
    if (at == all.end())
      all.push_back({&f});
    else
      at->push_back(&f);
  }
  const auto rank = [](const JudgedFailure* f) {
    return std::tuple(f->failed && !shows_in_answer(*f->law), f->in_base > 0, -f->excess);
  };
  for (Alike& alike : all) std::ranges::stable_sort(alike, {}, rank);
  return all;
}

std::string law_title(const Law& law) { return fmt::format("law {} {}", law.number, law.name); }

FailureView view_of(const JudgedFailure& f) {
  FailureView view{.method = one_line(f.method),
                   .law = law_title(*f.law),
                   .what = one_line(f.what),
                   .pairs = counted(f.count, "pair"),
                   .origin = origin_of(f),
                   .cause = one_line(f.cause),
                   .again = again_in_words(f),
                   .found = format_pair(f.found),
                   .simplest = format_pair(f.simplest),
                   .replay = {}};
  view.replay =
      fmt::format("echo {} | {} replay - --methods {}{}{}", shell_quoted(view.simplest), own_command(),
                  shell_quoted(view.method), f.options.empty() ? "" : ' ' + one_line(f.options),
                  shows_in_answer(*f.law) ? "" : fmt::format(" --laws {}", f.law->number));
  return view;
}

FailureView view_of(const Alike& alike) {
  FailureView view = view_of(*alike.front());
  std::uint64_t count = 0;
  for (const JudgedFailure* f : alike) count += f->count;
  view.pairs = counted(count, "pair");
  return view;
}

}  // namespace cyl
