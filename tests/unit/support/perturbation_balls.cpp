#include "perturbation_balls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace perturbation {
namespace {

// Vectors of integral components and length.
struct Offset {
  int64_t v[3];
  int64_t length;
};

std::vector<Offset> integral_offsets(bool in_plane) {
  constexpr int64_t reach = 15;
  std::vector<Offset> offsets;
  for (int64_t x = -reach; x <= reach; ++x) {
    for (int64_t y = -reach; y <= reach; ++y) {
      for (int64_t z = in_plane ? 0 : -reach; z <= (in_plane ? 0 : reach); ++z) {
        const int64_t squared = x * x + y * y + z * z;
        const int64_t length = std::lround(std::sqrt(static_cast<double>(squared)));
        if (squared > 0 && length * length == squared) offsets.push_back({{x, y, z}, length});
      }
    }
  }
  return offsets;
}

const Offset &random_offset(oracle::RandomSource &random, bool in_plane) {
  static const std::vector<Offset> in_space = integral_offsets(false);
  static const std::vector<Offset> plane = integral_offsets(true);
  const std::vector<Offset> &from = in_plane ? plane : in_space;
  return from[random.next() % from.size()];
}

Ball in_box(oracle::RandomSource &random, int64_t m) {
  return {{random.in(0, m), random.in(0, m), random.in(0, m)}, random.in(0, m), 0};
}

Ball through_the_origin(oracle::RandomSource &random, bool in_plane) {
  const Offset &offset = random_offset(random, in_plane);
  return {{offset.v[0], offset.v[1], offset.v[2]}, offset.length, 0};
}

// All of these spheres hold the circle of radius 12 about the origin in the plane x = 0.
Ball through_a_circle(oracle::RandomSource &random) {
  constexpr int64_t axial[][2] = {{0, 12}, {5, 13}, {9, 15}, {16, 20}, {35, 37}};
  const auto &[x, radius] = axial[random.next() % 5];
  return {{random.one_in(2) ? x : -x, 0, 0}, radius, 0};
}

Ball tangent_to(oracle::RandomSource &random, const Ball &other) {
  const Offset &offset = random_offset(random, random.one_in(3));
  const int64_t length = offset.length;
  Ball ball{{other.centre[0] + offset.v[0], other.centre[1] + offset.v[1], other.centre[2] + offset.v[2]}, 0, 0};
  const int64_t inside = std::abs(other.radius - length);
  ball.radius = random.one_in(3) ? other.radius + length : inside;
  return ball;
}

void fill(oracle::RandomSource &random, Ball (&ball)[4]) {
  constexpr int64_t boxes[] = {1, 1, 2, 2, 3, 6};
  const uint64_t kind = random.next() % 10;
  const int64_t m = boxes[random.next() % 6];
  for (int k = 0; k < 4; ++k) {
    switch (kind) {
      case 0:  // no rule
      case 1:
        ball[k] = in_box(random, m);
        break;
      case 2:  // in a plane
        ball[k] = in_box(random, m);
        ball[k].centre[2] = 0;
        break;
      case 3:  // on a line
        ball[k] = random.one_in(8) ? in_box(random, m) : through_a_circle(random);
        break;
      case 4:
        ball[k] = through_the_origin(random, false);
        break;
      case 5:  // in a plane and through a point of it: triples of circles that touch there
        ball[k] = through_the_origin(random, !random.one_in(4));
        break;
      case 6:
        ball[k] =
            k == 0 || random.one_in(4) ? in_box(random, 6) : tangent_to(random, ball[random.next() % unsigned(k)]);
        break;
      case 7:  // equal balls, common centres
        ball[k] = random.one_in(2) ? in_box(random, m) : through_the_origin(random, false);
        if (k > 0 && random.one_in(3)) {
          const int64_t radius = random.one_in(2) ? ball[k].radius : ball[k - 1].radius;
          ball[k] = ball[random.next() % unsigned(k)];
          if (random.one_in(2)) ball[k].radius = radius;
        }
        break;
      case 8:  // points: on the others' spheres or anywhere
        ball[k] = through_the_origin(random, random.one_in(4));
        if (random.one_in(4)) ball[k] = {{0, 0, 0}, 0, 0};
        if (random.one_in(6)) ball[k].radius = 0;
        break;
      default:  // a piece of a lattice, with equal radii
        for (int64_t &x : ball[k].centre) x = 2 * random.in(0, 2);
        ball[k].radius = k == 0 ? random.in(1, 4) : ball[0].radius;
    }
  }
}

void turn(oracle::RandomSource &random, Ball (&ball)[4]) {
  const uint64_t axis = random.next() % 3;
  const bool mirrored = random.one_in(2);
  const int64_t shift[3] = {random.in(-9, 9), random.in(-9, 9), random.in(-9, 9)};
  for (Ball &b : ball) {
    std::swap(b.centre[0], b.centre[axis]);
    for (int k = 0; k < 3; ++k) b.centre[k] = (mirrored ? -b.centre[k] : b.centre[k]) + shift[k];
  }
}

}  // namespace

TiedBalls random_tied_balls(oracle::RandomSource &random, Size size) {
  TiedBalls four{};
  auto &ball = four.ball;
  fill(random, ball);
  turn(random, ball);
  int64_t largest = 1;
  for (const Ball &b : ball) largest = std::max(largest, b.radius);

  const int64_t limit = size == Size::small ? int64_t{1} << 8 : (int64_t{1} << 30) - 1;
  int64_t scale = limit / largest;
  if (size == Size::small) scale = random.one_in(2) ? 1 : random.in(1, scale);
  if (size == Size::near_limit && random.one_in(2)) scale = random.in(scale / 2, scale);
  for (Ball &b : ball) {
    for (int64_t &x : b.centre) x *= scale;
    b.radius *= scale;
  }
  if (size == Size::near_limit) {
    if (random.one_in(10)) {  // sizes of all magnitudes
      for (Ball &b : ball) b.radius = std::max<int64_t>(b.radius >> (random.next() % 31), 1);
    }
    if (random.one_in(3)) {  // next to a tie
      Ball &b = ball[random.next() % 4];
      int64_t &value = random.one_in(4) ? b.radius : b.centre[random.next() % 3];
      value += random.one_in(2) ? 1 : -1;
      b.radius = std::clamp<int64_t>(b.radius, 0, limit);
    }
    if (random.one_in(2)) {  // far out
      for (int k = 0; k < 3; ++k) {
        const int64_t offset = (random.one_in(2) ? 1 : -1) * ((int64_t{1} << 50) - (int64_t{1} << 36));
        for (Ball &b : ball) b.centre[k] += offset;
      }
    }
  }
  // The caller's order is the last resort of the rank.
  uint32_t order[4] = {0, 1, 2, 3};
  for (uint32_t k = 3; k > 0; --k) std::swap(order[k], order[random.next() % (k + 1)]);
  for (int k = 0; k < 4; ++k) ball[k].index = order[k];
  return four;
}

}  // namespace perturbation
