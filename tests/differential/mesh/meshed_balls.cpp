#include "meshed_balls.hpp"

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

int64_t MeshedBalls::surface_euler() const {
  if (probe_ == 0.0) return computed_.counts.euler;
  hsp_surface_map_counts map{};
  expect_ok(hsp_surface_get_map_counts(surface_.surface, &map), "hsp_surface_get_map_counts");
  std::vector<hsp_surface_shell> shells(map.shells);
  uint32_t needed = 0;
  expect_ok(hsp_surface_get_shells(surface_.surface, shells.data(), map.shells, &needed), "hsp_surface_get_shells");
  int64_t sum = 0;
  for (const hsp_surface_shell &shell : shells) sum += shell.euler;
  return sum;
}
