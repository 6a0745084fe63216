#include "commands/running_mean.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool running_mean_make(struct running_mean *running, size_t count) {
  double *const all = calloc(4 * count + 1, sizeof *all);
  *running = (struct running_mean){.count = count, .mean = all};
  if (all == NULL) return false;
  running->deviation = all + count;
  running->least = all + 2 * count;
  running->most = all + 3 * count;
  return true;
}

void running_mean_add(struct running_mean *running, const double *numbers) {
  const bool first = running->times == 0;
  const double times = (double)++running->times;
  for (size_t k = 0; k < running->count; ++k) {
    const double number = numbers[k], before = number - running->mean[k];
    running->mean[k] += before / times;
    running->deviation[k] += before * (number - running->mean[k]);
    if (first || number < running->least[k]) running->least[k] = number;
    if (first || number > running->most[k]) running->most[k] = number;
  }
}

void running_mean_finish(struct running_mean *running) {
  const double degrees = (double)running->times - 1.0;
  for (size_t k = 0; k < running->count; ++k) {
    running->deviation[k] = degrees > 0.0 ? sqrt(running->deviation[k] / degrees) : (double)NAN;
  }
}

void running_mean_free(struct running_mean *running) {
  free(running->mean);
  memset(running, 0, sizeof *running);
}
