/* Notes on a successful run that a user should read and that its output does not show: lines on stderr. */
#pragma once

#include "commands/request.h"
#include "read/molecule.h"
#include "read/text_buffer.h"

struct notes {
  struct text_buffer lines;                 /* lines about the file, each ended by '\n' */
  struct text_buffer unmatched;             /* names that fit nothing: "--only chain:Z, --radius Xx" */
  struct text_buffer assemblies;            /* assemblies that the file states and that were not read */
  uint64_t waters;                          /* water molecules counted in an output that cannot say so: --csv */
  uint64_t dummies;                         /* dummies and virtual sites, which are left out */
  uint64_t contradicted, contradicted_line; /* atoms whose name contradicts their element; the line of the first */
  char contradicted_name[8];                /* the first one's name */
  struct element_symbol stated;             /* and the element that the file states for it */
  uint64_t labels, labels_left_out;
  double largest_rounding; /* of hsp_model_info */
};

#define NOTES_NONE \
  { TEXT_BUFFER_EMPTY, TEXT_BUFFER_EMPTY, TEXT_BUFFER_EMPTY, 0, 0, 0, 0, "", {""}, 0, 0, 0.0 }

/* Note peculiarities of a file that was read: molecules that were not read, atoms without coordinates, and what the
 * file states beside its atoms. */
void notes_look_at_file(struct notes *notes, const struct request *request, struct molecule *molecule);

/* Note names of --only, --hide and --radius that no atom of the file has, and contradicted elements. */
void notes_look_among_all(struct notes *notes, const struct request *request, const struct molecule *molecule);

/* Note names of --highlight that none of the remaining atoms has. */
void notes_look_among_chosen(struct notes *notes, const struct request *request, const struct molecule *molecule);

/* Note that copies by symmetry were asked for, but not made. */
void notes_look_at_symmetry(struct notes *notes, const struct request *request, const struct symmetry *symmetry);

/* Count water molecules among the measured atoms, and dummies and virtual sites among those read. */
void notes_look_at_result(struct notes *notes, const struct request *request, const struct molecule *molecule);

/* Print the lines about the file, and a line each for names that fit nothing, assemblies, contradictions, dummies,
 * water, labels without room, and a coarse lattice. */
void notes_print(const struct notes *notes, const struct request *request);

/* Whether there is nothing to print. */
bool notes_are_none(const struct notes *notes);

void notes_free(struct notes *notes);
