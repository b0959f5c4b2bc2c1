// SPDX-License-Identifier: MIT
// The errata of the text of 2008 and of the page of the book.
#include "oracles/methods/errata.hpp"

namespace cyl {
namespace {

using literature::Fault;
using enum Document;
using enum ErratumKind;

// Symbols as in errata_2017.cpp.
constexpr Erratum table[] = {
    {.id = "2008-wall-alone",
     .document = text_2008,
     .kind = gap,
     .place = "section 3",
     .says = "The projections of a cylinder onto a line or plane are determined solely by its wall; the end "
             "disks are not relevant.",
     .should = "The projections onto a line. To a plane the end disks project too.",
     .why = "Seen along the axis the wall is a circle, and the cylinder a disk; a short wall at a slant "
            "leaves a hole in the middle. Section 5 has the regions right, a disk, a rectangle, and a "
            "rectangle with two caps, so no verdict changes. The text of 2017 speaks of a line alone.",
     .shown_by = ShownBy::none,
     .test = "PlaneProjection2008.TheWallAloneLeavesAHole"},
    {.id = "2008-radius",
     .document = text_2008,
     .kind = error,
     .place = "section 7, f(W0) < 0 and f(W1) < 0 without a root",
     .says = "r1 |W0 x W1|^2 < rho^2.",
     .should = "r1^2 |W0 x W1|^2 < rho^2.",
     .why = "Both sides of r1 |W0 x W1| < rho are squared. As printed the answer depends on the unit of "
            "length.",
     .shown_by = ShownBy::alone,
     .fault = Fault::radius_not_squared,
     .rate = "Wrong of 3000 pairs a family: random 234, touching_cap_rim 1367, touching_cap_side 1220, "
             "mixed_scale 778, disks 447, close_rims 374; 18 families more.",
     .numbers = "Along W0, rho = 3/2: printed 2 < 9/4 is true, right 4 < 9/4 is false."},
    {.id = "2008-parallel-distance",
     .document = text_2008,
     .kind = rounding,
     .place = "section 7, parallel axes",
     .says = "The squared distance of the axes is |Delta|^2 - (W0.Delta)^2.",
     .should = "|Delta x W0|^2.",
     .why = "The same number in exact arithmetic. In doubles the difference cancels if the solids are far "
            "apart along the axes and near each other across.",
     .shown_by = ShownBy::alone,
     .fault = Fault::cancelling_distance,
     .rate = "On none of 3000 pairs a family; it takes parallel axes 2^26 times as far apart along them as "
             "across.",
     .numbers = "10^18 + 9 - 10^18 is 0 in doubles, 9 > 4 exactly."},
    {.id = "2008-derivative",
     .document = text_2008,
     .kind = error,
     .place = "section 8, G'(x)",
     .says = "The last term is -sigma2 b2.",
     .should = "-sigma2 a2.",
     .why = "It is the derivative of -sigma2 (a2 x + b2).",
     .shown_by = ShownBy::alone,
     .fault = Fault::derivative_of_the_wrong_term,
     .rate = "Wrong of 3000 pairs a family: random 11, touching_side_rim 1259, needle_and_disk 138, "
             "close_contacts 127, close_contacts_by_angle 65, close_rims 37; 9 families more.",
     .numbers = "f(D) = -0.594 at D = (-0.368, 0.657, -0.657), around W0. With V0 along the projection of "
                "Delta a2 is 0, and b2 is 4.24."},
    {.id = "2008-tangent-line",
     .document = text_2008,
     .kind = gap,
     .place = "section 8, D(x) = x U0 + V0",
     .says = "The tangent line stands for the half circle, with any U0 and V0.",
     .should = "V0 along the projection of Delta, and V0 is tested itself.",
     .why = "The line never is U0. If f(U0) < 0, F falls for ever and has no critical point; if f(U0) = 0, "
            "it may fall for ever to a negative value, and to test U0 too does not help. With U0 square to "
            "Delta neither can be. Then G' may still be 0 all along the line, as between segments in one "
            "plane: its polynomial is 0 and has no roots to be computed, and any point of the line will do.",
     .shown_by = ShownBy::alone,
     .fault = Fault::tangent_line_misses_u0,
     .rate = "Wrong of 3000 pairs a family: random 39, axes_nearly_parallel 225, needle_and_disk 89, "
             "lattice 68, points 66, lattice_dust 58; 12 families more.",
     .numbers = "f(D) = -0.707 at D = (0, 0.707, -0.707), along the projection of Delta, around W1. F falls "
                "for ever on any other line."},
    {.id = "2008-vanished-term",
     .document = text_2008,
     .kind = gap,
     .place = "section 8, after G'(x)",
     .says = "|A0 x + B0| = 0 where D is parallel to W0 x W1.",
     .should = "Where D is parallel to W1, which happens for perpendicular axes alone.",
     .why = "A0 x + B0 is P_1 D, which vanishes on W1. Section 7 has tested W1 too, so no verdict changes.",
     .shown_by = ShownBy::none,
     .test = "Separation2008.VanishingTermIsTheOtherAxis"},
    {.id = "2008-disk-distance",
     .document = text_2008,
     .kind = gap,
     .place = "section 8, the second projection is a disk",
     .says = "The distance of C_0 to it, to be compared with r0, is the length of the projection of Delta.",
     .should = "That length less r1.",
     .why = "The distance of a point to a disk is that to its centre less the radius. The second "
            "projection is a disk only for parallel axes, which section 7 has settled, so no verdict "
            "changes.",
     .shown_by = ShownBy::none,
     .test = "PlaneProjection2008.ADiskIsNearerThanItsCentre"},
    {.id = "2008-negated-pair",
     .document = text_2008,
     .kind = error,
     .place = "section 10, steps 2 to 4",
     .says = "(-eta0, -eta1) leads to the same equations as (eta0, eta1) and can be ignored; both eta_i . "
             "A_i^T R xi must be positive. For g1 the first three steps are identical.",
     .should = "Both must have one sign, either. Or, for g1, step 3 is solved anew with xi = (x, y, -1), "
               "which changes the sign of d.",
     .why = "The two pairs have one and the same xi, and opposite signs there: of a critical point at "
            "which the pair that was kept has two negative signs, nothing is left. Which ones are lost "
            "depends on the signs of the eigenvectors and on the frames, which the text leaves open; this "
            "pair shows it with V_i along W0 x W1. Solved anew, g1 has -xi, at which the signs are "
            "positive.",
     .shown_by = ShownBy::alone,
     .fault = Fault::negated_pair_ignored,
     .rate = "Wrong of 3000 pairs a family: touching_rim_rim 698, touching_disks 686, close_rims 300, "
             "coins_edge_to_edge 62, close_contacts 32; 8 families more.",
     .numbers =
         "f(D) = -0.151 at D = (0.205, 0.768, 0.607). The method keeps the pair that has two negative "
         "signs there. With the second axis turned round it keeps the negated one, and says 'disjoint'.",
     .test = "Separation2008.CriticalPointsComeWithEitherSign"},
    {.id = "2008-step-4",
     .document = text_2008,
     .kind = remark,
     .place = "section 10, step 4",
     .says = "The second condition ends after W_1 . R xi.",
     .should = "W_1 . R xi >= 0.",
     .why = "Unfinished. D.Delta >= 0, which is not asked, follows from the others: D.Delta = D.phi + "
            "(h0/2) D.W_0 + (h1/2) D.W_1 and D.phi > 0. No verdict changes.",
     .shown_by = ShownBy::none,
     .test = "Separation2008.ThirdInequalityFollows"},
    {.id = "2008-sign-of-p0",
     .document = text_2008,
     .kind = trap,
     .place = "section 11, P_0 = r0 det(B0) eta_0",
     .says = "P_0 and P_1 are vectors for the extraction of (x, y), which needs no unit length.",
     .should = "As it stands. A warning would help: P_0 points against eta_0 if det(B0) < 0, so step 4 of "
               "section 10 needs -P_0 for eta_0 then.",
     .why = "The text is right: for the extraction the sign does not matter. A program that goes on to "
            "step 4 with P_0 accepts the wrong points and rejects the right ones. `seed2008-printed` does "
            "not do that.",
     .shown_by = ShownBy::alone,
     .fault = Fault::sign_of_p0,
     .rate = "Wrong of 3000 pairs a family: random 1, touching_rim_rim 680, touching_disks 680, close_rims "
             "278, coins_edge_to_edge 42, close_contacts 32; 9 families more.",
     .numbers =
         "f(D) = -0.229 at D = (-0.081, -0.614, -0.785), with det(B0) = -0.295: eta_0 . A_0^T D > 0 and "
         "P_0 . A_0^T D < 0."},
    {.id = "2008-b-squared",
     .document = text_2008,
     .kind = error,
     .place = "section 11, b^2",
     .says = "b^2 = (r1^2 - e0 r0^2 det(B0)^2)/(e1 - e0).",
     .should = "b^2 = (r0^2 det(B0)^2 - e0 r1^2)/(e1 - e0).",
     .why = "It solves a^2 + b^2 = r1^2 and e0 a^2 + e1 b^2 = r0^2 det(B0)^2.",
     .shown_by = ShownBy::alone,
     .fault = Fault::wrong_b_squared,
     .rate = "Wrong of 3000 pairs a family: random 1, touching_rim_rim 1383, touching_disks 1350, "
             "close_rims 531, coins_edge_to_edge 116, close_contacts 61; 9 families more.",
     .numbers = "f(D) = -0.151 at D = (0.205, 0.768, -0.607), with r1^2 = 1 and a^2 = 0.970. b^2 is 0.030 "
                "there, as printed 1.406."},
    {.id = "2008-equal-eigenvalues",
     .document = text_2008,
     .kind = gap,
     .place = "section 11, e0 = e1",
     .says = "a^2 and b^2 are divided by e1 - e0, also if that is 0.",
     .should = "If e0 = e1: no isolated critical point.",
     .why = "C^T C is a multiple of the identity only if W is along a bisector of the axes. Then, if r0 = "
            "r1, g0 is least at W and on the whole arc from W0 to W1, whose ends section 7 tests, or which "
            "leaves the region of its signs where section 8 looks. If r0 != r1, there is no critical "
            "point. Not-a-number fails every test, so no verdict changes.",
     .shown_by = ShownBy::none,
     .fault = Fault::equal_eigenvalues,
     .test = "Separation2008.EqualEigenvalues"},
    {.id = "2008-slips",
     .document = text_2008,
     .kind = remark,
     .place = "sections 2.2, 5, 6 and 9 to 12",
     .says = "(a) Regions of a plane are projected onto a line, twice (2.2). (b) Y = P(X - C +- (h/2) W), "
             "three times (5). (c) f(tD) < 0 for any t (6, 9). (d) Eight functions g are looked at (9). (e) "
             "Step 2 refers to step 4 for the extraction of (x, y) (10). (f) eta_0 is divided by r0, also "
             "if that is 0 (11). (g) The right side of the two equations is defined as D (12). (h) The "
             "vector A_i^T R xi is a number, twice (12).",
     .should = "(a) Onto the plane. (b) -+ for +-. (c) For any t != 0. (d) Four will do, as g1(D) = g0(-D). "
               "(e) Step 3. (f) If r0 = 0 and both determinants are not 0, there is no solution. (g) d. (h) "
               "Times eta_i.",
     .why = "What is meant is clear, and everything here does that, so no verdict changes.",
     .shown_by = ShownBy::none,
     .test = "PlaneProjection2008.IsTheProjection"},

    {.id = "book-sign-of-p0",
     .document = book,
     .kind = trap,
     .place = "the formula of p_0",
     .says = "p_0 = r0 det(B0) eta_0 and p_1 stand for eta_0 and eta_1 in the extraction of (x, y), which "
             "needs no unit length.",
     .should = "As it stands. A warning would help: p_0 points against eta_0 if det(B0) < 0.",
     .why = "As in section 11 of the text of 2008. The conditions on signs are on no page that is at hand.",
     .shown_by = ShownBy::alone,
     .fault = Fault::sign_of_p0,
     .rate = "Wrong of 3000 pairs a family: random 1, touching_rim_rim 680, touching_disks 680, close_rims "
             "277, coins_edge_to_edge 39, close_contacts 32; 9 families more.",
     .numbers = "As in the text of 2008."},
    {.id = "book-b-squared",
     .document = book,
     .kind = error,
     .place = "the formula of b^2",
     .says = "b^2 = (r1^2 - e0 r0^2 det(B0)^2)/(e1 - e0).",
     .should = "b^2 = (r0^2 det(B0)^2 - e0 r1^2)/(e1 - e0).",
     .why = "As in section 11 of the text of 2008.",
     .shown_by = ShownBy::alone,
     .fault = Fault::wrong_b_squared,
     .rate = "Wrong of 3000 pairs a family: random 1, touching_rim_rim 1383, touching_disks 1350, "
             "close_rims 529, coins_edge_to_edge 110, close_contacts 61; 9 families more.",
     .numbers = "As in the text of 2008."},
    {.id = "book-equal-eigenvalues",
     .document = book,
     .kind = gap,
     .place = "the formulas of a^2 and b^2",
     .says = "a^2 and b^2 are divided by e1 - e0, also if that is 0.",
     .should = "If e0 = e1: no isolated critical point.",
     .why = "As in section 11 of the text of 2008: no verdict changes.",
     .shown_by = ShownBy::none,
     .fault = Fault::equal_eigenvalues,
     .test = "Separation2008.EqualEigenvalues"},
};

}  // namespace

std::span<const Erratum> errata_2008() { return table; }

}  // namespace cyl
