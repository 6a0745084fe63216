/* Eight or sixteen characters at a time: lines, decimals and labels in fixed columns. The first character is the lowest
 * byte of a word on any machine. */
#pragma once

#include <float.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#define WORD_OF(byte) (UINT64_C(0x0101010101010101) * (byte))

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
static inline uint64_t word_at(const char *text) {
  uint64_t word;
  memcpy(&word, text, sizeof word);
  return word;
}

static inline void word_put(char *out, uint64_t word) {
  memcpy(out, &word, sizeof word);
}
#else
static inline uint64_t word_at(const char *text) {
  uint64_t word = 0;
  for (int i = 0; i < 8; ++i) word |= (uint64_t)(unsigned char)text[i] << 8 * i;
  return word;
}

static inline void word_put(char *out, uint64_t word) {
  for (int i = 0; i < 8; ++i) out[i] = (char)(word >> 8 * i);
}
#endif

/* The place of the lowest bit of a word that is not 0. */
static inline unsigned lowest_bit(uint64_t word) {
#ifdef __GNUC__
  return (unsigned)__builtin_ctzll(word);
#else
  unsigned at = 0;
  while ((word >> at & 1) == 0) ++at;
  return at;
#endif
}

static inline unsigned highest_bit(uint64_t word) {
#ifdef __GNUC__
  return 63U - (unsigned)__builtin_clzll(word);
#else
  unsigned at = 63;
  while ((word >> at & 1) == 0) --at;
  return at;
#endif
}

/* The first `count` characters, 0 to 8, and zeros behind them. */
static inline uint64_t word_first(uint64_t word, unsigned count) {
  return count >= 8 ? word : word & ((UINT64_C(1) << 8 * count) - 1);
}

/* 0x80 at the first character that equals `byte`, and perhaps at later ones; 0: none does. */
static inline uint64_t word_find(uint64_t word, char byte) {
  const uint64_t apart = word ^ WORD_OF((unsigned char)byte);
  return (apart - WORD_OF(0x01)) & ~apart & WORD_OF(0x80);
}

/* Whether all eight are digits, and the number that they make up. */
static inline bool word_is_digits(uint64_t word) {
  return ((word & WORD_OF(0xF0)) | ((word + WORD_OF(0x06)) & WORD_OF(0xF0)) >> 4) == WORD_OF(0x33);
}

static inline uint32_t word_digits(uint64_t word) {
  word = (word & WORD_OF(0x0F)) * 2561 >> 8;
  word = (word & UINT64_C(0x00FF00FF00FF00FF)) * 6553601 >> 16;
  return (uint32_t)((word & UINT64_C(0x0000FFFF0000FFFF)) * UINT64_C(42949672960001) >> 32);
}

/* Eight columns with blanks, a sign or none, digits with one point or none, at least one digit, and nothing behind: the
 * value is that of number_parse, digits over a power of ten, rounded once. False: anything else, right or wrong. */
static inline bool word_number(uint64_t word, double *value) {
  static const double powers[8] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};
  const uint64_t point = word_find(word, '.');
  unsigned decimals = 0, most = 56; /* bits before the first digit */
  if (point != 0) {                 /* the digits before it move up to those behind it */
    const unsigned at = lowest_bit(point) & 56;
    const uint64_t behind = ~UINT64_C(0xFF) << at;
    word = (word & behind) | ((word << 8 | ' ') & ~behind);
    decimals = 7 - at / 8;
    most = at + 8;
  }
  const uint64_t digits = word & WORD_OF(0x10); /* a bit of each digit that blanks, signs and points lack */
  if (FLT_EVAL_METHOD != 0 || digits == 0) return false;
  const unsigned head = lowest_bit(digits) & 56;
  if (head > most) return false;
  const uint64_t blank = (UINT64_C(1) << head) - 1, sign = (word ^ WORD_OF(' ')) & blank;
  if (sign != 0 && sign != (uint64_t)(' ' ^ '-') << (head - 8)) return false;
  word = (word & ~blank) | (WORD_OF('0') & blank);
  if (!word_is_digits(word)) return false;
  const double magnitude = (double)word_digits(word) / powers[decimals];
  *value = sign != 0 ? -magnitude : magnitude;
  return true;
}

/* The first `count` characters, 0 to 8, as a number. False: one of them is no digit. */
static inline bool word_whole(uint64_t word, unsigned count, uint64_t *number) {
  *number = 0;
  if (count == 0) return true;
  const unsigned unused = 64 - 8 * count;
  word = count == 8 ? word : word << unused | word_first(WORD_OF('0'), unused / 8);
  if (!word_is_digits(word)) return false;
  *number = word_digits(word);
  return true;
}

/* A decimal without blanks, of at most 8 digits before its point and 8 behind it: the value is that of
 * number_parse_times, with power 0 or 1, rounded once. 16 bytes may be read. False: anything else, right or wrong. */
static inline bool word_decimal(const char *text, size_t length, int power, double *value) {
  static const double powers[9] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};
  static const uint64_t tens[9] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
  if (FLT_EVAL_METHOD != 0 || length == 0 || length > 16) return false;
  const bool negative = text[0] == '-';
  const char *const begin = text + (negative ? 1 : 0);
  unsigned whole = (unsigned)length - (negative ? 1 : 0), decimals = 0;
  const uint64_t front = word_at(begin), point = word_find(front, '.');
  const unsigned at = point != 0 ? lowest_bit(point) / 8 : 8;
  if (at < whole) {
    if (at == 8 && begin[8] != '.') return false;
    decimals = whole - at - 1;
    whole = at;
  }
  if (whole > 8 || decimals > 8 || whole + decimals == 0) return false;
  const uint64_t back = decimals > 0 ? word_at(begin + whole + 1) : 0;
  uint64_t digits, behind = 0;
  if (whole + decimals <= 8) { /* the digits move up to those behind the point */
    const uint64_t joined = whole == 8 ? front : word_first(front, whole) | back << 8 * whole;
    if (!word_whole(joined, whole + decimals, &digits)) return false;
  } else {
    if (!word_whole(front, whole, &digits) || !word_whole(back, decimals, &behind)) return false;
    digits = digits * tens[decimals] + behind; /* 15 digits at most: exact in a double */
  }
  const int exponent = digits == 0 ? 0 : power - (int)decimals;
  const double magnitude = exponent < 0 ? (double)digits / powers[-exponent] : (double)digits * powers[exponent];
  *value = negative ? -magnitude : magnitude;
  return true;
}

/* The first `width` columns without the blanks around them, and zeros behind. */
static inline uint64_t word_label(uint64_t word, unsigned width) {
  const uint64_t filled = word_first(word ^ WORD_OF(' '), width);
  if (filled == 0) return 0;
  const unsigned first = lowest_bit(filled) & 56, last = highest_bit(filled) & 56;
  return word_first(word >> first, (last - first) / 8 + 1);
}

/* The hash of a key whose length is a multiple of 8. */
static inline uint32_t word_hash(const void *key, size_t bytes) {
  uint64_t hash = 0;
  for (size_t i = 0; i < bytes; i += sizeof hash) {
    uint64_t word;
    memcpy(&word, (const char *)key + i, sizeof word);
    hash = (hash ^ word) * UINT64_C(0x9E3779B97F4A7C15);
    hash ^= hash >> 32;
  }
  return (uint32_t)hash;
}

/* A bit for each of sixteen characters: those below `limit`, 1 to 128, those that equal `byte`, those that equal one of
 * two, those that differ from other ones, and all control characters but a tab. */
#ifdef __SSE2__
static inline uint32_t control_in_16(const char *text) {
  const __m128i bytes = _mm_loadu_si128((const __m128i *)(const void *)text);
  const __m128i low = _mm_cmpeq_epi8(_mm_min_epu8(bytes, _mm_set1_epi8(' ' - 1)), bytes);
  const __m128i tab = _mm_cmpeq_epi8(bytes, _mm_set1_epi8('\t')), last = _mm_cmpeq_epi8(bytes, _mm_set1_epi8(0x7F));
  return (uint32_t)_mm_movemask_epi8(_mm_or_si128(_mm_andnot_si128(tab, low), last));
}

static inline uint32_t below_in_16(const char *text, char limit) {
  const __m128i bytes = _mm_loadu_si128((const __m128i *)(const void *)text), most = _mm_set1_epi8((char)(limit - 1));
  return (uint32_t)_mm_movemask_epi8(_mm_cmpeq_epi8(_mm_min_epu8(bytes, most), bytes));
}

static inline uint32_t equal_in_16(const char *text, char byte) {
  const __m128i bytes = _mm_loadu_si128((const __m128i *)(const void *)text);
  return (uint32_t)_mm_movemask_epi8(_mm_cmpeq_epi8(bytes, _mm_set1_epi8(byte)));
}

static inline uint32_t either_in_16(const char *text, char one, char other) {
  const __m128i bytes = _mm_loadu_si128((const __m128i *)(const void *)text);
  const __m128i same = _mm_cmpeq_epi8(bytes, _mm_set1_epi8(one)), also = _mm_cmpeq_epi8(bytes, _mm_set1_epi8(other));
  return (uint32_t)_mm_movemask_epi8(_mm_or_si128(same, also));
}

static inline uint32_t differ_in_16(const char *text, const char *other) {
  const __m128i bytes = _mm_loadu_si128((const __m128i *)(const void *)text);
  const __m128i others = _mm_loadu_si128((const __m128i *)(const void *)other);
  return (uint32_t)_mm_movemask_epi8(_mm_cmpeq_epi8(bytes, others)) ^ UINT32_C(0xFFFF);
}
#else
static inline uint32_t below_in_8(uint64_t word, char limit) {
  const uint64_t high = WORD_OF(0x80);
  const uint64_t other = (((word | high) - WORD_OF((unsigned char)limit)) | word) & high;
  return (uint32_t)(((other ^ high) >> 7) * UINT64_C(0x0102040810204080) >> 56);
}

static inline uint32_t below_in_16(const char *text, char limit) {
  return below_in_8(word_at(text), limit) | below_in_8(word_at(text + 8), limit) << 8;
}

static inline uint32_t equal_in_16(const char *text, char byte) {
  const uint64_t same = WORD_OF((unsigned char)byte);
  return below_in_8(word_at(text) ^ same, 1) | below_in_8(word_at(text + 8) ^ same, 1) << 8;
}

static inline uint32_t either_in_16(const char *text, char one, char other) {
  return equal_in_16(text, one) | equal_in_16(text, other);
}

static inline uint32_t control_in_16(const char *text) {
  return (below_in_16(text, ' ') & ~equal_in_16(text, '\t')) | equal_in_16(text, 0x7F);
}

static inline uint32_t differ_in_16(const char *text, const char *other) {
  const uint32_t low = below_in_8(word_at(text) ^ word_at(other), 1);
  return (low | below_in_8(word_at(text + 8) ^ word_at(other + 8), 1) << 8) ^ UINT32_C(0xFFFF);
}
#endif
