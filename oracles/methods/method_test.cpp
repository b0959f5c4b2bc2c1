// SPDX-License-Identifier: MIT
#include "oracles/methods/method.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracles/methods/adapter.hpp"

namespace cyl {
namespace {

TEST(SelectNames, NamesAndPrefixesInTheirOrder) {
  const std::vector<std::string> names{"decide", "fcl-indep", "fcl-libccd", "fcl-libccd-tol1e-10", "fclx"};
  using Indices = std::vector<std::size_t>;
  EXPECT_EQ(select_names(names, "decide"), (Indices{0}));
  EXPECT_EQ(select_names(names, "fcl"), (Indices{1, 2, 3}));
  EXPECT_EQ(select_names(names, "fcl-libccd,decide"), (Indices{0, 2, 3}));
  EXPECT_EQ(select_names(names, "fcl,fcl-indep"), (Indices{1, 2, 3}));
  EXPECT_EQ(select_names(names, "-fcl"), (Indices{0, 4}));
  EXPECT_EQ(select_names({"far", "box", "box_far", "far_box", "far_off"}, "box,far_off,far"),
            (Indices{0, 1, 4}));
  EXPECT_EQ(select_names({"margin_1e-01", "margin", "margins_2"}, "margin"), (Indices{1}));
  EXPECT_EQ(select_names({"margin_1e-01", "margin_1e-02", "margins"}, "margin"), (Indices{0, 1}));
  EXPECT_EQ(select_names(names, "-decide,fclx"), (Indices{1, 2, 3}));
}

TEST(SelectNames, AnUnknownNameIsAnErrorThatListsTheKnown) {
  const std::vector<std::string> names{"decide", "fcl-indep"};
  for (const char* spec : {"", "-", "fc", "fcl-", "decide,", "decide,ode", "-decide,-fcl", "fcl-indep-x"}) {
    try {
      select_names(names, spec);
      ADD_FAILURE() << "'" << spec << "' was accepted";
    } catch (const std::invalid_argument& e) {
      EXPECT_NE(std::string(e.what()).find("decide fcl"), std::string::npos) << e.what();
    }
  }
}

TEST(SelectMethods, KeepsTheMethodsNamed) {
  const auto two = select_methods(all_methods(), "decide,fcl-indep");
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0]->name(), "decide");
  EXPECT_EQ(two[1]->name(), "fcl-indep");
  for (const auto& m : select_methods(all_methods(), "-nlopt,fcl,bullet,libccd,ode,mujoco"))
    EXPECT_FALSE(m->foreign()) << m->name();
}

TEST(SetReason, TruncatesAndTerminates) {
  MethodAnswer answer;
  answer.set_reason(std::string(500, 'x'));
  EXPECT_EQ(std::string(answer.reason), std::string(sizeof answer.reason - 1, 'x'));
  answer.set_reason("short");
  EXPECT_STREQ(answer.reason, "short");
}

TEST(Adapter, RotationTakesZToTheAxis) {
  for (const Vector3& axis :
       {Vector3(0, 0, 1), Vector3(0, 0, -1), Vector3(1, 0, 0), Vector3(-1e-9, 1e-9, -1), Vector3(3, -4, 12),
        Vector3(1e-320, -2e-320, 2e-320), Vector3(1e308, 1e308, -1e308), Vector3(1e-200, 1e200, -0.0)}) {
    const Vector3 u = unit_axis(axis);
    EXPECT_NEAR(u.norm(), 1, 4e-16);
    EXPECT_NEAR(u.dot((axis / axis.cwiseAbs().maxCoeff()).normalized()), 1, 4e-16);
    const Eigen::Matrix3d m = rotation_to(u);
    EXPECT_EQ(Vector3(m.col(2)), u);
    EXPECT_LE((m.transpose() * m - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_NEAR(m.determinant(), 1, 1e-15);
  }
}

// By hand: the rotation of (1, 2, 3, 4), whose square is 30.
TEST(Adapter, RotationOfABoxIsThatOfItsQuaternion) {
  Eigen::Matrix3d by_hand;
  by_hand << -10, 2, 11, 10, -5, 10, 5, 14, 2;
  by_hand /= 15;
  for (const double length : {1e-200, 1.0, 1e200}) {
    const Solid box{.shape = Shape::box, .quaternion = {length, 2 * length, 3 * length, 4 * length}};
    EXPECT_LE((rotation_of(box) - by_hand).cwiseAbs().maxCoeff(), 0x1p-50) << length;
  }
  const Solid rod{.axis = {0, 3, 4}};
  EXPECT_EQ(rotation_of(rod), rotation_to(unit_axis(rod.axis)));
}

TEST(Adapter, EdgesAreRoundedInwards) {
  const Solid box{.shape = Shape::box, .edges = {1, 2, 3}};
  const Solid rounded = with_rounded_rims(box, 0.25);
  EXPECT_EQ(rounded.edges, (std::array{0.5, 1.5, 2.5}));
  EXPECT_EQ(rounded.rounding, 0.25);
  EXPECT_EQ(with_rounded_rims(box, 0.75).edges, box.edges) << "too thin";
  EXPECT_EQ(with_rounded_rims(rounded, 0.125).rounding, 0.25) << "rounded already";
}

}  // namespace
}  // namespace cyl
