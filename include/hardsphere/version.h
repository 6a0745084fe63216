/* hardsphere/version.h: the versions of the header and of the library, and the rule for comparing them.
 *
 * Guide: guarantees.md.
 *
 * Stable: from version 1.0 on this stays as it is, and is only added to.
 *
 * Five numbers, each as a macro of the header and as a function of the library that was linked:
 *   version      what the library offers. A larger version has all that a smaller one of the same ABI number has.
 *   ABI          the binary interface of the stable headers (TIERS in hardsphere.h). It is raised when a released
 *                function, constant or struct of a stable header changes or goes, and stays when something is added.
 *   provisional  the same for all other headers.
 *   numerics     the bits of the results of stable functions. Two libraries of one numerics number give the same bits
 *                for the same calls, on every machine; the number is raised with the first release in which a last bit
 *                of any of these results may differ. Structure (ids, order, counts and flags) changes from 1.0 on with
 *                the major version alone, unless it was wrong or a header makes an exception (topology.h, model.h).
 *   provisional numerics  the same for the results of all other functions.
 * A program may run with a library if
 *   hsp_abi() == HSP_ABI_NUMBER && hsp_version() >= HSP_VERSION_NUMBER
 * and, if it uses anything of a provisional header, hsp_provisional() == HSP_PROVISIONAL_NUMBER. If hsp_numerics() ==
 * HSP_NUMERICS_NUMBER as well, stable functions give the program the bits that it was tested with; provisional
 * functions do if hsp_provisional_numerics() == HSP_PROVISIONAL_NUMERICS_NUMBER. capi/abi/README.md says what may
 * change with which number. Cost: O(1). */
#ifndef HARDSPHERE_VERSION_H
#define HARDSPHERE_VERSION_H

#include "export.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define HSP_VERSION_MAJOR 1        /**< raised when a stable header changes or loses something */
#define HSP_VERSION_MINOR 1        /**< raised when something is added, or a provisional header changes */
#define HSP_VERSION_PATCH 0        /**< raised when only mistakes were mended */
#define HSP_VERSION_STRING "1.1.0" /**< the three of them */

/** Version of this header: 10000 * major + 100 * minor + patch. */
#define HSP_VERSION_NUMBER (10000 * HSP_VERSION_MAJOR + 100 * HSP_VERSION_MINOR + HSP_VERSION_PATCH)

/** The binary interface that stable headers describe; the shared library's file name ends with it. */
#define HSP_ABI_NUMBER 2

/** The binary interface that provisional headers describe. */
#define HSP_PROVISIONAL_NUMBER 2

/** The bits of the results that stable functions of the library of this header give. */
#define HSP_NUMERICS_NUMBER 3

/** The bits of the results that provisional functions of the library of this header give. */
#define HSP_PROVISIONAL_NUMERICS_NUMBER 4

/** HSP_VERSION_NUMBER of the library that was linked. */
HSP_API uint32_t HSP_CALL hsp_version(void);

/** HSP_ABI_NUMBER of the library that was linked. */
HSP_API uint32_t HSP_CALL hsp_abi(void);

/** HSP_PROVISIONAL_NUMBER of the library that was linked. */
HSP_API uint32_t HSP_CALL hsp_provisional(void);

/** HSP_NUMERICS_NUMBER of the library that was linked. */
HSP_API uint32_t HSP_CALL hsp_numerics(void);

/** HSP_PROVISIONAL_NUMERICS_NUMBER of the library that was linked. */
HSP_API uint32_t HSP_CALL hsp_provisional_numerics(void);

#ifdef __cplusplus
}
#endif

#endif
