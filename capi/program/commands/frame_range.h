/* Which frames of a trajectory are looked at: --frames. */
#ifndef HARDSPHERE_TOOL_FRAME_RANGE_H
#define HARDSPHERE_TOOL_FRAME_RANGE_H

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"

/* The frames first, first + step, .. up to last, counted from 1. */
struct frame_range {
  uint64_t first, last, step;
};

#define FRAME_RANGE_ALL \
  { 1, UINT64_MAX, 1 }

/* "A:B:S", of which each may be missing, or "A" for one frame. False: it is none, and the failure says so. */
bool frame_range_parse(struct frame_range *range, const char *text, struct failure *failure);

bool frame_range_has(const struct frame_range *range, uint64_t number);

#endif
