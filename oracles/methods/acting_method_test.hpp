// SPDX-License-Identifier: MIT
// Methods for tests that do something when they are asked, such as to crash.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "oracles/methods/contained.hpp"
#include "oracles/methods/fake_method_test.hpp"

namespace cyl {

inline constexpr std::chrono::milliseconds short_cap{60};
inline constexpr std::chrono::hours no_cap{1};

/// Returns one method for each act. It performs the act, then answers with the radius of a as the distance.
inline std::vector<std::unique_ptr<Method>> fakes(std::vector<std::function<void()>> acts) {
  std::vector<std::unique_ptr<Method>> methods;
  for (auto& act : acts) {
    methods.push_back(fake_method("fake", [act = std::move(act)](const Pair& pair) {
      act();
      MethodAnswer answer = answered(Verdict::disjoint);
      answer.has_distance = true;
      answer.distance = pair.a.radius;
      return answer;
    }));
  }
  return methods;
}

inline std::vector<Pair> numbered_pairs(std::size_t count) {
  std::vector<Pair> pairs(count);
  for (std::size_t i = 0; i < count; ++i) pairs[i].a.radius = static_cast<double>(i);
  return pairs;
}

/// Asks a good method, then one that performs `act`, then the good one again. Returns the answer in the
/// middle and checks the other two.
inline MethodAnswer ask_between_good_ones(std::function<void()> act, const Caps& caps = {}) {
  const auto methods = fakes({[] {}, std::move(act)});
  const auto pairs = numbered_pairs(3);
  const std::vector<Question> questions{{0, 0}, {1, 1}, {0, 2}};
  const auto answers = ask_contained(methods, pairs, questions, caps);
  EXPECT_EQ(answers.size(), 3u);
  for (std::size_t i : {0u, 2u}) {
    EXPECT_EQ(answers[i].answer.status, Status::answered) << answers[i].answer.reason;
    EXPECT_EQ(answers[i].answer.distance, static_cast<double>(i));
    EXPECT_GT(answers[i].nanoseconds, 0);
  }
  return answers[1].answer;
}

}  // namespace cyl
