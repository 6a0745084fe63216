/* hardsphere/status.h: what functions return.
 *
 * Guide: guarantees.md.
 *
 * Stable: from version 1.0 on this stays as it is, and is only added to. */
#ifndef HARDSPHERE_STATUS_H
#define HARDSPHERE_STATUS_H

#include "export.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* HSP_E_ARGUMENT is for single values: NULL where a pointer or a handle must be given, options that are not known, and
 * values that a function does not take. HSP_E_HANDLE is for pointers to anything but a live handle of their kind, and
 * HSP_E_VERSION for structs with struct_size: see MEMORY and STRUCTS in hardsphere.h. HSP_E_CHECK always means a fault
 * of the library; HSP_E_DEGENERATE never does. -14 is not used. */
#define HSP_OK 0               /**< success */
#define HSP_E_ARGUMENT (-1)    /**< a null pointer, an unknown option, or a value that is not allowed there */
#define HSP_E_CAPACITY (-2)    /**< an output array or a limit is too small; what suffices is reported */
#define HSP_E_MEMORY (-3)      /**< the memory is smaller than required */
#define HSP_E_STATE (-4)       /**< nothing there to read, continue or undo, or what it was made from has changed */
#define HSP_E_ID (-5)          /**< nothing has this id, number or name, or one is listed twice */
#define HSP_E_CHECK (-6)       /**< a violated invariant, or results that contradict each other: please report it */
#define HSP_E_SINK (-7)        /**< the caller's byte sink refused bytes */
#define HSP_E_HANDLE (-8)      /**< no live handle of this kind: overwritten, moved, or of another kind */
#define HSP_E_VERSION (-9)     /**< a bad struct_size, or more asked for than this version of the library knows */
#define HSP_E_NOT_FINITE (-10) /**< a value is NaN or infinite */
#define HSP_E_NEGATIVE (-11)   /**< a radius, the probe or another length is negative */
#define HSP_E_RANGE (-12)      /**< a value lies beyond the lattice or its range, or is no rotation or direction */
#define HSP_E_CONFLICT (-13)   /**< parts that do not fit together: sticks, bricks; which ones is reported */
#define HSP_E_EXECUTOR (-15)   /**< the caller's executor failed, or did not call every task exactly once */
#define HSP_E_DEGENERATE (-16) /**< ties or near ties of the input that could not be resolved */
#define HSP_E_STOPPED (-17)    /**< the caller's executor said not to go on */
#define HSP_E_DAMAGED (-18)    /**< bytes that are no result of this library, or not as they were written */

/** The meaning of a status in the words above, for messages: a constant text of the library's, never NULL; "unknown
 *  status" for numbers not listed above.
 *  Cost: O(1). */
HSP_API const char *HSP_CALL hsp_status_text(int32_t status);

#ifdef __cplusplus
}
#endif

#endif
