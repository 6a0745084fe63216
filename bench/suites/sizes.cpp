#include "sizes.hpp"

#include "tiling.hpp"

namespace bench {

std::vector<Size> molecule_sizes() {
  std::vector<Size> sizes;
  for (const Molecule &molecule : paper_molecules()) {
    sizes.push_back({molecule.name, [molecule] { return with_radii(molecule, Radii::van_der_waals); }});
  }
  return sizes;
}

std::vector<Size> all_sizes() {
  std::vector<Size> sizes = molecule_sizes();
  const Size largest = sizes.back();
  for (const int copies : {2, 3, 6}) {
    sizes.push_back({largest.name + "_x" + std::to_string(copies * copies * copies),
                     [largest, copies] { return tiled(largest.balls(), copies); }});
  }
  return sizes;
}

}  // namespace bench
