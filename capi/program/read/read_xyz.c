/* .xyz: a line with the number of atoms, a title line, then "element x y z" for each atom; further columns are ignored.
 * A trajectory repeats all that: each time is a model. In extended XYZ the title may put the columns in
 * another order. */
#include <inttypes.h>
#include <string.h>

#include "read/atom_elements.h"
#include "read/characters.h"
#include "read/frame_title.h"
#include "read/number.h"
#include "read/read_molecule.h"
#include "read/title_value.h"

/* Step to the next line that is not blank and split it. */
static enum line_status next_filled_line(struct line_reader *reader, struct field *column, size_t capacity,
                                         size_t *columns, struct failure *failure) {
  for (;;) {
    const enum line_status status = line_reader_next(reader, failure);
    if (status != LINE_READ) return status;
    *columns = fields_split(reader->text, reader->length, column, capacity);
    if (*columns > 0) return LINE_READ;
  }
}

/* The columns of an atom's data, counted from 0. */
struct columns {
  size_t element;
  size_t position; /* of x; y and z follow */
};

enum { MOST_COLUMNS = 64 };

/* One name:type:count of Properties; false if it is no such thing. `text` steps to the next one. */
static bool next_property(struct field *text, struct field *name, uint64_t *count) {
  struct field part[3];
  for (int i = 0; i < 3; ++i) {
    const char *colon = text->length == 0 ? NULL : memchr(text->text, ':', text->length);
    if (colon == NULL && i < 2) return false;
    part[i].text = text->text;
    part[i].length = colon == NULL ? text->length : (size_t)(colon - text->text);
    const size_t step = colon == NULL ? text->length : part[i].length + 1;
    text->text += step;
    text->length -= step;
  }
  *name = part[0];
  return number_parse_count(part[2].text, part[2].length, count) == NUMBER_OK && *count > 0 && *count < MOST_COLUMNS;
}

/* The columns by the title of an extended XYZ file, which has Properties=species:S:1:pos:R:3 and more; without that
 * those of plain XYZ. */
static bool columns_of_title(const struct line_reader *reader, struct columns *columns, struct failure *failure) {
  static const char form[] = "Properties is not of the form name:type:count:...";
  struct field value, text = {NULL, 0};
  *columns = (struct columns){0, 1};
  if (!title_value(reader->text, "Properties", &value)) return true;
  if (title_value_split(value, &text, 1) > 1) return failure_in_input(failure, reader->number, "%s", form);
  bool element_seen = false;
  bool species_seen = false;
  bool position_seen = false;
  for (size_t at = 0; text.length > 0;) {
    struct field name;
    uint64_t count;
    if (!next_property(&text, &name, &count)) {
      return failure_in_input(failure, reader->number, "%s", form);
    }
    /* Beside a symbol Z may be anything, a charge for instance. */
    const bool species = field_is(name, "SPECIES");
    if (count == 1 && (species ? !species_seen : field_is(name, "Z") && !element_seen)) {
      columns->element = at;
      element_seen = true;
      species_seen = species;
    }
    if ((field_is(name, "POS") || field_is(name, "POSITIONS")) && count == 3 && !position_seen) {
      columns->position = at;
      position_seen = true;
    }
    if (count > MOST_COLUMNS - at) return failure_in_input(failure, reader->number, "Properties has too many columns");
    at += (size_t)count;
  }
  if (element_seen && position_seen) return true;
  return failure_in_input(failure, reader->number, "Properties has no %s", element_seen ? "pos:R:3" : "species:S:1");
}

static bool read_atom(struct line_reader *reader, const struct field *column, size_t count, struct columns columns,
                      struct molecule *molecule, struct failure *failure) {
  const uint64_t line = reader->number;
  const size_t needed = columns.element < columns.position ? columns.position + 3 : columns.element + 1;
  if (count < needed) {
    return failure_in_input(failure, line, "expected %s, found %u of %u columns",
                            needed == 4 ? "element x y z" : "the columns of Properties", (unsigned)count,
                            (unsigned)needed);
  }
  struct atom_label label = ATOM_LABEL_NONE;
  const struct field element = column[columns.element];
  const struct atom_evidence evidence = {ATOM_SYMBOLS, {"", 0}, element};
  if (!atom_take_element(&evidence, &label)) {
    char shown[EXCERPT_BYTES];
    return failure_in_input(failure, line, "unknown element '%s'; expected a symbol such as C or Cl, or a number",
                            excerpt(shown, element.text, element.length));
  }
  double xyz[3];
  static const char *const names[3] = {"x", "y", "z"};
  for (size_t axis = 0; axis < 3; ++axis) {
    if (!field_number_in_line(column[columns.position + axis], names[axis], &xyz[axis], line, failure)) {
      const struct field *first = &column[0];
      const struct field *second = &column[1];
      const bool tinker = is_digit(first->text[0]) && is_letter(second->text[0]);
      return !tinker ? false : failure_in_input(failure, line, "this looks like Tinker's format, not like XYZ");
    }
  }
  return molecule_add(molecule, xyz, 0.0, &label, line, failure);
}

/* Read a model, whose number of atoms stands in the current line, or step over it. *read: atoms found. */
static enum line_status read_model(struct line_reader *reader, uint64_t count, bool wanted, struct molecule *molecule,
                                   uint64_t *read, struct failure *failure) {
  struct field column[MOST_COLUMNS];
  struct columns columns = {0, 1};
  size_t found = 0;
  enum line_status status = line_reader_next(reader, failure); /* the title, possibly blank */
  if (status == LINE_READ && wanted && !columns_of_title(reader, &columns, failure)) return LINE_FAILED;
  if (status == LINE_READ) frame_title_read(reader->text, &molecule->frame);
  const bool behind = molecule->models > molecule->model;
  if (status == LINE_READ && !behind) box_from_title(reader->text, &molecule->frame.box);
  for (*read = 0; status == LINE_READ && *read < count; ++*read) {
    status = next_filled_line(reader, column, MOST_COLUMNS, &found, failure);
    if (status != LINE_READ) break;
    if (wanted && !read_atom(reader, column, found, columns, molecule, failure)) return LINE_FAILED;
  }
  return status;
}

/* Step to the next model and read it if it is wanted. */
static enum line_status next_announced(struct line_reader *reader, uint64_t *count_before, struct molecule *molecule,
                                       struct failure *failure) {
  uint64_t count = 0;
  struct field column[1];
  size_t columns = 0;
  const enum line_status status = next_filled_line(reader, column, 1, &columns, failure);
  if (status != LINE_READ) return status;
  if (columns != 1 || number_parse_count(column[0].text, column[0].length, &count) != NUMBER_OK) {
    if (molecule->models == 0) {
      failure_in_input(failure, reader->number, "expected the number of atoms alone on this line");
    } else {
      failure_in_input(failure, reader->number, "data after the last atom (%" PRIu64 " announced)", *count_before);
    }
    return LINE_FAILED;
  }
  *count_before = count;
  return read_announced_model(reader, count, read_model, molecule, failure) ? LINE_READ : LINE_FAILED;
}

static bool read_xyz(struct line_reader *reader, struct molecule *molecule, struct failure *failure) {
  uint64_t count = 0;
  for (;;) {
    const enum line_status status = next_announced(reader, &count, molecule, failure);
    if (status != LINE_READ) return status == LINE_END;
  }
}

static enum line_status next_xyz(struct line_reader *reader, bool *begun, bool wanted, struct molecule *molecule,
                                 struct failure *failure) {
  (void)begun;
  (void)wanted;
  uint64_t count = 0;
  return next_announced(reader, &count, molecule, failure);
}

/* The lines behind the number of atoms are its title and as many that are not blank. */
static bool begins_xyz(struct molecule_lines *lines, const struct line_reader *reader) {
  struct field column[2];
  const size_t columns = fields_split(reader->text, reader->length, column, 2);
  if (lines->open) {
    lines->open = false; /* it is the title */
  } else if (lines->line > 0) {
    lines->line -= columns > 0 ? 1 : 0;
  } else if (columns > 0) {
    const bool counts = columns == 1 && number_parse_count(column[0].text, column[0].length, &lines->line) == NUMBER_OK;
    if (!counts) lines->line = UINT64_MAX; /* it is not known where the next one begins */
    lines->open = counts;
    ++lines->count;
    return true;
  }
  return false;
}

static struct field title_of_xyz(const char *text, size_t length) {
  while (length > 0 && molecule_text_next_line(&text, &length).length == 0) continue;
  return molecule_text_next_line(&text, &length);
}

const struct file_format xyz_format = {
    .name = "xyz",
    .extensions = "XYZ EXTXYZ",
    ANGSTROM,
    .features = FILE_ATOMS | FILE_ELEMENTS | FILE_ATOMIC_NUMBERS | FILE_FRAMES | FILE_MOLECULES,
    .nameless = "no element",
    .read = read_xyz,
    .next = next_xyz,
    .begins = begins_xyz,
    .title = title_of_xyz};
