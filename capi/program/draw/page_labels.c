#include "draw/page_labels.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw/drawing.h"
#include "read/geometry.h"
#include "read/residues.h"

/* The face of the ball with most room, if anything is seen of it. Its faces are on the left of its outline. */
static int32_t find_widest(const hsp_map *map, uint32_t ball, bool *seen, hsp_map_pole *widest) {
  uint32_t count = 0;
  int32_t status = hsp_map_get_outline(map, ball, NULL, 0, &count);
  *seen = false;
  if (status != HSP_E_CAPACITY) return status; /* no loops */
  uint32_t *loops = malloc(count * sizeof *loops);
  if (loops == NULL) return HSP_E_MEMORY;
  status = hsp_map_get_outline(map, ball, loops, count, &count);
  for (uint32_t i = 0; status == HSP_OK && i < count; ++i) {
    hsp_map_pole pole;
    status = hsp_map_get_pole(map, hsp_map_left(map, loops[i]), &pole);
    if (status != HSP_OK || (*seen && pole.radius <= widest->radius)) continue;
    *widest = pole;
    *seen = true;
  }
  free(loops);
  return status;
}

static bool has_several_chains(const struct molecule *molecule) {
  for (uint32_t i = 1; i < molecule->atoms; ++i) {
    if (strcmp(molecule->label[i].residue->chain, molecule->label[0].residue->chain) != 0) return true;
  }
  return false;
}

/* Residues of several chains with the chain's letter. */
static void name_label(char *out, size_t room, const struct molecule *molecule, uint32_t atom, int kind, bool several) {
  const struct atom_label *label = &molecule->label[atom];
  const struct residue_label *residue = label->residue;
  if (kind == LABEL_CHAIN) {
    snprintf(out, room, "%s", residue->chain);
  } else if (kind == LABEL_RESIDUE) {
    const char *const blank = several && residue->chain[0] != '\0' ? " " : "";
    snprintf(out, room, "%s%s%s %s%s", residue->name, blank, several ? residue->chain : "", residue->number,
             residue->insertion);
  } else if (label->name[0] != '\0') {
    snprintf(out, room, "%s", label->name);
  } else {
    snprintf(out, room, "%s%u", label->element.text, (unsigned)atom + 1);
  }
}

/* Whether the atom belongs to the same thing as an earlier one. Residues stand together in a file. */
static bool belongs(const struct molecule *molecule, uint32_t atom, uint32_t earlier, int kind) {
  const struct residue_label *a = molecule->label[atom].residue;
  const struct residue_label *b = molecule->label[earlier].residue;
  if (kind == LABEL_CHAIN) return strcmp(a->chain, b->chain) == 0;
  return kind == LABEL_RESIDUE && residue_label_same(a, b);
}

bool page_labels_find(const hsp_map *map, const struct molecule *molecule, const struct selection *selected, int kind,
                      struct page_label **labels, uint32_t *count, struct failure *failure) {
  struct page_label *const found = calloc((size_t)molecule->atoms + 1, sizeof *found);
  uint32_t *const last = calloc((size_t)molecule->atoms + 1, sizeof *last); /* the last atom of each label */
  uint32_t made = 0;
  const bool several = has_several_chains(molecule);
  int32_t status = found == NULL || last == NULL ? HSP_E_MEMORY : HSP_OK;
  for (uint32_t atom = 0; status == HSP_OK && atom < molecule->atoms; ++atom) {
    bool seen = false;
    hsp_map_pole pole = {{0.0, 0.0}, 0.0, 0.0};
    if (!selection_takes(selected, molecule, atom)) continue;
    status = find_widest(map, atom, &seen, &pole);
    if (status != HSP_OK || !seen) continue;
    /* Few chains, and residues whose last atom is near: most labels are found at the end. */
    uint32_t at = made;
    while (at > 0 && !belongs(molecule, atom, last[at - 1], kind)) at = kind == LABEL_CHAIN ? at - 1 : 0;
    if (at == 0) {
      at = ++made;
      name_label(found[at - 1].text, sizeof found[at - 1].text, molecule, atom, kind, several);
    }
    struct page_label *const label = &found[at - 1];
    last[at - 1] = atom;
    if (pole.radius <= label->radius) continue;
    label->radius = pole.radius;
    label->atom = atom;
    memcpy(label->at, pole.centre, sizeof label->at);
  }
  free(last);
  if (status == HSP_OK) {
    *labels = found;
    *count = made;
    return true;
  }
  free(found);
  return failure_in_library(failure, status);
}
