/* Outputs filled with a pattern, to see that a failing call leaves them alone. */
#pragma once

#include <string.h>

#include "check.h"

#define FILL(object) memset(&(object), 0xA5, sizeof(object))
#define CHECK_UNTOUCHED(object)                                \
  do {                                                         \
    unsigned char untouched_pattern[sizeof(object)];           \
    memset(untouched_pattern, 0xA5, sizeof(object));           \
    CHECK_BYTES(&(object), untouched_pattern, sizeof(object)); \
  } while (0)
