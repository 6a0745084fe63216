#include "paths/cell_search.hpp"

#include "core/sorting.hpp"
#include "paths/free_segments.hpp"

namespace hsp {
namespace {

constexpr uint32_t not_seen = no_id, done = no_id - 1;

// The value nearest to `value` that the intervals of two runs along one axis have in common.
int64_t nearest_common(int64_t value, int64_t a_low, int64_t a_high, int64_t b_low, int64_t b_high) {
  const int64_t low = a_low > b_low ? a_low : b_low, high = a_high < b_high ? a_high : b_high;
  return value < low ? low : value > high ? high : value;
}

}  // namespace

void CellSearch::carve(Workspace &workspace, const FreeSpaceLimits &limits) {
  workspace.take_each(limits.cells, visits_, heap_, boxes_);
  links_ = workspace.take<uint32_t>(2 * static_cast<uint64_t>(limits.adjacencies));
}

bool CellSearch::prepare(const FreeSpace &space, Patience &patience) {
  // A cell has as many contacts as neighbours.
  const uint32_t cells = space.cell_count();
  for (uint32_t c = 0; c < cells; ++c) heap_[c] = space.first_neighbour[c + 1];
  for (uint32_t contact = space.adjacency_count(); contact-- > 0;) {
    if (!patience.allows(30)) return false;
    for (const uint32_t cell : space.contacts[contact].cell) links_[--heap_[cell]] = contact;
  }
  constexpr int64_t beyond = INT64_C(1) << 52;
  const auto corner = [&](int64_t cube) {
    return cube <= -EmptyRuns::infinity ? -beyond : cube >= EmptyRuns::infinity ? beyond : cube * space.side;
  };
  space.runs.for_each_run(space.cover, [&](uint32_t run, const CubeCoordinates &low, const CubeCoordinates &high) {
    boxes_[run] = {{corner(low.x), corner(low.y), corner(low.z)}, {corner(high.x), corner(high.y), corner(high.z)}};
  });
  return true;
}

// Of equal estimates the cell comes first that is nearer to the end, then the one with the lower number: so the way
// depends on nothing else.
bool CellSearch::comes_first(uint32_t a, uint32_t b) const {
  const Visit &first = visits_[a], &second = visits_[b];
  if (first.estimate != second.estimate) return first.estimate < second.estimate;
  if (first.way != second.way) return first.way > second.way;
  return a < b;
}

// The portal of a contact; between two runs the point of their common side that is nearest to `from`.
exact::Vector CellSearch::portal(const FreeSpace &space, uint32_t contact, const exact::Vector &from) const {
  const uint32_t *const cell = space.contacts[contact].cell;
  if (cell[0] >= space.run_count() || cell[1] >= space.run_count()) return space.contacts.portal(contact);
  const Box &a = boxes_[cell[0]], &b = boxes_[cell[1]];
  return {nearest_common(from.x, a.low.x, a.high.x, b.low.x, b.high.x),
          nearest_common(from.y, a.low.y, a.high.y, b.low.y, b.high.y),
          nearest_common(from.z, a.low.z, a.high.z, b.low.z, b.high.z)};
}

Status CellSearch::find(const FreeSpace &space, uint32_t from_cell, const exact::Vector &from, uint32_t to_cell,
                        const exact::Vector &to, Patience &patience) {
  for (uint32_t c = 0; c < space.cell_count(); ++c) visits_[c].next = not_seen;
  visits_[from_cell] = {from, 0.0, distance(from, to), no_id, 0};
  heap_[0] = from_cell;
  const auto later = [&](uint32_t a, uint32_t b) { return comes_first(b, a); };
  const auto placed = [&](uint32_t cell, uint32_t at) { visits_[cell].next = at; };
  uint32_t waiting = 1;
  bool found = false;
  while (waiting > 0 && !found) {
    if (!patience.allows(2000)) return Status::stopped;
    const uint32_t cell = heap_[0];
    visits_[cell].next = done;
    heap_[0] = heap_[--waiting];
    if (waiting > 0) sift_down(heap_.part(0, waiting), 0, later, placed);
    found = cell == to_cell;
    if (found) break;
    const Visit here = visits_[cell];
    for (uint32_t k = space.first_neighbour[cell]; k < space.first_neighbour[cell + 1]; ++k) {
      const uint32_t contact = links_[k];
      const uint32_t *const pair = space.contacts[contact].cell;
      const uint32_t other = pair[0] == cell ? pair[1] : pair[0];
      Visit &there = visits_[other];
      if (there.next == done) continue;
      const exact::Vector at = portal(space, contact, here.entry);
      const double way = here.way + distance(here.entry, at);
      if (there.next == not_seen) {
        there.next = waiting++;
        heap_[there.next] = other;
      } else if (!(way < there.way)) {
        continue;
      }
      const uint32_t in_heap = there.next;
      there = {at, way, way + distance(at, to), cell, in_heap};
      sift_up(heap_, in_heap, later, placed);
    }
  }
  if (!found) return Status::check;
  uint32_t behind = no_id;
  for (uint32_t cell = to_cell; cell != no_id; cell = visits_[cell].from) {
    visits_[cell].next = behind;
    behind = cell;
  }
  return Status::ok;
}

}  // namespace hsp
