// SPDX-License-Identifier: MIT
// The errata of the text of 2017.
#include "oracles/methods/errata.hpp"

namespace cyl {
namespace {

using literature::Fault;
using enum Document;
using enum ErratumKind;

// r_i, h_i: radii and (whole) heights; W_i: unit axes; D: a direction; Delta: from the first centre to the
// second; f(D) < 0: the line along D separates.
constexpr Erratum table[] = {
    {.id = "2017-coincident-centers",
     .document = text_2017,
     .kind = gap,
     .place = "sections 4 and 8",
     .says = "Delta != 0 is assumed, and nothing tests it.",
     .should = "If Delta = 0, leave out section 7, which has no W then.",
     .why = "W = Delta/|Delta| is not-a-number, and so is every G: section 7 finds nothing. Sections 5 and "
            "6 answer before, and rightly: 'not separated', unless neither solid has an inside. Two "
            "segments, or two disks of height 0 in one plane, only touch, and f(D) = 0 for a D that "
            "section 5 or 6 tests, which section 3.1 counts as separation. No verdict changes.",
     .shown_by = ShownBy::none,
     .fault = Fault::coincident_centers},
    {.id = "2017-mixed-strictness",
     .document = text_2017,
     .kind = error,
     .place = "sections 1, 3.1 to 6 and 8",
     .says = "Section 3.1 lets equality count as separation; sections 4, 5 and 6 have f(D) <= 0, and so "
             "have the functions of section 8 that search. SeparatedCylinders in section 8 has < 0 for W0, "
             "W1, W0 x W1 and for parallel axes. In section 1 two capsules intersect if the distance of "
             "their segments equals the sum of the radii.",
     .should = "<= 0 in SeparatedCylinders. Or < 0 in all functions, for anyone who wants what only touches "
               "to intersect, as in section 1.",
     .why = "Of solids that only touch, the answer depends on the test that sees it: one on top of the "
            "other they are 'not separated', side by side at an angle they are 'separated'.",
     .shown_by = ShownBy::alone,
     .fault = Fault::mixed_strictness,
     .rate = "Only on pairs that touch exactly, if parallel axes or a plane square to an axis decide.",
     .numbers = "h0/2 + h1/2 - |W0.Delta| = 0: < 0 is false, <= 0 is true."},
    {.id = "2017-kink-of-equation-9",
     .document = text_2017,
     .kind = remark,
     .place = "section 6, the warning after Equation (10)",
     .says = "F' and F'' jump where Sign((1-t) a2 + b2) = 0.",
     .should = "Sign((1-t) a2 + t b2) = 0.",
     .why = "A t is missing. Equations (8) and (9) and the code have it, so no verdict changes.",
     .shown_by = ShownBy::none,
     .test = "Quarter2017.TheKinkIsWhereDeltaIsSquareToD"},
    {.id = "2017-equation-10",
     .document = text_2017,
     .kind = remark,
     .place = "section 6, Equation (10)",
     .says = "The first term of F'' is 3 r0/((1-t)^2 + t^2)^(3/2).",
     .should = "r0/((1-t)^2 + t^2)^(3/2).",
     .why = "sqrt(q) with q = (1-t)^2 + t^2 has the second derivative 1/q^(3/2). No step of the method "
            "uses F'', so no verdict changes.",
     .shown_by = ShownBy::none,
     .test = "Quarter2017.TheCoefficientOfEquation10IsOne"},
    {.id = "2017-strictly-convex",
     .document = text_2017,
     .kind = gap,
     .place = "section 6, after Equation (10)",
     .says = "F is strictly convex; so F(0) is the least if F'(0) >= 0, and F(1) if F'(1) <= 0.",
     .should =
         "F is convex on either side of the kink of its last term; if F(0) > 0 and F(1) > 0, F > 0 on a "
         "quarter with a kink.",
     .why = "-|x| is concave, so F has a peak where (1-t) a2 + t b2 changes its sign. At a2 = 0 Sign is 0, "
            "and (9) is not the slope: with r0 = r1 = 1, h1 b1/2 = 3, c1^2 = 1/4 and b2 = 4 it gives F'(0) "
            "= 1, the slope is -3, F(0) = 2, F(1) = 1/2, and the least is 0.46. No verdict changes: |P_i "
            "D(t)| is at least (1-t) |P_i U0| and at least t |P_i V0|, so with a2 >= 0 >= b2, F(t) >= "
            "(1-t) F(0) before the kink and F(t) >= t F(1) behind it; with a2 = 0, F(t) >= t F(1) for "
            "either sign of b2. Both ends are tested.",
     .shown_by = ShownBy::none,
     .fault = Fault::kink_taken_for_convex,
     .test = "Quarter2017.AKinkHidesNoSeparation"},
    {.id = "2017-first-quarter",
     .document = text_2017,
     .kind = error,
     .place = "section 8, SeparatedByCylinderPerpendiculars",
     .says = "If F'(0) >= 0 or F'(1) <= 0 on the first quarter circle, false is returned.",
     .should = "Go on to the second quarter circle, from -U0 to V0, as section 6 does.",
     .why = "The slopes of one quarter say nothing of the other. (Section 6 has 'there is no separation' "
            "there, of the line segment in hand, and goes on to the other one.) Alone it costs nothing "
            "once section 7 is put right, which looks at every direction, perpendicular ones among them; "
            "in the printed method it does.",
     .shown_by = ShownBy::taken_out,
     .fault = Fault::first_quarter_ends_all,
     .rate = "Wrong of 3000 pairs a family: random 8, touching_side_rim 643, mixed_scale 218, "
             "close_contacts 82, close_rims 81, close_contacts_by_angle 64; 13 families more.",
     .numbers =
         "Around either axis F(0) = 0.268 and F'(0) > 0 on the first quarter. On the second, F falls to "
         "-0.119 and -0.075."},
    {.id = "2017-no-return",
     .document = text_2017,
     .kind = remark,
     .place = "section 8, the end of SeparatedByCylinderPerpendiculars",
     .says = "The function ends without a return.",
     .should = "return false.",
     .why = "What is meant is clear, and everything here does that, so no verdict changes.",
     .shown_by = ShownBy::none},
    {.id = "2017-vanished-root",
     .document = text_2017,
     .kind = gap,
     .place = "section 6, Equation (9), at t = 1 of perpendicular axes; section 7, the gradient of G at D = "
              "W_i",
     .says = "The derivative of r |P_i D| is divided by |P_i D|, also where that is 0.",
     .should = "The one-sided slope -r1 in Equation (9); in section 7 any subgradient, such as 0, and one "
               "more line searched from there.",
     .why = "0/0 is not-a-number. It turns no comparison the wrong way, but it ends a search on the spot.",
     .shown_by = ShownBy::alone,
     .fault = Fault::division_by_vanished_root,
     .rate = "On none of 3000 pairs a family.",
     .numbers =
         "f(D) = -0.117 at D = (0.898, -0.357, 0.256). With 0/0 the search ends before it gets there."},
    {.id = "2017-cancelling-sine",
     .document = text_2017,
     .kind = rounding,
     .place = "section 8, SeparatedByCylinderPerpendiculars",
     .says = "b1 = sqrt(1 - c1^2) and V0 = (W1 - c1 W0)/b1.",
     .should = "b1 = |W0 x W1|, U0 = -(W0 x W1)/b1, V0 = W0 x U0, with W0 x W1 as (W0 - W1) x (W0 + W1)/2, "
               "one axis turned round if need be.",
     .why = "Right in exact arithmetic. In doubles 1 - c1^2 cancels between axes that are nearly parallel: "
            "at angles of 1e-8 and below b1 is 0, 1.5e-8 or not-a-number. Once section 7 is put right, "
            "which does not use b1, no separation is missed for it; but F may come out <= 0 for solids "
            "that intersect.",
     .shown_by = ShownBy::taken_out,
     .fault = Fault::cancelling_sine,
     .rate = "Wrong of 3000 pairs a family: close_rods 312, close_contacts_by_angle 114, close_contacts 76, "
             "axes_nearly_parallel 53, close_rims 40; 2 families more.",
     .numbers = "b1 is 1e-8. In doubles sqrt(1 - c1^2) is 0."},
    {.id = "2017-one-octant",
     .document = text_2017,
     .kind = error,
     .place = "section 8, SeparatedByOtherDirections",
     .says = "G is minimised for s, t >= 0 and s + t <= 1.",
     .should = "Likewise with (-U, V), (-U, -V) and (U, -V) in the place of (U, V), as section 7 says.",
     .why = "That is one octant of the four that the hemisphere consists of. Section 7 names the octants "
            "and writes out the first, as an example; a program that follows section 8 has that one alone.",
     .shown_by = ShownBy::alone,
     .fault = Fault::one_octant,
     .rate = "Wrong of 3000 pairs a family: random 1, touching_disks 1028, touching_rim_rim 935, close_rims "
             "403, coins_edge_to_edge 64, close_contacts 44; 9 families more.",
     .numbers = "With the U and V of the method G is at least 0.157 in the first octant, and falls to -1.32, "
                "-2.29 and -1.92 in the others."},
    {.id = "2017-cancelling-root",
     .document = text_2017,
     .kind = rounding,
     .place = "section 7, Q_i; section 8, G and GDer",
     .says = "|P_i D| = sqrt(|D|^2 - (D.W_i)^2).",
     .should = "|P_i D| = |D x W_i|.",
     .why = "Right in exact arithmetic. In doubles the difference has lost half of its digits next to W_i, "
            "and the slope of G with them.",
     .shown_by = ShownBy::taken_out,
     .fault = Fault::cancelling_root,
     .rate = "Wrong of 3000 pairs a family: touching_cap_rim 55, mixed_scale 35, touching_cap_side 17, "
             "close_contacts_by_angle 16, close_contacts 13; 6 families more.",
     .numbers = "G falls to -1.73 in the first octant. With the printed roots the search stops above 0."},
    {.id = "2017-kinks",
     .document = text_2017,
     .kind = remark,
     .place = "sections 7 and 8",
     .says = "The derivatives of G jump where Sign(L_i) = 0; G is convex, and numerical minimizers tend to "
             "perform quite well for convex functions.",
     .should = "As it stands. Advice: minimise G in each of the cells into which the lines D.W_0 = 0 and "
               "D.W_1 = 0 cut the triangle, with the signs of D.W_i that hold there.",
     .why = "On those lines conjugate gradients and Powell's line searches can get stuck above the minimum.",
     .shown_by = ShownBy::taken_out,
     .fault = Fault::kinks_taken_for_smooth,
     .rate = "Wrong of 3000 pairs a family: touching_side_rim 146, mixed_scale 69, close_contacts 24, "
             "close_contacts_by_angle 19, touching_rim_rim 17; 10 families more.",
     .numbers =
         "In the first octant G falls to -0.537, on the side t = 0. Conjugate gradients that cross the "
         "kinks stop above 0."},
    {.id = "2017-boundary",
     .document = text_2017,
     .kind = error,
     .place = "section 8, after SeparatedByOtherDirections",
     .says = "Once a line search ends on the boundary of the triangle, the minimum is on the boundary; a "
             "minimum inside never leads there.",
     .should = "Search the boundary first, and start from its lowest point.",
     .why = "The first line from anywhere may end on the boundary. From the lowest point of the boundary "
            "none does, as G is not lower anywhere on it.",
     .shown_by = ShownBy::alone,
     .fault = Fault::stays_on_the_boundary,
     .rate = "Wrong of 3000 pairs a family: touching_rim_rim 142, close_rims 110, touching_disks 22, "
             "close_contacts 22, coins_edge_to_edge 21; 1 family more.",
     .numbers = "G falls to -0.0030 inside the octant of -U and -V, and is at least 0.22 on the boundary of "
                "each."},
    {.id = "2017-sixteenth",
     .document = text_2017,
     .kind = remark,
     .place = "section 7, the determinant of the second derivatives of eta_i, and of G",
     .says = "Q^3 (eta_ss eta_tt - eta_st^2) = (2 Q Q_ss - Q_s^2)(2 Q Q_tt - Q_t^2) - (2 Q Q_st - Q_s "
             "Q_t)^2. G_ss G_tt - G_st^2 is 0 only if D is perpendicular to W0 x W1.",
     .should = "A sixteenth of the right side. Only then, or if r0 r1 = 0.",
     .why = "4 Q^(3/2) eta_ss = 2 Q Q_ss - Q_s^2, and so for the others. For unit axes both sides are 0, "
            "so the proof of convexity stands and no verdict changes.",
     .shown_by = ShownBy::none,
     .test = "Octant2017.TheDeterminantNeedsASixteenth"},
    {.id = "2017-slips",
     .document = text_2017,
     .kind = remark,
     .place = "sections 2 and 4 to 8",
     .says = "(a) A point is X(theta, t), and s is in the formula (2). (b) f > 0 if Delta = 0, and f(D) > 0 "
             "if D is perpendicular to Delta (4, 7). (c) Parallel axes may be separated across if f(W0) >= "
             "0 (5). (d) The second quarter circle is (1-t)(-U0) + t V (6). (e) c1Sqr is declared and c1sqr "
             "used (8).",
     .should =
         "(a) X(theta, s, t). (b) f(D) >= 0, both times: it is 0 if both solids lie in the plane that D "
         "is perpendicular to, as two segments, or two disks of height 0, may. (c) If f(W0) > 0, as "
         "f(W0) = 0 is separation there. (d) t V0. (e) One name.",
     .why = "What is meant is clear, and everything here does that. In (b) neither solid has an inside, "
            "and sections 5 and 6 test such a D. No verdict changes.",
     .shown_by = ShownBy::none,
     .test = "Degenerate2017.TouchingIsApartWhereAsked"},
};

}  // namespace

std::span<const Erratum> errata_2017() { return table; }

}  // namespace cyl
