/* hardsphere/element.h: elements by symbol, and their radii.
 *
 * Guide: tutorial.md.
 *
 * Stable: from version 1.0 on this stays as it is, and is only added to.
 *
 * Cost: O(1); hsp_element_number: the length of the text. */
#ifndef HARDSPHERE_ELEMENT_H
#define HARDSPHERE_ELEMENT_H

#include "export.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Van der Waals radii of A. Bondi, J. Phys. Chem. 68 (1964) 441, completed for the main group by M. Mantina et al.,
 *  J. Phys. Chem. A 113 (2009) 5806, Table 12, with hydrogen 1.10 after R. S. Rowland and R. Taylor, J. Phys. Chem. 100
 *  (1996) 7384. Published: all s- and p-block elements of the periods 1 to 6, Fr, Ra, Ni, Cu, Zn, Pd, Ag, Cd, Au, Hg
 *  and U. */
#define HSP_RADII_BONDI UINT32_C(0)

/** The radii of the paper, Section 2, which are those of Chem3D Plus. Published: H, C, N, O, P, S and Ca. */
#define HSP_RADII_CHEM3D UINT32_C(1)

/** The radii of the universal force field, A. K. Rappe et al., J. Am. Chem. Soc. 114 (1992) 10024, Table 1: sigma / 2,
 *  with sigma = x_I / 2^(1/6) rounded to 0.001 angstrom, as programs for porous crystals have it: C 1.7155, O 1.559.
 *  Two equal atoms have energy 0 at the distance sigma, and the least energy at the distance x_I. Published: the
 *  elements up to lawrencium, 103. */
#define HSP_RADII_UFF UINT32_C(4)

/** The source of the set has no radius for this element: the radius is a substitute. */
#define HSP_RADIUS_FALLBACK UINT32_C(1)

/** The radius of an element in one of the sets above, HSP_RADII_*: *radius in angstrom, *flags = HSP_RADIUS_* or 0;
 *  flags may be NULL. Atomic numbers are 1 (hydrogen) to 118 (oganesson); deuterium is hydrogen.
 *  Where the source of the set has no radius, *radius is that of HSP_RADII_BONDI, and 2.00 where Bondi's set has none
 *  either, always with HSP_RADIUS_FALLBACK, so that a caller can refuse the element or choose a radius.
 *  On failure nothing is written.
 *  @retval HSP_E_ARGUMENT  radius is NULL; another set, those of residue.h included
 *  @retval HSP_E_ID        no element has this number */
HSP_API int32_t HSP_CALL hsp_element_radius(uint32_t set, uint32_t atomic_number, double *radius, uint32_t *flags);

/** The atomic number of an element by its symbol, a NUL-terminated text: one or two letters in upper or lower case,
 *  with blanks before and behind where a file has them. "Fe", "FE", " fe" and "fe " are iron, 26, "CA" is calcium, and
 *  "D" is hydrogen. An atom's name is no symbol: an alpha carbon's name is "CA", too. On failure nothing is written.
 *  @retval HSP_E_ARGUMENT  symbol or atomic_number is NULL
 *  @retval HSP_E_ID        no element has this symbol */
HSP_API int32_t HSP_CALL hsp_element_number(const char *symbol, uint32_t *atomic_number);

/** The symbol of an element as chemists write it, "H" or "Ca": a constant text of the library's, never NULL; "" for
 *  numbers that no element has.
 *  - Property 1: hsp_element_number finds the number again. */
HSP_API const char *HSP_CALL hsp_element_symbol(uint32_t atomic_number);

#ifdef __cplusplus
}
#endif

#endif
