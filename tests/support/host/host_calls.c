#include "host_calls.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_environment.h"

static int which = -1;

void host_calls_choose(int environment) {
  which = environment;
}

/* The variable is read once; threads that are the first at the same time read the same. */
static int chosen(void) {
  if (which < 0) {
    const char *const name = getenv("HSP_HOST_ENVIRONMENT");
    int k = HOST_default;
    while (name != NULL && k < HOST_ENVIRONMENTS && strcmp(name, host_environment_name(k)) != 0) ++k;
    if (k == HOST_ENVIRONMENTS || !host_environment_exists(k)) {
      printf("skipped: no environment %s here\n", name);
      exit(77);
    }
    which = k;
  }
  return which;
}

void host_call_begins(host_call *call, const char *name) {
  static unsigned calls = 0;
  call->name = name;
  call->which = chosen();
  if (call->which == HOST_default) return;
  call->flag = calls++ % 2 == 0;
  fegetenv(&call->own);
  host_environment_set(call->which, call->flag);
}

void host_call_ends(const host_call *call) {
  const char *differs;
  if (call->which == HOST_default) return;
  differs = host_environment_differs(call->which, call->flag);
  fesetenv(&call->own);
  if (differs != NULL) {
    printf("%s in the environment %s: %s are not as before\n", call->name, host_environment_name(call->which), differs);
    exit(1);
  }
}
