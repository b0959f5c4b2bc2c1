// SPDX-License-Identifier: MIT
#include "props/mutants/kill_matrix.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

namespace cyl {
namespace {

int selected = 0;
void select(int number) noexcept { selected = number; }

Detection detect(std::string (*betrayal)(const Mutant&)) {
  const Mutant mutant{7, "", "", "", "", "", ""};
  const Detector detector{"planted", betrayal};
  return run_detectors(mutant, {&detector, 1}, select).detections.at(0);
}

TEST(KillMatrix, TellsApartWhatBecameOfAChild) {
  EXPECT_EQ(detect([](const Mutant&) { return std::string(); }).fate, Fate::survived);
  EXPECT_EQ(detect([](const Mutant&) { return std::string("seen"); }).fate, Fate::killed);
  EXPECT_EQ(detect([](const Mutant&) -> std::string { throw std::runtime_error("bad"); }).fate, Fate::killed);
  EXPECT_EQ(detect([](const Mutant&) -> std::string { std::abort(); }).fate, Fate::crashed);
  EXPECT_EQ(detect([](const Mutant&) -> std::string { raise(SIGXCPU), pause(), _exit(0); }).fate, Fate::hung);
  EXPECT_EQ(detect([](const Mutant&) -> std::string { raise(SIGALRM), pause(), _exit(0); }).fate, Fate::hung);
  EXPECT_EQ(detect([](const Mutant&) -> std::string { _exit(3); }).fate, Fate::killed);
}

TEST(KillMatrix, KeepsWhatGaveTheMutantAway) {
  EXPECT_EQ(detect([](const Mutant&) { return std::string("law 1"); }).what, "law 1");
  EXPECT_EQ(detect([](const Mutant&) { return std::string(1 << 20, 'x'); }).what.size(), 4096u);
}

TEST(KillMatrix, SelectsTheMutantInTheChildAlone) {
  EXPECT_EQ(detect([](const Mutant&) { return std::to_string(selected); }).what, "7");
  EXPECT_EQ(selected, 0);
}

TEST(KillMatrix, OneFateOtherThanSurvivalIsAKill) {
  KillRow row{{}, {{}, {}}};
  EXPECT_FALSE(row.killed());
  row.detections[1].fate = Fate::hung;
  EXPECT_TRUE(row.killed());
}

}  // namespace
}  // namespace cyl
