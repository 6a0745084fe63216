/* Makes every call of the interface in another floating-point environment than the program's own. The program is linked
 * with wrapped_calls.c and the options of hsp_in_host_environments (CMakeLists.txt). The program itself runs in its own
 * environment; its calls run in the environment that the process's variable HSP_HOST_ENVIRONMENT names. A call that
 * returns with another environment, or other exception flags, than it was entered with ends the program. */
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

/* From here on calls are made in this environment, which must exist on this processor. */
void host_calls_choose(int environment);

#ifdef __cplusplus
}
#endif
