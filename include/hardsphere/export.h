/* hardsphere/export.h: what makes a function visible, and how it is called. */
#ifndef HARDSPHERE_EXPORT_H
#define HARDSPHERE_EXPORT_H

/* The mark before every function. Building the shared library defines HSP_BUILD_SHARED: the functions of this header
 * are what it exports. Nothing has to be defined to use either library; a program for Windows that loads the DLL may
 * define HSP_USE_SHARED, as the CMake package does, which saves a jump in each call. */
#ifndef HSP_API
#if defined(HSP_BUILD_SHARED) && defined(_WIN32)
#define HSP_API __declspec(dllexport)
#elif defined(HSP_BUILD_SHARED)
#define HSP_API __attribute__((visibility("default")))
#elif defined(HSP_USE_SHARED) && defined(_WIN32)
#define HSP_API __declspec(dllimport)
#else
#define HSP_API
#endif
#endif

/* The calling convention of every function, and of every function of the caller's that the library calls: that of C. */
#ifndef HSP_CALL
#define HSP_CALL
#endif

#endif
