// Creases beside those of surfaces that doubles decide patch by patch, where these fit together: as many pieces, arcs,
// creases and corners, the same areas. And the rules of every set: borders chain, every crease is in two patches, every
// corner in three.
#include "surface/creases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "built_creases.hpp"
#include "excluded_surface.hpp"
#include "molecule_file.hpp"
#include "random_numbers.hpp"
#include "sweep_length.hpp"
#include "tied_families.hpp"

namespace {

double largest_difference(const BuiltSurface &built, const BuiltCreases &creases) {
  const double p = static_cast<double>(built.balls().probe_steps);
  double worst = 0.0;
  for (uint32_t v = 0; v < built.boundary().vertex_count(); ++v) {
    const hsp::ConcavePatch ours = creases.patch(v), theirs = built.surface().patch(v);
    worst = std::max(worst, std::fabs(ours.area - theirs.area) / (p * p));
    const hsp::Vec3 apart = ours.vector_area - theirs.vector_area;
    worst = std::max(worst, std::sqrt(dot(apart, apart)));
  }
  return worst;
}

// Of a structure alone.
void expect_closed(const BuiltSurface &built, const BuiltCreases &creases) {
  const hsp::CutPatches &cut = creases.cut();
  const uint32_t first_corner = 3 * built.boundary().vertex_count() + 2 * built.surface().cusped_circles().count();
  std::map<uint32_t, uint32_t> starts;
  uint32_t of_creases = 0;
  for (uint32_t v = 0; v < built.boundary().vertex_count(); ++v) {
    for (const uint32_t piece : cut.pieces(v)) {
      for (const uint32_t a : cut.arcs(piece)) {
        const hsp::PatchArc &arc = cut.arc(a);
        EXPECT_GT(arc.angle, 0.0);
        EXPECT_LE(arc.angle, 2 * hsp::pi);
        if (arc.corner != hsp::no_id) ++starts[arc.corner];
        if (arc.is_side()) {
          EXPECT_EQ(arc.twin, hsp::no_id);
          continue;
        }
        ++of_creases;
        ASSERT_NE(arc.twin, hsp::no_id);
        const hsp::PatchArc &twin = cut.arc(arc.twin);
        EXPECT_EQ(twin.twin, a);
        EXPECT_EQ(twin.across, v);
        EXPECT_NE(arc.across, v);
        EXPECT_EQ(arc.corner, arc.corner == hsp::no_id ? twin.corner : cut.end_corner(arc.twin));
        EXPECT_NEAR(twin.angle, arc.angle, 1e-9);
        EXPECT_EQ(cut.creases().has(a), a < arc.twin);
      }
    }
  }
  EXPECT_EQ(of_creases, 2 * cut.creases().size());
  for (const auto &[corner, count] : starts) {
    if (corner < 3 * built.boundary().vertex_count()) {
      EXPECT_EQ(count, 1U);
    } else if (corner >= first_corner) {
      EXPECT_EQ(count, 3U);
      EXPECT_LT(corner - first_corner, cut.crease_corners().size());
      EXPECT_EQ(cut.arc(cut.crease_corners().member(corner - first_corner)).corner, corner);
    }
  }
}

struct Tally {
  uint32_t sets = 0, compared = 0, creases = 0, corners = 0, pieces = 0, split = 0, circles = 0;
  hsp::ActualBalls::Answers answers;
};

void compare(const support::BallList &list, double probe, double step, double most, Tally &tally,
             bool same_structure = true) {
  const BuiltSurface built(list, probe, step);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const BuiltCreases creases(built);
  ASSERT_EQ(creases.status(), hsp::Status::ok);
  ASSERT_NO_FATAL_FAILURE(expect_closed(built, creases));
  ++tally.sets;
  const hsp::CutPatches &ours = creases.cut(), &theirs = built.surface().cut_patches();
  EXPECT_LE(largest_difference(built, creases), most);
  EXPECT_EQ(creases.actual().answers().by_none, 0U);
  tally.creases += ours.creases().size();
  tally.corners += ours.crease_corners().size();
  tally.pieces += ours.piece_count();
  tally.split += ours.extra_pieces().size();
  for (const hsp::Crease &crease : creases.creases().creases()) tally.circles += crease.start == hsp::no_id ? 1U : 0U;
  tally.answers.by_doubles += creases.actual().answers().by_doubles;
  tally.answers.by_floats += creases.actual().answers().by_floats;
  if (!same_structure) return;
  ++tally.compared;
  EXPECT_EQ(ours.piece_count(), theirs.piece_count());
  EXPECT_EQ(ours.arc_count(), theirs.arc_count());
  EXPECT_EQ(ours.creases().size(), theirs.creases().size());
  EXPECT_EQ(ours.crease_corners().size(), theirs.crease_corners().size());
}

support::BallList random_list(support::Random &random, uint32_t n, double side, double radius, uint32_t one_point_in) {
  support::BallList list;
  const auto below = [&random](double x) { return std::floor(x * random.fraction() * 1e6) / 1e6; };
  for (uint32_t i = 0; i < n; ++i) {
    const double x = below(side), y = below(side), z = below(side), r = below(radius);
    list.add(x, y, z, random.below(one_point_in) == 0 ? 0.0 : r);
  }
  return list;
}

constexpr double probes[] = {0.5, 1.0, 1.4, 2.0, 3.0, 8.0};

TEST(Creases, OfRandomBalls) {
  support::Random random(81);
  Tally tally;
  for (int turn = 0; turn < oracle::rounds(150, 5000) && !testing::Test::HasFailure(); ++turn) {
    const uint32_t n = 4 + random.below(16);
    compare(random_list(random, n, 1.0 + random.below(3), 0.5, 1000), probes[random.below(6)], 1e-8, 1e-6, tally);
  }
  EXPECT_GT(tally.compared, tally.sets / 2);
  EXPECT_GT(tally.creases, 30U);
  EXPECT_GT(tally.corners, 0U);
}

// Points, and balls with points among them: all probes around a point meet in it, where the old builder takes smaller
// ones.
TEST(Creases, OfRandomPoints) {
  support::Random random(82);
  Tally tally;
  for (int turn = 0; turn < oracle::rounds(50, 3000) && !testing::Test::HasFailure(); ++turn) {
    const uint32_t n = 4 + random.below(3);
    compare(random_list(random, n, 1.0 + random.below(3), 1.0, 1 + random.below(2)), probes[random.below(6)], 1e-8,
            1e-6, tally);
  }
  EXPECT_GT(tally.compared, tally.sets / 2);
  EXPECT_GT(tally.answers.by_floats, 100U);
}

// Five points of a lattice, moved by up to ten steps: here the patches of the old builder often do not fit together.
TEST(Creases, OfPointsNearALattice) {
  support::Random random(83);
  Tally tally;
  for (int turn = 0; turn < oracle::rounds(50, 3000) && !testing::Test::HasFailure(); ++turn) {
    support::BallList list;
    const auto near = [&random] { return random.below(3) + (static_cast<double>(random.below(21)) - 10.0) * 1e-8; };
    for (uint32_t i = 0; i < 5; ++i) {
      const double x = near(), y = near(), z = near();
      list.add(x, y, z, 0.0);
    }
    compare(list, probes[1 + random.below(5)], 1e-8, 1e-6, tally);
  }
  EXPECT_LE(tally.compared, tally.sets);
  EXPECT_GT(tally.answers.by_floats, 100U);
}

// With a usual probe no question goes beyond doubles, and areas are the same but for rounding.
TEST(Creases, OfCrambin) {
  const support::BallList balls =
      with_radii(support::read_atoms(support::own_molecule("crambin.pdb")), support::Radii::van_der_waals);
  Tally tally;
  for (const double probe : {1.4, 3.0, 0.5}) {
    compare(balls, probe, 0.0, 1e-12, tally);
    if (probe > 1.0) {
      EXPECT_EQ(tally.answers.by_floats, 0U);
    }
  }
  EXPECT_EQ(tally.compared, 3U);
  EXPECT_EQ(tally.creases, 54U + 21U + 7U);
  EXPECT_EQ(tally.corners, 2U);
}

// The whole area, from creases and from the definition of the surface alone. There balls are a little larger, as exact
// ties would be decided by roundings: areas move like the root of that.
void expect_areas_of_definition(const BuiltSurface &built, const BuiltCreases &creases, const support::BallList &list,
                                double probe) {
  const double p = static_cast<double>(built.balls().probe_steps);
  const hsp::SurfaceMeasure total = built.total();
  double area = (total.convex + total.saddle) / (probe * probe);
  for (uint32_t v = 0; v < built.boundary().vertex_count(); ++v) area += creases.patch(v).area / (p * p);
  std::vector<oracle::ProbedBall> balls;
  for (uint32_t i = 0; i < list.size(); ++i) {
    balls.push_back({{list.xyz[3 * i], list.xyz[3 * i + 1], list.xyz[3 * i + 2]}, list.radius[i] + probe + 1e-5});
  }
  const oracle::AreaAndVolume expected = oracle::excluded_surface_by_lines(balls, probe, 48);
  EXPECT_NEAR(area, expected.area / (probe * probe), 6e-3 * expected.area / (probe * probe) + 1e-2);
}

// Sets of all families with ties.
TEST(Creases, OfTiedFamilies) {
  for (const support::TiedFamily &family : support::tied_families) {
    SCOPED_TRACE(family.name);
    Tally tally;
    for (int k = 0; k < oracle::rounds(4, 1000) && !testing::Test::HasFailure(); ++k) {
      SCOPED_TRACE(k);
      const support::TiedSet set = family.member(static_cast<uint64_t>(k));
      compare(set.balls, set.probe, 0.0, 1e-3, tally, false);
    }
  }
}

// Points are kept as far as there is room for them: that must not be seen in the last bit of any patch.
TEST(Creases, HaveTheSameBitsInAnyRoom) {
  for (const support::TiedFamily &family : support::tied_families) {
    for (uint64_t k = 0; k < 3; ++k) {
      SCOPED_TRACE(family.name + std::to_string(k));
      const support::TiedSet set = family.member(k);
      const BuiltSurface built(set.balls, set.probe, 0.0);
      const hsp::Boundary &boundary = built.boundary();
      for (const uint32_t neighbours : {1U, 400U}) {
        hsp::SurfaceLimits limits =
            hsp::default_limits(boundary.vertex_count(), boundary.face_count(), boundary.circle_count());
        limits.neighbours = neighbours;
        CarvedMemory memory;
        hsp::SurfaceBuilder builder;
        ASSERT_EQ(memory.build(builder, limits, built.balls(), boundary), hsp::Status::ok);
        for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
          EXPECT_EQ(builder.surface().patch(v).area, built.surface().patch(v).area) << v;
          EXPECT_EQ(builder.surface().patch(v).vector_area.x, built.surface().patch(v).vector_area.x) << v;
        }
      }
    }
  }
}

// Probes of one circle whose coordinates are alike: a point of it has to be the same one for every question.
TEST(Creases, OfBallsThatTouchWhereOthersPass) {
  const double sets[][6][3] = {{{0, 1, 0}, {.6, 0, -.8}, {0, -1, 0}, {0, -1, 0}, {0, 1, 0}},
                               {{.48, .6, .64}, {0, 1, 0}, {0, .6, .8}, {.6, .8, 0}, {0, -1, 0}},
                               {{0, .6, .8}, {.64, .48, -.6}, {-.48, .64, .6}, {.8, 0, .6}, {0, 0, 1}}};
  const double probe[] = {0.5, 0.5, 1.0};
  const uint32_t creases[] = {8, 16, 42}, corners[] = {4, 8, 18};
  for (uint32_t k = 0; k < 3; ++k) {
    SCOPED_TRACE(k);
    support::BallList list;
    list.add(1, 0, 0, 1 - probe[k]);
    list.add(-1, 0, 0, 1 - probe[k]);
    for (uint32_t i = 0; i < 5; ++i) list.add(sets[k][i][0], sets[k][i][1], sets[k][i][2], 1 - probe[k]);
    const BuiltSurface built(list, probe[k], 1e-8);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const BuiltCreases found(built);
    ASSERT_EQ(found.status(), hsp::Status::ok);
    expect_closed(built, found);
    expect_areas_of_definition(built, found, list, probe[k]);
    // Which creases without length there are depends on how balls are moved.
    EXPECT_NEAR(found.creases().creases().size(), creases[k], 6);
    EXPECT_NEAR(found.creases().corners().size(), corners[k], 6);
  }
}

// Balls around lattice points of a circle, whose spheres meet in two points: about as many vertices as balls are in
// each of them. Pairs of them are asked about, not triples. All patches there make up the angle of a pyramid.
TEST(Creases, OfManyProbesInOnePoint) {
  constexpr int circle = 325, distance = 845, height = 780;
  constexpr double probe = 65.0;
  support::BallList list;
  for (int y = -circle; y <= circle; ++y) {
    for (int z = -circle; z <= circle; ++z) {
      if (y * y + z * z == circle * circle) list.add(0.0, y, z, distance - probe);
    }
  }
  const BuiltSurface built(list, probe, 1e-4);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const BuiltCreases found(built);
  ASSERT_EQ(found.status(), hsp::Status::ok);
  expect_closed(built, found);
  const uint32_t vertices = built.boundary().vertex_count();
  EXPECT_EQ(vertices, 2 * (list.size() - 2));
  EXPECT_LT(found.actual().answers().by_floats, 2 * uint64_t{vertices} * vertices);
  double area = 0.0;
  for (uint32_t v = 0; v < vertices; ++v) area += found.patch(v).area;
  std::vector<double> angles;
  for (uint32_t i = 0; i < list.size(); ++i) angles.push_back(std::atan2(list.xyz[3 * i + 1], list.xyz[3 * i + 2]));
  std::sort(angles.begin(), angles.end());
  angles.push_back(angles.front() + 2 * hsp::pi);
  double steradians = 0.0;
  for (size_t k = 0; k + 1 < angles.size(); ++k) {
    // The triangle of two directions and the axis.
    const double half = 0.5 * (angles[k + 1] - angles[k]);
    steradians += 2.0 * (half - std::atan(std::tan(half) * height / distance));
  }
  const double p = static_cast<double>(built.balls().probe_steps);
  EXPECT_NEAR(area / (p * p), 2.0 * steradians, 1e-9);
}

// A triangle that a probe touches from both sides: the patches of its two vertices meet in a whole circle, as all three
// sides are farther from the middle. With sides nearer to it there are cusps, and each crease joins two of them.
TEST(Creases, OfFewBalls) {
  Tally tally;
  for (const bool along_x : {false, true}) {
    support::BallList triangle;
    for (const auto &[a, b] : {std::pair{0.0, 0.0}, std::pair{3.3, 0.0}, std::pair{1.65, 2.858}}) {
      along_x ? triangle.add(0, a, b, 1.0) : triangle.add(a, b, 0, 1.0);
    }
    compare(triangle, 1.0, 1e-6, 1e-9, tally);
  }
  EXPECT_EQ(tally.compared, 2U);
  EXPECT_EQ(tally.creases, 2U);
  EXPECT_EQ(tally.circles, 2U);
  support::BallList larger;
  larger.add(0, 0, 0, 1.0);
  larger.add(4.8, 0, 0, 1.0);
  larger.add(2.4, 4.157, 0, 1.0);
  compare(larger, 2.0, 1e-6, 1e-9, tally);
  EXPECT_EQ(tally.compared, 3U);
  EXPECT_EQ(tally.creases, 2U + 3U);
}

}  // namespace
