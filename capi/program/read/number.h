/* Decimal numbers as molecule files and command lines write them. */
#pragma once

#include <float.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum number_status {
  NUMBER_OK,
  NUMBER_SYNTAX,     /* not a decimal number: words, hexadecimal, a decimal comma, something left over */
  NUMBER_NOT_FINITE, /* nan, inf or infinity in any spelling */
  NUMBER_TOO_LARGE   /* a number too large for a double */
};

/* The double nearest to a decimal number. The whole of text[0 .. length) must be the number, without blanks around:
 *   [+-] digits [. digits] [(e|E|d|D) [+-] digits]     with at least one digit before the exponent.
 * Any number of digits is read, and rounded correctly. The locale has no influence. *value is set only on NUMBER_OK. */
enum number_status number_parse(const char *text, size_t length, double *value);

/* The same for the number times ten to a power, rounded only once, too. */
enum number_status number_parse_times(const char *text, size_t length, int power, double *value);

/* The same for a plain count: digits only, optionally after a '+'. NUMBER_TOO_LARGE if it exceeds a uint64_t. */
enum number_status number_parse_count(const char *text, size_t length, uint64_t *value);

/* The complaint, to stand behind the quoted text: "is not a number", ... */
const char *number_complaint(enum number_status status);

/* Neither NaN nor infinite. */
static inline bool is_finite(double value) {
  return value >= -DBL_MAX && value <= DBL_MAX;
}
