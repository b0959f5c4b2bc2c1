// SPDX-License-Identifier: MIT
// Compiled for x86-64-v3: see CMakeLists.txt.
#if defined(__x86_64__)
#define CYL_KERNEL batch_v3
#define CYL_LANES 4
#include "solver/detail/intersect_batch_kernel.hpp"
#endif
