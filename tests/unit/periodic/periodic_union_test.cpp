// Unions in boxes against the same balls in many explicit copies, against more copies in a larger box, against
// themselves from other images, and against values that another program computed with 113 bits.
#include "periodic/periodic_union.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "curvature/morphometry.hpp"
#include "lattice_lengths.hpp"
#include "measure/boundary_positions.hpp"
#include "molecule_file.hpp"
#include "periodic_crystals.hpp"

namespace {

constexpr BoxVectors cube(double side) {
  return {side, 0, 0, 0, side, 0, 0, 0, side};
}
constexpr BoxVectors skew{4, 0, 0, 1.25, 4.5, 0, -1.5, 0.75, 3.75};

TEST(PeriodicUnion, IsThatOfManyCopies) {
  oracle::RandomSource random(321);
  for (int set = 0; set < 12 && !HasFailure(); ++set) expect_as_in_copies(RandomCrystal(random, set % 2 == 0));
}

// Crystals in which all or many vertices tie, and their copies: body-centred and face-centred, caesium chloride, rock
// salt, diamond, and a skew box with every ball twice.
TEST(PeriodicUnion, OfCrystalsIsThatOfManyCopies) {
  const std::vector<std::array<double, 4>> face_centred{{0, 0, 0, 3}, {0, 4, 4, 3}, {4, 0, 4, 3}, {4, 4, 0, 3}};
  std::vector<std::array<double, 4>> rock_salt = face_centred, diamond;
  for (const auto &[x, y, z, r] : face_centred) {
    rock_salt.push_back({x + 4, y, z, 2});
    diamond.push_back({x, y, z, 2});
    diamond.push_back({x + 2, y + 2, z + 2, 2});
  }
  const BoxVectors leaning{4, 0, 0, 2, 4, 0, -2, 2, 4};
  for (const auto &[balls, box] : std::vector<std::pair<std::vector<std::array<double, 4>>, BoxVectors>>{
           {{{0, 0, 0, 2}}, cube(4)},
           {{{0, 0, 0, 3}}, cube(4)},
           {{{0, 0, 0, 4}}, cube(8)},
           {{{0, 0, 0, 3}, {2, 2, 2, 3}}, cube(4)},
           {{{0, 0, 0, 2}, {2, 2, 2, 1}}, cube(4)},
           {face_centred, cube(8)},
           {rock_salt, cube(8)},
           {diamond, cube(8)},
           {{{0, 0, 0, 2}, {0, 0, 0, 2}, {2, 1, 2, 2}, {2, 1, 2, 2}}, leaning}}) {
    Crystal crystal;
    crystal.balls = balls_of(balls);
    crystal.box = box;
    expect_as_in_copies(crystal, box[3] == 0.0 ? 2 : 4);
    if (HasFailure()) return;
  }
}

// A larger box of m x m x m copies has that many of everything, and what wraps less often there goes on all the same.
TEST(PeriodicUnion, HasSoManyOfEverythingInALargerBox) {
  oracle::RandomSource random(322);
  for (int set = 0; set < 24; ++set) {
    const RandomCrystal crystal(random, set % 2 == 0);
    const BuiltPeriodic one(crystal.balls, crystal.box);
    const int m = set % 3 == 0 ? 3 : 2;
    support::BallList balls;
    BoxVectors box = crystal.box;
    for (double &x : box) x *= m;
    for (int a = 0; a < m; ++a) {
      for (int b = 0; b < m; ++b) {
        for (int c = 0; c < m; ++c) {
          for (uint32_t i = 0; i < one.balls(); ++i) add_copy(crystal.balls, crystal.box, {a, b, c}, i, balls);
        }
      }
    }
    const BuiltPeriodic all(balls, box);
    ASSERT_EQ(one.status(), hsp::Status::ok);
    ASSERT_EQ(all.status(), hsp::Status::ok);
    expect_laws(one);
    expect_laws(all);
    const uint32_t times = static_cast<uint32_t>(m * m * m);
    EXPECT_EQ(all->counts().vertices, times * one->counts().vertices);
    EXPECT_EQ(all->counts().arcs, times * one->counts().arcs);
    EXPECT_EQ(all->counts().circles, times * one->counts().circles);
    EXPECT_EQ(all->counts().loops, times * one->counts().loops);
    EXPECT_EQ(all->counts().faces, times * one->counts().faces);
    EXPECT_EQ(all->counts().contacts, times * one->counts().contacts);
    const hsp::PeriodicTotals few = one.totals();
    const hsp::PeriodicTotals many = all.totals();
    EXPECT_NEAR(many.area, times * few.area, 1e-12 * times * few.box_volume);
    EXPECT_NEAR(many.volume, times * few.volume, 1e-12 * many.box_volume);
    EXPECT_EQ(many.box_volume, times * few.box_volume);
    EXPECT_NEAR(many.free_volume, times * few.free_volume, 1e-12 * many.box_volume);
    EXPECT_NEAR(many.contact_area, times * few.contact_area, 1e-12 * many.box_volume);
    for (uint32_t i = 0; i < one.balls(); ++i) {
      EXPECT_EQ(all->windings().lattice(all->windings().component(i)).rank,
                one->windings().lattice(one->windings().component(i)).rank);
    }
  }
}

void expect_same_bits(const BuiltPeriodic &p, const BuiltPeriodic &q) {
  ASSERT_EQ(p.status(), hsp::Status::ok);
  ASSERT_EQ(q.status(), hsp::Status::ok);
  const hsp::PeriodicTotals a = p.totals();
  const hsp::PeriodicTotals b = q.totals();
  EXPECT_EQ(a.area, b.area);
  EXPECT_EQ(a.volume, b.volume);
  EXPECT_EQ(a.free_volume, b.free_volume);
  EXPECT_EQ(a.contact_area, b.contact_area);
  EXPECT_EQ(p->counts().vertices, q->counts().vertices);
  EXPECT_EQ(p->counts().shells, q->counts().shells);
  EXPECT_EQ(p->counts().components, q->counts().components);
  for (uint32_t i = 0; i < p.balls(); ++i) {
    EXPECT_EQ(p.of_ball(i).area, q.of_ball(i).area);
    EXPECT_EQ(p.of_ball(i).volume, q.of_ball(i).volume);
  }
}

TEST(PeriodicUnion, HasTheSameBitsForAllImages) {
  oracle::RandomSource random(323);
  for (int set = 0; set < 30; ++set) {
    const RandomCrystal crystal(random, set % 2 == 0);
    const BuiltPeriodic built(crystal.balls, crystal.box);
    support::BallList others;
    std::vector<std::array<int, 3>> moved;
    for (uint32_t i = 0; i < built.balls(); ++i) {
      std::array<int, 3> times;
      for (int &k : times) k = static_cast<int>(random.in(-5, 5));
      moved.push_back(times);
      add_copy(crystal.balls, crystal.box, times, i, others);
    }
    const BuiltPeriodic again(others, crystal.box);
    expect_same_bits(built, again);
    // Another basis of the same box: b + 2 a, c - b + a.
    BoxVectors skewed = crystal.box;
    for (size_t k = 0; k < 3; ++k) {
      skewed[3 + k] += 2 * crystal.box[k];
      skewed[6 + k] += crystal.box[k] - crystal.box[3 + k];
    }
    expect_same_bits(built, BuiltPeriodic(crystal.balls, skewed));
    // Contacts lead from ball to ball, wherever the caller has put them.
    for (uint32_t i = 0; i < built.balls(); ++i) {
      again->visit_contacts_of(i, [&](const hsp::PeriodicContact &contact) {
        const uint32_t j = again->images().ball_of(contact.other);
        const hsp::BoxShift shift = again->images().caller_shift(i, contact.other);
        const hsp::Vec3 v =
            again->balls().difference(again->grid().grid_index(i), again->grid().grid_index(contact.other));
        const double to[3] = {v.x, v.y, v.z};
        for (size_t axis = 0; axis < 3; ++axis) {
          double difference = others.xyz[3 * j + axis] - others.xyz[3 * i + axis];
          for (size_t row = 0; row < 3; ++row) difference += shift.k[row] * crystal.box[3 * row + axis];
          EXPECT_EQ(difference, to[axis]);
        }
      });
    }
  }
}

// Shells joined in another way: faces that share a point of the torus, by its coordinates.
TEST(PeriodicUnion, CountsShellsByTheirPoints) {
  oracle::RandomSource random(324);
  uint32_t several = 0;
  for (int set = 0; set < 60; ++set) {
    const RandomCrystal crystal(random, false, 2);
    const BuiltPeriodic built(crystal.balls, crystal.box);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::Boundary &b = built->boundary();
    std::map<std::array<int64_t, 3>, uint32_t> face_at;
    std::vector<uint32_t> parent(b.face_count());
    for (uint32_t f = 0; f < b.face_count(); ++f) parent[f] = f;
    const auto root = [&](uint32_t f) {
      while (parent[f] != f) f = parent[f];
      return f;
    };
    const auto meet_at = [&](const double(&xyz)[3], uint32_t face) {
      // Rounded to a tenth of a step; a point at a wall of the box or between two such tenths may be missed, so that
      // all near ones are looked at.
      for (int64_t code = 0; code < 27; ++code) {
        double p[3];
        const int64_t near[3] = {code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
        for (size_t k = 0; k < 3; ++k) p[k] = xyz[k] + 1e-3 * static_cast<double>(near[k]);
        for (size_t row = 3; row-- > 0;) {
          const double times = std::floor(p[row] / crystal.box[4 * row]);
          for (size_t k = 0; k < 3; ++k) p[k] -= times * crystal.box[3 * row + k];
        }
        const std::array<int64_t, 3> key{std::llround(10 * p[0]), std::llround(10 * p[1]), std::llround(10 * p[2])};
        const auto [at, is_new] = face_at.insert({key, face});
        if (!is_new) parent[root(face)] = root(at->second);
      }
    };
    for (uint32_t i = 0; i < built.balls(); ++i) {
      const uint32_t ball = built->grid().grid_index(i);
      for (const uint32_t e : b.half_edges(ball)) {
        double xyz[3];
        hsp::to_coordinates(built->balls(), hsp::position_of_vertex(built->balls(), b, b.half_edge(e).vertex), xyz);
        meet_at(xyz, b.face_of(e));
      }
      for (const hsp::ClosedHalfEdge e : b.circles(ball)) {
        double xyz[3];
        hsp::to_coordinates(built->balls(), hsp::position_of_circle(built->balls(), ball, b.neighbour(e)).centre, xyz);
        meet_at(xyz, b.face_of_loop(b.loop_of(e)));
      }
    }
    uint32_t shells = 0;
    for (uint32_t i = 0; i < built.balls(); ++i) {
      for (const uint32_t f : b.faces(built->grid().grid_index(i))) shells += parent[f] == f ? 1U : 0U;
    }
    EXPECT_EQ(built->counts().shells, shells);
    several += shells > 1 ? 1U : 0U;
  }
  EXPECT_GT(several, 5U);
}

struct Reference {
  const char *name;
  std::vector<std::array<double, 4>> balls;
  BoxVectors box;
  double area, volume, contact_area;
  uint32_t vertices, arcs, circles, faces, contacts;
  int64_t euler;
  uint32_t rank;
};

// Values that another program computed with 113 bits.
TEST(PeriodicUnion, HasTheReferenceValuesOfSmallSets) {
  const Reference references[] = {
      {"apart", {{1, 2, 3, 1.5}}, cube(4), 28.274333882308, 14.137166941154, 0, 0, 0, 0, 1, 0, 2, 0},
      {"meets itself",
       {{1, 2, 3, 2.25}},
       cube(4),
       42.411500823462,
       45.160394395353,
       10.013826583317,
       0,
       0,
       3,
       1,
       3,
       -4,
       3},
      {"rod",
       {{0, 0, 0, 1.25}, {2, 0, 0, 1.25}},
       cube(4),
       31.415926535898,
       15.44616388015,
       3.5342917352885,
       0,
       0,
       2,
       2,
       2,
       0,
       1},
      {"askew",
       {{0, 0, 0, 1.5}, {2, 1.25, 0.5, 1.75}},
       skew,
       49.761059346619,
       33.330136722756,
       7.3810537076276,
       0,
       0,
       2,
       2,
       2,
       0,
       1},
      {"chain",
       {{0, 0, 0, 1.75}, {2, 2, 0, 1.25}},
       cube(4),
       51.841888628008,
       30.366551965965,
       3.0434178831651,
       0,
       0,
       4,
       2,
       4,
       -4,
       2},
  };
  for (const Reference &reference : references) {
    const BuiltPeriodic built(balls_of(reference.balls), reference.box, 0.0, 0.0);
    ASSERT_EQ(built.status(), hsp::Status::ok) << reference.name;
    const hsp::PeriodicTotals totals = built.totals();
    EXPECT_NEAR(totals.area, reference.area, 1e-11) << reference.name;
    EXPECT_NEAR(totals.volume, reference.volume, 1e-11) << reference.name;
    EXPECT_NEAR(totals.contact_area, reference.contact_area, 1e-11) << reference.name;
    EXPECT_EQ(totals.free_volume, totals.box_volume - totals.volume) << reference.name;
    const hsp::PeriodicCounts &counts = built->counts();
    EXPECT_EQ(counts.vertices, reference.vertices) << reference.name;
    EXPECT_EQ(counts.arcs, reference.arcs) << reference.name;
    EXPECT_EQ(counts.circles, reference.circles) << reference.name;
    EXPECT_EQ(counts.faces, reference.faces) << reference.name;
    EXPECT_EQ(counts.contacts, reference.contacts) << reference.name;
    EXPECT_EQ(counts.euler(), reference.euler) << reference.name;
    EXPECT_EQ(counts.components, 1U) << reference.name;
    EXPECT_EQ(built->windings().lattice(0).rank, reference.rank) << reference.name;
    EXPECT_EQ(built->windings().lattice(0).copies(), 1U) << reference.name;
  }
}

// Of four boxes, by the same program: area, volume, contacts, counts, windings.
TEST(PeriodicUnion, HasTheReferenceValuesOfCrambin) {
  const support::BallList balls =
      with_radii(support::read_atoms(support::own_molecule("crambin.pdb")), support::Radii::van_der_waals);
  struct {
    double probe;
    BoxVectors box;
    double area, volume, contact_area;
    uint32_t vertices, arcs, circles, faces, contacts;
    int64_t euler;
    uint32_t rank;
    std::array<std::array<int32_t, 3>, 3> rows;
  } const references[] = {
      {0.0,
       {40.96, 0, 0, 0, 18.65, 0, 0, 0, 22.52},
       4236.4055729381,
       3570.8694220603,
       2336.660805353,
       900,
       1350,
       34,
       444,
       1009,
       -76,
       2,
       {{{0, 1, 0}, {0, 0, 1}}}},
      {1.4,
       {40.96, 0, 0, 0, 18.65, 0, 0, 0, 22.52},
       2040.4173479224,
       7760.0414526713,
       6784.6526682721,
       486,
       729,
       0,
       242,
       2124,
       -2,
       2,
       {{{0, 1, 0}, {0, 0, 1}}}},
      {1.4,
       {25, 0, 0, 7, 18, 0, -9, 5, 20},
       1547.1613633888,
       7051.4068173166,
       6570.1401390642,
       442,
       663,
       0,
       220,
       2226,
       -2,
       3,
       {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
      {1.4,
       {30, 0, 0, 0, 30, 0, 0, 0, 30},
       2955.6038928619,
       8354.6306000178,
       6617.3802848779,
       482,
       723,
       0,
       244,
       1993,
       2,
       1,
       {{{1, 0, 0}}}},
  };
  for (const auto &reference : references) {
    const BuiltPeriodic built(balls, reference.box, reference.probe, 0.0);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    expect_laws(built);
    const hsp::PeriodicTotals totals = built.totals();
    EXPECT_NEAR(totals.area, reference.area, 1e-9);
    EXPECT_NEAR(totals.volume, reference.volume, 1e-9);
    EXPECT_NEAR(totals.contact_area, reference.contact_area, 1e-9);
    const hsp::PeriodicCounts &counts = built->counts();
    EXPECT_EQ(counts.vertices, reference.vertices);
    EXPECT_EQ(counts.arcs, reference.arcs);
    EXPECT_EQ(counts.circles, reference.circles);
    EXPECT_EQ(counts.faces, reference.faces);
    EXPECT_EQ(counts.contacts, reference.contacts);
    EXPECT_EQ(counts.euler(), reference.euler);
    EXPECT_EQ(counts.components, 1U);
    const hsp::WindingLattice &lattice = built->windings().lattice(0);
    EXPECT_EQ(lattice.rank, reference.rank);
    EXPECT_EQ(lattice.copies(), 1U);
    for (uint32_t row = 0; row < lattice.rank; ++row) {
      for (size_t k = 0; k < 3; ++k) EXPECT_EQ(lattice.row[row][k], reference.rows[row][k]);
    }
  }
}

TEST(PeriodicUnion, HasTheMeanCurvatureOfCrambin) {
  const support::BallList balls =
      with_radii(support::read_atoms(support::own_molecule("crambin.pdb")), support::Radii::van_der_waals);
  const BuiltPeriodic built(balls, {25, 0, 0, 7, 18, 0, -9, 5, 20}, 1.4, 0.0);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const hsp::CurvatureTotals found = hsp::sum_curvatures(built->grid(), built->boundary(), built->images().lattice(),
                                                         [](uint32_t, const hsp::BallCurvature &) {});
  EXPECT_NEAR(found.mean, -94.510929797134, 1e-9);
  EXPECT_NEAR(found.gauss, 2 * hsp::pi * static_cast<double>(built->counts().euler()), 1e-9);
}

// Crystals in which everything ties: touching spheres, holes, nothing left free.
TEST(PeriodicUnion, DecidesTiesOfCrystalsAlikeInAllCopies) {
  const auto euler_of = [](const std::vector<std::array<double, 4>> &balls, double side) {
    const BuiltPeriodic built(balls_of(balls), cube(side));
    EXPECT_EQ(built.status(), hsp::Status::ok);
    return built->counts().euler();
  };
  EXPECT_EQ(euler_of({{0, 0, 0, 2}}, 4), -4);                // simple cubic, touching: three handles
  EXPECT_EQ(euler_of({{0, 0, 0, 2}, {0, 0, 0, 2}}, 4), -4);  // every ball twice
  EXPECT_EQ(euler_of({{0, 0, 0, 3}}, 4), 2);                 // with a hole in the middle of the cube
  const BuiltPeriodic filled(balls_of({{0, 0, 0, 4}}), cube(4));
  ASSERT_EQ(filled.status(), hsp::Status::ok);
  EXPECT_EQ(filled->counts().faces, 0U);
  EXPECT_EQ(filled.totals().area, 0.0);
  EXPECT_EQ(filled.totals().volume, 64.0);
  EXPECT_EQ(filled.totals().free_volume, 0.0);
  EXPECT_NEAR(filled.of_ball(0).volume, 64.0, 1e-11);  // its cell is the box
}

// A cage of eight balls: each circle of two neighbours has an arc outside and one in the void, also where a wall of the
// box runs between them.
TEST(PeriodicUnion, KeepsShellsApartThatShareCirclesAcrossWalls) {
  for (const std::array<double, 3> &middle :
       {std::array<double, 3>{10, 10, 10}, {0, 10, 10}, {10, 0, 0}, {0, 0, 0}, {0.5, 19.5, 0}}) {
    std::vector<std::array<double, 4>> cage;
    for (int k = 0; k < 8; ++k) {
      cage.push_back({middle[0] + k % 2 * 2.0 - 1, middle[1] + k / 2 % 2 * 2.0 - 1, middle[2] + k / 4 * 2.0 - 1, 1.5});
    }
    const BuiltPeriodic built(balls_of(cage), cube(20), 0.0, 0.5);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    EXPECT_EQ(built->counts().shells, 2U);
    EXPECT_EQ(built->counts().faces, 16U);
  }
}

// Each contact is listed at one of its two balls, also if both are copies of one ball.
TEST(PeriodicUnion, ListsEachContactOnce) {
  oracle::RandomSource random(325);
  uint32_t of_one_ball = 0;
  for (int set = 0; set < 20; ++set) {
    const RandomCrystal crystal(random, set % 2 == 0);
    const BuiltPeriodic built(crystal.balls, crystal.box);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    uint32_t listed = 0;
    for (uint32_t i = 0; i < built.balls(); ++i) {
      built->visit_contacts_of(i, [&](const hsp::PeriodicContact &contact) {
        if (!built->is_listed(contact)) return;
        ++listed;
        of_one_ball += built->images().ball_of(contact.other) == i ? 1U : 0U;
      });
    }
    EXPECT_EQ(listed, built->counts().contacts);
  }
  EXPECT_GT(of_one_ball, 10U);
}

// Components of balls that only touch, of one inside another one, and of one that is covered by others but inside none
// of them: it has no cell and no contact.
TEST(PeriodicUnion, JoinsBallsWithoutCells) {
  const auto components = [](const std::vector<std::array<double, 4>> &balls, const BoxVectors &box) {
    const BuiltPeriodic built(balls_of(balls), box);
    EXPECT_EQ(built.status(), hsp::Status::ok);
    return built->counts().components;
  };
  EXPECT_EQ(components({{0, 0, 0, 2}, {4, 0, 0, 2}, {0, 9, 0, 2}}, cube(20)), 2U);
  EXPECT_EQ(components({{0, 0, 0, 5}, {39, 1, 1, 2}, {20, 20, 20, 1}}, cube(40)), 2U);
  std::vector<std::array<double, 4>> covered{{0, 0, 0, 5}};
  for (int k = 0; k < 8; ++k) covered.push_back({k % 2 * 20.0 - 10, k / 2 % 2 * 20.0 - 10, k / 4 * 20.0 - 10, 20});
  const BuiltPeriodic built(balls_of(covered), cube(200));
  ASSERT_EQ(built.status(), hsp::Status::ok);
  EXPECT_FALSE(built->boundary().is_contained(built->grid().grid_index(0)));
  EXPECT_EQ(built.of_ball(0).volume, 0.0);
  EXPECT_EQ(built->counts().components, 1U);
}

// Against sums over contacts that are looked at one by one.
TEST(PeriodicUnion, SumsContactsBetweenGroups) {
  oracle::RandomSource random(324);
  size_t pairs = 0;
  for (int set = 0; set < 12; ++set) {
    const RandomCrystal crystal(random, set % 2 == 0);
    BuiltPeriodic built(crystal.balls, crystal.box);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    std::vector<uint32_t> group(built.balls());
    for (uint32_t &g : group) {
      g = 5 * random.below(4);
      if (g == 15) g = hsp::no_id;
    }
    std::map<std::array<uint32_t, 2>, std::array<double, 3>> expected;
    for (uint32_t i = 0; i < built.balls(); ++i) {
      built->visit_contacts_of(i, [&](const hsp::PeriodicContact &contact) {
        if (!built->is_listed(contact)) return;
        const uint32_t a = group[i];
        const uint32_t b = group[built->images().ball_of(contact.other)];
        if (a == b || a == hsp::no_id || b == hsp::no_id) return;
        std::array<double, 3> &sum = expected[{a < b ? a : b, a < b ? b : a}];
        sum[0] += 1.0;
        sum[1] += contact.record->area;
        sum[2] += contact.record->rim;
      });
    }
    pairs += expected.size();
    auto next = expected.begin();
    built.group_contacts(group.data()).visit([&](const hsp::GroupContact &found) {
      ASSERT_NE(next, expected.end());
      EXPECT_EQ(found.group[0], next->first[0]);
      EXPECT_EQ(found.group[1], next->first[1]);
      EXPECT_EQ(found.contacts, next->second[0]);
      EXPECT_NEAR(found.area, next->second[1], 1e-12 * (1.0 + next->second[1]));
      EXPECT_NEAR(found.rim, next->second[2], 1e-12 * (1.0 + next->second[2]));
      ++next;
    });
    EXPECT_EQ(next, expected.end());
  }
  EXPECT_GT(pairs, 5U);
}

// Of points alone the step is by the largest length, that of a vector here.
TEST(PeriodicUnion, OfPointsThatAreNearInTheirBox) {
  const BuiltPeriodic built(balls_of({{0, 0, 0, 0}, {1e-11, 0, 0, 0}}), cube(1e-3), 0.0, 0.0);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  EXPECT_EQ(built->counts().components, 2U);
}

TEST(PeriodicUnion, IsEmptyOrRefused) {
  const BuiltPeriodic none({}, cube(4));
  ASSERT_EQ(none.status(), hsp::Status::ok);
  EXPECT_EQ(none.totals().free_volume, 64.0);
  EXPECT_EQ(none->counts().components, 0U);
  EXPECT_EQ(BuiltPeriodic(balls_of({{0, 0, 0, 300}}), cube(4)).status(), hsp::Status::range);
  EXPECT_EQ(BuiltPeriodic(balls_of({{0, 0, 0, 1}}), {4, 1, 0, 4, 1, 0, 0, 0, 4}).status(), hsp::Status::range);
  const BuiltPeriodic far(balls_of({{0, 0, 0, 1}, {0, 0x1p40, 0, 1}}), cube(4));
  EXPECT_EQ(far.status(), hsp::Status::range);
  EXPECT_EQ(far.first_bad(), 1U);
  const BuiltPeriodic negative(balls_of({{0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, -1}}), cube(4));
  EXPECT_EQ(negative.status(), hsp::Status::negative);
  EXPECT_EQ(negative.first_bad(), 2U);
}

}  // namespace
