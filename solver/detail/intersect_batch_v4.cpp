// SPDX-License-Identifier: MIT
// Compiled for x86-64-v4: see CMakeLists.txt.
#if defined(__x86_64__)
#define CYL_KERNEL batch_v4
#define CYL_LANES 8
#include "solver/detail/intersect_batch_kernel.hpp"
#endif
