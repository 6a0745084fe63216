/* A law is a C function that tries one rule on one function of the registry. */
#pragma once

#include "call.h"
#include "check.h"

/* capacity: as much room for records as the base arguments need */
typedef void (*law)(const function *f, uint32_t capacity);

/* Tries a law on all functions. */
void try_law(law try_it);

/* The same: what main returns. 77, after a line that says why, where there is no fenced memory. */
int check_law(law try_it);

/* Runs a call and checks what holds of every call. `what` and `whose` say what is odd about its arguments. */
void law_run(call *c, const char *what, const char *whose);

/* Runs a call that has to be refused with this status. It may write only the output that tells the reason, and outputs
 * whose names are in `but`: "|name|name|". If the status is HSP_E_HANDLE it may not write the reason either. */
void law_refused(call *c, const char *what, const char *whose, int32_t status, const char *but);

/* Runs a call that has to succeed. */
void law_succeeds(call *c, const char *what, const char *whose);
