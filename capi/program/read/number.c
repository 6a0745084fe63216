#include "read/number.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>

#include "read/characters.h"

/* No double, and no midpoint between two doubles, has more than 768 significant decimal digits (the subnormals' last
 * midpoint has as many). So it is enough to keep this many digits of a longer number, and one more that says whether
 * any dropped digit is not 0: the result is rounded as if all digits had been read. */
#define KEPT_DIGITS 800

/* Exponents are held between these: both lie far outside what the digits of a file can make up for. */
#define EXPONENT_LIMIT INT64_C(1000000000000000)

/* Numbers as files write them have few digits: digits and power of ten are doubles then, and one operation rounds
 * once. Not where the machine keeps more precision than a double has. */
enum { MOST_DIGITS = 18, SMALL_EXPONENT = 22 };
#define EXACT_DIGITS (UINT64_C(1) << 53)

static bool quick_value(uint64_t digits, int exponent, double *value) {
  static const double powers[SMALL_EXPONENT + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  if (FLT_EVAL_METHOD != 0 || digits > EXACT_DIGITS) return false;
  if (digits == 0) exponent = 0;
  if (exponent < -SMALL_EXPONENT || exponent > SMALL_EXPONENT) return false;
  *value = exponent < 0 ? (double)digits / powers[-exponent] : (double)digits * powers[exponent];
  return true;
}

/* A decimal of at most 18 digits without an exponent, times a power of ten. False: it is another one, or none. */
static bool parse_quickly(const char *text, size_t length, int power, double *value) {
  const bool negative = length > 0 && text[0] == '-';
  uint64_t digits = 0;
  size_t at = negative ? 1 : 0, whole = 0, decimals = 0;
  if (length > MOST_DIGITS + 2) return false;
  for (; at < length && is_digit(text[at]); ++at, ++whole) digits = 10 * digits + (uint64_t)(text[at] - '0');
  if (at < length && text[at] == '.') {
    for (++at; at < length && is_digit(text[at]); ++at, ++decimals) digits = 10 * digits + (uint64_t)(text[at] - '0');
  }
  if (at < length || whole + decimals == 0 || whole + decimals > MOST_DIGITS) return false;
  if (!quick_value(digits, power - (int)decimals, value)) return false;
  if (negative) *value = -*value;
  return true;
}

static bool matches(const char *text, size_t length, const char *word) {
  size_t i = 0;
  while (i < length && word[i] != '\0' && to_lower(text[i]) == word[i]) ++i;
  return i == length && word[i] == '\0';
}

/* Text that is no decimal number: distinguish the names of NaN and infinity from other words. */
static enum number_status classify(const char *text, size_t length) {
  if (length > 0 && (text[0] == '+' || text[0] == '-')) ++text, --length;
  const bool not_finite =
      matches(text, length, "nan") || matches(text, length, "inf") || matches(text, length, "infinity");
  return not_finite ? NUMBER_NOT_FINITE : NUMBER_SYNTAX;
}

/* Read "e12", "D-3" and so on from text[*at]; false if what stands there is no exponent. */
static bool parse_exponent(const char *text, size_t length, size_t *at, int64_t *exponent) {
  size_t i = *at;
  const char mark = to_lower(text[i]);
  if (mark != 'e' && mark != 'd') return false;
  ++i;
  const bool negative = i < length && text[i] == '-';
  if (i < length && (text[i] == '+' || text[i] == '-')) ++i;
  if (i == length || !is_digit(text[i])) return false;
  int64_t value = 0;
  for (; i < length && is_digit(text[i]); ++i) {
    if (value < EXPONENT_LIMIT) value = 10 * value + (text[i] - '0');
  }
  *exponent += negative ? -value : value;
  *at = i;
  return true;
}

enum number_status number_parse(const char *text, size_t length, double *value) {
  return number_parse_times(text, length, 0, value);
}

enum number_status number_parse_times(const char *text, size_t length, int power, double *value) {
  if (parse_quickly(text, length, power, value)) return NUMBER_OK;
  size_t at = 0;
  const bool negative = length > 0 && text[0] == '-';
  if (length > 0 && (text[0] == '+' || text[0] == '-')) ++at;

  /* The number is gathered as digits x 10^exponent with whole digits, so that no decimal point, which a locale could
   * change, ever reaches strtod. */
  char digits[KEPT_DIGITS + 40];
  size_t kept = 0;
  int64_t exponent = power;
  bool any_digit = false;
  bool after_point = false;
  bool dropped = false;
  for (; at < length; ++at) {
    const char c = text[at];
    if (c == '.' && !after_point) {
      after_point = true;
      continue;
    }
    if (!is_digit(c)) break;
    any_digit = true;
    const bool leading_zero = kept == 0 && c == '0';
    if (leading_zero || kept < KEPT_DIGITS) {
      if (!leading_zero) digits[kept++] = c;
      if (after_point) --exponent;
    } else {
      dropped = dropped || c != '0';
      if (!after_point) ++exponent;
    }
  }
  if (!any_digit) return classify(text, length);
  if (at < length && (!parse_exponent(text, length, &at, &exponent) || at != length)) return NUMBER_SYNTAX;

  if (!dropped && kept <= MOST_DIGITS && exponent >= -SMALL_EXPONENT && exponent <= SMALL_EXPONENT) {
    uint64_t few = 0;
    for (size_t i = 0; i < kept; ++i) few = 10 * few + (uint64_t)(digits[i] - '0');
    if (quick_value(few, (int)exponent, value)) {
      if (negative) *value = -*value;
      return NUMBER_OK;
    }
  }
  if (dropped) {
    digits[kept++] = '1';
    --exponent;
  }
  if (exponent > 400) exponent = 400;     /* at least 1e400: too large */
  if (exponent < -2000) exponent = -2000; /* less than 1e-1199: rounds to zero */
  snprintf(digits + kept, sizeof digits - kept, "e%d", (int)exponent);
  const double magnitude = strtod(digits, NULL);
  if (magnitude > DBL_MAX) return NUMBER_TOO_LARGE;
  *value = negative ? -magnitude : magnitude;
  return NUMBER_OK;
}

enum number_status number_parse_count(const char *text, size_t length, uint64_t *value) {
  size_t at = length > 0 && text[0] == '+' ? 1 : 0;
  if (at == length) return NUMBER_SYNTAX;
  uint64_t count = 0;
  for (; at < length; ++at) {
    if (!is_digit(text[at])) return NUMBER_SYNTAX;
    const uint64_t digit = (uint64_t)(text[at] - '0');
    if (count > (UINT64_MAX - digit) / 10) return NUMBER_TOO_LARGE;
    count = 10 * count + digit;
  }
  *value = count;
  return NUMBER_OK;
}

const char *number_complaint(enum number_status status) {
  switch (status) {
    case NUMBER_OK:
      return "is a number";
    case NUMBER_SYNTAX:
      return "is not a decimal number";
    case NUMBER_NOT_FINITE:
      return "is not finite";
    case NUMBER_TOO_LARGE:
      return "is too large";
  }
  return "is not a number";
}
