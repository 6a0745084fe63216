/* Character classes of ASCII, whatever the locale, and where characters of UTF-8 end. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

static inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
static inline bool is_lower(char c) {
  return c >= 'a' && c <= 'z';
}
static inline bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}
static inline bool is_letter(char c) {
  return is_lower(c) || is_upper(c);
}
static inline bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
static inline char to_lower(char c) {
  return is_upper(c) ? (char)(c - 'A' + 'a') : c;
}
static inline char to_upper(char c) {
  return is_lower(c) ? (char)(c - 'a' + 'A') : c;
}
/* Write a text in capitals, as much as there is room for, and a NUL. */
static inline void to_capitals(char *out, size_t room, const char *text, size_t length) {
  size_t at = 0;
  for (; at < length && at + 1 < room; ++at) out[at] = to_upper(text[at]);
  out[at] = '\0';
}
/* How many bytes of a text that goes on behind `most` of them are whole characters, if it is UTF-8. */
static inline size_t whole_characters(const char *text, size_t most) {
  size_t length = most;
  while (length > 0 && most - length < 3 && ((unsigned char)text[length] & 0xC0) == 0x80) --length;
  return ((unsigned char)text[length] & 0xC0) == 0xC0 ? length : most;
}
