#include "read_molecule.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

bool molecule_format_named(const char *name, enum molecule_format *format) {
  const struct field written = {name, strlen(name)};
  static const char *const names[] = {"XYZR", "PDB", "PQR", "XYZ"};
  static const enum molecule_format formats[] = {FORMAT_XYZR, FORMAT_PDB, FORMAT_PQR, FORMAT_XYZ};
  for (size_t i = 0; i < sizeof formats / sizeof formats[0]; ++i) {
    if (field_is(written, names[i])) {
      *format = formats[i];
      return true;
    }
  }
  return false;
}

bool molecule_format_of(const char *path, enum molecule_format *format, struct failure *failure) {
  const char *slash = strrchr(path, '/');
  const char *dot = strrchr(slash == NULL ? path : slash + 1, '.');
  if (dot != NULL && molecule_format_named(dot + 1, format)) return true;
  failure->file = path;
  return failure_in_input(failure, 0, "unknown extension; expected .xyzr, .pdb, .pqr or .xyz");
}

/* Nothing follows from a file without atoms, but that something went wrong before. */
static bool check_atoms(const struct molecule *molecule, struct failure *failure) {
  if (molecule->atoms > 0) return true;
  if (molecule->models <= 1 && molecule->model == 1) return failure_in_input(failure, 0, "no atoms in the file");
  if (molecule->model <= molecule->models) {
    return failure_in_input(failure, 0, "no atoms in model %" PRIu64, molecule->model);
  }
  return failure_in_input(failure, 0, "no model %" PRIu64 ": the file has %" PRIu64, molecule->model, molecule->models);
}

bool read_molecule(const char *path, enum molecule_format format, uint64_t model, struct molecule *molecule,
                   struct failure *failure) {
  molecule_init(molecule, format, model);
  failure->file = input_name(path);
  struct line_reader *reader = malloc(sizeof *reader);
  if (reader == NULL) return failure_of_memory(failure);
  bool done = line_reader_open(reader, path, failure);
  if (done) {
    switch (format) {
      case FORMAT_XYZR:
        done = read_xyzr(reader, molecule, failure);
        break;
      case FORMAT_PDB:
        done = read_pdb(reader, molecule, failure);
        break;
      case FORMAT_PQR:
        done = read_pqr(reader, molecule, failure);
        break;
      case FORMAT_XYZ:
        done = read_xyz(reader, molecule, failure);
        break;
    }
    line_reader_close(reader);
  }
  free(reader);
  return done && check_atoms(molecule, failure);
}
