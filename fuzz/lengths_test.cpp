// SPDX-License-Identifier: MIT
// Every place that reads the lengths of a solid, in one table: each must see each length of each shape. A
// shape or a length that is new fails here until all places know it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "corpus/pairs/pair_digest.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_json.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/size_range.hpp"
#include "corpus/pairs/support.hpp"
#include "fuzz/guided/record.hpp"
#include "fuzz/worst/shapes.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/cells.hpp"
#include "oracles/trial/failure_key.hpp"
#include "props/laws/laws.hpp"
#include "props/shrink/complexity.hpp"
#include "props/shrink/moves.hpp"

namespace cyl {

/// Is declared in fuzz/guided/mutator.hpp, whose function moves() has the name of the shrinker's namespace.
Pair mutate(const Pair& pair, std::uint64_t seed);

namespace {

/// The places of lengths in numbers_of(): radius, height, rounding, edges.
constexpr std::array<std::size_t, 6> length_places{6, 7, 8, 9, 10, 11};

/// A legal solid of each shape with lengths that differ, which a law or a place may not confuse.
Solid solid_of(Shape shape) {
  if (shape == Shape::half_space) return {.axis = {0, 0, 1}, .shape = shape};
  if (shape == Shape::box)
    return {.center = {0.1, 0.2, 4},
            .rounding = 0.5,
            .shape = shape,
            .edges = {1, 2, 3},
            .quaternion = {1, 0.5, 0.25, 0.125}};
  return {.center = {0.1, 0.2, 4}, .axis = {1, 2, 3}, .radius = 1, .height = 1.25, .rounding = 0.5};
}

/// All pairs of two shapes, and the places of lengths that their solids have.
struct Length {
  Pair pair;
  Solid Pair::*solid;
  std::size_t place;
  double& of(Pair& other) const { return *numbers_of(other.*solid)[place]; }
  Pair changed(const std::function<double(double)>& change) const {
    Pair other = pair;
    of(other) = change(of(other));
    return other;
  }
};

std::vector<Length> all_lengths() {
  std::vector<Length> all;
  for (const Shape one : {Shape::cylinder, Shape::box})
    for (const Shape two : {Shape::cylinder, Shape::box, Shape::half_space}) {
      Pair pair{solid_of(one), solid_of(two)};
      pair.a.center = {1, 1, 1};
      if (one == Shape::cylinder) pair.a.axis = {1, 0, 1};
      for (const auto solid : {&Pair::a, &Pair::b})
        for (const std::size_t place : places_of((pair.*solid).shape))
          if (std::ranges::count(length_places, place)) all.push_back({pair, solid, place});
    }
  return all;
}

std::string where(const Length& length) {
  return format_pair(length.pair) + (length.solid == &Pair::a ? " a " : " b ") + std::to_string(length.place);
}

double support_of(const Pair& pair) {
  const Vec3<double> d{0.6, 0.48, 0.64};
  double sum = 0;
  for (const Solid* c : {&pair.a, &pair.b})
    if (!is_half_space(*c)) sum += support(terms_of<double>(*c), d);
  return sum;
}

/// The result of a place in the code for a pair.
template <class Result>
struct Place {
  const char* name;
  std::function<Result(const Pair&)> of;
};

/// Text that must differ if a length differs.
const Place<std::string> readers[] = {
    {"size_of", [](const Pair& p) { return format_double(size_of(p)); }},
    {"digest_of", [](const Pair& p) { return std::to_string(digest_of(p, 0)); }},
    {"format_pair", [](const Pair& p) { return format_pair(p); }},
    {"pair_json", [](const Pair& p) { return pair_json(p).dump(); }},
    {"encode_record",
     [](const Pair& p) {
       const Record record = encode_record(p);
       return std::string(record.begin(), record.end());
     }},
    {"decode_record", [](const Pair& p) { return format_pair(*decode_record(encode_record(p))); }},
    {"support", [](const Pair& p) { return format_double(support_of(p)); }},
    {"approximate_distance",
     [](Pair p) {  // so far apart that corners and rims are nearest
       p.b.center += Vector3(13, 17, 19);
       return format_double(approximate_distance(p).value);
     }},
    {"complexity",
     [](const Pair& p) {
       std::string text;
       for (const double x : complexity(p).values) text += format_double(x) + ' ';
       return text;
     }},
};

TEST(Lengths, EveryReaderSeesEachLength) {
  for (const Length& length : all_lengths())
    for (const auto& reader : readers)
      EXPECT_NE(reader.of(length.pair), reader.of(length.changed([](double x) { return 1.25 * x; })))
          << reader.name << ": " << where(length);
}

/// Whether a pair is out of the ordinary; a length of a thousandth or a million is.
const Place<bool> judges[] = {
    {"is_ordinary", [](const Pair& p) { return !is_ordinary(p); }},
    {"SizeRange::holds", [](const Pair& p) { return !SizeRange{.least = 0.1, .greatest = 10}.holds(p); }},
    {"is_legal", [](const Pair& p) { return !is_legal(p); }},
    {"cells",
     [](const Pair& p) {
       return cells_of(p, Verdict::intersecting)[static_cast<std::size_t>(Plane::aspect_margin)].x > 3;
     }},
    {"coordinate_of", [](const Pair& p) { return coordinate_of(p, 0.1) != Coordinate::plain; }},
};

TEST(Lengths, EveryJudgeSeesEachLength) {
  for (const Length& length : all_lengths())
    for (const auto& judge : judges) {
      EXPECT_FALSE(judge.of(length.pair)) << judge.name << ": " << where(length);
      // With a half-space there is nothing to compare the size with, and a ball has an aspect of 1.
      if (has_half_space(length.pair) && length.place == 8 && judge.name == std::string_view("cells"))
        continue;
      const double much = std::string_view(judge.name) == "is_legal" ? -1 : 1e6;
      EXPECT_TRUE(judge.of(length.changed([=](double) { return much; })))
          << judge.name << ": " << where(length);
    }
}

std::vector<Pair> asked_by(int law, const Pair& pair) {
  const auto method = fake_method("any", [](const Pair&) { return answered(Verdict::intersecting); });
  std::vector<Pair> pairs;
  for (const LawQuery& query : law_numbered(law).queries(*method, pair, answered(Verdict::intersecting)))
    pairs.push_back(query.pair);
  return pairs;
}
/// Similar pairs, with all lengths and centres times one factor.
const Place<std::vector<Pair>> scalers[] = {
    {"scaled", [](const Pair& p) { return std::vector{scaled(p, 3)}; }},
    {"scaled_exactly", [](const Pair& p) { return std::vector{*scaled_exactly(p, -3)}; }},
    {"fitted", [](const Pair& p) { return std::vector{fitted(p, {.greatest = 0.25}).value_or(p)}; }},
    {"moves::scales", [](const Pair& p) { return moves::scales(p); }},
    {"law 2", [](const Pair& p) { return asked_by(2, p); }},
    {"bring_into_domain",
     [](const Pair& p) {
       const Pair large = scaled(p, 12);
       return std::vector{has_half_space(p) ? large : bring_into_domain(large).value()};
     }},
};

TEST(Lengths, EveryScalerScalesEachLength) {
  for (const Length& length : all_lengths())
    for (const auto& scaler : scalers) {
      Pair before = length.pair;
      int scaled_pairs = 0;
      for (Pair after : scaler.of(before)) {
        const double factor = size_of(after) / size_of(before);
        scaled_pairs += factor != 1;
        EXPECT_NEAR(length.of(after), factor * length.of(before), 1e-12 * factor)
            << scaler.name << ": " << where(length);
      }
      EXPECT_GT(scaled_pairs, 0) << scaler.name;
    }
}

/// Pairs. In one of them each length is larger than before, or otherwise changed.
const Place<std::vector<Pair>> changers[] = {
    {"law 10 or 25",
     [](const Pair& p) {
       std::vector<Pair> all = asked_by(10, p);
       MethodAnswer apart = answered(Verdict::disjoint);
       apart.has_distance = true, apart.distance = 1;
       const auto method = fake_method("any", [](const Pair&) { return answered(Verdict::disjoint); });
       for (const LawQuery& query : law_numbered(25).queries(*method, p, apart)) all.push_back(query.pair);
       return all;
     }},
    {"law 11", [](const Pair& p) { return asked_by(11, p); }},
    {"mutate",
     [](const Pair& p) {
       std::vector<Pair> all;
       for (std::uint64_t seed = 0; seed < 2000; ++seed) all.push_back(mutate(p, seed));
       return all;
     }},
    {"one_number",
     [](const Pair& p) {
       std::vector<Pair> all;
       for (std::size_t i = 0; i < 2 * solid_number_count; ++i)
         std::ranges::copy(moves::one_number(p, i), std::back_inserter(all));
       return all;
     }},
    {"equalities", [](const Pair& p) { return moves::equalities(p); }},
    {"nudged",
     [](const Pair& p) {
       RandomStream stream("lengths_test", 1, 0);
       std::vector<Pair> all;
       for (int i = 0; i < 20; ++i) all.push_back(nudged(p, stream));
       return all;
     }},
    {"roundings", [](const Pair& p) { return moves::roundings(scaled(p, -3)); }},
};

TEST(Lengths, EveryChangerChangesEachLength) {
  for (const Length& length : all_lengths())
    for (const auto& changer : changers) {
      Pair before = length.pair;
      const std::vector<Pair> all = changer.of(before);
      EXPECT_TRUE(std::ranges::any_of(all, [&](Pair after) { return length.of(after) != length.of(before); }))
          << changer.name << ": " << where(length);
    }
}

TEST(Lengths, TheMutatorMendsEachLength) {
  for (const Length& length : all_lengths())
    for (const double bad : {-1.0, std::nan(""), HUGE_VAL})
      EXPECT_TRUE(is_legal(mutate(length.changed([=](double) { return bad; }), 1))) << where(length);
}

}  // namespace
}  // namespace cyl
