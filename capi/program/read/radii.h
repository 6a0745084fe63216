/* Element symbols and their radii. Lengths are in angstrom. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A symbol as chemists write it, "H" or "Ca", NUL-terminated. */
struct element_symbol {
  char text[3];
};

/* Make a symbol of one or two letters in any case; deuterium and tritium, D and T, become H. False: the text is not one
 * or two letters. True says not yet that an element has that symbol. */
bool element_symbol_parse(const char *text, size_t length, struct element_symbol *symbol);

/* The atomic number of the element with that symbol; 0 if there is none. */
uint32_t element_atomic_number(struct element_symbol symbol);

/* The symbol of an atomic number; false if no element has it. */
bool element_symbol_of_number(uint64_t number, struct element_symbol *symbol);

/* Whether the periodic table has the symbol. */
bool element_symbol_exists(struct element_symbol symbol);

/* X: in files of the PDB an atom of unknown element. It has no atomic number. */
extern const struct element_symbol element_unknown;
bool element_is_unknown(struct element_symbol symbol);

/* The radius of every symbol of one or two letters; negative: none. */
struct radii {
  double of[27 * 27];
  bool substitute[27 * 27]; /* the set has no radius for this element: another is used */
  bool given[27 * 27];      /* the radius was set by radii_put */
};

/* A set of radii with a name. */
struct radii_set;

extern const struct radii_set radii_bondi;

/* The set of that name, or NULL. */
const struct radii_set *radii_set_find(const char *name);

/* All sets, from 0 on; NULL beyond the last. */
const struct radii_set *radii_set_at(size_t i);

/* The set's radii by residue and atom, HSP_RADII_*, which come before those by element; HSP_NONE if it has none. */
uint32_t radii_set_residues(const struct radii_set *set);

const char *radii_set_name(const struct radii_set *set);

/* The publication of a set, in a few words. */
const char *radii_set_source(const struct radii_set *set);

/* Begin with a set's radii by element, which for sets by residue and atom are those of bondi, and with a substitute for
 * unknown atoms; radii_put then adds or replaces single radii. */
void radii_take_set(struct radii *radii, const struct radii_set *set);
void radii_put(struct radii *radii, struct element_symbol symbol, double radius);

/* Find the radius of a symbol. False: it has none. */
bool radii_find(const struct radii *radii, struct element_symbol symbol, double *radius);

/* Whether the radius is not from the set, but a substitute: that of bondi, or 2 if bondi has none either. */
bool radii_is_substitute(const struct radii *radii, struct element_symbol symbol);

/* Whether radii_put has set the radius. */
bool radii_is_given(const struct radii *radii, struct element_symbol symbol);
