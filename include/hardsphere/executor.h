/* hardsphere/executor.h: threads of the caller's own. The library starts none.
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
typedef void hsp_task(void *data, uint32_t task);

/** A parallel loop of the caller's, as OpenMP, TBB or a pool of threads has it. A function that is given one may share
 *  its work out; results are the same bits for any number of workers. NULL instead of an executor, and workers 0 or 1,
 *  are the caller's thread. */
typedef struct hsp_executor {
  uint32_t struct_size; /**< sizeof(hsp_executor) */
  uint32_t workers;     /**< how many threads there are for the tasks */
  void *context;        /**< or NULL: handed to run */
  /** Calls task(data, 0) to task(data, tasks - 1), each once, in any order and on any threads, and returns when all
   *  have returned. Not NULL with more than one worker. */
  void (*run)(void *context, uint32_t tasks, hsp_task *task, void *data);
} hsp_executor;

#ifdef __cplusplus
}
#endif

#endif
