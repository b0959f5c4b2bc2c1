// SPDX-License-Identifier: MIT
// The errata of the text of 2017.
#include "oracles/methods/errata.hpp"

namespace cyl {
namespace {

using literature::Fault;
using enum Document;

// r_i, h_i: radii and (whole) heights; W_i: unit axes; D: a direction; Delta: from the first centre to the
// second; f(D) < 0: the line along D separates.
constexpr Erratum table[] = {
    {.id = "2017-coincident-centers",
     .document = text_2017,
     .place = "sections 4 and 8",
     .says = "Delta != 0 is assumed, and nothing tests it.",
     .should = "Where Delta = 0, the answer is: not separated.",
     .why =
         "W = Delta/|Delta| is then not-a-number, every comparison with it is false, and the code comes to "
         "'not separated' after all its work. That is right, and no verdict changes: solids with one centre "
         "have a point in common.",
     .shown_by = ShownBy::none,
     .fault = Fault::coincident_centers},
    {.id = "2017-mixed-strictness",
     .document = text_2017,
     .place = "sections 3.1, 5 and 8",
     .says =
         "Section 3.1 lets equality count as separation, and sections 5, 6 and 7 have f(D) <= 0. The code of "
         "section 8 has < 0 for W0, W1, W0 x W1 and for parallel axes.",
     .should = "<= 0 in all of them; or < 0 in all of them, where what only touches shall not be separated.",
     .why = "Two cylinders, one on the other, are 'not separated', while two that touch side by side at an "
            "angle are.",
     .shown_by = ShownBy::alone,
     .fault = Fault::mixed_strictness,
     .rate = "Of what touches exactly alone, where parallel axes or a plane square to an axis decide."},
    {.id = "2017-kink-of-equation-9",
     .document = text_2017,
     .place = "section 6, the warning after Equation (10)",
     .says = "F' and F'' jump where Sign((1-t) a2 + b2) = 0.",
     .should = "Sign((1-t) a2 + t b2) = 0.",
     .why = "A t is missing. Equations (8) and (9) and the code have it, so no verdict changes.",
     .shown_by = ShownBy::none,
     .test = "Quarter2017.TheKinkIsWhereDeltaIsSquareToD"},
    {.id = "2017-equation-10",
     .document = text_2017,
     .place = "section 6, Equation (10)",
     .says = "The first term of F'' is 3 r0/((1-t)^2 + t^2)^(3/2).",
     .should = "r0/((1-t)^2 + t^2)^(3/2).",
     .why = "sqrt(q) with q = (1-t)^2 + t^2 has the second derivative 1/q^(3/2). No step of the method uses "
            "F'', so no "
            "verdict changes.",
     .shown_by = ShownBy::none,
     .test = "Quarter2017.TheCoefficientOfEquation10IsOne"},
    {.id = "2017-strictly-convex",
     .document = text_2017,
     .place = "section 6, after Equation (10)",
     .says = "F is strictly convex.",
     .should = "F is convex on either side of the kink of its last term.",
     .why = "-|x| is concave, so F has a peak where (1-t) a2 + t b2 changes its sign. No verdict changes: "
            "|P_i D(t)| is "
            "at least (1-t) |P_i U0| and at least t |P_i V0|, so with a2 > 0 > b2, F(t) >= (1-t) F(0) before "
            "the kink "
            "and F(t) >= t F(1) behind it, and both ends are tested.",
     .shown_by = ShownBy::none,
     .fault = Fault::kink_taken_for_convex},
    {.id = "2017-first-quarter",
     .document = text_2017,
     .place = "section 6, the algorithm; section 8, SeparatedByCylinderPerpendiculars",
     .says = "Where F'(0) >= 0 or F'(1) <= 0 on the first quarter circle, no perpendicular direction "
             "separates: false is "
             "returned.",
     .should = "Go on to the second quarter circle, from -U0 to V0.",
     .why = "The slopes of one quarter say nothing of the other. Alone it costs nothing once section 7 is "
            "put right, "
            "which looks at every direction, perpendicular ones among them; in the printed method it does.",
     .shown_by = ShownBy::taken_out,
     .fault = Fault::first_quarter_ends_all,
     .rate = "Wrong of 3000 pairs a family: random 8, touching_side_rim 643, mixed_scale 218, close_contacts "
             "82, close_rims 81, close_contacts_by_angle 64; 13 families more."},
    {.id = "2017-no-return",
     .document = text_2017,
     .place = "section 8, the end of SeparatedByCylinderPerpendiculars",
     .says = "The function ends without a return.",
     .should = "return false.",
     .why = "What happens then is undefined. Everything here takes it as false, so no verdict changes.",
     .shown_by = ShownBy::none},
    {.id = "2017-vanished-root",
     .document = text_2017,
     .place =
         "section 6, Equation (9), at t = 1 of perpendicular axes; section 7, the gradient of G at D = W_i",
     .says = "The derivative of r |P_i D| is divided by |P_i D|, also where that is 0.",
     .should = "The one-sided slope -r1 in Equation (9); in section 7 any subgradient, such as 0, and one "
               "more line "
               "searched from there.",
     .why = "0/0 is not-a-number. It turns no comparison the wrong way, but it ends a search on the spot.",
     .shown_by = ShownBy::alone,
     .fault = Fault::division_by_vanished_root,
     .rate = "Wrong of 3000 pairs a family: close_rims 3; lattice_dust 1 of 2164."},
    {.id = "2017-cancelling-sine",
     .document = text_2017,
     .place = "section 8, SeparatedByCylinderPerpendiculars",
     .says = "b1 = sqrt(1 - c1^2) and V0 = (W1 - c1 W0)/b1.",
     .should = "b1 = |N|, U0 = -N/b1, V0 = W0 x U0 with N = (W0 - W1) x (W0 + W1)/2, one axis turned round "
               "if need be.",
     .why = "Between axes that are nearly parallel 1 - c1^2 cancels: at angles of 1e-8 and below b1 is 0, "
            "1.5e-8 or "
            "not-a-number. Alone it costs nothing once section 7 is put right, which does not use b1.",
     .shown_by = ShownBy::taken_out,
     .fault = Fault::cancelling_sine,
     .rate = "Wrong of 3000 pairs a family: close_contacts_by_angle 119, close_contacts 81, "
             "axes_nearly_parallel 53, close_rims 38, coins_edge_to_edge 36."},
    {.id = "2017-one-octant",
     .document = text_2017,
     .place = "section 8, SeparatedByOtherDirections",
     .says = "G is minimised for s, t >= 0 and s + t <= 1.",
     .should = "Likewise with (-U, V), (-U, -V) and (U, -V) in the place of (U, V), as section 7 says.",
     .why = "That is one octant of the four that the hemisphere consists of. Section 7 names the octants and "
            "writes out "
            "the first; a program that follows section 8 has that one alone.",
     .shown_by = ShownBy::alone,
     .fault = Fault::one_octant,
     .rate = "Wrong of 3000 pairs a family: random 2, touching_disks 1007, touching_rim_rim 959, close_rims "
             "416, coins_edge_to_edge 73, close_contacts 36; 9 families more."},
    {.id = "2017-cancelling-root",
     .document = text_2017,
     .place = "section 7, Q_i; section 8, G and GDer",
     .says = "|P_i D| = sqrt(|D|^2 - (D.W_i)^2).",
     .should = "|P_i D| = |D x W_i|.",
     .why = "Next to W_i the difference has lost half of its digits, and the slope of G with them.",
     .shown_by = ShownBy::taken_out,
     .fault = Fault::cancelling_root,
     .rate = "Wrong of 3000 pairs a family: touching_cap_rim 55, mixed_scale 35, touching_cap_side 17, "
             "close_contacts_by_angle 16, close_contacts 13; 6 families more."},
    {.id = "2017-kinks",
     .document = text_2017,
     .place = "sections 7 and 8",
     .says = "G is convex, and minimisers do well on convex functions.",
     .should = "Minimise G in each of the cells into which the lines D.W_0 = 0 and D.W_1 = 0 cut the "
               "triangle, with the "
               "signs of D.W_i that hold there.",
     .why = "G has kinks on those lines, where conjugate gradients and Powell's line searches get stuck "
            "above the "
            "minimum.",
     .shown_by = ShownBy::taken_out,
     .fault = Fault::kinks_taken_for_smooth,
     .rate = "Wrong of 3000 pairs a family: touching_side_rim 146, mixed_scale 69, close_contacts 25, "
             "close_contacts_by_angle 22, touching_rim_rim 17; 10 families more."},
    {.id = "2017-boundary",
     .document = text_2017,
     .place = "section 8, after SeparatedByOtherDirections",
     .says = "Once a line search ends on the boundary of the triangle, the minimum is on the boundary; a "
             "minimum inside "
             "never leads there.",
     .should = "Search the boundary first, and start from its lowest point.",
     .why = "The first line from anywhere may end on the boundary. From the lowest point of the boundary "
            "none does, as G "
            "is not lower anywhere on it.",
     .shown_by = ShownBy::alone,
     .fault = Fault::stays_on_the_boundary,
     .rate = "Wrong of 3000 pairs a family: touching_rim_rim 234, close_rims 214, close_contacts 26, "
             "close_contacts_by_angle 10, coins_edge_to_edge 1."},
    {.id = "2017-sixteenth",
     .document = text_2017,
     .place = "section 7, the determinant of the second derivatives of eta_i",
     .says =
         "Q^3 (eta_ss eta_tt - eta_st^2) = (2 Q Q_ss - Q_s^2)(2 Q Q_tt - Q_t^2) - (2 Q Q_st - Q_s Q_t)^2.",
     .should = "A sixteenth of the right side.",
     .why = "4 Q^(3/2) eta_ss = 2 Q Q_ss - Q_s^2, and so for the others. For unit axes both sides are 0, so "
            "the proof of "
            "convexity stands and no verdict changes.",
     .shown_by = ShownBy::none,
     .test = "Octant2017.TheDeterminantNeedsASixteenth"},
    {.id = "2017-slips",
     .document = text_2017,
     .place = "sections 4, 5, 6 and 8",
     .says = "f > 0 where Delta = 0 (4). Parallel axes may be separated across where f(W0) >= 0 (5). The "
             "second quarter "
             "circle is (1-t)(-U0) + t V (6). c1Sqr is declared and c1sqr used (8).",
     .should = "f >= 0: it is 0 for two points. f(W0) > 0, as f(W0) = 0 is separation there. t V0. One name.",
     .why = "Slips of the pen: what is meant is clear, and everything here does that, so no verdict changes.",
     .shown_by = ShownBy::none},
};

}  // namespace

std::span<const Erratum> errata_2017() { return table; }

}  // namespace cyl
