// SPDX-License-Identifier: MIT
// The report on many cylinders, as text and as JSON.
#include "reports/scene/near_report.hpp"

#include <gtest/gtest.h>

#include "base/json.hpp"
#include "reports/schemas/schema_check_test.hpp"
#include "scenes/near/scene_generators.hpp"

namespace cyl {
namespace {

using json = nlohmann::json;

const std::string hostile = "</script><img src=x onerror=alert(1)>\"\x01\xff@@STYLE@@$&";

NearStudy rods(std::size_t count, double clearance) {
  NearStudy study;
  study.generated = "rods";
  study.seed = 3;
  study.clearance = clearance;
  study.cylinders = generate_cylinders("rods", count, 3);
  study.pairs = find_close_pairs(study.cylinders, clearance);
  study.check = check_close_pairs(study.cylinders, clearance, study.pairs);
  study.nearest = nearest_pairs(study.cylinders, clearance, study.pairs, 20);
  return study;
}

NearStudy of_a_file() {
  NearStudy study = rods(40, 0.2);
  study.generated.clear();
  study.check.reset();
  study.file = hostile;
  study.cylinders.front().rounding = 0.1 + 0.2;
  study.cylinders.front().height = 2.0 / 3;
  study.names.assign(study.cylinders.size(), hostile);
  return study;
}

TEST(NearReport, KeepsToItsSchema) {
  if (schema_python().empty()) SKIP_WITHOUT("python3-jsonschema");
  const std::string document = near_json(rods(300, 0));
  EXPECT_TRUE(keeps_to("close_pairs.json", document)) << document;
  EXPECT_TRUE(keeps_to("close_pairs.json", near_json(of_a_file())));
  const json good = parse_json(document);
  for (const char* planted :
       {R"([{"op":"replace","path":"/nearest/0/certificate","value":"a vote"}])",
        R"([{"op":"remove","path":"/nearest/0/on_a/2"}])", R"([{"op":"remove","path":"/within/0/1"}])",
        R"([{"op":"remove","path":"/cpu_ms/tree"}])",
        R"([{"op":"replace","path":"/certificates/failed","value":-1}])",
        R"([{"op":"add","path":"/file","value":"and a file too"}])", R"([{"op":"remove","path":"/seed"}])",
        R"([{"op":"add","path":"/colour","value":"red"}])"})
    EXPECT_FALSE(keeps_to("close_pairs.json", good.patch(parse_json(planted)).dump())) << planted;
}

TEST(NearReport, HoldsTheNearestPairsToTheBit) {
  const NearStudy study = of_a_file();
  const json all = parse_json(near_json(study));
  ASSERT_EQ(all["nearest"].size(), study.nearest.size());
  for (std::size_t i = 0; i < study.nearest.size(); ++i) {
    EXPECT_EQ(all["nearest"][i]["distance"], study.nearest[i].distance);
    EXPECT_EQ(all["nearest"][i]["a"], study.nearest[i].bodies.first);
    EXPECT_EQ(all["nearest"][i]["on_b"][2], study.nearest[i].on_b[2]);
    EXPECT_EQ(all["nearest"][i]["certificate"] == "direction", !study.nearest[i].within);
  }
  EXPECT_EQ(all["within"].size(), study.pairs.within.size());
}

TEST(NearReport, SaysWhatWasAskedAndFound) {
  const NearStudy study = rods(300, 0);
  const json all = parse_json(near_json(study));
  EXPECT_EQ(all["generated"], "rods");
  EXPECT_EQ(all["seed"], "3");
  EXPECT_EQ(all["cylinders"], 300);
  EXPECT_EQ(all["candidates"], study.pairs.candidates.size());
  EXPECT_EQ(all["verification"]["asked"], all["candidates"]);
  EXPECT_EQ(all["certificates"]["checked"], all["candidates"]);
  EXPECT_EQ(all["certificates"]["failed"], 0);
  EXPECT_FALSE(all.contains("names"));
}

TEST(NearReport, ListsTheNearestPairsByName) {
  NearStudy study = of_a_file();
  study.names[study.nearest[0].bodies.first] = "a \"rod\", long";
  study.check.emplace();
  study.check->referee.asked = 5;
  study.check->certificates.checked = 4;
  study.check->certificates.undecided = 1;
  const std::string text = near_text(study, 1), csv = near_csv(study);
  EXPECT_NE(text.find("\nreferee: 5 pairs judged, 0 wrong, 0 not proved, 0 ms\n"
                      "certificates: 4 checked, 0 failed, 1 pairs without one, 0 ms\n"),
            text.npos);
  EXPECT_TRUE(text.ends_with("  a \"rod\", long - " + hostile + "\n")) << text;
  EXPECT_NE(csv.find("\n\"a \"\"rod\"\", long\",\"</script><img src=x onerror=alert(1)>\"\""), csv.npos)
      << csv;
  EXPECT_EQ(near_text(study, 0).find("certificate "), std::string::npos);
}

}  // namespace
}  // namespace cyl
