#include "check.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* The number of failures that are printed: more would only hide the first reasons. */
enum { FAILURES_SHOWN = 25 };

static long checks_made;
static long checks_failed;
static char scene[256];

void check_scene(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(scene, sizeof scene, format, arguments);
  va_end(arguments);
}

static int record(int holds) {
  ++checks_made;
  if (holds) return 1;
  ++checks_failed;
  return 0;
}

static int shown(const char *text, const char *file, int line) {
  if (checks_failed > FAILURES_SHOWN) return 0;
  printf("%s:%d: %s", file, line, text);
  if (scene[0] != '\0') printf(" [%s]", scene);
  return 1;
}

int check_true(int holds, const char *text, const char *file, int line) {
  if (record(holds)) return 1;
  if (shown(text, file, line)) printf("\n");
  return 0;
}

int check_equal(long long actual, long long expected, const char *text, const char *file, int line) {
  if (record(actual == expected)) return 1;
  if (shown(text, file, line)) printf(": %lld, expected %lld\n", actual, expected);
  return 0;
}

int check_near(double actual, double expected, double tolerance, const char *text, const char *file, int line) {
  const double difference = fabs(actual - expected);
  if (record(difference <= tolerance)) return 1;
  if (shown(text, file, line)) {
    printf(": %.17g, expected %.17g, off by %.3g > %.3g\n", actual, expected, difference, tolerance);
  }
  return 0;
}

int check_bytes(const void *actual, const void *expected, size_t bytes, const char *text, const char *file, int line) {
  size_t at = 0;
  const unsigned char *a = actual;
  const unsigned char *b = expected;
  if (record(bytes == 0 || memcmp(actual, expected, bytes) == 0)) return 1;
  while (a[at] == b[at]) ++at;
  if (shown(text, file, line)) printf(": byte %zu of %zu differs\n", at, bytes);
  return 0;
}

int check_report(void) {
  if (checks_failed > FAILURES_SHOWN) printf("... and %ld more\n", checks_failed - FAILURES_SHOWN);
  printf("%ld checks, %ld failed\n", checks_made, checks_failed);
  return checks_failed == 0 && checks_made > 0 ? 0 : 1;
}
