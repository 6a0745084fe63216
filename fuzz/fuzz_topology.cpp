// The topology of any set: every promise of the header about its records, by the invariants of tests/api/support; the
// same bytes twice; no effect of the order of the balls; limits that are too small; each component on its own; and the
// regions of points against free lines between points, which are found from the balls in integers.
#include <topology_invariants.h>

#include <map>

#include "computed_set.hpp"
#include "guarded_output.hpp"
#include "required_limits.hpp"
#include "topology_input.hpp"

namespace {

using fuzz::same;

class Result {
 public:
  explicit Result(const fuzz::ScaledBalls &set) : set_(set) {
    const int32_t status = topology_result_make(&set_.get(), &topology_);
    FUZZ_REQUIRE(status == HSP_OK, hsp_status_text(status));
  }
  ~Result() { topology_result_release(&topology_); }
  Result(const Result &) = delete;
  Result &operator=(const Result &) = delete;

  const topology_result &get() const { return topology_; }
  hsp_topology *topology() const { return topology_.topology; }

 private:
  fuzz::ComputedSet set_;
  topology_result topology_{};
};

void require_sound(const topology_result &t) {
  const char *broken = broken_topology(&t);
  FUZZ_REQUIRE(broken == nullptr, broken);
}

void require_same_bytes(const topology_result &a, const topology_result &b) {
  FUZZ_REQUIRE(std::memcmp(&a.counts, &b.counts, sizeof a.counts) == 0, "counts differ the second time");
  FUZZ_REQUIRE(same(a.onext, b.onext, 4 * a.counts.edges), "onext differs the second time");
  FUZZ_REQUIRE(same(a.origin, b.origin, 4 * a.counts.edges), "origin differs the second time");
  FUZZ_REQUIRE(same(a.vertices, b.vertices, a.counts.vertices), "vertices differ the second time");
  FUZZ_REQUIRE(same(a.edges, b.edges, a.counts.edges), "edges differ the second time");
  FUZZ_REQUIRE(same(a.faces, b.faces, a.counts.simple_faces), "simple faces differ the second time");
  FUZZ_REQUIRE(same(a.shells, b.shells, a.counts.shells), "shells differ the second time");
  FUZZ_REQUIRE(same(a.components, b.components, a.counts.components), "components differ the second time");
  FUZZ_REQUIRE(same(a.regions, b.regions, a.counts.regions), "regions differ the second time");
}

// hsp_topology_compute, property 1.
void require_no_order(const fuzz::ScaledBalls &set, const topology_result &reference, fuzz::Bytes &bytes) {
  const Result other(fuzz::permuted(set, fuzz::shuffled(set.n(), bytes)));
  require_sound(other.get());
  const char *what = topology_difference_after_permutation(&reference, &other.get());
  FUZZ_REQUIRE(what == nullptr, what);
}

// Each component on its own gives its shells: as many of each kind, Euler number and number of maximal faces.
void require_components_alone(const fuzz::ScaledBalls &set, const topology_result &reference) {
  if (reference.counts.components < 2) return;
  for (uint32_t k = 0; k < reference.counts.components; ++k) {
    fuzz::ScaledBalls part = set;
    part.balls.clear();
    for (uint32_t i = 0; i < set.n(); ++i) {
      if (reference.base->balls[i].component == k) part.balls.push_back(set.balls[i]);
    }
    const Result alone(part);
    std::map<std::array<int64_t, 5>, int> balance;
    const auto key = [](const hsp_shell &s) {
      return std::array<int64_t, 5>{s.kind, s.euler, s.faces, s.simple_faces, s.edges};
    };
    for (uint32_t s = 0; s < reference.counts.shells; ++s) {
      if (reference.shells[s].component == k) ++balance[key(reference.shells[s])];
    }
    for (uint32_t s = 0; s < alone.get().counts.shells; ++s) --balance[key(alone.get().shells[s])];
    for (const auto &entry : balance) FUZZ_REQUIRE(entry.second == 0, "shells of a component on its own");
  }
}

void require_capacities(const topology_result &reference, fuzz::Bytes &bytes) {
  const auto compute = [&](hsp_topology *topology, hsp_topology_limits *limits) {
    return hsp_topology_compute(topology, reference.base->boundary, limits);
  };
  const auto read = [&](const hsp_topology *topology) {
    hsp_topology_counts counts{};
    const int32_t status = hsp_topology_get_counts(topology, &counts);
    if (status == HSP_OK)
      FUZZ_REQUIRE(std::memcmp(&counts, &reference.counts, sizeof counts) == 0, "counts differ with more room");
    return status;
  };
  fuzz::require_limits<support::TopologyKind>(reference.needed, bytes, compute, read);
}

// ---- points ----

using Place = oracle::LatticePoint;

bool in_ball(const fuzz::ScaledBalls &set, size_t i, const Place &at) {
  const oracle::Vector from_centre = centre_difference(set.balls[i], oracle::ball_around(at, 0));
  return oracle::dot(from_centre, from_centre) <= set.radius_of(i) * set.radius_of(i);
}

// Whether the line from a to b, which differ along one axis, misses every closed ball.
bool line_is_free(const fuzz::ScaledBalls &set, const Place &a, const Place &b) {
  for (size_t i = 0; i < set.balls.size(); ++i) {
    Place nearest = centre_of(set.balls[i]);
    for (size_t axis = 0; axis < 3; ++axis) {
      nearest[axis] = std::clamp(nearest[axis], std::min(a[axis], b[axis]), std::max(a[axis], b[axis]));
    }
    if (in_ball(set, i, nearest)) return false;
  }
  return true;
}

std::array<double, 3> lengths(const fuzz::ScaledBalls &set, const Place &at) {
  return {set.length(at[0]), set.length(at[1]), set.length(at[2])};
}

// The region of a point; checked against the balls.
uint32_t region_of(const fuzz::ScaledBalls &set, const Result &result, const Place &at) {
  bool inside = false;
  for (uint32_t i = 0; i < set.n(); ++i) inside = inside || in_ball(set, i, at);
  uint32_t region = 12345;
  FUZZ_REQUIRE(hsp_topology_locate(result.topology(), lengths(set, at).data(), &region) == HSP_OK,
               "hsp_topology_locate");
  FUZZ_REQUIRE((region == HSP_NONE) == inside, "in a region exactly if in no ball");
  FUZZ_REQUIRE(region == HSP_NONE || region < result.get().counts.regions, "no such region");
  return region;
}

// Near a ball of the set, mostly between it and another.
Place some_place(const fuzz::ScaledBalls &set, fuzz::Bytes &bytes) {
  Place at{};
  const int64_t unit = set.steps_per_unit;
  if (set.n() > 0) {
    const Place a = centre_of(set.balls[bytes.below(set.n())]), b = centre_of(set.balls[bytes.below(set.n())]);
    for (size_t axis = 0; axis < 3; ++axis) at[axis] = (a[axis] + b[axis]) / 2;
  }
  for (int64_t &coordinate : at) coordinate += (bytes.below(15) - int64_t{7}) * unit + bytes.below(3) - 1;
  return at;
}

void require_places(const fuzz::ScaledBalls &set, const Result &result, fuzz::Bytes &bytes) {
  static constexpr int64_t far_away = int64_t{1} << 22;
  Place before{};
  uint32_t before_region = HSP_NONE;
  for (int k = 0; k < 16; ++k) {
    const Place at = some_place(set, bytes);
    const uint32_t region = region_of(set, result, at);
    if (region != 0 && region != HSP_NONE) {
      for (size_t axis = 0; axis < 3; ++axis) {
        for (const int64_t end : {-far_away, far_away}) {
          Place away = at;
          away[axis] = end;
          FUZZ_REQUIRE(!line_is_free(set, at, away), "a free way out, but not in the outer region");
        }
      }
    }
    if (k > 0 && region != before_region) {
      // from `before` to `at` along x, y and z in turn
      const Place first{at[0], before[1], before[2]}, second{at[0], at[1], before[2]};
      const bool joined =
          line_is_free(set, before, first) && line_is_free(set, first, second) && line_is_free(set, second, at);
      FUZZ_REQUIRE(!joined, "joined by a free way, but in different regions");
    }
    before = at;
    before_region = region;
  }
  FUZZ_REQUIRE(region_of(set, result, {far_away, 0, 0}) == 0, "far away, but not in the outer region");
}

// Places all over a box around the balls, joined along the axes wherever that is free: what is joined is one region,
// and what the box's surface reaches is the outer one.
void require_flood(const fuzz::ScaledBalls &set, const Result &result) {
  int64_t spacing = set.steps_per_unit;
  Place low{}, high{};
  for (size_t axis = 0; axis < 3; ++axis) {
    low[axis] = std::numeric_limits<int64_t>::max();
    high[axis] = std::numeric_limits<int64_t>::min();
    for (size_t i = 0; i < set.balls.size(); ++i) {
      low[axis] = std::min(low[axis], centre_of(set.balls[i])[axis] - set.radius_of(i));
      high[axis] = std::max(high[axis], centre_of(set.balls[i])[axis] + set.radius_of(i));
    }
    spacing = std::max(spacing, (high[axis] - low[axis]) / 16 + 1);
  }
  for (int64_t &coordinate : low) coordinate -= 1 + spacing / 3;
  std::map<Place, uint32_t> regions;
  for (int64_t x = low[0]; x <= high[0] + spacing; x += spacing) {
    for (int64_t y = low[1]; y <= high[1] + spacing; y += spacing) {
      for (int64_t z = low[2]; z <= high[2] + spacing; z += spacing) {
        const Place at{x, y, z};
        const uint32_t region = region_of(set, result, at);
        regions[at] = region;
        bool border = false;
        for (size_t axis = 0; axis < 3; ++axis) {
          border = border || at[axis] == low[axis] || at[axis] > high[axis];
          Place neighbour = at;
          neighbour[axis] -= spacing;
          const auto there = regions.find(neighbour);
          if (there == regions.end() || there->second == region) continue;
          FUZZ_REQUIRE(!line_is_free(set, neighbour, at),
                       "neighbours in the box joined by a free line, but in different regions");
        }
        if (border) FUZZ_REQUIRE(region == 0, "on the box's surface, but not in the outer region");
      }
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const bool flood = bytes.one_in(6);
  const fuzz::ScaledBalls set = fuzz::topology_set(bytes);
  const Result reference(set);
  require_sound(reference.get());
  {
    const Result again(set);
    require_same_bytes(reference.get(), again.get());
  }
  require_no_order(set, reference.get(), bytes);
  require_components_alone(set, reference.get());
  require_capacities(reference.get(), bytes);
  require_places(set, reference, bytes);
  if (flood && set.n() > 0) require_flood(set, reference);
  return 0;
}
