// SPDX-License-Identifier: MIT
#include "oracles/trial/witness_set.hpp"

#include <gtest/gtest.h>

namespace cyl {
namespace {

const Pair apart{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{9, 0, 0}, {0, 0, 1}, 1, 2}};

TEST(WitnessSet, OurCertificateIsOfferedWhoeverIsAsked) {
  const std::vector<std::unique_ptr<Method>> nobody;
  WitnessSet offers(nobody);
  const auto offered = offers.with_own_witness(apart, {});
  ASSERT_EQ(offered.size(), 1u);
  EXPECT_EQ(offered[0].witness, CertificateKind::direction);
}

TEST(WitnessSet, ItIsNotOfferedTwice) {
  const auto methods = own_methods();
  const std::vector<MethodAnswer> said(methods.size());
  EXPECT_EQ(WitnessSet(methods).with_own_witness(apart, said).size(), methods.size());
}

}  // namespace
}  // namespace cyl
