#include "meshed_balls.hpp"

#include <cmath>
#include <vector>

#include "library_run.hpp"

MeshedBalls::MeshedBalls(const support::BallList &balls, double probe, double step) : probe_(probe) {
  hsp_model_options options;
  expect_ok(hsp_model_options_init(&options, sizeof options), "hsp_model_options_init");
  options.probe = probe;
  options.step = step;
  expect_ok(computed_make(balls.size(), balls.xyz.data(), balls.radius.data(), &options, &computed_), "computed_make");
  expect_ok(surface_result_make(&computed_, &surface_), "surface_result_make");
}

MeshedBalls::~MeshedBalls() {
  surface_result_release(&surface_);
  computed_release(&computed_);
}

std::vector<hsp_surface_shell> MeshedBalls::surface_shells() const {
  hsp_surface_part_counts map{};
  expect_ok(hsp_surface_get_part_counts(surface_.surface, &map), "hsp_surface_get_part_counts");
  std::vector<hsp_surface_shell> shells(map.shells);
  uint32_t needed = 0;
  expect_ok(hsp_surface_get_shells(surface_.surface, shells.data(), map.shells, &needed), "hsp_surface_get_shells");
  return shells;
}

std::vector<uint32_t> MeshedBalls::shells_of_patches() const {
  hsp_surface_part_counts map{};
  expect_ok(hsp_surface_get_part_counts(surface_.surface, &map), "hsp_surface_get_part_counts");
  std::vector<hsp_surface_patch> patches(map.patches);
  expect_ok(hsp_surface_get_patches(surface_.surface, 0, map.patches, patches.data()), "hsp_surface_get_patches");
  std::vector<uint32_t> shells;
  for (const hsp_surface_patch &patch : patches) shells.push_back(patch.shell);
  return shells;
}

int64_t MeshedBalls::surface_euler() const {
  if (probe_ == 0.0) return computed_.counts.euler;
  int64_t sum = 0;
  for (const hsp_surface_shell &shell : surface_shells()) sum += shell.euler;
  return sum;
}

double MadeMesh::triangle_area(uint32_t t) const {
  const double(&p)[3] = mesh_.xyz[mesh_.corners[t][0]];
  const double(&q)[3] = mesh_.xyz[mesh_.corners[t][1]];
  const double(&r)[3] = mesh_.xyz[mesh_.corners[t][2]];
  double square = 0.0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double n = (q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i]);
    square += n * n;
  }
  return 0.5 * std::sqrt(square);
}

double MadeMesh::triangle_volume(uint32_t t) const {
  const double(&p)[3] = mesh_.xyz[mesh_.corners[t][0]];
  const double(&q)[3] = mesh_.xyz[mesh_.corners[t][1]];
  const double(&r)[3] = mesh_.xyz[mesh_.corners[t][2]];
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    sum += p[k] * (q[i] * r[j] - q[j] * r[i]);
  }
  return sum / 6;
}
