// gemmi_read FILE: reads a molecule by gemmi, and prints how many atoms it has.
#include <cstddef>
#include <cstdio>
#include <exception>
#include <gemmi/cif.hpp>
#include <gemmi/mmcif.hpp>
#include <gemmi/pdb.hpp>
#include <string>

int main(int argc, char **argv) {
  if (argc != 2) return 2;
  try {
    const std::string path = argv[1];
    const bool is_cif = path.size() >= 4 && path.compare(path.size() - 4, 4, ".cif") == 0;
    const gemmi::Structure all =
        is_cif ? gemmi::make_structure(gemmi::cif::read_file(path)) : gemmi::read_pdb_file(path);
    size_t atoms = 0;
    for (const gemmi::Chain &chain : all.models.at(0).chains) {
      for (const gemmi::Residue &residue : chain.residues) atoms += residue.atoms.size();
    }
    std::printf("%zu\n", atoms);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "gemmi_read: %s\n", error.what());
    return 1;
  }
  return 0;
}
