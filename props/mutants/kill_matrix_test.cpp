// SPDX-License-Identifier: MIT
#include "props/mutants/kill_matrix.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>

#include "base/json.hpp"
#include "props/mutants/kill_data.hpp"

namespace cyl {
namespace {

int selected = 0;
void select(int number) noexcept { selected = number; }

Detection detect(std::string (*find)(const Mutant&)) {
  const Mutant mutant{7, "", "", "", "", "", ""};
  const Detector detector{"planted", find};
  return run_detectors(mutant, {&detector, 1}, select).detections.at(0);
}

TEST(KillMatrix, TellsApartWhatBecameOfAChild) {
  EXPECT_EQ(detect([](const Mutant&) { return std::string(); }).outcome, Detection::Outcome::survived);
  EXPECT_EQ(detect([](const Mutant&) { return std::string("seen"); }).outcome, Detection::Outcome::killed);
  EXPECT_EQ(detect([](const Mutant&) -> std::string { throw std::runtime_error("bad"); }).outcome,
            Detection::Outcome::killed);
  EXPECT_EQ(detect([](const Mutant&) -> std::string { std::abort(); }).outcome, Detection::Outcome::crashed);
  EXPECT_EQ(detect([](const Mutant&) -> std::string { raise(SIGXCPU), pause(), _exit(0); }).outcome,
            Detection::Outcome::hung);
  EXPECT_EQ(detect([](const Mutant&) -> std::string { raise(SIGALRM), pause(), _exit(0); }).outcome,
            Detection::Outcome::hung);
  EXPECT_EQ(detect([](const Mutant&) -> std::string { _exit(3); }).outcome, Detection::Outcome::killed);
}

TEST(KillMatrix, KeepsWhatGaveTheMutantAway) {
  EXPECT_EQ(detect([](const Mutant&) { return std::string("law 1"); }).evidence.failure_message, "law 1");
  EXPECT_EQ(detect([](const Mutant&) { return std::string(1 << 20, 'x'); }).evidence.failure_message.size(),
            4096u);
}

TEST(KillMatrix, SelectsTheMutantInTheChildAlone) {
  EXPECT_EQ(detect([](const Mutant&) { return std::to_string(selected); }).evidence.failure_message, "7");
  EXPECT_EQ(selected, 0);
}

TEST(KillMatrix, OneOutcomeOtherThanSurvivalIsAKill) {
  KillRow row{{}, {{}, {}}};
  EXPECT_FALSE(row.killed());
  row.detections[1].outcome = Detection::Outcome::hung;
  EXPECT_TRUE(row.killed());
}

TEST(KillData, HasARowForEachFault) {
  std::set<int> rows, faults;
  const auto numbers_of = [](const char* file, const char* key, std::set<int>& numbers) {
    std::ifstream in(std::string(DAYLIGHT_SOURCE_DIR "/props/mutants/") + file);
    for (std::string line; std::getline(in, line);) numbers.insert(parse_json(line).at(key).get<int>());
  };
  numbers_of("mutants.jsonl", "number", faults);
  numbers_of("kill_matrix.jsonl", "mutant", rows);
  EXPECT_GT(faults.size(), 200u);
  EXPECT_EQ(rows, faults) << "run daylight mutants matrix --only NUMBER --json FILE, and add the row";
}

TEST(KillData, NamesTheFaultsThatCampaignsSoonFindWithTheMethodsAsked) {
  const auto rows = read_kill_matrix(DAYLIGHT_SOURCE_DIR "/props/mutants/kill_matrix.jsonl");
  const auto own = own_methods();
  // With too few faults, a campaign's faults could be guessed. Then measure the column again: daylight
  // mutants matrix --detectors fuzz.
  EXPECT_GE(faults_soon_found(rows, own).size(), 40u);
  EXPECT_TRUE(faults_soon_found(rows, std::span(own).first(1)).empty());
  EXPECT_GE(faults_soon_found(rows, all_methods()).size(), faults_soon_found(rows, own).size());
  EXPECT_THROW(read_kill_matrix("/nowhere"), std::runtime_error);
}

}  // namespace
}  // namespace cyl
