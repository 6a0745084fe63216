/* hardsphere/export.h: what makes a function visible. */
#ifndef HARDSPHERE_EXPORT_H
#define HARDSPHERE_EXPORT_H

/* The mark before every function. Building the shared library defines HSP_BUILD_SHARED: the functions of this header
 * are what it exports. Nothing has to be defined to use either library. */
#ifndef HSP_API
#ifdef HSP_BUILD_SHARED
#define HSP_API __attribute__((visibility("default")))
#else
#define HSP_API
#endif
#endif

#endif
