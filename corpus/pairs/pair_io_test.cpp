// SPDX-License-Identifier: MIT
#include "corpus/pairs/pair_io.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"

namespace cyl {
namespace {

const std::string good_a = R"({"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2})";
const std::string good_b = R"({"center":[3,0,0],"axis":[0,1,0],"radius":0.5,"height":1})";
const std::string good_line = R"({"a":)" + good_a + R"(,"b":)" + good_b + "}";

std::string with_a(const std::string& a) { return R"({"a":)" + a + R"(,"b":)" + good_b + "}"; }
std::string with_more(const std::string& more) {
  return R"({"a":)" + good_a + R"(,"b":)" + good_b + "," + more + "}";
}

std::vector<CaseLine> read_all(const std::string& text) {
  std::istringstream in(text);
  CaseReader reader(in);
  std::vector<CaseLine> out;
  while (auto line = reader.next()) out.push_back(std::move(*line));
  return out;
}

bool same_bits(double x, double y) {
  return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
}

using Bits = std::array<std::uint64_t, solid_number_count>;

bool same_bits(const Solid& x, const Solid& y) {
  return x.shape == y.shape && std::bit_cast<Bits>(numbers_of(x)) == std::bit_cast<Bits>(numbers_of(y));
}

bool same_bits(const Pair& x, const Pair& y) { return same_bits(x.a, y.a) && same_bits(x.b, y.b); }

TEST(PairIo, ReadsWhatItSays) {
  const CaseLine line =
      parse_case(with_more(R"("id":"n\u0061me","source":"a book","truth":"disjoint","note":"ok",)"
                           R"("url":{"x":[1,{"a":null}]},"kind":[true])"),
                 7);
  ASSERT_EQ(line.error, "");
  ASSERT_TRUE(line.value);
  EXPECT_EQ(line.line, 7u);
  EXPECT_EQ(line.value->id, "name");
  EXPECT_EQ(line.value->source, "a book");
  EXPECT_EQ(line.value->truth, Verdict::disjoint);
  EXPECT_EQ(line.value->note, "ok");
  EXPECT_EQ(format_pair(line.value->pair), good_line);
}

TEST(PairIo, KeepsEveryBitOfEveryDouble) {
  constexpr double smallest = std::numeric_limits<double>::denorm_min(),
                   largest = std::numeric_limits<double>::max();
  for (const double x : {0.0, -0.0, smallest, -smallest, 2.2250738585072011e-308, 1e-300, 0.1, -1.0 / 3, 1e23,
                         9007199254740993.0, 123456789012345680.0, largest, -largest}) {
    EXPECT_LE(format_double(x).size(), 24u);
    Case c;
    c.pair.a.center = {x, -x, 1};
    c.pair.b.axis = {1, x, -x};
    c.pair.b.radius = std::abs(x);
    c.pair.a.height = std::abs(x);
    const CaseLine line = parse_case(format_case(c), 1);
    ASSERT_EQ(line.error, "") << x;
    EXPECT_TRUE(same_bits(line.value->pair, c.pair)) << x;
  }
}

TEST(PairIo, ReadsNumbersAsTheNearestDouble) {
  const CaseLine line = parse_case(
      with_a(R"({"center":[-0,-0.0,-0.00e-400],"axis":[9007199254740993,18446744073709551616,-0e5],)"
             R"("radius":1e0,"height":0e-999})"),
      1);
  ASSERT_EQ(line.error, "");
  const Solid& a = line.value->pair.a;
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(same_bits(a.center[i], -0.0)) << i;
  EXPECT_EQ(a.axis.x(), 9007199254740992.0);
  EXPECT_EQ(a.axis.y(), 18446744073709551616.0);
  EXPECT_TRUE(same_bits(a.axis.z(), -0.0));
  EXPECT_EQ(a.radius, 1.0);
  EXPECT_TRUE(same_bits(a.height, 0.0));
}

TEST(PairIo, WritesWhatItReads) {
  Case c;
  c.pair.a.center = {-0.0, 1e-300, 0.1};
  c.id = "quo\"te\\ \n\x01 \xC3\xA9";
  c.source = "s";
  c.truth = Verdict::touching;
  c.note = "n";
  const std::string text = format_case(c);
  EXPECT_EQ(text.substr(0, text.find(",\"axis\"")), R"({"a":{"center":[-0,1e-300,0.1])");
  EXPECT_EQ(text.find('\n'), text.npos);
  const CaseLine line = parse_case(text, 1);
  ASSERT_EQ(line.error, "");
  EXPECT_EQ(line.value->id, c.id);
  EXPECT_EQ(line.value->source, c.source);
  EXPECT_EQ(line.value->truth, c.truth);
  EXPECT_EQ(line.value->note, c.note);
  EXPECT_TRUE(same_bits(line.value->pair, c.pair));
  EXPECT_EQ(format_case(*line.value), text);
  EXPECT_EQ(quote_json("a\xFF"
                       "b"),
            "\"a\xEF\xBF\xBD"
            "b\"");
}

TEST(PairIo, ReadsShapesByName) {
  const auto read = [](const std::string& a) {
    const std::string b = R"({"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2})";
    const CaseLine line = parse_case(R"({"a":)" + a + R"(,"b":)" + b + "}", 1);
    EXPECT_EQ(line.error, "") << a;
    return line.value ? line.value->pair.a : Solid{};
  };
  const Solid sphere = read(R"({"radius":3,"shape":"sphere","center":[1,2,3]})");
  EXPECT_EQ(sphere.rounding, 3);
  EXPECT_EQ(sphere.radius + sphere.height, 0);
  const Solid capsule =
      read(R"({"shape":"capsule","center":[1,2,3],"quaternion":[0,1,0,1],"radius":3,"height":4})");
  EXPECT_EQ(capsule.axis, Vector3(2, 0, 0));
  EXPECT_EQ(capsule.rounding, 3);
  EXPECT_EQ(capsule.radius, 0);
  EXPECT_EQ(capsule.height, 4);
  EXPECT_EQ(read(R"({"shape":"cylinder","center":[0,0,0],"axis":[0,1,0],"radius":1,"height":2})").radius, 1);
  const Solid plane = read(R"({"shape":"half_space","normal":[0,0,-2],"point":[1,2,3]})");
  EXPECT_EQ(plane.shape, Shape::half_space);
  EXPECT_EQ(plane.center, Vector3(1, 2, 3));
  EXPECT_EQ(plane.axis, Vector3(0, 0, -2));
  const std::string written = format_pair({plane, capsule});
  EXPECT_EQ(written.substr(0, written.find(",\"b\"")),
            R"({"a":{"shape":"half_space","point":[1,2,3],"normal":[0,0,-2]})");
  EXPECT_TRUE(same_bits(parse_case(written, 1).value->pair, {plane, capsule}));
  const Solid box =
      read(R"({"rounding":0.5,"quaternion":[0,-0.0,1,2],"edges":[1,0,3],"center":[4,5,6],"shape":"box"})");
  EXPECT_EQ(box.shape, Shape::box);
  EXPECT_EQ(box.center, Vector3(4, 5, 6));
  EXPECT_EQ(box.edges, (std::array<double, 3>{1, 0, 3}));
  EXPECT_EQ(box.quaternion, (std::array<double, 4>{0, 0, 1, 2}));
  EXPECT_EQ(box.rounding, 0.5);
  const Solid plain = read(R"({"shape":"box","center":[0,0,0],"edges":[1,2,3]})");
  EXPECT_EQ(plain.quaternion, (std::array<double, 4>{1, 0, 0, 0}));
  EXPECT_EQ(plain.rounding, 0);
  const std::string boxes = format_pair({plain, box});
  EXPECT_EQ(boxes,
            R"({"a":{"shape":"box","center":[0,0,0],"edges":[1,2,3],"quaternion":[1,0,0,0]},"b":{)"
            R"("shape":"box","center":[4,5,6],"edges":[1,0,3],"quaternion":[0,-0,1,2],"rounding":0.5}})");
  EXPECT_TRUE(same_bits(parse_case(boxes, 1).value->pair, {plain, box}));
}

struct Refusal {
  std::string marked;  ///< a line with '@' before the place that the error must name
  std::string error;
};

TEST(PairIo, NamesTheFaultAndItsPlace) {
  const std::string start = R"({"center":[0,0,0],"axis":[0,0,1],"radius":)";
  const std::string only = "; a cylinder has center, axis, radius, height, rounding";
  const std::vector<Refusal> refusals = {
      // Shapes by name.
      {with_a(R"({"shape":@"ball","center":[0,0,0],"radius":1})"),
       "a.shape is \"ball\", expected cylinder, capsule, sphere, half_space or box"},
      {with_a(R"({"shape":"box","center":[0,0,0],@"size":[1,2,3]})"),
       "a.size is not a field of a solid; give edges, the three full lengths"},
      {with_a(R"({"shape":"box","center":[0,0,0],@"half_extents":[1,2,3]})"),
       "a.half_extents is not a field of a solid; give edges, which are twice as much"},
      {with_a(R"({"shape":"box","center":[0,0,0],"edges":[1,2,3],"radius":1@})"),
       "a.radius is given, but a box has center, edges, and perhaps quaternion and rounding"},
      {with_a(R"({"shape":"box","center":[0,0,0]@})"), "a.edges is missing"},
      {with_a(R"({"shape":"box","center":[0,0,0],"edges":@[1,-2,3]})"), "a.edges are negative"},
      {with_a(R"({"shape":"box","center":[0,0,0],"edges":@[1,2]})"), "a.edges has 2 coordinates, expected 3"},
      {with_a(R"({"shape":"box","center":[0,0,0],"edges":[1,2,3],"quaternion":[0,0,0,-0.0]@})"),
       "a.quaternion is zero"},
      {with_a(R"({"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2,"edges":[1,2,3]@})"),
       "a.edges is given, but a cylinder has center, axis or quaternion, radius, height, and perhaps "
       "rounding"},
      {with_a(R"({"shape":"sphere","center":[0,0,0],"radius":1,"height":2@})"),
       "a.height is given, but a sphere has center and radius"},
      {with_a(R"({"shape":"half_space","point":[0,0,0]@})"), "a.normal is missing"},
      {with_a(R"({"shape":"half_space","point":[0,0,0],"normal":@[0,0,0]})"), "a.normal is zero"},
      {with_a(R"({"shape":"capsule","center":[0,0,0],"quaternion":@[1,0,0],"radius":1,"height":2})"),
       "a.quaternion has 3 coordinates, expected 4"},
      {with_a(R"({"center":[0,0,0],"axis":[0,0,1],"quaternion":[1,0,0,0],"radius":1,"height":2@})"),
       "a has an axis and a quaternion; give one of them"},
      {with_a(R"({"center":[0,0,0],"axis":[0,0,1],"radius":1,@"half_height":2})"),
       "a.half_height is not a field of a solid; give height, which is twice as much"},
      // Values of a cylinder.
      {with_a(start + R"(@-1,"height":2})"), "a.radius is negative (-1)"},
      {with_a(start + R"(1,"height":@-0.5})"), "a.height is negative (-0.5)"},
      {with_a(R"({"center":[0,0,0],"axis": @[0, -0.0, 0],"radius":1,"height":2})"), "a.axis is zero"},
      {with_a(start + R"(@"1","height":2})"), "a.radius is a string, expected a number"},
      {with_a(start + R"(@null,"height":2})"), "a.radius is null, expected a number"},
      {with_a(start + R"(@[1],"height":2})"), "a.radius is a list, expected a number"},
      {with_a(start + R"(@NaN,"height":2})"), "a.radius is NaN, expected a number"},
      {with_a(start + R"(@-Infinity,"height":2})"), "a.radius is -Infinity, expected a number"},
      {with_a(start + R"(@.5,"height":2})"), "a.radius is .5, expected a number"},
      {with_a(start + R"(0@x10,"height":2})"), "not JSON: invalid literal"},
      {with_a(start + R"(0@1,"height":2})"), "not JSON: unexpected number literal; expected '}'"},
      {with_a(start + R"(@1e999,"height":2})"), "a.radius overflows a double (1e999)"},
      {with_a(R"({"center":[0,@-1e999,0],"axis":[0,0,1],"radius":1,"height":2})"),
       "a.center[1] overflows a double (-1e999)"},
      {with_a(start + R"(@1e-999,"height":2})"), "a.radius underflows a double (1e-999)"},
      {with_a(start + R"(@0.)" + std::string(330, '0') + R"(1,"height":2})"),
       "a.radius underflows a double (0." + std::string(38, '0') + "...)"},
      {with_a(R"({"center":[0,0,0],"axis":[0,@1e-400,1],"radius":1,"height":2})"),
       "a.axis[1] underflows a double (1e-400)"},
      {with_a(R"({"center":@[0,0],"axis":[0,0,1],"radius":1,"height":2})"),
       "a.center has 2 coordinates, expected 3"},
      {with_a(R"({"center":[0,0,0,@7],"axis":[0,0,1],"radius":1,"height":2})"),
       "a.center has more than 3 coordinates"},
      {with_a(R"({"center":@0,"axis":[0,0,1],"radius":1,"height":2})"),
       "a.center is a number, expected a list of 3 numbers"},
      {R"({"a":)" + good_a + R"(,"b":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":@-2}})",
       "b.height is negative (-2)"},
      // Fields of a cylinder.
      {with_a(R"({"center":[0,0,0],"axis":[0,0,1],@"raduis":1,"height":2})"),
       "a.raduis is not a field of a solid" + only},
      {with_a(R"({@")" + std::string(50, 'x') + R"(":1})"),
       "a." + std::string(40, 'x') + "... is not a field of a solid" + only},
      {with_a(start + R"(1@})"), "a.height is missing"},
      {with_a("{@}"), "a.center is missing"},
      {with_a(start + R"(1,@"radius":1,"height":2})"), "a.radius is given twice"},
      // The line itself.
      {R"({"a":)" + good_a + "@}", "b is missing"},
      {R"({"b":)" + good_a + " @}", "a is missing"},
      {with_a("@[0,0,0]"), "a is a list, expected an object"},
      {with_more(R"("id":@7)"), "id is a number, expected a string"},
      {with_more(R"("truth":@true)"), "truth is true, expected a string"},
      {with_more(R"("truth":@"maybe")"),
       "truth is \"maybe\", expected disjoint, intersecting, touching, undecided or invalid"},
      {with_more(R"(@"truht":"disjoint")"), "truht is not a known key; did you mean truth?"},
      {with_more(R"(@"sources":"x")"), "sources is not a known key; did you mean source?"},
      {with_more(R"("x":1,@"x":2)"), "x is given twice"},
      {with_more(R"(@"a":)" + good_a), "a is given twice"},
      {with_more(R"("url":[1,{"x":@1e999}])"), "a number overflows a double (1e999)"},
      // Not an object, or not JSON.
      {"@[]", "the line is a list, expected an object"},
      {"@hello", "not JSON: invalid literal"},
      {good_line + "@x", "not JSON: invalid literal"},
      {good_line.substr(0, good_line.size() - 1) + "@", "not JSON: unexpected end of input; expected '}'"},
      {with_more("@"), "not JSON: unexpected '}'; expected string literal"},
      {with_more("\"id\":\"a@\xFF"
                 "b\""),
       "not JSON: invalid string: ill-formed UTF-8 byte"},
      {with_more("\"x\":[\"a@\xFF"
                 "b\"]"),
       "not JSON: invalid string: ill-formed UTF-8 byte"},
      {with_more(R"("id":"\@q")"), "not JSON: invalid string: forbidden character after backslash"},
      {with_more("\"id\":\"a@" + std::string(1, '\0') + "b\""), "not JSON: a NUL byte"},
      {good_line + "@" + std::string(1, '\0') + "x", "not JSON: a NUL byte"},
      {"@\xEF\xBB\xBF" + good_line, "not JSON: a byte order mark"},
      {"@" + std::string(100000, '['), "the line is a list, expected an object"},
      {with_more("\"x\":" + std::string(100000, '[') + "@}"),
       "not JSON: unexpected '}'; expected '[', '{', or a literal"},
  };
  for (const Refusal& r : refusals) {
    const std::size_t at = r.marked.find('@');
    ASSERT_NE(at, r.marked.npos);
    const std::string text = r.marked.substr(0, at) + r.marked.substr(at + 1);
    const CaseLine line = parse_case(text, 3);
    EXPECT_FALSE(line.value) << r.marked;
    EXPECT_EQ(line.line, 3u);
    EXPECT_EQ(line.error, "line 3, column " + std::to_string(at + 1) + ": " + r.error)
        << r.marked.substr(0, 300);
  }
}

TEST(PairIo, SkipsOtherKeysWhateverTheyHold) {
  const std::string deep(100000, '[');
  for (const std::string& more :
       {std::string(R"("url":"x","report":null,"kind":{"a":{"radius":-1},"truht":1},"numbers_exact":false)"),
        "\"x\":" + deep + std::string(100000, ']'), std::string(R"("c":1,"trust":2,"ids":3,"not_a_note":4)"),
        std::string(R"("":0,"tiny":1e-999)")}) {
    const CaseLine line = parse_case(with_more(more), 1);
    ASSERT_EQ(line.error, "") << more.substr(0, 100);
    EXPECT_EQ(format_pair(line.value->pair), good_line);
  }
}

TEST(PairIo, AnswersEveryLineAroundABadOne) {
  const std::string blank = " \t";
  const auto lines = read_all("\xEF\xBB\xBF" + good_line + "\r\n\n" + blank + "\r\n{\"a\":1}\n" + good_line +
                              "\n\xEF\xBB\xBF" + good_line + "\n" + good_line);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_TRUE(lines[0].value);
  EXPECT_EQ(lines[0].line, 1u);
  EXPECT_EQ(lines[1].error, "line 4, column 6: a is a number, expected an object");
  EXPECT_TRUE(lines[2].value);
  EXPECT_EQ(lines[2].line, 5u);
  EXPECT_EQ(lines[3].error, "line 6, column 1: not JSON: a byte order mark");
  EXPECT_TRUE(lines[4].value);
  EXPECT_EQ(lines[4].line, 7u);
  EXPECT_TRUE(read_all("").empty());
  EXPECT_TRUE(read_all("\n \n\xEF\xBB\xBF").size() == 1);
  EXPECT_TRUE(read_all("\xEF\xBB\xBF\r\n").empty());
}

TEST(PairIo, RefusesALineBeyondTheCapAndGoesOn) {
  const std::string head = good_line.substr(0, good_line.size() - 1) + R"(,"note":")", tail = "\"}";
  const auto line_of = [&](std::size_t size) {
    return head + std::string(size - head.size() - tail.size(), 'x') + tail;
  };
  const std::string too_long = "column 1048577: the line is longer than 1 MiB";
  for (const char* newline : {"\n", "\r\n"}) {
    const auto lines =
        read_all(line_of(line_cap) + newline + line_of(line_cap + 1) + newline + line_of(3 * line_cap) +
                 newline + std::string(2 * line_cap, ' ') + newline + good_line);
    ASSERT_EQ(lines.size(), 5u);
    EXPECT_EQ(lines[0].error, "");
    EXPECT_EQ(lines[1].error, "line 2, " + too_long);
    EXPECT_EQ(lines[2].error, "line 3, " + too_long);
    EXPECT_EQ(lines[3].error, "line 4, " + too_long);
    EXPECT_EQ(lines[4].error, "");
    EXPECT_EQ(lines[4].line, 5u);
  }
  EXPECT_EQ(read_all(line_of(line_cap)).at(0).error, "");
  EXPECT_EQ(read_all(line_of(line_cap + 1)).at(0).error, "line 1, " + too_long);
}

// For any bytes, a line gives a value or an error. A value is valid and survives a round trip.
TEST(PairIo, SurvivesMutatedBytes) {
  const std::vector<std::string> seeds = {
      good_line,
      with_more(R"("id":"n\u0061me","source":"b\\k","truth":"touching","note":"","x":[1,{"y":null}]})"),
      with_a(R"({"center":[-0,1e-300,-1.5E+3],"axis":[0,0,1e150],"radius":0,"height":0})"),
      with_a(R"({"shape":"box","center":[1,2,3],"edges":[0,1.5,2],"quaternion":[1,0,-1,0],"rounding":1})")};
  RandomStream stream("pair_io_test", 20261121, 1);
  const auto bits = [&] { return static_cast<std::uint32_t>(stream.bits() >> 32); };
  constexpr std::string_view favourites = "\"\\{}[]:,-+.eE0123456789 \t\r\n\xEF\xBB\xBF\xFFtruefalsn";
  std::string batch;
  std::size_t values = 0;
  for (int i = 1; i <= 40000; ++i) {
    std::string text = seeds[bits() % seeds.size()];
    for (unsigned edits = 1 + bits() % 2; edits > 0; --edits) {
      const std::size_t at = bits() % text.size();
      const char byte = bits() % 4 != 0 ? favourites[bits() % favourites.size()] : static_cast<char>(bits());
      switch (bits() % 4) {
        case 0:
          text[at] = byte;
          break;
        case 1:
          text.insert(at, 1, byte);
          break;
        case 2:
          text.erase(at, 1 + bits() % 3);
          break;
        case 3:
          text.insert(at, text.substr(at / 2, bits() % 20));
          break;
      }
      if (text.empty()) text = "{";
    }
    batch += text + "\n";
    if (i % 100 != 0) continue;
    for (const CaseLine& line : read_all(std::exchange(batch, {}))) {
      ASSERT_EQ(line.error.empty(), line.value.has_value())
          << line.error << format_case(line.value.value_or(Case{}));
      if (!line.value) {
        ASSERT_LT(line.error.size(), 250u);
        continue;
      }
      ++values;
      ASSERT_EQ(find_defect(line.value->pair.a), Defect::none) << format_case(*line.value);
      ASSERT_EQ(find_defect(line.value->pair.b), Defect::none) << format_case(*line.value);
      const CaseLine again = parse_case(format_case(*line.value), 1);
      ASSERT_EQ(again.error, "") << format_case(*line.value);
      ASSERT_TRUE(same_bits(again.value->pair, line.value->pair)) << format_case(*line.value);
      ASSERT_EQ(again.value->note, line.value->note);
    }
  }
  EXPECT_GT(values, 300u);
}

}  // namespace
}  // namespace cyl
