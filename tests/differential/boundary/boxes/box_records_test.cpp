// The records of a periodic box against brute force: each ball at its place among all images that meet it, and what the
// oracle finds of that set on this ball. And against themselves, from other images and other vectors.
#include "box_records.hpp"

#include <gtest/gtest.h>

#include "brute_boundary.hpp"
#include "random_balls.hpp"
#include "sweep_length.hpp"

namespace {

using support::operator+;
using support::operator-;
using support::BoxedBalls;
using support::PlacedBall;
using support::PlacedBoundary;
using support::PlacedVertex;
using support::Steps;

void compute(support::OwnedPeriodic &owned, const BoxedBalls &set) {
  hsp_periodic_limits limits{};
  ASSERT_EQ(hsp_periodic_limits_init(&limits, sizeof limits, set.balls.size()), HSP_OK);
  owned.take(limits);
  hsp_model_options options{};
  ASSERT_EQ(hsp_model_options_init(&options, sizeof options), HSP_OK);
  options.step = 1.0;
  owned.compute([&](hsp_periodic *handle, hsp_periodic_limits *asked) {
    return hsp_periodic_compute(handle, set.balls.size(), set.balls.xyz.data(), set.balls.radius.data(), set.box.data(),
                                &options, asked, nullptr);
  });
}

// The balls in their places, then all images that meet one of them; of which ball each is.
struct Patch {
  oracle::Balls balls;
  std::vector<uint32_t> ball_of;

  explicit Patch(const BoxedBalls &set) {
    const uint32_t n = set.balls.size();
    for (uint32_t i = 0; i < n; ++i) add(set, i, set.place(i));
    // Places are in a brick, which copies that lean by no more than half a vector lie around.
    for (uint32_t i = 0; i < n; ++i) {
      for (int32_t a = -7; a <= 7; ++a) {
        for (int32_t b = -5; b <= 5; ++b) {
          for (int32_t c = -3; c <= 3; ++c) {
            const int32_t shift[3] = {a, b, c};
            if (a != 0 || b != 0 || c != 0) add_if_near(set, n, i, set.place(i) + set.moved(shift));
          }
        }
      }
    }
  }
  [[nodiscard]] PlacedBall at(uint32_t k) const { return {ball_of[k], {balls[k].x, balls[k].y, balls[k].z}}; }

 private:
  void add(const BoxedBalls &set, uint32_t i, const Steps &centre) {
    balls.push_back(oracle::ball_around(centre, static_cast<int64_t>(set.balls.radius[i])));
    ball_of.push_back(i);
  }
  void add_if_near(const BoxedBalls &set, uint32_t n, uint32_t i, const Steps &centre) {
    for (uint32_t j = 0; j < n; ++j) {
      const Steps v = centre - oracle::centre_of(balls[j]);
      const int64_t reach = balls[j].radius + static_cast<int64_t>(set.balls.radius[i]);
      if (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] <= reach * reach) return add(set, i, centre);
    }
  }
};

// The oracle's records of the first n balls.
PlacedBoundary brute_force(const Patch &patch, uint32_t n) {
  const oracle::BoundaryRecord record = oracle::brute_boundary(patch.balls);
  PlacedBoundary result;
  const auto name = [&](uint32_t v) {
    const auto &vertex = record.vertices[v];
    return support::placed_vertex({patch.at(vertex.ball[0]), patch.at(vertex.ball[1]), patch.at(vertex.ball[2])},
                                  vertex.sign);
  };
  for (uint32_t v = 0; v < record.vertices.size(); ++v) {
    if (record.vertices[v].ball[0] < n) result.vertices.emplace_back(name(v), record.vertices[v].tied);
  }
  std::sort(result.vertices.begin(), result.vertices.end());
  std::vector<support::PlacedFace> faces;
  for (const auto &face : record.faces) faces.push_back({patch.ball_of[face.ball], face.loops, {}});
  const auto add = [&](const auto &edge, const PlacedVertex &from, const PlacedVertex &to) {
    faces[edge.face[0]].edges.push_back({patch.at(edge.ball[1]), from, to});
    faces[edge.face[1]].edges.push_back({patch.at(edge.ball[0]), to, from});
  };
  for (const auto &arc : record.arcs) add(arc, name(arc.vertex[0]), name(arc.vertex[1]));
  for (const auto &circle : record.circles) add(circle, {}, {});
  for (size_t f = 0; f < faces.size(); ++f) {
    if (record.faces[f].ball >= n) continue;
    std::sort(faces[f].edges.begin(), faces[f].edges.end());
    result.faces.push_back(faces[f]);
  }
  std::sort(result.faces.begin(), result.faces.end());
  return result;
}

void expect_brute_force(const BoxedBalls &set) {
  support::OwnedPeriodic owned;
  ASSERT_NO_FATAL_FAILURE(compute(owned, set));
  const support::BoxRecords records(owned.get());
  const support::BoxReader reader(set, records);
  EXPECT_EQ(reader.problem(), "");
  const Patch patch(set);
  const PlacedBoundary expected = brute_force(patch, set.balls.size());
  EXPECT_EQ(reader.placed().vertices, expected.vertices) << oracle::to_text(patch.balls);
  EXPECT_EQ(reader.placed().faces, expected.faces) << oracle::to_text(patch.balls);
}

BoxedBalls random_set(oracle::RandomSource &random, bool tied) {
  const int64_t unit = tied ? 2 : 1000;
  const auto whole = [&](int64_t least, int64_t most) {
    return static_cast<double>(tied ? random.in(least, most) * unit : random.in(least * unit, most * unit));
  };
  BoxedBalls set;
  set.box = {whole(4, 6), 0, 0, whole(-3, 3), whole(4, 6), 0, whole(-3, 3), whole(-3, 3), whole(4, 6)};
  if (random.one_in(2)) set.box[3] = set.box[6] = set.box[7] = 0;
  const int64_t n = random.in(1, 4);
  for (int64_t i = 0; i < n; ++i) {
    const double x = whole(-9, 9), y = whole(-9, 9), z = whole(-9, 9);
    set.balls.add(x, y, z, whole(1, 3));
  }
  if (random.one_in(4)) set.balls.add(set.balls.xyz[0], set.balls.xyz[1], set.balls.xyz[2], set.balls.radius[0]);
  return set;
}

TEST(BoxRecords, AreThoseOfBruteForce) {
  oracle::RandomSource random(61);
  uint32_t of_own_images = 0, across = 0;
  const int sets = oracle::sets(40);
  for (int k = 0; k < sets && !HasFailure(); ++k) {
    const BoxedBalls set = random_set(random, k % 2 == 0);
    expect_brute_force(set);
    support::OwnedPeriodic owned;
    compute(owned, set);
    for (const hsp_periodic_vertex &v : support::BoxRecords(owned.get()).vertices) {
      of_own_images += v.image[0].ball == v.image[1].ball || v.image[1].ball == v.image[2].ball ? 1U : 0U;
    }
    for (const hsp_periodic_loop_arc &arc : support::BoxRecords(owned.get()).loop_arcs) {
      across += arc.arc.shift[0] != 0 || arc.arc.shift[1] != 0 || arc.arc.shift[2] != 0 ? 1U : 0U;
    }
  }
  EXPECT_GT(of_own_images, static_cast<uint32_t>(sets));
  EXPECT_GT(across, static_cast<uint32_t>(sets));
}

// Crystals whose vertices tie: simple, body-centred and face-centred cubes.
TEST(BoxRecords, OfCrystalsAreThoseOfBruteForce) {
  const std::array<double, 9> small{4, 0, 0, 0, 4, 0, 0, 0, 4}, large{8, 0, 0, 0, 8, 0, 0, 0, 8};
  BoxedBalls simple{{}, small}, centred{{}, small}, faces{{}, large}, touching{{}, small};
  simple.balls.add(1, 2, 3, 3);
  touching.balls.add(0, 0, 0, 2);
  centred.balls.add(0, 0, 0, 2);
  centred.balls.add(2, 2, 2, 2);
  faces.balls.add(0, 0, 0, 3);
  faces.balls.add(0, 4, 4, 3);
  faces.balls.add(4, 0, 4, 3);
  faces.balls.add(4, 4, 0, 3);
  for (const BoxedBalls &set : {simple, touching, centred, faces}) expect_brute_force(set);
}

// Numbers, ids and places have the same bits, whichever images are given and by whichever vectors.
TEST(BoxRecords, AreTheSameForAllImagesAndVectors) {
  oracle::RandomSource random(62);
  for (int k = 0; k < oracle::sets(60) && !HasFailure(); ++k) {
    const BoxedBalls set = random_set(random, k % 2 == 0);
    BoxedBalls other = set;
    for (uint32_t i = 0; i < set.balls.size(); ++i) {
      int32_t shift[3];
      for (int32_t &s : shift) s = static_cast<int32_t>(random.in(-5, 5));
      const Steps at = set.given(i) + set.moved(shift);
      for (size_t axis = 0; axis < 3; ++axis) other.balls.xyz[3 * size_t{i} + axis] = static_cast<double>(at[axis]);
    }
    if (k % 3 != 0) {
      for (size_t axis = 0; axis < 3; ++axis) {
        other.box[3 + axis] += 2 * set.box[axis];
        other.box[6 + axis] += set.box[axis] - set.box[3 + axis];
      }
    }
    support::OwnedPeriodic one, two;
    compute(one, set);
    compute(two, other);
    const support::BoxRecords first(one.get()), second(two.get());
    EXPECT_EQ(support::difference_of_records(set, first, other, second), "");
    EXPECT_EQ(support::BoxReader(set, first).problem(), "");
    EXPECT_EQ(support::BoxReader(other, second).problem(), "");
  }
}

}  // namespace
