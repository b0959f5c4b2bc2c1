// SPDX-License-Identifier: MIT
#include "oracles/trial/offers.hpp"

#include <gtest/gtest.h>

namespace cyl {
namespace {

const Pair apart{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{9, 0, 0}, {0, 0, 1}, 1, 2}};

TEST(Offers, OurCertificateIsOfferedWhoeverIsAsked) {
  const std::vector<std::unique_ptr<Method>> nobody;
  Offers offers(nobody);
  const auto offered = offers.with_ours(apart, {});
  ASSERT_EQ(offered.size(), 1u);
  EXPECT_EQ(offered[0].witness, CertificateKind::direction);
}

TEST(Offers, ItIsNotOfferedTwice) {
  const auto methods = own_methods();
  const std::vector<MethodAnswer> said(methods.size());
  EXPECT_EQ(Offers(methods).with_ours(apart, said).size(), methods.size());
}

}  // namespace
}  // namespace cyl
