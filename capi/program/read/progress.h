/* The progress of long work, for a person who watches: one line on a terminal's stderr that vanishes at the end. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* Less work is too short to be watched. */
#define PROGRESS_LEAST_BALLS 20001
#define PROGRESS_LEAST_BYTES 2000000

struct progress {
  bool watched;
};

/* From now on no further work is watched: several threads are about to start. */
void progress_be_quiet(void);

/* Work of this amount is watched if it is `least` or more, and stderr is a terminal. */
struct progress progress_begin(uint64_t amount, uint64_t least);

/* Replace the line. */
void progress_show(const struct progress *progress, const char *text);

/* The same with a number of megabytes behind the text. */
void progress_show_bytes(const struct progress *progress, const char *text, uint64_t bytes);

/* Take the line away: before the results, and before a failure is reported. */
void progress_end(const struct progress *progress);
