// Chains of residues laid down as strands inside a sphere: where the atoms of the stand-in begin.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "integer_geometry.hpp"
#include "random_numbers.hpp"
#include "residues.hpp"

namespace stand_in {

struct Atom {
  std::string_view name;
  std::string_view residue;
  Element element = Element::carbon;
  Shape shape = Shape::tetrahedral;
  char chain = 'A';
  uint8_t lobe = 0;     // the sphere that it is kept in
  Length out = 0;       // how far beyond that sphere it may go; negative: how far inside it has to stay
  bool hetero = false;  // a HETATM of the PDB format: metals and waters
  int residue_number = 0;
  Point at;
};

// Two atoms that are to stand a given length apart.
struct Link {
  uint32_t a = 0;
  uint32_t b = 0;
  Length length = 0;
};

struct Lobe {
  Point centre;
  Length radius = 0;
};

struct Assembly {
  std::vector<Atom> atoms;
  std::vector<Link> bonds;      // covalent bonds: angles follow from them
  std::vector<Link> distances;  // further distances: flat peptides and rings, metals and their ligands
  std::vector<std::vector<uint32_t>> five_rings;
  std::vector<Lobe> lobes;
};

// Append a chain of exactly `atoms` atoms in a new lobe: residues drawn at random, one copper and one zinc with four
// histidines each, and waters for what is left over. The strands run along x, y or z by `axis` 0, 1 or 2.
void append_chain(Assembly &assembly, char chain, const Lobe &lobe, int axis, size_t atoms, support::Random &random);

}  // namespace stand_in
