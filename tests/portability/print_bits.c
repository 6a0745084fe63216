#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "interface_bits.h"

void print_doubles(const double *value, uint32_t count) {
  uint32_t i;
  for (i = 0; i < count; ++i) {
    uint64_t bits;
    memcpy(&bits, &value[i], sizeof bits);
    printf(" %016" PRIx64, bits);
  }
}

void print_numbers(const uint32_t *number, uint32_t count) {
  uint32_t i;
  for (i = 0; i < count; ++i) printf(" %" PRIu32, number[i]);
}

void end_line(void) {
  printf("\n");
}

static int failures;

void print_status(const char *what, int32_t status) {
  if (status != HSP_OK) ++failures;
  printf("%s %" PRId32, what, status);
}

int all_succeeded(void) {
  return failures == 0;
}
