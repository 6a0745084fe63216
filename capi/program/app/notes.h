/* Notes that a user should read of a run that went well and shows it nowhere else: lines on stderr. */
#pragma once

#include "commands/request.h"
#include "read/molecule.h"
#include "read/text_buffer.h"

struct notes {
  struct text_buffer lines;                 /* of the file, each ended by '\n' */
  struct text_buffer unmatched;             /* names in lists that nothing has: "--only chain:Z, --radius Xx" */
  struct text_buffer assemblies;            /* that the file states and that are not what is read */
  uint64_t waters;                          /* that are counted where the output cannot say so: in --csv */
  uint64_t dummies;                         /* and virtual sites, which are left out */
  uint64_t contradicted, contradicted_line; /* atoms whose name says another element than the file, and the first */
  char contradicted_name[8];
  struct element_symbol stated; /* its element */
  uint64_t labels, labels_left_out;
  double largest_rounding; /* as hsp_model_info has it */
};

#define NOTES_NONE \
  { TEXT_BUFFER_EMPTY, TEXT_BUFFER_EMPTY, TEXT_BUFFER_EMPTY, 0, 0, 0, 0, "", {""}, 0, 0, 0.0 }

/* Look for strange things in a file that was read: molecules that were not, atoms without places, and what the file
 * states beside its atoms. */
void notes_look_at_file(struct notes *notes, const struct request *request, struct molecule *molecule);

/* Look for the names of --only, --hide and --radius among all atoms of a file, and for contradictions. */
void notes_look_among_all(struct notes *notes, const struct request *request, const struct molecule *molecule);

/* Look for those of --highlight among the atoms that are left. */
void notes_look_among_chosen(struct notes *notes, const struct request *request, const struct molecule *molecule);

/* Note that copies by symmetry are asked for and not made. */
void notes_look_at_symmetry(struct notes *notes, const struct request *request, const struct symmetry *symmetry);

/* Count water among the atoms that were measured, and what is no atom among those that were read. */
void notes_look_at_result(struct notes *notes, const struct request *request, const struct molecule *molecule);

/* Those of the file, and a line each for names that nothing has, assemblies, contradictions, dummies, water, labels
 * without room, and a coarse lattice. */
void notes_print(const struct notes *notes, const struct request *request);

/* Whether there is nothing to print. */
bool notes_are_none(const struct notes *notes);

void notes_free(struct notes *notes);
