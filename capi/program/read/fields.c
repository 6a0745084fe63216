#include "read/fields.h"

#include "read/characters.h"
#include "read/number.h"
#include "read/words.h"

size_t fields_split(const char *line, size_t length, struct field *fields, size_t capacity) {
  size_t count = 0;
  bool within = false;
  for (size_t at = 0; at < length; at += 16) {
    uint32_t blank = equal_in_16(line + at, ' ') | equal_in_16(line + at, '\t');
    if (length - at < 16) blank |= UINT32_C(0xFFFF) << (length - at) & UINT32_C(0xFFFF);
    /* Where a field begins or ends. */
    uint32_t change = (blank ^ (blank << 1 | (within ? 0 : 1))) & UINT32_C(0xFFFF);
    for (; change != 0; change &= change - 1) {
      const char *const place = line + at + lowest_bit(change);
      if (within) {
        if (count < capacity) fields[count].length = (size_t)(place - fields[count].text);
        ++count;
      } else if (count < capacity) {
        fields[count].text = place;
      }
      within = !within;
    }
  }
  if (within && count < capacity) fields[count].length = (size_t)(line + length - fields[count].text);
  return within ? count + 1 : count;
}

struct field field_in_columns(const char *line, size_t length, size_t first, size_t last) {
  size_t begin = first - 1 < length ? first - 1 : length;
  size_t end = last < length ? last : length;
  while (begin < end && line[begin] == ' ') ++begin;
  while (begin < end && line[end - 1] == ' ') --end;
  const struct field found = {line + begin, end - begin};
  return found;
}

bool field_is(struct field field, const char *word) {
  size_t i = 0;
  while (i < field.length && word[i] != '\0' && to_upper(field.text[i]) == word[i]) ++i;
  return i == field.length && word[i] == '\0';
}

bool field_number(struct field field, const char *name, double *value, uint64_t line, struct failure *failure) {
  if (field.length == 0) return failure_in_input(failure, line, "%s is missing", name);
  const enum number_status status = number_parse(field.text, field.length, value);
  if (status == NUMBER_OK) return true;
  char shown[EXCERPT_BYTES];
  return failure_in_input(failure, line, "%s: '%s' %s", name, excerpt(shown, field.text, field.length),
                          number_complaint(status));
}

bool field_number_in_line(struct field field, const char *name, double *value, uint64_t line, struct failure *failure) {
  return word_decimal(field.text, field.length, 0, value) || field_number(field, name, value, line, failure);
}

bool field_radius(struct field field, double *value, uint64_t line, struct failure *failure) {
  if (!field_number_in_line(field, "radius", value, line, failure)) return false;
  if (*value < 0.0) {
    char shown[EXCERPT_BYTES];
    return failure_in_input(failure, line, "radius: '%s' is negative", excerpt(shown, field.text, field.length));
  }
  return true;
}
