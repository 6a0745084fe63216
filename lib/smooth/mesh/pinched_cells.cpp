// The cells without area of patches whose borders touch or run along each other (pinched_patch.cpp): they close what
// the triangles beside them leave open. If the same edge would be there twice, points that belong to no border are
// added.
#include "mesh/spherical_patch.hpp"

namespace hsp {

// all: the samples around the cell, counter-clockwise, at most six; no_id for one that is missing. An edge between
// points that other patches may join, too, is never inside the cell: it would be there twice.
void SphericalPatch::add_cell(uint32_t face, const uint32_t *all, uint32_t most) {
  uint32_t corner[6], count = 0;
  for (uint32_t k = 0; k < most; ++k) {
    if (all[k] != no_id) corner[count++] = all[k];
  }
  if (count < 3) return;
  if (count == 3) {
    ears_.push({face, {corner[0], corner[1], corner[2]}});
    return;
  }
  uint32_t first = 0;
  while (first < count && !is_extra(corner[first])) ++first;
  if (first < count) {
    for (uint32_t k = 1; k + 1 < count; ++k) {
      ears_.push({face, {corner[first], corner[(first + k) % count], corner[(first + k + 1) % count]}});
    }
    return;
  }
  const uint32_t centre = add_extra(face, direction_of(corner[0]));
  for (uint32_t k = 0; k < count; ++k) ears_.push({face, {centre, corner[k], corner[(k + 1) % count]}});
}

// A new sample that divides the edge from b to a, if the border leads from b to a as well, or if another patch may have
// the edge, too; else no_id.
uint32_t SphericalPatch::middle_of(uint32_t a, uint32_t b) {
  if (a == b) return no_id;
  if (links_[b].next != a && !samples_[a].may_be_joined_elsewhere(samples_[b])) return no_id;
  return add_extra(links_[a].face, direction_between(a, b));
}

// If the sample where a wedge ends is followed by the one where it begins, a border without length joins the two, and
// nothing is divided.
uint32_t SphericalPatch::middle_of_wedge(uint32_t sample) {
  const uint32_t end = links_[sample].closing;
  return links_[end].next == sample ? no_id : middle_of(end, sample);
}

bool SphericalPatch::close_wedges() {
  for (uint32_t k = 0; k < linked_samples_; ++k) {
    if (!has_length(k)) continue;
    TriangleEdge way;
    if (!sphere_.find_edge(links_[k].point, links_[links_[k].next].point, way) || !close_wedge(k, way)) return false;
    Link &end = links_[links_[k].closing];
    if (end.closed || end.face != links_[k].face || samples_.overflowed()) return false;
    end.closed = true;
  }
  return true;
}

bool SphericalPatch::close_wedge(uint32_t sample, const TriangleEdge &way) {
  uint32_t strand = no_id;
  if (parts_[way.triangle].face == no_id) {
    strand = strand_back(way);
    if (strand == no_id) return false;
    has_corridors_ = true;
    links_[sample].closing = links_[strand].next;
    links_[sample].middle = middle_of_wedge(sample);
    return true;
  }
  const uint32_t p = links_[sample].point;
  uint32_t t = way.triangle;
  uint32_t edge = 0;
  for (;;) {
    const uint32_t corner = sphere_.triangle(t).corner_of(p);
    if (parts_[t].corner[corner] != no_id) return false;
    parts_[t].corner[corner] = sample;
    edge = next_corner(corner);
    strand = parts_[t].strand[edge];
    if (strand != no_id) break;
    if (sphere_.triangle(t).fixed[edge]) return false;
    t = sphere_.triangle(t).neighbour[edge];
  }
  const uint32_t end = links_[strand].next;
  links_[sample].closing = end;
  links_[sample].middle = middle_of_wedge(sample);
  if (end == sample) return true;
  // The last triangle has the edge from `strand` to this sample in place of the border. On the other side of a border
  // that comes back another triangle has the same edge, if the wedge at `strand` was closed before and ends at the
  // sample behind this one.
  uint32_t divided = middle_of(strand, sample);
  const uint32_t end_there = links_[strand].closing;
  if (divided == no_id && end_there != no_id && end_there != strand && links_[end_there].previous == sample) {
    divided = add_extra(links_[sample].face, direction_between(strand, sample));
  }
  parts_[t].middle[edge] = divided;
  const uint32_t cell[5] = {strand, end, links_[sample].middle, sample, divided};
  add_cell(links_[sample].face, cell, 5);
  return true;
}

void SphericalPatch::add_corridors() {
  for (uint32_t a = 0; has_corridors_ && a < linked_samples_; ++a) {
    TriangleEdge way;
    if (!has_length(a) || !sphere_.find_edge(links_[a].point, links_[links_[a].next].point, way)) continue;
    if (parts_[way.triangle].face != no_id) continue;
    const uint32_t c = strand_back(way);
    if (c < a) continue;
    const uint32_t b = links_[a].next;
    const uint32_t d = links_[c].next;
    const uint32_t cell[6] = {a, b, links_[c].middle, b == c ? no_id : c, d == a ? no_id : d, links_[a].middle};
    add_cell(links_[a].face, cell, 6);
  }
}

// Calls visit for the samples around a neck, counter-clockwise: from the sample where a wedge begins to the one where
// it ends, along the border to the one where the next wedge begins, and so on.
template <class Visit>
void SphericalPatch::for_each_of_neck(uint32_t sample, Visit visit) const {
  uint32_t at = sample;
  do {
    if (links_[at].middle != no_id) visit(links_[at].middle);
    at = links_[at].closing;
    visit(at);
    while (!has_length(at)) {
      at = links_[at].next;
      visit(at);
    }
  } while (at != sample);
}

// Adds each neck once: at the lowest of its samples where a wedge begins.
bool SphericalPatch::add_necks() {
  for (uint32_t k = 0; k < linked_samples_; ++k) {
    if (!has_length(k) || links_[k].closing == k) continue;
    uint32_t count = 0;
    uint32_t corner[3] = {no_id, no_id, no_id};
    bool is_first = true;
    for_each_of_neck(k, [&](uint32_t sample) {
      if (count < 3) corner[count] = sample;
      ++count;
      is_first = is_first && (sample >= linked_samples_ || sample >= k || !has_length(sample));
    });
    if (!is_first || count < 3) continue;
    if (count == 3) {
      add_cell(links_[k].face, corner, 3);
      continue;
    }
    const uint32_t centre = add_extra(links_[k].face, direction_of(k));
    if (samples_.overflowed()) return false;
    uint32_t before = k;
    for_each_of_neck(k, [&](uint32_t sample) {
      ears_.push({links_[k].face, {centre, before, sample}});
      before = sample;
    });
  }
  return true;
}

// Adds faces that exist but have no extent, as those of a ball of radius 0: their whole border is at one point.
bool SphericalPatch::add_faces_without_extent() {
  uint32_t last = 0;
  for (uint32_t first = 0; first < loops_.size(); first = last) {
    bool any = false;
    bool all = true;
    for (last = first; last < loops_.size() && loops_[last].face == loops_[first].face; ++last) {
      bool has_some = false;
      for (uint32_t k = loops_[last].first; k < end_of_loop(last); ++k) has_some = has_some || has_length(k);
      any = any || has_some;
      all = all && has_some;
    }
    if (any != all) return false;
    if (!any) cut_off_corners(ring_beside(first, last));
    if (samples_.overflowed()) return false;
  }
  return true;
}

void SphericalPatch::add_detours() {
  for (uint32_t k = 0; k < border_samples_; ++k) {
    const uint32_t first = links_[k].next;
    if (!is_extra(first)) continue;
    uint32_t at = links_[first].next;
    uint32_t before = no_id;
    for (; is_extra(at); at = links_[at].next) {
      if (before != no_id) ears_.push({links_[k].face, {first, at, before}});
      before = at;
    }
    if (before != no_id) ears_.push({links_[k].face, {first, at, before}});
    ears_.push({links_[k].face, {first, k, at}});
  }
}

}  // namespace hsp
