/* The choice of the atoms of a file that become balls, by --only, --hide and options like them. */
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
 * An item of `chain` is a chain's name as written in the file; "." is a chain without a name (TER records divide those
 * into ".1", ".2" ..). An item of `element` is a symbol, one of `atom` an atom's name. An item of `residue` is a
 * residue's name, its number with the insertion code, or a number or a range of numbers, A-B, with any insertion code.
 * If an end of a range has a code, 52A-53, residues are ordered by number, then by code, no code before A. An item of
 * `group` is a group of an index file, by its name or, from 0 on, its number; "_&_" within it belongs to the name.
 * Chains and groups are case-sensitive, all other items are not. */
struct selection_item;

/* The selections of a command line. They point to its texts. */
struct selection {
  struct selection_item *items;
  size_t count;
  size_t capacity;
  bool only; /* one of them names the atoms to be read */
};

#define SELECTION_EVERYTHING \
  { NULL, 0, 0, false }

/* Add a selection of atoms to be read, or, if `hide`, of atoms to be left out. `option` is the option that the user
 * wrote before it. False: it is no selection, and the failure says so, or memory is short. */
bool selection_add(struct selection *selection, const char *option, const char *text, bool hide,
                   struct failure *failure);

/* Whether files of the format tell what a selection asks for, and the index file has its groups. The index file must
 * stay where it is in memory. */
bool selection_suits(struct selection *selection, const struct file_format *format, const struct index_file *index,
                     struct failure *failure);

/* Whether an atom becomes a ball: it is named by one of the selections of atoms to be read, if there is any, and by
 * none of those to be left out. */
bool selection_takes(const struct selection *selection, const struct molecule *molecule, uint32_t atom);

/* Add "--only chain:Z, --hide residue:UNK": the items that fit no atom of the molecule, and selections whose items each
 * fit some atom, but together none. */
void selection_list_unmatched(const struct selection *selection, const struct molecule *molecule,
                              struct text_buffer *out);

/* Leave out the atoms that are not taken and count them; false if none is left. */
bool selection_apply(const struct selection *selection, struct molecule *molecule, struct failure *failure);

/* Leave out water, unless there is nothing else. */
void selection_hide_water(struct molecule *molecule);

void selection_free(struct selection *selection);
