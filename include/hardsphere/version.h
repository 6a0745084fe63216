/* hardsphere/version.h: the version of the header and of the library. */
#ifndef HARDSPHERE_VERSION_H
#define HARDSPHERE_VERSION_H

#include "export.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Version of this header: 10000 * major + 100 * minor + patch. */
#define HSP_VERSION_NUMBER 100

/** Version of the library that was linked, to be compared with HSP_VERSION_NUMBER. */
HSP_API uint32_t hsp_version(void);

#ifdef __cplusplus
}
#endif

#endif
