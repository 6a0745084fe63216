/* The versions of the header: what the preprocessor and the library say of them, and how they fit together. */
#include <hardsphere.h>
#include <stdio.h>
#include <string.h>

#include "check.h"

#if HSP_VERSION_NUMBER < 200 || HSP_VERSION_NUMBER >= 1000000 || HSP_ABI_NUMBER < 1 || HSP_PROVISIONAL_NUMBER < 1 || \
    HSP_NUMERICS_NUMBER < 1 || HSP_PROVISIONAL_NUMERICS_NUMBER < 1
#error "the preprocessor cannot compare versions"
#endif

int main(void) {
  char text[40];
  snprintf(text, sizeof text, "%d.%d.%d", HSP_VERSION_MAJOR, HSP_VERSION_MINOR, HSP_VERSION_PATCH);
  CHECK(strcmp(text, HSP_VERSION_STRING) == 0);
  CHECK(HSP_VERSION_MINOR < 100 && HSP_VERSION_PATCH < 100);
  CHECK_EQUAL(hsp_version(), HSP_VERSION_NUMBER);
  CHECK_EQUAL(hsp_version() / 10000, HSP_VERSION_MAJOR);
  CHECK_EQUAL(hsp_version() / 100 % 100, HSP_VERSION_MINOR);
  CHECK_EQUAL(hsp_version() % 100, HSP_VERSION_PATCH);
  CHECK_EQUAL(hsp_abi(), HSP_ABI_NUMBER);
  CHECK_EQUAL(hsp_provisional(), HSP_PROVISIONAL_NUMBER);
  CHECK_EQUAL(hsp_numerics(), HSP_NUMERICS_NUMBER);
  CHECK_EQUAL(hsp_provisional_numerics(), HSP_PROVISIONAL_NUMERICS_NUMBER);
  return check_report();
}
