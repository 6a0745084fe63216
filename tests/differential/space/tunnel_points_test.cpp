// The points of tunnels: as near to each other as hsp_pores_get_tunnel_points, property 1, says, by distances of our
// own, in free space and in boxes, and the same way on lattices of other steps.
#include <gtest/gtest.h>
#include <hardsphere_workspace.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "../oracle/sweep_length.hpp"
#include "../support/molecule_file.hpp"
#include "../support/random_numbers.hpp"

namespace {

using Random = support::RandomNumbers<support::SplitMix64>;
using Point = std::array<double, 3>;

struct Workspace : hsp_workspace {
  Workspace() : hsp_workspace{} {}
  ~Workspace() { hsp_workspace_free(this); }
  Workspace(const Workspace &) = delete;
  Workspace &operator=(const Workspace &) = delete;
};

// Balls, in a box whose vectors are the rows of `box` or in free space.
struct Case {
  std::vector<double> xyz, radius;
  bool boxed = false;
  std::array<double, 9> box{};

  Point centre(uint32_t ball, const int32_t *shift) const {
    Point p{};
    for (size_t axis = 0; axis < 3; ++axis) {
      p[axis] = xyz[3 * size_t{ball} + axis];
      for (size_t v = 0; v < 3; ++v) p[axis] += shift[v] * box[3 * v + axis];
    }
    return p;
  }
};

double distance(const Point &p, const Point &q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

double six_decimals(double x) {
  return std::round(x * 1e6) / 1e6;
}

double between(Random &random, double low, double high) {
  return six_decimals(low + (high - low) * random.fraction());
}

Case random_case(uint64_t seed, bool boxed) {
  Random random(seed);
  Case made;
  made.boxed = boxed;
  const auto n = static_cast<uint32_t>(boxed ? random.in(1, 6) : random.in(3, 14));
  if (boxed) {
    for (size_t k = 0; k < 9; k += 4) made.box[k] = between(random, 2, 5);
    made.box[3] = between(random, -0.5, 0.5) * 2;
    made.box[6] = between(random, -0.5, 0.5) * 2;
    made.box[7] = between(random, -0.5, 0.5) * 2;
  }
  for (uint32_t i = 0; i < n; ++i) {
    for (int axis = 0; axis < 3; ++axis) made.xyz.push_back(between(random, 0, boxed ? 5 : 4));
    made.radius.push_back(between(random, 0.4, 1.1));
  }
  return made;
}

void compute(Workspace &work, const Case &of, double step) {
  hsp_model_options options;
  ASSERT_EQ(hsp_model_options_init(&options, sizeof options), HSP_OK);
  options.step = step;
  const auto n = static_cast<uint32_t>(of.radius.size());
  if (of.boxed) {
    ASSERT_EQ(hsp_workspace_periodic(&work, n, of.xyz.data(), of.radius.data(), of.box.data(), &options, nullptr),
              HSP_OK);
    ASSERT_EQ(hsp_workspace_pores_periodic(&work, nullptr), HSP_OK);
  } else {
    ASSERT_EQ(hsp_workspace_set(&work, n, of.xyz.data(), of.radius.data(), &options, nullptr), HSP_OK);
    ASSERT_EQ(hsp_workspace_pores(&work, nullptr), HSP_OK);
  }
}

int32_t find(Workspace &work, const Case &of, const Point &from, const Point *to, const std::vector<uint32_t> &avoided,
             hsp_tunnel &tunnel) {
  const double *const target = to != nullptr ? to->data() : nullptr;
  const auto count = static_cast<uint32_t>(avoided.size());
  return of.boxed ? hsp_workspace_tunnel_periodic(&work, nullptr, from.data(), target, avoided.data(), count, &tunnel)
                  : hsp_workspace_tunnel(&work, nullptr, from.data(), target, avoided.data(), count, &tunnel);
}

// How many steps between points of the last tunnel are longer than they may be.
int steps_too_long(const Workspace &work, const Case &of, uint32_t count) {
  std::vector<hsp_tunnel_point> points(count);
  std::vector<hsp_tunnel_point_shifts> shifts(count);
  EXPECT_EQ(hsp_pores_get_tunnel_points(work.pores, points.data(), count, nullptr), HSP_OK);
  EXPECT_EQ(hsp_pores_get_tunnel_point_shifts(work.pores, shifts.data(), count, nullptr), HSP_OK);
  const auto centre = [&](uint32_t k, uint32_t b) { return of.centre(points[k].ball[b], shifts[k].ball + 3 * b); };
  int wrong = 0;
  for (uint32_t k = 1; k < count; ++k) {
    const Point here{points[k].xyz[0], points[k].xyz[1], points[k].xyz[2]};
    const Point before{points[k - 1].xyz[0], points[k - 1].xyz[1], points[k - 1].xyz[2]};
    // The farther one of the two from the centres of balls nearest to both, or else to either.
    double of_both = 0, of_either = 0;
    for (uint32_t a = 0; a < 4 && points[k].ball[a] != HSP_NONE; ++a) {
      const Point ball = centre(k, a);
      const double farther = std::fmax(distance(here, ball), distance(before, ball));
      of_either = std::fmax(of_either, distance(here, ball));
      for (uint32_t b = 0; b < 4 && points[k - 1].ball[b] != HSP_NONE; ++b) {
        if (distance(ball, centre(k - 1, b)) < 1e-6) of_both = std::fmax(of_both, farther);
      }
    }
    for (uint32_t b = 0; b < 4 && points[k - 1].ball[b] != HSP_NONE; ++b) {
      of_either = std::fmax(of_either, distance(before, centre(k - 1, b)));
    }
    if (distance(here, before) > 0.1 * (of_both > 0 ? of_both : of_either) + 1e-6) ++wrong;
  }
  return wrong;
}

// Three tunnels a set and more, each the next best one.
void sweep(bool boxed, int sets, uint64_t first) {
  Workspace work;
  int tunnels = 0, wrong = 0;
  for (int k = 0; k < sets; ++k) {
    const Case of = random_case(first + static_cast<uint64_t>(k), boxed);
    SCOPED_TRACE(k);
    compute(work, of, 0);
    Random random(977 * first + static_cast<uint64_t>(k));
    for (int question = 0; question < 3; ++question) {
      Point from{}, to{};
      for (size_t axis = 0; axis < 3; ++axis) {
        from[axis] = between(random, 0, boxed ? 6 : 4);
        to[axis] = between(random, 0, boxed ? 6 : 4);
      }
      std::vector<uint32_t> avoided;
      for (int next = 0; next < 2; ++next) {
        hsp_tunnel tunnel;
        const Point *const target = question % 2 == 0 ? &to : nullptr;
        ASSERT_EQ(find(work, of, from, target, avoided, tunnel), HSP_OK);
        // One that comes back from the outside leaps there.
        if (tunnel.there == 0 || (target != nullptr && tunnel.outside != 0)) break;
        ++tunnels;
        wrong += steps_too_long(work, of, tunnel.points) > 0;
        if (tunnel.gate == HSP_NONE) break;
        avoided.push_back(tunnel.gate);
      }
    }
  }
  EXPECT_EQ(wrong, 0) << "of " << tunnels;
  EXPECT_GT(tunnels, sets / 4);
}

TEST(TunnelPoints, AreNearToEachOther) {
  sweep(false, oracle::rounds(300, 4000), 5000);
}

TEST(TunnelPoints, AreNearToEachOtherInBoxes) {
  sweep(true, oracle::rounds(100, 1200), 7000);
}

// By how many steps of the lattice the largest probe at a point of a tunnel is narrower than the point says, at most,
// of all tunnels between maxima and to the outside.
double shortfall(Workspace &work, const Case &of, double step) {
  hsp_model_options lattice;
  EXPECT_EQ(hsp_model_options_init(&lattice, sizeof lattice), HSP_OK);
  lattice.step = step;
  hsp_pores_options options;
  EXPECT_EQ(hsp_pores_options_init(&options, sizeof options), HSP_OK);
  options.floor = -0.3;
  const auto n = static_cast<uint32_t>(of.radius.size());
  EXPECT_EQ(hsp_workspace_set(&work, n, of.xyz.data(), of.radius.data(), &lattice, nullptr), HSP_OK);
  EXPECT_EQ(hsp_workspace_pores(&work, &options), HSP_OK);
  hsp_pores_counts counts{};
  EXPECT_EQ(hsp_pores_get_counts(work.pores, &counts), HSP_OK);
  std::vector<hsp_pore_maximum> maxima(counts.maxima);
  EXPECT_EQ(hsp_pores_get_maxima(work.pores, 0, counts.maxima, maxima.data()), HSP_OK);
  double most = 0;
  for (uint32_t a = 0; a < counts.maxima; ++a) {
    for (uint32_t b = a + 1; b <= counts.maxima; ++b) {
      const double *const to = b < counts.maxima ? maxima[b].xyz : nullptr;
      hsp_tunnel tunnel{};
      EXPECT_EQ(hsp_workspace_tunnel(&work, &options, maxima[a].xyz, to, nullptr, 0, &tunnel), HSP_OK);
      std::vector<hsp_tunnel_point> points(tunnel.points);
      EXPECT_EQ(hsp_pores_get_tunnel_points(work.pores, points.data(), tunnel.points, nullptr), HSP_OK);
      for (const hsp_tunnel_point &point : points) {
        double widest = std::numeric_limits<double>::infinity();
        for (uint32_t i = 0; i < n; ++i) {
          const Point at{point.xyz[0], point.xyz[1], point.xyz[2]};
          widest = std::fmin(widest, distance(at, of.centre(i, std::array<int32_t, 3>{}.data())) - of.radius[i]);
        }
        most = std::fmax(most, (point.radius - widest) / step);
      }
    }
  }
  return most;
}

// A gate and a maximum beside it whose levels are one double: nothing says how long the curve between them is.
TEST(TunnelPoints, LieOnTheirWayWhereBallsNearlyTie) {
  Workspace work;
  const Case six{{0.99999999, -1e-8, 1.00000001, 1, 1.99999999, 0.99999999, 2, 1, 0.99999999, 1, 1.00000001, 2,
                  0.99999999, 1, -1e-8, -1e-8, 1.00000001, 1.00000001},
                 {0.99999999, 0.99999999, 0.99999999, 1, 1.00000001, 0.99999999}};
  EXPECT_LT(shortfall(work, six, 1e-9), 8);
  Random random(41);
  for (int k = 0; k < oracle::rounds(200, 4000); ++k) {
    SCOPED_TRACE(k);
    Case made;
    const auto n = static_cast<uint32_t>(random.in(4, 9));
    const auto beside = [&] { return 1e-8 * static_cast<double>(random.in(-1, 1)); };
    for (uint32_t i = 0; i < 3 * n; ++i) made.xyz.push_back(static_cast<double>(random.in(0, 2)) + beside());
    for (uint32_t i = 0; i < n; ++i) made.radius.push_back(1 + beside());
    EXPECT_LT(shortfall(work, made, 1e-9), 64);
  }
}

// From the roomiest place to the outside, up to three times, on lattices of four steps. How many there are; without a
// maximum none.
int same_way(const Case &of) {
  Workspace work;
  std::vector<double> first;
  for (const double step : {1e-8, 1e-7, 1e-6, 1e-5}) {
    SCOPED_TRACE(step);
    compute(work, of, step);
    hsp_pores_counts counts;
    EXPECT_EQ(hsp_pores_get_counts(work.pores, &counts), HSP_OK);
    if (counts.maxima == 0) return 0;
    hsp_pore_maximum widest;
    EXPECT_EQ(hsp_pores_get_maxima(work.pores, 0, 1, &widest), HSP_OK);
    std::vector<double> lengths;
    std::vector<uint32_t> avoided;
    for (int next = 0; next < 3; ++next) {
      hsp_tunnel tunnel;
      const Point from{widest.xyz[0], widest.xyz[1], widest.xyz[2]};
      EXPECT_EQ(find(work, of, from, nullptr, avoided, tunnel), HSP_OK);
      if (tunnel.there == 0) break;
      lengths.push_back(tunnel.length);
      if (tunnel.gate == HSP_NONE) break;
      avoided.push_back(tunnel.gate);
    }
    if (first.empty()) first = lengths;
    EXPECT_EQ(lengths.size(), first.size());
    for (size_t k = 0; k < std::min(first.size(), lengths.size()); ++k) EXPECT_NEAR(lengths[k], first[k], 1e-3) << k;
  }
  return static_cast<int>(first.size());
}

Case protein(const char *name) {
  const support::BallList balls = support::with_radii(
      support::read_atoms(support::own_molecule(name), support::Records::protein), support::Radii::van_der_waals);
  return {balls.xyz, balls.radius, false, {}};
}

TEST(TunnelPoints, AreThoseOfTheSameWayOnEveryLattice) {
  for (const char *const name : {"crambin.pdb", "ubiquitin.pdb"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(same_way(protein(name)), 3);
  }
}

TEST(TunnelPoints, OfFewBallsAreThoseOfTheSameWayOnEveryLattice) {
  const int sets = oracle::rounds(100, 1000);
  int tunnels = 0;
  for (int k = 0; k < sets; ++k) {
    SCOPED_TRACE(k);
    tunnels += same_way(random_case(9000 + static_cast<uint64_t>(k), false));
  }
  EXPECT_GT(tunnels, sets);
}

}  // namespace
