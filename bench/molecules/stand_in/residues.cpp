#include "residues.hpp"

#include <array>
#include <utility>

namespace stand_in {
namespace {

constexpr auto C = Element::carbon;
constexpr auto N = Element::nitrogen;
constexpr auto O = Element::oxygen;
constexpr auto S = Element::sulphur;
constexpr auto sp3 = Shape::tetrahedral;
constexpr auto sp2 = Shape::trigonal;

constexpr std::array<ResidueAtom, 4> backbone_atoms{
    {{"N", N, sp2, ""}, {"CA", C, sp3, "N"}, {"C", C, sp2, "CA"}, {"O", O, sp2, "C"}}};

constexpr ResidueAtom alanine[] = {{"CB", C, sp3, "CA"}};
constexpr ResidueAtom serine[] = {{"CB", C, sp3, "CA"}, {"OG", O, sp3, "CB"}};
constexpr ResidueAtom cysteine[] = {{"CB", C, sp3, "CA"}, {"SG", S, sp3, "CB"}};
constexpr ResidueAtom valine[] = {{"CB", C, sp3, "CA"}, {"CG1", C, sp3, "CB"}, {"CG2", C, sp3, "CB"}};
constexpr ResidueAtom threonine[] = {{"CB", C, sp3, "CA"}, {"OG1", O, sp3, "CB"}, {"CG2", C, sp3, "CB"}};
constexpr ResidueAtom isoleucine[] = {
    {"CB", C, sp3, "CA"}, {"CG1", C, sp3, "CB"}, {"CG2", C, sp3, "CB"}, {"CD1", C, sp3, "CG1"}};
constexpr ResidueAtom leucine[] = {
    {"CB", C, sp3, "CA"}, {"CG", C, sp3, "CB"}, {"CD1", C, sp3, "CG"}, {"CD2", C, sp3, "CG"}};
constexpr ResidueAtom aspartate[] = {
    {"CB", C, sp3, "CA"}, {"CG", C, sp2, "CB"}, {"OD1", O, sp2, "CG"}, {"OD2", O, sp2, "CG"}};
constexpr ResidueAtom asparagine[] = {
    {"CB", C, sp3, "CA"}, {"CG", C, sp2, "CB"}, {"OD1", O, sp2, "CG"}, {"ND2", N, sp2, "CG"}};
constexpr ResidueAtom glutamate[] = {
    {"CB", C, sp3, "CA"}, {"CG", C, sp3, "CB"}, {"CD", C, sp2, "CG"}, {"OE1", O, sp2, "CD"}, {"OE2", O, sp2, "CD"}};
constexpr ResidueAtom glutamine[] = {
    {"CB", C, sp3, "CA"}, {"CG", C, sp3, "CB"}, {"CD", C, sp2, "CG"}, {"OE1", O, sp2, "CD"}, {"NE2", N, sp2, "CD"}};
constexpr ResidueAtom methionine[] = {
    {"CB", C, sp3, "CA"}, {"CG", C, sp3, "CB"}, {"SD", S, sp3, "CG"}, {"CE", C, sp3, "SD"}};
constexpr ResidueAtom lysine[] = {
    {"CB", C, sp3, "CA"}, {"CG", C, sp3, "CB"}, {"CD", C, sp3, "CG"}, {"CE", C, sp3, "CD"}, {"NZ", N, sp3, "CE"}};
constexpr ResidueAtom arginine[] = {{"CB", C, sp3, "CA"}, {"CG", C, sp3, "CB"}, {"CD", C, sp3, "CG"},
                                    {"NE", N, sp2, "CD"}, {"CZ", C, sp2, "NE"}, {"NH1", N, sp2, "CZ"},
                                    {"NH2", N, sp2, "CZ"}};
constexpr ResidueAtom proline[] = {{"CB", C, sp3, "CA"}, {"CG", C, sp3, "CB"}, {"CD", C, sp3, "CG"}};
constexpr ResidueAtom histidine[] = {{"CB", C, sp3, "CA"},  {"CG", C, sp2, "CB"},   {"ND1", N, sp2, "CG"},
                                     {"CD2", C, sp2, "CG"}, {"CE1", C, sp2, "ND1"}, {"NE2", N, sp2, "CD2"}};
constexpr ResidueAtom phenylalanine[] = {{"CB", C, sp3, "CA"},  {"CG", C, sp2, "CB"},   {"CD1", C, sp2, "CG"},
                                         {"CD2", C, sp2, "CG"}, {"CE1", C, sp2, "CD1"}, {"CE2", C, sp2, "CD2"},
                                         {"CZ", C, sp2, "CE1"}};
constexpr ResidueAtom tyrosine[] = {{"CB", C, sp3, "CA"},  {"CG", C, sp2, "CB"},   {"CD1", C, sp2, "CG"},
                                    {"CD2", C, sp2, "CG"}, {"CE1", C, sp2, "CD1"}, {"CE2", C, sp2, "CD2"},
                                    {"CZ", C, sp2, "CE1"}, {"OH", O, sp3, "CZ"}};

constexpr std::string_view proline_ring[] = {"N", "CA", "CB", "CG", "CD"};
constexpr std::string_view histidine_ring[] = {"CG", "ND1", "CE1", "NE2", "CD2"};
constexpr std::string_view benzene_ring[] = {"CG", "CD1", "CE1", "CZ", "CE2", "CD2"};

constexpr Residue residue_table[] = {
    {"GLY", {}, {}, 74},
    {"ALA", alanine, {}, 74},
    {"SER", serine, {}, 81},
    {"CYS", cysteine, {}, 33},
    {"VAL", valine, {}, 68},
    {"THR", threonine, {}, 62},
    {"ILE", isoleucine, {}, 38},
    {"LEU", leucine, {}, 76},
    {"ASP", aspartate, {}, 59},
    {"ASN", asparagine, {}, 44},
    {"GLU", glutamate, {}, 58},
    {"GLN", glutamine, {}, 37},
    {"MET", methionine, {}, 18},
    {"LYS", lysine, {}, 72},
    {"ARG", arginine, {}, 42},
    {"PRO", proline, proline_ring, 50},
    {"HIS", histidine, histidine_ring, 29},
    {"PHE", phenylalanine, benzene_ring, 40},
    {"TYR", tyrosine, benzene_ring, 33},
};

constexpr size_t index_of(Element element) {
  return static_cast<size_t>(element);
}

}  // namespace

std::span<const ResidueAtom> backbone() {
  return backbone_atoms;
}

std::span<const Residue> residues() {
  return residue_table;
}

Length bond_length(Element a, Shape shape_a, Element b, Shape shape_b) {
  // After this the heavier element, or the trigonal one of two equal elements, is b.
  if (index_of(a) > index_of(b) || (a == b && shape_a == sp2)) {
    std::swap(a, b);
    std::swap(shape_a, shape_b);
  }
  const bool both_trigonal = shape_a == sp2 && shape_b == sp2;
  switch (b) {
    case C:
      return milliangstrom(both_trigonal ? 1390 : shape_b == sp2 ? 1515 : 1530);
    case N:
      return milliangstrom(both_trigonal ? 1335 : 1465);
    case O:
      return milliangstrom(both_trigonal ? 1240 : 1425);
    case S:
      return milliangstrom(a == S ? 2040 : 1810);
    case Element::copper:
    case Element::zinc:
      return milliangstrom(2080);
  }
  return 0;
}

std::string_view symbol(Element element) {
  constexpr std::array<std::string_view, element_count> symbols{"C", "N", "O", "S", "CU", "ZN"};
  return symbols[index_of(element)];
}

Length contact_distance(Element a, Element b) {
  // Near the sums of van der Waals radii: carbon with its hydrogens, nitrogen and oxygen with theirs between them, and
  // metals whose ligands keep others off.
  constexpr std::array<std::array<int, element_count>, element_count> table{{{3620, 3380, 3250, 3600, 4100, 4100},
                                                                             {3380, 2950, 2850, 3400, 3600, 3600},
                                                                             {3250, 2850, 2900, 3350, 3600, 3600},
                                                                             {3600, 3400, 3350, 3700, 3900, 3900},
                                                                             {4100, 3600, 3600, 3900, 6000, 6000},
                                                                             {4100, 3600, 3600, 3900, 6000, 6000}}};
  return milliangstrom(table[index_of(a)][index_of(b)]);
}

int64_t paper_radius_milliangstrom(Element element) {
  constexpr std::array<int64_t, element_count> radii{1520, 1360, 1280, 2100, 2500, 2500};
  return radii[index_of(element)];
}

}  // namespace stand_in
