#include "draw/ball_groups.h"

#include "read/residues.h"

bool ball_groups_make(const struct drawing *drawing, const struct molecule *molecule, uint32_t **group,
                      struct failure *failure) {
  if (!chain_numbers_make(molecule, group, failure)) return false;
  uint32_t chains = 0;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    if ((*group)[i] >= chains) chains = (*group)[i] + 1;
  }
  uint32_t residue = 0; /* counted along the file */
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const struct atom_label *label = &molecule->label[i];
    if (i > 0 && !residue_label_same(molecule->label[i - 1].residue, label->residue)) ++residue;
    if (drawing->colour == COLOUR_RESIDUE || !atom_is_of_chain(label)) (*group)[i] = chains + residue;
  }
  return true;
}
