/* SPDX-License-Identifier: MIT
 * A plug-in with a plain test of boxes, for tests of the gate. It takes boxes, capsules, spheres and
 * half-spaces. A solid is a box grown by a ball; the box of a capsule has two edges of 0. Separating axes
 * tell whether two boxes overlap, and how deep. Else all vertices and edges are tried for the nearest points.
 * cc -DFAULT=n plants fault n. naive_boxes_test.sh reads the list:
 *
 * FAULT 1: the quaternion is read as x y z w
 * FAULT 2: one component of the quaternion has the wrong sign
 * FAULT 3: the quaternion is not normalised
 * FAULT 4: the rotation is transposed
 * FAULT 5: the rotation is in single precision
 * FAULT 6: the centres are in single precision
 * FAULT 7: the edges are taken for half edges
 * FAULT 8: the first two edges are swapped
 * FAULT 9: a flat box is made 1e-3 thick
 * FAULT 10: the rounding is ignored
 * FAULT 11: the rounding counts twice
 * FAULT 12: the rounding goes inwards
 * FAULT 13: a rounded box is a larger box with sharp edges
 * FAULT 14: no absolute value of the projections of edges
 * FAULT 15: no absolute value of the projection between the centres
 * FAULT 16: one coordinate of the centres is ignored
 * FAULT 17: the axis of two edges is not normalised
 * FAULT 18: a tolerance of 1e-6 is added to every projection of an edge
 * FAULT 19: a facet of b is not tried
 * FAULT 20: a facet of a is not tried
 * FAULT 21: one of nine pairs of edges is not tried
 * FAULT 22: another of them is not tried
 * FAULT 23: edges within 1e-3 rad are parallel
 * FAULT 24: edges within 1e-5 rad are parallel
 * FAULT 25: if two edges are within 1e-2 rad, no pair of edges is tried
 * FAULT 26: pairs of edges take the rows of a rotation for its columns
 * FAULT 27: no pair of edges is tried
 * FAULT 28: a ball of the longest half edge is taken for a ball around the box
 * FAULT 29: the nearest points miss the vertices of a
 * FAULT 30: the nearest points miss pairs of edges
 * FAULT 31: edges are 10 % too long where they cross
 * FAULT 32: the nearest point of a box may be outside it
 * FAULT 33: the lowest vertex on a half-space ignores an edge
 * FAULT 34: half edges of a serve for b if the centres are far apart
 * FAULT 35: the axis of nearly parallel edges keeps its rounding errors */
#include <float.h>
#include <string.h>

#include "plugin.h"

#ifndef FAULT
#define FAULT 0
#endif
#define IF_FAULT(n, wrong, right) (FAULT == (n) ? (wrong) : (right))

static const double far = 1e100; /* a length whose square is a number */

struct Box {
  double edge[3][3]; /* the unit directions of the edges */
  double half[3];
  double rounding;
};

static double dot(const double* x, const double* y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }
static double length(const double* x) { return sqrt(dot(x, x)); }
static void cross(const double* x, const double* y, double* out) {
  for (int i = 0, j = 1, k = 2; i < 3; j = k, k = i++) out[i] = x[j] * y[k] - x[k] * y[j];
}
static void add(double* to, double factor, const double* x) {
  for (int i = 0; i < 3; ++i) to[i] += factor * x[i];
}

static struct DaylightSolid mistaken(const struct DaylightSolid* solid) {
  struct DaylightSolid s = *solid;
  double* const q = s.quaternion;
  if (FAULT == 1) {
    const double w = q[3];
    memmove(q + 1, q, 3 * sizeof *q);
    q[0] = w;
  }
  if (FAULT == 2) q[2] = -q[2];
  return s;
}

static struct Box box_of(const struct DaylightSolid* solid) {
  const struct DaylightSolid s = mistaken(solid);
  const int box = s.shape >= DAYLIGHT_BOX;
  struct Box out = {.rounding = IF_FAULT(10, s.shape == DAYLIGHT_ROUNDED_BOX ? 0 : s.rounding, s.rounding)};
  double rotation[9], longest = 0;
  daylight_solid_rotation(&s, rotation);
  if (FAULT == 3 && box) {
    const double n = dot(s.quaternion + 1, s.quaternion + 1) + s.quaternion[0] * s.quaternion[0];
    for (int i = 0; i < 9; ++i) rotation[i] = (i % 4 == 0) + (rotation[i] - (i % 4 == 0)) * n;
  }
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const double x = IF_FAULT(4, box ? rotation[3 * i + k] : rotation[3 * k + i], rotation[3 * k + i]);
      out.edge[i][k] = IF_FAULT(5, (float)x, x);
    }
    const double full = box ? s.lengths[i < 2 ? IF_FAULT(8, 1 - i, i) : i] : i < 2 ? 0 : s.lengths[1];
    out.half[i] = IF_FAULT(7, box ? full : full / 2, full / 2);
    longest = fmax(longest, out.half[i]);
  }
  for (int i = 0; i < 3 && box; ++i) {
    if (FAULT == 9) out.half[i] = fmax(out.half[i], 5e-4 * longest);
    if (FAULT == 12) out.half[i] = fmax(0, out.half[i] - s.rounding);
    if (FAULT == 13) out.half[i] += s.rounding;
  }
  if (FAULT == 13 && box) out.rounding = 0;
  return out;
}

/* The reach of a box along d, which may have any length. */
static double reach(const struct Box* box, const double* d) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double along = dot(box->edge[i], d);
    sum += box->half[i] * (IF_FAULT(14, along, fabs(along)) + IF_FAULT(18, 1e-6, 0));
  }
  return sum;
}

/* The gap between the boxes along d, in the unit of lengths; negative if they overlap. */
static double gap_along(const struct Box* a, const struct Box* b, const double* between, const double* d) {
  const double along = dot(between, d);
  return IF_FAULT(15, along, fabs(along)) - reach(a, d) - reach(b, d);
}

/* The greatest gap along one of the 15 axes, which is minus the depth if the boxes overlap. */
static double greatest_gap(const struct Box* a, const struct Box* b, const double* between) {
  double most = -DBL_MAX;
  for (int i = 0; i < 3; ++i) {
    if (FAULT != 20 || i != 0) most = fmax(most, gap_along(a, b, between, a->edge[i]));
    if (FAULT != 19 || i != 2) most = fmax(most, gap_along(a, b, between, b->edge[i]));
  }
  const double parallel = IF_FAULT(23, 1e-3, IF_FAULT(24, 1e-5, 1e-15)); /* sine of an angle */
  for (int pair = 0; pair < 9 && FAULT != 27; ++pair) {
    const int i = pair / 3, j = pair % 3;
    double other[3], axis[3];
    for (int k = 0; k < 3; ++k) other[k] = IF_FAULT(26, b->edge[k][j], b->edge[j][k]);
    cross(a->edge[i], other, axis);
    if (FAULT != 35) add(axis, -dot(axis, a->edge[i]), a->edge[i]);
    const double sine = length(axis);
    if (FAULT == 25 && sine < 1e-2) break;
    if (sine < parallel || (FAULT == 21 && pair == 1) || (FAULT == 22 && pair == 8)) continue;
    most = fmax(most, gap_along(a, b, between, axis) / IF_FAULT(17, 1, sine));
  }
  return most;
}

/* Keeps the shorter vector. */
static void keep_shorter(double* shortest, const double* vector) {
  if (length(vector) < length(shortest)) memcpy(shortest, vector, 3 * sizeof *vector);
}

/* The vertex of a box with the signs of the bits of `which`. Skips the edge `without`. */
static void vertex(const struct Box* box, int which, int without, double* out) {
  memset(out, 0, 3 * sizeof *out);
  for (int i = 0; i < 3; ++i)
    if (i != without) add(out, which >> i & 1 ? box->half[i] : -box->half[i], box->edge[i]);
}

/* Tries the vectors from vertices of `from`, whose centre is at `at`, to a box at the origin, times `sign`.
 */
static void try_vertices(const struct Box* from, const double* at, const struct Box* box, double sign,
                         double* shortest) {
  for (int which = 0; which < 8; ++which) {
    double point[3], vector[3] = {0, 0, 0};
    vertex(from, which, -1, point);
    add(point, 1, at);
    for (int i = 0; i < 3; ++i) {
      const double along = dot(point, box->edge[i]);
      const int inside = fabs(along) <= box->half[i] || (FAULT == 32 && i == 2);
      if (!inside) add(vector, sign * (copysign(box->half[i], along) - along), box->edge[i]);
    }
    keep_shorter(shortest, vector);
  }
}

/* Tries the vectors between points where two edges cross. The ends of edges are vertices. */
static void try_edges(const struct Box* a, const struct Box* b, const double* between, double* shortest) {
  for (int pair = 0; pair < 9; ++pair) {
    const int i = pair / 3, j = pair % 3;
    const double *const u = a->edge[i], *const v = b->edge[j];
    double axis[3];
    cross(u, v, axis);
    if (length(axis) < 1e-15) continue;
    for (int which = 0; which < 64; ++which) {
      if ((which >> i & 1) != 0 || (which >> (3 + j) & 1) != 0) continue;
      double from[3], vector[3], turned[3];
      vertex(a, which, i, from);
      vertex(b, which >> 3, j, vector);
      add(vector, 1, between);
      add(vector, -1, from);
      cross(vector, v, turned);
      const double s = dot(turned, axis) / dot(axis, axis), most = IF_FAULT(31, 1.1, 1);
      add(vector, -s, u);
      const double t = -dot(vector, v); /* nearly parallel edges leave s few digits, and need no more */
      add(vector, t, v);
      if (fabs(s) > most * a->half[i] || fabs(t) > most * b->half[j]) continue;
      keep_shorter(shortest, vector);
    }
  }
}

static double to_half_space(const struct DaylightSolid* plane, const struct DaylightSolid* solid,
                            double* normal) {
  const struct Box box = box_of(solid);
  double rotation[9], lowest = -box.rounding;
  daylight_solid_rotation(plane, rotation);
  for (int k = 0; k < 3; ++k) {
    normal[k] = rotation[3 * k + 2];
    lowest += (solid->center[k] - plane->center[k]) * normal[k];
  }
  for (int i = 0; i < IF_FAULT(33, 2, 3); ++i) lowest -= box.half[i] * fabs(dot(box.edge[i], normal));
  return lowest;
}

static double distance(const struct DaylightSolid* x, const struct DaylightSolid* y, double* shortest) {
  const struct Box a = box_of(x);
  struct Box b = box_of(y);
  double between[3], back[3];
  for (int k = 0; k < 3; ++k) {
    between[k] = IF_FAULT(6, (float)y->center[k] - (float)x->center[k], y->center[k] - x->center[k]);
    if (FAULT == 16 && k == 2) between[k] = 0;
    back[k] = -between[k];
    shortest[k] = far;
  }
  if (FAULT == 34 && length(between) > 10) memcpy(b.half, a.half, sizeof b.half);
  const double rounding = IF_FAULT(11, 2, 1) * (a.rounding + b.rounding);
  if (FAULT == 28) {
    const double beyond = length(between) - rounding - fmax(fmax(a.half[0], a.half[1]), a.half[2]) -
                          fmax(fmax(b.half[0], b.half[1]), b.half[2]);
    memcpy(shortest, between, sizeof between);
    if (beyond > 0) return beyond;
  }
  const double gap = greatest_gap(&a, &b, between);
  if (gap <= 0) return gap - rounding;
  try_vertices(&b, between, &a, -1, shortest);
  if (FAULT != 29) try_vertices(&a, back, &b, 1, shortest);
  if (FAULT != 30) try_edges(&a, &b, between, shortest);
  return length(shortest) - rounding;
}

static int ask(const struct DaylightSolid* a, const struct DaylightSolid* b, double more[7]) {
  double normal[3];
  more[0] = a->shape == DAYLIGHT_HALF_SPACE   ? to_half_space(a, b, normal)
            : b->shape == DAYLIGHT_HALF_SPACE ? to_half_space(b, a, normal)
                                              : distance(a, b, normal);
  if (!(more[0] > 0)) return DAYLIGHT_INTERSECTING;
  memcpy(more + 1, normal, sizeof normal);
  return DAYLIGHT_DISJOINT;
}

static const struct DaylightMethod boxes = {
    .abi = DAYLIGHT_PLUGIN_ABI,
    .name = "boxes",
    .claim_relative = 1e-12,
    .claim_absolute = 1e-11, /* lengths are at most 1e3, gaps at most 1e2 */
    .shapes = DAYLIGHT_SPHERE | DAYLIGHT_CAPSULE | DAYLIGHT_HALF_SPACE | DAYLIGHT_BOX | DAYLIGHT_ROUNDED_BOX,
    .least_length = 1e-3,
    .greatest_length = 1e3,
    .greatest_coordinate = 1e4,
    .greatest_gap = 1e2,
    .ask_solids = ask};
const struct DaylightMethod* daylight_method(void) { return &boxes; }
