// The model: the figures of the paper's Section 2 against brute force over all pairs, its own counts, and that one
// model can be set to one set after another.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "brute_queries.hpp"
#include "checked_model.hpp"

namespace {

bool close(double value, long double expected, long double tolerance) {
  return std::fabs(static_cast<long double>(value) - expected) <= tolerance * std::fabs(expected);
}

void check_figures(const fuzz::ScaledBalls &set, hsp_model *model) {
  hsp_packing figures, again;
  const oracle::Figures expected = oracle::brute_figures(set.with_probe());
  FUZZ_REQUIRE(hsp_model_get_packing(model, &figures) == HSP_OK, "figures");
  FUZZ_REQUIRE(hsp_model_get_packing(model, &again) == HSP_OK, "figures");
  FUZZ_REQUIRE(std::memcmp(&figures, &again, sizeof figures) == 0, "figures differ the second time");
  FUZZ_REQUIRE(figures.flags ==
                   ((expected.zero_radius ? HSP_PACKING_ZERO_RADIUS : 0) |
                    (expected.coincident ? HSP_PACKING_COINCIDENT : 0) | (expected.no_pair ? HSP_PACKING_NO_PAIR : 0)),
               "flags");
  FUZZ_REQUIRE(figures.max_overlaps == expected.max_overlaps, "max_overlaps");
  FUZZ_REQUIRE(close(figures.mean_overlaps, expected.mean_overlaps, 1e-14L), "mean_overlaps");
  FUZZ_REQUIRE(close(figures.k, expected.k, 1e-15L), "k");
  FUZZ_REQUIRE(close(figures.rho, expected.rho, 1e-15L), "rho");
  if (figures.flags == 0) {
    FUZZ_REQUIRE(static_cast<double>(figures.max_overlaps) <= figures.neighbour_bound, "Theorem 2.1");
  } else {
    FUZZ_REQUIRE(figures.neighbour_bound == 0, "a bound that says nothing");
  }
}

void check_info(const fuzz::ScaledBalls &set, const hsp_model *model) {
  hsp_model_info info;
  int64_t largest = 0;
  for (uint32_t i = 0; i < set.n(); ++i) largest = std::max(largest, set.radius_of(i));
  FUZZ_REQUIRE(hsp_model_get_info(model, &info) == HSP_OK, "info");
  FUZZ_REQUIRE(info.balls == set.n(), "balls");
  FUZZ_REQUIRE(info.cubes <= info.balls && (info.cubes > 0) == (info.balls > 0), "cubes");
  FUZZ_REQUIRE(info.table_slots >= 2 * info.cubes, "load at most 1/2");
  FUZZ_REQUIRE(info.longest_probe <= info.table_slots, "longest_probe");
  FUZZ_REQUIRE(info.step == set.step(), "step");
  FUZZ_REQUIRE(std::fabs(info.probe - set.length(set.probe_steps)) <= 1e-15 * info.probe, "probe");
  FUZZ_REQUIRE(std::fabs(info.largest_radius - set.length(largest)) <= 1e-15 * info.largest_radius, "largest_radius");
}

// The balls that the model returns must be those of the set, which are on the lattice already.
void check_balls(const fuzz::ScaledBalls &set, const hsp_model *model) {
  const support::BallList list = set.in_lengths();
  const uint32_t n = list.size();
  std::vector<double> xyz(3 * size_t{n} + 1, 777), radius(size_t{n} + 1, 777);
  FUZZ_REQUIRE(hsp_model_get_balls(model, xyz.data(), radius.data(), n, nullptr) == HSP_OK, "hsp_model_get_balls");
  FUZZ_REQUIRE(std::equal(list.xyz.begin(), list.xyz.end(), xyz.begin()) && xyz.back() == 777, "centres");
  for (uint32_t i = 0; i < n; ++i) FUZZ_REQUIRE(radius[i] == set.length(set.radius_of(i)), "radii with the probe");
  FUZZ_REQUIRE(radius.back() == 777, "beyond the last radius");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const size_t misalignment = bytes.below(16);
  const fuzz::ScaledBalls first = fuzz::ball_set(bytes, 48);
  const fuzz::CheckedModel model(first, misalignment);
  check_info(first, model.get());
  check_figures(first, model.get());
  check_balls(first, model.get());

  // another frame in the same model, of at most as many balls
  const fuzz::ScaledBalls second = fuzz::ball_set(bytes, 48);
  const support::BallList list = second.in_lengths();
  const hsp_model_options options = fuzz::options_of(second);
  const int32_t status =
      hsp_model_set(model.get(), list.size(), list.xyz.data(), list.radius.data(), &options, nullptr);
  FUZZ_REQUIRE(status == (second.n() > first.n() ? HSP_E_CAPACITY : HSP_OK), "capacity");
  if (status == HSP_OK) {
    check_info(second, model.get());
    check_figures(second, model.get());
    check_balls(second, model.get());
  } else {
    hsp_model_info info;
    FUZZ_REQUIRE(hsp_model_get_info(model.get(), &info) == HSP_OK && info.balls == 0, "on failure there are no balls");
    FUZZ_REQUIRE(hsp_model_get_balls(model.get(), nullptr, nullptr, 0, nullptr) == HSP_E_STATE,
                 "on failure there is nothing");
  }
  return 0;
}
