// SPDX-License-Identifier: MIT
// Campaigns of four small methods on two small families, for tests: what they find can be counted by hand.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/campaign/campaign.hpp"
#include "fuzz/campaign/killed_test.hpp"
#include "oracles/methods/fake_method_test.hpp"

namespace cyl {

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

/// A folder of its own for each test, gone afterwards.
class Campaign : public testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() /
             ("daylight_campaign_" + std::to_string(getpid()) + "_" +
              testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder);
    methods = make_methods();
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  CampaignOptions options(const std::string& name, std::uint64_t pairs) const {
    CampaignOptions o;
    o.out = folder / name;
    o.seed = 20261121;
    o.pairs = pairs;
    return o;
  }
  Workload workload() const { return {methods, two_families, cases}; }
  RunStore store(const std::string& name) const { return RunStore::open(folder / name); }

  std::filesystem::path folder;
  std::vector<std::unique_ptr<Method>> methods;
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
