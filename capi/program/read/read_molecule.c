#include "read/read_molecule.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/characters.h"
#include "read/number.h"
#include "read/residue_kinds.h"

void label_take_element(struct kinds_seen *seen, struct atom_label *label, struct field name) {
  const char *const residue = label->residue->name;
  const enum atom_kind kind = seen == NULL ? atom_kind_of(name, false, residue, &label->element)
                                           : atom_kind_again(seen, name, residue, &label->element);
  label->virtual_site = kind == ATOM_VIRTUAL;
  label->bead = kind == ATOM_BEAD;
  if (label->virtual_site) label->element = virtual_symbol_of(name);
}

bool label_take_symbol(struct atom_label *label, struct field text) {
  uint64_t number;
  if (number_parse_count(text.text, text.length, &number) == NUMBER_OK) {
    label->by_number = true;
    return element_symbol_of_number(number, &label->element);
  }
  size_t letters = 0;
  while (letters < text.length && is_letter(text.text[letters])) ++letters;
  if (!element_symbol_parse(text.text, letters, &label->element)) return false;
  /* X is no unknown atom here, but a dummy that an internal coordinate was defined by. */
  label->virtual_site = is_virtual_symbol(label->element) || element_is_unknown(label->element);
  return true;
}

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

void label_check_bead(struct atom_label *label) {
  const bool guessed = strcmp(label->element.text, "B") == 0 || strcmp(label->element.text, "S") == 0;
  label->bead = label->bead || (guessed && is_bead_name(label->name, label->residue->name));
  if (label->bead) label->element = (struct element_symbol){""};
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
  }
  free(reader);
  molecule->copy = 0; /* what comes now is named as it is */
  return done && check_atoms(molecule, failure) && (choice->assembly == NULL || assembly_make(molecule, failure));
}
