#include "read/read_molecule.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/characters.h"
#include "read/residue_kinds.h"

static const struct molecule_reader *const readers[FORMATS] = {&xyzr_reader, &pdb_reader, &pqr_reader,
                                                               &xyz_reader,  &cif_reader, &gro_reader};

const char *molecule_format_list(char out[FORMAT_LIST_BYTES], const char *prefix) {
  size_t at = 0;
  out[0] = '\0';
  for (int i = 0; i < FORMATS && at < FORMAT_LIST_BYTES; ++i) {
    const char *separator = i == 0 ? "" : i + 1 < FORMATS ? ", " : " or ";
    at += (size_t)snprintf(out + at, FORMAT_LIST_BYTES - at, "%s%s%s", separator, prefix, readers[i]->name);
  }
  return out;
}

/* Whether the name is one of the extensions between blanks. */
static bool is_extension(struct field name, const char *extensions) {
  for (const char *at = extensions; *at != '\0'; at += *at == ' ') {
    const char *begin = at;
    size_t same = 0;
    while (*at != '\0' && *at != ' ' && *at != '#') ++at;
    const size_t length = (size_t)(at - begin);
    while (same < length && same < name.length && to_upper(name.text[same]) == begin[same]) ++same;
    if (*at == '#') {
      while (same >= length && same < name.length && is_digit(name.text[same])) ++same;
      ++at;
    }
    if (same >= length && same == name.length) return true;
  }
  return false;
}

bool molecule_format_named(const char *name, enum molecule_format *format) {
  const struct field written = {name, strlen(name)};
  for (int i = 0; i < FORMATS; ++i) {
    if (!is_extension(written, readers[i]->extensions)) continue;
    *format = (enum molecule_format)i;
    return true;
  }
  return false;
}

bool molecule_format_of(const char *path, enum molecule_format *format, struct failure *failure) {
  const char *slash = strrchr(path, '/');
  const char *dot = strrchr(slash == NULL ? path : slash + 1, '.');
  const char *extension = dot == NULL ? "" : dot + 1;
  if (molecule_format_named(extension, format)) return true;
  failure->file = path;
  if (is_extension((struct field){extension, strlen(extension)}, "GZ Z BZ2 XZ ZST")) {
    return failure_in_input(failure, 0, "compressed; for instance: gunzip -c FILE | hardsphere measure - --format pdb");
  }
  char list[FORMAT_LIST_BYTES];
  return failure_in_input(failure, 0, "unknown extension; expected %s", molecule_format_list(list, "."));
}

bool format_has_radii(enum molecule_format format) {
  return readers[format]->has_radii;
}

bool format_has_elements(enum molecule_format format) {
  return readers[format]->has_elements;
}

bool format_has_residues(enum molecule_format format) {
  return readers[format]->has_residues;
}

bool format_has_hetatm(enum molecule_format format) {
  return readers[format]->has_hetatm;
}

const char *format_name(enum molecule_format format) {
  return readers[format]->name;
}

const char *format_unit(enum molecule_format format) {
  return readers[format]->unit;
}

void label_take_element(struct atom_label *label, struct field name) {
  const enum atom_kind kind = atom_kind_of(name, false, label->residue.name, &label->element);
  label->virtual_site = kind == ATOM_VIRTUAL;
  label->bead = kind == ATOM_BEAD;
  if (label->virtual_site) label->element = virtual_symbol_of(name);
}

void label_check_bead(struct atom_label *label) {
  const bool guessed = strcmp(label->element.text, "B") == 0 || strcmp(label->element.text, "S") == 0;
  label->bead = label->bead || (guessed && is_bead_name(label->name, label->residue.name));
  if (label->bead) label->element = (struct element_symbol){""};
}

bool read_announced_model(struct line_reader *reader, uint64_t count, announced_atoms *read_atoms,
                          struct molecule *molecule, struct failure *failure) {
  const uint64_t count_line = reader->number;
  const bool wanted = ++molecule->models == molecule->model;
  uint64_t read = 0;
  if (read_atoms(reader, count, wanted, molecule, &read, failure) == LINE_FAILED) return false;
  if (!wanted) molecule->left_out.other_models += read;
  /* What breaks off behind the model that is wanted, as in a run that was stopped, does not concern it. */
  if (read == count || molecule->models > molecule->model) return true;
  return failure_in_input(failure, count_line, "%" PRIu64 " atoms announced, the file ends after %" PRIu64, count,
                          read);
}

enum line_status read_next_model(enum molecule_format format, struct line_reader *reader, bool *begun, bool wanted,
                                 struct molecule *molecule, struct failure *failure) {
  molecule->models = 0;
  molecule->model = wanted ? 1 : 2;
  return readers[format]->next(reader, begun, wanted, molecule, failure);
}

bool format_has_frames(enum molecule_format format) {
  return readers[format]->next != NULL;
}

/* Nothing follows from a file without atoms, but that something went wrong before. */
static bool check_atoms(const struct molecule *molecule, struct failure *failure) {
  if (molecule->model > 1 && molecule->model > molecule->models) {
    return failure_in_input(failure, 0, "no model %" PRIu64 ": the file has %" PRIu64, molecule->model,
                            molecule->models);
  }
  if (molecule->atoms > 0) return true;
  if (molecule->models <= 1) return failure_in_input(failure, 0, "no atoms in the file");
  return failure_in_input(failure, 0, "no atoms in model %" PRIu64, molecule->model);
}

bool read_molecule(const char *path, enum molecule_format format, uint64_t model, struct molecule *molecule,
                   struct failure *failure) {
  molecule_init(molecule, format, model);
  failure->file = input_name(path);
  struct line_reader *reader = malloc(sizeof *reader);
  if (reader == NULL) return failure_of_memory(failure);
  bool done = line_reader_open(reader, path, failure);
  if (done) {
    done = readers[format]->read(reader, molecule, failure);
    line_reader_close(reader);
  }
  free(reader);
  return done && check_atoms(molecule, failure);
}
