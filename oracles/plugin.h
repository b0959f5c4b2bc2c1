/* SPDX-License-Identifier: MIT
 * Your collision test as a shared library, in C or C++. Define daylight_method(), build with -shared -fPIC,
 * and pass the file to a command: daylight gate --plugin ./libmine.so. docs/guides/library.md has a complete
 * example.
 *
 * A cylinder is eight doubles: centre x y z, axis x y z (any length but 0), radius, full height. It is solid,
 * closed and finite. If takes_rounding is 1, it is nine doubles. The last is the radius of a ball by which
 * the solid is grown: with radius 0 and height 0 it is a sphere, with radius 0 a capsule. A plug-in that sets
 * ask_solids gets structs instead, which may also be boxes and half-spaces.
 *
 * The plug-in runs in a process of its own, which is reused between calls. It may crash, hang, throw, sleep,
 * print, read files and start threads. It may not start processes, signal others, or leave the rounding mode
 * changed.
 */
#ifndef DAYLIGHT_PLUGIN_H
#define DAYLIGHT_PLUGIN_H

#include <math.h>
#include <stddef.h>

#define DAYLIGHT_PLUGIN_ABI 4 /* plug-ins built for interface 1, 2 or 3 still load */

enum DaylightVerdict {
  DAYLIGHT_DISJOINT = 0,
  DAYLIGHT_INTERSECTING = 1, /* also touching, if your library does not distinguish the two */
  DAYLIGHT_TOUCHING = 2,
  DAYLIGHT_UNDECIDED = 3,
  DAYLIGHT_BEYOND = 4,    /* disjoint; the gap is > more[0] >= 0, not measured further */
  DAYLIGHT_DECLINED = -1, /* the pair is not supported; this is not a fault */
  DAYLIGHT_FAILED = -2    /* the library tried and failed; this is a fault */
};

enum DaylightShapes {
  DAYLIGHT_SPHERE = 1,
  DAYLIGHT_CAPSULE = 2,
  DAYLIGHT_CYLINDER = 4,
  DAYLIGHT_ROUNDED_CYLINDER = 8,
  DAYLIGHT_HALF_SPACE = 16, /* this and the next two only with ask_solids */
  DAYLIGHT_BOX = 32,        /* without rounding */
  DAYLIGHT_ROUNDED_BOX = 64
};

/* A closed solid. The fields that its shape does not have are 0. A pair has at most one half-space. */
struct DaylightSolid {
  int shape;            /* one of DaylightShapes; the first four have the fields of a cylinder */
  double center[3];     /* a half-space has a point of its plane here */
  double axis[3];       /* of any length but 0; a half-space has its outward normal here */
  double quaternion[4]; /* w x y z of a box, of any length but 0. It turns x, y and z to the edges */
  double lengths[3];    /* radius and full height, or the three full edges of a box; each may be 0 */
  double rounding;      /* the radius of a ball by which the solid is grown */
};

/* AT_MOST: a depth that you return is an upper bound, such as the least on a few axes. It is a fault only if
 * the true depth is greater. */
enum DaylightDepth { DAYLIGHT_DEPTH_EXACT = 0, DAYLIGHT_DEPTH_AT_MOST = 1 };

struct DaylightMethod {
  int abi;             /* DAYLIGHT_PLUGIN_ABI */
  const char* name;    /* letters, digits, - _ . */
  const char* version; /* may be 0 */

  /* The claim: right if |distance| >= relative * size + absolute. A wrong answer beyond the claim is a fault.
   * A wrong answer within it is only counted. The size of a pair is the sum of the lengths and roundings of
   * both solids. These are the radii, not the diameters, and full heights and edges. A half-space adds
   * nothing. */
  double claim_relative, claim_absolute;
  const char* claim_source; /* the place that states it; may be 0 */

  /* Returns a verdict, as above. `more` is all NaN before the call. You may set the signed distance in
   * more[0] (negative: the depth), and the normal of a separating plane in more[1..3]. You may set a common
   * point in more[4..6], which is ignored if a solid is rounded. Called from one thread at a time.
   *
   * A normal or point that you set must be right within the claim, like a verdict. The point may lie outside
   * a solid by t, the bound in the claim. The normal may be off by the angle 2 t / gap, as if both nearest
   * points were off by t. It may have any length but 0. */
  int (*ask)(const double* a, const double* b, double more[7]);

  /* For timing; may be 0. `count` pairs of 16 doubles each (18 with rounding), one verdict each. */
  void (*ask_all)(size_t count, const double* pairs, signed char* verdicts);

  /* Added in interface 2. Each may be 0. */

  /* Returns why the last call of `ask` declined or failed, in a few words. */
  const char* (*reason)(void);
  /* Does what `ask` does for `count` pairs of 16 doubles each (18 with rounding), in one call: one verdict
   * and seven doubles of `more` for each. Must give the same answers as `ask`. */
  void (*ask_many)(size_t count, const double* pairs, int* verdicts, double* more);
  /* Another method of this library. */
  const struct DaylightMethod* next;
  /* 1: it supports rounded solids, and every cylinder passed to it is nine doubles. */
  int takes_rounding;

  /* Added in interface 3: what your library supports. 0 means no limit. Other pairs are not passed to it. */

  /* The sum of its DaylightShapes. 0: cylinders, and also those with a rounding if takes_rounding is 1. */
  int shapes;
  /* The least and the greatest radius, height, edge or rounding, in the unit of your scenes. */
  double least_length, greatest_length;
  /* The greatest of these lengths of one solid divided by the least. */
  double greatest_aspect;
  /* 1: no disks and segments, that is, no cylinders with a radius or height of 0. No boxes with an edge of
   * 0. */
  int no_zero_lengths;

  /* Added in interface 4. The first two limit the pairs that are passed to it. 0 means no limit. */

  /* The greatest coordinate of a centre or point of a plane, in absolute value. */
  double greatest_coordinate;
  /* The greatest gap between the balls around the solids, each at its centre. The solids are at least as far
   * apart as these balls. A half-space has no ball, and no such limit. */
  double greatest_gap;
  /* One of DaylightDepth. */
  int depth;
  /* If you set ask_solids, daylight calls these three instead of ask, ask_all and ask_many, which may be 0.
   * They differ only in the form of a solid. `pairs` holds two solids for each pair. */
  int (*ask_solids)(const struct DaylightSolid* a, const struct DaylightSolid* b, double more[7]);
  void (*ask_all_solids)(size_t count, const struct DaylightSolid* pairs, signed char* verdicts);
  void (*ask_many_solids)(size_t count, const struct DaylightSolid* pairs, int* verdicts, double* more);
};

#if defined(__cplusplus) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 199901L)
/* Fills `rotation` with a rotation, row by row. It takes the coordinate axis `along` (0 is x, 1 is y, 2 is z)
 * to the direction of `axis`, which has any length but 0. Column `along`, that is rotation[along],
 * rotation[along + 3] and rotation[along + 6], is the unit vector of the axis, within 4e-16. No axis is too
 * long or too short for it. */
static inline void daylight_rotation(const double axis[3], int along, double rotation[9]) {
  /* Duff et al., Building an Orthonormal Basis, Revisited (2017). s is the sign of n[2], so s + n[2] is never
   * 0. */
  const double most = fmax(fabs(axis[0]), fmax(fabs(axis[1]), fabs(axis[2])));
  double n[3] = {axis[0] / most, axis[1] / most, axis[2] / most};
  const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (int i = 0; i < 3; ++i) n[i] /= length;
  const double s = copysign(1, n[2]), t = -1 / (s + n[2]), u = n[0] * n[1] * t;
  const double columns[3][3] = {
      {1 + s * n[0] * n[0] * t, s * u, -s * n[0]}, {u, s + n[1] * n[1] * t, -n[1]}, {n[0], n[1], n[2]}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) rotation[3 * i + (along + 1 + j) % 3] = columns[j][i];
}

/* Fills `rotation` with the rotation of a solid, row by row, within 2e-15. The columns are the directions of
 * the edges of a box. The third column of all other solids is the unit axis or normal, as in
 * daylight_rotation(). */
static inline void daylight_solid_rotation(const struct DaylightSolid* solid, double rotation[9]) {
  if (solid->shape < DAYLIGHT_BOX) {
    daylight_rotation(solid->axis, 2, rotation);
    return;
  }
  const double* given = solid->quaternion;
  const double most = fmax(fmax(fabs(given[0]), fabs(given[1])), fmax(fabs(given[2]), fabs(given[3])));
  const double w = given[0] / most, v[3] = {given[1] / most, given[2] / most, given[3] / most};
  const double scale = 2 / (w * w + v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    rotation[4 * i] = 1 - scale * (v[j] * v[j] + v[k] * v[k]);
    rotation[3 * i + j] = scale * (v[i] * v[j] - w * v[k]);
    rotation[3 * j + i] = scale * (v[i] * v[j] + w * v[k]);
  }
}
#endif

#ifdef __cplusplus
extern "C"
#endif
    const struct DaylightMethod*
    daylight_method(void);

#endif
