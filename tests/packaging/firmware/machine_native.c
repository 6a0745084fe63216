/* This machine, for the digits that others are compared with. */
#include <stdio.h>

#include "machine.h"

static unsigned char pool[1 << 22];

unsigned char *machine_pool(void) {
  return pool;
}

size_t machine_pool_bytes(void) {
  return sizeof pool;
}

void machine_print(const char *text) {
  fputs(text, stdout);
}

void machine_begin(void) {}

int machine_cost(uint32_t cost[2]) {
  (void)cost;
  return 0;
}

int machine_may_retry(void) {
  return 1;
}
