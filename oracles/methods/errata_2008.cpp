// SPDX-License-Identifier: MIT
// The errata of the text of 2008 and of the page of the book.
#include "oracles/methods/errata.hpp"

namespace cyl {
namespace {

using literature::Fault;
using enum Document;

// Symbols as in errata_2017.cpp.
constexpr Erratum table[] = {
    {.id = "2008-radius",
     .document = text_2008,
     .place = "section 7, f(W0) < 0 and f(W1) < 0 without a root",
     .says = "r1 |W0 x W1|^2 < rho^2.",
     .should = "r1^2 |W0 x W1|^2 < rho^2.",
     .why =
         "Both sides of r1 |W0 x W1| < rho are squared. As printed the answer depends on the unit of length.",
     .shown_by = ShownBy::alone,
     .fault = Fault::radius_not_squared,
     .rate = "Wrong of 3000 pairs a family: random 234, touching_cap_rim 1367, touching_cap_side 1362, "
             "mixed_scale 778, disks 447, close_rims 379; 18 families more."},
    {.id = "2008-parallel-distance",
     .document = text_2008,
     .place = "section 7, parallel axes",
     .says = "The squared distance of the axes is |Delta|^2 - (W0.Delta)^2.",
     .should = "|Delta x W0|^2.",
     .why = "The same number, but the difference cancels where the solids are far apart along the axes and "
            "near each "
            "other across.",
     .shown_by = ShownBy::alone,
     .fault = Fault::cancelling_distance,
     .rate = "On none of 3000 pairs a family: where parallel axes lie 2^26 times as far apart along them as "
             "across."},
    {.id = "2008-derivative",
     .document = text_2008,
     .place = "section 8, G'(x)",
     .says = "The last term is -sigma2 b2.",
     .should = "-sigma2 a2.",
     .why = "It is the derivative of -sigma2 (a2 x + b2).",
     .shown_by = ShownBy::alone,
     .fault = Fault::derivative_of_the_wrong_term,
     .rate = "Wrong of 3000 pairs a family: random 10, touching_side_rim 1258, needle_and_disk 138, "
             "close_contacts 102, close_contacts_by_angle 47, close_rims 26; 9 families more."},
    {.id = "2008-tangent-line",
     .document = text_2008,
     .place = "section 8, D(x) = x U0 + V0",
     .says = "The tangent line stands for the half circle, with any U0 and V0.",
     .should = "V0 along the projection of Delta; then no more is needed.",
     .why = "The line never is U0. Where f(U0) < 0, F falls for ever and has no critical point; where f(U0) "
            "= 0, it may "
            "fall for ever to a negative value, and testing U0 too does not help. With U0 square to Delta "
            "neither can be.",
     .shown_by = ShownBy::alone,
     .fault = Fault::tangent_line_misses_u0,
     .rate = "Wrong of 3000 pairs a family: random 31, axes_nearly_parallel 154, needle_and_disk 89, lattice "
             "59, lattice_dust 46, points 44; 12 families more."},
    {.id = "2008-vanished-term",
     .document = text_2008,
     .place = "section 8, after G'(x)",
     .says = "|A0 x + B0| = 0 where D is parallel to W0 x W1.",
     .should = "Where D is parallel to W1, which happens for perpendicular axes alone.",
     .why = "A0 x + B0 is P_1 D, which vanishes on W1. Section 7 has tested W1 too, so no verdict changes.",
     .shown_by = ShownBy::none,
     .test = "Separation2008.VanishingTermIsTheOtherAxis"},
    {.id = "2008-negated-pair",
     .document = text_2008,
     .place = "section 10, steps 2 and 4",
     .says =
         "(-eta0, -eta1) can be ignored beside (eta0, eta1), and both eta_i . A_i^T R xi must be positive.",
     .should = "Both must have one sign, either.",
     .why = "The two pairs have one and the same xi and opposite signs there, so half of the critical points "
            "are thrown "
            "away. Were the companion's equations solved anew, with (x, y, -1), those would come back; the "
            "outline takes "
            "over the solution of the first three steps.",
     .shown_by = ShownBy::alone,
     .fault = Fault::negated_pair_ignored,
     .rate = "Wrong of 3000 pairs a family: random 1, touching_rim_rim 704, touching_disks 702, close_rims "
             "297, coins_edge_to_edge 58, close_contacts 30; 9 families more."},
    {.id = "2008-step-4",
     .document = text_2008,
     .place = "section 10, step 4",
     .says = "The second condition ends after W_1 . R xi.",
     .should = "W_1 . R xi >= 0.",
     .why = "Unfinished. D.Delta >= 0, which is not asked, follows from the others: D.Delta = D.phi + (h0/2) "
            "D.W_0 + (h1/2) "
            "D.W_1 and D.phi > 0. No verdict changes.",
     .shown_by = ShownBy::none,
     .test = "Separation2008.ThirdInequalityFollows"},
    {.id = "2008-sign-of-p0",
     .document = text_2008,
     .place = "section 11, P_0 = r0 det(B0) eta_0; section 10, step 4",
     .says = "P_0 and P_1 may stand for eta_0 and eta_1 in all that follows.",
     .should = "-P_0 for eta_0 where det(B0) < 0.",
     .why = "P_0 then points against eta_0, so the condition on signs in step 4 accepts the wrong points and "
            "rejects the "
            "right ones. Where the vectors are used to extract (x, y) alone, and eta_0 itself in step 4, it "
            "is no fault: "
            "a trap rather than a misprint.",
     .shown_by = ShownBy::alone,
     .fault = Fault::sign_of_p0,
     .rate = "Wrong of 3000 pairs a family: random 1, touching_rim_rim 279, touching_disks 234, close_rims "
             "199, close_contacts 25, coins_edge_to_edge 20; 9 families more."},
    {.id = "2008-b-squared",
     .document = text_2008,
     .place = "section 11, b^2",
     .says = "b^2 = (r1^2 - e0 r0^2 det(B0)^2)/(e1 - e0).",
     .should = "b^2 = (r0^2 det(B0)^2 - e0 r1^2)/(e1 - e0).",
     .why = "It solves a^2 + b^2 = r1^2 and e0 a^2 + e1 b^2 = r0^2 det(B0)^2. As printed the answer depends "
            "on the unit of "
            "length.",
     .shown_by = ShownBy::alone,
     .fault = Fault::wrong_b_squared,
     .rate = "Wrong of 3000 pairs a family: random 1, touching_disks 1114, touching_rim_rim 1111, close_rims "
             "424, coins_edge_to_edge 117, close_contacts 41; 9 families more."},
    {.id = "2008-equal-eigenvalues",
     .document = text_2008,
     .place = "section 11, e0 = e1",
     .says = "a^2 and b^2 are divided by e1 - e0, also where that is 0.",
     .should = "Where e0 = e1: no isolated critical point.",
     .why = "C^T C is a multiple of the identity only where W is along a bisector of the axes. Then g0 is "
            "least at W, and "
            "with r0 = r1 on the whole arc from W0 to W1, whose ends section 7 tests, or which leaves the "
            "region of its "
            "signs where section 8 looks; with r0 != r1 there is no critical point. Not-a-number fails every "
            "test, so no "
            "verdict changes.",
     .shown_by = ShownBy::none,
     .fault = Fault::equal_eigenvalues},
    {.id = "2008-slips",
     .document = text_2008,
     .place = "sections 2.2, 6, 10 and 12",
     .says = "Regions of a plane are projected onto a line, twice (2.2). f(tD) < 0 for any t (6). Step 2 "
             "refers to step 4 for "
             "the extraction of (x, y) (10). The right side of the two equations is defined as D (12).",
     .should = "Onto the plane. For any t != 0. Step 3. d.",
     .why = "Slips of the pen: what is meant is clear, and everything here does that, so no verdict changes.",
     .shown_by = ShownBy::none},

    {.id = "book-sign-of-p0",
     .document = book,
     .place = "page 656, p_0 = r0 det(B0) eta_0",
     .says = "p_0 and p_1 may stand for eta_0 and eta_1 in all that follows.",
     .should = "-p_0 for eta_0 where det(B0) < 0.",
     .why = "As in section 11 of the text of 2008.",
     .shown_by = ShownBy::alone,
     .fault = Fault::sign_of_p0,
     .rate = "Wrong of 3000 pairs a family: random 1, touching_rim_rim 279, touching_disks 234, close_rims "
             "199, close_contacts 25, coins_edge_to_edge 19; 9 families more."},
    {.id = "book-b-squared",
     .document = book,
     .place = "page 656, b^2",
     .says = "b^2 = (r1^2 - e0 r0^2 det(B0)^2)/(e1 - e0).",
     .should = "b^2 = (r0^2 det(B0)^2 - e0 r1^2)/(e1 - e0).",
     .why = "As in section 11 of the text of 2008.",
     .shown_by = ShownBy::alone,
     .fault = Fault::wrong_b_squared,
     .rate = "Wrong of 3000 pairs a family: random 1, touching_disks 1114, touching_rim_rim 1111, close_rims "
             "424, coins_edge_to_edge 110, close_contacts 41; 9 families more."},
    {.id = "book-equal-eigenvalues",
     .document = book,
     .place = "page 656, e0 = e1",
     .says = "a^2 and b^2 are divided by e1 - e0, also where that is 0.",
     .should = "Where e0 = e1: no isolated critical point.",
     .why = "As in section 11 of the text of 2008: no verdict changes.",
     .shown_by = ShownBy::none,
     .fault = Fault::equal_eigenvalues},
};

}  // namespace

std::span<const Erratum> errata_2008() { return table; }

}  // namespace cyl
