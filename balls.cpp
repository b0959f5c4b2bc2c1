#include <cmath>
#include "plugin.h"
static int ask(const double* a, const double* b, double* more) {
  more[0] = std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2])) -
            (a[8] + b[8]);
  return more[0] > 0 ? DAYLIGHT_DISJOINT : DAYLIGHT_INTERSECTING;
}
static const DaylightMethod balls{DAYLIGHT_PLUGIN_ABI, "balls", "1", 1e-12, 0, 0, ask, 0, 0, 0, 0, 1};
const DaylightMethod* daylight_method() { return &balls; }
