// SPDX-License-Identifier: MIT
#include "reports/gate/failure_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>

#include "base/json.hpp"
#include "base/own_command.hpp"
#include "base/safe_text.hpp"
#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// Of "FILE:LINE id". A file's name may hold colons, so the first one that a line number follows counts.
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

std::string from_here(const std::string& file) {
  const fs::path path = fs::path(file).lexically_normal();
  if (path.is_relative()) return path.string();
  std::error_code unknown;
  const fs::path below = path.lexically_relative(fs::current_path(unknown));
  return below.empty() || *below.begin() == ".." ? path.string() : below.string();
}

}  // namespace

bool is_error(const GateFailure& failure) { return failure.severity == Severity::contract; }

bool fails_gate(const GateFailure& failure) { return is_error(failure) && !failure.known; }

bool is_from_case(const GateFailure& failure) {
  return failure.phase == GatePhase::corpus || failure.phase == GatePhase::corpus_laws;
}

std::vector<Alike> alike_failures(const GateReport& report, bool failing) {
  std::vector<Alike> all;
  for (const GateFailure& f : report.failures) {
    if (fails_gate(f) != failing) continue;
    const auto at = std::find_if(all.begin(), all.end(), [&](const Alike& alike) {
      const GateFailure& g = *alike.front();
      return g.method == f.method && g.law == f.law && g.kind == f.kind && g.known == f.known;
    });
    if (at == all.end())
      all.push_back({&f});
    else
      at->push_back(&f);
  }
  return all;
}

std::uint64_t pairs_of(const Alike& alike) {
  std::uint64_t count = 0;
  for (const GateFailure* f : alike) count += f->count;
  return count;
}

SourceLine place_of(const GateFailure& failure) {
  SourceLine place{failure.law->file, static_cast<unsigned>(failure.law->line)};
  if (is_from_case(failure)) {
    if (auto of_case = place_in(failure.origin)) place = std::move(*of_case);
  }
  place.file = from_here(valid_utf8(place.file));
  return place;
}

bool is_told_by_answer(const Law& law) { return law.number == answer_law || law.number == verdict_law; }

std::string law_title(const Law& law) { return fmt::format("law {} {}", law.number, law.name); }

std::string luck_in_words(const GateFailure& failure) {
  if (failure.reruns == 0) return {};
  return fmt::format("{} {} of {}{}", failure.failed_again < failure.reruns ? "depends on luck:" : "fails",
                     failure.failed_again, failure.reruns,
                     failure.failed_again < failure.reruns ? "" : " times");
}

std::string replay_command(const GateFailure& failure) {
  return fmt::format("echo {} | {} replay - --methods {}{}{}", shell_quoted(format_pair(failure.simplest)),
                     own_command(), shell_quoted(one_line(failure.method)),
                     failure.options.empty() ? "" : ' ' + one_line(failure.options),
                     is_told_by_answer(*failure.law) ? "" : fmt::format(" --laws {}", failure.law->number));
}

std::string grouped(std::uint64_t n) {
  return n < 1000 ? std::to_string(n) : fmt::format("{},{:03}", grouped(n / 1000), n % 1000);
}

std::string pairs_in_words(std::uint64_t n) { return grouped(n) + (n == 1 ? " pair" : " pairs"); }

std::string valid_utf8(std::string_view text) { return parse_json(quote_json(text)).get<std::string>(); }

std::string one_line(std::string_view text) { return escaped_controls(valid_utf8(text)); }

}  // namespace cyl
