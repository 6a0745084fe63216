// The boundary of any set: every promise of the header about its records, checked by the invariants of
// tests/api/support; the same bytes twice; and no effect of the order of the balls, of a translation, of exchanged axes
// and of how the work is split.
#include <boundary_invariants.h>

#include "computed_set.hpp"

namespace {

using fuzz::close;
using fuzz::same;
using Result = fuzz::ComputedSet;

void require_sound(const computed &c) {
  const char *broken = broken_boundary(&c);
  FUZZ_REQUIRE(broken == nullptr, broken);
}

void require_same_bytes(const computed &a, const computed &b) {
  FUZZ_REQUIRE(std::memcmp(&a.counts, &b.counts, sizeof a.counts) == 0, "counts differ the second time");
  FUZZ_REQUIRE(same(a.vertices, b.vertices, a.counts.vertices), "vertices differ the second time");
  FUZZ_REQUIRE(same(a.arcs, b.arcs, a.counts.arcs), "arcs differ the second time");
  FUZZ_REQUIRE(same(a.circles, b.circles, a.counts.circles), "circles differ the second time");
  FUZZ_REQUIRE(same(a.faces, b.faces, a.counts.faces), "faces differ the second time");
  FUZZ_REQUIRE(same(a.balls, b.balls, a.n), "balls differ the second time");
  FUZZ_REQUIRE(same(a.area, b.area, a.n) && same(a.volume, b.volume, a.n), "areas differ the second time");
  FUZZ_REQUIRE(same(&a.totals, &b.totals, 1), "totals differ the second time");
}

// hsp_model_set, hsp_boundary_compute and hsp_boundary_measure, property 1 each.
void require_no_order(const fuzz::ScaledBalls &set, const computed &reference, fuzz::Bytes &bytes) {
  const std::vector<uint32_t> order = fuzz::shuffled(set.n(), bytes);
  const Result other(fuzz::permuted(set, order));
  require_sound(other.get());
  const char *what = boundary_difference_after_permutation(&reference, &other.get(), order.data());
  FUZZ_REQUIRE(what == nullptr, what);
}

void require_no_place(const fuzz::ScaledBalls &set, const computed &reference, fuzz::Bytes &bytes) {
  oracle::LatticePoint shift{};
  for (int64_t &along : shift) {
    const int64_t steps = bytes.below(1001) - int64_t{500};
    along = steps * (bytes.one_in(2) ? set.steps_per_unit : 1);
  }
  fuzz::ScaledBalls moved = set;
  moved.balls = oracle::moved(set.balls, shift);
  const Result other(moved);
  require_sound(other.get());
  const computed &c = other.get();
  FUZZ_REQUIRE(std::memcmp(&c.counts, &reference.counts, sizeof c.counts) == 0, "counts differ at another place");
  for (uint32_t i = 0; i < set.n(); ++i) {
    FUZZ_REQUIRE(c.balls[i].faces == reference.balls[i].faces, "faces of a ball differ at another place");
    FUZZ_REQUIRE(c.balls[i].flags == reference.balls[i].flags, "flags of a ball differ at another place");
    FUZZ_REQUIRE(close(c.area[i], reference.area[i]), "area of a ball differs at another place");
  }
  FUZZ_REQUIRE(close(reference.totals.volume, c.totals.volume), "volume differs at another place");
}

// Ties may be broken in another way when axes are exchanged; the topology of the closed balls must stay.
void require_no_axes(const fuzz::ScaledBalls &set, const computed &reference, fuzz::Bytes &bytes) {
  fuzz::ScaledBalls turned = set;
  const uint32_t turn = 1 + bytes.below(2);
  const uint32_t reflected = bytes.below(2) == 0 ? 0 : 7;
  turned.balls = oracle::along_axes(set.balls, {turn, (1 + turn) % 3, (2 + turn) % 3}, reflected);
  const Result other(turned);
  require_sound(other.get());
  const hsp_boundary_counts &counts = other.get().counts;
  FUZZ_REQUIRE(counts.components == reference.counts.components, "components differ with other axes");
  FUZZ_REQUIRE(counts.voids == reference.counts.voids, "voids differ with other axes");
  FUZZ_REQUIRE(counts.euler == reference.counts.euler, "euler differs with other axes");
  FUZZ_REQUIRE(close(reference.totals.area, other.get().totals.area), "area differs with other axes");
  FUZZ_REQUIRE(close(reference.totals.volume, other.get().totals.volume), "volume differs with other axes");
}

// Each component on its own gives its part of everything.
void require_sum_over_components(const fuzz::ScaledBalls &set, const computed &reference) {
  if (reference.counts.components < 2) return;
  hsp_boundary_counts sum{};
  double area = 0, volume = 0;
  for (uint32_t k = 0; k < reference.counts.components; ++k) {
    fuzz::ScaledBalls part = set;
    part.balls.clear();
    for (uint32_t i = 0; i < set.n(); ++i) {
      if (reference.balls[i].component == k) part.balls.push_back(set.balls[i]);
    }
    const Result result(part);
    const computed &c = result.get();
    FUZZ_REQUIRE(c.counts.components == 1, "a component falls apart on its own");
    sum.vertices += c.counts.vertices;
    sum.circles += c.counts.circles;
    sum.faces += c.counts.faces;
    sum.loops += c.counts.loops;
    sum.voids += c.counts.voids;
    sum.contained_balls += c.counts.contained_balls;
    sum.euler += c.counts.euler;
    area += c.totals.area;
    volume += c.totals.volume;
  }
  const hsp_boundary_counts &all = reference.counts;
  FUZZ_REQUIRE(sum.vertices == all.vertices && sum.circles == all.circles, "vertices or circles of the components");
  FUZZ_REQUIRE(sum.faces == all.faces && sum.loops == all.loops, "faces or loops of the components");
  FUZZ_REQUIRE(sum.voids == all.voids && sum.euler == all.euler, "voids or euler of the components");
  FUZZ_REQUIRE(sum.contained_balls == all.contained_balls, "contained balls of the components");
  FUZZ_REQUIRE(close(reference.totals.area, area) && close(reference.totals.volume, volume), "area of the components");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const fuzz::ScaledBalls set = fuzz::ball_set(bytes, 32);
  const Result reference(set);
  require_sound(reference.get());
  {
    Result again(set);
    require_same_bytes(reference.get(), again.get());
    again.compute_by_workers(1 + bytes.below(8), bytes);
    require_same_bytes(reference.get(), again.get());
    FUZZ_REQUIRE(same(&reference.get().needed, &again.get().needed, 1), "needed limits differ with the workers");
  }
  require_no_order(set, reference.get(), bytes);
  require_no_place(set, reference.get(), bytes);
  require_no_axes(set, reference.get(), bytes);
  require_sum_over_components(set, reference.get());
  return 0;
}
