/* Element symbols and the radii that stand for them. Lengths are in angstrom. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A symbol as chemists write it, "H" or "Ca", NUL-terminated. */
struct element_symbol {
  char text[3];
};

/* Make a symbol of one or two letters in any case; deuterium and tritium, D and T, become H. False if the text is no
 * such thing. Whether an element has that symbol is another question. */
bool element_symbol_parse(const char *text, size_t length, struct element_symbol *symbol);

/* The atomic number of the element with that symbol; 0 if there is none. */
uint32_t element_atomic_number(struct element_symbol symbol);

/* The symbol of an atomic number; false if no element has it. */
bool element_symbol_of_number(uint64_t number, struct element_symbol *symbol);

/* Whether the periodic table has the symbol. */
bool element_symbol_exists(struct element_symbol symbol);

/* X, which files of the PDB have for an atom that is there while nobody knows its element. It has no atomic number. */
extern const struct element_symbol element_unknown;
bool element_is_unknown(struct element_symbol symbol);

/* The radius of every symbol of one or two letters: negative where there is none. */
struct radii {
  double of[27 * 27];
  bool substitute[27 * 27]; /* the set has none for this element */
  bool given[27 * 27];      /* by radii_put */
};

/* The sets that can be asked for by name. */
struct radii_set;

extern const struct radii_set radii_bondi;

/* The set of that name, or NULL. */
const struct radii_set *radii_set_find(const char *name);

/* All sets, from 0 on; NULL beyond the last. */
const struct radii_set *radii_set_at(size_t i);

/* The radii by residue and atom that the set has before those by element, HSP_RADII_*; HSP_NONE if it has none. */
uint32_t radii_set_residues(const struct radii_set *set);

const char *radii_set_name(const struct radii_set *set);

/* Where a set was published, in a few words. */
const char *radii_set_source(const struct radii_set *set);

/* Begin with a set's radii by element, which for sets by residue and atom are those of bondi, and with a substitute for
 * unknown atoms; radii_put then adds or replaces single radii. */
void radii_take_set(struct radii *radii, const struct radii_set *set);
void radii_put(struct radii *radii, struct element_symbol symbol, double radius);

/* False: the symbol has no radius. */
bool radii_find(const struct radii *radii, struct element_symbol symbol, double *radius);

/* Whether the radius is none of the set, but a substitute for one: that of bondi, or 2 where this has none either. */
bool radii_is_substitute(const struct radii *radii, struct element_symbol symbol);

/* Whether radii_put has set the radius. */
bool radii_is_given(const struct radii *radii, struct element_symbol symbol);
