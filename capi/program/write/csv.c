#include "write/csv.h"

#include <string.h>

#include "read/number.h"
#include "read/number_text.h"

static bool is_plain(char c) {
  return (unsigned char)c > ',' || (c != '\0' && c != ',' && c != '"' && c != '\r' && c != '\n');
}

/* Most texts are names of a few characters, which are looked at and copied one by one. */
static bool add_name(struct text_buffer *out, const char *text) {
  enum { MOST = 15 };
  if (!text_buffer_reserve(out, MOST)) return false;
  char *const at = out->text + out->length;
  size_t length = 0;
  for (; length < MOST && is_plain(text[length]); ++length) at[length] = text[length];
  at[length] = '\0';
  if (text[length] != '\0') return false;
  out->length += length;
  return true;
}

SELDOM static void add_text(struct text_buffer *out, const char *text) {
  const size_t plain = strcspn(text, ",\"\r\n");
  if (text[plain] == '\0') {
    text_buffer_append(out, text, plain);
    return;
  }
  text_buffer_add_text(out, "\"");
  for (; *text != '\0'; ++text) text_buffer_add(out, "%s%c", *text == '"' ? "\"" : "", *text);
  text_buffer_add_text(out, "\"");
}

void csv_text(struct text_buffer *out, const char *text) {
  if (!add_name(out, text)) add_text(out, text);
}

void csv_number(struct text_buffer *out, double value) {
  if (is_finite(value) && text_buffer_reserve(out, NUMBER_BYTES)) {
    out->length += number_text_exact(out->text + out->length, value);
  }
}
