/* The atoms of one file, as balls. */
#ifndef HARDSPHERE_TOOL_MOLECULE_H
#define HARDSPHERE_TOOL_MOLECULE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "failure.h"
#include "fields.h"
#include "radii.h"

enum molecule_format { FORMAT_XYZR, FORMAT_PDB, FORMAT_PQR, FORMAT_XYZ };

/* What a person calls a residue; empty where the file does not say. */
struct residue_label {
  char chain[12];
  char name[8];
  char number[12]; /* as written, without the insertion code */
  char insertion[2];
};

/* What a person calls an atom; empty where the file does not say. */
struct atom_label {
  char name[8];
  struct residue_label residue;
  struct element_symbol element;
};

#define ATOM_LABEL_NONE     \
  {                         \
    "", {"", "", "", ""}, { \
      ""                    \
    }                       \
  }

struct molecule {
  enum molecule_format format;
  uint32_t atoms;
  uint32_t capacity;
  double *xyz;              /* [atoms][3] */
  double *radius;           /* [atoms] */
  uint64_t *line;           /* [atoms], the line that an atom was read from */
  struct atom_label *label; /* [atoms] */
};

void molecule_init(struct molecule *molecule, enum molecule_format format);

/* Append an atom. False when memory is short or the library could not take so many. */
bool molecule_add(struct molecule *molecule, const double xyz[3], double radius, const struct atom_label *label,
                  uint64_t line, struct failure *failure);

/* Append an atom whose radius follows from its element; an element without one is refused by name. */
bool molecule_add_element(struct molecule *molecule, const double xyz[3], const struct radii *radii,
                          const struct atom_label *label, uint64_t line, struct failure *failure);

void molecule_free(struct molecule *molecule);

/* Copy a field into a label; what does not fit is cut off. */
void label_copy(char *out, size_t room, struct field text);

/* Whether a format's files bring their own radii. */
bool format_has_radii(enum molecule_format format);

/* Whether a format's files say to which residue an atom belongs. */
bool format_has_residues(enum molecule_format format);

/* The unit of length of a format's files: "angstrom", or "unit" where everybody has their own. */
const char *format_unit(enum molecule_format format);

#endif
