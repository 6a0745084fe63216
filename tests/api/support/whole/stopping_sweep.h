/* All that asks whether to go on, stopped at its questions. */
#pragma once

#include <stdint.h>

enum { STOPPING_SETS = 40 };

/* Of the sets number `first` to `last` - 1, of 300 balls and of 50. */
void stopping_sweep(uint32_t first, uint32_t last);
