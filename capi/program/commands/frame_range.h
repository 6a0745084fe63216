/* Which frames of a trajectory are looked at: --frames, --begin, --end and --interval. */
#pragma once

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"

/* The frames first, first + step, .. up to last, counted from 1; of these, by time, the ones from begin to end, and of
 * these the first one in each interval from the first one's time on. */
struct frame_range {
  uint64_t first, last, step;
  double begin, end;
  double interval; /* 0: all of them */
};

#define FRAME_RANGE_ALL \
  { 1, UINT64_MAX, 1, -HUGE_VAL, HUGE_VAL, 0.0 }

/* How far a trajectory has got. Zeros at first. */
struct frame_clock {
  bool begun;
  double first; /* the time of the first frame that was taken */
  double due;   /* the number of the interval that the next one is in, at least */
};

/* "A:B:S", of which each may be missing, or "A" for one frame. False: it is none, and the failure says so. */
bool frame_range_parse(struct frame_range *range, const char *text, struct failure *failure);

bool frame_range_has(const struct frame_range *range, uint64_t number);

/* Whether times are asked for. */
bool frame_range_has_times(const struct frame_range *range);

/* Whether a frame of that time, the next one that frame_range_has, is taken. */
bool frame_clock_takes(struct frame_clock *clock, const struct frame_range *range, double time);
