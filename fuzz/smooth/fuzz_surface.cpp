// The solvent-excluded surface of any set, with a probe of any size. No area is below 0, and areas add up; the volume
// is between that of the balls and that of the union with the probe; the same bytes twice; no effect of the order of
// the balls; patches, edges and corners refer to each other consistently and add up; the derivative of the volume by
// the probe, inside the same spheres, is minus the area; limits that are too small. All these compare the library with
// itself.
#include <surface_result.h>

#include "computed_set.hpp"
#include "owned_surfaces.hpp"
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
  surface_result &get() { return surface_; }

 private:
  fuzz::ComputedSet set_;
  surface_result surface_{};
};

// A length of the set, to which errors are relative.
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

// sigma may be null.
Gradient gradient_of(const surface_result &s, const double *sigma, double tension, double pressure) {
  const uint32_t n = s.base->n;
  Gradient g{{}, std::vector<double>(3 * size_t{n}), std::vector<double>(n), std::vector<uint32_t>(n)};
  hsp_gradient_request request{};
  request.struct_size = sizeof request;
  request.tangency = HSP_TANGENT_OVERLAP;
  request.tension = tension;
  request.pressure = pressure;
  request.sigma = sigma;
  hsp_gradient_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = n;
  outputs.energy = &g.energy;
  outputs.d_centre = g.centre.data();
  outputs.d_radius = g.radius.data();
  outputs.flags = g.flags.data();
  const int32_t status = hsp_surface_get_gradient(s.surface, &request, &outputs);
  FUZZ_REQUIRE(status == HSP_OK, hsp_status_text(status));
  return g;
}

// hsp_surface_get_gradient, properties 1, 2 and 4, and property 1 for weights. Near vertices of three spheres that
// hardly meet, terms of any size cancel.
void require_gradient(const surface_result &s) {
  for (const bool of_volume : {false, true}) {
    const Gradient g = gradient_of(s, nullptr, of_volume ? 0 : 1, of_volume ? 1 : 0);
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

// Patches, edges and corners: the library's own check holds, and the records agree with each other and with the totals.
void require_map(const surface_result &s, const hsp_boundary_counts &boundary) {
  hsp_surface *surface = s.surface;
  uint32_t invariant = 0, id = 0;
  FUZZ_REQUIRE(s.counts.open_joints == 0, "an open joint");
  FUZZ_REQUIRE(hsp_surface_check(surface, &invariant, &id) == HSP_OK && invariant == 0, "hsp_surface_check");
  hsp_surface_part_counts counts;
  FUZZ_REQUIRE(hsp_surface_get_part_counts(surface, &counts) == HSP_OK, "counts of the map");
  std::vector<hsp_surface_patch> patches(counts.patches);
  std::vector<hsp_surface_edge> edges(counts.edges);
  std::vector<hsp_surface_corner> corners(counts.corners);
  std::vector<hsp_surface_shell> shells(counts.shells);
  uint32_t needed = 0;
  FUZZ_REQUIRE(hsp_surface_get_patches(surface, 0, counts.patches, patches.data()) == HSP_OK, "patches");
  FUZZ_REQUIRE(hsp_surface_get_edges(surface, 0, counts.edges, edges.data()) == HSP_OK, "edges");
  FUZZ_REQUIRE(hsp_surface_get_corners(surface, 0, counts.corners, corners.data()) == HSP_OK, "corners");
  FUZZ_REQUIRE(hsp_surface_get_shells(surface, shells.data(), counts.shells, &needed) == HSP_OK, "shells");
  double area = 0, volume = 0;
  uint32_t loop_edges = 0, of_shells = 0, left_over = 0;
  for (const hsp_surface_patch &patch : patches) {
    area += patch.area;
    loop_edges += patch.edges;
    left_over += patch.shell != HSP_NONE ? 1 : 0;
    FUZZ_REQUIRE(patch.kind != HSP_PATCH_CONVEX || patch.source < boundary.faces, "a convex patch");
    if (patch.h != HSP_NONE) {
      FUZZ_REQUIRE(&patches[hsp_surface_left(surface, patch.h)] == &patch, "a patch and its edge");
      FUZZ_REQUIRE(hsp_surface_left(surface, hsp_surface_next_loop(surface, patch.h)) ==
                       static_cast<uint32_t>(&patch - patches.data()),
                   "the loops of a patch");
    }
  }
  FUZZ_REQUIRE(loop_edges == 2 * counts.edges, "every edge has two patches");
  for (uint32_t e = 0; e < counts.edges; ++e) {
    for (uint32_t side = 0; side < 2; ++side) {
      const uint32_t next = edges[e].next[side];
      FUZZ_REQUIRE(next == hsp_surface_next(surface, 2 * e + side), "next");
      FUZZ_REQUIRE(edges[e].previous[side] == hsp_surface_previous(surface, 2 * e + side), "previous");
      FUZZ_REQUIRE(edges[e].corner[side] == hsp_surface_origin(surface, 2 * e + side), "origin");
      FUZZ_REQUIRE(edges[next / 2].patch[next % 2] == edges[e].patch[side], "one patch");
      FUZZ_REQUIRE(edges[next / 2].corner[next % 2] == edges[e].corner[1 - side], "from corner to corner");
      FUZZ_REQUIRE(patches[edges[e].patch[0]].shell == patches[edges[e].patch[1]].shell, "one shell");
      const uint32_t corner = edges[e].corner[side];
      if (corner != HSP_NONE) FUZZ_REQUIRE(corners[corner].shell == patches[edges[e].patch[0]].shell, "its corners");
    }
  }
  const double tolerance = 1e-6 * (1.0 + s.base->totals.area) * extent_of(s);
  double shell_area = 0;
  for (const hsp_surface_shell &shell : shells) {
    shell_area += shell.area;
    volume += shell.volume;
    of_shells += shell.patches;
    FUZZ_REQUIRE(shell.euler == 2 - 2 * static_cast<int32_t>(shell.genus), "genus");
  }
  FUZZ_REQUIRE(of_shells == left_over, "every patch in one shell");
  FUZZ_REQUIRE(std::fabs(area - s.totals.area) <= tolerance, "areas of patches do not add up");
  FUZZ_REQUIRE(std::fabs(shell_area - s.totals.area) <= tolerance, "areas of shells do not add up");
  FUZZ_REQUIRE(std::fabs(volume - s.totals.volume) <= tolerance * extent_of(s), "volumes of shells do not add up");
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
  std::vector<double> sigma(set.n()), permuted(set.n());
  for (uint32_t i = 0; i < set.n(); ++i) sigma[i] = 0.75 * (i % 4) - 1;
  for (uint32_t i = 0; i < set.n(); ++i) permuted[i] = sigma[order[i]];
  const Gradient here = gradient_of(reference, sigma.data(), 0.75, 0.25);
  const Gradient there = gradient_of(other.get(), permuted.data(), 0.75, 0.25);
  for (uint32_t i = 0; i < set.n(); ++i) {
    FUZZ_REQUIRE(same(&there.centre[3 * size_t{i}], &here.centre[3 * size_t{order[i]}], 3), "a gradient differs");
    FUZZ_REQUIRE(same(&there.radius[i], &here.radius[order[i]], 1), "a derivative by a radius differs");
    FUZZ_REQUIRE(there.flags[i] == here.flags[order[i]], "a flag differs");
  }
  FUZZ_REQUIRE(same(&other.get().counts, &reference.counts, 1), "counts differ in another order");
}

// hsp_surface_compute_shells, property 1. And the shells in two parts, each chosen and measured alone: their convex and
// saddle patches together must have the areas of the whole, up to rounding.
void require_parts(surface_result &s, fuzz::Bytes &bytes) {
  const uint32_t count = s.base->counts.shells;
  std::vector<uint32_t> parts[2], all;
  for (uint32_t shell = 0; shell < count; ++shell) {
    parts[bytes.below(2)].push_back(shell);
    all.push_back(shell);
  }
  hsp_surface_limits most = s.needed;
  const auto measured = [&](const std::vector<uint32_t> &shells) {
    const int32_t status = hsp_surface_compute_shells(s.surface, s.base->boundary, shells.data(),
                                                      static_cast<uint32_t>(shells.size()), &most);
    hsp_surface_totals totals{};
    if (status == HSP_E_CAPACITY) return totals;
    FUZZ_REQUIRE(status == HSP_OK, hsp_status_text(status));
    uint32_t invariant = 0, id = 0;
    FUZZ_REQUIRE(hsp_surface_check(s.surface, &invariant, &id) == HSP_OK, "a part is no map");
    FUZZ_REQUIRE(hsp_surface_measure(s.surface, &totals, nullptr, 0, nullptr) == HSP_OK, "a part has no area");
    return totals;
  };
  const hsp_surface_totals first = measured(parts[0]), second = measured(parts[1]);
  const double tolerance = 1e-6 * (1.0 + s.base->totals.area) * extent_of(s);
  if (first.area + second.area > 0) {
    FUZZ_REQUIRE(first.convex_area + second.convex_area <= s.totals.convex_area + tolerance, "convex patches of parts");
    FUZZ_REQUIRE(first.saddle_area + second.saddle_area <= s.totals.saddle_area + tolerance, "saddles of parts");
  }
  const hsp_surface_totals together = measured(all);
  FUZZ_REQUIRE(same(&together, &s.totals, 1), "all shells are not the whole");
}

// V' = -A: the difference quotient of the volume must lie between the areas at both ends, up to the change of the
// areas.
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
  Result reference(set);
  require_sound(set, reference.get());
  require_gradient(reference.get());
  require_map(reference.get(), reference.get().base->counts);
  {
    const Result again(set);
    FUZZ_REQUIRE(same(reference.get().balls, again.get().balls, set.n()), "shares differ the second time");
    FUZZ_REQUIRE(same(&reference.get().totals, &again.get().totals, 1), "totals differ the second time");
  }
  require_no_order(set, reference.get(), bytes);
  require_derivative(set, reference.get());
  require_capacities(reference.get(), bytes);
  require_parts(reference.get(), bytes);
  return 0;
}
