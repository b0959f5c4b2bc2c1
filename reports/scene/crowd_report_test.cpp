// SPDX-License-Identifier: MIT
// What is written of many cylinders, as text and as JSON.
#include "reports/scene/crowd_report.hpp"

#include <gtest/gtest.h>

#include "base/json.hpp"
#include "reports/schemas/schema_check_test.hpp"
#include "reports/web/page_template.hpp"
#include "scenes/scene_generators.hpp"

namespace cyl {
namespace {

using json = nlohmann::json;

const std::string hostile = "</script><img src=x onerror=alert(1)>\"\x01\xff@@STYLE@@$&";

Crowd rods(std::size_t count, double clearance) {
  Crowd crowd;
  crowd.generated = "rods";
  crowd.seed = 3;
  crowd.clearance = clearance;
  crowd.cylinders = generate_cylinders("rods", count, 3);
  crowd.pairs = find_close_pairs(crowd.cylinders, clearance);
  crowd.growth = {growth_row(find_close_pairs(generate_cylinders("rods", count / 2, 3), clearance)),
                  growth_row(crowd.pairs)};
  crowd.check = check_close_pairs(crowd.cylinders, clearance, crowd.pairs);
  crowd.nearest = nearest_pairs(crowd.cylinders, clearance, crowd.pairs, 20);
  return crowd;
}

Crowd of_a_file() {
  Crowd crowd = rods(40, 0.2);
  crowd.generated.clear();
  crowd.growth.clear();
  crowd.check.reset();
  crowd.file = hostile;
  crowd.cylinders.front().rounding = 0.1 + 0.2;
  crowd.cylinders.front().height = 2.0 / 3;
  crowd.names.assign(crowd.cylinders.size(), hostile);
  return crowd;
}

TEST(CrowdReport, KeepsToItsSchema) {
  if (schema_python().empty()) SKIP_WITHOUT("python3-jsonschema");
  const std::string document = crowd_json(rods(300, 0));
  EXPECT_TRUE(keeps_to("close_pairs.json", document)) << document;
  EXPECT_TRUE(keeps_to("close_pairs.json", crowd_json(of_a_file())));
  const json good = parse_json(document);
  for (const char* planted :
       {R"([{"op":"remove","path":"/solids/0/7"}])",
        R"([{"op":"replace","path":"/nearest/0/certificate","value":"a vote"}])",
        R"([{"op":"remove","path":"/nearest/0/on_a/2"}])", R"([{"op":"remove","path":"/within/0/1"}])",
        R"([{"op":"remove","path":"/growth/0/cpu_ms/tree"}])",
        R"([{"op":"replace","path":"/certificates/failed","value":-1}])",
        R"([{"op":"add","path":"/file","value":"and a file too"}])", R"([{"op":"remove","path":"/seed"}])",
        R"([{"op":"add","path":"/colour","value":"red"}])"})
    EXPECT_FALSE(keeps_to("close_pairs.json", good.patch(parse_json(planted)).dump())) << planted;
}

TEST(CrowdReport, HoldsTheSolidsAndTheNearestPairsToTheBit) {
  const Crowd crowd = of_a_file();
  const json all = parse_json(crowd_json(crowd));
  ASSERT_EQ(all["solids"].size(), crowd.cylinders.size());
  for (std::size_t i = 0; i < crowd.cylinders.size(); ++i) {
    const Cylinder& c = crowd.cylinders[i];
    std::vector<double> expected{c.center[0], c.center[1], c.center[2], c.axis[0],
                                 c.axis[1],   c.axis[2],   c.radius,    c.height};
    if (c.rounding != 0) expected.push_back(c.rounding);
    EXPECT_EQ(all["solids"][i].get<std::vector<double>>(), expected);
  }
  ASSERT_EQ(all["nearest"].size(), crowd.nearest.size());
  for (std::size_t i = 0; i < crowd.nearest.size(); ++i) {
    EXPECT_EQ(all["nearest"][i]["distance"], crowd.nearest[i].distance);
    EXPECT_EQ(all["nearest"][i]["a"], crowd.nearest[i].bodies.first);
    EXPECT_EQ(all["nearest"][i]["on_b"][2], crowd.nearest[i].on_b[2]);
    EXPECT_EQ(all["nearest"][i]["certificate"] == "direction", !crowd.nearest[i].within);
  }
  EXPECT_EQ(all["within"].size(), crowd.pairs.within.size());
}

TEST(CrowdReport, SaysWhatWasAskedAndFound) {
  const Crowd crowd = rods(300, 0);
  const json all = parse_json(crowd_json(crowd));
  EXPECT_EQ(all["generated"], "rods");
  EXPECT_EQ(all["seed"], "3");
  EXPECT_EQ(all["cylinders"], 300);
  EXPECT_EQ(all["candidates"], crowd.pairs.candidates.size());
  EXPECT_EQ(all["growth"][0]["cylinders"], 150);
  EXPECT_EQ(all["growth"][1]["within"], crowd.pairs.within.size());
  EXPECT_EQ(all["verification"]["asked"], all["candidates"]);
  EXPECT_EQ(all["certificates"]["checked"], all["candidates"]);
  EXPECT_EQ(all["certificates"]["failed"], 0);
  EXPECT_FALSE(all.contains("names"));
}

TEST(CrowdReport, LeavesOutTheNumbersOfTooManyCylinders) {
  Crowd crowd = of_a_file();
  crowd.cylinders.resize(crowd_page_cap + 1);
  crowd.names.resize(crowd_page_cap + 1);
  const json all = parse_json(crowd_json(crowd));
  EXPECT_FALSE(all.contains("solids") || all.contains("names"));
  EXPECT_TRUE(all.contains("within"));
}

TEST(CrowdReport, FillsALineForPeople) {
  const ClosePairs pairs = rods(300, 0).pairs;
  EXPECT_EQ(crowd_head().size(), crowd_line(pairs).size());
  ClosePairsCheck check;
  check.referee.asked = 5;
  check.certificates.checked = 4;
  check.certificates.undecided = 1;
  EXPECT_EQ(crowd_check_text(check),
            "referee: 5 pairs asked, 0 wrong, 0 not proved; 0 ms\n"
            "certificates: 4 checked, 0 failed, 1 pairs without one; 0 ms\n");
}

TEST(CrowdReport, PutsNoForeignTextIntoThePageAsMarkup) {
  const std::string page = fill_template(crowd_json(of_a_file()));
  EXPECT_EQ(page.find("<img src=x"), page.npos);
}

}  // namespace
}  // namespace cyl
