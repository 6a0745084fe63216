// Pores of any set. Against brute force in integers: maxima and gates of few balls, also where balls tie. Against other
// parts of the library: classes at a probe against the regions of free space around grown balls, for points and in
// number; regions beside the balls against the nesting of shells; the widest probe between two points against free
// space as cells; sizes of pockets with plugs against blocked regions. The tree, pockets and tunnels fit together; no
// effect of the order of the balls; limits that are too small.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "brute_pores.hpp"
#include "computed_set.hpp"
#include "owned_spaces.hpp"
#include "probe_by_cells.hpp"
#include "required_limits.hpp"
#include "topology_input.hpp"

namespace {

using Point = std::array<double, 3>;

constexpr uint32_t most_balls = 12;

struct Result {
  hsp_pores_counts counts{};
  hsp_pores_limits needed{};
  std::vector<hsp_pore_maximum> maxima;
  std::vector<hsp_pore_gate> gates;
};

hsp_pores_options with_floor(double floor) {
  hsp_pores_options options;
  FUZZ_REQUIRE(hsp_pores_options_init(&options, sizeof options) == HSP_OK, "hsp_pores_options_init");
  options.floor = floor;
  return options;
}

Result read(const hsp_pores *pores) {
  Result result;
  FUZZ_REQUIRE(hsp_pores_get_counts(pores, &result.counts) == HSP_OK, "counts");
  result.maxima.resize(result.counts.maxima);
  result.gates.resize(result.counts.gates);
  FUZZ_REQUIRE(hsp_pores_get_maxima(pores, 0, result.counts.maxima, result.maxima.data()) == HSP_OK, "maxima");
  FUZZ_REQUIRE(hsp_pores_get_gates(pores, 0, result.counts.gates, result.gates.data()) == HSP_OK, "gates");
  return result;
}

Result compute(const hsp_model *model, uint32_t n, const hsp_pores_options &options,
               support::OwnedHandle<support::PoresKind> &pores) {
  hsp_pores_limits limits;
  FUZZ_REQUIRE(hsp_pores_limits_init(&limits, sizeof limits, n) == HSP_OK, "hsp_pores_limits_init");
  pores.take(limits);
  pores.compute(
      [&](hsp_pores *handle, hsp_pores_limits *asked) { return hsp_pores_compute(handle, model, &options, asked); });
  Result result = read(pores.get());
  result.needed = pores.needed();
  return result;
}

bool same_levels(const Result &a, const Result &b) {
  const auto same = [](const auto &p, const auto &q) { return p.radius == q.radius; };
  return std::memcmp(&a.counts, &b.counts, sizeof a.counts) == 0 &&
         std::equal(a.maxima.begin(), a.maxima.end(), b.maxima.begin(), b.maxima.end(), same) &&
         std::equal(a.gates.begin(), a.gates.end(), b.gates.begin(), b.gates.end(), same);
}

bool same_bits(const Result &a, const Result &b) {
  const auto same = [](const auto &p, const auto &q) { return std::memcmp(&p, &q, sizeof p) == 0; };
  return std::memcmp(&a.counts, &b.counts, sizeof a.counts) == 0 &&
         std::equal(a.maxima.begin(), a.maxima.end(), b.maxima.begin(), b.maxima.end(), same) &&
         std::equal(a.gates.begin(), a.gates.end(), b.gates.begin(), b.gates.end(), same);
}

double distance(const fuzz::ScaledBalls &set, const double *xyz, uint32_t ball) {
  const oracle::LatticeBall &b = set.balls[ball];
  return std::hypot(xyz[0] - set.length(b.x), xyz[1] - set.length(b.y), xyz[2] - set.length(b.z)) -
         set.length(set.radius_of(ball));
}

double nearest(const fuzz::ScaledBalls &set, const double *xyz) {
  double least = INFINITY;
  for (uint32_t i = 0; i < set.n(); ++i) least = std::min(least, distance(set, xyz, i));
  return least;
}

// The allowed error: that of doubles of this size, and a lattice step.
double error_of(const fuzz::ScaledBalls &set, double size) {
  return 2.0 * set.step() + 1e-12 * std::fabs(size);
}

void require_sound(const fuzz::ScaledBalls &set, const Result &result, const hsp_pores *pores, double floor) {
  const auto outside = HSP_PORE_OUTSIDE;
  uint32_t merges = 0;
  for (uint32_t k = 0; k < result.counts.gates; ++k) {
    const hsp_pore_gate &gate = result.gates[k];
    merges += gate.merges;
    FUZZ_REQUIRE(gate.radius > floor - set.step(), "a gate above the floor");
    FUZZ_REQUIRE(std::fabs(nearest(set, gate.xyz) - gate.radius) <= error_of(set, gate.radius), "radius at a gate");
    for (const uint32_t end : gate.end) {
      FUZZ_REQUIRE(end == outside || end < result.counts.maxima, "an end of a gate");
      FUZZ_REQUIRE(end == outside || result.maxima[end].radius >= gate.radius, "an end is wider");
    }
    for (const uint32_t ball : gate.ball) {
      FUZZ_REQUIRE(std::fabs(distance(set, gate.xyz, ball) - gate.radius) <= error_of(set, gate.radius), "its balls");
    }
  }
  FUZZ_REQUIRE(merges == result.counts.merges, "merges");
  FUZZ_REQUIRE(result.counts.cavities == result.counts.maxima - merges, "cavities");
  for (uint32_t k = 0; k < result.counts.maxima; ++k) {
    const hsp_pore_maximum &maximum = result.maxima[k];
    FUZZ_REQUIRE(std::fabs(nearest(set, maximum.xyz) - maximum.radius) <= error_of(set, maximum.radius), "its radius");
    FUZZ_REQUIRE(k == 0 || maximum.radius <= result.maxima[k - 1].radius + error_of(set, maximum.radius),
                 "their order");
    uint32_t balls[64], needed = 0;
    const int32_t status = hsp_pores_get_maximum_balls(pores, k, balls, 64, &needed);
    FUZZ_REQUIRE(needed >= 4 && status == (needed > 64 ? HSP_E_CAPACITY : HSP_OK), "its balls");
    uint32_t gate = 0;
    FUZZ_REQUIRE(hsp_pores_gate_between(pores, k, outside, &gate) == HSP_OK, "its way out");
    if (maximum.gate == HSP_NONE) {
      FUZZ_REQUIRE(maximum.parent == HSP_NONE && gate == HSP_NONE, "a cavity has no way out");
      continue;
    }
    FUZZ_REQUIRE(maximum.parent == outside || maximum.parent < k, "a parent is older");
    FUZZ_REQUIRE(result.gates[maximum.gate].merges == 1 && maximum.death == result.gates[maximum.gate].radius, "death");
    FUZZ_REQUIRE(gate >= maximum.gate || gate == HSP_NONE, "the way out is no wider");
  }
}

void require_brute_force(const fuzz::ScaledBalls &set, const Result &result, const hsp_pores *pores, int64_t floor) {
  const oracle::Balls all = set.with_probe(), outer = oracle::outer_balls(all);
  if (outer.size() > 10) return;
  oracle::ListedPores listed;
  const auto list = [&](auto get, uint32_t count, auto &lists) {
    for (uint32_t k = 0; k < count; ++k) {
      uint32_t balls[10], needed = 0;
      FUZZ_REQUIRE(get(pores, k, balls, 10, &needed) == HSP_OK, "its balls");
      lists.emplace_back();
      for (uint32_t b = 0; b < needed; ++b) {
        const auto own = std::find(outer.begin(), outer.end(), all[balls[b]]);
        FUZZ_REQUIRE(std::find(all.begin(), all.end(), *own) - all.begin() == balls[b], "the first of equal balls");
        lists.back().push_back(static_cast<uint32_t>(own - outer.begin()));
      }
    }
  };
  list(hsp_pores_get_maximum_balls, result.counts.maxima, listed.maxima);
  list(hsp_pores_get_gate_balls, result.counts.gates, listed.gates);
  const uint32_t outside = result.counts.maxima;
  for (const hsp_pore_gate &gate : result.gates) {
    listed.ends.push_back({std::min(gate.end[0], outside), std::min(gate.end[1], outside)});
  }
  listed.gate_between = [&](size_t a, size_t b) {
    const auto end = [&](size_t k) { return k == outside ? HSP_PORE_OUTSIDE : static_cast<uint32_t>(k); };
    uint32_t gate = 0;
    FUZZ_REQUIRE(hsp_pores_gate_between(pores, end(a), end(b), &gate) == HSP_OK, "gate between");
    return gate;
  };
  const std::string difference = oracle::first_difference(oracle::brute_pores(outer, floor), listed);
  FUZZ_REQUIRE(difference.empty(), difference.c_str());
}

// Compares classes and regions at a level that is not near any maximum or gate.
void require_regions(const fuzz::ScaledBalls &set, const Result &result, hsp_pores *pores, int64_t level,
                     fuzz::Bytes &bytes) {
  const double radius = set.length(level);
  for (const auto &maximum : result.maxima) {
    if (std::fabs(maximum.radius - radius) < error_of(set, radius)) return;
  }
  for (const auto &gate : result.gates) {
    if (std::fabs(gate.radius - radius) < error_of(set, radius)) return;
  }
  fuzz::ScaledBalls grown = set;
  grown.probe_steps += level;
  for (uint32_t i = 0; i < grown.n(); ++i) {
    if (grown.radius_of(i) >= INT64_C(1) << 30) return;
  }
  const fuzz::ComputedSet base(grown);
  support::OwnedHandle<support::CellsKind> cells;
  hsp_cells_limits limits;
  FUZZ_REQUIRE(hsp_cells_limits_init(&limits, sizeof limits, set.n()) == HSP_OK, "hsp_cells_limits_init");
  cells.take(limits);
  cells.compute(
      [&](hsp_cells *handle, hsp_cells_limits *asked) { return hsp_cells_compute(handle, base.get().model, asked); });
  hsp_cells_counts counts{};
  FUZZ_REQUIRE(hsp_cells_get_counts(cells.get(), &counts) == HSP_OK, "counts of cells");
  std::set<uint32_t> classes{HSP_PORE_OUTSIDE};
  for (uint32_t k = 0; k < result.counts.maxima; ++k) {
    uint32_t member = 0;
    FUZZ_REQUIRE(hsp_pores_class_at(pores, k, radius, &member) == HSP_OK, "class");
    FUZZ_REQUIRE((member == HSP_NONE) == (result.maxima[k].radius < radius), "whether it fits");
    if (member != HSP_NONE) classes.insert(member);
  }
  FUZZ_REQUIRE(classes.size() == counts.regions, "classes are the regions");
  uint32_t pockets = 0;
  FUZZ_REQUIRE(hsp_pores_find_pockets(pores, radius, radius, &pockets) == HSP_OK, "pockets");
  FUZZ_REQUIRE(pockets + 1 == counts.regions, "pockets are the cavities");
  std::map<uint32_t, uint32_t> region_of;
  for (int k = 0; k < 6; ++k) {
    Point xyz{};
    for (double &x : xyz) x = set.length((static_cast<int64_t>(bytes.below(4000)) - 2000) * (1 + bytes.below(8)));
    hsp_pore_place place{};
    uint32_t cell = 0, member = 0;
    FUZZ_REQUIRE(hsp_pores_locate(pores, xyz.data(), &place) == HSP_OK, "locate");
    if (std::fabs(place.radius - radius) < error_of(set, radius)) continue;
    FUZZ_REQUIRE(hsp_cells_locate(cells.get(), xyz.data(), &cell) == HSP_OK, "locate in cells");
    FUZZ_REQUIRE((cell != HSP_NONE) == (place.radius > radius), "whether it is free");
    if (cell == HSP_NONE) continue;
    hsp_free_cell record{};
    FUZZ_REQUIRE(hsp_cells_get_cells(cells.get(), cell, 1, &record) == HSP_OK, "its cell");
    FUZZ_REQUIRE(hsp_pores_class_at(pores, place.maximum, radius, &member) == HSP_OK, "its class");
    FUZZ_REQUIRE((member == HSP_PORE_OUTSIDE) == (record.region == 0), "outside or not");
    const auto known = region_of.insert({member, record.region}).first;
    FUZZ_REQUIRE(known->second == record.region, "one class in two regions");
  }
}

std::vector<double> ascending(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

// Regions of free space beside the balls against those of the library's topology, which nests shells along vertical
// rays. There are none if the balls have too few lattice steps to know them.
void require_free_regions(const computed &base, hsp_pores *pores) {
  hsp_pore_access access{};
  uint32_t count = 0, channels = 0, needed = 0;
  const int32_t status = hsp_pores_find_regions(pores, base.boundary, &access, &count);
  FUZZ_REQUIRE(status == HSP_OK || status == HSP_E_RANGE, "regions");
  const int32_t listed = hsp_pores_get_channels(pores, 0, nullptr, 0, &channels);
  FUZZ_REQUIRE(listed == (channels > 0 ? HSP_E_CAPACITY : HSP_OK), "how many channels");
  support::OwnedTopology topology;
  topology.take(support::topology_limits_for(base.boundary));
  topology.compute([&](hsp_topology *handle, hsp_topology_limits *asked) {
    return hsp_topology_compute(handle, base.boundary, asked);
  });
  hsp_topology_counts counts{};
  FUZZ_REQUIRE(hsp_topology_get_counts(topology.get(), &counts) == HSP_OK, "counts of the topology");
  FUZZ_REQUIRE(channels + 1 == counts.regions, "channels are the regions but the outside");
  if (status != HSP_OK) return;
  FUZZ_REQUIRE(count == counts.regions && access.accessible == 1, "as many regions");
  std::vector<hsp_pore_region> found(count);
  std::vector<hsp_region> nested(count);
  FUZZ_REQUIRE(hsp_pores_get_regions(pores, 0, count, found.data()) == HSP_OK, "the list of regions");
  FUZZ_REQUIRE(hsp_topology_get_regions(topology.get(), nested.data(), count, &needed) == HSP_OK, "nested regions");
  std::vector<double> area[2], volume[2], shells[2];
  for (uint32_t k = 0; k < count; ++k) {
    const bool outside = found[k].maximum == HSP_PORE_OUTSIDE;
    FUZZ_REQUIRE(outside == (k == 0) && outside == std::isinf(found[k].volume), "the outside is the first");
    area[0].push_back(found[k].area);
    area[1].push_back(nested[k].area);
    volume[0].push_back(outside ? 0.0 : found[k].volume);
    volume[1].push_back(nested[k].volume);
    shells[0].push_back(found[k].shells);
    shells[1].push_back(nested[k].shells);
  }
  FUZZ_REQUIRE(shells[0][0] == shells[1][0] && ascending(shells[0]) == ascending(shells[1]), "their shells");
  const auto require_same = [&](const std::vector<double> *values, double tolerance, const char *what) {
    const auto one = ascending(values[0]), other = ascending(values[1]);
    for (uint32_t k = 0; k < count; ++k) FUZZ_REQUIRE(std::fabs(one[k] - other[k]) <= tolerance, what);
  };
  const double size = base.extent + base.info.largest_radius;
  require_same(area, 1e-9 * size * size, "their areas");
  require_same(volume, 1e-9 * size * size * size, "their volumes");
}

// Balls as they are, with their boundary and pores.
struct PluggedBalls {
  PluggedBalls(const hsp_pores *from, double step) {
    hsp_model_options options;
    FUZZ_REQUIRE(hsp_model_options_init(&options, sizeof options) == HSP_OK, "options");
    options.step = step;
    FUZZ_REQUIRE(hsp_pores_get_plugged_balls(from, nullptr, nullptr, 0, &n) == HSP_OK, "how many balls with plugs");
    std::vector<double> xyz(3 * static_cast<size_t>(n)), radius(n);
    FUZZ_REQUIRE(hsp_pores_get_plugged_balls(from, xyz.data(), radius.data(), n, &n) == HSP_OK, "balls with plugs");
    memory.resize(model_bytes());
    FUZZ_REQUIRE(hsp_model_init(memory.data(), memory.size(), n, &model) == HSP_OK, "their model");
    status = hsp_model_set(model, n, xyz.data(), radius.data(), &options, nullptr);
    FUZZ_REQUIRE(status == HSP_OK || status == HSP_E_RANGE, "a plug is too large, or there is none");
    if (status != HSP_OK) return;
    hsp_boundary_limits limits;
    FUZZ_REQUIRE(hsp_boundary_limits_init(&limits, sizeof limits, n) == HSP_OK, "limits of their boundary");
    boundary.take(limits);
    boundary.compute(
        [&](hsp_boundary *handle, hsp_boundary_limits *asked) { return hsp_boundary_compute(handle, model, asked); });
    hsp_pores_limits pores_limits;
    FUZZ_REQUIRE(hsp_pores_limits_init(&pores_limits, sizeof pores_limits, n) == HSP_OK, "limits of their pores");
    pores.take(pores_limits);
    pores.compute(
        [&](hsp_pores *handle, hsp_pores_limits *asked) { return hsp_pores_compute(handle, model, nullptr, asked); });
  }
  size_t model_bytes() const {
    size_t bytes = 0;
    FUZZ_REQUIRE(hsp_model_bytes(n, &bytes) == HSP_OK, "bytes");
    return bytes;
  }

  uint32_t n = 0;
  int32_t status = HSP_OK;
  std::vector<unsigned char> memory;
  hsp_model *model = nullptr;
  support::OwnedHandle<support::BoundaryKind> boundary;
  support::OwnedHandle<support::PoresKind> pores;
};

// Pockets between two levels: their sizes must be those of blocked regions, also with further plugs in leaks.
void require_pockets(const fuzz::ScaledBalls &set, hsp_pores *pores, int64_t narrow, int64_t wide) {
  uint32_t pockets = 0, before = 0;
  FUZZ_REQUIRE(hsp_pores_find_pockets(pores, set.length(narrow), set.length(wide), &pockets) == HSP_OK, "pockets");
  std::vector<hsp_pore_pocket_size> sizes(pockets);
  std::vector<double> first(pockets, NAN);
  auto plugged = std::make_unique<PluggedBalls>(pores, set.step());
  for (int times = 0;; ++times) {
    if (plugged->status != HSP_OK) return;
    const int32_t status =
        hsp_pores_measure_pockets(pores, plugged->pores.get(), plugged->boundary.get(), sizes.data(), pockets, nullptr);
    if (status == HSP_E_RANGE) return;  // some steps wide
    FUZZ_REQUIRE(status == HSP_OK, "sizes of pockets");
    hsp_pore_access access{};
    FUZZ_REQUIRE(hsp_pores_find_regions(plugged->pores.get(), plugged->boundary.get(), &access, nullptr) == HSP_OK,
                 "their regions");
    double area = 0.0, volume = 0.0;
    bool all_closed = true;
    for (uint32_t k = 0; k < pockets; ++k) {
      const hsp_pore_pocket_size &size = sizes[k];
      FUZZ_REQUIRE((size.closed == 0) == std::isnan(size.volume), "a pocket that is not closed has no volume");
      all_closed = all_closed && size.closed == 1;
      if (size.closed == 0) continue;
      FUZZ_REQUIRE(size.regions > 0 || size.volume == 0.0, "a filled pocket");
      area += size.area + size.plug_area;
      volume += size.volume;
    }
    FUZZ_REQUIRE(area <= access.blocked_area * (1.0 + 1e-9), "areas of pockets are of blocked regions");
    FUZZ_REQUIRE(volume <= access.blocked_volume * (1.0 + 1e-9), "volumes of pockets are of blocked regions");
    before = plugged->n;
    auto next = std::make_unique<PluggedBalls>(plugged->pores.get(), set.step());
    FUZZ_REQUIRE(next->n >= before && (next->n == before || !all_closed), "leaks are of pockets that are not closed");
    // Some pockets have no leak: a plug may turn the way up from all their maxima to the outside.
    if (next->n == before || times == 40) return;
    plugged = std::move(next);
  }
}

// A probe one step narrower than the widest must get from one point to the other, and one two steps wider must not.
void require_widest(const fuzz::ScaledBalls &set, const hsp_pore_passage &passage, int64_t floor, const Point &from,
                    const Point *to) {
  if (set.n() == 0) return;
  support::ProbeByCells cells(set.in_lengths(), set.step());
  const auto may_be_open = [&](int64_t steps, bool expected) {
    const double probe = set.length(set.probe_steps + steps);
    return cells.passes(probe, from.data(), to == nullptr ? nullptr : to->data()).value_or(expected) == expected;
  };
  const auto steps = static_cast<int64_t>(std::floor(passage.radius / set.step()));
  const int64_t narrower = floor == 0 && steps < 1 ? 0 : steps - 1, wider = passage.passes == 1 ? steps + 2 : 0;
  if (passage.passes == 1 && narrower >= 0) FUZZ_REQUIRE(may_be_open(narrower, true), "a narrower probe passes");
  if (wider >= 0) FUZZ_REQUIRE(may_be_open(wider, false), "no wider probe passes");
  FUZZ_REQUIRE(!cells.has_failed(), "cells of grown balls");
}

void require_tunnel(const fuzz::ScaledBalls &set, hsp_pores *pores, int64_t floor, const Point &from, const Point *to) {
  const double *const end = to == nullptr ? nullptr : to->data();
  hsp_pore_passage passage{};
  FUZZ_REQUIRE(hsp_pores_widest(pores, from.data(), end, &passage) == HSP_OK, "widest");
  require_widest(set, passage, floor, from, to);
  hsp_tunnel tunnel{};
  const int32_t status = hsp_pores_find_tunnel(pores, from.data(), end, nullptr, 0, &tunnel, nullptr);
  if (status == HSP_E_CAPACITY) return;
  FUZZ_REQUIRE(status == HSP_OK, "tunnel");
  FUZZ_REQUIRE(tunnel.there == passage.passes && tunnel.radius == passage.radius, "the tunnel is as wide");
  std::vector<hsp_tunnel_point> points(tunnel.points);
  FUZZ_REQUIRE(hsp_pores_get_tunnel_points(pores, points.data(), tunnel.points, nullptr) == HSP_OK, "its points");
  for (const hsp_tunnel_point &point : points) {
    const double there = nearest(set, point.xyz);
    if (set.n() == 0) continue;
    FUZZ_REQUIRE(std::fabs(there - point.radius) <= 4.0 * error_of(set, there), "radius at a point");
    FUZZ_REQUIRE(there >= tunnel.radius - 4.0 * error_of(set, there), "a point is as wide");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  fuzz::ScaledBalls set = fuzz::topology_set(bytes);
  // Few balls alone: if balls have so few lattice steps that all tie, or nearly, the library tries every set of four.
  if (set.n() > most_balls) set.balls.resize(most_balls);
  const fuzz::ComputedSet base(set);
  const hsp_model *const model = base.get().model;
  const int64_t floor = bytes.one_in(2) ? 0 : -static_cast<int64_t>(bytes.below(300));
  const hsp_pores_options options = with_floor(set.length(floor));
  support::OwnedHandle<support::PoresKind> pores;
  const Result reference = compute(model, set.n(), options, pores);
  require_sound(set, reference, pores.get(), set.length(floor));
  require_brute_force(set, reference, pores.get(), floor);
  require_free_regions(base.get(), pores.get());
  for (int k = 0; k < 2; ++k) {
    int64_t level = static_cast<int64_t>(bytes.below(2000));
    if (!reference.maxima.empty() && bytes.one_in(2)) {
      const double radius = reference.maxima[bytes.below(reference.counts.maxima)].radius;
      level = static_cast<int64_t>(std::floor(radius / set.step())) - static_cast<int64_t>(bytes.below(20));
    }
    if (level >= 0 && level >= floor) require_regions(set, reference, pores.get(), level, bytes);
    if (level >= floor) require_pockets(set, pores.get(), level, level + static_cast<int64_t>(bytes.below(1000)));
  }
  for (int k = 0; k < 2; ++k) {
    Point ends[2];
    for (Point &end : ends) {
      for (double &x : end) x = set.length((static_cast<int64_t>(bytes.below(4000)) - 2000) * (1 + bytes.below(8)));
      if (reference.maxima.empty() || !bytes.one_in(2)) continue;
      std::memcpy(end.data(), reference.maxima[bytes.below(reference.counts.maxima)].xyz, sizeof end);
    }
    require_tunnel(set, pores.get(), floor, ends[0], bytes.one_in(2) ? nullptr : &ends[1]);
  }
  const auto again = [&](hsp_pores *handle, hsp_pores_limits *limits) {
    return hsp_pores_compute(handle, model, &options, limits);
  };
  const auto compare = [&](const hsp_pores *handle) {
    hsp_pores_counts counts{};
    const int32_t status = hsp_pores_get_counts(handle, &counts);
    if (status != HSP_OK) return status;
    FUZZ_REQUIRE(same_levels(reference, read(handle)), "pores the second time");
    return status;
  };
  fuzz::require_limits<support::PoresKind>(reference.needed, bytes, again, compare);
  const fuzz::ComputedSet other(fuzz::permuted(set, fuzz::shuffled(set.n(), bytes)));
  support::OwnedHandle<support::PoresKind> permuted;
  FUZZ_REQUIRE(same_levels(reference, compute(other.get().model, set.n(), options, permuted)),
               "levels depend on the order of the balls");
  // Pores that were computed from those of fewer balls must have the same bits.
  fuzz::ScaledBalls fewer = set;
  fewer.balls.resize(set.n() - bytes.below(set.n() < 4 ? set.n() + 1 : 4));
  const fuzz::ComputedSet few(fewer);
  support::OwnedHandle<support::PoresKind> before, taking;
  static_cast<void>(compute(few.get().model, fewer.n(), options, before));
  hsp_pores_options with_before = options;
  with_before.before = before.get();
  FUZZ_REQUIRE(same_bits(reference, compute(model, set.n(), with_before, taking)), "pores from those before");
  return 0;
}
