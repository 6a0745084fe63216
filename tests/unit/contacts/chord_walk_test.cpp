// Chords that the walk finds from the boundary's vertices, against those that are left of all pairs of caps.
#include "contacts/chord_walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "boundary/boundary_builder.hpp"
#include "built_grid.hpp"
#include "contacts/chord_cuts.hpp"
#include "lattice_lengths.hpp"
#include "random_balls.hpp"
#include "runnable_targets.hpp"

namespace {

// By the balls of a chord, those that clip it.
using Chords = std::map<std::array<uint32_t, 3>, std::pair<uint32_t, uint32_t>>;
// By the balls of a chord, and 0 at p- or 1 at p+, the ball that clips it there.
using Ends = std::map<std::array<uint32_t, 4>, uint32_t>;

class WalkedBalls {
 public:
  explicit WalkedBalls(const support::BallList &balls) : built_(balls), n_(balls.size()) {
    memory_.carve(boundary_, hsp::BoundaryLimits{n_, n_, 8 * n_ * n_ + 8, n_ * n_ + 8, 0});
    EXPECT_EQ(boundary_.build(built_.grid()), hsp::Status::ok);
    caps_memory_.carve(caps_, n_);
  }

  Chords by_walk(uint32_t contacts) {
    CarvedMemory memory;
    hsp::ChordWalk walk;
    memory.carve(walk, hsp::ContactLimits{n_, n_, contacts, 0, 0});
    walk.start(built_.grid().balls().n, built_.grid().balls().n);
    Chords chords;
    Ends ends;
    std::map<std::array<uint32_t, 3>, uint32_t> free_ends;
    for (uint32_t i = 0; i < built_.grid().balls().n; ++i) {
      if (boundary_.boundary().is_contained(i)) continue;
      if (hsp::IdRange whole; walk.has_whole_chords(boundary_.boundary(), i, whole)) {
        for (uint32_t v = whole.first; v < whole.last; v += 2) {
          const auto [a, b, c] = boundary_.boundary().vertex(v).ball;
          free_ends[{a, b, c}] = 2;
          chords.insert({{a, b, c}, {hsp::no_id, hsp::no_id}});
        }
        ++with_whole_chords_;
        continue;
      }
      gather(i);
      with_many_later_ += caps_.count - caps_.first_later > hsp::MaskedChords::most_caps ? 1U : 0U;
      caps_found_ += caps_.count;
      walk.keep_exposed(boundary_.boundary(), caps_);
      caps_kept_ += caps_.count;
      place_first_later();
      all_asked_ += walk.asks_for_all_caps(boundary_.boundary(), i) ? 1U : 0U;
      walk.find(boundary_.boundary(), caps_);
      for (const hsp::FoundChord &chord : walk.chords()) {
        const auto [j, k] = chord.cap;
        EXPECT_LT(j, k);
        const std::array<uint32_t, 3> key = {i, caps_.ball[j], caps_.ball[k]};
        free_ends[key] = chord.free_ends;
        chords.insert({key, {hsp::no_id, hsp::no_id}});
      }
      for (const hsp::FoundVertex &vertex : walk.vertices()) add_ends(vertex, ends);
    }
    for (const auto &[key, end] : ends) {
      EXPECT_EQ(chords.count({key[0], key[1], key[2]}), 1U);
      auto &clippers = chords[{key[0], key[1], key[2]}];
      (key[3] == 0 ? clippers.first : clippers.second) = end;
    }
    for (const auto &[key, clippers] : chords) {
      EXPECT_EQ(free_ends[key], (clippers.first == hsp::no_id ? 1U : 0U) + (clippers.second == hsp::no_id ? 1U : 0U));
    }
    return chords;
  }

  Chords by_pairs() {
    CarvedMemory memory;
    hsp::ChordClipper clipper;
    memory.carve(clipper, n_);
    Chords chords;
    for (uint32_t i = 0; i < built_.grid().balls().n; ++i) {
      if (!gather(i)) continue;
      clipper.start(caps_);
      for (uint32_t j = caps_.first_later; j < caps_.count; ++j) {
        for (uint32_t k = j + 1; k < caps_.count; ++k) {
          hsp::ChordEnds ends;
          if (!clipper.clip(caps_, j, k, ends)) continue;
          const auto ball = [&](uint32_t cap) { return cap == hsp::no_id ? cap : caps_.ball[cap]; };
          chords[{i, caps_.ball[j], caps_.ball[k]}] = {ball(ends.clipper[0]), ball(ends.clipper[1])};
        }
      }
    }
    return chords;
  }

  // How many balls have more later caps than MaskedChords is for.
  uint32_t with_many_later() const { return with_many_later_; }
  // How many balls it left out.
  uint32_t with_whole_chords() const { return with_whole_chords_; }
  // How many balls the walk wanted to have with all of their caps.
  uint32_t all_asked() const { return all_asked_; }
  // How many caps there were, and how many the walk kept.
  uint32_t caps_found() const { return caps_found_; }
  uint32_t caps_kept() const { return caps_kept_; }

 private:
  // A power vertex of the ball at hand ends the chords of every three of its balls, each once.
  void add_ends(const hsp::FoundVertex &vertex, Ends &ends) const {
    const auto [a, b, c] = vertex.cap;
    EXPECT_TRUE(a < b && b < c);
    const uint32_t four[4] = {caps_.origin, caps_.ball[a], caps_.ball[b], caps_.ball[c]};
    for (uint32_t k = 0; k < 4; ++k) {
      uint32_t three[3];
      uint32_t count = 0;
      for (uint32_t m = 0; m < 4; ++m) {
        if (m != k) three[count++] = four[m];
      }
      const hsp::BallSet &balls = built_.grid().balls();
      const auto vector = [&](uint32_t ball) { return balls.ball(ball).centre - balls.ball(three[0]).centre; };
      const int side = hsp::exact::Exact::triple_product_sign(vector(three[1]), vector(three[2]), vector(four[k]));
      EXPECT_NE(side, 0);
      EXPECT_TRUE(ends.insert({{three[0], three[1], three[2], side > 0 ? 1U : 0U}, four[k]}).second);
    }
  }

  bool gather(uint32_t i) {
    const hsp::BallSet &balls = built_.grid().balls();
    if (boundary_.boundary().is_contained(i)) return false;
    const hsp::CubeGrid &grid = built_.grid();
    caps_.gather(balls, grid.block_around(grid.cube_at(balls.ball(i).centre)), i, nullptr);
    caps_.keep_if([this](uint32_t j) { return !boundary_.boundary().is_contained(j); });
    place_first_later();
    return true;
  }
  void place_first_later() {
    caps_.first_later = 0;
    while (caps_.first_later < caps_.count && caps_.ball[caps_.first_later] < caps_.origin) ++caps_.first_later;
  }

  BuiltGrid built_;
  uint32_t n_;
  CarvedMemory memory_, caps_memory_;
  hsp::BoundaryBuilder boundary_;
  hsp::Caps caps_;
  uint32_t all_asked_ = 0, with_many_later_ = 0, with_whole_chords_ = 0, caps_found_ = 0, caps_kept_ = 0;
};

oracle::Balls any_kind_of_balls(oracle::RandomSource &random, int k) {
  const size_t n = static_cast<size_t>(random.in(4, 24));
  switch (k % 4) {
    case 0:
      return oracle::dense_balls(random, n);
    case 1:
      return oracle::lattice_balls(random, n);
    case 2:
      return oracle::degenerate_balls(random, n);
    default:
      return oracle::any_balls(random, n);
  }
}

TEST(ChordWalk, FindsWhatIsLeftOfAllPairs) {
  oracle::RandomSource random(83);
  size_t chords = 0;
  uint32_t all_asked = 0, with_whole_chords = 0;
  for (int k = 0; k < 160 && !HasFailure(); ++k) {
    const oracle::Balls balls = any_kind_of_balls(random, k);
    WalkedBalls walked(oracle::in_lengths(balls, 1));
    const Chords expected = walked.by_pairs();
    EXPECT_EQ(walked.by_walk(100 * 24), expected) << oracle::to_text(balls);
    // Without room for what is to be kept all pairs are looked at from some ball on.
    EXPECT_EQ(walked.by_walk(0), expected) << oracle::to_text(balls);
    EXPECT_EQ(walked.by_walk(2), expected) << oracle::to_text(balls);
    chords += expected.size();
    all_asked += walked.all_asked();
    with_whole_chords += walked.with_whole_chords();
  }
  EXPECT_GT(chords, 2000U);
  EXPECT_GT(all_asked, 100U);
  EXPECT_GT(with_whole_chords, 100U);
}

// More later balls around one than there are bits for: for these there is another table.
TEST(ChordWalk, FindsWhatIsLeftAmongManyBalls) {
  oracle::RandomSource random(86);
  uint32_t with_many = 0;
  for (int k = 0; k < 2 && !HasFailure(); ++k) {
    oracle::Balls balls;
    while (balls.size() < 90) {
      balls.push_back({random.in(-400, 400), random.in(-400, 400), random.in(-400, 400), random.in(500, 520)});
    }
    WalkedBalls walked(oracle::in_lengths(balls, 1));
    const Chords expected = walked.by_pairs();
    EXPECT_EQ(walked.by_walk(10000), expected) << oracle::to_text(balls);
    with_many += walked.with_many_later();
  }
  EXPECT_GT(with_many, 10U);
}

// Models of one molecule: of some two hundred balls that meet a ball few have planes that touch its power cell.
TEST(ChordWalk, FindsWhatIsLeftAmongCopies) {
  oracle::RandomSource random(88);
  for (const int64_t jitter : {10, 100, 3000}) {
    const oracle::Balls places = oracle::balls_in_box(random, 10, 8000, 15000, 17000);
    oracle::Balls balls;
    for (int copy = 0; copy < 20; ++copy) {
      for (const oracle::LatticeBall &place : places) {
        const auto near = [&](int64_t x) { return x + random.in(-jitter, jitter); };
        balls.push_back({near(place.x), near(place.y), near(place.z), place.radius});
      }
    }
    WalkedBalls walked(oracle::in_lengths(balls, 1));
    EXPECT_EQ(walked.by_walk(4000), walked.by_pairs());
    EXPECT_GT(walked.caps_found(), 20000U);
    EXPECT_LT(walked.caps_kept(), walked.caps_found() / 4);
  }
}

// Studs on a large ball, so many that those near to each are looked at alone; also so near to each other that all are,
// and in steps of the lattice, with ties.
TEST(ChordWalk, FindsWhatIsLeftOnAStuddedBall) {
  oracle::RandomSource random(92);
  uint32_t with_many = 0;
  for (const auto &[large, least, largest] :
       {std::array<int64_t, 3>{100000, 12000, 20000}, {100000, 12000, 80000}, {40, 5, 9}, {2000000, 100, 500000}}) {
    for (const int64_t corner : {-1, 1}) {
      const oracle::LatticePoint centre = {corner * large, corner * large, corner * large};
      WalkedBalls walked(oracle::in_lengths(oracle::studded_ball(random, 170, centre, large, least, largest), 1));
      EXPECT_EQ(walked.by_walk(4000), walked.by_pairs());
      with_many += walked.with_many_later();
    }
  }
  EXPECT_GE(with_many, 3U);
}

// Planes that nearly go through one point, so many that a polyhedron has no room for all, and so near that doubles know
// few cuts: of most balls nothing is left.
TEST(ChordWalk, FindsWhatIsLeftOfNearPlanes) {
  oracle::RandomSource random(94);
  for (const auto &[n, width] : {std::pair<uint32_t, double>{200, 1.0}, {170, 1e-2}, {60, 1e-4}}) {
    WalkedBalls walked(oracle::in_lengths(oracle::balls_of_near_planes(random, n, 1000000, 0.5, width), 1));
    EXPECT_EQ(walked.by_walk(4000), walked.by_pairs());
  }
}

// Places for arrivals are used again when their ball has come: fewer do than there are power vertices.
TEST(ChordWalk, UsesPlacesAgain) {
  oracle::RandomSource random(95);
  WalkedBalls walked(oracle::in_lengths(oracle::balls_in_box(random, 60, 4000, 900, 1100), 1));
  const Chords expected = walked.by_pairs();
  EXPECT_EQ(walked.by_walk(4000), expected);
  const uint32_t asked = walked.all_asked();
  EXPECT_EQ(walked.by_walk(static_cast<uint32_t>(expected.size() / 8)), expected);
  EXPECT_EQ(walked.all_asked(), 2 * asked);  // as many: none was lost
}

// A ball in a cage of later ones: nothing leads to its chords, neither vertices nor earlier balls.
TEST(ChordWalk, FindsAllOfABallThatIsBuriedByLaterOnes) {
  oracle::RandomSource random(84);
  uint32_t buried = 0;
  for (int k = 0; k < 40 && !HasFailure(); ++k) {
    oracle::Balls balls;
    balls.push_back({random.in(-20, 20), random.in(-20, 20), random.in(-20, 20), 400});
    for (int64_t corner = 0; corner < 8; ++corner) {
      const auto side = [&](int64_t bit) { return ((corner >> bit) & 1) * 600 - 300 + random.in(-30, 30); };
      balls.push_back({side(0), side(1), side(2), 520 + random.in(-10, 10)});
    }
    WalkedBalls walked(oracle::in_lengths(balls, 1));
    const Chords expected = walked.by_pairs();
    EXPECT_EQ(walked.by_walk(1000), expected) << oracle::to_text(balls);
    for (const auto &[chord, ends] : expected) {
      buried += ends.first > chord[0] && ends.first != hsp::no_id && ends.second > chord[0] ? 1U : 0U;
    }
  }
  EXPECT_GT(buried, 40U);
}

// Caps of a unit sphere, of which the first two have a chord.
struct RandomCaps {
  static constexpr uint32_t room = 32;
  double ux[room] = {}, uy[room] = {}, uz[room] = {}, b[room];
  uint32_t first, last;

  explicit RandomCaps(oracle::RandomSource &random) {
    first = static_cast<uint32_t>(random.in(0, 5));
    last = first + static_cast<uint32_t>(random.in(3, 20));
    for (uint32_t t = 0; t < room; ++t) {
      b[t] = 4.0;
      if (t >= last) continue;
      const auto number = [&] { return static_cast<double>(random.in(-1000, 1000)); };
      const double x = number(), y = number(), z = number();
      set(t, x, y, z + 0.5, static_cast<double>(random.in(-400, 900)) / 1000);
    }
  }
  void set(uint32_t t, double x, double y, double z, double height) {
    const double length = std::sqrt(x * x + y * y + z * z);
    ux[t] = x / length;
    uy[t] = y / length;
    uz[t] = z / length;
    b[t] = height;
  }
  hsp::Vec3 axis(uint32_t t) const { return {ux[t], uy[t], uz[t]}; }
  // The cut that a kernel finds by these in doubles or in floats.
  template <class T>
  uint32_t nearest_cut(hsp::Target target, uint32_t j, uint32_t k, uint32_t side, uint32_t end) const {
    T numbers[4][room];
    const double *const arrays[4] = {ux, uy, uz, b};
    for (uint32_t a = 0; a < 4; ++a) {
      for (uint32_t t = 0; t < room; ++t) numbers[a][t] = static_cast<T>(arrays[a][t]);
    }
    const hsp::CapPointers<T> caps{numbers[0], numbers[1], numbers[2], numbers[3]};
    return hsp::nearest_cut(target, caps, first, end, j, k, side);
  }

  // Where the chord of j and k is cut, by all caps that are entered on the way between its ends: sorted. None if a cap
  // holds all of it.
  std::vector<std::pair<double, uint32_t>> cuts(uint32_t j, uint32_t k, double direction) const {
    const hsp::Vec3 u = axis(j), v = axis(k), n = cross(u, v);
    const double g = dot(u, v), S = dot(n, n);
    const double q = S - b[j] * b[j] - b[k] * b[k] + 2 * g * b[j] * b[k];
    std::vector<std::pair<double, uint32_t>> result;
    if (!(q > 1e-3) || !(S > 1e-3)) return result;
    const hsp::Vec3 m = ((b[j] - g * b[k]) / S) * u + ((b[k] - g * b[j]) / S) * v;
    const hsp::Vec3 w = (direction * std::sqrt(q) / S) * n;
    for (uint32_t t = first; t < last; ++t) {
      const double slope = dot(w, axis(t));
      const double depth = b[t] - dot(m, axis(t));
      if (t == j || t == k) continue;
      if (std::fabs(slope) <= -depth) return {};
      if (slope > std::fabs(depth)) result.emplace_back(depth / slope, t);
    }
    std::sort(result.begin(), result.end());
    return result;
  }
};

// Kernels for all targets find the cut that a loop finds, or are not certain.
template <class T>
void expect_cuts_of_a_loop(uint32_t least_certain) {
  oracle::RandomSource random(85);
  uint32_t asked = 0, certain = 0;
  for (int round = 0; round < 3000; ++round) {
    const RandomCaps caps(random);
    const uint32_t j = caps.first, k = caps.first + 1;
    for (uint32_t side = 0; side < 2; ++side) {
      const auto cuts = caps.cuts(j, k, side == 1 ? 1.0 : -1.0);
      if (cuts.empty()) continue;
      for (const hsp::Target target : runnable_targets()) {
        const uint32_t found = caps.nearest_cut<T>(target, j, k, side, caps.last);
        ++asked;
        if (found == hsp::no_cut) continue;
        ++certain;
        EXPECT_EQ(found, cuts[0].second);
      }
    }
  }
  EXPECT_GT(asked, 2000U);
  EXPECT_GT(certain, asked / 100 * least_certain);
}
TEST(ChordCuts, AreThoseOfALoop) {
  expect_cuts_of_a_loop<double>(99);
  if constexpr (hsp::has_lanes) expect_cuts_of_a_loop<float>(90);
}

// Two caps that cut in the same place, one that runs along the chord near to it, and some that are farther away.
template <class T>
void expect_no_cut_of_ties(double near) {
  oracle::RandomSource random(87);
  uint32_t asked = 0;
  for (int round = 0; round < 3000; ++round) {
    RandomCaps caps(random);
    const uint32_t j = caps.first, k = caps.first + 1;
    const auto cuts = caps.cuts(j, k, 1.0);
    if (cuts.empty() || caps.last == RandomCaps::room) continue;
    const hsp::Vec3 along = caps.axis(j);
    const auto cut = [&](const hsp::Target target, double height, uint32_t last) {
      caps.set(caps.last, along.x, along.y, along.z, height);
      return caps.nearest_cut<T>(target, j, k, 1, last);
    };
    for (const hsp::Target target : runnable_targets()) {
      const uint32_t before = cut(target, 4.0, caps.last);
      if (before == hsp::no_cut) continue;
      ++asked;
      EXPECT_EQ(cut(target, caps.b[j] + near, caps.last + 1), hsp::no_cut);
      EXPECT_EQ(cut(target, caps.b[j] + 0.1, caps.last + 1), before);
      caps.set(caps.last, caps.ux[before], caps.uy[before], caps.uz[before], caps.b[before]);
      EXPECT_EQ(caps.nearest_cut<T>(target, j, k, 1, caps.last + 1), hsp::no_cut);
    }
  }
  EXPECT_GT(asked, 1000U);
}
TEST(ChordCuts, AreNotCertainOfWhatIsTiedOrRunsAlong) {
  expect_no_cut_of_ties<double>(1e-15);
  if constexpr (hsp::has_lanes) expect_no_cut_of_ties<float>(1e-6);
}

}  // namespace
