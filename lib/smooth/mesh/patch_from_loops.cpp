// Triangles for patches without area, whose borders no points on a sphere tell apart. They are made from the order of
// the points on the loops alone, wherever the points are. So there is always a surface with these borders.
//
// One way leads around all loops of a face; from the first loop it takes a bridge to each other loop and back. Beside
// the way runs a ring. It has a point of its own for each step of the way, at the same place, so no edge to the ring or
// within it is an edge of anything else. The ring is a polygon that has no point twice. Its corners are cut off one by
// one, first those whose neighbours are nearest to each other: so borders that run along each other are closed like a
// zip.
#include "mesh/spherical_patch.hpp"

namespace hsp {

PatchState SphericalPatch::triangulate_from_loops() {
  needed_points_ = 3 * samples_.required();
  if (samples_.overflowed()) return PatchState::capacity;
  border_caps_ = caps_.size();
  sphere_.start(0);
  for (uint32_t t = 0; t < sphere_.triangle_count(); ++t) parts_[t] = Part{};
  for (uint32_t p = 0; p < sphere_.point_count(); ++p) sample_at_[p] = no_id;
  link_samples();
  uint32_t last = 0;
  for (uint32_t first = 0; first < loops_.size(); first = last) {
    last = first + 1;
    while (last < loops_.size() && loops_[last].face == loops_[first].face) ++last;
    cut_off_corners(ring_beside(first, last));
  }
  const uint64_t used = samples_.required() > ears_.required() ? samples_.required() : ears_.required();
  if (used > needed_points_) needed_points_ = used;
  if (samples_.overflowed() || ears_.overflowed()) return PatchState::capacity;
  return has_right_numbers() ? PatchState::complete : PatchState::too_coarse;
}

// Makes the ring beside these loops, all of one face. Returns one of its points.
uint32_t SphericalPatch::ring_beside(uint32_t first_loop, uint32_t last_loop) {
  const uint32_t face = loops_[first_loop].face, start = loops_[first_loop].first;
  const uint32_t ring = add_extra(face, direction_of(start));
  uint32_t at = start, inner = ring;
  const auto step = [&](uint32_t to, bool closes) {
    const uint32_t inner_to = closes ? ring : add_extra(face, direction_of(to));
    ears_.push({face, {at, to, inner_to}});
    ears_.push({face, {at, inner_to, inner}});
    links_[inner].next = inner_to;
    links_[inner_to].previous = inner;
    at = to;
    inner = inner_to;
  };
  for (uint32_t loop = first_loop; loop < last_loop; ++loop) {
    const bool is_first = loop == first_loop, is_last = loop + 1 == last_loop;
    const uint32_t begin = is_first ? start : nearest_of_loop(loop, start);
    const uint32_t bridge = is_first ? no_id : add_extra(face, direction_of(begin));
    if (!is_first) {
      step(bridge, false);
      step(begin, false);
    }
    uint32_t k = begin;
    do {
      k = links_[k].next;
      step(k, is_first && is_last && k == begin);
    } while (k != begin);
    if (!is_first) {
      step(bridge, false);
      step(start, is_last);
    }
  }
  return ring;
}

uint32_t SphericalPatch::nearest_of_loop(uint32_t loop, uint32_t sample) const {
  uint32_t nearest = loops_[loop].first;
  for (uint32_t k = nearest; k < end_of_loop(loop); ++k) {
    if (square_between(k, sample) < square_between(nearest, sample)) nearest = k;
  }
  return nearest;
}

double SphericalPatch::square_between(uint32_t a, uint32_t b) const {
  const Vec3 way = direction_of(b) - direction_of(a);
  return dot(way, way);
}

// Tries growing distances: corners whose neighbours are nearer than the current distance are cut off before all others.
// After a cut the corner before it is tried again. A distance is done once all corners that are left have been passed
// in a row without a cut.
void SphericalPatch::cut_off_corners(uint32_t ring) {
  constexpr double least = 0x1p-60, growth = 4.0;
  if (samples_.overflowed()) return;
  uint32_t corners = 0;
  uint32_t at = ring;
  do {
    ++corners;
    at = links_[at].next;
  } while (at != ring);
  for (double square = least; corners >= 3; square *= growth) {
    uint32_t left = 0;
    while (corners >= 3 && left < corners) {
      Link &own = links_[at];
      if (corners > 3 && square_between(own.previous, own.next) > square) {
        ++left;
        at = own.next;
        continue;
      }
      ears_.push({own.face, {own.previous, at, own.next}});
      links_[own.previous].next = own.next;
      links_[own.next].previous = own.previous;
      at = own.previous;
      left -= left > 0 ? 1 : 0;
      corners = corners == 3 ? 0 : corners - 1;
    }
  }
}

}  // namespace hsp
