#include "pose_workload.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "random_numbers.hpp"

namespace bench {
namespace {

constexpr uint32_t most_pairs = 1 << 16;

// Uniform on the sphere of radius 1, by components that are uniform in the ball.
template <size_t dimensions>
std::array<double, dimensions> random_direction(support::Random &random) {
  for (;;) {
    std::array<double, dimensions> direction{};
    double square = 0;
    for (double &component : direction) {
      component = 2 * random.fraction() - 1;
      square += component * component;
    }
    if (square > 1 || square < 0.01) continue;
    for (double &component : direction) component /= std::sqrt(square);
    return direction;
  }
}

Balls about_mean(Balls balls) {
  for (size_t axis = 0; axis < 3; ++axis) {
    double sum = 0;
    for (size_t i = axis; i < balls.xyz.size(); i += 3) sum += balls.xyz[i];
    for (size_t i = axis; i < balls.xyz.size(); i += 3) balls.xyz[i] -= sum / balls.size();
  }
  return balls;
}

}  // namespace

PreparedBody::PreparedBody(Balls balls)
    : balls_(std::make_unique<Balls>(about_mean(std::move(balls)))), model_(std::make_unique<Model>(*balls_, 0)) {
  size_t bytes = 0;
  expect_ok(hsp_body_bytes(size(), &bytes), "hsp_body_bytes");
  memory_.resize(bytes);
  expect_ok(hsp_body_init(memory_.data(), bytes, size(), &body_), "hsp_body_init");
  set();
}

double PreparedBody::reach() const {
  double most = 0;
  for (size_t i = 0; i < size(); ++i) {
    const double *const c = &balls_->xyz[3 * i];
    most = std::max(most, std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]) + balls_->radius[i]);
  }
  return most;
}

std::vector<Balls> moving_molecules() {
  std::vector<Balls> found;
  for (const Molecule &molecule : paper_molecules()) {
    if (molecule.name != "crambin" && molecule.name != "sod_stand_in") continue;
    if (molecule.name == "crambin") {
      const Molecule part{"crambin_100", {molecule.atoms.begin(), molecule.atoms.begin() + 100}};
      found.push_back(with_radii(part, Radii::van_der_waals));
    }
    found.push_back(with_radii(molecule, Radii::van_der_waals));
  }
  return found;
}

Balls resting_molecule() {
  return with_radii(paper_molecules().back(), Radii::van_der_waals);
}

std::vector<hsp_pose> slid_poses(const PreparedBody &fixed, const PreparedBody &moving, size_t count, double gap) {
  support::Random random(1994);
  std::vector<hsp_pose> poses;
  while (poses.size() < count) {
    const std::array<double, 4> q = random_direction<4>(random);
    const std::array<double, 3> d = random_direction<3>(random);
    hsp_pose pose{{q[0], q[1], q[2], q[3]}, {0, 0, 0}};
    double distance = fixed.reach() + moving.reach() + 1;
    const auto place = [&] {
      for (size_t axis = 0; axis < 3; ++axis) pose.translation[axis] = distance * d[axis];
    };
    // No step is longer than the gap, so nothing is passed through.
    for (int step = 0; step < 300 && distance > 0; ++step) {
      place();
      hsp_body_gap least{};
      expect_ok(hsp_body_gaps(fixed.get(), moving.get(), 1, &pose, &least, nullptr), "hsp_body_gaps");
      if (least.gap < 1e-3) break;
      distance -= least.gap;
    }
    distance += gap;
    place();
    poses.push_back(pose);
  }
  return poses;
}

size_t count_hits(const PreparedBody &fixed, const PreparedBody &moving, const std::vector<hsp_pose> &poses) {
  std::array<uint32_t, 1024> hit{};
  const auto count = static_cast<uint32_t>(std::min(poses.size(), hit.size()));
  expect_ok(hsp_body_hits(fixed.get(), moving.get(), count, poses.data(), hit.data(), nullptr), "hsp_body_hits");
  benchmark::DoNotOptimize(hit);
  size_t hits = 0;
  for (uint32_t k = 0; k < count; ++k) hits += hit[k];
  return hits;
}

double sum_gaps(const PreparedBody &fixed, const PreparedBody &moving, const std::vector<hsp_pose> &poses) {
  std::array<hsp_body_gap, 1024> gap{};
  const auto count = static_cast<uint32_t>(std::min(poses.size(), gap.size()));
  expect_ok(hsp_body_gaps(fixed.get(), moving.get(), count, poses.data(), gap.data(), nullptr), "hsp_body_gaps");
  double sum = 0;
  for (uint32_t k = 0; k < count; ++k) sum += gap[k].gap;
  return sum;
}

size_t count_pairs(const PreparedBody &fixed, const PreparedBody &moving, const std::vector<hsp_pose> &poses) {
  std::vector<uint32_t> pair(2 * size_t{most_pairs});
  size_t pairs = 0;
  for (const hsp_pose &pose : poses) {
    uint32_t needed = 0;
    const int32_t status = hsp_body_pairs(fixed.get(), moving.get(), &pose, pair.data(), most_pairs, &needed);
    if (status != HSP_OK) expect_ok(status, "hsp_body_pairs");
    pairs += needed;
  }
  benchmark::DoNotOptimize(pair);
  return pairs;
}

}  // namespace bench
