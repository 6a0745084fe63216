/* .xyzr, the input of MSMS and its relatives: one ball per line, "x y z r", in any unit. Text after the fourth
 * column is somebody's note, what follows a '#' is a comment. */
#include <string.h>

#include "read/read_molecule.h"

static bool read_xyzr(struct line_reader *reader, struct molecule *molecule, struct failure *failure) {
  const struct atom_label no_label = ATOM_LABEL_NONE;
  molecule->models = 1;
  for (;;) {
    const enum line_status status = line_reader_next(reader, failure);
    if (status != LINE_READ) return status == LINE_END;
    const char *comment = memchr(reader->text, '#', reader->length);
    const size_t length = comment == NULL ? reader->length : (size_t)(comment - reader->text);
    struct field column[4];
    const size_t columns = fields_split(reader->text, length, column, 4);
    if (columns == 0) continue;
    double xyz[3];
    double radius;
    static const char *const names[3] = {"x", "y", "z"};
    for (size_t axis = 0; axis < 3 && axis < columns; ++axis) {
      if (!field_number_in_line(column[axis], names[axis], &xyz[axis], reader->number, failure)) return false;
    }
    if (columns < 4) {
      return failure_in_input(failure, reader->number, "expected x y z r, found %u of 4 columns", (unsigned)columns);
    }
    if (!field_radius(column[3], &radius, reader->number, failure)) return false;
    if (!molecule_add(molecule, xyz, radius, &no_label, reader->number, failure)) return false;
  }
}

const struct file_format xyzr_format = {.name = "xyzr",
                                        .extensions = "XYZR",
                                        .unit = "unit",
                                        .sign = "",
                                        .features = FILE_ATOMS | FILE_RADII,
                                        .nameless = "no element",
                                        .read = read_xyzr};
