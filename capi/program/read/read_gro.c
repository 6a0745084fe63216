/* .gro, GROMACS's own format: a title, the number of atoms, the atoms in fixed columns, and the box. A trajectory
 * repeats all that: each time is a model. Of an atom's line count, in columns from 1: residue number 1-5 and name 6-10,
 * atom name 11-15, and from 21 on x, y, z, each as wide as its decimal points lie apart, so that any precision can be
 * read. The numbers are nanometres and become angstrom without being rounded on the way. */
#include <inttypes.h>
#include <string.h>

#include "read/atom_elements.h"
#include "read/characters.h"
#include "read/frame_title.h"
#include "read/number.h"
#include "read/read_molecule.h"
#include "read/words.h"

enum { FIRST_COORDINATE = 20 /* counted from 0 */, POWER_OF_NANOMETRE = 1 };

/* How far the decimal points of a line's coordinates lie apart; 0: they are not there, or not in equal columns. */
static size_t width_of(const struct line_reader *reader) {
  const char *point[3];
  const char *at = reader->text + FIRST_COORDINATE;
  if (reader->length <= FIRST_COORDINATE) return 0;
  for (int axis = 0; axis < 3; ++axis) {
    point[axis] = strchr(at, '.');
    if (point[axis] == NULL) return 0;
    at = point[axis] + 1;
  }
  const size_t width = (size_t)(point[1] - point[0]);
  return (size_t)(point[2] - point[1]) == width ? width : 0;
}

static bool take_coordinate(const struct line_reader *reader, size_t width, int axis, double *value,
                            struct failure *failure) {
  const size_t first = FIRST_COORDINATE + (size_t)axis * width + 1;
  const struct field number = field_in_columns(reader->text, reader->length, first, first + width - 1);
  if (word_decimal(number.text, number.length, POWER_OF_NANOMETRE, value)) return true;
  const enum number_status status = number_parse_times(number.text, number.length, POWER_OF_NANOMETRE, value);
  if (status == NUMBER_OK) return true;
  if (number.length == 0) {
    return failure_in_input(failure, reader->number, "%c (columns %u-%u) is missing", "xyz"[axis], (unsigned)first,
                            (unsigned)(first + width - 1));
  }
  char shown[EXCERPT_BYTES];
  return failure_in_input(failure, reader->number, "%c (columns %u-%u): '%s' %s", "xyz"[axis], (unsigned)first,
                          (unsigned)(first + width - 1), excerpt(shown, number.text, number.length),
                          number_complaint(status));
}

static bool read_atom(const struct line_reader *reader, size_t width, struct elements_seen *seen,
                      struct molecule *molecule, struct failure *failure) {
  const char *const text = reader->text;
  if (width == 0) {
    return failure_in_input(failure, reader->number,
                            "expected x y z in columns of equal width from column 21 on, each with a decimal point");
  }
  double xyz[3];
  for (int axis = 0; axis < 3; ++axis) {
    if (!take_coordinate(reader, width, axis, &xyz[axis], failure)) return false;
  }
  struct residue_label residue = RESIDUE_LABEL_NONE;
  struct atom_label label = ATOM_LABEL_NONE;
  label.residue = &residue;
  word_put(residue.number, word_label(word_at(text), 5));
  word_put(residue.name, word_label(word_at(text + 5), 5));
  word_put(label.name, word_label(word_at(text + 10), 5));
  atom_take_element_again(seen, (struct field){label.name, strlen(label.name)}, &label);
  return chain_name_copy(&residue, molecule->copy, failure) &&
         molecule_add(molecule, xyz, 0.0, &label, reader->number, failure);
}

static bool is_empty(const struct line_reader *reader) {
  struct field field;
  return fields_split(reader->text, reader->length, &field, 1) == 0;
}

/* The number of atoms alone on a line. */
static bool is_count(const struct line_reader *reader, uint64_t *count) {
  struct field field;
  return fields_split(reader->text, reader->length, &field, 1) == 1 &&
         number_parse_count(field.text, field.length, count) == NUMBER_OK;
}

/* Read the numbers of a line, which may touch: each has as many characters behind its point as the last one. */
static size_t split_at_points(const struct line_reader *reader, struct field *field, size_t capacity) {
  const char *const text = reader->text;
  size_t length = reader->length, points = 0, begin = 0;
  while (length > 0 && is_blank(text[length - 1])) --length;
  const char *const last = strrchr(text, '.');
  const size_t decimals = last == NULL || last >= text + length ? 0 : (size_t)(text + length - last) - 1;
  for (const char *point = strchr(text, '.'); decimals > 0 && point != NULL; point = strchr(point + 1, '.')) {
    const size_t end = (size_t)(point - text) + decimals + 1;
    if (points == capacity || end > length) return 0;
    field[points++] = field_in_columns(text, length, begin + 1, end);
    begin = end;
  }
  return points;
}

/* Three or nine numbers: the lengths along the axes first, then a_y a_z b_x b_z c_x c_y. */
static bool take_box(const struct line_reader *reader, struct box_record *box) {
  static const int place[9] = {0, 4, 8, 1, 2, 3, 5, 6, 7};
  struct field field[9];
  double vector[9] = {0};
  size_t count = fields_split(reader->text, reader->length, field, 9);
  if (count != 3 && count != 9) count = split_at_points(reader, field, 9);
  if (count != 3 && count != 9) return false;
  for (size_t i = 0; i < count; ++i) {
    if (number_parse_times(field[i].text, field[i].length, POWER_OF_NANOMETRE, &vector[place[i]]) != NUMBER_OK) {
      return false;
    }
  }
  box_from_vectors(vector, box);
  return true;
}

/* Step over a title, which may be empty, to the number of atoms behind it. LINE_END: only empty lines are left. */
static enum line_status find_model(struct line_reader *reader, struct molecule *molecule, uint64_t *count,
                                   struct failure *failure) {
  enum line_status status = line_reader_next(reader, failure);
  while (status == LINE_READ) {
    const bool empty = is_empty(reader);
    frame_title_read(reader->text, &molecule->frame);
    status = line_reader_next(reader, failure);
    if (status == LINE_READ && is_count(reader, count)) return LINE_READ;
    if (empty || status == LINE_FAILED) continue; /* what follows empty lines is a title */
    if (status == LINE_END &&
        (molecule->model == EVERY_MODEL ? molecule->models > 0 : molecule->models >= molecule->model))
      return LINE_END;
    failure_in_input(failure, reader->number, "expected the number of atoms alone on the line after the title");
    return LINE_FAILED;
  }
  return status;
}

/* Read the atoms of a model and its box, or step over them. *read: atoms found. */
static enum line_status read_model(struct line_reader *reader, uint64_t count, bool wanted, struct molecule *molecule,
                                   uint64_t *read, struct failure *failure) {
  size_t width = 0;
  struct elements_seen seen;
  enum line_status status = LINE_READ;
  memset(&seen, 0, sizeof seen);
  for (*read = 0; *read < count; ++*read) {
    status = line_reader_next(reader, failure);
    if (status != LINE_READ) return status;
    if (!wanted) continue;
    if (*read == 0) width = width_of(reader);
    if (!read_atom(reader, width, &seen, molecule, failure)) return LINE_FAILED;
  }
  status = line_reader_next(reader, failure);
  struct box_record box;
  if (status != LINE_READ) return status;
  if (take_box(reader, &box)) {
    if (molecule->models <= molecule->model) molecule->frame.box = box;
    return status;
  }
  failure_in_input(failure, reader->number, "expected the box, three or nine numbers, after %" PRIu64 " atom%s", count,
                   count == 1 ? "" : "s");
  return LINE_FAILED;
}

static bool read_gro(struct line_reader *reader, struct molecule *molecule, struct failure *failure) {
  for (;;) {
    uint64_t count = 0;
    const enum line_status status = find_model(reader, molecule, &count, failure);
    if (status != LINE_READ) return status == LINE_END;
    if (!read_announced_model(reader, count, read_model, molecule, failure)) return false;
  }
}

static enum line_status next_gro(struct line_reader *reader, bool *begun, bool wanted, struct molecule *molecule,
                                 struct failure *failure) {
  (void)begun;
  (void)wanted;
  uint64_t count = 0;
  const enum line_status status = find_model(reader, molecule, &count, failure);
  if (status != LINE_READ) return status;
  return read_announced_model(reader, count, read_model, molecule, failure) ? LINE_READ : LINE_FAILED;
}

const struct file_format gro_format = {.name = "gro",
                                       .extensions = "GRO",
                                       ANGSTROM,
                                       .features = FILE_ATOMS | FILE_ELEMENTS | FILE_RESIDUES | FILE_FRAMES,
                                       .nameless = "no element",
                                       .read = read_gro,
                                       .next = next_gro};
