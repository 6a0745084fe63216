/* The floating-point environments that programs call the library in: those that compilers' options make (-ffast-math,
 * -ffpe-trap), and rounding modes. */
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

enum {
  HOST_default,
  HOST_flushing, /* subnormal numbers are zero, as operands and as results */
  HOST_traps,    /* every exception ends the program, inexact results too */
  HOST_upward,
  HOST_downward,
  HOST_to_zero,
  HOST_ENVIRONMENTS
};

/* `flushing`, ... */
const char *host_environment_name(int which);

/* Whether this processor and this C library have it. */
int host_environment_exists(int which);

/* Sets it for the calling thread, with no exception flag set but that of overflow if `flag` is not 0 and none trap:
 * with traps a flag would end the program later. */
void host_environment_set(int which, int flag);

/* NULL, or what is not as host_environment_set has made it. */
const char *host_environment_differs(int which, int flag);

#ifdef __cplusplus
}
#endif
