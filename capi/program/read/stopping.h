/* The end of a run before its work is done: by Ctrl-C, or because its time is over. The library asks whether to go on,
 * and so do the loops that read and those over files. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "hardsphere.h"
#include "read/failure.h"

/* The values that shells use for a program ended by SIGINT, and timeout(1) for one whose time is over. */
#define EXIT_INTERRUPTED 130
#define EXIT_TIME_IS_OVER 124

/* From now on SIGINT stops the run. A signal that is ignored stays ignored. */
void stopping_by_interrupt(void);

/* From now on the run stops after that many seconds, if they are above 0. */
void stopping_after(double seconds);

/* For a handler of SIGINT: notes the signal. False if one was noted before: at the second the run ends at once. */
bool stopping_note(void);

/* Whether the run is to stop. */
bool stopping_asked(void);

/* The executor for all work that only the calling thread does. */
const hsp_executor *stopping_executor(void);

/* proceed of an executor. */
int32_t stopping_proceed(void *context);

/* Replace the failure by the reason why the run stops. */
void stopping_is_why(struct failure *failure);
