// The solvent-excluded surface of any set, with a probe of any size: areas that are none below 0 and add up, a volume
// between that of the balls and that of the union with the probe, the same bytes twice, no effect of the order of the
// balls, a volume that falls by the area where the probe grows inside the same spheres, limits that are too small.
#include <surface_result.h>

#include "computed_set.hpp"
#include "required_limits.hpp"

namespace {

using fuzz::same;

class Result {
 public:
  explicit Result(const fuzz::ScaledBalls &set) : set_(set) {
    const int32_t status = surface_result_make(&set_.get(), &surface_);
    FUZZ_REQUIRE(status == HSP_OK, hsp_status_text(status));
  }
  ~Result() { surface_result_release(&surface_); }
  Result(const Result &) = delete;
  Result &operator=(const Result &) = delete;

  const surface_result &get() const { return surface_; }

 private:
  fuzz::ComputedSet set_;
  surface_result surface_{};
};

// Lengths of the set: errors are relative to them.
double extent_of(const surface_result &s) {
  double extent = 1.0;
  for (uint32_t i = 0; i < s.base->n; ++i) extent = std::max(extent, s.base->radius[i]);
  return extent;
}

void require_sound(const fuzz::ScaledBalls &set, const surface_result &s) {
  const double tolerance = 1e-6 * (1.0 + s.base->totals.area) * extent_of(s);
  hsp_surface_totals sum{};
  for (uint32_t i = 0; i < s.base->n; ++i) {
    const hsp_surface_totals &ball = s.balls[i];
    FUZZ_REQUIRE(ball.convex_area >= 0 && ball.saddle_area >= 0 && ball.concave_area >= 0, "an area below 0");
    sum.area += ball.area;
    sum.volume += ball.volume;
  }
  FUZZ_REQUIRE(std::fabs(sum.area - s.totals.area) <= tolerance, "shares of the area do not add up");
  FUZZ_REQUIRE(std::fabs(sum.volume - s.totals.volume) <= tolerance, "shares of the volume do not add up");
  fuzz::ScaledBalls bare = set;
  bare.probe_steps = 0;
  const fuzz::ComputedSet without(bare);
  FUZZ_REQUIRE(s.totals.volume >= without.get().totals.volume - tolerance, "less than the balls");
  FUZZ_REQUIRE(s.totals.volume <= s.base->totals.volume + tolerance, "more than the union with the probe");
  FUZZ_REQUIRE(s.counts.hidden_patches <= s.counts.cut_patches, "hidden patches are cut");
  FUZZ_REQUIRE(s.counts.cut_patches <= s.counts.concave_patches, "cut patches are concave");
  FUZZ_REQUIRE(s.counts.cusped_patches <= s.counts.saddle_patches, "cusped patches are saddles");
}

struct Gradient {
  hsp_energy energy{};
  std::vector<double> centre, radius;
  std::vector<uint32_t> flags;
};

Gradient gradient_of(const surface_result &s, double tension, double pressure) {
  const uint32_t n = s.base->n;
  Gradient g{{}, std::vector<double>(3 * size_t{n}), std::vector<double>(n), std::vector<uint32_t>(n)};
  const int32_t status = hsp_surface_gradient(s.surface, tension, pressure, &g.energy, g.centre.data(), g.radius.data(),
                                              g.flags.data(), n, nullptr);
  FUZZ_REQUIRE(status == HSP_OK, hsp_status_text(status));
  return g;
}

// hsp_surface_gradient, properties 1, 2 and 4. Near vertices of three spheres that hardly meet terms are as large as
// they like, and cancel.
void require_gradient(const surface_result &s) {
  for (const bool of_volume : {false, true}) {
    const Gradient g = gradient_of(s, of_volume ? 0 : 1, of_volume ? 1 : 0);
    const double value = of_volume ? s.totals.volume : s.totals.area;
    FUZZ_REQUIRE(std::fabs(g.energy.value - value) <= 1e-9 * (1.0 + value), "an energy that is not what is measured");
    double sum[3]{}, scale = 1.0;
    bool degenerate = s.counts.open_joints > 0 || s.counts.rounded_patches > 0;
    for (uint32_t i = 0; i < s.base->n; ++i) {
      for (uint32_t axis = 0; axis < 3; ++axis) {
        const double d = g.centre[3 * size_t{i} + axis];
        FUZZ_REQUIRE(std::isfinite(d), "a derivative is not finite");
        sum[axis] += d;
        scale += std::fabs(d);
      }
      FUZZ_REQUIRE(std::isfinite(g.radius[i]), "a derivative by a radius is not finite");
      degenerate = degenerate || g.flags[i] != 0;
    }
    if (degenerate) continue;
    for (const double component : sum) {
      FUZZ_REQUIRE(std::fabs(component) <= 1e-6 * scale * extent_of(s), "derivatives by centres do not add up to 0");
    }
  }
}

bool has_equal_balls(const fuzz::ScaledBalls &set) {
  for (uint32_t i = 0; i < set.n(); ++i) {
    for (uint32_t j = 0; j < i; ++j) {
      const oracle::LatticeBall &a = set.balls[i], &b = set.balls[j];
      if (a.x == b.x && a.y == b.y && a.z == b.z && a.radius == b.radius) return true;
    }
  }
  return false;
}

// hsp_surface_measure, property 1. Of equal balls any may have the share.
void require_no_order(const fuzz::ScaledBalls &set, const surface_result &reference, fuzz::Bytes &bytes) {
  if (has_equal_balls(set)) return;
  const std::vector<uint32_t> order = fuzz::shuffled(set.n(), bytes);
  const Result other(fuzz::permuted(set, order));
  for (uint32_t i = 0; i < set.n(); ++i) {
    FUZZ_REQUIRE(same(&other.get().balls[i], &reference.balls[order[i]], 1), "a share differs in another order");
  }
  const Gradient here = gradient_of(reference, 0.75, 0.25), there = gradient_of(other.get(), 0.75, 0.25);
  for (uint32_t i = 0; i < set.n(); ++i) {
    FUZZ_REQUIRE(same(&there.centre[3 * size_t{i}], &here.centre[3 * size_t{order[i]}], 3), "a gradient differs");
    FUZZ_REQUIRE(same(&there.radius[i], &here.radius[order[i]], 1), "a derivative by a radius differs");
    FUZZ_REQUIRE(there.flags[i] == here.flags[order[i]], "a flag differs");
  }
  FUZZ_REQUIRE(same(&other.get().counts, &reference.counts, 1), "counts differ in another order");
}

// V' = -A: the difference quotient lies between the areas at both ends, up to what areas change in between.
void require_derivative(const fuzz::ScaledBalls &set, const surface_result &reference) {
  fuzz::ScaledBalls wider = set;
  const int64_t h = std::max<int64_t>(1, set.steps_per_unit / 1024);
  if (set.probe_steps == 0) return;
  for (oracle::LatticeBall &ball : wider.balls) {
    if (ball.radius < h) return;
    ball.radius -= h;
  }
  wider.probe_steps += h;
  const Result other(wider);
  const double length = set.length(h);
  const double quotient = (reference.totals.volume - other.get().totals.volume) / length;
  const double low = std::min(reference.totals.area, other.get().totals.area);
  const double high = std::max(reference.totals.area, other.get().totals.area);
  const double slack = 1e-5 / length + (high - low) + 0.02 * (1.0 + high);
  FUZZ_REQUIRE(quotient >= low - slack && quotient <= high + slack, "the volume does not fall by the area");
}

void require_capacities(const surface_result &reference, fuzz::Bytes &bytes) {
  const auto compute = [&](hsp_surface *surface, hsp_surface_limits *limits) {
    return hsp_surface_compute(surface, reference.base->boundary, limits);
  };
  const auto read = [&](const hsp_surface *surface) {
    hsp_surface_counts counts{};
    hsp_surface_totals totals{};
    const int32_t status = hsp_surface_get_counts(surface, &counts);
    FUZZ_REQUIRE(hsp_surface_measure(surface, &totals, nullptr, 0, nullptr) == status, "measure and counts");
    if (status == HSP_OK) {
      FUZZ_REQUIRE(same(&counts, &reference.counts, 1), "counts differ with more room");
      FUZZ_REQUIRE(same(&totals, &reference.totals, 1), "totals differ with more room");
    }
    return status;
  };
  fuzz::require_limits<support::SurfaceKind>(reference.needed, bytes, compute, read);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  fuzz::ScaledBalls set = fuzz::ball_set(bytes, 24);
  if (bytes.below(4) != 0) set.probe_steps = 1 + bytes.below(static_cast<uint32_t>(4 * set.steps_per_unit));
  const Result reference(set);
  require_sound(set, reference.get());
  require_gradient(reference.get());
  {
    const Result again(set);
    FUZZ_REQUIRE(same(reference.get().balls, again.get().balls, set.n()), "shares differ the second time");
    FUZZ_REQUIRE(same(&reference.get().totals, &again.get().totals, 1), "totals differ the second time");
  }
  require_no_order(set, reference.get(), bytes);
  require_derivative(set, reference.get());
  require_capacities(reference.get(), bytes);
  return 0;
}
