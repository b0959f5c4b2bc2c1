// SPDX-License-Identifier: MIT
#include "oracles/methods/guest_protocol.hpp"

#include <gtest/gtest.h>

#include "corpus/pairs/truth_io.hpp"

namespace cyl {
namespace {

TEST(GuestLines, AnAnswer) {
  const GuestLine line = parse_guest_line(
      R"({"verdict":"intersecting","distance":-0.25,"point":[1,[2,1e-20],-3],"direction":[0,0,1],"x":{}})");
  ASSERT_TRUE(line.answer) << line.error;
  EXPECT_FALSE(line.hello);
  EXPECT_EQ(line.answer->verdict, Verdict::intersecting);
  EXPECT_EQ(line.answer->distance, -0.25);
  EXPECT_EQ(line.answer->point, (std::array<double, 6>{1, 2, -3, 0, 1e-20, 0}));
  EXPECT_EQ(line.answer->direction, (std::array<double, 3>{0, 0, 1}));
}

TEST(GuestLines, ALowerBoundOfTheDistance) {
  const GuestLine line = parse_guest_line(R"({"verdict":"disjoint","distance_at_least":0.5})");
  ASSERT_TRUE(line.answer) << line.error;
  EXPECT_EQ(line.answer->at_least, 0.5);
  const MethodAnswer beyond = method_answer(*line.answer, false);
  EXPECT_FALSE(beyond.has_distance);
  EXPECT_TRUE(beyond.at_least);
  EXPECT_EQ(beyond.distance, 0.5);
  EXPECT_EQ(format_method_answer(beyond), R"({"verdict":"disjoint","distance_at_least":0.5})");
  EXPECT_NE(parse_guest_line(R"({"verdict":"disjoint","distance":1,"distance_at_least":0.5})").error, "");
}

TEST(GuestLines, ADepthThatIsAnUpperBound) {
  const auto is_bound = [](const char* text, bool depth_at_most) {
    return method_answer(*parse_guest_line(text).answer, depth_at_most).at_least;
  };
  const char* deep = R"({"verdict":"intersecting","distance":-0.5})";
  EXPECT_TRUE(is_bound(deep, true));
  EXPECT_FALSE(is_bound(deep, false));
  EXPECT_FALSE(is_bound(R"({"verdict":"intersecting"})", true));
  EXPECT_FALSE(is_bound(R"({"verdict":"disjoint","distance":0.5})", true)) << "gaps stay exact";
  EXPECT_TRUE(parse_guest_line(R"({"name":"x","depth":"at_most"})").hello->depth_at_most);
  EXPECT_FALSE(parse_guest_line(R"({"name":"x","depth":"exact"})").hello->depth_at_most);
  EXPECT_NE(parse_guest_line(R"({"name":"x","depth":"at_least"})").error, "");
}

TEST(GuestLines, DecliningIsNoFailing) {
  const GuestLine declined = parse_guest_line(R"({"declined":"no disks"})");
  ASSERT_TRUE(declined.answer);
  EXPECT_TRUE(declined.answer->declined);
  EXPECT_EQ(declined.answer->reason, "no disks");
  const GuestLine failed = parse_guest_line(R"({"error":"no convergence"})");
  ASSERT_TRUE(failed.answer);
  EXPECT_FALSE(failed.answer->declined || failed.answer->verdict);
  EXPECT_EQ(failed.answer->reason, "no convergence");
}

TEST(GuestLines, AHello) {
  const GuestLine line = parse_guest_line(
      R"({"name":"mine","version":"1.2","claim":{"relative":1e-6,"absolute":1e-9,"source":"manual"},)"
      R"("call":"meet","install":"make","files":["mine.h"]})");
  ASSERT_TRUE(line.hello) << line.error;
  EXPECT_EQ(line.hello->name, "mine");
  EXPECT_EQ(line.hello->version, "1.2");
  EXPECT_EQ(line.hello->relative, 1e-6);
  EXPECT_EQ(line.hello->absolute, 1e-9);
  EXPECT_EQ(line.hello->claim_source, "manual");
  EXPECT_EQ(line.hello->upstream.call, "meet");
  EXPECT_EQ(line.hello->upstream.install, "make");
  EXPECT_EQ(line.hello->upstream.files, std::vector<std::string>{"mine.h"});
}

TEST(GuestLines, AHelloThatStatesWhatIsSupported) {
  const GuestLine line = parse_guest_line(
      R"({"takes":["sphere","capsule"],"sizes":{"least":0.01,"greatest":100,"aspect":50,"zero":false}})");
  ASSERT_TRUE(line.hello) << line.error;
  EXPECT_EQ(line.hello->supports, (std::array{true, true, false, false, false, false, false}));
  EXPECT_EQ(line.hello->sizes, (SizeRange{0.01, 100, 50, false}));
  EXPECT_EQ(parse_guest_line(R"({"name":"x","sizes":{"least":1}})").hello->sizes, (SizeRange{.least = 1}));
  EXPECT_EQ(parse_guest_line(R"({"name":"x","sizes":{"coordinate":9,"gap":2}})").hello->sizes,
            (SizeRange{.coordinate = 9, .gap = 2}));
  EXPECT_EQ(parse_guest_line(R"({"sizes":{"aspect":9}})").hello->sizes, (SizeRange{.aspect = 9}));
  EXPECT_TRUE(parse_guest_line(R"({"name":"x","takes":[]})").error.starts_with("takes is empty"));
  EXPECT_TRUE(
      parse_guest_line(R"({"takes":["half_space"]})").error.starts_with("takes has half_space alone"));
  EXPECT_TRUE(parse_guest_line(R"({"takes":["half_space","sphere"]})").hello);
  EXPECT_EQ(parse_guest_line(R"({"takes":["box","rounded_box"]})").hello->supports,
            (std::array{false, false, false, false, false, true, true}));
  for (const char* wrong : {R"({"name":"x","sizes":3})", R"({"name":"x","sizes":{"least":-1}})",
                            R"({"name":"x","sizes":{"gap":-1}})", R"({"name":"x","sizes":{"coordinates":9}})",
                            R"({"name":"x","sizes":{"least":2,"greatest":1}})",
                            R"({"name":"x","sizes":{"zero":1}})", R"({"name":"x","files":[1]})"})
    EXPECT_NE(parse_guest_line(wrong).error, "") << wrong;
}

TEST(GuestLines, AnythingElseIsAnErrorThatShowsALittleOfIt) {
  const auto error = [](std::string_view text) {
    const GuestLine line = parse_guest_line(text);
    EXPECT_FALSE(line.hello || line.answer) << text;
    return line.error;
  };
  EXPECT_EQ(error("loading\n..."), "not JSON: \"loading\\n...\"");
  EXPECT_EQ(error(""), "not JSON: \"\"");
  EXPECT_EQ(error(R"({"verdict":"disjoint","distance":NaN})"),
            R"(not JSON: "{\"verdict\":\"disjoint\",\"distance\":NaN}")");
  EXPECT_EQ(error(R"({"verdict":"disjoint","distance":1e999})").substr(0, 8), "not JSON");
  EXPECT_EQ(error("[1]"), "no object: \"[1]\"");
  EXPECT_EQ(error("{}"), "neither a verdict nor declined, error or a hello: \"{}\"");
  EXPECT_EQ(error(R"({"verdict":"no"})").substr(0, 19), R"(the verdict is "no")");
  EXPECT_EQ(error(R"({"verdict":7})").substr(0, 20), "verdict is no string");
  EXPECT_EQ(error(R"({"verdict":"disjoint","direction":[1,2]})").substr(0, 25), "direction is no list of 3");
  EXPECT_EQ(error(R"({"verdict":"disjoint","point":[1,2,[3]]})").substr(0, 23), "a coordinate of point i");
  EXPECT_EQ(error(R"({"name":"x","claim":{"relative":-1}})").substr(0, 30), "relative of the claim is negat");
  EXPECT_LT(error(std::string(100'000, '[')).size(), 100u);
  EXPECT_EQ(error("\xff\xfe"), "not JSON: \"\xef\xbf\xbd\xef\xbf\xbd\"");
}

}  // namespace
}  // namespace cyl
