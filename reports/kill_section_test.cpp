// SPDX-License-Identifier: MIT
#include "reports/kill_section.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

namespace cyl {
namespace {

class KillSection : public testing::Test {
 protected:
  void TearDown() override { std::remove(file_.c_str()); }
  std::string of(const std::string& rows) {
    std::ofstream(file_) << rows;
    return kill_section(file_);
  }
  const std::string file_ = testing::TempDir() + "kills-" + std::to_string(getpid()) + ".jsonl";
};

constexpr const char* rows =
    R"({"mutant":0,"file":"","what":"the program as it is","like":"","laws":{"fate":"survived","seconds":5,"what":""}}
{"mutant":101,"file":"solver/sections.hpp","what":"a < b","like":"sign","laws":{"fate":"killed","seconds":1.25,"what":"x"},"gate":{"fate":"survived","seconds":4,"what":""}}
{"mutant":102,"file":"solver/decide.cpp","what":"none","like":"sign","equivalent":"by <law>","laws":{"fate":"survived","seconds":5,"what":""}}
{"mutant":601,"file":"oracles/search.hpp","what":"missed","like":"sign","laws":{"fate":"survived","seconds":5,"what":""}}
)";

TEST_F(KillSection, CountsByPartAndTellsEachFault) {
  const std::string html = of(rows);
  EXPECT_NE(html.find("<td>solver</td><td>2</td><td>1</td><td>1</td><td>0</td><td>1</td>"),
            std::string::npos);
  EXPECT_NE(html.find("<td>referee</td><td>1</td><td>0</td><td>0</td><td>1</td><td>0</td>"),
            std::string::npos);
  EXPECT_NE(html.find("<td>all</td><td>3</td><td>1</td><td>1</td><td>1</td>"), std::string::npos);
  EXPECT_NE(html.find("a &lt; b</td><td>1.2 s</td><td></td><td></td><td></td><td>no</td><td></td>"),
            std::string::npos)
      << html;
  EXPECT_NE(html.find("equivalent: by &lt;law&gt;"), std::string::npos);
  EXPECT_EQ(html.find("as it is"), std::string::npos);
}

TEST_F(KillSection, IsEmptyWithoutAMatrixAndRefusesAnythingElse) {
  EXPECT_EQ(kill_section(file_), "");
  EXPECT_THROW(of("no rows\n"), std::runtime_error);
  EXPECT_THROW(of("{}\n"), std::runtime_error);
  EXPECT_THROW(of(""), std::runtime_error);
}

}  // namespace
}  // namespace cyl
