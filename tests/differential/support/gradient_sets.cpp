#include "gradient_sets.hpp"

#include <algorithm>

#include "lattice_lengths.hpp"
#include "molecule_file.hpp"
#include "named_balls.hpp"
#include "sweep_length.hpp"

using oracle::Balls;
using oracle::LatticeBall;

Balls in_general_position(const Balls &balls, oracle::RandomSource &random) {
  constexpr int64_t factor = int64_t{1} << 22;
  Balls result;
  for (const LatticeBall &ball : balls) {
    const auto fine = [&](int64_t value) { return value * factor + random.in(-factor / 2, factor / 2); };
    const int64_t x = fine(ball.x);
    const int64_t y = fine(ball.y);
    const int64_t z = fine(ball.z);
    result.push_back({x, y, z, fine(ball.radius)});
  }
  return result;
}

namespace {

// A large ball with bumps apart from each other: one face with many loops, bounded by whole circles.
Balls bumpy_ball() {
  Balls balls = {{0, 0, 0, 100}};
  for (const LatticeBall &direction : Balls{{0, 0, 1, 0},
                                            {0, 0, -1, 0},
                                            {0, 1, 0, 0},
                                            {0, -1, 0, 0},
                                            {1, 0, 0, 0},
                                            {-1, 0, 0, 0},
                                            {1, 1, 1, 0},
                                            {1, 1, -1, 0},
                                            {1, -1, 1, 0},
                                            {-1, 1, 1, 0},
                                            {-1, -1, 1, 0},
                                            {-1, 1, -1, 0},
                                            {1, -1, -1, 0}}) {
    const int64_t axes = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
    const int64_t length = axes == 1 ? 100 : 58;
    balls.push_back({length * direction.x, length * direction.y, length * direction.z, 20 + 2 * axes});
  }
  return balls;
}

// Free balls, free pairs, a ball inside another.
Balls scattered_balls() {
  return {{0, 0, 0, 70}, {400, 10, -30, 50}, {0, 300, 0, 80}, {70, 350, 40, 60}, {-300, 0, 20, 90}, {-310, 20, 30, 30}};
}

}  // namespace

std::vector<oracle::NamedBalls> sets_of_every_kind(uint64_t seed) {
  oracle::RandomSource random(seed);
  std::vector<oracle::NamedBalls> sets;
  const auto add = [&](const std::string &name, const Balls &balls) {
    sets.push_back({name, in_general_position(balls, random)});
  };
  add("scattered", scattered_balls());
  add("loose", oracle::loose_balls(random, 14));
  add("loose, larger", oracle::loose_balls(random, 40));
  add("dense", oracle::dense_balls(random, 9));
  add("clustered", oracle::clustered_balls(random, 16));
  add("belted", oracle::belted_balls(random, 25));
  add("bumpy", bumpy_ball());
  for (const oracle::KnownBalls &set : oracle::known_balls())
    for (const char *name : {"belt with many bumps", "two belts with bumps", "hollow shell",
                             "hollow shell with balls inside and outside", "fullerene"})
      if (set.name == name) add(name, set.balls);
  return oracle::some_of(sets);
}

std::vector<oracle::NamedBalls> molecules_of_gradient_tests() {
  constexpr double units = 268435456;  // 2^28: crambin's largest radius with probe, 3.2, stays below 2^30
  std::vector<oracle::NamedBalls> sets;
  for (const std::string name : {"caffeine", "crambin"}) {
    const support::BallList balls =
        with_radii(support::read_atoms(support::own_molecule(name + ".pdb")), support::Radii::van_der_waals);
    for (const double probe : {0.0, 1.4})
      sets.push_back({name + (probe > 0 ? ", accessible" : ""), oracle::on_lattice(balls, probe, units)});
  }
  if (oracle::emulated) sets.erase(sets.begin() + 1, sets.end());
  return sets;
}

Balls nearest_to_first(const Balls &balls, size_t n) {
  Balls sorted = balls;
  const auto distance = [&](const LatticeBall &ball) {
    const oracle::Vector v = oracle::centre_difference(balls.front(), ball);
    return oracle::dot(v, v);
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const LatticeBall &a, const LatticeBall &b) { return distance(a) < distance(b); });
  sorted.resize(std::min(n, sorted.size()));
  return sorted;
}
