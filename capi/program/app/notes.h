/* Notes that a user should read of a run that went well and shows it nowhere else: lines on stderr. */
#ifndef HARDSPHERE_TOOL_NOTES_H
#define HARDSPHERE_TOOL_NOTES_H

#include "commands/request.h"
#include "read/molecule.h"
#include "read/text_buffer.h"

/* Names in lists that nothing has: "--only chain:Z, --radius Xx". */
struct notes {
  struct text_buffer unmatched;
  struct text_buffer assemblies; /* that the file states and that are not what is read */
  struct text_buffer symmetry;   /* that the box is not filled by */
  uint64_t waters;               /* that are counted where the output cannot say so: in --csv */
  uint64_t labels, labels_left_out;
  double largest_rounding; /* as hsp_model_info has it */
};

#define NOTES_NONE \
  { TEXT_BUFFER_EMPTY, TEXT_BUFFER_EMPTY, TEXT_BUFFER_EMPTY, 0, 0, 0, 0.0 }

/* Look for what the file states beside the atoms that were read. */
void notes_look_at_file(struct notes *notes, const struct request *request, struct molecule *molecule);

/* Look for the names of --only, --hide and --radius among all atoms of a file. */
void notes_look_among_all(struct notes *notes, const struct request *request, const struct molecule *molecule);

/* Look for those of --highlight among the atoms that are left. */
void notes_look_among_chosen(struct notes *notes, const struct request *request, const struct molecule *molecule);

/* Count water among the atoms that were measured, and look whether the box was filled. */
void notes_look_at_result(struct notes *notes, const struct request *request, const struct molecule *molecule);

/* A line for the names, one for assemblies, one for symmetry, one for water, one for labels without room, and one for a
 * lattice that is coarse. */
void notes_print(const struct notes *notes, const struct request *request);

void notes_free(struct notes *notes);

#endif
