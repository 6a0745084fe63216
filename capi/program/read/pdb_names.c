#include "read/pdb_names.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/characters.h"
#include "read/growing_array.h"
#include "read/residue_kinds.h"

enum way { LONG_RESIDUE, LONG_CHAIN, EITHER };

/* Lipids: two letters for the tails, and the head, PC or PE; and sterols. */
static bool is_lipid(const char *name) {
  static const char tails[] = "DA DB DE DL DM DO DP DS DY PD PL PO SA SD SL SO";
  static const char *const others[] = {"CHL1", "CHOL", "CHSD", "ERG1"};
  char capital[5];
  to_capitals(capital, sizeof capital, name, 4);
  for (size_t k = 0; k < sizeof others / sizeof others[0]; ++k) {
    if (strcmp(capital, others[k]) == 0) return true;
  }
  if (capital[2] != 'P' || strchr("ACEGIS", capital[3]) == NULL) return false;
  for (const char *at = tails; at[0] != '\0'; at += at[2] == '\0' ? 2 : 3) {
    if (at[0] == capital[0] && at[1] == capital[1]) return true;
  }
  return false;
}

static bool is_known(struct field name) {
  char label[5];
  label_copy(label, sizeof label, name);
  return residue_kind_of(label) != RESIDUE_OTHER || (name.length == 4 && is_lipid(label));
}

/* Which way a record with a letter in column 21 shows. */
static enum way way_of(const char *text) {
  if (text[19] == ' ') return LONG_CHAIN;
  if (text[21] == ' ' || is_known(field_in_columns(text, 22, 18, 21))) return LONG_RESIDUE;
  return is_known(field_in_columns(text, 22, 18, 20)) ? LONG_CHAIN : EITHER;
}

static bool chains_are_long(const struct pdb_names *names) {
  return names->long_chains > names->long_residues;
}

void pdb_names_read(const struct pdb_names *names, const char *text, struct residue_label *residue) {
  bool chain = false;
  if (text[20] != ' ') {
    const enum way way = way_of(text);
    chain = way == LONG_CHAIN || (way == EITHER && chains_are_long(names));
  }
  label_copy(residue->name, sizeof residue->name, field_in_columns(text, 22, 18, chain ? 20 : 21));
  label_copy(residue->chain, sizeof residue->chain, field_in_columns(text, 22, chain ? 21 : 22, 22));
}

bool pdb_names_note(struct pdb_names *names, const char *text, struct molecule *molecule, struct failure *failure) {
  struct residue_label *const residue = molecule_last_residue(molecule);
  if (residue == names->last) return true;
  names->last = residue;
  const enum way way = way_of(text);
  if (way == LONG_RESIDUE) ++names->long_residues;
  if (way == LONG_CHAIN && text[19] != ' ') ++names->long_chains;
  if (text[19] == ' ' || text[21] == ' ') return true;
  return array_append(&names->either, &names->count, &names->room, &residue, sizeof residue) ||
         failure_of_memory(failure);
}

void pdb_names_number(struct pdb_names *names, uint64_t ends, const char *atom, struct residue_label *residue) {
  const bool loose = residue_kind_of(residue->name) == RESIDUE_WATER || strcmp(residue->name, atom) == 0;
  if (names->number == 0 || (ends != names->ends && !(loose && names->loose))) ++names->number;
  names->ends = ends;
  names->loose = loose;
  if (names->number > 1) snprintf(residue->chain, sizeof residue->chain, ".%" PRIu32, (uint32_t)names->number);
}

/* The letter in column 21 is the last one of the residue's name or the first one of the chain's, which the number of a
 * copy may follow. */
static void name_anew(struct residue_label *residue, bool long_chain) {
  const size_t name = strlen(residue->name), chain = strlen(residue->chain);
  const bool is_long = chain > 1 && residue->chain[1] != '-';
  if (is_long == long_chain || name + 1 >= sizeof residue->name || chain + 1 >= sizeof residue->chain) return;
  if (long_chain) {
    memmove(residue->chain + 1, residue->chain, chain + 1);
    residue->chain[0] = residue->name[name - 1];
    residue->name[name - 1] = '\0';
  } else {
    residue->name[name] = residue->chain[0];
    memmove(residue->chain, residue->chain + 1, chain);
  }
}

void pdb_names_finish(struct pdb_names *names) {
  for (size_t k = 0; k < names->count; ++k) name_anew(names->either[k], chains_are_long(names));
}

void pdb_names_free(struct pdb_names *names) {
  free(names->either);
  memset(names, 0, sizeof *names);
}
