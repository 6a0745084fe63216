// The model: figures of Section 2 against all pairs, what it tells about itself, and that sets can follow one another.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "checked_model.hpp"

namespace {

struct ExpectedFigures {
  int64_t smallest = std::numeric_limits<int64_t>::max();
  int64_t largest = 0;
  uint64_t overlaps = 0;
  uint32_t most = 0;
  uint32_t flags = 0;
  double rho = std::numeric_limits<double>::infinity();
};

ExpectedFigures figures_by_definition(const fuzz::BallSet &set) {
  ExpectedFigures expected;
  for (uint32_t i = 0; i < set.n(); ++i) {
    uint32_t count = 0;
    const int64_t r = set.radius_of(i);
    expected.smallest = std::min(expected.smallest, r);
    expected.largest = std::max(expected.largest, r);
    if (r == 0) expected.flags |= HSP_PACKING_ZERO_RADIUS;
    for (uint32_t j = 0; j < set.n(); ++j) {
      if (i == j) continue;
      const int64_t s = set.radius_of(j);
      const int64_t squared = fuzz::squared_distance(set.balls[i].centre, set.balls[j].centre);
      if (squared < (r + s) * (r + s)) ++count;
      if (squared == 0) {
        expected.flags |= HSP_PACKING_COINCIDENT;
        expected.rho = 0;
      }
      if (std::max(r, s) > 0) {
        expected.rho =
            std::min(expected.rho, std::sqrt(static_cast<double>(squared)) / static_cast<double>(std::max(r, s)));
      }
    }
    expected.overlaps += count;
    expected.most = std::max(expected.most, count);
  }
  if (set.n() < 2 || expected.largest == 0) {
    expected.flags |= HSP_PACKING_NO_PAIR;
    expected.rho = 0;
  }
  return expected;
}

void check_figures(const fuzz::BallSet &set, hsp_model *model) {
  hsp_packing figures, again;
  const ExpectedFigures expected = figures_by_definition(set);
  FUZZ_REQUIRE(hsp_model_get_packing(model, &figures) == HSP_OK, "figures");
  FUZZ_REQUIRE(hsp_model_get_packing(model, &again) == HSP_OK, "figures");
  FUZZ_REQUIRE(std::memcmp(&figures, &again, sizeof figures) == 0, "figures differ the second time");
  FUZZ_REQUIRE(figures.flags == expected.flags, "flags");
  FUZZ_REQUIRE(figures.max_overlaps == expected.most, "max_overlaps");
  const double mean = set.n() == 0 ? 0 : static_cast<double>(expected.overlaps) / set.n();
  FUZZ_REQUIRE(std::fabs(figures.mean_overlaps - mean) <= 1e-14 * mean, "mean_overlaps");
  const bool has_k = set.n() > 0 && expected.smallest > 0;
  const double k = has_k ? static_cast<double>(expected.largest) / static_cast<double>(expected.smallest) : 0;
  FUZZ_REQUIRE(std::fabs(figures.k - k) <= 1e-15 * k, "k");
  FUZZ_REQUIRE(std::fabs(figures.rho - expected.rho) <= 1e-15 * expected.rho, "rho");
  if (figures.flags == 0) {
    FUZZ_REQUIRE(static_cast<double>(figures.max_overlaps) <= figures.neighbour_bound, "Theorem 2.1");
  } else {
    FUZZ_REQUIRE(figures.neighbour_bound == 0, "a bound that says nothing");
  }
}

void check_info(const fuzz::BallSet &set, const hsp_model *model) {
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const size_t misalignment = bytes.below(16);
  const fuzz::BallSet first = fuzz::ball_set(bytes, 48);
  const fuzz::CheckedModel model(first, misalignment);
  check_info(first, model.get());
  check_figures(first, model.get());

  // another frame in the same model, of at most as many balls
  const fuzz::BallSet second = fuzz::ball_set(bytes, 48);
  const std::vector<double> xyz = second.xyz(), radius = second.radius();
  const hsp_model_options options = fuzz::options_of(second);
  const int32_t status = hsp_model_set(model.get(), second.n(), xyz.data(), radius.data(), &options, nullptr);
  FUZZ_REQUIRE(status == (second.n() > first.n() ? HSP_E_CAPACITY : HSP_OK), "capacity");
  if (status == HSP_OK) {
    check_info(second, model.get());
    check_figures(second, model.get());
  } else {
    hsp_model_info info;
    FUZZ_REQUIRE(hsp_model_get_info(model.get(), &info) == HSP_OK && info.balls == 0, "on failure the model is empty");
  }
  return 0;
}
