#include "write/report.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
  snprintf(out, NUMBER_BYTES, "%" PRId64, value);
  return out;
}

const char *quantity_text(char out[NUMBER_BYTES], double value, int decimals) {
  value += 0.0; /* no "-0" */
  const double magnitude = value < 0.0 ? -value : value;
  if (!is_finite(magnitude)) return memcpy(out, "-", 2);
  if (magnitude >= 1e12 || (magnitude > 0.0 && magnitude < 1e-2)) {
    snprintf(out, NUMBER_BYTES, "%.8e", value);
  } else {
    snprintf(out, NUMBER_BYTES, "%.*f", decimals < 10 ? decimals : 10, value);
  }
  return out;
}

const char *column_text(char out[NUMBER_BYTES], const struct file_format *format, double value, int decimals) {
  const double magnitude = value < 0.0 ? -value : value;
  double half_of_last = 0.5;
  for (int k = 0; k < decimals; ++k) half_of_last /= 10.0;
  /* Without a unit lengths may be of any order. */
  if (format->sign[0] == '\0' || !(magnitude < 1e12)) return quantity_text(out, value, decimals);
  if (magnitude >= half_of_last || value == 0.0) {
    snprintf(out, NUMBER_BYTES, "%.*f", decimals, value + 0.0);
  } else {
    snprintf(out, NUMBER_BYTES, "%s%.*f", value > 0.0 ? "<" : "", decimals, value > 0.0 ? 2.0 * half_of_last : 0.0);
  }
  return out;
}

const char *coordinate_text(char out[NUMBER_BYTES], const struct file_format *format, double value) {
  enum { DECIMALS = 4 };
  const bool vanishes = format->sign[0] != '\0' && value < 0.5e-4 && value > -0.5e-4;
  return column_text(out, format, vanishes ? 0.0 : value, DECIMALS);
}

const char *exact_text(char out[NUMBER_BYTES], double value) {
  /* 15 digits read back as any double that was written with so few; 17 tell every double from every other. */
  for (int digits = 15; digits <= 17; ++digits) {
    snprintf(out, NUMBER_BYTES, "%.*g", digits, value + 0.0); /* + 0.0: no "-0" */
    if (digits == 17 || strtod(out, NULL) == value) break;
  }
  return out;
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
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    char residue[RESIDUE_TEXT_BYTES];
    columns.names = columns.names || molecule->label[i].name[0] != '\0' ||
                    residue_text(residue, &molecule->label[i].residue)[0] != '\0';
    columns.elements = columns.elements || molecule->label[i].element.text[0] != '\0';
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
  if (columns.names) text_buffer_add(out, "  %-6s %-17s", label->name, residue_text(residue, &label->residue));
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
    char shown[NUMBER_BYTES];
    text_buffer_add(out, "%s", exact_text(shown, value));
  } else {
    text_buffer_add(out, "null");
  }
}

void json_vector(struct text_buffer *out, const double xyz[3]) {
  for (int axis = 0; axis < 3; ++axis) {
    text_buffer_add(out, axis == 0 ? "[" : ", ");
    json_number(out, xyz[axis]);
  }
  text_buffer_add(out, "]");
}

void json_text(struct text_buffer *out, const char *text) {
  text_buffer_add(out, "\"");
  for (; *text != '\0'; ++text) {
    const unsigned char byte = (unsigned char)*text;
    if (byte >= 0x80) {
      text_buffer_add(out, "\\ufffd");
    } else if (byte < 0x20 || byte == 0x7F) {
      text_buffer_add(out, "\\u%04x", (unsigned)byte);
    } else {
      text_buffer_add(out, "%s%c", byte == '"' || byte == '\\' ? "\\" : "", *text);
    }
  }
  text_buffer_add(out, "\"");
}

void json_frame(struct text_buffer *out, const struct frame_stamp *frame) {
  if (frame->number == 0) return;
  text_buffer_add(out, "\"frame\": %" PRIu64 ", \"time\": ", frame->number);
  if (frame->timed) {
    json_number(out, frame->time);
  } else {
    text_buffer_add(out, "null");
  }
  if (frame->stepped) {
    text_buffer_add(out, ", \"step\": %" PRId64 ", ", frame->step);
  } else {
    text_buffer_add(out, ", \"step\": null, ");
  }
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
  text_buffer_add(out, "%s%s", text[0] == '-' && digits[0] != '0' ? "-" : "", digits);
}
