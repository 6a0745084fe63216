/* Mean, standard deviation, least and most of several numbers that come together again and again, by Welford's
 * recurrence: sums of squares would lose the digits that a small deviation has. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct running_mean {
  size_t count;         /* of the numbers */
  uint64_t times;       /* that they came */
  double *mean;         /* [count] */
  double *deviation;    /* [count]: the sum of squares about the mean, until they are finished */
  double *least, *most; /* [count] */
};

/* False: memory is short. Free it on true and on false. */
bool running_mean_make(struct running_mean *running, size_t count);

void running_mean_add(struct running_mean *running, const double *numbers);

/* Deviations are those of a sample, with times - 1 in the denominator; NaN of a single one. */
void running_mean_finish(struct running_mean *running);

void running_mean_free(struct running_mean *running);
