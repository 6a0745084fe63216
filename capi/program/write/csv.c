#include "write/csv.h"

#include <inttypes.h>
#include <string.h>

#include "read/number.h"
#include "write/report.h"

void csv_text(struct text_buffer *out, const char *text) {
  if (strpbrk(text, ",\"\r\n") == NULL) {
    text_buffer_add(out, "%s", text);
    return;
  }
  text_buffer_add(out, "\"");
  for (; *text != '\0'; ++text) text_buffer_add(out, "%s%c", *text == '"' ? "\"" : "", *text);
  text_buffer_add(out, "\"");
}

void csv_number(struct text_buffer *out, double value) {
  char shown[NUMBER_BYTES];
  if (is_finite(value)) text_buffer_add(out, "%s", exact_text(shown, value));
}

void csv_numbers(struct text_buffer *out, const double *numbers, int count) {
  for (int i = 0; i < count; ++i) {
    text_buffer_add(out, ",");
    csv_number(out, numbers[i]);
  }
}

void csv_frame_titles(struct text_buffer *out) {
  text_buffer_add(out, "frame,time,step,atoms,");
}

void csv_frame(struct text_buffer *out, const struct molecule *molecule) {
  const struct frame_stamp *frame = &molecule->frame;
  text_buffer_add(out, "%" PRIu64 ",", frame->number);
  if (frame->timed) csv_number(out, frame->time);
  text_buffer_add(out, ",");
  if (frame->stepped) text_buffer_add(out, "%" PRId64, frame->step);
  text_buffer_add(out, ",%" PRIu32 ",", molecule->atoms);
}
