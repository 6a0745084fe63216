/* The reason why the program gives up: one line for stderr and an exit status. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#define EXIT_BAD_INPUT 1 /* the input, or a resource, is at fault */
#define EXIT_BAD_USAGE 2 /* the command line is at fault */

struct failure {
  int exit_status;  /* 0 as long as nothing failed */
  const char *file; /* the file at fault, or NULL; not owned */
  uint64_t line;    /* its line, counted from 1; 0 where no line applies */
  char reason[512];
  bool of_memory; /* whether it is that memory is short */
};
#define FAILURE_NONE \
  { 0, NULL, 0, "", false }

/* Marks functions that are seldom called. They are not inlined, so that their callers save fewer registers. */
#ifdef __GNUC__
#define SELDOM __attribute__((noinline))
#else
#define SELDOM
#endif

#ifdef __GNUC__
#if defined(__MINGW_PRINTF_FORMAT) /* of C99, which the header of C knows */
#define FAILURE_FORMAT(text, first) __attribute__((format(__MINGW_PRINTF_FORMAT, text, first)))
#else
#define FAILURE_FORMAT(text, first) __attribute__((format(printf, text, first)))
#endif
#else
#define FAILURE_FORMAT(text, first)
#endif

/* Record a fault of the input at a line (0: none). Always false, so that callers can return it. */
bool failure_in_input(struct failure *failure, uint64_t line, const char *format, ...) FAILURE_FORMAT(3, 4);

/* Record a fault of the command line. Always false. */
bool failure_in_usage(struct failure *failure, const char *format, ...) FAILURE_FORMAT(2, 3);

/* A rule of usage: whether it is broken, and the text for that. */
struct usage_rule {
  bool broken;
  const char *reason;
};

/* False if a rule is broken; the failure has the text of the first broken one. */
bool usage_rules_hold(const struct usage_rule *rule, size_t count, struct failure *failure);

/* Record that memory is short. Always false. */
bool failure_of_memory(struct failure *failure);

/* "hardsphere: FILE:LINE: reason" on stderr, always exactly one line. */
void failure_print(const struct failure *failure);

/* Room for a piece of input as it is quoted in a reason. */
#define EXCERPT_BYTES 48

/* Copy text into out for quoting: shortened if it is long, bytes that would disturb a terminal replaced by '?'. */
const char *excerpt(char out[EXCERPT_BYTES], const char *text, size_t length);
