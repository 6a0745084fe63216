#include "read/text_buffer.h"

#include <errno.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/number_text.h"

bool text_buffer_grow(struct text_buffer *buffer, size_t more) {
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

/* Add bytes in a field of that many columns, at its left end if `left`. */
static void add_field(struct text_buffer *buffer, const char *bytes, size_t count, size_t width, bool left) {
  const size_t blanks = width > count ? width - count : 0;
  if (!text_buffer_reserve(buffer, count + blanks)) return;
  char *const at = buffer->text + buffer->length;
  memcpy(left ? at : at + blanks, bytes, count);
  memset(left ? at + count : at, ' ', blanks);
  buffer->length += count + blanks;
  buffer->text[buffer->length] = '\0';
}

/* A width or a number of decimals: digits, or an argument. */
static const char *take_count(const char *format, va_list *arguments, int *count) {
  if (*format == '*') {
    *count = va_arg(*arguments, int);
    return format + 1;
  }
  for (; '0' <= *format && *format <= '9'; ++format) *count = 10 * *count + (*format - '0');
  return format;
}

/* Add text by a format of the most common items: texts, characters, whole numbers, and numbers with a number of
 * decimals or significant digits. False: the format has another item. */
static bool add_plainly(struct text_buffer *buffer, const char *format, va_list *arguments) {
  for (;;) {
    const size_t plain = strcspn(format, "%");
    text_buffer_append(buffer, format, plain);
    format += plain;
    if (*format == '\0') return true;
    bool left = *++format == '-';
    int width = 0, decimals = -1, longs = 0;
    format += left;
    if (*format == '0') return false;
    format = take_count(format, arguments, &width);
    if (*format == '.') decimals = 0, format = take_count(format + 1, arguments, &decimals);
    for (; *format == 'l'; ++format) ++longs;
    left = left || width < 0;
    const size_t columns = (size_t)(width < 0 ? -width : width);
    char number[NUMBER_BYTES + 1];
    char *const end = number + sizeof number;
    if (*format == 's' && decimals < 0) {
      const char *const text = va_arg(*arguments, const char *);
      add_field(buffer, text, strlen(text), columns, left);
    } else if (*format == 'c') {
      number[0] = (char)va_arg(*arguments, int);
      add_field(buffer, number, 1, columns, left);
    } else if (*format == 'u' || *format == 'd') {
      const bool is_signed = *format == 'd';
      const int64_t value = !is_signed   ? 0
                            : longs == 0 ? va_arg(*arguments, int)
                            : longs == 1 ? va_arg(*arguments, long)
                                         : va_arg(*arguments, long long);
      const uint64_t size = is_signed    ? (value < 0 ? 0 - (uint64_t)value : (uint64_t)value)
                            : longs == 0 ? va_arg(*arguments, unsigned)
                            : longs == 1 ? va_arg(*arguments, unsigned long)
                                         : va_arg(*arguments, unsigned long long);
      char *digits = number_text_digits(end, size);
      if (value < 0) *--digits = '-';
      add_field(buffer, digits, (size_t)(end - digits), columns, left);
    } else if (*format == 'f' && decimals >= 0) {
      const double value = va_arg(*arguments, double);
      if (!(value < 1e21 && value > -1e21)) return false;
      add_field(buffer, number, number_text_fixed(number, value, decimals), columns, left);
    } else if (*format == 'g' && decimals >= 1 && decimals <= 17) {
      const size_t count = number_text_general(number, va_arg(*arguments, double), decimals);
      add_field(buffer, number, count, columns, left);
    } else if (*format == '%') {
      text_buffer_append(buffer, "%", 1);
    } else {
      return false;
    }
    ++format;
  }
}

void text_buffer_add(struct text_buffer *buffer, const char *format, ...) {
  const size_t length = buffer->length;
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  if (!add_plainly(buffer, format, &arguments)) {
    va_list measured;
    va_copy(measured, again);
    buffer->length = length;
    const int wanted = vsnprintf(NULL, 0, format, measured);
    va_end(measured);
    if (wanted >= 0 && text_buffer_reserve(buffer, (size_t)wanted)) {
      vsnprintf(buffer->text + buffer->length, (size_t)wanted + 1, format, again);
      buffer->length += (size_t)wanted;
    }
  }
  va_end(again);
  va_end(arguments);
}

void text_buffer_add_count(struct text_buffer *buffer, uint64_t count) {
  char number[NUMBER_BYTES];
  char *const end = number + sizeof number;
  const char *const digits = number_text_digits(end, count);
  text_buffer_append(buffer, digits, (size_t)(end - digits));
}

void text_buffer_add_exact(struct text_buffer *buffer, double value) {
  if (text_buffer_reserve(buffer, NUMBER_BYTES)) {
    buffer->length += number_text_exact(buffer->text + buffer->length, value);
  }
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
