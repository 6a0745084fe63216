/* hsp_status_text for every documented status and for every other number. */
#include <hardsphere.h>
#include <limits.h>
#include <string.h>

#include "check.h"

static const int32_t documented[] = {HSP_OK,           HSP_E_ARGUMENT, HSP_E_CAPACITY, HSP_E_MEMORY,   HSP_E_STATE,
                                     HSP_E_ID,         HSP_E_CHECK,    HSP_E_SINK,     HSP_E_HANDLE,   HSP_E_VERSION,
                                     HSP_E_NOT_FINITE, HSP_E_NEGATIVE, HSP_E_RANGE,    HSP_E_CONFLICT, HSP_E_EXECUTOR,
                                     HSP_E_DEGENERATE, HSP_E_STOPPED,  HSP_E_DAMAGED};
enum { DOCUMENTED = sizeof documented / sizeof documented[0] };

static int is_documented(int32_t status) {
  size_t i;
  for (i = 0; i < DOCUMENTED; ++i) {
    if (documented[i] == status) return 1;
  }
  return 0;
}

int main(void) {
  static const int32_t far[] = {INT32_MIN, INT32_MIN + 1, -65536, 65536, INT32_MAX};
  size_t i, j;
  int32_t status;
  for (i = 0; i < DOCUMENTED; ++i) {
    const char *text = hsp_status_text(documented[i]);
    check_scene("status %d", (int)documented[i]);
    if (!CHECK(text != NULL)) continue;
    CHECK(strlen(text) > 0 && strlen(text) < 80);
    CHECK(strcmp(text, "unknown status") != 0);
    CHECK(hsp_status_text(documented[i]) == text || strcmp(hsp_status_text(documented[i]), text) == 0);
    for (j = 0; j < i; ++j) CHECK(strcmp(text, hsp_status_text(documented[j])) != 0);
    CHECK(documented[i] <= 0);
  }
  for (status = -300; status <= 300; ++status) {
    if (is_documented(status)) continue;
    check_scene("status %d", (int)status);
    if (CHECK(hsp_status_text(status) != NULL)) CHECK(strcmp(hsp_status_text(status), "unknown status") == 0);
  }
  for (i = 0; i < sizeof far / sizeof far[0]; ++i) {
    check_scene("status %d", (int)far[i]);
    if (CHECK(hsp_status_text(far[i]) != NULL)) CHECK(strcmp(hsp_status_text(far[i]), "unknown status") == 0);
  }
  return check_report();
}
