/* Every call of the interface that a program makes, in another floating-point environment than the program's own. The
 * program is linked with wrapped_calls.c and the options of hsp_in_host_environments (CMakeLists.txt). It runs as it
 * is; its calls run in the environment that the variable HSP_HOST_ENVIRONMENT of the process names. A call that does
 * not put it back, with its flags, ends the program. */
#pragma once

#include <fenv.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct host_call {
  const char *name;
  int which, flag;
  fenv_t own;
} host_call;

/* The program's own environment comes back when the call has ended. */
void host_call_begins(host_call *call, const char *name);
void host_call_ends(const host_call *call);

/* From now on calls are made in this one instead, which exists. */
void host_calls_choose(int environment);

#ifdef __cplusplus
}
#endif
