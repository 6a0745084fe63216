#include "perturbation_balls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace perturbation {
namespace {

int64_t between(std::mt19937_64 &random, int64_t low, int64_t high) {
  return low + static_cast<int64_t>(random() % static_cast<uint64_t>(high - low + 1));
}

bool one_in(std::mt19937_64 &random, unsigned n) {
  return random() % n == 0;
}

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

const Offset &random_offset(std::mt19937_64 &random, bool in_plane) {
  static const std::vector<Offset> in_space = integral_offsets(false);
  static const std::vector<Offset> plane = integral_offsets(true);
  const std::vector<Offset> &from = in_plane ? plane : in_space;
  return from[random() % from.size()];
}

Ball in_box(std::mt19937_64 &random, int64_t m) {
  return {{between(random, 0, m), between(random, 0, m), between(random, 0, m)}, between(random, 0, m), 0};
}

Ball through_the_origin(std::mt19937_64 &random, bool in_plane) {
  const Offset &offset = random_offset(random, in_plane);
  return {{offset.v[0], offset.v[1], offset.v[2]}, offset.length, 0};
}

// All of these spheres hold the circle of radius 12 about the origin in the plane x = 0.
Ball through_a_circle(std::mt19937_64 &random) {
  constexpr int64_t axial[][2] = {{0, 12}, {5, 13}, {9, 15}, {16, 20}, {35, 37}};
  const auto &[x, radius] = axial[random() % 5];
  return {{one_in(random, 2) ? x : -x, 0, 0}, radius, 0};
}

Ball tangent_to(std::mt19937_64 &random, const Ball &other) {
  const Offset &offset = random_offset(random, one_in(random, 3));
  const int64_t length = offset.length;
  Ball ball{{other.centre[0] + offset.v[0], other.centre[1] + offset.v[1], other.centre[2] + offset.v[2]}, 0, 0};
  const int64_t inside = std::abs(other.radius - length);
  ball.radius = one_in(random, 3) ? other.radius + length : inside;
  return ball;
}

void fill(std::mt19937_64 &random, Ball (&ball)[4]) {
  constexpr int64_t boxes[] = {1, 1, 2, 2, 3, 6};
  const uint64_t kind = random() % 10;
  const int64_t m = boxes[random() % 6];
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
        ball[k] = one_in(random, 8) ? in_box(random, m) : through_a_circle(random);
        break;
      case 4:
        ball[k] = through_the_origin(random, false);
        break;
      case 5:  // in a plane and through a point of it: triples of circles that touch there
        ball[k] = through_the_origin(random, !one_in(random, 4));
        break;
      case 6:
        ball[k] = k == 0 || one_in(random, 4) ? in_box(random, 6) : tangent_to(random, ball[random() % unsigned(k)]);
        break;
      case 7:  // equal balls, common centres
        ball[k] = one_in(random, 2) ? in_box(random, m) : through_the_origin(random, false);
        if (k > 0 && one_in(random, 3)) {
          const int64_t radius = one_in(random, 2) ? ball[k].radius : ball[k - 1].radius;
          ball[k] = ball[random() % unsigned(k)];
          if (one_in(random, 2)) ball[k].radius = radius;
        }
        break;
      case 8:  // points: on the others' spheres or anywhere
        ball[k] = through_the_origin(random, one_in(random, 4));
        if (one_in(random, 4)) ball[k] = {{0, 0, 0}, 0, 0};
        if (one_in(random, 6)) ball[k].radius = 0;
        break;
      default:  // a piece of a lattice, with equal radii
        for (int64_t &x : ball[k].centre) x = 2 * between(random, 0, 2);
        ball[k].radius = k == 0 ? between(random, 1, 4) : ball[0].radius;
    }
  }
}

void turn(std::mt19937_64 &random, Ball (&ball)[4]) {
  const uint64_t axis = random() % 3;
  const bool mirrored = one_in(random, 2);
  const int64_t shift[3] = {between(random, -9, 9), between(random, -9, 9), between(random, -9, 9)};
  for (Ball &b : ball) {
    std::swap(b.centre[0], b.centre[axis]);
    for (int k = 0; k < 3; ++k) b.centre[k] = (mirrored ? -b.centre[k] : b.centre[k]) + shift[k];
  }
}

}  // namespace

FourBalls random_tied_balls(std::mt19937_64 &random, Size size) {
  FourBalls four{};
  auto &ball = four.ball;
  fill(random, ball);
  turn(random, ball);
  int64_t largest = 1;
  for (const Ball &b : ball) largest = std::max(largest, b.radius);

  const int64_t limit = size == Size::small ? int64_t{1} << 8 : (int64_t{1} << 30) - 1;
  int64_t scale = limit / largest;
  if (size == Size::small) scale = one_in(random, 2) ? 1 : between(random, 1, scale);
  if (size == Size::near_limit && one_in(random, 2)) scale = between(random, scale / 2, scale);
  for (Ball &b : ball) {
    for (int64_t &x : b.centre) x *= scale;
    b.radius *= scale;
  }
  if (size == Size::near_limit) {
    if (one_in(random, 10)) {  // sizes of all magnitudes
      for (Ball &b : ball) b.radius = std::max<int64_t>(b.radius >> (random() % 31), 1);
    }
    if (one_in(random, 3)) {  // next to a tie
      Ball &b = ball[random() % 4];
      int64_t &value = one_in(random, 4) ? b.radius : b.centre[random() % 3];
      value += one_in(random, 2) ? 1 : -1;
      b.radius = std::clamp<int64_t>(b.radius, 0, limit);
    }
    if (one_in(random, 2)) {  // far out
      for (int k = 0; k < 3; ++k) {
        const int64_t offset = (one_in(random, 2) ? 1 : -1) * ((int64_t{1} << 50) - (int64_t{1} << 36));
        for (Ball &b : ball) b.centre[k] += offset;
      }
    }
  }
  // The caller's order is the last resort of the rank.
  uint32_t order[4] = {0, 1, 2, 3};
  for (uint32_t k = 3; k > 0; --k) std::swap(order[k], order[random() % (k + 1)]);
  for (int k = 0; k < 4; ++k) ball[k].index = order[k];
  return four;
}

}  // namespace perturbation
