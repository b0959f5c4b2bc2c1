// SPDX-License-Identifier: MIT
#define CYL_KERNEL batch_baseline
#define CYL_LANES 2
#include "solver/detail/intersect_batch_kernel.hpp"
