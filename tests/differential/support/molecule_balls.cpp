#include "molecule_balls.hpp"

#include <cmath>

oracle::Balls on_lattice(const support::BallList &balls, double probe, double steps_per_unit) {
  const auto steps = [&](double length) { return static_cast<int64_t>(std::llround(length * steps_per_unit)); };
  oracle::Balls result;
  for (size_t i = 0; i < balls.size(); ++i)
    result.push_back({steps(balls.xyz[3 * i]), steps(balls.xyz[3 * i + 1]), steps(balls.xyz[3 * i + 2]),
                      steps(balls.radius[i] + probe)});
  return result;
}

oracle::Balls read_molecule(const std::filesystem::path &file, support::Records records) {
  return on_lattice(with_radii(support::read_atoms(file, records), support::Radii::van_der_waals), 0,
                    static_cast<double>(steps_per_angstrom));
}
