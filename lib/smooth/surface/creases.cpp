#include "surface/creases.hpp"

#include "core/first_index.hpp"
#include "core/sorting.hpp"
#include "surface/actual_points.hpp"
#include "surface/covered_gaps.hpp"
#include "surface/probe_caps.hpp"

namespace hsp {
namespace {

// Above this error the floats of a triangle's sides say nothing: all probes that overlap count as near.
constexpr double most_side_error = 0x1p-24;
constexpr float no_limit = 16.0F;

// Which of a corner's three pairs is that of two of its vertices.
uint32_t pair_slot(const CreaseCorner &corner, uint32_t low, uint32_t high) {
  return low != corner.vertex[0] ? 2 : high == corner.vertex[1] ? 0 : 1;
}

}  // namespace

void Creases::carve(Workspace &workspace, const CreaseLimits &limits) {
  limit(limits);
  near_ = FixedVector(workspace.take<Near>(limits.near));
  first_near_ = workspace.take<uint32_t>(uint64_t{limits.vertices} + 1);
  pairs_ = FixedVector(workspace.take<CreasePair>(limits.pairs));
  corners_ = FixedVector(workspace.take<CreaseCorner>(limits.corners));
  creases_ = FixedVector(workspace.take<Crease>(limits.creases));
  ends_ = FixedVector(workspace.take<End>(limits.ends));
}

Status Creases::build(const ActualBalls &actual, const ChosenFaces &chosen, const ProbeGrid &grid,
                      const CuspedCircles &cusped) {
  actual_ = &actual;
  cusped_ = &cusped;
  const uint32_t vertices = actual.boundary().vertex_count();
  first_cusp_ = 3 * vertices;
  first_crease_corner_ = first_cusp_ + 2 * cusped.count();
  needed_ = {vertices};
  near_.clear();
  pairs_.clear();
  corners_.clear();
  creases_.clear();
  if (vertices > limits_.vertices) return Status::capacity;
  find_near(chosen, grid);
  needed_.near = clamped_count(near_.required());
  if (near_.overflowed()) return Status::capacity;
  find_pairs();
  needed_.pairs = clamped_count(pairs_.required());
  if (pairs_.overflowed()) return Status::capacity;
  const Status status = find_corners();
  needed_.corners = clamped_count(corners_.required());
  if (status != Status::ok) return status;
  if (corners_.overflowed()) return Status::capacity;
  return find_creases(chosen, grid);
}

// Vertices of other components cut nothing that those of this one do not (PROOFS.md, section 5).
void Creases::find_near(const ChosenFaces &chosen, const ProbeGrid &grid) {
  const Boundary &boundary = actual_->boundary();
  const BallSet &balls = actual_->balls();
  const uint32_t n = boundary.vertex_count();
  const double error = vertex_error * static_cast<double>(balls.largest_radius);
  ProbeTriangles triangles;
  ProbeSearch search;
  uint32_t found[ProbeSearch::room + ProbeSearch::spare];
  for (uint32_t v = 0; v < n; ++v) {
    first_near_[v] = near_.size();
    const uint32_t lane = v % ProbeTriangles::lanes;
    if (lane == 0) {
      FourVertices four;
      for (uint32_t k = 0; k < ProbeTriangles::lanes; ++k) four[k] = v + k < n ? v + k : n - 1;
      measure_triangles(balls, boundary, grid.positions(), four, triangles);
    }
    grid.start_search(balls, v, search);
    aim(triangles, lane, search);
    const bool has_sides = triangles.steradians[lane] >= 0.0 && boundary.root_discriminant(v) > 0.0 &&
                           error * triangles.side_error[lane] <= most_side_error;
    if (!has_sides) search.margin = no_limit;
    while (!search.done()) {
      const uint32_t count = find_near_probes(boundary.target(), search, found);
      for (uint32_t k = 0; k < count; ++k) {
        const uint32_t w = found[k];
        if (w == v ||
            boundary.component(boundary.vertex(w).ball[0]) != boundary.component(boundary.vertex(v).ball[0]) ||
            !(chosen.all() || chosen.together(face_at_vertex(boundary, w), face_at_vertex(boundary, v)))) {
          continue;
        }
        near_.push({w, no_id});
      }
    }
    if (!near_.overflowed()) {
      sort_in_place(near_.items().part(first_near_[v], near_.size()),
                    [](const Near &a, const Near &b) { return a.vertex < b.vertex; });
    }
  }
  first_near_[n] = near_.size();
}

// The place of w among those near v; no_id if it is not.
uint32_t Creases::near_of(uint32_t v, uint32_t w) const {
  const IdRange range = near(v);
  const uint32_t k = first_index(range.first, range.last, [this, w](uint32_t j) { return near_[j].vertex >= w; });
  return k < range.last && near_[k].vertex == w ? k : no_id;
}

void Creases::find_pairs() {
  for (uint32_t v = 0; v < needed_.vertices; ++v) {
    for (const uint32_t k : near(v)) {
      const uint32_t w = near_[k].vertex;
      if (w < v) continue;
      const uint32_t back = near_of(w, v);
      if (back == no_id) continue;
      near_[k].pair = near_[back].pair = clamped_count(pairs_.required());
      pairs_.push({v, w, no_id, 0});
    }
  }
}

// Their corner would be on the axis, where cusps are.
bool Creases::on_one_circle(uint32_t a, uint32_t b, uint32_t c) const {
  const Boundary &boundary = actual_->boundary();
  uint32_t common = 0;
  for (const uint32_t ball : boundary.vertex(a).ball) {
    if (boundary.vertex(b).has(ball) && boundary.vertex(c).has(ball)) ++common;
  }
  return common >= 2;
}

bool Creases::in_patch(const BorderPoint &point, uint32_t v) const {
  for (uint32_t slot = 0; slot < 3; ++slot) {
    if (actual_->inside_of_side(point, v, slot) <= 0) return false;
  }
  return true;
}

bool Creases::in_other_probe(const BorderPoint &point, uint32_t v, uint32_t w, uint32_t x) const {
  for (const uint32_t k : near(v)) {
    const uint32_t other = near_[k].vertex;
    if (other != w && other != x && actual_->in_probe(point, other) >= 0) return true;
  }
  return false;
}

void Creases::add_corner(const BorderPoint &corner) {
  const uint32_t number = clamped_count(corners_.required());
  CreaseCorner added{{corner.id[0], corner.id[1], corner.id[2]}, corner.sign, {no_id, no_id, no_id}};
  const uint32_t pairs[3] = {near_[near_of(corner.id[0], corner.id[1])].pair,
                             near_[near_of(corner.id[0], corner.id[2])].pair,
                             near_[near_of(corner.id[1], corner.id[2])].pair};
  for (int k = 0; k < 3; ++k) {
    added.next[k] = pairs_[pairs[k]].first_corner;
    pairs_[pairs[k]].first_corner = number;
  }
  corners_.push(added);
}

Status Creases::find_corners() {
  for (uint32_t p = 0; p < pairs_.size(); ++p) {
    const uint32_t a = pairs_[p].low, b = pairs_[p].high;
    for (uint32_t q = p + 1; q < pairs_.size() && pairs_[q].low == a; ++q) {
      const uint32_t c = pairs_[q].high;
      const uint32_t k = near_of(b, c);
      if (k == no_id || near_[k].pair == no_id || on_one_circle(a, b, c)) continue;
      if (actual_->have_corners(a, b, c) <= 0) continue;
      for (int8_t sign = -1; sign <= 1; sign = static_cast<int8_t>(sign + 2)) {
        const BorderPoint corner{BorderPoint::Kind::corner, sign, {a, b, c}};
        if (in_patch(corner, a) && !in_other_probe(corner, a, b, c)) add_corner(corner);
      }
    }
  }
  return actual_->answers().by_none == 0 ? Status::ok : Status::degenerate;
}

BorderPoint Creases::point(uint32_t corner) const {
  if (corner < first_cusp_) {
    return {BorderPoint::Kind::towards_ball,
            0,
            {corner / 3, actual_->boundary().vertex(corner / 3).ball[corner % 3], no_id}};
  }
  if (corner < first_crease_corner_) {
    const uint32_t k = (corner - first_cusp_) / 2, side = (corner - first_cusp_) % 2;
    return {BorderPoint::Kind::cusp,
            static_cast<int8_t>(side == 0 ? -1 : 1),
            {cusped_->ball(k, 0), cusped_->ball(k, 1), no_id}};
  }
  const CreaseCorner &own = corners_[corner - first_crease_corner_];
  return {BorderPoint::Kind::corner, static_cast<int8_t>(own.sign), {own.vertex[0], own.vertex[1], own.vertex[2]}};
}

// Of a pair on one circle, or on more: where the covered gap of one of them lies between the two, the cusps. Whether
// there is a circle with cusps at all.
bool Creases::add_cusps(const ChosenFaces &chosen, uint32_t v, uint32_t w) {
  const Boundary &boundary = actual_->boundary();
  const VertexRecord &record = boundary.vertex(v), &other = boundary.vertex(w);
  bool share = false;
  for (uint32_t slot = 0; slot < 3; ++slot) {
    const uint32_t ball = record.ball[slot], e = boundary.half_edge_at(v, slot);
    const uint32_t circle = boundary.half_edge(e).circle;
    if (!other.has(ball) || !other.has(circle)) continue;
    const uint32_t k = ball < circle ? cusped_->of_arc(ball, circle) : cusped_->of_arc(circle, ball);
    if (k == no_id) continue;
    share = true;
    if (gap_behind(actual_->balls(), boundary, chosen, ball, e).vertex != w) continue;
    for (uint32_t side = 0; side < 2; ++side) {
      const uint32_t number = first_cusp_ + 2 * k + side;
      ends_.push({number, actual_->starts_at_cusp(point(number), v, w) > 0, false});
    }
  }
  return share;
}

Status Creases::find_creases(const ChosenFaces &chosen, const ProbeGrid &grid) {
  for (uint32_t k = 0; k < cusped_->count(); ++k) {
    if (!actual_->has_cusps(cusped_->ball(k, 0), cusped_->ball(k, 1))) return Status::degenerate;
  }
  for (CreasePair &pair : pairs_.items()) {
    pair.first_crease = creases_.size();
    ends_.clear();
    for (uint32_t c = pair.first_corner; c != no_id;
         c = corners_[c].next[pair_slot(corners_[c], pair.low, pair.high)]) {
      const CreaseCorner &corner = corners_[c];
      const uint32_t third = corner.vertex[2 - pair_slot(corner, pair.low, pair.high)];
      const uint32_t number = first_crease_corner_ + c;
      ends_.push({number, actual_->starts_at_corner(point(number), pair.low, pair.high, third) > 0, false});
    }
    const bool share_cusps = add_cusps(chosen, pair.low, pair.high);
    needed_.ends = larger_count(needed_.ends, clamped_count(ends_.required()));
    if (ends_.overflowed()) continue;
    const Status status = add_creases(grid, pair.low, pair.high, share_cusps);
    if (status != Status::ok) return status;
  }
  needed_.creases = clamped_count(creases_.required());
  if (needed_.ends > limits_.ends || creases_.overflowed()) return Status::capacity;
  return actual_->answers().by_none == 0 ? Status::ok : Status::degenerate;
}

// Ends of the pair at hand, by turns in order around the circle, start and end creases.
Status Creases::add_creases(const ProbeGrid &grid, uint32_t v, uint32_t w, bool share_cusps) {
  Span<End> ends = ends_.items();
  const uint32_t n = ends.size();
  if (n == 0) {
    if (share_cusps || actual_->overlap(v, w) <= 0) return Status::ok;
    const int8_t axis = axis_least_along(grid.difference(actual_->balls(), v, w));
    const BorderPoint anywhere{BorderPoint::Kind::on_crease, axis, {v, w, no_id}};
    if (!in_patch(anywhere, v) || in_other_probe(anywhere, v, w, w)) return Status::ok;
    if (!in_patch(anywhere, w)) return Status::degenerate;
    creases_.push({no_id, no_id});
    return Status::ok;
  }
  for (uint32_t k = 1; k < n; ++k) {
    ends[k].in_second_half = actual_->turn(v, w, point(ends[0].number), point(ends[k].number)) < 0;
  }
  for (uint32_t k = 2; k < n; ++k) {
    const End moved = ends[k];
    uint32_t to = k;
    for (; to > 1; --to) {
      const End &before = ends[to - 1];
      const bool in_order = before.in_second_half != moved.in_second_half
                                ? moved.in_second_half
                                : actual_->turn(v, w, point(before.number), point(moved.number)) > 0;
      if (in_order) break;
      ends[to] = before;
    }
    ends[to] = moved;
  }
  for (uint32_t k = 0; k < n; ++k) {
    const End &end = ends[k], &next = ends[k + 1 < n ? k + 1 : 0];
    if (end.starts == next.starts) return Status::degenerate;
    if (end.starts) creases_.push({end.number, next.number});
  }
  return Status::ok;
}

}  // namespace hsp
