#include "write/report.h"

#include <inttypes.h>
#include <stdio.h>

#include "read/characters.h"
#include "read/number.h"
#include "read/residues.h"

void report_row(struct text_buffer *out, const char *name, const char *value, const char *remark) {
  if (remark[0] == '\0') {
    text_buffer_add(out, "  %-16s %s\n", name, value);
  } else {
    text_buffer_add(out, "  %-16s %-14s %s\n", name, value, remark);
  }
}

void report_row_count(struct text_buffer *out, const char *name, int64_t value, const char *remark) {
  char shown[NUMBER_BYTES];
  report_row(out, name, count_text(shown, value), remark);
}

const char *count_text(char out[NUMBER_BYTES], int64_t value) {
  char *const end = out + NUMBER_BYTES - 1;
  char *begin = number_text_digits(end, value < 0 ? 0 - (uint64_t)value : (uint64_t)value);
  if (value < 0) *--begin = '-';
  *end = '\0';
  return begin;
}

const char *quantity_text(char out[NUMBER_BYTES], double value, int decimals) {
  value += 0.0; /* no "-0" */
  const double magnitude = value < 0.0 ? -value : value;
  if (!is_finite(magnitude)) return "-";
  if (magnitude >= 1e12 || (magnitude > 0.0 && magnitude < 1e-2)) {
    snprintf(out, NUMBER_BYTES, "%.8e", value);
  } else {
    number_text_fixed(out, value, decimals < 10 ? decimals : 10);
  }
  return out;
}

const char *column_text(char out[NUMBER_BYTES], const struct file_format *format, double value, int decimals) {
  static const double halves[] = {0.5, 0.5e-1, 0.5e-2, 0.5e-3, 0.5e-4};
  const double magnitude = value < 0.0 ? -value : value;
  const double half_of_last = halves[decimals];
  /* Without a unit lengths may be of any order. */
  if (format->sign[0] == '\0' || !(magnitude < 1e12)) return quantity_text(out, value, decimals);
  if (magnitude >= half_of_last || value == 0.0) {
    number_text_fixed(out, value + 0.0, decimals);
  } else {
    out[0] = '<';
    number_text_fixed(out + (value > 0.0), value > 0.0 ? 2.0 * half_of_last : 0.0, decimals);
  }
  return out;
}

const char *coordinate_text(char out[NUMBER_BYTES], const struct file_format *format, double value) {
  enum { DECIMALS = 4 };
  const bool vanishes = format->sign[0] != '\0' && value < 0.5e-4 && value > -0.5e-4;
  return column_text(out, format, vanishes ? 0.0 : value, DECIMALS);
}

void report_file_name(struct text_buffer *out, const char *name) {
  const size_t begin = out->length;
  text_buffer_add(out, "%s", name);
  for (size_t i = begin; i < out->length; ++i) {
    if ((unsigned char)out->text[i] < 0x20 || out->text[i] == 0x7F) out->text[i] = '?';
  }
}

struct ball_columns ball_columns_of(const struct molecule *molecule) {
  struct ball_columns columns = {false, false};
  for (uint32_t i = 0; i < molecule->atoms && !(columns.names && columns.elements); ++i) {
    const struct atom_label *label = &molecule->label[i];
    columns.names = columns.names || label->name[0] != '\0' || residue_label_says(label->residue);
    columns.elements = columns.elements || label->element.text[0] != '\0';
  }
  return columns;
}

void report_name_titles(struct text_buffer *out, struct ball_columns columns, const char *ball) {
  text_buffer_add(out, "  %9s", ball);
  if (columns.names) text_buffer_add(out, "  %-6s %-17s", "atom", "residue");
}

void report_name(struct text_buffer *out, struct ball_columns columns, const struct molecule *molecule, uint32_t ball) {
  const struct atom_label *label = &molecule->label[ball];
  char residue[RESIDUE_TEXT_BYTES];
  text_buffer_add(out, "  %9" PRIu32, ball);
  if (columns.names) text_buffer_add(out, "  %-6s %-17s", label->name, residue_text(residue, label->residue));
}

void report_ball_titles(struct text_buffer *out, struct ball_columns columns) {
  report_name_titles(out, columns, "ball");
  if (columns.elements) text_buffer_add(out, "  %-7s", "element");
  text_buffer_add(out, "  %10s", "radius");
}

void report_ball(struct text_buffer *out, struct ball_columns columns, const struct molecule *molecule, uint32_t ball) {
  char radius[NUMBER_BYTES];
  report_name(out, columns, molecule, ball);
  if (columns.elements) text_buffer_add(out, "  %-7s", molecule->label[ball].element.text);
  text_buffer_add(out, "  %10s", quantity_text(radius, molecule->radius[ball], 4));
}

void json_number(struct text_buffer *out, double value) {
  if (is_finite(value)) {
    text_buffer_add_exact(out, value);
  } else {
    text_buffer_add_text(out, "null");
  }
}

void json_numbers(struct text_buffer *out, const double *numbers, uint32_t count) {
  if (numbers == NULL) {
    text_buffer_add_text(out, "null");
    return;
  }
  text_buffer_append(out, "[", 1);
  for (uint32_t k = 0; k < count; ++k) {
    if (k > 0) text_buffer_append(out, ", ", 2);
    json_number(out, numbers[k]);
  }
  text_buffer_append(out, "]", 1);
}

void json_counts(struct text_buffer *out, const uint32_t *counts, uint32_t count) {
  text_buffer_add_text(out, "[");
  for (uint32_t k = 0; k < count; ++k) {
    if (k > 0) text_buffer_append(out, ", ", 2);
    text_buffer_add_count(out, counts[k]);
  }
  text_buffer_append(out, "]", 1);
}

void json_points(struct text_buffer *out, const double *xyz, uint32_t count) {
  text_buffer_add_text(out, "[");
  for (uint32_t k = 0; k < count; ++k) {
    if (k > 0) text_buffer_append(out, ", ", 2);
    json_numbers(out, xyz + 3 * (size_t)k, 3);
  }
  text_buffer_add_text(out, "]");
}

/* Whether a byte needs no escape in a string. */
static bool is_plain(unsigned char byte) {
  return byte >= 0x20 && byte < 0x7F && byte != '"' && byte != '\\';
}

/* A text of a few bytes that stand as they are, as nearly all are; false: it is none. */
static bool json_short_text(struct text_buffer *out, const char *text) {
  enum { MOST = 30 };
  if (!text_buffer_reserve(out, MOST + 2)) return false;
  char *const at = out->text + out->length;
  size_t length = 0;
  for (; length < MOST && is_plain((unsigned char)text[length]); ++length) at[length + 1] = text[length];
  const bool whole = text[length] == '\0';
  at[0] = whole ? '"' : '\0';
  if (!whole) return false;
  at[length + 1] = '"';
  at[length + 2] = '\0';
  out->length += length + 2;
  return true;
}

/* The bytes of the character of UTF-8 that begins with one of 0x80 and more; 0: it is ill-formed. */
static size_t utf8_length(const char *text) {
  const unsigned char *const byte = (const unsigned char *)text;
  const size_t length = byte[0] < 0xC2 ? 0 : byte[0] < 0xE0 ? 2 : byte[0] < 0xF0 ? 3 : byte[0] < 0xF5 ? 4 : 0;
  for (size_t k = 1; k < length; ++k) {
    if ((byte[k] & 0xC0) != 0x80) return 0; /* the text's end, too */
  }
  const bool overlong = (byte[0] == 0xE0 && byte[1] < 0xA0) || (byte[0] == 0xF0 && byte[1] < 0x90);
  const bool surrogate = byte[0] == 0xED && byte[1] > 0x9F, beyond = byte[0] == 0xF4 && byte[1] > 0x8F;
  return overlong || surrogate || beyond ? 0 : length;
}

void json_text(struct text_buffer *out, const char *text) {
  if (json_short_text(out, text)) return;
  text_buffer_append(out, "\"", 1);
  while (*text != '\0') {
    size_t plain = 0;
    while (is_plain((unsigned char)text[plain])) ++plain;
    text_buffer_append(out, text, plain);
    text += plain;
    const unsigned char byte = (unsigned char)*text;
    if (byte == '\0') break;
    const size_t character = byte >= 0x80 ? utf8_length(text) : 0;
    if (character > 0) {
      text_buffer_append(out, text, character);
      text += character;
      continue;
    }
    if (byte >= 0x80) {
      text_buffer_add_text(out, "\\ufffd");
    } else if (byte < 0x20 || byte == 0x7F) {
      text_buffer_add(out, "\\u%04x", (unsigned)byte);
    } else {
      text_buffer_add(out, "\\%c", byte);
    }
    ++text;
  }
  text_buffer_append(out, "\"", 1);
}

void json_residue_number(struct text_buffer *out, const char *text) {
  const char *digits = text[0] == '-' ? text + 1 : text;
  size_t length = 0;
  while (is_digit(digits[length])) ++length;
  if (length == 0 || digits[length] != '\0') {
    json_text(out, text);
    return;
  }
  while (digits[0] == '0' && length > 1) ++digits, --length; /* JSON has no leading zeros */
  if (text[0] == '-' && digits[0] != '0') text_buffer_append(out, "-", 1);
  text_buffer_append(out, digits, length);
}
