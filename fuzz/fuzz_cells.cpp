// Cells of free space of any set: regions are the cells of the complement, neighbours are so for both, points are where
// the topology has them, nothing depends on the order of the balls, and limits that are too small.
#include <topology_result.h>

#include <cstring>
#include <map>
#include <vector>

#include "computed_set.hpp"
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

// Sums over spheres are those of the totals, no scratch memory is written behind its end, and the union has no more
// vertices than the arrangement.
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
  FUZZ_REQUIRE(reference.counts.regions == topology.counts.cells, "regions are not the cells of the complement");
  FUZZ_REQUIRE(hsp_cells_check(cells.get(), topology.topology, &invariant, &id) == HSP_OK, "hsp_cells_check");
  FUZZ_REQUIRE(invariant == 0 && id == HSP_NONE, "a violated invariant");
  FUZZ_REQUIRE(same_results(reference, read(cells.get())), "results after the check");
  std::map<uint32_t, uint32_t> cell_of;
  for (int k = 0; k < 16; ++k) {
    double xyz[3];
    for (double &x : xyz) x = set.length(static_cast<int64_t>(bytes.below(4000)) - 2000) * (1 + bytes.below(8));
    uint32_t here = 0, there = 0;
    FUZZ_REQUIRE(hsp_cells_locate(cells.get(), xyz, &here) == HSP_OK, "locate");
    FUZZ_REQUIRE(hsp_topology_locate(topology.topology, xyz, &there) == HSP_OK, "locate in the topology");
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

  const fuzz::ComputedSet other(fuzz::permuted(set, fuzz::shuffled(set.n(), bytes)));
  support::OwnedHandle<support::CellsKind> permuted;
  const Result changed = compute(other.get().model, set.n(), permuted);
  FUZZ_REQUIRE(std::memcmp(&changed.counts, &reference.counts, sizeof changed.counts) == 0,
               "counts depend on the order of the balls");
  return 0;
}
