// SPDX-License-Identifier: MIT
// Shared by the tests of the laws: methods with a planted fault, and the laws that they break. The fault is
// planted in one of our answers, so only the fault can break a law.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "props/laws/laws.hpp"

namespace cyl {

/// Pairs of each family, beside those that are drawn.
inline constexpr std::uint64_t pairs_per_family = 200;
inline constexpr std::uint64_t family_seed = 20261121;

/// One of our own methods.
inline MethodAnswer ask_ours(std::string_view name, const Pair& pair) {
  static const auto methods = own_methods();
  for (const auto& method : methods)
    if (method->name() == name) return method->ask(pair);
  return {};
}

/// Promises no more than verdicts beyond 1e-13 of the size.
inline constexpr Claim of_verdicts{.relative = 1e-13, .source = "planted"};
/// Promises, in addition, all that a method can.
inline constexpr Claim of_everything{.relative = 1e-13,
                                     .source = "planted",
                                     .bitwise_stable = true,
                                     .mirror_invariant = true,
                                     .certified = true,
                                     .from_a_to_b = true,
                                     .reports_invalid = true,
                                     .decides = DecisionScope::above_1e13};

/// A method that answers by a function.
struct Planted final : FakeMethod {
  using Prepared = std::function<Verdict(const Pair&)>;

  explicit Planted(Ask ask, std::string_view name = "planted", Claim claim = of_verdicts)
      : FakeMethod(std::string(name), std::move(ask), {.claim = claim}) {}
  bool supports(SolidKind) const override { return true; }
  Call prepare_all(std::span<const Pair> pairs) override {
    if (!prepared) return {};
    return [this, copy = std::vector<Pair>(pairs.begin(), pairs.end())](std::size_t i) {
      return prepared(copy[i]);
    };
  }
  BatchCall prepare_batch(std::span<const Pair> pairs) override {
    if (!batch) return {};
    return [this, copy = std::vector<Pair>(pairs.begin(), pairs.end())](std::span<Verdict> verdicts) {
      for (std::size_t i = 0; i < copy.size(); ++i) verdicts[i] = batch(copy[i]);
    };
  }

  Prepared prepared, batch;  ///< none if empty
};

/// The numbers of the laws that the first pairs of a family show broken.
inline std::vector<int> laws_broken_by(Planted method, std::string_view family = "random") {
  std::vector<int> numbers;
  for (const Law& law : all_laws()) {
    for (std::uint64_t index = 0; index < pairs_per_family; ++index) {
      if (!violation_of(method, law, find_family(family)->generate(family_seed, index))) continue;
      numbers.push_back(law.number);
      break;
    }
  }
  return numbers;
}

/// Our answer with a fault: `change` alters it.
inline Planted plant(std::string_view ours, std::function<void(const Pair&, MethodAnswer&)> change,
                     const Claim& claim = of_verdicts) {
  return Planted(
      [ours, change = std::move(change)](const Pair& pair) {
        MethodAnswer answer = ask_ours(ours, pair);
        change(pair, answer);
        return answer;
      },
      "planted", claim);
}

using Numbers = std::vector<int>;

}  // namespace cyl
