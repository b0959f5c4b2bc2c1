// SPDX-License-Identifier: MIT
#include "fuzz/guided/record.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "base/error_of_test.hpp"
#include "base/scratch_test.hpp"
#include "corpus/pairs/pair_numbers.hpp"

namespace cyl {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const Pair pair{{{0, 1, 2}, {3, 4, 5}, 6, 7, 8}, {{9, 10, 11}, {12, 13, 14}, 15, 16, 17}};

TEST(Record, KeepsEveryBit) {
  for (const Pair& p :
       {pair, Pair{{{-0.0, 0x1p-1074, 0x1.fffffffffffffp1023}, {nan, -nan, 1 / 3.0}, 0x1p-1022, 5, nan},
                   {{1, 2, 3}, {4, 5, 6}, std::numeric_limits<double>::infinity(), -7, 0}}}) {
    const Record record = encode_record(p);
    ASSERT_TRUE(decode_record(record));
    EXPECT_EQ(encode_record(*decode_record(record)), record);
  }
  EXPECT_EQ(numbers_of(*decode_record(encode_record(pair))), numbers_of(pair));
  const Solid box{.center = {1, 2, 3},
                  .rounding = 4,
                  .shape = Shape::box,
                  .edges = {5, 6, 7},
                  .quaternion = {8, 9, 10, 11}};
  const Pair mixed{box, pair.b}, read = *decode_record(encode_record(mixed));
  EXPECT_EQ(numbers_of(read), numbers_of(mixed));
  EXPECT_EQ(read.a.shape, Shape::box);
}

TEST(Record, OfAnotherShapeOrSizeIsNone) {
  Record record = encode_record(pair);
  EXPECT_FALSE(decode_record(std::span(record).first(128))) << "as in earlier versions";
  record[0] = 1;
  EXPECT_EQ(decode_record(record)->a.shape, Shape::half_space);
  record[0] = words_of(Shape{}).size();
  EXPECT_FALSE(decode_record(record));
}

class Corpus : public testing::Test, protected Scratch {
 protected:
  void keep(const std::string& file, const Pair& p, std::size_t size = record_size) {
    const Record record = encode_record(p);
    write(file, {reinterpret_cast<const char*>(record.data()), size});
  }
};

TEST_F(Corpus, HasEachFinitePairOnce) {
  std::filesystem::create_directories(folder / "core");
  Pair infinite = pair;
  infinite.a.height = nan;
  keep("core/b", pair);
  keep("a", pair);
  keep("c", infinite);
  const std::vector<Pair> pairs = read_corpus(folder.string());
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(numbers_of(pairs[0]), numbers_of(pair));
  keep("short", pair, 128);
  const std::string error = error_of([&] { read_corpus(folder.string()); });
  EXPECT_NE(error.find("short is not a record"), std::string::npos) << error;
}

}  // namespace
}  // namespace cyl
