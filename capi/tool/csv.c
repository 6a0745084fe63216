#include "csv.h"

#include <float.h>
#include <string.h>

#include "report.h"

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
  if (value >= -DBL_MAX && value <= DBL_MAX) text_buffer_add(out, "%s", exact_text(shown, value));
}
