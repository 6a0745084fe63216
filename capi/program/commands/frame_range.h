/* The choice of frames of a trajectory: --frames, --begin, --end and --interval. */
#pragma once

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"

/* The frames first, first + step, .. up to last, counted from 1; of these the ones with times from begin to end; and of
 * these the first one in each interval, counted from the time of the first one. */
struct frame_range {
  uint64_t first, last, step;
  double begin, end;
  double interval; /* 0: all frames */
};

#define FRAME_RANGE_ALL \
  { 1, UINT64_MAX, 1, -HUGE_VAL, HUGE_VAL, 0.0 }

/* How far a trajectory has got. Zeros at first. */
struct frame_clock {
  bool begun;
  double first; /* the time of the first frame that was taken */
  double due;   /* the next one must be in the interval of this number, or in a later one */
};

/* Read "A:B:S", each of which may be missing, or "A" for one frame. False: the text is no such range, and the failure
 * says so. */
bool frame_range_parse(struct frame_range *range, const char *text, struct failure *failure);

bool frame_range_has(const struct frame_range *range, uint64_t number);

/* Whether times are asked for. */
bool frame_range_has_times(const struct frame_range *range);

/* Whether the next frame with frame_range_has is taken, if this is its time. */
bool frame_clock_takes(struct frame_clock *clock, const struct frame_range *range, double time);
