// Contacts, cells and the dual complex against brute force, sampling, and the reference values that were computed with
// 113 bits by another program.
#include "contacts/contacts_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "built_contacts.hpp"
#include "contacts/contacts_check.hpp"
#include "lattice_lengths.hpp"
#include "molecule_file.hpp"
#include "power_cells.hpp"
#include "random_balls.hpp"
#include "set_arrangements.hpp"
#include "stopped_at.hpp"

namespace {

constexpr uint32_t all_simplices = 100000;

template <size_t n>
std::array<uint32_t, n> in_input_order(const BuiltContacts &built, const uint32_t (&balls)[n]) {
  std::array<uint32_t, n> result{};
  for (size_t k = 0; k < n; ++k) result[k] = built.balls().caller[balls[k]];
  std::sort(result.begin(), result.end());
  return result;
}

oracle::DualSimplices simplices_of(const BuiltContacts &built) {
  const hsp::Contacts &contacts = built.contacts();
  oracle::DualSimplices result;
  for (uint32_t i = 0; i < contacts.ball_count(); ++i) {
    if (built.boundary().is_exposed(i) || !contacts.row(i).empty()) result.balls.insert(built.balls().caller[i]);
  }
  for (uint32_t id = 0; id < contacts.contact_count(); ++id) {
    result.edges.insert(in_input_order(built, contacts.contact(id).ball));
  }
  for (const hsp::TriangleRecord &triangle : contacts.triangles()) {
    result.triangles.insert(in_input_order(built, triangle.ball));
  }
  for (const hsp::TetrahedronRecord &tetrahedron : contacts.tetrahedra()) {
    result.tetrahedra.insert(in_input_order(built, tetrahedron.ball));
  }
  return result;
}

void expect_simplices(const oracle::Balls &balls) {
  const BuiltContacts built(oracle::in_lengths(balls, 1), 0.0, 1.0, all_simplices);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const oracle::DualSimplices expected = oracle::dual_simplices(balls);
  const oracle::DualSimplices found = simplices_of(built);
  EXPECT_EQ(found.balls, expected.balls) << oracle::to_text(balls);
  EXPECT_EQ(found.edges, expected.edges) << oracle::to_text(balls);
  EXPECT_EQ(found.triangles, expected.triangles) << oracle::to_text(balls);
  EXPECT_EQ(found.tetrahedra, expected.tetrahedra) << oracle::to_text(balls);
  const hsp::SimplexCounts &counts = built.contacts().simplices();
  EXPECT_EQ(counts.dimension(0), found.balls.size());
  EXPECT_EQ(counts.dimension(1), built.contacts().contact_count());
  EXPECT_EQ(counts.dimension(1), found.edges.size());
  EXPECT_EQ(counts.dimension(2), found.triangles.size());
  EXPECT_EQ(counts.dimension(3), built.contacts().tetrahedra().size());
  EXPECT_EQ(counts.dimension(3), found.tetrahedra.size());
  // Every vertex of the boundary is an end of a chord, every free circle a singular edge.
  EXPECT_EQ(counts.of[2][1] + 2 * counts.of[2][0], built.boundary().vertex_count());
  EXPECT_EQ(counts.of[1][0], built.boundary().circle_count());
  const hsp::ContactViolation violation = hsp::check_contacts(built.balls(), built.boundary(), built.contacts());
  EXPECT_EQ(violation.invariant, hsp::ContactInvariant::none) << oracle::to_text(balls) << " at " << violation.id;
}

TEST(Contacts, HaveTheDualComplexOfBruteForce) {
  oracle::RandomSource random(71);
  for (int k = 0; k < 120 && !HasFailure(); ++k) {
    const size_t n = static_cast<size_t>(random.in(1, 9));
    expect_simplices(oracle::any_balls(random, n));
  }
}

TEST(Contacts, HaveTheDualComplexOfBruteForceWithTies) {
  oracle::RandomSource random(72);
  for (int k = 0; k < 180 && !HasFailure(); ++k) {
    const size_t n = static_cast<size_t>(random.in(2, 9));
    expect_simplices(k % 3 == 0   ? oracle::lattice_balls(random, n)
                     : k % 3 == 1 ? oracle::grid_balls(random, n)
                                  : oracle::degenerate_balls(random, n));
  }
}

TEST(Contacts, DecideTiesOfOneStepExactly) {
  oracle::RandomSource random(73);
  for (int k = 0; k < 1 && !HasFailure(); ++k) {
    const oracle::Balls balls = oracle::lattice_balls(random, 8);
    const oracle::Balls large = oracle::scaled(balls, 1000);
    for (const oracle::Balls &near : oracle::one_step_off(large)) expect_simplices(near);
  }
}

TEST(Contacts, HaveTheAreasAndVolumesOfSampling) {
  oracle::RandomSource random(74);
  uint32_t contacts = 0;
  for (int k = 0; k < 12; ++k) {
    const size_t n = static_cast<size_t>(random.in(2, 8));
    const oracle::Balls balls = k % 3 == 2 ? oracle::loose_balls(random, n) : oracle::dense_balls(random, n);
    const BuiltContacts built(oracle::in_lengths(balls, 1));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    for (uint32_t id = 0; id < built.contacts().contact_count(); ++id) {
      const hsp::ContactRecord &contact = built.contacts().contact(id);
      const uint32_t a = built.balls().caller[contact.ball[0]];
      const uint32_t b = built.balls().caller[contact.ball[1]];
      EXPECT_NEAR(contact.area, oracle::contact_area_by_slices(balls, a, b, 4000), 0.02) << oracle::to_text(balls);
      ++contacts;
    }
    const std::vector<double> cells = oracle::cell_volumes_by_points(balls, 40);
    for (uint32_t i = 0; i < balls.size(); ++i) {
      const double r = static_cast<double>(balls[i].radius);
      EXPECT_NEAR(built.cell(i), cells[i], 0.02 * r * r * r) << oracle::to_text(balls) << " ball " << i;
    }
  }
  EXPECT_GT(contacts, 100U);
}

TEST(Contacts, AreTheSameBitsForEveryOrderOfTheInput) {
  oracle::RandomSource random(75);
  for (int k = 0; k < 60; ++k) {
    const oracle::Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(2, 12)));
    const std::vector<uint32_t> order = random.permutation(balls.size());
    const BuiltContacts built(oracle::in_lengths(balls, 1));
    const BuiltContacts mixed(oracle::in_lengths(oracle::permuted(balls, order), 1));
    ASSERT_EQ(mixed.contacts().contact_count(), built.contacts().contact_count());
    for (uint32_t id = 0; id < built.contacts().contact_count(); ++id) {
      EXPECT_EQ(mixed.contacts().contact(id).area, built.contacts().contact(id).area);
      EXPECT_EQ(mixed.contacts().contact(id).rim, built.contacts().contact(id).rim);
    }
    for (uint32_t i = 0; i < balls.size(); ++i) {
      EXPECT_EQ(mixed.contacts().share_volume(i), built.contacts().share_volume(i));
      EXPECT_EQ(mixed.contacts().contact_area(i), built.contacts().contact_area(i));
      uint32_t before = 0;
      for (const uint32_t id : built.contacts().row(i)) {
        const uint32_t caller = built.balls().caller[built.contacts().contact(id).other(i)];
        EXPECT_LE(before, caller);
        before = caller;
      }
    }
  }
}

struct Reference {
  std::vector<std::array<double, 4>> balls;
  double area, volume;
  std::vector<double> cells;
  std::vector<std::array<double, 3>> pairs;  // of some contacts
  std::array<uint32_t, 4> simplices;
};

double within_15_digits(double value) {
  return 2e-14 * (1.0 + std::fabs(value));
}

TEST(Contacts, OfSmallSetsHaveTheReferenceValues) {
  const Reference references[] = {
      {{{0, 0, 0, 1}, {1, 0, 0, 1}},
       2.35619449019234,
       7.06858347057703,
       {3.53429173528852, 3.53429173528852},
       {{0, 1, 2.35619449019}},
       {2, 1, 0, 0}},
      {{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}},
       4.77191899778192,
       9.83075054182875,
       {2.94257710760145, 3.44408671711365, 3.44408671711365},
       {{0, 1, 1.99326041719}, {0, 2, 1.99326041719}, {1, 2, 0.785398163397}},
       {3, 3, 1, 0}},
      {{{0, 0, 0, 1}, {1, 0, 0, 1}, {0.3, 0.9, 0, 1}, {0.2, 0.4, 0.8, 1.1}},
       7.92263821715679,
       12.0518439808927,
       {2.40163561094021, 3.02097080459906, 2.62450285143537, 4.004734713918},
       {{0, 1, 1.29712472104},
        {0, 2, 1.11139153272},
        {0, 3, 1.63741130143},
        {1, 2, 0.999606692974},
        {1, 3, 1.17419466727},
        {2, 3, 1.70290930173}},
       {4, 6, 4, 1}},
      {{{0, 0, 0, 1}, {0, 0, 0, 1}, {0.25, 0, 0, 0.75}, {1, 0, 0, 1}, {3, 0, 0, 1}},
       2.35619449019234,
       11.2573736753634,
       {3.53429173528852, 0, 0, 3.53429173528852, 4.18879020478639},
       {{0, 3, 2.35619449019}, {3, 4, 0}},
       {3, 2, 0, 0}},
  };
  for (const Reference &reference : references) {
    support::BallList balls;
    for (const auto &[x, y, z, r] : reference.balls) balls.add(x, y, z, r);
    const BuiltContacts built(balls, 0.0, 0.01);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    EXPECT_NEAR(built.total_area(), reference.area, within_15_digits(reference.area));
    double volume = 0.0;
    for (uint32_t i = 0; i < balls.size(); ++i) {
      EXPECT_NEAR(built.cell(i), reference.cells[i], within_15_digits(reference.cells[i]));
      volume += built.cell(i);
    }
    EXPECT_NEAR(volume, reference.volume, within_15_digits(reference.volume));
    for (const auto &[a, b, area] : reference.pairs) {
      EXPECT_NEAR(built.area(static_cast<uint32_t>(a), static_cast<uint32_t>(b)), area, 1e-11);
    }
    for (uint32_t d = 0; d < 4; ++d) {
      EXPECT_EQ(built.contacts().simplices().dimension(d), reference.simplices[d]);
    }
  }
}

TEST(Contacts, OfTiedSetsHaveTheReferenceValues) {
  support::BallList cube, centred;
  for (int k = 0; k < 8; ++k) {
    const double x = k & 1, y = (k >> 1) & 1, z = (k >> 2) & 1;
    cube.add(x, y, z, 0.9);
    centred.add(2 * x - 1, 2 * y - 1, 2 * z - 1, 1.5);
  }
  centred.add(0, 0, 0, 1);
  const BuiltContacts corners(cube, 0.0, 0.01);
  EXPECT_NEAR(corners.total_area(), 16.5357175756574, 2e-13);
  EXPECT_NEAR(corners.area(0, 1), 1.37797646464, 1e-11);
  for (uint32_t i = 0; i < 8; ++i) EXPECT_NEAR(corners.cell(i), 1.96220103754239, 2e-14);
  for (uint32_t d = 0; d < 4; ++d) {
    EXPECT_EQ(corners.contacts().simplices().dimension(d), (std::array<uint32_t, 4>{8, 19, 18, 6})[d]);
  }
  const BuiltContacts buried(centred, 0.0, 0.01);
  EXPECT_NEAR(buried.total_area(), 47.0988588160528, 5e-13);
  EXPECT_NEAR(buried.area(0, 1), 3.48287110149, 1e-11);
  EXPECT_NEAR(buried.area(0, 8), 0.663050699772, 1e-11);
  EXPECT_NEAR(buried.cell(0), 10.9080154279068, 1e-13);
  EXPECT_NEAR(buried.cell(8), 343.0 / 384, 1e-15);
  for (uint32_t d = 0; d < 4; ++d) {
    EXPECT_EQ(buried.contacts().simplices().dimension(d), (std::array<uint32_t, 4>{9, 26, 30, 12})[d]);
  }
}

TEST(Contacts, OfCrambinHaveTheReferenceValues) {
  const support::BallList balls =
      with_radii(support::read_atoms(support::own_molecule("crambin.pdb")), support::Radii::van_der_waals);
  struct Values {
    double probe, area, squares, cell[3], contact, edge;
    std::array<uint32_t, 4> simplices;
  };
  const Values values[] = {{0.0,
                            2331.41786533733,
                            12286.8850203103,
                            {11.8061012284103, 10.3810757100390, 10.1381382557968},
                            5.56789795516737,
                            4.39697004997624,
                            {327, 1004, 837, 194}},
                           {1.4,
                            6610.26605369680,
                            46452.9735578287,
                            {38.7090615491387, 22.2090512581415, 24.5816947510877},
                            11.8686313897322,
                            3.79439855815722,
                            {327, 1991, 3092, 1426}}};
  for (const Values &expected : values) {
    const BuiltContacts built(balls, expected.probe, 0.0);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    EXPECT_NEAR(built.total_area(), expected.area, 1e-10);
    const hsp::exact::Lattice &lattice = built.balls().lattice;
    double squares = 0.0;
    for (uint32_t id = 0; id < built.contacts().contact_count(); ++id) {
      const double area = lattice.area(built.contacts().contact(id).area);
      squares += area * area;
    }
    EXPECT_NEAR(squares, expected.squares, 1e-9);
    constexpr uint32_t chosen[] = {0, 100, 326};
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(built.cell(chosen[k]), expected.cell[k], 1e-12);
    EXPECT_NEAR(built.area(0, 1), expected.contact, 2e-14 * expected.contact);
    EXPECT_NEAR(lattice.length(built.between(0, 1)->rim), expected.edge, 1e-13);
    for (uint32_t d = 0; d < 4; ++d) {
      EXPECT_EQ(built.contacts().simplices().dimension(d), expected.simplices[d]);
    }
    EXPECT_EQ(hsp::check_contacts(built.balls(), built.boundary(), built.contacts()).invariant,
              hsp::ContactInvariant::none);
  }
}

// Balls with so many contacts that these are looked for in trees: every one is there once, with all of its area.
TEST(Contacts, OfStuddedBallsAreThereOnce) {
  oracle::RandomSource random(93);
  for (const auto &[least, largest] : {std::pair{1000, 9000}, std::pair{8000, 9000}, std::pair{8000, 30000}}) {
    oracle::Balls balls;
    // Half of the studs come before their ball, and half of them behind it.
    for (const oracle::LatticePoint &centre : {oracle::LatticePoint{-9, -9, 9}, {9, 149000, -9}}) {
      const oracle::Balls studded = oracle::studded_ball(random, 600, centre, 100000, least, largest);
      balls.insert(balls.end(), studded.begin(), studded.end());
    }
    const BuiltContacts built(oracle::in_lengths(balls, 1), all_simplices);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    std::set<std::pair<uint32_t, uint32_t>> pairs;
    for (uint32_t id = 0; id < built.contacts().contact_count(); ++id) {
      const auto [a, b] = built.contacts().contact(id).ball;
      EXPECT_TRUE(pairs.insert({a, b}).second);
    }
    const hsp::ContactViolation violation = hsp::check_contacts(built.balls(), built.boundary(), built.contacts());
    EXPECT_EQ(violation.invariant, hsp::ContactInvariant::none) << "ball " << violation.id;
  }
}

// Nearly eight spheres through every middle of a grid's cubes: what doubles alone would decide otherwise.
TEST(Contacts, OfNearlyTiedSetsCloseTheirCells) {
  oracle::RandomSource random(76);
  for (const int64_t jitter : {1, 10, 10000}) {
    oracle::Balls balls;
    for (int64_t k = 0; k < 64; ++k) {
      const int64_t x = k % 4 * 100000000 + random.in(-jitter, jitter);
      const int64_t y = k / 4 % 4 * 100000000 + random.in(-jitter, jitter);
      const int64_t z = k / 16 * 100000000 + random.in(-jitter, jitter);
      balls.push_back({x, y, z, 95000000 + random.in(-jitter, jitter)});
    }
    const BuiltContacts built(oracle::in_lengths(balls, 1));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const hsp::ContactViolation violation = hsp::check_contacts(built.balls(), built.boundary(), built.contacts());
    EXPECT_EQ(violation.invariant, hsp::ContactInvariant::none) << "ball " << violation.id;
    // A contact within a face of the grid is that of the tied grid but for what was moved.
    const double across = built.area(21, 22);
    EXPECT_NEAR(across, 1e16, 10.0 * 1e8 * static_cast<double>(jitter));
  }
}

TEST(Contacts, FlagWhatTouchesAndWhatIsWhole) {
  support::BallList balls;
  balls.add(0, 0, 0, 5);
  balls.add(8, 0, 0, 5);   // a whole circle
  balls.add(18, 0, 0, 5);  // touches the second
  balls.add(0, 0, 0, 3);   // inside the first
  balls.add(0, 40, 0, 5);  // alone
  const BuiltContacts built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  ASSERT_NE(built.between(0, 1), nullptr);
  EXPECT_TRUE(built.between(0, 1)->is_circle());
  EXPECT_FALSE(built.between(0, 1)->is_touching());
  EXPECT_NEAR(built.between(0, 1)->area, 9 * hsp::pi, 1e-13);
  EXPECT_NEAR(built.between(0, 1)->rim, 6 * hsp::pi, 1e-13);
  ASSERT_NE(built.between(1, 2), nullptr);
  EXPECT_TRUE(built.between(1, 2)->is_touching());
  EXPECT_EQ(built.between(1, 2)->area, 0.0);
  EXPECT_EQ(built.between(1, 2)->rim, 0.0);
  EXPECT_EQ(built.between(0, 3), nullptr);
  EXPECT_EQ(built.cell(3), 0.0);
  EXPECT_NEAR(built.cell(4), 500 * hsp::pi / 3, 1e-12);
  const hsp::SimplexCounts &counts = built.contacts().simplices();
  EXPECT_EQ(counts.of[0][static_cast<uint32_t>(hsp::SimplexKind::singular)], 1U);
  EXPECT_EQ(counts.of[0][static_cast<uint32_t>(hsp::SimplexKind::regular)], 3U);
  EXPECT_EQ(counts.of[1][static_cast<uint32_t>(hsp::SimplexKind::singular)], 2U);
}

TEST(Contacts, OfNoBallsAndOfPoints) {
  EXPECT_EQ(BuiltContacts(support::BallList{}).contacts().contact_count(), 0U);
  support::BallList points;
  for (int k = 0; k < 4; ++k) points.add(k / 2, 0, 0, 0);
  const BuiltContacts built(points);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  EXPECT_EQ(built.contacts().contact_count(), 0U);
  EXPECT_EQ(built.contacts().simplices().dimension(0), 2U);
  for (uint32_t i = 0; i < 4; ++i) EXPECT_EQ(built.cell(i), 0.0);
}

hsp::Status status_with(const BuiltContacts &built, const hsp::ContactLimits &limits, hsp::ContactLimits &retry) {
  CarvedMemory memory;
  hsp::ContactsBuilder builder;
  memory.carve(builder, limits);
  const hsp::Status status = builder.build(built.grid(), built.boundary(), built.neighbours());
  retry = builder.retry_limits();
  return status;
}

TEST(Contacts, ReportLimitsThatSuffice) {
  oracle::RandomSource random(77);
  const support::BallList balls = oracle::in_lengths(oracle::dense_balls(random, 14), 1);
  BuiltContacts built(balls, 0.0, 1.0, all_simplices);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const hsp::ContactLimits exact{built.contacts().ball_count(), built.neighbours(), built.contacts().contact_count(),
                                 built.contacts().triangles().size(), built.contacts().tetrahedra().size()};
  ASSERT_GT(exact.tetrahedra, 1U);
  hsp::ContactLimits retry;
  EXPECT_EQ(status_with(built, exact, retry), hsp::Status::ok);
  EXPECT_EQ(status_with(built, {exact.balls, exact.neighbours, exact.contacts, 0, 0}, retry), hsp::Status::ok);
  for (uint32_t hsp::ContactLimits::*limit :
       {&hsp::ContactLimits::balls, &hsp::ContactLimits::neighbours, &hsp::ContactLimits::contacts,
        &hsp::ContactLimits::triangles, &hsp::ContactLimits::tetrahedra}) {
    for (const uint32_t less : {1U, exact.*limit - 1U}) {
      hsp::ContactLimits limits = exact;
      limits.*limit -= less;
      if (limits.*limit == 0 && limit != &hsp::ContactLimits::balls) limits.*limit = 1;
      uint32_t tries = 0;
      while (status_with(built, limits, retry) == hsp::Status::capacity) {
        ASSERT_LT(++tries, 4U);
        ASSERT_GT(retry.*limit, limits.*limit);
        limits = retry;
      }
      EXPECT_GT(tries, 0U);
    }
  }
}

// Where there is no room, chords of balls with more than 64 caps are not looked for: what they may have suffices, too.
TEST(Contacts, ReportLimitsThatSufficeForManyCaps) {
  oracle::RandomSource random(78);
  const oracle::Balls balls = oracle::studded_ball(random, 200, {0, 0, 0}, 100000, 40000, 45000);
  BuiltContacts built(oracle::in_lengths(balls, 1), 0.0, 1.0, all_simplices);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const uint32_t contacts = built.contacts().contact_count(), triangles = built.contacts().triangles().size(),
                 tetrahedra = built.contacts().tetrahedra().size();
  ASSERT_GT(tetrahedra, 100U);
  uint32_t with_more = 0;
  for (const uint32_t room : {1U, tetrahedra / 4, tetrahedra / 2}) {
    hsp::ContactLimits limits{built.contacts().ball_count(), built.neighbours(), room, 1, 1}, retry;
    ASSERT_EQ(status_with(built, limits, retry), hsp::Status::capacity);
    EXPECT_GE(retry.contacts, contacts);
    with_more += retry.contacts > contacts ? 1 : 0;
    ASSERT_EQ(status_with(built, retry, limits), hsp::Status::ok);
    EXPECT_GE(retry.triangles, triangles);
    EXPECT_GE(retry.tetrahedra, tetrahedra);
  }
  EXPECT_GT(with_more, 0U);
}

// All that is found over a grid: pairs, area and volume by their last bits.
std::vector<std::pair<std::array<uint32_t, 2>, double>> contacts_over(const hsp::CubeGrid &grid) {
  const uint32_t n = grid.balls().n;
  CarvedMemory boundary_memory, contacts_memory;
  hsp::BoundaryBuilder boundary;
  hsp::ContactsBuilder builder;
  EXPECT_EQ(boundary_memory.build(boundary, hsp::BoundaryLimits{n, 8, 8, 8, 0}, grid), hsp::Status::ok);
  const uint32_t neighbours = boundary.needed().neighbours;
  EXPECT_EQ(
      contacts_memory.build(builder, hsp::ContactLimits{n, neighbours, 4, 0, 0}, grid, boundary.boundary(), neighbours),
      hsp::Status::ok);
  const hsp::Contacts &contacts = builder.contacts();
  std::vector<std::pair<std::array<uint32_t, 2>, double>> found;
  for (uint32_t id = 0; id < contacts.contact_count(); ++id) {
    const hsp::ContactRecord &contact = contacts.contact(id);
    found.push_back({{contact.ball[0], contact.ball[1]}, contact.area});
  }
  for (uint32_t i = 0; i < n; ++i) found.push_back({{i, i}, contacts.share_volume(i)});
  return found;
}

// Small ones in wide cubes are found by levels of radii.
TEST(Contacts, FewLargeBallsChangeNothing) {
  oracle::RandomSource random(35);
  oracle::Balls balls = oracle::balls_in_box(random, 1700, 26000, 300, 1800);
  for (int k = 0; k < 3; ++k) balls.push_back(oracle::ball_in_box(random, 20000, 15000, 20000));
  BuiltGrid built(oracle::in_lengths(balls, 1));
  ASSERT_NE(built.grid().levels(), nullptr);
  const auto by_levels = contacts_over(built.grid());
  built.grid().use_no_levels();
  EXPECT_EQ(by_levels, contacts_over(built.grid()));
  EXPECT_GT(by_levels.size(), balls.size() + 300);
}

// Behind the last ball of a block there is none, however many the levels find.
TEST(Contacts, TheLastBallHasNoLaterNeighbours) {
  oracle::RandomSource random(36);
  oracle::Balls balls = oracle::balls_in_box(random, 1700, 26000, 300, 1800);
  for (int k = 0; k < 3; ++k) balls.push_back(oracle::ball_in_box(random, 20000, 15000, 20000));
  BuiltGrid built(oracle::in_lengths(balls, 1));
  const hsp::BallSet &set = built.grid().balls();
  ASSERT_NE(built.grid().levels(), nullptr);
  CarvedMemory memory;
  hsp::Caps caps;
  memory.carve(caps, set.n);
  // The last one that meets any.
  uint32_t last = set.n;
  hsp::CubeBlock block;
  do {
    --last;
    block = built.grid().block_around(built.grid().cube_at(set.ball(last).centre));
    caps.gather(set, block, last, nullptr);
  } while (caps.met == 0);
  block.range[0] = {last, set.n};
  block.ranges = 1;
  caps.gather(set, block, last, nullptr);
  EXPECT_EQ(caps.met, 0U);
}

TEST(ContactsBuilder, StopsAtTheLastQuestions) {
  BuiltContacts built(oracle::in_lengths(long_row(6500), 1));
  ASSERT_EQ(built.status(), hsp::Status::ok);
  expect_stops_at_questions(10, 20, [&](const hsp::Executor &executor) {
    return built.builder().build(built.grid(), built.boundary(), built.neighbours(), hsp::Patience(&executor));
  });
  EXPECT_EQ(built.contacts().contact_count(), built.balls().n - 1);
}

}  // namespace
