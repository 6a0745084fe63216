// The chemistry of the stand-in: amino-acid residues as atoms, bonds and shapes.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "integer_geometry.hpp"

namespace stand_in {

enum class Element { carbon, nitrogen, oxygen, sulphur, copper, zinc };
constexpr size_t element_count = 6;

// How an atom's bonds stand: about 110.5 or 120 degrees to each other.
enum class Shape { tetrahedral, trigonal };

struct ResidueAtom {
  std::string_view name;  // PDB atom name without padding
  Element element;
  Shape shape;
  std::string_view parent;  // the earlier atom of the residue that it is bonded to; empty for the backbone N
};

// An amino-acid residue as it stands in a chain: no hydrogens, no terminal oxygen.
struct Residue {
  std::string_view name;                    // three-letter code
  std::span<const ResidueAtom> side_chain;  // atoms beyond N CA C O
  std::span<const std::string_view> ring;   // its ring of five or six atoms in order, or empty
  int per_mille;                            // how often it occurs
};

// The backbone N, CA, C, O that every residue begins with.
std::span<const ResidueAtom> backbone();

// Nineteen residues (tryptophan, the rarest, is left out) with the frequencies of vertebrate proteins:
// King and Jukes, Science 164 (1969) 788.
std::span<const Residue> residues();

// Ideal length of a bond by the elements and shapes of its ends, as in the textbooks, to about 0.02 Angstrom.
Length bond_length(Element a, Shape shape_a, Element b, Shape shape_b);

std::string_view symbol(Element element);

// The least distance between atoms that are not bonded; tuned, see ../README.md.
Length contact_distance(Element a, Element b);

// The ball's radius in the paper's Section 2, in milliangstrom; for copper and zinc, which the paper does not list,
// the 2.50 that its k = 1.95 asks for.
int64_t paper_radius_milliangstrom(Element element);

}  // namespace stand_in
