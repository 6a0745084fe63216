/* hardsphere/executor.h: how the caller's own threads share the work, and how the caller stops it.
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

/** Does one task of the library's: `data` is what hsp_executor.run was handed, `task` the number of the task. */
typedef void HSP_CALL hsp_task(void *data, uint32_t task);

/** A parallel loop of the caller's, as OpenMP, TBB or a pool of threads has it; the library starts no threads itself. A
 *  function that is given an executor shares its work out where there is enough of it. Otherwise, as with NULL or with
 *  workers 0 or 1, it works in the caller's thread. Results are the same bits either way and for any number of workers;
 *  the cost that a function states is that of all workers together. Output arrays are final only when the function
 *  returns: a later task may change what an earlier one wrote.
 *  If the loop fails, leaves a task out, or calls one twice or one that does not exist, the function returns
 *  HSP_E_EXECUTOR: it has no results then, and all handles may be used as before. A task that is called twice is done
 *  once. A function that is stopped returns HSP_E_STOPPED, and the same holds of results and handles. */
typedef struct hsp_executor {
  uint32_t struct_size; /**< sizeof(hsp_executor) */
  uint32_t workers;     /**< how many threads there are for the tasks */
  void *context;        /**< or NULL: handed to run and proceed */
  /** Calls task(data, 0) to task(data, tasks - 1), each once, in any order and on any threads that have 16 KiB of stack
   *  left for it, and what proceed takes. So a thread of 24 KiB suffices, where the system's own part is less than 8.
   *  Returns 0 when all have returned, or anything else if it could not call them all. By then everything that
   *  tasks wrote must be visible to the caller's thread, as after a join. tasks may be larger than workers, and is at
   *  most HSP_MAX_WORKERS. Must not be NULL with more than one worker. The loop runs in the caller's floating-point
   *  environment, and tasks in the library's, whatever that of their thread is (FLOATING POINT in hardsphere.h). */
  int32_t(HSP_CALL *run)(void *context, uint32_t tasks, hsp_task *task, void *data);
  /** NULL, or says whether to go on: returns 0 to go on, anything else to stop. It is called with workers 0 or 1, too.
   *  The library calls it between balls and stages of the work, from the caller's thread and from those of tasks,
   *  several at a time, with a copy of the caller's floating-point environment. A library that is compiled for size
   *  never calls it. It must not call functions with the handles of the function that calls it. Of molecules of up to
   *  10,000 balls fewer than 10 million instructions lie between two calls, as a rule one million; where many balls tie
   *  in one place there may be more. Functions without an executor in their request or options never call it. Each
   *  function that computes has a sibling that does (splitting_the_work.md lists them). Exceptions are poses, of which
   *  a caller can ask for fewer at a time, and functions that measure, check or copy results: these take up to 4,000
   *  instructions a ball, self-checks more. */
  int32_t(HSP_CALL *proceed)(void *context);
} hsp_executor;

#ifdef __cplusplus
}
#endif

#endif
