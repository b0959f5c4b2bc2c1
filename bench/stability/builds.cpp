// SPDX-License-Identifier: MIT
#include "bench/stability/builds.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "base/json.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/strata.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {
namespace {

using nlohmann::json;

constexpr std::uint64_t seed = 1;
/// So few that even the slowest build, which is not optimised, answers them all within minutes.
constexpr std::uint64_t pairs_per_family = 30, plain_pairs_per_stratum = 3, scaled_pairs_per_stratum = 1;
constexpr int tiny_exponents[] = {-500, -1010, -1060};

bool said_same(const MethodAnswer& x, const MethodAnswer& y) {
  return x.status == y.status && (x.status != Status::answered || x.verdict == y.verdict);
}

bool same_distance(const MethodAnswer& x, const MethodAnswer& y) {
  if (x.has_distance != y.has_distance) return false;
  return !x.has_distance || x.distance == y.distance || (std::isnan(x.distance) && std::isnan(y.distance));
}

}  // namespace

std::vector<Pair> build_pairs() {
  std::vector<Pair> pairs;
  for (const Family& family : families())
    for (std::uint64_t i = 0; i < pairs_per_family; ++i) pairs.push_back(family.generate(seed, i));
  const auto add_strata = [&](std::uint64_t count, int exponent) {
    for (const Pair& pair : draw_in_all_strata(count, seed)) pairs.push_back(scaled(pair, exponent));
  };
  add_strata(plain_pairs_per_stratum, 0);
  for (const int exponent : tiny_exponents) add_strata(scaled_pairs_per_stratum, exponent);
  return pairs;
}

bool BuildComparison::is_wrong_beyond_claim(std::size_t i, const Method& method, const MethodAnswer& answer) {
  Proofs& proofs = proofs_.try_emplace(i, pairs_[i], std::span<const MethodAnswer>()).first->second;
  Trial& proved = proofs.of(pairs_[i]);
  MethodAnswer verdict = answer;  // the verdict alone, because only it has changed
  verdict.has_distance = false;
  verdict.witness = CertificateKind::none;
  const auto finding = cyl::compare(proved, method.claim(), verdict);
  return finding && finding->severity == Severity::contract;
}

std::vector<BuildDifference> BuildComparison::compare(std::span<const MethodAnswer> against,
                                                      std::span<const MethodAnswer> build) {
  if (against.size() != build.size() || build.size() != methods_.size() * pairs_.size())
    throw std::invalid_argument("the answers are not of these pairs and methods");
  std::vector<BuildDifference> all;
  for (std::size_t m = 0; m < methods_.size(); ++m) {
    const Method& method = *methods_[m];
    BuildDifference& d = all.emplace_back();
    d.method = method.name();
    for (std::size_t i = 0; i < pairs_.size(); i += method.share()) {
      const MethodAnswer &was = against[i * methods_.size() + m], &is = build[i * methods_.size() + m];
      ++d.pairs;
      if (!said_same(was, is)) {
        ++d.verdicts_changed;
        d.beyond_claim += is_wrong_beyond_claim(i, method, is);
      }
      if (same_distance(was, is)) continue;
      ++d.distances_changed;
      const double change = std::abs(was.distance - is.distance) / size_of(pairs_[i]);
      if (was.has_distance && is.has_distance && std::isfinite(change))
        d.largest_change = std::max(d.largest_change.value_or(0), change);
    }
  }
  return all;
}

json to_json(const BuildDifference& d) {
  return {{"method", d.method},
          {"build", d.build},
          {"against", d.against},
          {"pairs", d.pairs},
          {"verdicts_changed", d.verdicts_changed},
          {"beyond_claim", d.beyond_claim},
          {"distances_changed", d.distances_changed},
          {"largest_change", d.largest_change ? json(*d.largest_change) : json(nullptr)}};
}

json builds_json(const std::filesystem::path& file) {
  json all = json::array();
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line)) return all;
  try {
    parse_json(line).at("command");
    while (std::getline(in, line)) {
      all.push_back(parse_json(line));
      for (const char* field : {"method", "build", "against", "pairs", "verdicts_changed", "beyond_claim",
                                "distances_changed", "largest_change"})
        all.back().at(field);
    }
  } catch (const json::exception& e) {
    throw std::runtime_error(file.string() + " is not a comparison of builds: " + e.what());
  }
  return all;
}

}  // namespace cyl
