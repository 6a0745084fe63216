/* Which atoms of a file become balls, as --only, --hide and their kin say. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/index_file.h"
#include "read/molecule.h"
#include "read/text_buffer.h"

/* A selection is written
 *   selection = term {"&" term}              all of the terms hold
 *   term      = key ":" item {"," item}      one of the items holds
 *             | "water" | "hetatm" | "hydrogen"
 *   key       = "chain" | "residue" | "element" | "atom" | "group"
 * An item of `chain` is a chain's name as it stands, "." for those without one, of which TER records make ".1", ".2"
 * ..; of `element` a symbol; of `atom` an atom's name. An item of `residue` is a residue's name, its number with the
 * insertion code, or a number or a range of numbers, A-B, whatever the insertion code; where an end of a range has one,
 * 52A-53, it is of numbers and then of codes, none before A; of `group` a group of an index file, by its name or, from
 * 0 on, its number; "_&_" in it is of the name. Chains and groups are case-sensitive, all other items are not. */
struct selection_item;

/* The selections of a command line. They point to its texts. */
struct selection {
  struct selection_item *items;
  size_t count;
  size_t capacity;
  bool only; /* there is one that names the atoms to be read */
};

#define SELECTION_EVERYTHING \
  { NULL, 0, 0, false }

/* Add a selection: of the atoms to be read, if any are named so, or of atoms to be left out. `option` is what the user
 * wrote before it. False: it is none, and the failure says so, or memory is short. */
bool selection_add(struct selection *selection, const char *option, const char *text, bool hide,
                   struct failure *failure);

/* Whether files of the format say what a selection asks for, and the index file has its groups, which must stay where
 * it is. */
bool selection_suits(struct selection *selection, const struct file_format *format, const struct index_file *index,
                     struct failure *failure);

/* Whether an atom becomes a ball: it is named by one of the selections of atoms to be read, if there is any, and by
 * none of those to be left out. */
bool selection_takes(const struct selection *selection, const struct molecule *molecule, uint32_t atom);

/* Add "--only chain:Z, --hide residue:UNK": the items that no atom of the molecule has, and selections that it has all
 * items of but no atom with all of them. */
void selection_list_unmatched(const struct selection *selection, const struct molecule *molecule,
                              struct text_buffer *out);

/* Leave out the atoms that are not taken and count them; false if none is left. */
bool selection_apply(const struct selection *selection, struct molecule *molecule, struct failure *failure);

/* Leave out water, unless there is nothing else. */
void selection_hide_water(struct molecule *molecule);

void selection_free(struct selection *selection);
