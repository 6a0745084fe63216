/* hardsphere/executor.h: threads of the caller's own, of which the library starts none; and a way to stop.
 *
 * Guide: splitting_the_work.md.
 *
 * Stable: from version 1.0 on this stays as it is, and is only added to. */
#ifndef HARDSPHERE_EXECUTOR_H
#define HARDSPHERE_EXECUTOR_H

#include "export.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A task of the library's, of which `data` is all that it knows. */
typedef void HSP_CALL hsp_task(void *data, uint32_t task);

/** A parallel loop of the caller's, as OpenMP, TBB or a pool of threads has it. A function that is given one shares its
 *  work out, where there is enough of it, and otherwise does it in the caller's thread, as with NULL or with workers 0
 *  or 1; results are the same bits either way and for any number of workers, and the cost that functions state is that
 *  of all workers together. Nothing is final before that function returns: tasks may write to output arrays what later
 *  ones still change.
 *  If the loop fails, leaves a task out, or calls one twice or one that does not exist, that function returns
 *  HSP_E_EXECUTOR: it has no results then, and all handles may be used as before. A task that is called twice is done
 *  once. A function that is stopped returns HSP_E_STOPPED, likewise. */
typedef struct hsp_executor {
  uint32_t struct_size; /**< sizeof(hsp_executor) */
  uint32_t workers;     /**< how many threads there are for the tasks */
  void *context;        /**< or NULL: handed to run and proceed */
  /** Calls task(data, 0) to task(data, tasks - 1), each once, in any order and on any threads with 16 KiB of stack or
   *  more, and returns 0 when all have returned, or anything else if it could not call them all. Their results must be
   *  visible to the caller's thread then, as after a join. tasks may be larger than workers, HSP_MAX_WORKERS at most.
   *  Not NULL with more than one worker. The loop runs in the caller's floating-point environment, and tasks in the
   *  library's, whatever that of their thread is (FLOATING POINT in hardsphere.h). */
  int32_t(HSP_CALL *run)(void *context, uint32_t tasks, hsp_task *task, void *data);
  /** NULL, or says whether to go on: 0 does, anything else stops. Also asked with workers 0 or 1. It is asked between
   *  balls and stages of the work, by the caller's thread and by those of tasks, several at a time, with a copy of the
   *  caller's floating-point environment; not by a library that is compiled for size. It must not call functions with
   *  the handles of the function that asks. Of molecules of up to 10,000 balls fewer than 10 million instructions lie
   *  between two questions, as a rule one million; where many balls tie in one place there may be more. Functions
   *  without an executor in their request or options do not ask. Those that compute have a sibling that does
   *  (splitting_the_work.md lists them), but for poses, which may be asked for less at a time, and for what measures,
   *  checks or copies what was computed: up to 4,000 instructions a ball, and more for self-checks. */
  int32_t(HSP_CALL *proceed)(void *context);
} hsp_executor;

#ifdef __cplusplus
}
#endif

#endif
