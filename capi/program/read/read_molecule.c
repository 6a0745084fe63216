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

static bool read_all(struct line_reader *reader, struct molecule *molecule, struct failure *failure) {
  const bool done = molecule->format->read(reader, molecule, failure);
  if (done) molecule_agree_elements(molecule);
  molecule->copy = 0; /* further atoms have their own names */
  return done && check_atoms(molecule, failure);
}

bool read_molecule(const char *path, const struct file_format *format, const struct file_choice *choice, unsigned keeps,
                   struct molecule *molecule, struct failure *failure) {
  struct line_reader reader;
  molecule_init(molecule, format, choice, keeps);
  failure->file = input_name(path);
  if (!line_reader_open(&reader, path, failure)) return false;
  const bool done = read_all(&reader, molecule, failure);
  line_reader_close(&reader);
  return done && (choice->assembly == NULL || assembly_make(molecule, failure));
}

bool read_molecule_text(struct molecule_text *text, const struct file_format *format, const struct file_choice *choice,
                        unsigned keeps, struct molecule *molecule, struct failure *failure) {
  struct line_reader reader;
  if (molecule->format == NULL) molecule_init(molecule, format, choice, keeps);
  molecule_renew(molecule);
  if (!text_buffer_reserve(&text->text, LINE_READER_ROOM)) return failure_of_memory(failure);
  line_reader_open_text(&reader, text->text.text, text->text.length);
  const bool done = read_all(&reader, molecule, failure);
  line_reader_close(&reader);
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const uint64_t line = molecule_text_line(text, molecule->line[i]);
    molecule->line[i] = line <= UINT32_MAX ? (uint32_t)line : 0;
  }
  if (!done) failure->line = molecule_text_line(text, failure->line);
  return done;
}
