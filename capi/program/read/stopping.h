/* Ends of a run before its work is done: Ctrl-C, and a time that is over. The library asks; so do loops that read and
 * those over files. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "hardsphere.h"
#include "read/failure.h"

/* As shells have it of a program that SIGINT ended, and as timeout(1). */
#define EXIT_INTERRUPTED 130
#define EXIT_TIME_IS_OVER 124

/* From now on SIGINT stops the run. A signal that is ignored stays ignored. */
void stopping_by_interrupt(void);

/* So does the time in seconds, if it is above 0. */
void stopping_after(double seconds);

/* Of a handler of SIGINT: notes it. False if that was done before, as a second one is not to wait. */
bool stopping_note(void);

/* Whether the run is to stop. */
bool stopping_asked(void);

/* For all that computes by the calling thread alone. */
const hsp_executor *stopping_executor(void);

/* proceed of an executor. */
int32_t stopping_proceed(void *context);

/* Why the run stops, instead of what failed as it did. */
void stopping_is_why(struct failure *failure);
