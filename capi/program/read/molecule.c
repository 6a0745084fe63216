#include "read/molecule.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hardsphere.h"
#include "read/characters.h"
#include "read/growing_array.h"
#include "read/residue_kinds.h"
#include "read/text_buffer.h"

const struct residue_label residue_nameless = RESIDUE_LABEL_NONE;

enum { RESIDUES_OF_BLOCK = 256 };

struct residue_block {
  struct residue_block *next;
  struct residue_label label[RESIDUES_OF_BLOCK];
};

void molecule_init(struct molecule *molecule, const struct file_format *format, const struct file_choice *choice,
                   unsigned keeps) {
  const struct file_choice own = *choice; /* it may be the molecule's */
  memset(molecule, 0, sizeof *molecule);
  molecule->keeps = keeps;
  molecule->format = format;
  molecule->choice = own;
  molecule->model = own.model;
  molecule->most = HSP_MAX_BALLS;
}

void molecule_empty(struct molecule *molecule) {
  molecule->atoms = molecule->read = 0;
  molecule->residues.last = molecule->residues.first;
  molecule->residues.used = 0;
  molecule->residue_begin = 0;
  molecule->bonds = 0;
}

void molecule_renew(struct molecule *molecule) {
  symmetry_free(&molecule->symmetry);
  assemblies_free(&molecule->assemblies);
  name_table_free(&molecule->asyms);
  const struct molecule old = *molecule;
  molecule_init(molecule, old.format, &old.choice, old.keeps);
  molecule->capacity = old.capacity;
  molecule->xyz = old.xyz;
  molecule->radius = old.radius;
  molecule->line = old.line;
  molecule->label = old.label;
  molecule->place = old.place;
  molecule->coordinate = old.coordinate;
  molecule->extra = old.extra;
  molecule->residues = old.residues;
  molecule->bond = old.bond;
  molecule->bond_capacity = old.bond_capacity;
  molecule_empty(molecule);
}

static bool same_name(const struct molecule *molecule, uint32_t atom, const char *name) {
  return memcmp(molecule->label[atom].name, name, sizeof molecule->label->name) == 0;
}

/* Whether the atom begins another residue of the same names, by its own. */
static bool begins_again(const struct molecule *molecule, const struct residue_label *residue, const char *name) {
  enum { MOST = 512 }; /* atoms of a residue */
  const uint32_t last = molecule->atoms - 1;
  const uint32_t first = last - molecule->residue_begin < MOST ? molecule->residue_begin : last - MOST;
  const enum residue_kind kind = residue_kind_of(residue->name);
  const bool any = strcmp(residue->name, "UNK") == 0 || strcmp(residue->name, "UNL") == 0;
  if (residue->number[0] == '\0' && (kind == RESIDUE_OTHER || any) && strcmp(name, residue->name) != 0) return false;
  if (same_name(molecule, molecule->residue_begin, name)) return true;
  if (same_name(molecule, last, name)) return false;
  for (uint32_t atom = first; atom < last; ++atom) {
    if (same_name(molecule, atom, name)) return true;
  }
  return false;
}

/* The residue of the next atom; NULL: memory is short. */
static const struct residue_label *keep_residue(struct molecule *molecule, const struct atom_label *label) {
  struct residue_list *const list = &molecule->residues;
  const struct residue_label *const residue = label->residue;
  if (residue == &residue_nameless) return residue;
  struct residue_block *block = list->last;
  uint16_t repeat = 0;
  if (list->used > 0) {
    const struct residue_label *const before = &block->label[list->used - 1];
    const size_t names = offsetof(struct residue_label, repeat);
    if (residue == before || (memcmp(before, residue, names) == 0 && before->asym == residue->asym)) {
      const bool follows = molecule->residue_begin < molecule->atoms; /* an atom of it is there */
      if (residue_is_numbered(before) || !follows || !begins_again(molecule, before, label->name)) return before;
      repeat = (uint16_t)(before->repeat + 1);
    }
  }
  if (block == NULL || list->used == RESIDUES_OF_BLOCK) {
    struct residue_block *next = block == NULL ? NULL : block->next;
    if (next == NULL) {
      next = malloc(sizeof *next);
      if (next == NULL) return NULL;
      next->next = NULL;
      *(block == NULL ? &list->first : &block->next) = next;
    }
    list->last = block = next;
    list->used = 0;
  }
  molecule->residue_begin = molecule->atoms;
  block->label[list->used] = *residue;
  block->label[list->used].repeat = repeat;
  return &block->label[list->used++];
}

bool chain_name_copy(struct residue_label *residue, uint64_t copy, struct failure *failure) {
  char name[sizeof residue->chain + 24];
  if (copy < 2) return true;
  const size_t length = (size_t)snprintf(name, sizeof name, "%s-%" PRIu64, residue->chain, copy);
  if (length >= sizeof residue->chain) {
    char shown[EXCERPT_BYTES];
    return failure_in_input(failure, 0, "a chain's name is too long for its copy's: '%s'",
                            excerpt(shown, name, length));
  }
  memset(residue->chain, 0, sizeof residue->chain); /* labels have zeros behind their texts */
  memcpy(residue->chain, name, length);
  return true;
}

bool label_fits(struct field text, size_t room, const char *what, uint64_t line, struct failure *failure) {
  char shown[EXCERPT_BYTES];
  return text.length < room ||
         failure_in_input(failure, line, "%s '%s' has more than %d letter%s", what,
                          excerpt(shown, text.text, text.length), (int)room - 1, room == 2 ? "" : "s");
}

bool label_take(char *out, size_t room, struct field text, const char *what, uint64_t line, struct failure *failure) {
  if (!label_fits(text, room, what, line, failure)) return false;
  label_copy(out, room, text);
  return true;
}

bool chain_is_nameless(const char *chain) {
  return chain[0] == '\0' || ((chain[0] == '.' || chain[0] == '-') && chain[1] >= '1' && chain[1] <= '9');
}

bool chain_is_named(const char *chain, struct field name) {
  if (name.length == 1 && name.text[0] == '.' && chain_is_nameless(chain)) return true;
  if (chain[0] == '\0') chain = ".1";
  return strlen(chain) == name.length && memcmp(chain, name.text, name.length) == 0;
}

static bool grow(struct molecule *molecule) {
  const size_t capacity = molecule->capacity == 0 ? 4096 : 2 * (size_t)molecule->capacity;
  if (capacity > SIZE_MAX / (4 * sizeof(struct atom_label))) return false;
  double *xyz = realloc(molecule->xyz, capacity * sizeof *xyz * 3);
  if (xyz != NULL) molecule->xyz = xyz;
  double *radius = realloc(molecule->radius, capacity * sizeof *radius);
  if (radius != NULL) molecule->radius = radius;
  uint32_t *line = realloc(molecule->line, capacity * sizeof *line);
  if (line != NULL) molecule->line = line;
  struct atom_label *label = realloc(molecule->label, capacity * sizeof *label);
  if (label != NULL) molecule->label = label;
  if (xyz == NULL || radius == NULL || line == NULL || label == NULL) return false;
  if (molecule->keeps & KEEP_PLACES) {
    uint32_t *place = realloc(molecule->place, capacity * sizeof *place);
    if (place != NULL) molecule->place = place;
    uint32_t *coordinate = realloc(molecule->coordinate, capacity * sizeof *coordinate);
    if (coordinate != NULL) molecule->coordinate = coordinate;
    if (place == NULL || coordinate == NULL) return false;
  }
  if (molecule->keeps & KEEP_EXTRAS) {
    struct atom_extra *extra = realloc(molecule->extra, capacity * sizeof *extra);
    if (extra == NULL) return false;
    molecule->extra = extra;
  }
  molecule->capacity = (uint32_t)capacity; /* at most twice HSP_MAX_BALLS */
  return true;
}

uint32_t molecule_atoms_of_file(const struct molecule *molecule) {
  const uint64_t atoms = molecule->read + molecule->left_out.alternate_locations + molecule->left_out.unplaced;
  return atoms < UINT32_MAX ? (uint32_t)atoms : UINT32_MAX;
}

bool molecule_add(struct molecule *molecule, const double xyz[3], double radius, const struct atom_label *label,
                  uint64_t line, struct failure *failure) {
  if (molecule->read == molecule->most) {
    const bool library = molecule->most == HSP_MAX_BALLS;
    return failure_in_input(failure, line, "more than %" PRIu32 " atoms%s", molecule->most,
                            library ? "" : ", which the molecule has");
  }
  if (molecule->atoms == molecule->capacity && !grow(molecule)) return failure_of_memory(failure);
  const struct residue_label *const residue = keep_residue(molecule, label);
  if (residue == NULL) return failure_of_memory(failure);
  const size_t atom = molecule->atoms++;
  memcpy(molecule->xyz + 3 * atom, xyz, 3 * sizeof *xyz);
  molecule->radius[atom] = radius;
  molecule->line[atom] = line <= UINT32_MAX ? (uint32_t)line : 0;
  molecule->label[atom] = *label;
  molecule->label[atom].residue = residue;
  if (molecule->place != NULL) molecule->place[atom] = molecule_atoms_of_file(molecule);
  if (molecule->coordinate != NULL) molecule->coordinate[atom] = molecule->read;
  if (molecule->extra != NULL) molecule->extra[atom] = (struct atom_extra)ATOM_EXTRA_NONE;
  ++molecule->read;
  return true;
}

struct atom_extra *molecule_last_extra(const struct molecule *molecule) {
  return molecule->extra == NULL ? NULL : &molecule->extra[molecule->atoms - 1];
}

struct residue_label *molecule_last_residue(const struct molecule *molecule) {
  return &molecule->residues.last->label[molecule->residues.used - 1];
}

bool molecule_add_bond(struct molecule *molecule, const struct stated_bond *bond, struct failure *failure) {
  return array_append(&molecule->bond, &molecule->bonds, &molecule->bond_capacity, bond, sizeof *bond) ||
         failure_of_memory(failure);
}

/* Elements without a radius, each with its first line and its atoms. */
struct missing {
  struct element_symbol element;
  uint64_t line;
  uint32_t atoms;
};

enum { MOST_MISSING = 8 }; /* as many as one line of text has room for */

static bool report_missing(const struct missing *missing, size_t count, bool more, struct failure *failure) {
  struct text_buffer list = TEXT_BUFFER_EMPTY;
  struct text_buffer options = TEXT_BUFFER_EMPTY;
  struct text_buffer symbols = TEXT_BUFFER_EMPTY;
  for (size_t i = 0; i < count; ++i) {
    const struct missing *of = &missing[i];
    text_buffer_add(&list, "%s'%s' (%" PRIu32 " atom%s)", i == 0 ? "" : ", ", of->element.text, of->atoms,
                    of->atoms == 1 ? "" : "s");
    text_buffer_add(&options, "%s%s=R", i == 0 ? "" : ",", of->element.text);
    text_buffer_add(&symbols, "%s%s", i == 0 ? "" : ",", of->element.text);
  }
  if (list.out_of_memory || options.out_of_memory || symbols.out_of_memory) {
    failure_of_memory(failure);
  } else {
    failure_in_input(failure, missing[0].line,
                     "unknown element%s %s%s; give %s with --radius %s, or leave out such atoms with --hide element:%s",
                     count == 1 ? "" : "s", list.text, more ? " and more" : "", count == 1 ? "a radius" : "radii",
                     options.text, symbols.text);
  }
  text_buffer_free(&list);
  text_buffer_free(&options);
  text_buffer_free(&symbols);
  return false;
}

/* An atom without an element. */
static bool report_nameless(const struct molecule *molecule, uint32_t atom, struct failure *failure) {
  const struct atom_label *label = &molecule->label[atom];
  const uint64_t line = molecule->line[atom];
  char name[EXCERPT_BYTES], residue[EXCERPT_BYTES];
  excerpt(name, label->name, strlen(label->name));
  if (label->bead) {
    return failure_in_input(failure, line, "'%s' of %s is no element: looks coarse-grained; give radii by --radii FILE",
                            name, excerpt(residue, label->residue->name, strlen(label->residue->name)));
  }
  return failure_in_input(failure, line, "%s in the atom name '%s'", molecule->format->nameless, name);
}

/* All atoms were left out; `site` is the symbol of the virtual ones, if they have one. */
static bool report_nothing(const struct molecule *molecule, const char *site, struct failure *failure) {
  const uint64_t sites = molecule->left_out.virtual_sites, hydrogens = molecule->left_out.hydrogens_of_set;
  const bool dummies = strcmp(site, "Ep") != 0 && strcmp(site, "Lp") != 0 && site[0] != 'M' && site[0] != '\0';
  if (sites > 0 && hydrogens > 0) {
    return failure_in_input(failure, 0,
                            "no atoms are left: all are virtual sites, %" PRIu64 ", or hydrogens, %" PRIu64
                            ", which heavy atoms stand for",
                            sites, hydrogens);
  }
  char many[40] = "the only one is";
  const bool one = sites + hydrogens == 1;
  if (!one) snprintf(many, sizeof many, "all %" PRIu64 " are", sites + hydrogens);
  if (sites == 0) {
    return failure_in_input(
        failure, 0, "no atoms are left: %s %s", many,
        one ? "a hydrogen, which its heavy atom stands for" : "hydrogens, which heavy atoms stand for");
  }
  return failure_in_input(failure, 0, "no atoms are left: %s %s%s%s", many, site, site[0] == '\0' ? "" : ", ",
                          dummies ? (one ? "a dummy" : "dummies") : (one ? "a virtual site" : "virtual sites"));
}

void molecule_keep_atoms(struct molecule *molecule, const uint8_t *keep) {
  uint32_t kept = 0;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    if (!keep[i]) continue;
    molecule_move_atom(molecule, kept, i);
    if (molecule->coordinate != NULL) molecule->coordinate[kept] = kept;
    ++kept;
  }
  molecule->atoms = molecule->read = kept;
}

void molecule_move_atom(struct molecule *molecule, uint32_t to, uint32_t from) {
  if (to == from) return;
  memcpy(molecule->xyz + 3 * (size_t)to, molecule->xyz + 3 * (size_t)from, 3 * sizeof *molecule->xyz);
  molecule->radius[to] = molecule->radius[from];
  molecule->line[to] = molecule->line[from];
  molecule->label[to] = molecule->label[from];
  if (molecule->place != NULL) molecule->place[to] = molecule->place[from];
  if (molecule->coordinate != NULL) molecule->coordinate[to] = molecule->coordinate[from];
  if (molecule->extra != NULL) molecule->extra[to] = molecule->extra[from];
}

/* The radius of an atom; false if it has none. */
static bool find_radius(struct atom_label *label, const struct radii *radii, const struct radii_table *table,
                        double *radius) {
  if (table->count > 0 && !radii_is_given(radii, label->element)) {
    label->by_name = radii_table_find(table, label->residue->name, label->name, radius);
  }
  if (label->by_name) return true;
  return (!label->virtual_site || radii_is_given(radii, label->element)) && radii_find(radii, label->element, radius);
}

bool molecule_take_radii(struct molecule *molecule, const struct radii *radii, const struct radii_table *table,
                         struct failure *failure) {
  if (file_format_has(molecule->format, FILE_RADII)) return true;
  const struct element_symbol hydrogen = {"H"};
  const bool without_hydrogens = !table->hydrogens && !radii_is_given(radii, hydrogen);
  struct missing missing[MOST_MISSING];
  size_t count = 0;
  bool more = false;
  uint32_t taken = 0;
  struct element_symbol site = {""};
  bool one_symbol = true;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    struct atom_label *label = &molecule->label[i];
    const struct element_symbol element = label->element;
    if (without_hydrogens && atom_is_hydrogen(label) && radii_table_names(table, label->residue->name)) {
      ++molecule->left_out.hydrogens_of_set;
      continue;
    }
    if (find_radius(label, radii, table, &molecule->radius[i])) {
      molecule_move_atom(molecule, taken++, i);
      continue;
    }
    if (label->virtual_site) {
      if (molecule->left_out.virtual_sites++ == 0) site = element;
      one_symbol = one_symbol && strcmp(site.text, element.text) == 0;
      continue;
    }
    if (element.text[0] == '\0') return report_nameless(molecule, i, failure);
    size_t at = 0;
    while (at < count && strcmp(missing[at].element.text, element.text) != 0) ++at;
    if (at == MOST_MISSING) {
      more = true;
      continue;
    }
    if (at == count) missing[count++] = (struct missing){element, molecule->line[i], 0};
    ++missing[at].atoms;
  }
  if (count > 0) return report_missing(missing, count, more, failure);
  molecule->atoms = taken;
  return taken > 0 || report_nothing(molecule, one_symbol ? site.text : "", failure);
}

bool atom_is_water(const struct atom_label *label) {
  return residue_kind_of(label->residue->name) == RESIDUE_WATER;
}

bool atom_is_of_chain(const struct atom_label *label) {
  if (!label->hetatm) return true;
  const enum residue_kind kind = residue_kind_of(label->residue->name);
  return kind == RESIDUE_AMINO_ACID || kind == RESIDUE_NUCLEOTIDE;
}

bool atom_is_hydrogen(const struct atom_label *label) {
  return label->element.text[0] == 'H' && label->element.text[1] == '\0';
}

uint32_t molecule_points(const struct molecule *molecule) {
  uint32_t points = molecule->points;
  for (uint32_t i = 0; molecule->radius != NULL && i < molecule->atoms; ++i) {
    if (molecule->radius[i] == 0.0) ++points;
  }
  return points;
}

double molecule_mean_radius(const struct molecule *molecule) {
  double sum = 0.0;
  for (uint32_t atom = 0; atom < molecule->atoms; ++atom) sum += molecule->radius[atom];
  return molecule->atoms > 0 ? sum / molecule->atoms : 0.0;
}

void molecule_drop_balls(struct molecule *molecule) {
  molecule->points = molecule_points(molecule);
  free(molecule->xyz);
  free(molecule->radius);
  free(molecule->line);
  molecule->xyz = molecule->radius = NULL;
  molecule->line = NULL;
}

void molecule_free(struct molecule *molecule) {
  free(molecule->xyz);
  free(molecule->radius);
  free(molecule->line);
  free(molecule->label);
  free(molecule->place);
  free(molecule->coordinate);
  free(molecule->extra);
  for (struct residue_block *block = molecule->residues.first, *next; block != NULL; block = next) {
    next = block->next;
    free(block);
  }
  free(molecule->bond);
  symmetry_free(&molecule->symmetry);
  assemblies_free(&molecule->assemblies);
  name_table_free(&molecule->asyms);
  molecule_init(molecule, molecule->format, &molecule->choice, molecule->keeps);
}

void label_copy(char *out, size_t room, struct field text) {
  const size_t length = text.length < room ? text.length : whole_characters(text.text, room - 1);
  if (length > 0) memcpy(out, text.text, length); /* an empty field may have no text */
  out[length] = '\0';
}

bool molecule_is_flat(const struct molecule *molecule, uint32_t first) {
  for (uint32_t i = first; i < molecule->atoms; ++i) {
    if (molecule->xyz[3 * (size_t)i + 2] != 0.0) return false;
  }
  return true;
}
