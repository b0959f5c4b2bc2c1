// SPDX-License-Identifier: MIT
#include "oracles/trial/trial.hpp"

#include <gtest/gtest.h>

namespace cyl {
namespace {

Pair upright_pair(double apart) {
  return {{Vector3(0, 0, 0), Vector3(0, 0, 1), 1, 2}, {Vector3(apart, 0, 0), Vector3(0, 0, 1), 1, 2}};
}

TEST(Proofs, OffersWitnessesOfItsOwnPairAlone) {
  const Pair own = upright_pair(3), other = upright_pair(4);
  MethodAnswer answer = answered(Verdict::disjoint);
  answer.set_direction(Vector3(1, 0, 0));
  Proofs proofs(own, {&answer, 1});
  EXPECT_TRUE(proofs.of(own).truth.witnessed);
  EXPECT_FALSE(proofs.of(other).truth.witnessed);
}

TEST(Proofs, ReachAClaimOrNot) {
  const Pair pair = upright_pair(3);  // a gap of 1, size 6
  Proofs proofs(pair, {});
  EXPECT_TRUE(beyond_claim(proofs.of(pair), {.relative = 1e-13, .source = "the test"}));
  EXPECT_TRUE(beyond_claim(proofs.of(pair), {.absolute = 0.99, .source = "the test"}));
  EXPECT_FALSE(beyond_claim(proofs.of(pair), {.relative = 0.5, .source = "the test"}));
}

TEST(WitnessSet, OurCertificateIsOfferedWhoeverIsAsked) {
  const std::vector<std::unique_ptr<Method>> nobody;
  WitnessSet offers(nobody);
  const auto offered = offers.with_own_witness(upright_pair(9), {});
  ASSERT_EQ(offered.size(), 1u);
  EXPECT_EQ(offered[0].witness, CertificateKind::direction);
}

TEST(WitnessSet, ItIsNotOfferedTwice) {
  const auto methods = own_methods();
  const std::vector<MethodAnswer> said(methods.size());
  EXPECT_EQ(WitnessSet(methods).with_own_witness(upright_pair(9), said).size(), methods.size());
}

}  // namespace
}  // namespace cyl
