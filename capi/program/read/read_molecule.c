#include "read/read_molecule.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/atom_elements.h"
#include "read/number.h"

bool serial_of_number(struct field text, struct serial_label *serial) {
  static const char digits[] = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  uint64_t number;
  size_t at = sizeof serial->text - 1;
  if (number_parse_count(text.text, text.length, &number) != NUMBER_OK) return false;
  serial->text[at] = '\0';
  while (at > 0) {
    serial->text[--at] = digits[number % 36];
    number /= 36;
  }
  return number == 0;
}

bool read_announced_model(struct line_reader *reader, uint64_t count, announced_atoms *read_atoms,
                          struct molecule *molecule, struct failure *failure) {
  const uint64_t count_line = reader->number;
  const bool wanted = molecule_wants_model(molecule, ++molecule->models);
  uint64_t read = 0;
  if (read_atoms(reader, count, wanted, molecule, &read, failure) == LINE_FAILED) return false;
  if (!wanted) molecule->left_out.other_models += read;
  /* A break after the model that is wanted, as in a run that was stopped, does not concern it. */
  if (read == count || molecule->models > molecule->model) return true;
  return failure_in_input(failure, count_line, "%" PRIu64 " atoms announced, the file ends after %" PRIu64, count,
                          read);
}

/* Nothing follows from a file without atoms, but that something went wrong before. */
static bool check_atoms(const struct molecule *molecule, struct failure *failure) {
  if (molecule->model > 1 && molecule->model != EVERY_MODEL && molecule->model > molecule->models) {
    return failure_in_input(failure, 0, "no model %" PRIu64 ": the file has %" PRIu64, molecule->model,
                            molecule->models);
  }
  if (molecule->atoms > 0) return true;
  if (molecule->models <= 1 || molecule->model == EVERY_MODEL)
    return failure_in_input(failure, 0, "no atoms in the file");
  return failure_in_input(failure, 0, "no atoms in model %" PRIu64, molecule->model);
}

bool read_molecule(const char *path, const struct file_format *format, const struct file_choice *choice, unsigned keeps,
                   struct molecule *molecule, struct failure *failure) {
  molecule_init(molecule, format, choice, keeps);
  failure->file = input_name(path);
  struct line_reader *reader = malloc(sizeof *reader);
  if (reader == NULL) return failure_of_memory(failure);
  bool done = line_reader_open(reader, path, failure);
  if (done) {
    done = format->read(reader, molecule, failure);
    line_reader_close(reader);
    if (done) molecule_agree_elements(molecule);
  }
  free(reader);
  molecule->copy = 0; /* what comes now is named as it is */
  return done && check_atoms(molecule, failure) && (choice->assembly == NULL || assembly_make(molecule, failure));
}
