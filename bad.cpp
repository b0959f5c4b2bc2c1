#include <cstdlib>
#include "plugin.h"
static int ask(const double* a, const double*, double*) { return DAYLIGHT_DISJOINT; }
static const DaylightMethod bad{DAYLIGHT_PLUGIN_ABI, "bad", "1", 0, 0, 0, ask, 0};
const DaylightMethod* daylight_method() { return &bad; }
