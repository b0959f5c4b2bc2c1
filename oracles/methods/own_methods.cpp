// SPDX-License-Identifier: MIT
#include <cstdint>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/methods/own_answers.hpp"
#include "oracles/referee/decide_exactly.hpp"
#include "solver/distance.hpp"
#include "solver/intersect_batch.hpp"

namespace cyl {
namespace {

/// `query` on two prepared solids, for every pair.
template <typename Query>
auto prepare_solids(std::span<const Pair> pairs, Query query) {
  return [solids = solids_of<Prepared>(pairs, prepare), query](std::size_t i) {
    return query(solids[i].first, solids[i].second);
  };
}

/// Prepared solids of both sides, and which of them make a pair.
struct PreparedPairs {
  explicit PreparedPairs(std::span<const Pair> pairs) {
    for (const Pair& pair : pairs) {
      indices.push_back({static_cast<std::uint32_t>(a.size()), static_cast<std::uint32_t>(b.size())});
      a.push_back(prepare(pair.a));
      b.push_back(prepare(pair.b));
    }
  }
  std::vector<Prepared> a, b;
  std::vector<IndexPair> indices;
};

class Intersect final : public Method {
 public:
  Intersect() : Method({"intersect"}) {}
  std::string_view version() const override { return DAYLIGHT_VERSION; }
  Claim claim() const override {
    return {.relative = 1e-13,
            .source = "solver/decide.hpp: Right wherever the margin is >= 1e-13.",
            .bitwise_stable = true,
            .mirror_invariant = true,
            .from_a_to_b = true,
            .reports_invalid = true,
            .decides = DecisionScope::above_1e13};
  }
  bool foreign() const override { return false; }
  bool supports(SolidKind) const override { return true; }
  MethodAnswer answer(const Pair& pair) override { return answered(intersect(pair.a, pair.b)); }
  Call prepare_all(std::span<const Pair> pairs) override {
    return prepare_solids(pairs, [](const Prepared& a, const Prepared& b) { return intersect(a, b); });
  }
  BatchCall prepare_batch(std::span<const Pair> pairs) override {
    return [of = PreparedPairs(pairs)](std::span<Verdict> verdicts) {
      intersect_batch(of.a, of.b, of.indices, verdicts.data());
    };
  }
};

class Decide final : public Method {
 public:
  Decide() : Method({"decide"}) {}
  std::string_view version() const override { return DAYLIGHT_VERSION; }
  Claim claim() const override {
    return {.source = "solver/decide.hpp: Never wrong.",
            .bitwise_stable = true,
            .certified = true,
            .from_a_to_b = true,
            .reports_invalid = true,
            .decides = DecisionScope::above_1e13};
  }
  bool foreign() const override { return false; }
  bool supports(SolidKind) const override { return true; }
  MethodAnswer answer(const Pair& pair) override { return answer_of(pair, decide(pair.a, pair.b)); }
  Call prepare_all(std::span<const Pair> pairs) override {
    return prepare_solids(pairs, [](const Prepared& a, const Prepared& b) { return decide(a, b).verdict; });
  }
};

/// The error that `distance` may have, relative to the size and the distance of the centres.
constexpr double distance_tol = 1e-13;

class MeasureDistance final : public Method {
 public:
  MeasureDistance() : Method({"distance"}) {}
  std::string_view version() const override { return DAYLIGHT_VERSION; }
  Claim claim() const override {
    return {.relative = distance_tol,
            .source = "solver/distance.hpp: error within 1e-13 of size + |Delta|, or it reports more.",
            .bitwise_stable = true,
            .from_a_to_b = true,
            .reports_invalid = true,
            .decides = DecisionScope::above_1e13};
  }
  bool foreign() const override { return false; }
  bool supports(SolidKind) const override { return true; }
  MethodAnswer answer(const Pair& pair) override { return answer_of(pair, distance(pair.a, pair.b)); }
  Call prepare_all(std::span<const Pair> pairs) override {
    return prepare_solids(pairs, [](const Prepared& a, const Prepared& b) { return distance(a, b).verdict; });
  }
  DistanceCall prepare_distances(std::span<const Pair> pairs) override {
    return prepare_solids(pairs, [](const Prepared& a, const Prepared& b) { return distance(a, b).value; });
  }
};

class Exact final : public Method {
 public:
  Exact() : Method({"exact"}) {}
  std::string_view version() const override { return DAYLIGHT_VERSION; }
  Claim claim() const override {
    return {.source = "oracles/referee/decide_exactly.hpp: Proved, with certificate.",
            .from_a_to_b = true,
            .reports_invalid = true,
            .decides = DecisionScope::all};
  }
  bool foreign() const override { return false; }
  bool supports(SolidKind) const override { return true; }
  MethodAnswer answer(const Pair& pair) override {
    const Truth truth = decide_exactly(pair.a, pair.b);
    MethodAnswer answer = answered(truth.verdict);
    // A certificate of rationals that doubles cannot hold is left out. The verdict stands without it.
    answer.set_witness(truth.certificate);
    return answer;
  }
};

}  // namespace

std::unique_ptr<Method> certifying_method() { return std::make_unique<Decide>(); }

MethodAnswer answer_of(const Pair& pair, const Answer& decided) {
  MethodAnswer answer = answered(decided.verdict);
  answer.steps = decided.iterations;
  answer.step_cap = decide_iteration_cap;
  answer.set_witness(certificate_of(decided, pair.a, pair.b));
  return answer;
}

MethodAnswer answer_of(const Pair& pair, const Distance& measured) {
  MethodAnswer answer = answered(measured.verdict);
  answer.steps = measured.iterations;
  answer.step_cap = distance_step_cap;
  // It returns no number if its bounds stay apart, or if the depth of a box and a cylinder is not proved. It
  // also returns none if a half-space is so far from its own point that the error is not relative to the
  // size.
  const bool plane = has_half_space(pair), overlap = measured.verdict == Verdict::intersecting;
  const Vector3 delta = pair.b.center - pair.a.center;
  const double reach = size_of(pair) + (plane ? 0 : std::hypot(delta.x(), delta.y(), delta.z()));
  const bool close = measured.error <= distance_tol * reach;
  const bool sure = overlap && !plane ? !has_box(pair) || (measured.least && close) : close;
  answer.has_distance = measured.verdict != Verdict::invalid && sure;
  answer.distance = measured.value;
  answer.error_bound = measured.error;
  // Only exact multiples of the normal of a half-space prove anything.
  const Vector3 direction = is_half_space(pair.a)   ? prepare(pair.a).second_axis
                            : is_half_space(pair.b) ? Vector3(-prepare(pair.b).second_axis)
                                                    : measured.direction;
  if (measured.verdict == Verdict::disjoint) answer.set_direction(direction);
  return answer;
}

std::vector<std::unique_ptr<Method>> own_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Intersect>());
  methods.push_back(std::make_unique<Decide>());
  methods.push_back(std::make_unique<MeasureDistance>());
  methods.push_back(std::make_unique<Exact>());
  return methods;
}

}  // namespace cyl
