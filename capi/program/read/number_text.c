#include "read/number_text.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char pairs[] =
    "0001020304050607080910111213141516171819202122232425262728293031323334353637383940414243444546474849"
    "5051525354555657585960616263646566676869707172737475767778798081828384858687888990919293949596979899";

char *number_text_digits(char *end, uint64_t value) {
  while (value >= 100) {
    const uint64_t rest = value / 100;
    end -= 2;
    memcpy(end, pairs + 2 * (value - 100 * rest), 2);
    value = rest;
  }
  if (value >= 10) return memcpy(end - 2, pairs + 2 * value, 2);
  *--end = (char)('0' + value);
  return end;
}

#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 wide_integer;

enum { MOST_POWER = 27, FRACTION_BITS = 52 };

static const uint64_t power_of_5[MOST_POWER + 1] = {
    UINT64_C(1),
    UINT64_C(5),
    UINT64_C(25),
    UINT64_C(125),
    UINT64_C(625),
    UINT64_C(3125),
    UINT64_C(15625),
    UINT64_C(78125),
    UINT64_C(390625),
    UINT64_C(1953125),
    UINT64_C(9765625),
    UINT64_C(48828125),
    UINT64_C(244140625),
    UINT64_C(1220703125),
    UINT64_C(6103515625),
    UINT64_C(30517578125),
    UINT64_C(152587890625),
    UINT64_C(762939453125),
    UINT64_C(3814697265625),
    UINT64_C(19073486328125),
    UINT64_C(95367431640625),
    UINT64_C(476837158203125),
    UINT64_C(2384185791015625),
    UINT64_C(11920928955078125),
    UINT64_C(59604644775390625),
    UINT64_C(298023223876953125),
    UINT64_C(1490116119384765625),
    UINT64_C(7450580596923828125),
};

/* A double without its sign: mantissa x 2^exponent. */
struct binary {
  uint64_t mantissa;
  int exponent;
  bool negative;
};

/* The parts of a normal double or zero. */
static struct binary binary_of(double value) {
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  const uint64_t leading = (uint64_t)(value != 0.0) << FRACTION_BITS;
  return (struct binary){(bits & ((UINT64_C(1) << FRACTION_BITS) - 1)) | leading,
                         (int)(bits >> FRACTION_BITS & 0x7FF) - 1075, bits >> 63 != 0};
}

/* The number times a power of ten, exactly, is product / 2^shift; `digits` is the whole number nearest to it, ties to
 * even. */
struct scaled {
  wide_integer product;
  unsigned shift; /* 1 .. 127 */
  uint64_t digits;
};

/* False: the power of two is not in that range. */
static inline bool scale(const struct binary *number, int power, struct scaled *to) {
  const int shift = -(number->exponent + power);
  if (shift < 1 || shift > 127) return false;
  to->shift = (unsigned)shift;
  to->product = (wide_integer)number->mantissa * power_of_5[power];
  to->digits = (uint64_t)(to->product >> to->shift);
  const wide_integer rest = to->product & (((wide_integer)1 << to->shift) - 1);
  const wide_integer half = (wide_integer)1 << (to->shift - 1);
  to->digits += rest > half || (rest == half && (to->digits & 1) != 0);
  return true;
}

/* Whether the digits read back as the number: they are as near as half of the distance to the next double, which below
 * a power of two is but half as far, and at half of it the even one is read. */
static inline bool reads_back(const struct binary *number, int power, const struct scaled *of) {
  const wide_integer there = (wide_integer)of->digits << of->shift;
  const bool above = there >= of->product;
  const wide_integer apart = above ? there - of->product : of->product - there;
  const bool narrow = number->mantissa == UINT64_C(1) << FRACTION_BITS && !above;
  const wide_integer twice = apart << (narrow ? 2 : 1);
  return twice < power_of_5[power] || (twice == power_of_5[power] && (number->mantissa & 1) == 0);
}

/* Digits, as many as `decimals` behind the point; in front of them is room for zeros. */
static inline size_t put_decimal(char *out, bool negative, char *begin, const char *end, int decimals) {
  while (end - begin <= decimals) *--begin = '0';
  const size_t whole = (size_t)(end - begin - decimals);
  char *at = out;
  if (negative) *at++ = '-';
  memcpy(at, begin, whole);
  at += whole;
  if (decimals > 0) {
    *at++ = '.';
    memcpy(at, begin + whole, (size_t)decimals);
    at += decimals;
  }
  *at = '\0';
  return (size_t)(at - out);
}

/* digits / 10^decimals. */
static inline size_t write_decimal(char *out, bool negative, uint64_t digits, int decimals) {
  char text[NUMBER_BYTES];
  char *const end = text + sizeof text;
  return put_decimal(out, negative, number_text_digits(end, digits), end, decimals);
}

/* The same as %g writes it: without zeros at the end, and in powers of ten below 1e-4. */
static inline size_t write_general(char *out, bool negative, uint64_t digits, int decimals) {
  enum { MOST_ZEROS = 4 };
  while (decimals > 0 && digits % 10 == 0) digits /= 10, --decimals;
  char text[NUMBER_BYTES];
  char *const end = text + sizeof text;
  char *begin = number_text_digits(end, digits);
  const int exponent = (int)(end - begin) - 1 - decimals;
  if (exponent >= -MOST_ZEROS) return put_decimal(out, negative, begin, end, decimals);
  char *at = out;
  if (negative) *at++ = '-';
  *at++ = *begin++;
  if (begin != end) {
    *at++ = '.';
    memcpy(at, begin, (size_t)(end - begin));
    at += end - begin;
  }
  *at++ = 'e';
  *at++ = '-';
  *at++ = (char)('0' + -exponent / 10);
  *at++ = (char)('0' + -exponent % 10);
  *at = '\0';
  return (size_t)(at - out);
}

/* thousandths / 1000 without zeros at the end; it is below 1000. */
static inline size_t write_thousandths(char *out, bool negative, uint32_t thousandths) {
  const uint32_t whole = thousandths / 1000, rest = thousandths % 1000;
  char *at = out;
  if (negative) *at++ = '-';
  if (whole >= 100) *at++ = (char)('0' + whole / 100);
  const char *const last = pairs + 2 * (whole % 100);
  if (whole >= 10) *at++ = last[0];
  *at++ = last[1];
  if (rest != 0) {
    const char *const behind = pairs + 2 * (rest % 100);
    at[0] = '.';
    at[1] = (char)('0' + rest / 100);
    at[2] = behind[0];
    at[3] = behind[1];
    at += behind[1] != '0' ? 4 : behind[0] != '0' ? 3 : 2;
  }
  *at = '\0';
  return (size_t)(at - out);
}

/* Its first digits, so many, and how many of them are behind the point. False: printf is to write it. */
static inline bool first_digits(const struct binary *number, int digits, struct scaled *of, int *decimals) {
  /* By the power of two: as many decimals as there are, or one too many. */
  const int log2 = number->exponent + FRACTION_BITS;
  *decimals = digits - 1 - (log2 >= 0 ? log2 * 315653 >> 20 : -(-log2 * 315653 >> 20) - 1);
  if (*decimals > MOST_POWER - 2 || *decimals < 0 || !scale(number, *decimals, of)) return false;
  if (of->digits <= power_of_5[digits] << digits) return true;
  return --*decimals >= 0 && scale(number, *decimals, of);
}

/* By as few of 15 to 17 digits as read back; 0: it is left to printf. A function of its own: what is most common has
 * few registers to save then. */
__attribute__((noinline)) static size_t by_digits_that_read_back(char *out, double value) {
  const struct binary number = binary_of(value);
  int decimals;
  struct scaled scaled;
  if (!first_digits(&number, 15, &scaled, &decimals)) return 0;
  for (int digits = 15; digits < 17 && !reads_back(&number, decimals, &scaled); ++digits) {
    if (!scale(&number, ++decimals, &scaled)) return 0;
  }
  return write_general(out, number.negative, scaled.digits, decimals);
}

/* Doubles whose digits 128-bit integers hold. */
static inline bool is_moderate(double magnitude) {
  return magnitude >= 1e-10 && magnitude < 1e14;
}

/* 0: it is left to printf. */
static size_t exact_in_128_bits(char *out, double value) {
  const double magnitude = value < 0.0 ? -value : value;
  if (!is_moderate(magnitude)) return 0;
  /* As files write coordinates and radii: three decimals. */
  const double thousands = magnitude * 1000.0;
  if (thousands >= 1.0 && thousands < 999999.0) {
    const uint32_t nearest = (uint32_t)(thousands + 0.5);
    if ((double)nearest / 1000.0 == magnitude) return write_thousandths(out, value < 0.0, nearest);
  }
  return by_digits_that_read_back(out, value);
}

static size_t general_in_128_bits(char *out, double value, int digits) {
  const struct binary number = binary_of(value);
  if (value == 0.0) return write_decimal(out, number.negative, 0, 0);
  int decimals;
  struct scaled scaled;
  if (!is_moderate(value < 0.0 ? -value : value) || digits < 1 || digits > 15 ||
      !first_digits(&number, digits, &scaled, &decimals)) {
    return 0;
  }
  /* One digit more, as 9.6 has if one is asked for, is a power of ten. */
  if (decimals == 0 && scaled.digits == power_of_5[digits] << digits) return 0;
  return write_general(out, number.negative, scaled.digits, decimals);
}

static size_t fixed_in_128_bits(char *out, double value, int decimals) {
  const double magnitude = value < 0.0 ? -value : value;
  struct binary number = binary_of(value);
  struct scaled scaled = {0, 0, 0};
  if (!(magnitude < 1e9) || decimals < 0 || decimals > 10) return 0;
  if (magnitude < 1e-12) {
    /* Less than half of the last decimal. */
  } else if (!scale(&number, decimals, &scaled)) {
    return 0;
  }
  return write_decimal(out, number.negative, scaled.digits, decimals);
}
#else
static size_t exact_in_128_bits(char *out, double value) {
  (void)out;
  (void)value;
  return 0;
}

static size_t general_in_128_bits(char *out, double value, int digits) {
  (void)out;
  (void)value;
  (void)digits;
  return 0;
}

static size_t fixed_in_128_bits(char *out, double value, int decimals) {
  (void)out;
  (void)value;
  (void)decimals;
  return 0;
}
#endif

size_t number_text_exact(char out[NUMBER_BYTES], double value) {
  if (value == 0.0) return memcpy(out, "0", 2), 1;
  size_t length = exact_in_128_bits(out, value);
  /* 15 digits read back as any double that was written with so few; 17 tell every double from every other. */
  for (int digits = 15; length == 0; ++digits) {
    const int written = snprintf(out, NUMBER_BYTES, "%.*g", digits, value);
    if (digits == 17 || strtod(out, NULL) == value) length = (size_t)written;
  }
  return length;
}

size_t number_text_general(char out[NUMBER_BYTES], double value, int digits) {
  const size_t length = general_in_128_bits(out, value, digits);
  return length > 0 ? length : (size_t)snprintf(out, NUMBER_BYTES, "%.*g", digits, value);
}

size_t number_text_fixed(char out[NUMBER_BYTES], double value, int decimals) {
  const size_t length = fixed_in_128_bits(out, value, decimals);
  return length > 0 ? length : (size_t)snprintf(out, NUMBER_BYTES, "%.*f", decimals, value);
}
