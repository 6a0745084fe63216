// The work of single_atoms.c by hardsphere.hpp: Monte Carlo of single atoms with an energy of areas and springs.
//   single_atoms MOLECULE.xyzr [MOVES]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <hardsphere.hpp>

#include "../read_balls.hpp"

namespace {

constexpr double probe = 1.4, tension = 0.0054;  // kcal/mol per angstrom^2, as is usual
constexpr double spring = 1.0;                   // kcal/mol per angstrom^2
constexpr double temperature = 0.6;              // R T in kcal/mol at 300 K
constexpr double largest_shift = 0.3;

// In [0, 1): Vigna's xorshift64*.
double random_number() {
  static uint64_t x = 1994;
  x ^= x >> 12;
  x ^= x << 25;
  x ^= x >> 27;
  return static_cast<double>((x * UINT64_C(2685821657736338717)) >> 11) / 9007199254740992.0;
}

double spring_energy(const double *at, const double *place) {
  double squared = 0;
  for (int k = 0; k < 3; ++k) squared += (at[k] - place[k]) * (at[k] - place[k]);
  return 0.5 * spring * squared;
}

}  // namespace

int main(int count, char **arguments) try {
  if (count < 2 || count > 3) {
    std::fprintf(stderr, "usage: single_atoms MOLECULE.xyzr [MOVES]\n");
    return 2;
  }
  const unsigned long moves = count == 3 ? std::strtoul(arguments[2], nullptr, 10) : 100000;
  Balls balls;
  add_balls(balls, arguments[1]);
  if (balls.radius.empty()) throw std::runtime_error("there are no atoms");
  hardsphere::moving walk(balls.xyz, balls.radius, {.tension = tension}, {.probe = probe});
  std::vector<double> xyz = balls.xyz;
  const double first = walk.energy().value;
  double surface = first;
  unsigned long accepted = 0;
  const auto start = std::chrono::steady_clock::now();
  for (unsigned long move = 0; move < moves; ++move) {
    const auto atom = static_cast<uint32_t>(random_number() * walk.size());
    double *at = &xyz[3 * size_t{atom}], to[3];
    const double *place = &balls.xyz[3 * size_t{atom}];
    for (int k = 0; k < 3; ++k) to[k] = at[k] + largest_shift * (2 * random_number() - 1);
    const double found = walk.move({&atom, 1}, to).energy().value;
    const double rise = found - surface + spring_energy(to, place) - spring_energy(at, place);
    if (rise > 0 && random_number() >= std::exp(-rise / temperature)) {
      walk.undo();
      continue;
    }
    std::copy(to, to + 3, at);
    surface = found;
    ++accepted;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%u atoms, %lu moves, %lu accepted: %.6f kcal/mol, before %.6f\n", walk.size(), moves, accepted, surface,
              first);
  if (seconds.count() > 0) std::printf("%.0f moves a second\n", static_cast<double>(moves) / seconds.count());

  // A model of the atoms as they are, computed once for all, by the same lattice and largest radius.
  hardsphere::workspace anew(xyz, balls.radius, {.probe = probe});
  hardsphere::check(hsp_moving_get_model(walk.handle(), anew->model));
  const double value = anew.gradient({.tension = tension}).energy.value;
  hsp_boundary_counts counts{};
  hardsphere::check(hsp_boundary_get_counts(anew.boundary(), &counts));
  std::printf("a new model has %s: %.17g kcal/mol, %u vertices, %u voids\n",
              value == surface ? "the same bits" : "OTHER BITS", value, static_cast<unsigned>(counts.vertices),
              static_cast<unsigned>(counts.voids));
  return value == surface ? 0 : 1;
} catch (const std::exception &failure) {
  std::fprintf(stderr, "single_atoms: %s\n", failure.what());
  return 1;
}
