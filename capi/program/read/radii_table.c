#include "read/radii_table.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "hardsphere.h"
#include "read/characters.h"
#include "read/fields.h"
#include "read/line_reader.h"

enum { NAME_BYTES = 8 };

struct radii_entry {
  char residue[NAME_BYTES];
  char atom[NAME_BYTES];
  char type[24]; /* while a file is read: the radius follows when all types are known */
  double radius;
  uint64_t line;
};

/* A type of FreeSASA's files. */
struct radii_type {
  char name[24];
  double radius;
};

struct reading {
  struct line_reader *reader;
  struct radii_table *table;
  struct radii_type *types;
  size_t type_count;
  size_t type_capacity;
  struct failure *failure;
};

/* False: the name is too long. */
static bool copy_name(char *out, size_t room, struct field name) {
  if (name.length >= room) return false;
  for (size_t i = 0; i < room; ++i) out[i] = '\0';
  for (size_t i = 0; i < room - 1 && i < name.length; ++i) out[i] = to_upper(name.text[i]);
  return true;
}

static bool names_hydrogen(const char *atom) {
  while (is_digit(*atom)) ++atom;
  return *atom == 'H' || *atom == 'D';
}

/* Room for one more of `size` bytes; false when memory is short. */
static bool make_room(void **items, size_t count, size_t *capacity, size_t size, struct failure *failure) {
  if (count < *capacity) return true;
  const size_t larger = *capacity == 0 ? 64 : 2 * *capacity;
  void *moved = larger > SIZE_MAX / size ? NULL : realloc(*items, larger * size);
  if (moved == NULL) return failure_of_memory(failure);
  *items = moved;
  *capacity = larger;
  return true;
}

static struct radii_entry *add_entry(struct radii_table *table, struct field residue, struct field atom, uint64_t line,
                                     struct failure *failure) {
  void *entries = table->entries;
  const bool room = make_room(&entries, table->count, &table->capacity, sizeof *table->entries, failure);
  table->entries = entries;
  if (!room) return NULL;
  struct radii_entry *entry = &table->entries[table->count];
  memset(entry, 0, sizeof *entry);
  entry->line = line;
  const struct field any = {"ANY", 3};
  if (field_is(residue, "*")) residue = any;
  if (!copy_name(entry->residue, sizeof entry->residue, residue) || !copy_name(entry->atom, sizeof entry->atom, atom)) {
    failure_in_input(failure, line, "a name of more than %d characters", NAME_BYTES - 1);
    return NULL;
  }
  ++table->count;
  if (names_hydrogen(entry->atom)) table->hydrogens = true;
  return entry;
}

static int order_of_entries(const void *left, const void *right) {
  const struct radii_entry *a = left;
  const struct radii_entry *b = right;
  const int by_residue = strcmp(a->residue, b->residue);
  return by_residue != 0 ? by_residue : strcmp(a->atom, b->atom);
}

/* Put the entries in order. An atom may stand there twice, but not with two radii. */
static bool sort_entries(struct radii_table *table, struct failure *failure) {
  if (table->count > 0) qsort(table->entries, table->count, sizeof *table->entries, order_of_entries);
  for (size_t i = 1; i < table->count; ++i) {
    const struct radii_entry *before = &table->entries[i - 1];
    const struct radii_entry *entry = &table->entries[i];
    if (order_of_entries(before, entry) != 0 || before->radius == entry->radius) continue;
    return failure_in_input(failure, before->line > entry->line ? before->line : entry->line,
                            "%s %s has another radius above", entry->residue, entry->atom);
  }
  return true;
}

static struct field whole(const char *name) {
  return (struct field){name, strlen(name)};
}

bool radii_table_make(struct radii_table *table, uint32_t set, struct failure *failure) {
  uint32_t count = 0;
  hsp_residue_get_atoms(set, NULL, 0, &count);
  hsp_residue_atom *atoms = malloc(count * sizeof *atoms);
  if (atoms == NULL) return failure_of_memory(failure);
  bool done = hsp_residue_get_atoms(set, atoms, count, NULL) == HSP_OK;
  for (uint32_t i = 0; done && i < count; ++i) {
    struct radii_entry *entry = add_entry(table, whole(atoms[i].residue), whole(atoms[i].atom), 0, failure);
    done = entry != NULL;
    if (done) entry->radius = atoms[i].radius;
  }
  free(atoms);
  return done && sort_entries(table, failure);
}

static bool read_type(struct reading *reading, const struct field *part, size_t count) {
  const uint64_t line = reading->reader->number;
  if (count != 2 && count != 3) return failure_in_input(reading->failure, line, "expected a type and its radius");
  void *types = reading->types;
  const bool room =
      make_room(&types, reading->type_count, &reading->type_capacity, sizeof *reading->types, reading->failure);
  reading->types = types;
  if (!room) return false;
  struct radii_type *type = &reading->types[reading->type_count];
  if (!copy_name(type->name, sizeof type->name, part[0])) {
    return failure_in_input(reading->failure, line, "a name of more than %d characters", (int)sizeof type->name - 1);
  }
  ++reading->type_count;
  return field_radius(part[1], &type->radius, line, reading->failure);
}

static bool read_entry(struct reading *reading, const struct field *part, size_t count, bool typed) {
  const uint64_t line = reading->reader->number;
  if (count != 3) {
    return failure_in_input(reading->failure, line, "expected a residue, an atom and its %s",
                            typed ? "type" : "radius");
  }
  struct radii_entry *entry = add_entry(reading->table, part[0], part[1], line, reading->failure);
  if (entry == NULL) return false;
  if (!typed) return field_radius(part[2], &entry->radius, line, reading->failure);
  if (copy_name(entry->type, sizeof entry->type, part[2])) return true;
  return failure_in_input(reading->failure, line, "a name of more than %d characters", (int)sizeof entry->type - 1);
}

static bool read_lines(struct reading *reading) {
  enum { PLAIN, TYPES, ATOMS } section = PLAIN;
  for (;;) {
    const enum line_status status = line_reader_next(reading->reader, reading->failure);
    if (status != LINE_READ) return status == LINE_END;
    const char *text = reading->reader->text;
    const char *comment = memchr(text, '#', reading->reader->length);
    struct field part[4];
    const size_t count =
        fields_split(text, comment == NULL ? reading->reader->length : (size_t)(comment - text), part, 4);
    if (count == 0) continue;
    if (part[0].text[part[0].length - 1] == ':') {
      if (field_is(part[0], "NAME:")) continue;
      if (count == 1 && field_is(part[0], "TYPES:")) {
        section = TYPES;
      } else if (count == 1 && field_is(part[0], "ATOMS:")) {
        section = ATOMS;
      } else {
        return failure_in_input(reading->failure, reading->reader->number, "expected name:, types: or atoms:");
      }
    } else if (!(section == TYPES ? read_type(reading, part, count)
                                  : read_entry(reading, part, count, section == ATOMS))) {
      return false;
    }
  }
}

static bool resolve_types(struct reading *reading) {
  for (size_t i = 0; i < reading->table->count; ++i) {
    struct radii_entry *entry = &reading->table->entries[i];
    if (entry->type[0] == '\0') continue;
    size_t at = 0;
    while (at < reading->type_count && strcmp(reading->types[at].name, entry->type) != 0) ++at;
    if (at == reading->type_count) {
      return failure_in_input(reading->failure, entry->line, "there is no type '%s'", entry->type);
    }
    entry->radius = reading->types[at].radius;
  }
  return true;
}

bool radii_table_read(struct radii_table *table, const char *path, struct failure *failure) {
  const char *file_before = failure->file;
  failure->file = input_name(path);
  struct reading reading = {malloc(sizeof *reading.reader), table, NULL, 0, 0, failure};
  if (reading.reader == NULL) return failure_of_memory(failure);
  bool done = line_reader_open(reading.reader, path, failure);
  if (done) {
    done = read_lines(&reading) && resolve_types(&reading) && sort_entries(table, failure);
    line_reader_close(reading.reader);
  }
  if (done && table->count == 0) done = failure_in_input(failure, 0, "no radii in the file");
  free(reading.types);
  free(reading.reader);
  if (done) failure->file = file_before;
  return done;
}

static const struct radii_entry *find(const struct radii_table *table, const struct radii_entry *key) {
  if (table->count == 0) return NULL;
  return bsearch(key, table->entries, table->count, sizeof *table->entries, order_of_entries);
}

bool radii_table_find(const struct radii_table *table, const char *residue, const char *atom, double *radius) {
  struct radii_entry key;
  if (table->count == 0) return false;
  if (!copy_name(key.residue, sizeof key.residue, whole(residue)) ||
      !copy_name(key.atom, sizeof key.atom, whole(atom))) {
    return false;
  }
  const struct radii_entry *found = find(table, &key);
  if (found == NULL) {
    memcpy(key.residue, "ANY", 4);
    found = find(table, &key);
  }
  if (found == NULL) return false;
  *radius = found->radius;
  return true;
}

static int order_of_residues(const void *left, const void *right) {
  return strcmp(((const struct radii_entry *)left)->residue, ((const struct radii_entry *)right)->residue);
}

bool radii_table_names(const struct radii_table *table, const char *residue) {
  struct radii_entry key;
  if (table->count == 0 || !copy_name(key.residue, sizeof key.residue, whole(residue))) {
    return false;
  }
  return bsearch(&key, table->entries, table->count, sizeof *table->entries, order_of_residues) != NULL;
}

bool radii_table_get(const struct radii_table *table, size_t i, const char **residue, const char **atom,
                     double *radius) {
  if (i >= table->count) return false;
  *residue = table->entries[i].residue;
  *atom = table->entries[i].atom;
  *radius = table->entries[i].radius;
  return true;
}

void radii_table_free(struct radii_table *table) {
  free(table->entries);
  *table = (struct radii_table)RADII_TABLE_NONE;
}
