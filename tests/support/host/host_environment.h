/* Floating-point environments in which programs may call the library: those that compilers' options set up
 * (-ffast-math, -ffpe-trap), and rounding modes. */
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

/* Sets the environment for the calling thread. No exception flag is set but that of overflow, and this one only if
 * `flag` is not 0 and the environment has no traps: with traps a flag would end the program later. */
void host_environment_set(int which, int flag);

/* NULL, or the name of what differs from the environment that host_environment_set makes. */
const char *host_environment_differs(int which, int flag);

#ifdef __cplusplus
}
#endif
