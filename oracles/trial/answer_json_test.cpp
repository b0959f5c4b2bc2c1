// SPDX-License-Identifier: MIT
// For any doubles of a pair, `daylight check` prints only lines of JSON.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

constexpr double largest = std::numeric_limits<double>::max();

/// Returns lengths and coordinates at the ends of the range, and ordinary ones.
double wild(RandomStream& stream) {
  constexpr std::array lengths{0.0, 5e-324, 1e-308, 1e-300, 1e-150, 1.0, 3.0, 1e150, 1e300, 1.7e308, largest};
  return lengths[stream.bits() % lengths.size()] * (stream.bits() % 2 == 0 ? 1 : -1);
}

Pair wild_pair(RandomStream& stream) {
  Pair pair;
  do {
    for (Solid* c : {&pair.a, &pair.b}) {
      for (int i = 0; i < 3; ++i) c->center[i] = wild(stream), c->axis[i] = wild(stream);
      c->radius = std::fabs(wild(stream));
      c->height = std::fabs(wild(stream));
    }
  } while (!is_legal(pair));
  return pair;
}

/// Returns whether an end of an enclosure is a number, or a string of decimals if no double reaches it.
bool is_end(const nlohmann::json& end, double value) {
  return std::isfinite(value) ? end.get<double>() == value : end == format_end(value);
}

TEST(AnswerJson, IsMadeOfEveryPair) {
  RandomStream stream("answer_json_test", 20261121, 0);
  const auto methods = own_methods();
  int beyond = 0;
  for (int i = 0; i < 500; ++i) {
    const Pair pair = wild_pair(stream);
    const Truth truth = judge(pair);
    const Enclosure distance = enclose_distance(pair, truth);
    const auto stated = parse_json(format_truth(truth, &distance));
    ASSERT_EQ(stated["verdict"], to_string(truth.verdict));
    EXPECT_TRUE(is_end(stated["distance"][0], distance.lo) && is_end(stated["distance"][1], distance.hi))
        << format_pair(pair);
    beyond += stated["distance"][0].is_string() + stated["distance"][1].is_string();
    for (const auto& method : methods)
      EXPECT_NO_THROW(parse_json(format_method_answer(method->ask(pair)))) << format_pair(pair);
  }
  EXPECT_GT(beyond, 50);
}

}  // namespace
}  // namespace cyl
