// SPDX-License-Identifier: MIT
#include "props/mutants/kill_matrix.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <system_error>

#include "base/process/fork_with_retry.hpp"
#include "corpus/pairs/families.hpp"
#include "oracles/trial/compare.hpp"
#include "props/laws/examine.hpp"

namespace cyl {
namespace {

constexpr int survived_code = 0, killed_code = 1;

/// Bytes of a report that are kept; a pipe holds as many unread.
constexpr std::size_t report_cap = 4096;

/// Pairs drawn of each family, and of each family for timing; enough that chance plays no part with faults
/// that are seen at all.
constexpr std::uint64_t law_pairs = 100, differential_pairs = 400;
constexpr std::uint64_t detector_seed = 20261121;

/// Pairs examined at once: few, so that a kill ends the work early; many, so that forks do not count.
constexpr std::size_t chunk_size = 256;

constexpr int first_law_of_truth = 30;
bool any(std::size_t, const Law&) { return true; }
bool of_truth(std::size_t, const Law& law) { return law.number >= first_law_of_truth; }

std::string broken_law(std::span<const std::unique_ptr<Method>> methods, std::span<const Pair> pairs,
                       const Wanted& wanted) {
  for (std::size_t at = 0; at < pairs.size(); at += chunk_size) {
    const auto chunk = pairs.subspan(at, std::min(chunk_size, pairs.size() - at));
    for (const BrokenLaw& b : examine(methods, chunk, wanted).broken)
      if (b.broken.severity == Severity::contract)
        return fmt::format("{} breaks law {}, {}: {}; {}", methods[b.method]->name(), b.law->number,
                           b.law->name, b.broken.what, format_pair(chunk[b.pair]));
  }
  return {};
}

void draw(std::vector<Pair>& pairs, std::span<const Family> from, std::uint64_t count, std::uint64_t seed) {
  for (std::uint64_t i = 0; i < count; ++i)
    for (const Family& family : from) pairs.push_back(family.generate(seed, i));
}

std::vector<Pair> pairs_of(std::span<const Case> cases) {
  std::vector<Pair> pairs;
  for (const Case& c : cases) pairs.push_back(c.pair);
  return pairs;
}

auto methods_of(const Mutant& mutant) { return select_methods(all_methods(), mutant.asks); }

// What a case states is held to the proof as the answer of one that is always right would be; and where a
// verdict is stated, it has been proved once.
std::string contradiction(std::span<const Case> cases) {
  for (const Case& c : cases) {
    if (!c.truth) continue;
    const Truth truth = judge(c.pair);
    MethodAnswer stated;
    stated.status = Status::answered;
    stated.verdict = *c.truth;
    LazyDistance distance([&](double width) { return enclose_distance(c.pair, truth, width); });
    if (truth.verdict == Verdict::undecided ? *c.truth != Verdict::undecided
                                            : compare(c.pair, truth, distance, Claim{}, stated).has_value())
      return fmt::format("{} is stated to be {}, judged {}", c.id, to_string(*c.truth),
                         to_string(truth.verdict));
  }
  return {};
}

[[noreturn]] void detect(const Mutant& mutant, const Detector& detector, void (*select)(int) noexcept,
                         int report) {
  const rlimit no_core{0, 0}, cpu{detector_cpu_cap, detector_cpu_cap + 1};
  setrlimit(RLIMIT_CORE, &no_core);
  setrlimit(RLIMIT_CPU, &cpu);
  alarm(detector_wall_cap);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  select(mutant.number);
  std::string what;
  try {
    what = detector.betrayal(mutant);
  } catch (const std::exception& error) {
    what = fmt::format("the harness fails: {}", error.what());
  }
  if (what.empty()) _exit(survived_code);
  if (write(report, what.data(), std::min(what.size(), report_cap)) < 0) _exit(killed_code);
  _exit(killed_code);
}

}  // namespace

bool KillRow::killed() const {
  return std::any_of(detections.begin(), detections.end(),
                     [](const Detection& d) { return d.fate > Fate::survived; });
}

KillRow run_detectors(const Mutant& mutant, std::span<const Detector> detectors,
                      void (*select)(int) noexcept) {
  KillRow row{mutant, {}};
  for (const Detector& detector : detectors) {
    const auto start = std::chrono::steady_clock::now();
    std::fflush(nullptr);
    int report[2];
    if (pipe2(report, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    const pid_t child = patient_fork();
    if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (child == 0) detect(mutant, detector, select, report[1]);
    close(report[1]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    Detection d;
    d.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fcntl(report[0], F_SETFL, O_NONBLOCK);  // a worker that outlives the child may hold the other end
    std::array<char, report_cap> text;
    if (const ssize_t got = read(report[0], text.data(), text.size()); got > 0)
      d.what.assign(text.data(), static_cast<std::size_t>(got));
    close(report[0]);
    if (WIFSIGNALED(status)) {
      const int signal = WTERMSIG(status);
      d.fate = signal == SIGXCPU || signal == SIGALRM || signal == SIGKILL ? Fate::hung : Fate::crashed;
    } else {
      d.fate = WEXITSTATUS(status) == survived_code ? Fate::survived : Fate::killed;
    }
    row.detections.push_back(d);
  }
  return row;
}

std::vector<Detector> law_detectors(std::span<const Case> cases) {
  return {
      {"laws",
       [cases](const Mutant& mutant) {
         std::vector<Pair> pairs = pairs_of(cases);
         draw(pairs, families(), law_pairs, detector_seed);
         return broken_law(methods_of(mutant), pairs, any);
       }},
      {"corpus",
       [cases](const Mutant& mutant) {
         const std::string broken = broken_law(methods_of(mutant), pairs_of(cases), of_truth);
         return broken.empty() ? contradiction(cases) : broken;
       }},
      {"differential",
       [](const Mutant& mutant) {
         std::vector<Pair> pairs;
         draw(pairs, families(), differential_pairs, detector_seed + 1);
         draw(pairs, margin_families(), differential_pairs, detector_seed + 1);
         return broken_law(methods_of(mutant), pairs, of_truth);
       }},
  };
}

}  // namespace cyl
