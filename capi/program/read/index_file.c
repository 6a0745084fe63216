#include "read/index_file.h"

#include <stdlib.h>
#include <string.h>

#include "read/growing_array.h"
#include "read/line_reader.h"
#include "read/molecule.h"
#include "read/number.h"

static bool begin_group(struct index_file *file, struct field name, struct failure *failure) {
  struct index_group group = {.count = 0};
  label_copy(group.name, sizeof group.name, name);
  return array_append(&file->group, &file->count, &file->capacity, &group, sizeof group) || failure_of_memory(failure);
}

static bool add_atom(struct index_group *group, uint32_t place, struct failure *failure) {
  return array_append(&group->place, &group->count, &group->capacity, &place, sizeof place) ||
         failure_of_memory(failure);
}

static int order_of_places(const void *left, const void *right) {
  const uint32_t a = *(const uint32_t *)left, b = *(const uint32_t *)right;
  return (a > b) - (a < b);
}

static void sort_places(struct index_group *group) {
  if (group->count > 0) qsort(group->place, group->count, sizeof *group->place, order_of_places);
}

/* The name between brackets, without the blanks around. */
static bool take_heading(struct index_file *file, const struct line_reader *lines, struct failure *failure) {
  const char *const text = lines->text, *const begin = strchr(text, '['), *const end = strrchr(text, ']');
  if (end == NULL || end < begin) return failure_in_input(failure, lines->number, "a heading without ']'");
  const size_t before = (size_t)(begin - text) + 1;
  const struct field name = field_in_columns(text, lines->length, before + 1, (size_t)(end - text));
  if (name.length == 0) return failure_in_input(failure, lines->number, "a group without a name");
  return begin_group(file, name, failure);
}

static bool take_numbers(struct index_file *file, const struct line_reader *lines, struct failure *failure) {
  const char *at = lines->text;
  for (;;) {
    at += strspn(at, " \t");
    const size_t length = strcspn(at, " \t");
    if (length == 0) return true;
    uint64_t number = 0;
    char shown[EXCERPT_BYTES];
    if (number_parse_count(at, length, &number) != NUMBER_OK || number == 0 || number > UINT32_MAX) {
      return failure_in_input(failure, lines->number, "'%s' is not the number of an atom, from 1 on",
                              excerpt(shown, at, length));
    }
    if (file->count == 0) return failure_in_input(failure, lines->number, "atoms before the first [ group ]");
    if (!add_atom(&file->group[file->count - 1], (uint32_t)number - 1, failure)) return false;
    at += length;
  }
}

bool index_file_read(struct index_file *file, const char *path, struct failure *failure) {
  struct line_reader *const lines = malloc(sizeof *lines);
  if (lines == NULL) return failure_of_memory(failure);
  const char *const before = failure->file;
  failure->file = input_name(path);
  if (!line_reader_open(lines, path, failure)) {
    free(lines);
    return false;
  }
  bool done = true;
  enum line_status status = LINE_READ;
  while (done && (status = line_reader_next(lines, failure)) == LINE_READ) {
    lines->text[strcspn(lines->text, ";")] = '\0';
    done = (lines->text[strspn(lines->text, " \t")] == '[' ? take_heading : take_numbers)(file, lines, failure);
  }
  done = done && status == LINE_END;
  for (size_t i = 0; i < file->count; ++i) sort_places(&file->group[i]);
  if (done && file->count == 0) done = failure_in_input(failure, 0, "no [ group ] in the file");
  if (done) failure->file = before;
  line_reader_close(lines);
  free(lines);
  return done;
}

const struct index_group *index_file_find(const struct index_file *file, struct field name) {
  uint64_t number = 0;
  for (size_t i = 0; i < file->count; ++i) {
    const struct index_group *const group = &file->group[i];
    if (strlen(group->name) == name.length && memcmp(group->name, name.text, name.length) == 0) return group;
  }
  const bool numbered = number_parse_count(name.text, name.length, &number) == NUMBER_OK && number < file->count;
  return numbered ? &file->group[number] : NULL;
}

bool index_group_has(const struct index_group *group, uint32_t place) {
  return group->count > 0 && bsearch(&place, group->place, group->count, sizeof *group->place, order_of_places) != NULL;
}

bool index_file_suits(const struct index_file *file, const char *path, uint32_t atoms, struct failure *failure) {
  for (size_t i = 0; i < file->count; ++i) {
    const struct index_group *const group = &file->group[i];
    if (group->count == 0 || group->place[group->count - 1] < atoms) continue;
    failure->file = input_name(path);
    return failure_in_input(failure, 0, "group %s has atom %lu, and the molecule has %lu", group->name,
                            (unsigned long)group->place[group->count - 1] + 1, (unsigned long)atoms);
  }
  return true;
}

void index_file_free(struct index_file *file) {
  for (size_t i = 0; i < file->count; ++i) free(file->group[i].place);
  free(file->group);
  *file = (struct index_file)INDEX_FILE_NONE;
}
