#include "write/csv.h"

#include <string.h>

#include "read/number.h"

void csv_text(struct text_buffer *out, const char *text) {
  const size_t plain = strcspn(text, ",\"\r\n");
  if (text[plain] == '\0') {
    text_buffer_append(out, text, plain);
    return;
  }
  text_buffer_add_text(out, "\"");
  for (; *text != '\0'; ++text) text_buffer_add(out, "%s%c", *text == '"' ? "\"" : "", *text);
  text_buffer_add_text(out, "\"");
}

void csv_number(struct text_buffer *out, double value) {
  if (is_finite(value)) text_buffer_add_exact(out, value);
}
