#include "read/failure.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "read/characters.h"

/* Input may hold any bytes; text shown to a person must stay on its line. Bytes from 0x80 up pass: they are UTF-8. */
static char printable(char c) {
  return ((unsigned char)c < 0x20 || c == 0x7F) ? '?' : c;
}

bool failure_in_input(struct failure *failure, uint64_t line, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(failure->reason, sizeof failure->reason, format, arguments);
  va_end(arguments);
  failure->exit_status = EXIT_BAD_INPUT;
  failure->line = line;
  failure->of_memory = false;
  return false;
}

bool failure_in_usage(struct failure *failure, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(failure->reason, sizeof failure->reason, format, arguments);
  va_end(arguments);
  failure->exit_status = EXIT_BAD_USAGE;
  failure->file = NULL;
  failure->line = 0;
  failure->of_memory = false;
  return false;
}

bool usage_rules_hold(const struct usage_rule *rule, size_t count, struct failure *failure) {
  for (size_t k = 0; k < count; ++k) {
    if (rule[k].broken) return failure_in_usage(failure, "%s", rule[k].reason);
  }
  return true;
}

bool failure_of_memory(struct failure *failure) {
  failure_in_input(failure, 0, "out of memory");
  failure->of_memory = true;
  return false;
}

static void put_printable(const char *text) {
  for (; *text != '\0'; ++text) fputc(printable(*text), stderr);
}

void failure_print(const struct failure *failure) {
  fputs("hardsphere: ", stderr);
  if (failure->file != NULL) {
    put_printable(failure->file);
    if (failure->line != 0) fprintf(stderr, ":%llu", (unsigned long long)failure->line);
    fputs(": ", stderr);
  }
  put_printable(failure->reason);
  fputc('\n', stderr);
}

const char *excerpt(char out[EXCERPT_BYTES], const char *text, size_t length) {
  static const char more[] = "...";
  const size_t room = EXCERPT_BYTES - sizeof more;
  const size_t shown = length <= room ? length : whole_characters(text, room);
  for (size_t i = 0; i < shown; ++i) out[i] = printable(text[i]);
  out[shown] = '\0';
  if (shown < length) memcpy(out + shown, more, sizeof more);
  return out;
}
