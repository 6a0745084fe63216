#include "surface/creases.hpp"

#include "core/sorting.hpp"
#include "surface/actual_points.hpp"
#include "surface/covered_gaps.hpp"

namespace hsp {
namespace {

// Instructions for a pair or a triple of near vertices that doubles do not decide.
constexpr uint32_t of_a_pair = 20000;

bool comes_before(const CreaseCorner &a, const uint32_t (&vertex)[3]) {
  if (a.vertex[0] != vertex[0]) return a.vertex[0] < vertex[0];
  if (a.vertex[1] != vertex[1]) return a.vertex[1] < vertex[1];
  return a.vertex[2] < vertex[2];
}

}  // namespace

void Creases::carve(Workspace &workspace, uint32_t near, uint32_t creases, uint32_t corners) {
  near_ = FixedVector(workspace.take<uint32_t>(near));
  // A crease's pair has at most two corners with each other vertex, and the cusps of three circles.
  ends_ = FixedVector(workspace.take<CreaseEnd>(2 * uint64_t{near} + 6));
  creases_ = FixedVector(workspace.take<Crease>(creases));
  by_high_ = workspace.take<uint32_t>(creases);
  corners_ = FixedVector(workspace.take<CreaseCorner>(corners));
}

Status Creases::build(const ActualBalls &actual, const ChosenFaces &chosen, const ProbeGrid &grid,
                      const CuspedCircles &cusped, ProbeTriangles &triangles, Patience &patience) {
  actual_ = &actual;
  cusped_ = &cusped;
  first_cusp_ = 3 * actual.boundary().vertex_count();
  first_crease_corner_ = first_cusp_ + 2 * cusped.count();
  most_near_ = 0;
  creases_.clear();
  corners_.clear();
  NearVertices near(actual, chosen, grid, triangles, near_);
  const auto has_room = [this] { return most_near_ <= near_.capacity() && !corners_.overflowed(); };
  Status found = Status::ok;
  for (uint32_t v = 0; v < actual.boundary().vertex_count(); ++v) {
    const bool fits = near.find(v);
    most_near_ = larger_count(most_near_, clamped_count(near.required()));
    if (!fits) continue;
    if (!patience.allows(5000 + of_a_pair * near.asked()) || !find_corners(v, patience)) return Status::stopped;
    if (found == Status::ok && has_room()) found = find_creases(chosen, grid, v, patience);
    if (found == Status::stopped) return found;
  }
  if (!has_room()) {
    creases_.clear();
    return Status::capacity;
  }
  if (found != Status::ok || actual.answers().by_none != 0) return Status::degenerate;
  if (creases_.overflowed()) return Status::capacity;
  for (uint32_t k = 0; k < creases_.size(); ++k) by_high_[k] = k;
  sort_in_place(by_high_.part(0, creases_.size()), [this](uint32_t j, uint32_t k) {
    return creases_[j].high != creases_[k].high ? creases_[j].high < creases_[k].high : j < k;
  });
  return Status::ok;
}

// Whether three vertices are on one circle. Then they have no corner: it would be on the circle's axis, like the cusps.
bool Creases::on_one_circle(uint32_t a, uint32_t b, uint32_t c) const {
  const Boundary &boundary = actual_->boundary();
  uint32_t common = 0;
  for (const uint32_t ball : boundary.vertex(a).ball) {
    if (boundary.vertex(b).has(ball) && boundary.vertex(c).has(ball)) ++common;
  }
  return common >= 2;
}

// Finds the corners whose lowest vertex is a. False if `patience` stops it.
bool Creases::find_corners(uint32_t a, Patience &patience) {
  const Span<const uint32_t> others = near_.items();
  for (uint32_t k = 0; k < others.size(); ++k) {
    if (others[k] < a) continue;
    if (!patience.allows(of_a_pair * uint64_t{others.size() - k})) return false;
    for (uint32_t j = k + 1; j < others.size(); ++j) {
      const uint32_t b = others[k], c = others[j];
      const uint32_t corners = on_one_circle(a, b, c) ? 0 : actual_->corners(a, b, c, others);
      if ((corners & 1) != 0) corners_.push({{a, b, c}, -1});
      if ((corners & 2) != 0) corners_.push({{a, b, c}, 1});
    }
  }
  return true;
}

BorderPoint Creases::point(uint32_t corner) const {
  if (corner < first_cusp_) {
    return {BorderPoint::Kind::towards_ball,
            0,
            {corner / 3, actual_->boundary().vertex(corner / 3).ball[corner % 3], no_id},
            corner};
  }
  if (corner < first_crease_corner_) {
    const uint32_t k = (corner - first_cusp_) / 2, side = (corner - first_cusp_) % 2;
    return {BorderPoint::Kind::cusp,
            static_cast<int8_t>(side == 0 ? -1 : 1),
            {cusped_->ball(k, 0), cusped_->ball(k, 1), no_id},
            corner};
  }
  const CreaseCorner &own = corners_[corner - first_crease_corner_];
  return {
      BorderPoint::Kind::corner, static_cast<int8_t>(own.sign), {own.vertex[0], own.vertex[1], own.vertex[2]}, corner};
}

// Adds ends at cusps for a pair of vertices: those of each common circle whose covered gap lies between the two.
// Returns whether any common circle has cusps.
bool Creases::add_cusps(const ChosenFaces &chosen, uint32_t v, uint32_t w) {
  const Boundary &boundary = actual_->boundary();
  bool share = false;
  for_each_common_circle(boundary, v, w, [&](uint32_t slot, uint32_t e) {
    const uint32_t ball = boundary.vertex(v).ball[slot], k = cusped_->of_arc(ball, boundary.half_edge(e).circle);
    share = share || k != no_id;
    if (k == no_id || vertex_across_gap(actual_->balls(), boundary, chosen, ball, e) != w) return;
    for (uint32_t side = 0; side < 2; ++side) {
      const uint32_t number = first_cusp_ + 2 * k + side;
      ends_.push({number, actual_->starts_at_cusp(point(number), v, w) > 0, false});
    }
  });
  return share;
}

// Adds the corners of v, w and x as ends of creases of v and w.
void Creases::add_corner_ends(uint32_t v, uint32_t w, uint32_t x) {
  const uint32_t vertex[3] = {x < v ? x : v, x < v ? v : x < w ? x : w, x < w ? w : x};
  uint32_t c = first_index(0, corners_.size(), [&](uint32_t k) { return !comes_before(corners_[k], vertex); });
  for (; c < corners_.size(); ++c) {
    const CreaseCorner &corner = corners_[c];
    if (corner.vertex[0] != vertex[0] || corner.vertex[1] != vertex[1] || corner.vertex[2] != vertex[2]) return;
    const uint32_t number = first_crease_corner_ + c;
    ends_.push({number, ActualBalls::starts_at_corner(point(number), v, w), false});
  }
}

// Finds the creases whose lower vertex is v.
Status Creases::find_creases(const ChosenFaces &chosen, const ProbeGrid &grid, uint32_t v, Patience &patience) {
  for (const uint32_t w : near_.items()) {
    if (w < v) continue;
    if (!patience.allows(of_a_pair)) return Status::stopped;
    ends_.clear();
    if (!corners_.items().empty()) {
      for (const uint32_t x : near_.items()) {
        if (x != w) add_corner_ends(v, w, x);
      }
    }
    const bool share_cusps = add_cusps(chosen, v, w);
    if (ends_.overflowed()) return Status::degenerate;
    const Status status = add_creases(grid, v, w, share_cusps);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

// Sorts the ends of the pair at hand around the circle. They must be starts and ends of creases by turns.
Status Creases::add_creases(const ProbeGrid &grid, uint32_t v, uint32_t w, bool share_cusps) {
  Span<CreaseEnd> ends = ends_.items();
  const uint32_t n = ends.size();
  if (n == 0) {
    if (share_cusps || actual_->overlap(v, w) <= 0) return Status::ok;
    const int8_t axis = axis_least_along(grid.difference(actual_->balls(), v, w));
    const BorderPoint anywhere{BorderPoint::Kind::on_crease, axis, {v, w, no_id}};
    if (actual_->is_left(anywhere, near_.items()) > 0) creases_.push({v, w, no_id, no_id});
    return Status::ok;
  }
  for (uint32_t k = 1; k < n; ++k) {
    ends[k].in_second_half = actual_->turn(v, w, point(ends[0].number), point(ends[k].number)) < 0;
  }
  sort_in_place(ends.part(1, n), [&](const CreaseEnd &a, const CreaseEnd &b) {
    if (a.in_second_half != b.in_second_half) return b.in_second_half;
    return actual_->turn(v, w, point(b.number), point(a.number)) <= 0;
  });
  for (uint32_t k = 0; k < n; ++k) {
    const CreaseEnd &end = ends[k], &next = ends[k + 1 < n ? k + 1 : 0];
    if (end.starts == next.starts) return Status::degenerate;
    if (end.starts) creases_.push({v, w, end.number, next.number});
  }
  return Status::ok;
}

}  // namespace hsp
