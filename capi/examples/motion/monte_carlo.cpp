// The work of monte_carlo.c by hardsphere.hpp: a ligand wanders about a receptor and gathers contacts.
//   monte_carlo RECEPTOR.xyzr LIGAND.xyzr [MOVES]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <hardsphere.hpp>

#include "../read_balls.hpp"

namespace {

constexpr double reach = 1.0, largest_shift = 0.5, largest_turn = 0.1, temperature = 2.0;
constexpr double step = 1e-6;  // all bodies that meet need lattices of one step

// In [-1, 1): Vigna's xorshift64*.
double random_number() {
  static uint64_t x = 1994;
  x ^= x >> 12;
  x ^= x << 25;
  x ^= x >> 27;
  return static_cast<double>((x * UINT64_C(2685821657736338717)) >> 11) / 4503599627370496.0 - 1.0;
}

// Poses turn about the origin: the ligand turns about its own middle if that is there.
Balls read_at_origin(const char *path) {
  Balls balls;
  add_balls(balls, path);
  const size_t n = balls.radius.size();
  for (size_t axis = 0; axis < 3; ++axis) {
    double mean = 0;
    for (size_t i = 0; i < n; ++i) mean += balls.xyz[3 * i + axis] / static_cast<double>(n);
    for (size_t i = 0; i < n; ++i) balls.xyz[3 * i + axis] -= mean;
  }
  return balls;
}

// How far balls reach from the origin, for a place beside the receptor.
double largest_x(const Balls &balls) {
  double most = 0;
  for (size_t i = 0; i < balls.radius.size(); ++i) {
    const double *c = &balls.xyz[3 * i];
    most = std::max(most, std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]) + balls.radius[i]);
  }
  return most;
}

// A small turn after that of the pose, and a small shift.
hsp_pose neighbour_of(const hsp_pose &pose) {
  const double *q = pose.quaternion;
  double turn[4] = {1}, length = 0;
  hsp_pose moved = pose;
  for (int k = 1; k < 4; ++k) turn[k] = largest_turn / 2 * random_number();
  moved.quaternion[0] = turn[0] * q[0] - turn[1] * q[1] - turn[2] * q[2] - turn[3] * q[3];
  moved.quaternion[1] = turn[0] * q[1] + turn[1] * q[0] + turn[2] * q[3] - turn[3] * q[2];
  moved.quaternion[2] = turn[0] * q[2] - turn[1] * q[3] + turn[2] * q[0] + turn[3] * q[1];
  moved.quaternion[3] = turn[0] * q[3] + turn[1] * q[2] - turn[2] * q[1] + turn[3] * q[0];
  for (double part : moved.quaternion) length += part * part;
  for (double &part : moved.quaternion) part /= std::sqrt(length);
  for (double &part : moved.translation) part += largest_shift * random_number();
  return moved;
}

}  // namespace

int main(int count, char **arguments) try {
  if (count < 3 || count > 4) {
    std::fprintf(stderr, "usage: monte_carlo RECEPTOR.xyzr LIGAND.xyzr [MOVES]\n");
    return 2;
  }
  const unsigned long moves = count == 4 ? std::strtoul(arguments[3], nullptr, 10) : 100000;
  const Balls fixed = read_at_origin(arguments[1]), posed = read_at_origin(arguments[2]);
  const hardsphere::body receptor(fixed.xyz, fixed.radius, {.step = step});
  const hardsphere::body ligand(posed.xyz, posed.radius, {.step = step});
  const hardsphere::body wide_ligand(posed.xyz, posed.radius, {.probe = reach, .step = step});
  hsp_pose pose = {{1, 0, 0, 0}, {largest_x(fixed) + largest_x(posed), 0, 0}};
  for (int k = 0; k < 100; ++k) {  // slides until it is near: no step is longer than the gap
    const hsp_body_gap gap = receptor.gaps(ligand, {&pose, 1})[0];
    if (gap.fixed == HSP_NONE || gap.gap < reach / 2 || pose.translation[0] < 0) break;
    pose.translation[0] -= gap.gap - reach / 4;
  }
  unsigned long poses = 0, clashes = 0, accepted = 0;
  const auto clash = [&](const hsp_pose &at) { return ++poses, receptor.hits(ligand, {&at, 1})[0] != 0; };
  const auto score = [&](const hsp_pose &at) { return receptor.overlaps(wide_ligand, {&at, 1})[0].pairs; };
  uint32_t contacts = clash(pose) ? 0 : score(pose), most = contacts;
  hsp_pose best = pose;
  const auto start = std::chrono::steady_clock::now();
  for (unsigned long k = 0; k < moves; ++k) {
    const hsp_pose moved = neighbour_of(pose);
    if (clash(moved)) {
      ++clashes;
      continue;
    }
    const uint32_t found = score(moved);
    const double chance = std::exp((static_cast<double>(found) - static_cast<double>(contacts)) / temperature);
    if (found < contacts && (random_number() + 1) / 2 >= chance) continue;
    pose = moved;
    contacts = found;
    ++accepted;
    if (contacts > most) most = contacts, best = pose;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%lu poses: %lu clash, %lu accepted\n", poses, clashes, accepted);
  std::printf("best: %u contacts, quaternion %.17g %.17g %.17g %.17g, translation %.17g %.17g %.17g\n", most,
              best.quaternion[0], best.quaternion[1], best.quaternion[2], best.quaternion[3], best.translation[0],
              best.translation[1], best.translation[2]);
  if (seconds.count() > 0) std::printf("%.0f poses a second\n", static_cast<double>(poses) / seconds.count());
  return 0;
} catch (const std::exception &failure) {
  std::fprintf(stderr, "monte_carlo: %s\n", failure.what());
  return 1;
}
