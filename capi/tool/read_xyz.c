/* .xyz: a line with the number of atoms, a title line, then "element x y z" for each atom; further columns are ignored.
 * A trajectory repeats all that; the first model is read. */
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
                      const struct radii *radii, struct molecule *molecule, struct failure *failure) {
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
  return molecule_add_element(molecule, xyz, radii, &label, line, failure);
}

bool read_xyz(struct line_reader *reader, const struct radii *radii, struct molecule *molecule,
              struct failure *failure) {
  struct field column[4];
  size_t columns = 0;
  enum line_status status = next_filled_line(reader, column, 4, &columns, failure);
  if (status != LINE_READ) return status == LINE_END; /* a file of nothing holds no atoms */

  uint64_t count = 0;
  if (columns != 1 || number_parse_count(column[0].text, column[0].length, &count) != NUMBER_OK) {
    return failure_in_input(failure, reader->number, "expected the number of atoms alone on this line");
  }
  const uint64_t count_line = reader->number;
  status = line_reader_next(reader, failure); /* the title, possibly blank */
  for (uint64_t atom = 0; status == LINE_READ && atom < count; ++atom) {
    status = next_filled_line(reader, column, 4, &columns, failure);
    if (status == LINE_READ && !read_atom(reader, column, columns, radii, molecule, failure)) return false;
  }
  if (status == LINE_END && molecule->atoms < count) {
    return failure_in_input(failure, count_line, "%" PRIu64 " atoms announced, the file ends after %" PRIu32, count,
                            molecule->atoms);
  }
  if (status == LINE_READ) status = next_filled_line(reader, column, 4, &columns, failure);
  if (status != LINE_READ) return status == LINE_END;
  uint64_t next_count;
  if (columns == 1 && number_parse_count(column[0].text, column[0].length, &next_count) == NUMBER_OK) return true;
  return failure_in_input(failure, reader->number, "data after the last atom (%" PRIu64 " announced)", count);
}
