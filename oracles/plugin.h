/* SPDX-License-Identifier: MIT
 * A method of yours as a shared library: define daylight_method(), build with -shared -fPIC, and name the
 * file to any command: daylight gate --plugin ./libmine.so. C and C++ alike; docs/guides/library.md has one whole.
 *
 * A cylinder is eight doubles: centre x y z, axis x y z (any length but 0), radius, full height. Solid,
 * closed, finite. For a method that takes rounding it is nine: the last is the radius of a ball by which the
 * solid is grown (radius 0 and height 0: a sphere; radius 0: a capsule). Others are not asked about such pairs.
 *
 * A method runs in a process of its own, in which it may crash, hang, throw, sleep, print, read files and
 * start threads; the process lives on from question to question. It may not start processes, signal others,
 * or leave the rounding mode changed.
 */
#ifndef DAYLIGHT_PLUGIN_H
#define DAYLIGHT_PLUGIN_H

#include <stddef.h>

#define DAYLIGHT_PLUGIN_ABI 2 /* what was built for 1, which ends with ask_all, is asked as ever */

enum DaylightVerdict {
  DAYLIGHT_DISJOINT = 0,
  DAYLIGHT_INTERSECTING = 1, /* touching included, for who does not tell them apart */
  DAYLIGHT_TOUCHING = 2,
  DAYLIGHT_UNDECIDED = 3,
  DAYLIGHT_DECLINED = -1, /* not for such a pair: no fault */
  DAYLIGHT_FAILED = -2    /* tried and broke */
};

struct DaylightMethod {
  int abi;             /* DAYLIGHT_PLUGIN_ABI */
  const char* name;    /* letters, digits, - _ . */
  const char* version; /* may be 0 */

  /* The claim: right wherever |distance| >= relative * (r0 + h0 + r1 + h1) + absolute. What is wrong beyond
   * it is a fault, what is wrong within it is only counted. */
  double claim_relative, claim_absolute;
  const char* claim_source; /* where you say so; may be 0 */

  /* Answers whether a and b meet, one of the words above. `more` is all NaN before: where you have them,
   * leave the signed distance in more[0] (negative: how deep), a direction square to a separating plane in
   * more[1..3], a common point in more[4..6] (not looked at where a solid is rounded); with no part of a direction
   * or point it is none. Called from one thread at a time. */
  int (*ask)(const double* a, const double* b, double more[7]);

  /* For timing, may be 0: `count` pairs of 16 doubles each (18 with rounding), a word for each. */
  void (*ask_all)(size_t count, const double* pairs, signed char* verdicts);

  /* All that follows is of interface 2, and may be 0. */

  /* Why the last call of `ask` declined or failed, in a few words. */
  const char* (*reason)(void);
  /* As `ask` about `count` pairs of 16 doubles each (18 with rounding), in one call: a word and seven doubles of
   * `more` for each. Must say what `ask` says. */
  void (*ask_many)(size_t count, const double* pairs, int* words, double* more);
  /* Another method of this library. */
  const struct DaylightMethod* next;
  /* 1: it takes rounding, and a cylinder is nine doubles wherever one is handed over. */
  int takes_rounding;
};

#ifdef __cplusplus
extern "C"
#endif
    const struct DaylightMethod*
    daylight_method(void);

#endif
