// SPDX-License-Identifier: MIT
#define CYL_KERNEL batch_baseline
#define CYL_DECIDE_KERNEL decide_baseline
#define CYL_LANES 2
#include "solver/detail/decide_batch_kernel.hpp"
