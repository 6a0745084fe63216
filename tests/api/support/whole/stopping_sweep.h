/* All computations that ask whether to go on (hsp_executor.proceed), stopped at their questions. */
#pragma once

#include <stdint.h>

enum { STOPPING_SETS = 40 };

/* Sweeps over the sets number `first` to `last` - 1, of 300 balls and of 50. */
void stopping_sweep(uint32_t first, uint32_t last);
