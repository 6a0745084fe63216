#include "molecule_balls.hpp"

#include "lattice_lengths.hpp"

oracle::Balls read_molecule(const std::filesystem::path &file, support::Records records) {
  return oracle::on_lattice(with_radii(support::read_atoms(file, records), support::Radii::van_der_waals), 0,
                            static_cast<double>(steps_per_angstrom));
}
