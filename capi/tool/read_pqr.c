/* .pqr: the atom records of a PDB file as fields between blanks, with charge and radius at the end:
 *   ATOM serial name residue [chain] number x y z charge radius
 * (see the format's description by Dolinsky, Nielsen, McCammon and Baker for PDB2PQR). */
#include <string.h>

#include "characters.h"
#include "pdb_records.h"
#include "read_molecule.h"

enum { MOST_FIELDS = 11 };

/* The record name may run into the serial number: HETATM12345. */
static bool serial_is_joined(struct field record) {
  return !field_is(record, "ATOM") && !field_is(record, "HETATM");
}

/* A residue number may end in its insertion code: 52A. */
static void label_number(struct field number, struct residue_label *label) {
  if (number.length >= 2 && is_digit(number.text[number.length - 2]) && is_letter(number.text[number.length - 1])) {
    label_copy(label->insertion, sizeof label->insertion, (struct field){number.text + number.length - 1, 1});
    --number.length;
  }
  label_copy(label->number, sizeof label->number, number);
}

static bool read_atom(const struct line_reader *reader, struct molecule *molecule, struct failure *failure) {
  const uint64_t line = reader->number;
  struct field part[MOST_FIELDS];
  const size_t count = fields_split(reader->text, reader->length, part, MOST_FIELDS);
  const size_t first = serial_is_joined(part[0]) ? 1 : 2; /* of the fields after the serial number */
  const size_t after_serial = count - first;              /* name residue [chain] number x y z charge radius */
  if (count < first || after_serial < 8 || after_serial > 9) {
    return failure_in_input(failure, line,
                            "expected ATOM serial name residue [chain] number x y z charge radius, found %u fields",
                            (unsigned)count);
  }
  const struct field *number = part + count - 6;
  if (memchr(number->text, '.', number->length) != NULL) {
    char shown[EXCERPT_BYTES];
    return failure_in_input(failure, line, "'%s' stands where a residue number should; wrong number of fields?",
                            excerpt(shown, number->text, number->length));
  }
  static const char *const names[4] = {"x", "y", "z", "charge"};
  double value[4];
  double radius;
  for (size_t i = 0; i < 4; ++i) {
    if (!field_number(part[count - 5 + i], names[i], &value[i], line, failure)) return false;
  }
  if (!field_radius(part[count - 1], &radius, line, failure)) return false;

  struct atom_label label = ATOM_LABEL_NONE;
  label_copy(label.name, sizeof label.name, part[first]);
  label_copy(label.residue.name, sizeof label.residue.name, part[first + 1]);
  if (after_serial == 9) label_copy(label.residue.chain, sizeof label.residue.chain, part[first + 2]);
  label_number(*number, &label.residue);
  label.hetatm = pdb_record_is_hetatm(reader->text);
  return molecule_add(molecule, value, radius, &label, line, failure);
}

bool read_pqr(struct line_reader *reader, struct molecule *molecule, struct failure *failure) {
  struct pdb_models models = {0, false};
  bool record_seen = false;
  for (;;) {
    const enum line_status status = pdb_next_atom(reader, molecule, &models, &record_seen, failure);
    if (status != LINE_READ) return status == LINE_END;
    if (!read_atom(reader, molecule, failure)) return false;
  }
}
