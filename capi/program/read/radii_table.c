#include "read/radii_table.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "read/characters.h"
#include "read/fields.h"
#include "read/growing_array.h"
#include "read/line_reader.h"
#include "read/number.h"
#include "read/words.h"

enum { NAME_BYTES = RADII_NAME_BYTES, MOST_PARTS = 5 };

/* Does not compile unless names are as long as those of the library. */
typedef char names_as_in_library[sizeof(((hsp_residue_atom *)NULL)->residue) == NAME_BYTES ? 1 : -1];

/* A type in FreeSASA's files. */
struct type_name {
  char text[24];
};

struct radii_type {
  struct type_name name;
  double radius;
};

/* The line of an entry in a file, and its type there, from which its radius follows once types are known; the type is
 * empty if the entry has a radius. */
struct source {
  uint64_t line;
  struct type_name type;
};

struct reading {
  struct line_reader *reader;
  struct radii_table *table;
  struct radii_type *types;
  size_t type_count;
  size_t type_capacity;
  struct source *sources; /* [table->count] */
  size_t source_capacity;
  char residue[NAME_BYTES]; /* of NACCESS's files: the one that atoms belong to; empty: it is no such file so far */
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

/* An entry that has neither type nor radius yet; NULL: it cannot be added. */
static hsp_residue_atom *add_entry(struct reading *reading, struct field residue, struct field atom) {
  struct radii_table *table = reading->table;
  if (!array_make_room(&table->entries, table->count, &table->capacity, sizeof *table->entries) ||
      !array_make_room(&reading->sources, table->count, &reading->source_capacity, sizeof *reading->sources)) {
    failure_of_memory(reading->failure);
    return NULL;
  }
  hsp_residue_atom *entry = &table->entries[table->count];
  *entry = (hsp_residue_atom){"", "", 0.0};
  const struct field any = {"ANY", 3};
  if (field_is(residue, "*")) residue = any;
  if (!copy_name(entry->residue, sizeof entry->residue, residue) || !copy_name(entry->atom, sizeof entry->atom, atom)) {
    failure_in_input(reading->failure, reading->reader->number, "a name of more than %d characters", NAME_BYTES - 1);
    return NULL;
  }
  reading->sources[table->count++] = (struct source){reading->reader->number, {""}};
  if (names_hydrogen(entry->atom)) table->hydrogens = true;
  return entry;
}

/* The slot of a residue and an atom, or of a residue alone if `atom` is 0: empty, or twice the number of an entry with
 * these names, plus 1 for an atom and 2 for a residue. */
static uint32_t *slot_of(const struct radii_table *table, uint64_t residue, uint64_t atom) {
  const uint64_t spread = UINT64_C(0x9E3779B97F4A7C15);
  uint64_t at = (residue * spread ^ atom) * spread >> 32;
  for (;; ++at) {
    uint32_t *const slot = &table->slots[at & (table->slot_count - 1)];
    if (*slot == 0) return slot;
    const hsp_residue_atom *entry = &table->entries[(*slot - 1) / 2];
    if (word_at(entry->residue) == residue && (*slot % 2 == 0 ? 0 : word_at(entry->atom)) == atom) return slot;
  }
}

/* The first of several entries with the same names counts. */
static void fill_slots(struct radii_table *table) {
  memset(table->slots, 0, table->slot_count * sizeof *table->slots);
  for (uint32_t i = 0; i < table->count; ++i) {
    const uint64_t residue = word_at(table->entries[i].residue);
    if (i == 0 || residue != word_at(table->entries[i - 1].residue)) {
      uint32_t *const alone = slot_of(table, residue, 0);
      if (*alone == 0) *alone = 2 * i + 2;
    }
    uint32_t *const slot = slot_of(table, residue, word_at(table->entries[i].atom));
    if (*slot == 0) *slot = 2 * i + 1;
  }
}

static bool add_slots(struct radii_table *table, struct failure *failure) {
  table->slot_count = 1;
  while (table->slot_count <= 2 * table->count) table->slot_count *= 2;
  table->slots = table->count > UINT32_MAX / 4 ? NULL : malloc(table->slot_count * sizeof *table->slots);
  if (table->slots == NULL) return failure_of_memory(failure);
  fill_slots(table);
  return true;
}

static int order_of_entries(const void *left, const void *right) {
  const hsp_residue_atom *a = left;
  const hsp_residue_atom *b = right;
  const int by_residue = strcmp(a->residue, b->residue);
  return by_residue != 0 ? by_residue : strcmp(a->atom, b->atom);
}

void radii_table_sort(struct radii_table *table) {
  if (table->count == 0) return;
  qsort(table->entries, table->count, sizeof *table->entries, order_of_entries);
  fill_slots(table);
}

/* An atom may stand there twice, but not with two radii. */
static bool check_entries(const struct reading *reading) {
  const struct radii_table *table = reading->table;
  for (size_t i = 0; i < table->count; ++i) {
    const hsp_residue_atom *entry = &table->entries[i];
    const uint32_t first = (*slot_of(table, word_at(entry->residue), word_at(entry->atom)) - 1) / 2;
    if (table->entries[first].radius == entry->radius) continue;
    return failure_in_input(reading->failure, reading->sources[i].line, "%s %s has another radius above",
                            entry->residue, entry->atom);
  }
  return true;
}

bool radii_table_make(struct radii_table *table, uint32_t set, struct failure *failure) {
  uint32_t count = 0;
  hsp_residue_get_atoms(set, NULL, 0, &count);
  table->entries = malloc(count * sizeof *table->entries);
  if (table->entries == NULL) return failure_of_memory(failure);
  hsp_residue_get_atoms(set, table->entries, count, NULL);
  table->count = table->capacity = count;
  for (uint32_t i = 0; i < count; ++i) table->hydrogens = table->hydrogens || names_hydrogen(table->entries[i].atom);
  return add_slots(table, failure);
}

static bool read_type(struct reading *reading, const struct field *part, size_t count) {
  const uint64_t line = reading->reader->number;
  if (count != 2 && count != 3) return failure_in_input(reading->failure, line, "expected a type and its radius");
  if (!array_make_room(&reading->types, reading->type_count, &reading->type_capacity, sizeof *reading->types)) {
    return failure_of_memory(reading->failure);
  }
  struct radii_type *type = &reading->types[reading->type_count];
  if (!copy_name(type->name.text, sizeof type->name.text, part[0])) {
    return failure_in_input(reading->failure, line, "a name of more than %d characters",
                            (int)sizeof type->name.text - 1);
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
  hsp_residue_atom *entry = add_entry(reading, part[0], part[1]);
  if (entry == NULL) return false;
  if (!typed) return field_radius(part[2], &entry->radius, line, reading->failure);
  struct type_name *type = &reading->sources[reading->table->count - 1].type;
  if (copy_name(type->text, sizeof type->text, part[2])) return true;
  return failure_in_input(reading->failure, line, "a name of more than %d characters", (int)sizeof type->text - 1);
}

/* RESIDUE kind name count, of NACCESS, where names of nucleotides are filled up with '_'. In the plain form there may
 * be a residue called so. */
static bool begins_residue(const struct field *part, size_t count) {
  double radius;
  return field_is(part[0], "RESIDUE") && count > 2 && part[2].text[part[2].length - 1] != ':' &&
         (count == 4 || (count == 3 && number_parse(part[2].text, part[2].length, &radius) != NUMBER_OK));
}

static bool read_residue(struct reading *reading, struct field name) {
  while (name.length > 1 && name.text[0] == '_') ++name.text, --name.length;
  return copy_name(reading->residue, sizeof reading->residue, name) ||
         failure_in_input(reading->failure, reading->reader->number, "a name of more than %d characters",
                          NAME_BYTES - 1);
}

/* ATOM name radius [whether it is polar], where a name may have a blank in it, "N A" of older files for NA. */
static bool read_atom(struct reading *reading, const struct field *part, size_t count) {
  char name[2 * NAME_BYTES];
  double radius;
  size_t length = 0, at = 1;
  const uint64_t line = reading->reader->number;
  if (!field_is(part[0], "ATOM")) return failure_in_input(reading->failure, line, "expected ATOM or RESIDUE");
  for (; at < count && at < 3; ++at) {
    if (at > 1 && number_parse(part[at].text, part[at].length, &radius) == NUMBER_OK) break;
    if (part[at].length >= NAME_BYTES) break;
    memcpy(name + length, part[at].text, part[at].length);
    length += part[at].length;
  }
  if (length == 0 || at == count || count > at + 2) {
    return failure_in_input(reading->failure, line, "expected ATOM, an atom and its radius");
  }
  const struct field residue = {reading->residue, strlen(reading->residue)};
  hsp_residue_atom *entry = add_entry(reading, residue, (struct field){name, length});
  return entry != NULL && field_radius(part[at], &entry->radius, line, reading->failure);
}

static bool read_lines(struct reading *reading) {
  enum { PLAIN, TYPES, ATOMS } section = PLAIN;
  for (;;) {
    const enum line_status status = line_reader_next(reading->reader, reading->failure);
    if (status != LINE_READ) return status == LINE_END;
    const char *text = reading->reader->text;
    const char *comment = memchr(text, '#', reading->reader->length);
    struct field part[MOST_PARTS];
    const size_t count =
        fields_split(text, comment == NULL ? reading->reader->length : (size_t)(comment - text), part, MOST_PARTS);
    if (count == 0) continue;
    if (section == PLAIN && begins_residue(part, count)) {
      if (!read_residue(reading, part[2])) return false;
    } else if (reading->residue[0] != '\0') {
      if (!read_atom(reading, part, count)) return false;
    } else if (part[0].text[part[0].length - 1] == ':') {
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
    hsp_residue_atom *entry = &reading->table->entries[i];
    const char *type = reading->sources[i].type.text;
    if (type[0] == '\0') continue;
    size_t at = 0;
    while (at < reading->type_count && strcmp(reading->types[at].name.text, type) != 0) ++at;
    if (at == reading->type_count) {
      return failure_in_input(reading->failure, reading->sources[i].line, "there is no type '%s'", type);
    }
    entry->radius = reading->types[at].radius;
  }
  return true;
}

bool radii_table_read(struct radii_table *table, const char *path, struct failure *failure) {
  const char *file_before = failure->file;
  failure->file = input_name(path);
  struct reading reading = {malloc(sizeof *reading.reader), table, NULL, 0, 0, NULL, 0, "", failure};
  if (reading.reader == NULL) return failure_of_memory(failure);
  bool done = line_reader_open(reading.reader, path, failure);
  if (done) {
    done = read_lines(&reading) && resolve_types(&reading) && add_slots(table, failure) && check_entries(&reading);
    if (done) radii_table_sort(table);
    line_reader_close(reading.reader);
  }
  if (done && table->count == 0) done = failure_in_input(failure, 0, "no radii in the file");
  free(reading.types);
  free(reading.sources);
  free(reading.reader);
  if (done) failure->file = file_before;
  return done;
}

/* A name of at most 7 characters, in capitals, with zeros behind it. */
static uint64_t capitals_of(const char name[NAME_BYTES]) {
  const uint64_t word = word_at(name);
  const uint64_t text = word_first(word, lowest_bit(word_find(word, '\0')) / 8);
  const uint64_t low = text & WORD_OF(0x7F);
  const uint64_t lower = ((low + WORD_OF(0x80 - 'a')) & ~(low + WORD_OF(0x7F - 'z'))) & ~text & WORD_OF(0x80);
  return text ^ lower >> 2;
}

/* Eight bytes at least can be read. No table has a longer name than it has room for. */
static bool is_short(const char *residue) {
  return memchr(residue, '\0', NAME_BYTES) != NULL;
}

bool radii_table_find(const struct radii_table *table, const char *residue, const char atom[NAME_BYTES],
                      double *radius) {
  if (table->count == 0) return false;
  const uint64_t name = capitals_of(atom);
  if (name == 0) return false;
  uint32_t slot = is_short(residue) ? *slot_of(table, capitals_of(residue), name) : 0;
  if (slot == 0) slot = *slot_of(table, word_at("ANY\0\0\0\0"), name);
  if (slot == 0) return false;
  *radius = table->entries[(slot - 1) / 2].radius;
  return true;
}

bool radii_table_names(const struct radii_table *table, const char *residue) {
  return table->count > 0 && is_short(residue) && *slot_of(table, capitals_of(residue), 0) != 0;
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
  free(table->slots);
  *table = (struct radii_table)RADII_TABLE_NONE;
}
