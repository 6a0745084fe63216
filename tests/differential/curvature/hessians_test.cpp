// Second derivatives against those of another derivation in 113 bits: random sets, and sets a little off every event at
// which derivatives of some order jump.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "gradient_sets.hpp"
#include "hessian_in_113_bits.hpp"
#include "lattice_lengths.hpp"
#include "molecule_file.hpp"
#include "random_balls.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;
using oracle::LatticeBall;
using oracle::RandomSource;

constexpr double unit = 0x1p24;  // steps of a length of 1

double real(RandomSource &random, double least, double most) {
  return least + (most - least) * random.fraction();
}

LatticeBall ball_of(double x, double y, double z, double radius) {
  return {std::llround(unit * x), std::llround(unit * y), std::llround(unit * z), std::llround(unit * radius)};
}

struct Direction {
  double x, y, z;
};
Direction unit_vector(RandomSource &random) {
  for (;;) {
    const Direction v{real(random, -1, 1), real(random, -1, 1), real(random, -1, 1)};
    const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    if (length > 0.1 && length <= 1) return {v.x / length, v.y / length, v.z / length};
  }
}

// 0.1 to 1e-6, of either sign.
double little(RandomSource &random) {
  return std::pow(10.0, -static_cast<double>(random.in(1, 6))) * (random.one_in(2) ? 1 : -1);
}

Balls atoms(RandomSource &random) {
  Balls balls;
  const auto n = static_cast<size_t>(random.in(2, 40));
  const double side = 1.1 * std::cbrt(static_cast<double>(n)) + 1;
  while (balls.size() < n)
    balls.push_back(ball_of(real(random, 0, side), real(random, 0, side), real(random, 0, side), real(random, 0.8, 2)));
  return balls;
}

Balls uneven(RandomSource &random) {
  Balls balls;
  const auto n = static_cast<size_t>(random.in(4, 40));
  while (balls.size() < n) {
    const double radius = balls.size() % 7 == 0 ? real(random, 1, 3) : real(random, 0.1, 0.6);
    balls.push_back(ball_of(real(random, 0, 5), real(random, 0, 5), real(random, 0, 5), radius));
  }
  return balls;
}

// Neighbours miss each other, overlap, or lie inside one another by a little.
Balls nearly_touching_chain(RandomSource &random) {
  Balls balls;
  const double off = little(random);
  Direction at{0, 0, 0};
  double radius = real(random, 0.8, 2);
  for (int64_t left = random.in(2, 14); left > 0; --left) {
    balls.push_back(ball_of(at.x, at.y, at.z, radius));
    const double next = real(random, 0.8, 2);
    const double distance = (random.one_in(4) ? std::fabs(radius - next) : radius + next) + off;
    const Direction u = unit_vector(random);
    at = {at.x + distance * u.x, at.y + distance * u.y, at.z + distance * u.z};
    radius = next;
  }
  return balls;
}

// Triples whose vertex lies a little above the plane of the centres.
Balls nearly_flat_triples(RandomSource &random) {
  Balls balls;
  const double above = std::fabs(little(random));
  for (int64_t left = random.in(1, 5); left > 0; --left) {
    const Direction o{real(random, 0, 9), real(random, 0, 9), real(random, 0, 9)}, u = unit_vector(random);
    const Direction other = unit_vector(random);
    const double along = u.x * other.x + u.y * other.y + u.z * other.z;
    const Direction v{other.x - along * u.x, other.y - along * u.y, other.z - along * u.z};
    for (int k = 0; k < 3; ++k) {
      const double distance = real(random, 0.8, 1.5), angle = 2.1 * k + real(random, 0, 1);
      const double c = distance * std::cos(angle), s = distance * std::sin(angle);
      const Direction to{c * u.x + s * v.x, c * u.y + s * v.y, c * u.z + s * v.z};
      const double radius = std::sqrt(to.x * to.x + to.y * to.y + to.z * to.z) + above;
      balls.push_back(ball_of(o.x + to.x, o.y + to.y, o.z + to.z, radius));
    }
  }
  return balls;
}

Balls nearly_through_points(RandomSource &random) {
  Balls balls;
  const double off = little(random);
  for (int64_t groups = random.in(1, 4); groups > 0; --groups) {
    const Direction o{real(random, 0, 9), real(random, 0, 9), real(random, 0, 9)};
    for (int64_t left = random.in(4, 6); left > 0; --left) {
      const Direction u = unit_vector(random);
      const double radius = real(random, 0.8, 2);
      balls.push_back(
          ball_of(o.x + radius * u.x, o.y + radius * u.y, o.z + radius * u.z, radius + off * real(random, -1, 1)));
    }
  }
  return balls;
}

Balls noisy_crate(RandomSource &random) {
  Balls balls;
  const double off = little(random), radius = 1 + 0.15 * static_cast<double>(random.in(0, 5));
  const int64_t side = random.in(2, 3);
  for (int64_t k = 0; k < side * side * side; ++k) {
    const auto coordinate = [&](int64_t cell) { return 2.0 * static_cast<double>(cell) + off * real(random, -1, 1); };
    balls.push_back(ball_of(coordinate(k % side), coordinate(k / side % side), coordinate(k / side / side), radius));
  }
  return balls;
}

// Small integers: most touch, tie or lie in one another, and are passed over.
Balls small_integers(RandomSource &random) {
  Balls balls;
  for (int64_t left = random.in(2, 8); left > 0; --left) {
    const auto whole = [&] { return static_cast<double>(random.in(0, 6)); };
    balls.push_back(ball_of(whole(), whole(), whole(), static_cast<double>(random.in(1, 3))));
  }
  return balls;
}

// A cluster on a ball of ten thousands of times their radius.
Balls on_a_large_ball(RandomSource &random) {
  const double radius = real(random, 5, 30);
  Balls balls = {ball_of(0, 0, -radius, radius)};
  for (int64_t left = random.in(3, 9); left > 0; --left)
    balls.push_back(
        ball_of(real(random, 0, 1e-3), real(random, 0, 1e-3), real(random, -1e-4, 1e-4), real(random, 2e-4, 5e-4)));
  return balls;
}

// Some of the balls are there twice; where they have a face they are passed over.
Balls with_equal_balls(RandomSource &random) {
  Balls balls = atoms(random);
  for (int64_t left = random.in(1, 3); left > 0; --left)
    balls.push_back(balls[static_cast<size_t>(random.in(0, static_cast<int64_t>(balls.size()) - 1))]);
  return balls;
}

struct Rows {
  std::vector<uint32_t> first, ball, flags;
  std::vector<double> block;
};

Rows rows_of(const LibraryBoundary &boundary, const hsp_gradient_request &request, size_t n) {
  Rows rows;
  rows.first.resize(n + 1);
  rows.flags.resize(n + 1);
  uint32_t entries = 0;
  hsp_boundary_get_hessian_rows(boundary.handle(), &request, rows.first.data(), nullptr, nullptr, nullptr, 0, &entries);
  rows.ball.resize(entries);
  rows.block.resize(9 * size_t{entries});
  expect_ok(hsp_boundary_get_hessian_rows(boundary.handle(), &request, rows.first.data(), rows.ball.data(),
                                          rows.block.data(), rows.flags.data(), entries, nullptr),
            "hsp_boundary_get_hessian_rows");
  return rows;
}

struct Tally {
  size_t sets = 0, tied = 0;
  double worst = 0;
};

// The largest difference over the magnitudes of the terms of its row.
void compare(const Balls &balls, RandomSource &random, Tally &tally) {
  const LibraryBoundary boundary(balls);
  const size_t n = balls.size();
  std::vector<double> sigma(n), direction(3 * n);
  for (double &weight : sigma) weight = real(random, -1, 2);
  for (double &component : direction) component = real(random, -1, 1);
  for (const hsp_vertex &vertex : boundary.vertices()) {
    if ((vertex.flags & HSP_VERTEX_TIED) == 0) continue;
    ++tally.tied;
    return;
  }
  for (const bool of_volume : {false, true}) {
    hsp_gradient_request request{};
    request.struct_size = sizeof request;
    request.sigma = sigma.data();
    request.tension = of_volume ? 0 : 1;
    request.pressure = of_volume ? 1 : 0;
    const Rows rows = rows_of(boundary, request, n);
    if (rows.flags.back() != 0) {
      ++tally.tied;
      return;
    }
    const std::vector<double> expected = hessian_in_113_bits(balls, boundary, sigma, of_volume, direction);
    const double scale =
        rows.block.empty() ? 0
                           : std::fabs(*std::max_element(rows.block.begin(), rows.block.end(), [](double a, double b) {
                               return std::fabs(a) < std::fabs(b);
                             }));
    for (size_t i = 0; i < n; ++i) {
      for (size_t p = 0; p < 3; ++p) {
        double sum = 0, size = 1e-3 * scale;
        for (size_t k = rows.first[i]; k < rows.first[i + 1]; ++k) {
          for (size_t q = 0; q < 3; ++q) {
            const double term = rows.block[9 * k + 3 * p + q] * direction[3 * size_t{rows.ball[k]} + q];
            sum += term;
            size += std::fabs(term);
          }
        }
        const double difference = std::fabs(sum - expected[3 * i + p]);
        if (difference > 0) tally.worst = std::max(tally.worst, difference / size);
        EXPECT_LE(difference, 1e-12 * size) << (of_volume ? "V" : "S") << ", ball " << i << " of " << n;
      }
    }
  }
  ++tally.sets;
}

// At least so large a part of the sets must have been compared.
void compare_many(Balls (*make)(RandomSource &), uint64_t seed, double part = 8.0 / 9) {
  RandomSource random(seed);
  Tally tally;
  const int sets = oracle::rounds(250, 2000);
  for (int k = 0; k < sets && !::testing::Test::HasFailure(); ++k) compare(make(random), random, tally);
  std::cout << tally.sets << " sets, " << tally.tied << " with ties, worst " << tally.worst << "\n";
  EXPECT_GT(static_cast<double>(tally.sets), part * sets);
}

TEST(Hessians, OfRandomSets) {
  compare_many(atoms, 1);
}
TEST(Hessians, OfUnevenSets) {
  compare_many(uneven, 2);
}
TEST(Hessians, OfChainsThatNearlyTouch) {
  compare_many(nearly_touching_chain, 3);
}
TEST(Hessians, OfTriplesThatAreNearlyFlat) {
  compare_many(nearly_flat_triples, 4);
}
TEST(Hessians, OfSpheresNearlyThroughPoints) {
  compare_many(nearly_through_points, 5);
}
TEST(Hessians, OfNoisyCrates) {
  compare_many(noisy_crate, 6);
}

TEST(Hessians, OfClustersOnALargeBall) {
  compare_many(on_a_large_ball, 7);
}
TEST(Hessians, OfSmallIntegers) {
  compare_many(small_integers, 8, 0.1);
}
TEST(Hessians, OfEqualBallsAmongOthers) {
  compare_many(with_equal_balls, 9, 0.01);
}

void compare_molecule(const oracle::NamedBalls &set, RandomSource &random) {
  Tally tally;
  compare(set.balls, random, tally);
  std::cout << set.name << ", " << set.balls.size() << " balls: worst " << tally.worst << "\n";
  EXPECT_LE(tally.worst, 1e-13) << set.name;
  EXPECT_EQ(tally.sets, 1U) << set.name;
}

TEST(Hessians, OfMolecules) {
  RandomSource random(7);
  for (const oracle::NamedBalls &set : molecules_of_gradient_tests()) compare_molecule(set, random);
}

TEST(Hessians, OfFurtherMolecules) {
  if (!oracle::long_tests()) GTEST_SKIP() << "in the long form alone";
  RandomSource random(10);
  for (const char *const name : {"4hhb.pdb.gz", "1tii.pdb.gz", "2buk.pdb.gz", "1m4x.pdb.gz"}) {
    const auto path = support::further_molecule(name);
    if (!path) continue;
    const support::BallList balls =
        with_radii(support::read_atoms(*path, support::Records::protein), support::Radii::van_der_waals);
    compare_molecule({name, oracle::on_lattice(balls, 0, 0x1p28)}, random);
  }
}

}  // namespace
