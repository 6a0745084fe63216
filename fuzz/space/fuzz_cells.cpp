// Cells of free space of any set. Neighbours are so from both sides; regions, and those of points, agree with the
// library's topology; no effect of the order of the balls; limits that are too small. There is a path between two
// points if and only if they are in one region, and for probes up to the widest that the pores say. Cells, topology,
// paths and pores are parts of the library that take different ways: they are held against each other.
#include <topology_result.h>

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <vector>

#include "computed_set.hpp"
#include "owned_spaces.hpp"
#include "required_limits.hpp"
#include "topology_input.hpp"

namespace {

struct Result {
  hsp_cells_counts counts{};
  hsp_cells_limits needed{};
  std::vector<hsp_free_cell> cells;
  std::vector<hsp_cell_pair> pairs;
};

Result read(const hsp_cells *cells) {
  Result result;
  FUZZ_REQUIRE(hsp_cells_get_counts(cells, &result.counts) == HSP_OK, "counts");
  result.cells.resize(result.counts.cells);
  result.pairs.resize(result.counts.adjacencies);
  FUZZ_REQUIRE(hsp_cells_get_cells(cells, 0, result.counts.cells, result.cells.data()) == HSP_OK, "cells");
  FUZZ_REQUIRE(hsp_cells_get_pairs(cells, 0, result.counts.adjacencies, result.pairs.data()) == HSP_OK, "pairs");
  return result;
}

Result compute(const hsp_model *model, uint32_t n, support::OwnedHandle<support::CellsKind> &cells) {
  hsp_cells_limits limits;
  FUZZ_REQUIRE(hsp_cells_limits_init(&limits, sizeof limits, n) == HSP_OK, "hsp_cells_limits_init");
  cells.take(limits);
  cells.compute([&](hsp_cells *handle, hsp_cells_limits *asked) { return hsp_cells_compute(handle, model, asked); });
  Result result = read(cells.get());
  result.needed = cells.needed();
  return result;
}

void require_sound(const Result &result, const hsp_cells *cells) {
  std::vector<uint32_t> found(result.counts.cells);
  for (const hsp_cell_pair &pair : result.pairs) {
    FUZZ_REQUIRE(pair.cell[0] < pair.cell[1] && pair.cell[1] < result.counts.cells, "a pair of cells");
    FUZZ_REQUIRE(result.cells[pair.cell[0]].region == result.cells[pair.cell[1]].region, "neighbours in two regions");
    ++found[pair.cell[0]];
    ++found[pair.cell[1]];
  }
  std::vector<uint32_t> list(result.counts.cells);
  for (uint32_t c = 0; c < result.counts.cells; ++c) {
    uint32_t needed = 0;
    FUZZ_REQUIRE(hsp_cells_get_neighbours(cells, c, list.data(), result.counts.cells, &needed) == HSP_OK, "neighbours");
    FUZZ_REQUIRE(needed == found[c] && needed == result.cells[c].neighbours, "how many neighbours");
    for (uint32_t k = 1; k < needed; ++k) FUZZ_REQUIRE(list[k - 1] < list[k], "neighbours in order");
    FUZZ_REQUIRE((result.cells[c].kind == HSP_CELL_RUN) == (c < result.counts.runs), "runs come first");
  }
}

bool same_results(const Result &a, const Result &b) {
  return a.counts.cells == b.counts.cells && a.counts.adjacencies == b.counts.adjacencies &&
         fuzz::same(a.cells.data(), b.cells.data(), a.counts.cells) &&
         fuzz::same(a.pairs.data(), b.pairs.data(), a.counts.adjacencies);
}

// The arrangement's numbers summed over spheres must be its totals, nothing may be written behind scratch memory, and
// the union must not have more vertices than the arrangement.
void require_arrangement(const computed &base, const fuzz::ScaledBalls &set) {
  uint32_t needed = 12345;
  hsp_arrangement totals{}, sum{};
  const int32_t counted = hsp_model_arrangement(base.model, &totals, nullptr, nullptr, 0, &needed);
  FUZZ_REQUIRE(counted == (needed > 0 ? HSP_E_CAPACITY : HSP_OK), "words of scratch memory");
  std::vector<uint32_t> scratch(needed);
  std::vector<hsp_arrangement> spheres(set.n());
  FUZZ_REQUIRE(hsp_model_arrangement(base.model, &totals, spheres.data(), scratch.data(), needed, &needed) == HSP_OK,
               "hsp_model_arrangement");
  for (const hsp_arrangement &sphere : spheres) {
    sum.vertices += sphere.vertices;
    sum.edges += sphere.edges;
    sum.faces += sphere.faces;
    FUZZ_REQUIRE(sphere.faces > sphere.vertices, "faces of a sphere");
  }
  FUZZ_REQUIRE(sum.vertices == 3 * totals.vertices && sum.edges == 2 * totals.edges && sum.faces == totals.faces,
               "sums over spheres");
  FUZZ_REQUIRE(totals.vertices >= base.counts.vertices && totals.edges >= totals.vertices, "what balls cover counts");
}

using Point = std::array<double, 3>;

Point any_point(const fuzz::ScaledBalls &set, fuzz::Bytes &bytes) {
  Point xyz{};
  for (double &x : xyz) {
    const int64_t steps = static_cast<int64_t>(bytes.below(4000)) - 2000;
    x = set.length(steps * (1 + bytes.below(8)));
  }
  return xyz;
}

double distance(const double *a, const double *b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Computes paths and finds one, with memory that grows until it suffices.
class FoundPath {
 public:
  FoundPath(const hsp_model *model, uint32_t n, const Point &from, const Point &to) {
    hsp_paths_limits limits;
    FUZZ_REQUIRE(hsp_paths_limits_init(&limits, sizeof limits, n) == HSP_OK, "hsp_paths_limits_init");
    paths_.take(limits);
    paths_.compute([&](hsp_paths *handle, hsp_paths_limits *asked) {
      const int32_t status = hsp_paths_compute(handle, model, asked);
      return status == HSP_OK ? hsp_paths_find(handle, from.data(), to.data(), &path, asked) : status;
    });
    points.resize(path.points);
    uint32_t needed = 0;
    double *const out = path.points == 0 ? nullptr : points[0].data();
    FUZZ_REQUIRE(hsp_paths_get_points(paths_.get(), out, path.points, &needed) == HSP_OK, "hsp_paths_get_points");
    FUZZ_REQUIRE(needed == path.points, "how many points");
  }

  hsp_path path{};
  std::vector<Point> points;
  const hsp_paths_limits &needed() const { return paths_.needed(); }

 private:
  support::OwnedHandle<support::PathsKind> paths_;
};

uint32_t expected_ends(const Result &reference, uint32_t here, uint32_t there) {
  if (here == HSP_NONE || there == HSP_NONE) return HSP_PATH_COVERED;
  return reference.cells[here].region == reference.cells[there].region ? HSP_PATH_CONNECTED : HSP_PATH_APART;
}

// The path must lead from end to end, and its own numbers must fit its points.
void require_sound(const FoundPath &found, const Point &from, const Point &to) {
  const hsp_path &path = found.path;
  FUZZ_REQUIRE((path.ends == HSP_PATH_CONNECTED) == (path.points > 0) && path.reserved == 0, "points of a path");
  if (path.points == 0) return;
  FUZZ_REQUIRE(found.points.front() == from && found.points.back() == to, "ends of a path");
  double length = 0;
  for (size_t k = 1; k < found.points.size(); ++k) {
    length += distance(found.points[k - 1].data(), found.points[k].data());
  }
  FUZZ_REQUIRE(std::fabs(length - path.length) <= 1e-9 * (1 + length), "length of a path");
  const double error = 1e-9 * (1 + length + std::hypot(from[0], from[1], from[2]));
  FUZZ_REQUIRE(path.certified == 0 || path.clearance >= -error, "clearance of a certified path");
}

// For a probe one lattice step below the widest that the pores say there must be a path, for one two steps above there
// must be none.
void require_widest(const fuzz::ScaledBalls &set, const hsp_model *model, const Point &from, const Point *to,
                    bool passes) {
  support::OwnedHandle<support::PoresKind> pores;
  hsp_pores_limits limits;
  FUZZ_REQUIRE(hsp_pores_limits_init(&limits, sizeof limits, set.n()) == HSP_OK, "hsp_pores_limits_init");
  pores.take(limits);
  pores.compute(
      [&](hsp_pores *handle, hsp_pores_limits *asked) { return hsp_pores_compute(handle, model, nullptr, asked); });
  hsp_pore_passage widest{};
  FUZZ_REQUIRE(hsp_pores_widest(pores.get(), from.data(), to == nullptr ? nullptr : to->data(), &widest) == HSP_OK,
               "widest");
  FUZZ_REQUIRE((widest.passes != 0) == passes, "whether a point passes");
  FUZZ_REQUIRE(passes || (widest.radius == 0 && widest.gate == HSP_NONE && widest.ball == HSP_NONE), "nothing passes");
  FUZZ_REQUIRE(!passes || set.n() == 0 || (widest.gate == HSP_NONE) != (widest.ball == HSP_NONE), "a gate or an end");
  if (!passes || to == nullptr || !std::isfinite(widest.radius)) return;
  const auto steps = static_cast<int64_t>(std::floor(widest.radius / set.step()));
  for (const int64_t more : {steps - 1, steps + 3}) {
    fuzz::ScaledBalls grown = set;
    grown.probe_steps += more;
    if (more < 0 || grown.probe_steps >= INT64_C(1) << 29) continue;
    const fuzz::ComputedSet other(grown);
    const FoundPath found(other.get().model, set.n(), from, *to);
    FUZZ_REQUIRE((found.path.ends == HSP_PATH_CONNECTED) == (more < steps), "the widest probe");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const fuzz::ScaledBalls set = fuzz::topology_set(bytes);
  const fuzz::ComputedSet base(set);
  const hsp_model *const model = base.get().model;
  support::OwnedHandle<support::CellsKind> cells;
  const Result reference = compute(model, set.n(), cells);
  require_sound(reference, cells.get());
  require_arrangement(base.get(), set);
  uint32_t invariant = 12345, id = 12345;

  topology_result topology{};
  FUZZ_REQUIRE(topology_result_make(&base.get(), &topology) == HSP_OK, "topology");
  FUZZ_REQUIRE(reference.counts.regions == topology.counts.regions, "regions are not the cells of the complement");
  FUZZ_REQUIRE(hsp_cells_check(cells.get(), topology.topology, &invariant, &id) == HSP_OK, "hsp_cells_check");
  FUZZ_REQUIRE(invariant == 0 && id == HSP_NONE, "a violated invariant");
  FUZZ_REQUIRE(same_results(reference, read(cells.get())), "results after the check");
  std::map<uint32_t, uint32_t> cell_of;
  for (int k = 0; k < 16; ++k) {
    const Point xyz = any_point(set, bytes);
    uint32_t here = 0, there = 0;
    FUZZ_REQUIRE(hsp_cells_locate(cells.get(), xyz.data(), &here) == HSP_OK, "locate");
    FUZZ_REQUIRE(hsp_topology_locate(topology.topology, xyz.data(), &there) == HSP_OK, "locate in the topology");
    FUZZ_REQUIRE((here == HSP_NONE) == (there == HSP_NONE), "in a ball or not");
    if (here == HSP_NONE) continue;
    const auto known = cell_of.insert({reference.cells[here].region, there}).first;
    FUZZ_REQUIRE(known->second == there, "one region in two cells of the complement");
  }
  topology_result_release(&topology);

  const auto again = [&](hsp_cells *handle, hsp_cells_limits *limits) {
    return hsp_cells_compute(handle, model, limits);
  };
  const auto compare = [&](const hsp_cells *handle) {
    hsp_cells_counts counts{};
    const int32_t status = hsp_cells_get_counts(handle, &counts);
    if (status != HSP_OK) return status;
    FUZZ_REQUIRE(same_results(reference, read(handle)), "cells the second time");
    return status;
  };
  fuzz::require_limits<support::CellsKind>(reference.needed, bytes, again, compare);

  const Point from = any_point(set, bytes), to = any_point(set, bytes);
  uint32_t here = 0, there = 0;
  FUZZ_REQUIRE(hsp_cells_locate(cells.get(), from.data(), &here) == HSP_OK, "locate");
  FUZZ_REQUIRE(hsp_cells_locate(cells.get(), to.data(), &there) == HSP_OK, "locate");
  const FoundPath found(model, set.n(), from, to);
  FUZZ_REQUIRE(found.path.ends == expected_ends(reference, here, there), "whether there is a path");
  require_sound(found, from, to);
  const auto path_again = [&](hsp_paths *handle, hsp_paths_limits *limits) {
    hsp_path path{};
    const int32_t status = hsp_paths_compute(handle, model, limits);
    if (status != HSP_OK) return status;
    return hsp_paths_find(handle, from.data(), to.data(), &path, limits);
  };
  const auto same_path = [&](const hsp_paths *handle) {
    std::vector<Point> points(found.points.size() + 1);
    uint32_t needed = 0;
    const int32_t status = hsp_paths_get_points(handle, points[0].data(), found.path.points, &needed);
    if (status != HSP_OK) return status;
    if (needed != found.path.points) return static_cast<int32_t>(HSP_E_STATE);  // the path had no room
    points.resize(found.points.size());
    FUZZ_REQUIRE(points == found.points, "a path the second time");
    return status;
  };
  fuzz::require_limits<support::PathsKind>(found.needed(), bytes, path_again, same_path);
  if (bytes.one_in(4)) {
    const bool to_outside = bytes.one_in(2);
    const bool outside = here != HSP_NONE && reference.cells[here].region == 0;
    require_widest(set, model, from, to_outside ? nullptr : &to,
                   to_outside ? outside : found.path.ends == HSP_PATH_CONNECTED);
  }

  const fuzz::ComputedSet other(fuzz::permuted(set, fuzz::shuffled(set.n(), bytes)));
  support::OwnedHandle<support::CellsKind> permuted;
  const Result changed = compute(other.get().model, set.n(), permuted);
  FUZZ_REQUIRE(std::memcmp(&changed.counts, &reference.counts, sizeof changed.counts) == 0,
               "counts depend on the order of the balls");
  return 0;
}
