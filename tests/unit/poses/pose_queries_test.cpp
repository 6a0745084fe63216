#include "poses/pose_queries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "point_lattices.hpp"
#include "random_poses.hpp"
#include "rational_images.hpp"

namespace {

using oracle::Balls;
using oracle::Int128;
using oracle::LatticeBall;
using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;

// The balls where the pose puts them.
Balls moved(const Balls &balls, const hsp::Pose &pose) {
  Balls images;
  for (const LatticeBall &ball : balls) {
    const hsp::Vec3 p =
        pose.snapped({static_cast<double>(ball.x), static_cast<double>(ball.y), static_cast<double>(ball.z)});
    images.push_back({static_cast<int64_t>(p.x), static_cast<int64_t>(p.y), static_cast<int64_t>(p.z), ball.radius});
  }
  return images;
}

Int128 square_of_distance(const LatticeBall &a, const LatticeBall &b) {
  const oracle::Vector v = oracle::centre_difference(a, b);
  return oracle::dot(v, v);
}

struct BruteForce {
  BruteForce(const Balls &fixed, const Balls &moving) {
    for (uint32_t i = 0; i < fixed.size(); ++i)
      for (uint32_t j = 0; j < moving.size(); ++j) {
        const Int128 square = square_of_distance(fixed[i], moving[j]);
        const Int128 sum = Int128{fixed[i].radius} + moving[j].radius;
        if (square <= sum * sum) pairs.emplace_back(i, j);
        gap = std::min(gap, std::sqrt(static_cast<long double>(square)) - static_cast<long double>(sum));
      }
  }
  Pairs pairs;
  long double gap = INFINITY;
};

// Empty, or what is answered otherwise from any witness. The pair that comes back is one of the answer.
template <class AnyPose>
std::string witness_complaint(const hsp::SphereTree &fixed, const hsp::SphereTree &moving, const AnyPose &pose,
                              const hsp::PairGap &least) {
  hsp::PairRanks none;
  const bool hit = hsp::any_balls_meet(fixed, moving, pose, none);
  if (hit != (none.fixed != hsp::no_id)) return "witness of a hit";
  const uint32_t f = fixed.ball_count(), m = moving.ball_count();
  for (const hsp::PairRanks &start :
       {hsp::PairRanks{0, 0}, {f / 2, m / 2}, {f - 1, m - 1}, {f, 0}, {0, m}, {hsp::no_id, 0}, none}) {
    hsp::PairRanks witness = start;
    if (hsp::any_balls_meet(fixed, moving, pose, witness) != hit) return "hit from a witness";
    if (!hit && (witness.fixed != start.fixed || witness.moving != start.moving)) return "witness without a hit";
    witness = start;
    const hsp::PairGap found = hsp::least_gap(fixed, moving, pose, witness);
    if (found.gap != least.gap || found.fixed != least.fixed || found.moving != least.moving)
      return "gap from a witness";
    if (f > 0 && m > 0 && (fixed.caller(witness.fixed) != found.fixed || moving.caller(witness.moving) != found.moving))
      return "witness of the gap";
  }
  return "";
}

// Empty, or what the trees say otherwise than brute force.
std::string complaint_about(const BuiltTree &rest, const BuiltTree &other, const Balls &fixed, const Balls &moving,
                            const hsp::Pose &pose) {
  const Balls images = moved(moving, pose);
  const BruteForce brute(fixed, images);
  if (hsp::any_balls_meet(rest.tree(), other.tree(), pose) == brute.pairs.empty()) return "hit";
  std::vector<hsp::MeetingPair> room(brute.pairs.size() + 1);
  const uint64_t count =
      hsp::list_meeting_pairs(rest.tree(), other.tree(), pose, {room.data(), static_cast<uint32_t>(room.size())});
  Pairs pairs;
  for (uint64_t k = 0; k < count && k < room.size(); ++k) pairs.emplace_back(room[k].fixed, room[k].moving);
  if (pairs != brute.pairs) return "pairs";
  if (hsp::sum_overlaps(rest.tree(), other.tree(), pose).pairs != count) return "count";
  const hsp::PairGap least = hsp::least_gap(rest.tree(), other.tree(), pose);
  if (const std::string text = witness_complaint(rest.tree(), other.tree(), pose, least); !text.empty()) return text;
  if (fixed.empty() || moving.empty()) return least.fixed == hsp::no_id && std::isinf(least.gap) ? "" : "gap of none";
  if (std::fabs(least.gap - static_cast<double>(brute.gap)) > 1e-15 * std::fabs(least.gap) + 1e-6) return "gap";
  if (least.fixed >= fixed.size() || least.moving >= moving.size()) return "pair of the gap";
  const auto gap_of = [&](uint32_t i, uint32_t j) {
    return std::sqrt(static_cast<double>(square_of_distance(fixed[i], images[j]))) -
           static_cast<double>(fixed[i].radius + images[j].radius);
  };
  // Squares below 2^53 are exact, and their roots are rounded alike everywhere.
  const double distance = least.gap + static_cast<double>(fixed[least.fixed].radius + moving[least.moving].radius);
  const bool is_exact = distance < 0x1p26;
  const double error = is_exact ? 0 : 0x1p-50 * distance;
  if (std::fabs(gap_of(least.fixed, least.moving) - least.gap) > error) return "gap of its pair";
  for (uint32_t i = 0; i <= least.fixed; ++i)
    for (uint32_t j = 0; j < (i == least.fixed ? least.moving : moving.size()); ++j) {
      const double gap = gap_of(i, j);
      if (gap < least.gap - error || (is_exact && gap == least.gap)) return "an earlier pair";
    }
  return "";
}

// The same of the code for wide registers and of that for every processor; both find pairs in one order.
std::string complaint(const Balls &fixed, const Balls &moving, const hsp::Pose &pose) {
  BuiltTree rest(fixed);
  const BuiltTree other(moving);
  const auto order_of_pairs = [&] {
    hsp::PairRanks witness;
    hsp::any_balls_meet(rest.tree(), other.tree(), pose, witness);
    return std::tuple(witness.fixed, witness.moving, hsp::sum_overlaps(rest.tree(), other.tree(), pose).volume);
  };
  std::string text = complaint_about(rest, other, fixed, moving, pose);
  const auto order = order_of_pairs();
  if (!text.empty() || rest.tree().target() == hsp::Target::baseline) return text;
  rest.use(hsp::Target::baseline);
  if (order != order_of_pairs()) return "another order";
  text = complaint_about(rest, other, fixed, moving, pose);
  return text.empty() ? "" : "for every processor: " + text;
}

TEST(PoseQueries, AgreeWithBruteForce) {
  oracle::RandomSource random(6);
  for (int k = 0; k < 1500; ++k) {
    const Balls fixed = oracle::any_balls(random, static_cast<size_t>(random.in(1, 40)));
    const Balls moving = k % 5 == 0 ? fixed : oracle::any_balls(random, static_cast<size_t>(random.in(1, 40)));
    int64_t size = 1;
    for (const LatticeBall &ball : fixed) size = std::max({size, std::abs(ball.x), std::abs(ball.y), std::abs(ball.z)});
    const PoseNumbers numbers = random_pose(random, k % 7 == 0 ? 0 : 3 * size);
    ASSERT_EQ(complaint(fixed, moving, pose_of(numbers)), "") << oracle::to_text(fixed) << "\n"
                                                              << oracle::to_text(moving);
  }
}

// Of large coordinates floats keep a part only. Each ball touches one at rest, or misses it by a step.
TEST(PoseQueries, FindPairsThatJustTouch) {
  oracle::RandomSource random(12);
  for (int k = 0; k < 60; ++k) {
    const int64_t size = int64_t{1} << random.in(12, 36);
    const Balls moving = oracle::balls_in_box(random, static_cast<size_t>(random.in(1, 90)), size,
                                              std::min<int64_t>(size >> 4, 1 << 29), std::min<int64_t>(size, 1 << 29));
    const hsp::Pose pose = pose_of(random_pose(random, size));
    Balls fixed;
    for (LatticeBall ball : moved(moving, pose)) {
      const int64_t radius = std::min<int64_t>(random.in(1, size >> 3), 1 << 29);
      int64_t &coordinate = random.one_in(2) ? ball.x : ball.z;
      coordinate += (random.one_in(2) ? 1 : -1) * (ball.radius + radius + (random.one_in(3) ? 1 : 0));
      ball.radius = radius;
      fixed.push_back(ball);
    }
    ASSERT_EQ(complaint(fixed, moving, pose), "") << size;
  }
}

// Where all spheres touch in many points at once.
TEST(PoseQueries, AgreeOnLattices) {
  const Balls fixed = oracle::box_lattice({4, 4, 4}, {4, 4, 4}, 2);
  for (const int64_t radius : {1, 2, 3})
    for (int shift = -24; shift <= 24; ++shift) {
      const Balls moving = oracle::box_lattice({3, 4, 2}, {4, 4, 4}, radius);
      for (const std::array<double, 4> &q : {std::array<double, 4>{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 1, 1, 1}}) {
        const auto s = static_cast<double>(shift);
        ASSERT_EQ(complaint(fixed, moving, pose_of({q, {s, 0, 0}})), "") << shift;
        ASSERT_EQ(complaint(fixed, moving, pose_of({q, {s, 4, s}})), "") << shift;
      }
    }
}

TEST(PoseQueries, AgreeFarFromTheOrigin) {
  oracle::RandomSource random(7);
  for (int k = 0; k < 300; ++k) {
    Balls fixed = oracle::any_balls(random, 20), moving = oracle::any_balls(random, 20);
    const int64_t far = int64_t{1} << random.in(20, 49);
    for (LatticeBall &ball : fixed) ball.x += far;
    for (LatticeBall &ball : moving) ball.y -= far;
    // A turn by a right angle, and any other.
    for (const std::array<double, 4> &q : {std::array<double, 4>{1, 0, 0, 1}, {0.9, 0.1, -0.2, 0.3}})
      ASSERT_EQ(complaint(fixed, moving, pose_of({q, {0, 0, 0}})), "") << far;
  }
}

hsp::Status make_pose(const BuiltTree &other, const RationalNumbers &numbers, hsp::RationalPose &pose) {
  const double translation[3] = {static_cast<double>(numbers.shift[0]), static_cast<double>(numbers.shift[1]),
                                 static_cast<double>(numbers.shift[2])};
  return hsp::make_pose(other.tree(), numbers.quaternion.data(), translation, pose);
}

// Empty, or what the trees say otherwise than large integers of a rational pose.
std::string rational_complaint(const Balls &fixed, const Balls &moving, const RationalNumbers &numbers) {
  const BuiltTree rest(fixed), other(moving);
  hsp::RationalPose pose;
  if (make_pose(other, numbers, pose) != hsp::Status::ok) return "refused";
  Pairs expected;
  double gap = INFINITY, error = 0;
  for (uint32_t i = 0; i < fixed.size(); ++i)
    for (uint32_t j = 0; j < moving.size(); ++j) {
      if (exact_relation(fixed[i], moving[j], numbers) <= 0) expected.emplace_back(i, j);
      const auto point = [](const LatticeBall &ball) {
        return hsp::Vec3{static_cast<double>(ball.x), static_cast<double>(ball.y), static_cast<double>(ball.z)};
      };
      const double distance = pose.distance(point(fixed[i]), point(moving[j]));
      gap = std::min(gap, distance - static_cast<double>(fixed[i].radius + moving[j].radius));
      error = std::max(error, 0x1p-50 * distance);
    }
  std::vector<hsp::MeetingPair> room(expected.size() + 1);
  const uint64_t count =
      hsp::list_meeting_pairs(rest.tree(), other.tree(), pose, {room.data(), static_cast<uint32_t>(room.size())});
  Pairs pairs;
  for (uint64_t k = 0; k < count && k < room.size(); ++k) pairs.emplace_back(room[k].fixed, room[k].moving);
  if (pairs != expected) return "pairs";
  hsp::PairRanks witness;
  if (hsp::any_balls_meet(rest.tree(), other.tree(), pose, witness) == expected.empty()) return "hit";
  witness = {};
  const hsp::PairGap least = hsp::least_gap(rest.tree(), other.tree(), pose, witness);
  if (!(std::fabs(least.gap - gap) <= error)) return "gap";
  return witness_complaint(rest.tree(), other.tree(), pose, least);
}

TEST(PoseQueries, AgreeWithLargeIntegersInRationalPoses) {
  oracle::RandomSource random(11);
  for (int k = 0; k < 250; ++k) {
    const Balls fixed = oracle::any_balls(random, static_cast<size_t>(random.in(1, 16)));
    const Balls moving = k % 5 == 0 ? fixed : oracle::any_balls(random, static_cast<size_t>(random.in(1, 16)));
    int64_t size = 1;
    for (const LatticeBall &ball : fixed) size = std::max({size, std::abs(ball.x), std::abs(ball.y), std::abs(ball.z)});
    const RationalNumbers numbers = random_rational(random, k % 7 == 0 ? 0 : 2 * size);
    ASSERT_EQ(rational_complaint(fixed, moving, numbers), "") << oracle::to_text(fixed) << "\n"
                                                              << oracle::to_text(moving);
  }
}

// Turned by angles of 3, 4, 5 or right ones, lattices meet in many points; the same molecule lies in its own place.
TEST(PoseQueries, AgreeOnLatticesInRationalPoses) {
  const Balls fixed = oracle::box_lattice({2, 3, 3}, {10, 10, 10}, 5);
  for (const std::array<int32_t, 4> &q :
       {std::array<int32_t, 4>{7, 0, 0, 0}, {2, 0, 0, 1}, {1, 1, 1, 1}, {INT32_MAX, INT32_MAX, 0, 0}})
    for (const int64_t shift : {0, 5, 10, 15, 20, 30}) {
      EXPECT_EQ(rational_complaint(fixed, fixed, {q, {shift, 0, 0}}), "") << shift;
      EXPECT_EQ(rational_complaint(fixed, fixed, {q, {shift, -shift, 10}}), "") << shift;
    }
}

// A motion by small steps of all sizes, among them none. Free poses that need no walk leave what is known as it is: so
// many were answered without one.
TEST(PoseQueries, AgreeAlongMotionsWithinTheGap) {
  oracle::RandomSource random(13);
  const double margins[] = {0, 2, 100, 3000, INFINITY};
  int free = 0, without_walk = 0, hits = 0, ends = 0;
  for (int k = 0; k < 400; ++k) {
    const Balls fixed = oracle::any_balls(random, static_cast<size_t>(random.in(1, 12)));
    const Balls moving = oracle::any_balls(random, static_cast<size_t>(random.in(1, 12)));
    int64_t size = 1;
    for (const LatticeBall &ball : fixed) size = std::max({size, std::abs(ball.x), std::abs(ball.y), std::abs(ball.z)});
    BuiltTree rest(fixed);
    const BuiltTree other(moving);
    if (k % 2 == 1) rest.use(hsp::Target::baseline);
    PoseNumbers numbers = random_pose(random, 2 * size);
    hsp::GapBudget known(margins[k % 5]);
    bool was_free = false;
    for (int time = 0; time < 60; ++time) {
      const double angle = std::pow(10.0, static_cast<double>(random.in(-6, -1)));
      const int64_t shift = random.in(0, 1 + size / (time % 3 == 0 ? 5 : 200));
      for (double &component : numbers.quaternion) component += angle * (random.fraction() - 0.5);
      for (double &component : numbers.translation) component += static_cast<double>(random.in(-shift, shift));
      const hsp::Pose pose = pose_of(numbers);
      const double budget = known.budget;
      const bool hit = hsp::any_balls_meet(rest.tree(), other.tree(), pose, known);
      ASSERT_EQ(hit, !BruteForce(fixed, moved(moving, pose)).pairs.empty()) << k << ' ' << time;
      hits += hit ? 1 : 0;
      free += hit ? 0 : 1;
      without_walk += !hit && known.budget == budget && budget > 0 ? 1 : 0;
      ends += hit && was_free ? 1 : 0;
      was_free = !hit;
    }
  }
  EXPECT_GT(without_walk, free / 4);
  EXPECT_GT(hits, 2000);
  EXPECT_GT(ends, 50);
}

// Against walks without any knowledge, which the test above compares with large integers.
TEST(PoseQueries, AgreeAlongRationalMotionsWithinTheGap) {
  oracle::RandomSource random(14);
  int free = 0, without_walk = 0, ends = 0;
  for (int k = 0; k < 100; ++k) {
    const Balls fixed = oracle::any_balls(random, static_cast<size_t>(random.in(1, 8)));
    const Balls moving = oracle::any_balls(random, static_cast<size_t>(random.in(1, 8)));
    int64_t size = 1;
    for (const LatticeBall &ball : fixed) size = std::max({size, std::abs(ball.x), std::abs(ball.y), std::abs(ball.z)});
    const BuiltTree rest(fixed), other(moving);
    RationalNumbers numbers = random_rational(random, size);
    for (int32_t &component : numbers.quaternion) component /= 4;
    numbers.quaternion[0] |= 1;
    hsp::GapBudget known(k % 2 == 0 ? 100 : 1e5);
    bool was_free = false;
    for (int time = 0; time < 40; ++time) {
      const auto step = static_cast<int32_t>(random.in(-1 << 22, 1 << 22));
      numbers.quaternion[static_cast<size_t>(time) % 4] += step | 1;
      for (int64_t &component : numbers.shift) component += random.in(-1 - size / 20, 1 + size / 20);
      hsp::RationalPose pose;
      ASSERT_EQ(make_pose(other, numbers, pose), hsp::Status::ok);
      const double budget = known.budget;
      const bool hit = hsp::any_balls_meet(rest.tree(), other.tree(), pose, known);
      hsp::PairRanks none;
      ASSERT_EQ(hit, hsp::any_balls_meet(rest.tree(), other.tree(), pose, none)) << k << ' ' << time;
      free += hit ? 0 : 1;
      without_walk += !hit && known.budget == budget && budget > 0 ? 1 : 0;
      ends += hit && was_free ? 1 : 0;
      was_free = !hit;
    }
  }
  EXPECT_GT(without_walk, free / 8);
  EXPECT_GT(ends, 30);
}

// As far as the gap, and a step less far: straight ahead, and by a turn, whose way is longer than its chord.
TEST(PoseQueries, KnowWhereTheGapEnds) {
  const Balls fixed{{0, 0, 0, 1000}}, moving{{3000, 0, 0, 500}};
  const BuiltTree rest(fixed), other(moving);
  const auto at = [](double x) { return pose_of({{1, 0, 0, 0}, {x, 0, 0}}); };
  for (const double margin : {0.0, 1.0, 1400.0, 1600.0, 1e9}) {
    for (const double gap : {1.0, 2.0, 3.0, 10.0, 800.0}) {
      hsp::GapBudget known(margin);
      EXPECT_FALSE(hsp::any_balls_meet(rest.tree(), other.tree(), at(gap - 1500), known));
      EXPECT_FALSE(hsp::any_balls_meet(rest.tree(), other.tree(), at(-1499), known));
      EXPECT_TRUE(hsp::any_balls_meet(rest.tree(), other.tree(), at(-1500), known)) << margin << ' ' << gap;
      EXPECT_FALSE(hsp::any_balls_meet(rest.tree(), other.tree(), at(-4501), known));
      EXPECT_TRUE(hsp::any_balls_meet(rest.tree(), other.tree(), at(-4500), known)) << margin << ' ' << gap;
    }
    hsp::GapBudget known(margin);
    const BuiltTree above(Balls{{0, 3000, 0, 1000}});
    int hits = 0;
    for (int k = 0; k <= 900; ++k) {
      const hsp::Pose pose = pose_of({{std::cos(k / 1000.0), 0, 0, std::sin(k / 1000.0)}, {0, 0, 0}});
      const bool hit = hsp::any_balls_meet(above.tree(), other.tree(), pose, known);
      EXPECT_EQ(hit, hsp::any_balls_meet(above.tree(), other.tree(), pose)) << margin << ' ' << k;
      hits += hit ? 1 : 0;
    }
    EXPECT_GT(hits, 200);
  }
}

TEST(PoseQueries, KnowEmptyMolecules) {
  const Balls none, one{{0, 0, 0, 5}};
  for (const auto &[fixed, moving] : {std::pair{none, none}, {none, one}, {one, none}})
    EXPECT_EQ(complaint(fixed, moving, hsp::Pose()), "");
  const BuiltTree empty(none), ball(one);
  hsp::GapBudget known(10);
  EXPECT_FALSE(hsp::any_balls_meet(empty.tree(), ball.tree(), hsp::Pose(), known));
  EXPECT_FALSE(hsp::any_balls_meet(ball.tree(), empty.tree(), hsp::Pose(), known));
}

TEST(PoseQueries, CountPairsThatThereIsNoRoomFor) {
  const Balls balls(30, {0, 0, 0, 5});
  const BuiltTree one(balls), two(balls);
  std::vector<hsp::MeetingPair> room(10, {77, 77});
  EXPECT_EQ(hsp::list_meeting_pairs(one.tree(), two.tree(), hsp::Pose(), {room.data(), 9}), 900U);
  EXPECT_EQ(room[9].fixed, 77U);
  EXPECT_EQ(hsp::list_meeting_pairs(one.tree(), two.tree(), hsp::Pose(), {}), 900U);
}

// Lenses by slices across the line of the centres.
TEST(PoseQueries, SumTheVolumesOfOverlaps) {
  oracle::RandomSource random(8);
  for (int time = 0; time < 40; ++time) {
    const Balls fixed = oracle::balls_in_box(random, 4, 900, 100, 1500);
    const Balls moving = oracle::balls_in_box(random, 3, 900, 100, 1500);
    long double sum = 0;
    for (const LatticeBall &a : fixed)
      for (const LatticeBall &b : moving) {
        const long double d = std::sqrt(static_cast<long double>(square_of_distance(a, b)));
        const long double r = static_cast<long double>(a.radius), s = static_cast<long double>(b.radius);
        constexpr int slices = 20000;
        const long double from = std::max(-r, d - s), to = std::min(r, d + s), width = (to - from) / slices;
        for (int k = 0; k < slices && width > 0; ++k) {
          const long double t = from + (k + 0.5L) * width;
          sum += width * 3.14159265358979324L * std::min(r * r - t * t, s * s - (d - t) * (d - t));
        }
      }
    const BuiltTree rest(fixed), other(moving);
    EXPECT_NEAR(hsp::sum_overlaps(rest.tree(), other.tree(), hsp::Pose()).volume, static_cast<double>(sum),
                1e-7 * static_cast<double>(sum));
  }
  // One ball within the other, and two that touch.
  const BuiltTree large({{0, 0, 0, 10}}), small({{3, 0, 0, 2}}), beside({{12, 0, 0, 2}});
  EXPECT_NEAR(hsp::sum_overlaps(large.tree(), small.tree(), hsp::Pose()).volume, 33.510321638291124, 1e-13);
  const hsp::Overlap touching = hsp::sum_overlaps(large.tree(), beside.tree(), hsp::Pose());
  EXPECT_EQ(touching.pairs, 1U);
  EXPECT_EQ(touching.volume, 0);
}

// Against the same formula in 113 bits: where doubles for the distance lose up to seven digits of the volume.
TEST(PoseQueries, SumOverlapsThatAreSmallBesideTheirBalls) {
  struct Case {
    LatticeBall fixed, posed;
    double volume;
  };
  static constexpr Case cases[] = {{{0, 0, 0, 536870900}, {536870911, 3, 5, 13}, 154.98522943156871},
                                   {{0, 0, 0, 499999999}, {500000000, 1, 0, 3}, 29.321531307841031},
                                   {{0, 0, 0, 250000000}, {300000000, 400000001, 17, 250000001}, 15707917.844740856}};
  for (const auto &[fixed, posed, volume] : cases) {
    const BuiltTree rest({fixed}), other({posed});
    EXPECT_NEAR(hsp::sum_overlaps(rest.tree(), other.tree(), hsp::Pose()).volume, volume, 4e-15 * volume);
    EXPECT_NEAR(hsp::sum_overlaps(other.tree(), rest.tree(), hsp::Pose()).volume, volume, 4e-15 * volume);
  }
}

}  // namespace
