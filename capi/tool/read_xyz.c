/* .xyz: a line with the number of atoms, a title line, then "element x y z" for each atom; further columns are ignored.
 * A trajectory repeats all that: each time is a model. */
#include <inttypes.h>

#include "number.h"
#include "read_molecule.h"

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

static bool read_atom(struct line_reader *reader, const struct field column[4], size_t columns,
                      struct molecule *molecule, struct failure *failure) {
  const uint64_t line = reader->number;
  if (columns < 4) {
    return failure_in_input(failure, line, "expected element x y z, found %u of 4 columns", (unsigned)columns);
  }
  struct atom_label label = ATOM_LABEL_NONE;
  if (!element_symbol_parse(column[0].text, column[0].length, &label.element)) {
    char shown[EXCERPT_BYTES];
    return failure_in_input(failure, line, "unknown element '%s'; expected a symbol such as C or Cl",
                            excerpt(shown, column[0].text, column[0].length));
  }
  double xyz[3];
  static const char *const names[3] = {"x", "y", "z"};
  for (size_t axis = 0; axis < 3; ++axis) {
    if (!field_number(column[1 + axis], names[axis], &xyz[axis], line, failure)) return false;
  }
  return molecule_add(molecule, xyz, 0.0, &label, line, failure);
}

/* Read a model, whose number of atoms stands in the current line, or step over it. *read: atoms found. */
static enum line_status read_model(struct line_reader *reader, uint64_t count, bool wanted, struct molecule *molecule,
                                   uint64_t *read, struct failure *failure) {
  struct field column[4];
  size_t columns = 0;
  enum line_status status = line_reader_next(reader, failure); /* the title, possibly blank */
  for (*read = 0; status == LINE_READ && *read < count; ++*read) {
    status = next_filled_line(reader, column, 4, &columns, failure);
    if (status != LINE_READ) break;
    if (wanted && !read_atom(reader, column, columns, molecule, failure)) return LINE_FAILED;
  }
  return status;
}

bool read_xyz(struct line_reader *reader, struct molecule *molecule, struct failure *failure) {
  uint64_t count_before = 0;
  for (;;) {
    uint64_t count = 0;
    struct field column[1];
    size_t columns = 0;
    enum line_status status = next_filled_line(reader, column, 1, &columns, failure);
    if (status != LINE_READ) return status == LINE_END;
    const uint64_t count_line = reader->number;
    if (columns != 1 || number_parse_count(column[0].text, column[0].length, &count) != NUMBER_OK) {
      if (molecule->models == 0) {
        return failure_in_input(failure, count_line, "expected the number of atoms alone on this line");
      }
      return failure_in_input(failure, count_line, "data after the last atom (%" PRIu64 " announced)", count_before);
    }
    count_before = count;
    ++molecule->models;
    const bool wanted = molecule->models == molecule->model;
    uint64_t read = 0;
    status = read_model(reader, count, wanted, molecule, &read, failure);
    if (status == LINE_FAILED) return false;
    if (!wanted) molecule->left_out.other_models += read;
    /* What breaks off behind the model that is wanted, as in a run that was stopped, does not concern it. */
    if (read < count && molecule->models <= molecule->model) {
      return failure_in_input(failure, count_line, "%" PRIu64 " atoms announced, the file ends after %" PRIu64, count,
                              read);
    }
  }
}
