#include "read/text_buffer.h"

#include <errno.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool text_buffer_reserve(struct text_buffer *buffer, size_t more) {
  if (buffer->out_of_memory) return false;
  if (more < buffer->capacity - buffer->length) return true;
  if (more > SIZE_MAX / 2 - buffer->length - 1 || buffer->capacity > SIZE_MAX / 2) {
    buffer->out_of_memory = true;
    return false;
  }
  size_t capacity = 2 * buffer->capacity;
  if (capacity < buffer->length + more + 1) capacity = buffer->length + more + 1;
  if (capacity < 256) capacity = 256;
  char *text = realloc(buffer->text, capacity);
  if (text == NULL) {
    buffer->out_of_memory = true;
    return false;
  }
  buffer->text = text;
  buffer->capacity = capacity;
  return true;
}

void text_buffer_add(struct text_buffer *buffer, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  va_list again;
  va_copy(again, arguments);
  const int wanted = vsnprintf(NULL, 0, format, arguments);
  va_end(arguments);
  if (wanted >= 0 && text_buffer_reserve(buffer, (size_t)wanted)) {
    vsnprintf(buffer->text + buffer->length, (size_t)wanted + 1, format, again);
    buffer->length += (size_t)wanted;
  }
  va_end(again);
}

void text_buffer_append(struct text_buffer *buffer, const char *bytes, size_t count) {
  if (count == 0 || !text_buffer_reserve(buffer, count)) return;
  memcpy(buffer->text + buffer->length, bytes, count);
  buffer->length += count;
  buffer->text[buffer->length] = '\0';
}

void text_buffer_add_xml(struct text_buffer *buffer, const char *text) {
  for (; *text != '\0'; ++text) {
    switch (*text) {
      case '&':
        text_buffer_add(buffer, "&amp;");
        break;
      case '<':
        text_buffer_add(buffer, "&lt;");
        break;
      case '>':
        text_buffer_add(buffer, "&gt;");
        break;
      default:
        text_buffer_append(buffer, ' ' <= *text && *text <= '~' ? text : "?", 1);
    }
  }
}

bool text_buffer_print(const struct text_buffer *buffer, struct failure *failure) {
  failure->file = NULL;
  if (buffer->out_of_memory) return failure_of_memory(failure);
  errno = 0;
  const size_t written = buffer->length == 0 ? 0 : fwrite(buffer->text, 1, buffer->length, stdout);
  if (written != buffer->length || fflush(stdout) != 0) {
    return failure_in_input(failure, 0, "standard output: %s", errno != 0 ? strerror(errno) : "cannot be written");
  }
  return true;
}

void text_buffer_free(struct text_buffer *buffer) {
  free(buffer->text);
  buffer->text = NULL;
  buffer->length = 0;
  buffer->capacity = 0;
}
