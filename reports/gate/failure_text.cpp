// SPDX-License-Identifier: MIT
#include "reports/gate/failure_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <tuple>

#include "base/own_command.hpp"
#include "base/safe_text.hpp"
#include "base/source_tree.hpp"
#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// Returns FILE and LINE of "FILE:LINE id". The name of a file may contain colons. It ends at the first
/// colon that a line number follows.
std::optional<SourceLine> place_in(std::string_view origin) {
  for (std::size_t colon = origin.find(':'); colon != std::string_view::npos;
       colon = origin.find(':', colon + 1)) {
    const char* end = origin.data() + origin.size();
    unsigned line = 0;
    const auto [after, fault] = std::from_chars(origin.data() + colon + 1, end, line);
    if (fault == std::errc() && line > 0 && colon > 0 && (after == end || *after == ' '))
      return SourceLine{std::string(origin.substr(0, colon)), line};
  }
  return {};
}

/// Returns the path from the current folder if the file lies below it. Otherwise returns the whole path.
std::string from_here(const std::string& file) {
  const fs::path path = fs::path(file).lexically_normal();
  if (path.is_relative()) return path.string();
  std::error_code unknown;
  const fs::path below = path.lexically_relative(fs::current_path(unknown));
  return below.empty() || *below.begin() == ".." ? path.string() : below.string();
}

/// Returns the origin. If a guest fails on a case of ours, it contains the path from our folder.
std::string origin_of(const JudgedFailure& failure) {
  const fs::path ours = fs::path(in_source_tree("corpus")).parent_path();
  if (failure.options.empty() || ours.empty() || !is_from_case(failure)) return one_line(failure.origin);
  const std::string prefix = ours.string() + '/';
  return one_line(failure.origin.starts_with(prefix) ? "daylight's " + failure.origin.substr(prefix.size())
                                                     : failure.origin);
}

std::optional<SourceLine> place_of(const JudgedFailure& failure) {
  std::optional<SourceLine> place = failure.at;
  if (failure.options.empty()) {
    place = {failure.law->file, static_cast<unsigned>(failure.law->line)};
    if (is_from_case(failure))
      if (auto of_case = place_in(failure.origin)) place = std::move(of_case);
  }
  if (place) place->file = from_here(valid_utf8(place->file));
  return place;
}

/// Returns "fails 10 of 10 times", or "fails 3 of 10 times, not deterministically". Empty if not run again.
std::string again_in_words(const JudgedFailure& failure) {
  if (failure.reruns == 0) return {};
  return fmt::format("fails {} of {} times{}", failure.failed_again, failure.reruns,
                     failure.failed_again < failure.reruns ? ", not deterministically" : "");
}

}  // namespace

SourceLine source_line(std::string_view text) {
  return place_in(text).value_or(SourceLine{std::string(text)});
}

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
                   .replay = {},
                   .place = place_of(f)};
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
