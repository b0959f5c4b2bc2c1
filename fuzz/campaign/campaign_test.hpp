// SPDX-License-Identifier: MIT
// Campaigns of four small methods on two small families, for tests: what they find can be counted by hand.
// They can be killed again and again, and still complete on any machine.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/scratch_test.hpp"
#include "fuzz/campaign/campaign.hpp"
#include "oracles/methods/fake_method_test.hpp"

namespace cyl {

/// A splitmix64 step: the tests' own random numbers.
inline std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// A session of a campaign, which passes its argument on as the callback.
using Session = std::function<void(const std::function<void(const CampaignProgress&)>&)>;

/// Runs `session` in one child after the other until one ends by itself, and returns how many were killed.
/// Each is killed a random time after a random number of commits, 0 to `most`, so at any place of its work.
/// At commit most + 1 it kills itself. So a session with more work does not end by itself, even if this
/// process is slow. Once one commit is drawn there is progress, even if it is fast.
inline int kill_until_done(std::uint64_t seed, std::uint64_t most, const Session& session) {
  constexpr std::uint64_t longest_microseconds = 20'000;  // some batches, if nothing else runs
  for (int kills = 0;; ++kills) {
    const std::uint64_t drawn = mix(seed + static_cast<std::uint64_t>(kills)), wanted = drawn % (most + 1);
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0) {
      close(ends[0]);
      std::uint64_t done = 0, commits = 0;
      try {
        session([&](const CampaignProgress& progress) {
          if (progress.session_done == done) return;
          done = progress.session_done;
          if (++commits > most || write(ends[1], "c", 1) != 1) raise(SIGKILL);
        });
      } catch (const std::exception&) {
        _exit(1);
      }
      _exit(0);
    }
    close(ends[1]);
    char commit;
    for (std::uint64_t n = 0; n < wanted && read(ends[0], &commit, 1) == 1;) ++n;
    usleep(static_cast<useconds_t>((drawn >> 32) % longest_microseconds));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    close(ends[0]);
    if (!WIFEXITED(status)) continue;
    EXPECT_EQ(WEXITSTATUS(status), 0);
    return kills;
  }
}

/// Runs `run` in a process of its own. It passes its argument to run_campaign as `on_progress` and returns
/// the exit code. Sends the process `signal` after its first new pairs are stored, and returns the status of
/// waitpid.
template <class Run>
int end_on_its_way(const Run& run, int signal) {
  int stored[2];
  if (pipe(stored) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child == 0) {
    close(stored[0]);
    bool reported = false;
    const int code = run([&](const CampaignProgress& progress) {
      if (progress.session_done > 0 && !reported) reported = write(stored[1], "", 1) == 1;
    });
    _exit(code);
  }
  close(stored[1]);
  char byte;
  if (read(stored[0], &byte, 1) == 1) kill(child, signal);  // else it has ended, with nothing left to do
  close(stored[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

/// A method made of a function, so that a test can make it wrong in any way.
inline std::unique_ptr<Method> fake(std::string name, FakeMethod::Ask ask, bool foreign = true,
                                    unsigned share = 1) {
  return fake_method(std::move(name), std::move(ask),
                     {.claim = {1e-6, 0, "a fake's word"}, .foreign = foreign, .share = share});
}

/// The families here hold upright cylinders of radius 1 and height 3, side by side along x.
inline Pair beside(double gap) { return {{{0, 0, 0}, {0, 0, 1}, 1, 3}, {{2 + gap, 0, 0}, {0, 0, 1}, 1, 3}}; }

inline Verdict right(const Pair& pair) {
  return pair.b.center.x() > 2 ? Verdict::disjoint : Verdict::intersecting;
}

inline Pair wide(std::uint64_t seed, std::uint64_t index) {
  return beside(static_cast<double>(mix(seed * 77 + index) % 1000) / 1000 - 0.4995);
}
inline Pair narrow(std::uint64_t seed, std::uint64_t index) {
  const double gap = std::ldexp(1.0, -2 - static_cast<int>(mix(seed * 99 + index) % 40));
  return beside(index % 2 == 0 ? gap : -gap);
}

inline const Family two_families[] = {{"wide", "gaps up to half a radius", wide},
                                      {"narrow", "small gaps", narrow}};

inline std::vector<std::unique_ptr<Method>> make_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake(
      "good", [](const Pair& p) { return answered(right(p)); }, false));
  methods.push_back(fake("blind", [](const Pair&) { return answered(Verdict::disjoint); }));
  methods.push_back(fake("crashing", [](const Pair& p) {
    if (p.b.center.x() > 2.49) std::abort();
    return answered(right(p));
  }));
  methods.push_back(fake(
      "choosy", [](const Pair& p) { return p.b.center.x() > 2.1 ? MethodAnswer{} : answered(right(p)); }));
  return methods;
}

class Campaign : public testing::Test, protected Scratch {
 protected:
  CampaignOptions options(const std::string& name, std::uint64_t pairs) const {
    CampaignOptions o;
    o.out = folder / name;
    o.seed = 20261121;
    o.pairs = pairs;
    return o;
  }
  Workload workload() const { return {methods, two_families, cases}; }
  RunStore store(const std::string& name) const { return RunStore::open(folder / name); }

  std::vector<std::unique_ptr<Method>> methods = make_methods();
  std::vector<Case> cases;
};

/// All of a run that must not depend on times: findings, groups and counts, as text.
inline std::string content(const RunStore& store, std::uint64_t below = ~0ull) {
  std::string text;
  for (const FindingRecord& f : store.findings()) {
    if (f.index >= below) continue;
    text += std::to_string(f.index) + f.family + std::to_string(f.family_index) + f.method +
            to_string(f.kind) + to_string(f.severity) + f.pair + f.answers + f.truth + f.reason;
    if (f.margin) text += std::to_string(f.margin->lo) + std::to_string(f.margin->hi);
    text += '\n';
  }
  if (below != ~0ull) return text;
  for (const CellRecord& c : store.cells()) {
    text += c.plane + ' ' + std::to_string(c.x) + ' ' + std::to_string(c.y) + ' ' +
            format_cell_counts(c.methods) + '\n';
  }
  for (const GroupRecord& g : store.groups()) {
    text += g.method + to_string(g.kind) + to_string(g.severity) + g.family + std::to_string(g.count) + '\n';
  }
  for (const auto& [method, family, c] : store.tallies()) {
    text += method + family;
    for (const auto n : {c.asked, c.declined, c.failed, c.contract, c.resolution, c.undecided}) {
      text += ' ' + std::to_string(n);
    }
    text += '\n';
  }
  return text;
}

inline Counts total(const RunStore& store, const std::string& method) {
  Counts sum;
  for (const TallyRecord& t : store.tallies()) {
    if (t.method == method) sum += t.counts;
  }
  return sum;
}

}  // namespace cyl
