/* Checks for test programs in plain C99: a failed check is printed with file and line and counted, and the program goes
 * on. Each program ends with `return check_report();`. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* A name for what is being checked, printed with every failure until it is replaced. */
void check_scene(const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 1, 2)))
#endif
    ;

int check_true(int holds, const char *text, const char *file, int line);
int check_equal(long long actual, long long expected, const char *text, const char *file, int line);
int check_near(double actual, double expected, double tolerance, const char *text, const char *file, int line);
int check_bytes(const void *actual, const void *expected, size_t bytes, const char *text, const char *file, int line);

/* Prints how many checks were made and failed. 0 if all held and there was at least one, else 1. */
int check_report(void);

/* A request or outputs with these fields; all others are 0. */
#define SIZED(type, ...)                     \
  &(type) {                                  \
    .struct_size = sizeof(type), __VA_ARGS__ \
  }

#define CHECK(condition) check_true((condition) != 0, #condition, __FILE__, __LINE__)
#define CHECK_EQUAL(actual, expected) \
  check_equal((long long)(actual), (long long)(expected), #actual " == " #expected, __FILE__, __LINE__)
/* |actual - expected| <= tolerance; false for NaN. */
#define CHECK_NEAR(actual, expected, tolerance) \
  check_near((actual), (expected), (tolerance), #actual " near " #expected, __FILE__, __LINE__)
/* The same bytes, which for doubles is stricter than ==. */
#define CHECK_BYTES(actual, expected, bytes) \
  check_bytes((actual), (expected), (bytes), #actual " same bytes as " #expected, __FILE__, __LINE__)
