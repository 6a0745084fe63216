/* hardsphere/status.h: what functions return. */
#ifndef HARDSPHERE_STATUS_H
#define HARDSPHERE_STATUS_H

#include "export.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define HSP_OK 0                 /**< success */
#define HSP_E_ARGUMENT (-1)      /**< a null pointer, no live handle, an unknown option, or a bad struct_size */
#define HSP_E_CAPACITY (-2)      /**< an output array or a limit is too small; what suffices is reported */
#define HSP_E_MEMORY (-3)        /**< the memory is smaller than required */
#define HSP_E_STATE (-4)         /**< nothing computed, or the model or boundary behind it has changed since */
#define HSP_E_ID (-5)            /**< no ball, vertex, edge, quarter-edge, face, shell, cell or element has this id */
#define HSP_E_CHECK (-6)         /**< the self-check found a violated invariant: please report it */
#define HSP_E_SINK (-7)          /**< the caller's byte sink refused bytes */
#define HSP_E_NOT_FINITE (-10)   /**< a value is NaN or infinite */
#define HSP_E_NEGATIVE (-11)     /**< a radius, the probe or the step is negative */
#define HSP_E_RANGE (-12)        /**< a value lies beyond the lattice or the largest size */
#define HSP_E_CONFLICT (-13)     /**< balls and sticks that cannot be painted; which ones is reported */
#define HSP_E_OPEN_SURFACE (-14) /**< a degenerate set of balls, whose smooth surface does not close */

/** What stands above beside a status, for messages; never NULL, "unknown status" for numbers not listed above. */
HSP_API const char *hsp_status_text(int32_t status);

#ifdef __cplusplus
}
#endif

#endif
