// One worker's part of the boundary: from the balls of its cubes to half-edges, loops and faces.
//
// As an example ten balls in three cubes, 0 to 3, 4 and 5, 6 to 9, for three workers. Worker w begins with the first
// cube that begins at or behind ball 10 w / 3:
//   worker     10 w / 3      cubes     balls
//      0          0            0       0 to 3
//      1          3            1       4 and 5
//      2          6            2       6 to 9
// A cube is never shared: its neighbours are looked up once for all of its balls. A worker may be left without cubes.
#include "boundary/boundary_worker.hpp"

#include "core/first_index.hpp"
#include "core/small_code.hpp"
#include "exact/discriminant.hpp"
#include "model/block_sweep.hpp"
#include "sphere/root_discriminants.hpp"

namespace hsp {
namespace {

// The first cube that begins at or behind a ball.
uint32_t cube_from(const CubeGrid &grid, uint32_t ball) {
  return first_index(0, grid.own_cubes(), [&grid, ball](uint32_t cube) { return grid.balls_in(cube).first >= ball; });
}

// Memory for candidates during the search: that of the half-edges, which come later, or the scratch memory if that is
// larger.
Span<uint32_t> idle_while_searching(const BoundaryArrays &arrays, Span<uint32_t> scratch) {
  const Span<HalfEdge> half_edges = arrays.half_edges;
  const uint64_t words = uint64_t{half_edges.size()} * sizeof(HalfEdge) / sizeof(uint32_t);
  if (words <= scratch.size()) return scratch;
  return {reinterpret_cast<uint32_t *>(half_edges.data()),
          static_cast<uint32_t>(words <= UINT32_MAX ? words : UINT32_MAX)};
}

// In cubes of so many balls each ball is first compared with the largest ball around: if balls are nested, most lie in
// that one.
constexpr uint32_t many_in_a_cube = 64;

// Whether balls of a cube may lie in balls with the same centre: if there are many, or if two consecutive ones have the
// same x.
bool may_be_nested(const BallSet &balls, BallRange own) {
  if (small_code) return false;
  if (own.last - own.first >= many_in_a_cube) return true;
  uint32_t same = 0;
  for (uint32_t i = own.first + 1; i < own.last; ++i) same |= static_cast<uint32_t>(balls.x[i - 1] == balls.x[i]);
  return same != 0;
}

// The largest of ball `largest` and those of the range. Of equal balls the first, which contains the others.
uint32_t largest_ball(const BallSet &balls, BallRange range, uint32_t largest) {
  for (uint32_t j = range.first; j < range.last; ++j) largest = balls.r[j] > balls.r[largest] ? j : largest;
  return largest;
}

// The largest of the balls around a cube; no_id if these are so many that looking at them takes longer than it saves.
uint32_t largest_ball(const BallSet &balls, const CubeBlock &block, BallRange own) {
  uint32_t all = 0;
  for (uint32_t k = 0; k < block.ranges; ++k) all += block.range[k].last - block.range[k].first;
  if (block.levels != nullptr && all / 16 > own.last - own.first) return no_id;
  uint32_t largest = block.range[0].first;
  for (uint32_t k = 0; k < block.ranges; ++k) largest = largest_ball(balls, block.range[k], largest);
  return largest;
}

// The balls with the centre of ball i, from i on: in grid order such balls of one cube follow each other, from small to
// large ones.
BallRange concentric(const BallSet &balls, uint32_t i, uint32_t end_of_cube) {
  uint32_t last = i + 1;
  const auto has_centre = [&](uint32_t j) {
    return balls.x[j] == balls.x[i] && balls.y[j] == balls.y[i] && balls.z[j] == balls.z[i];
  };
  while (last < end_of_cube && has_centre(last)) ++last;
  return {i, last};
}

}  // namespace

BallShare share_of(const CubeGrid &grid, uint32_t worker, uint32_t workers) {
  // n w / workers, in 32 bits.
  const auto first_cube = [&grid, workers](uint32_t w) {
    const uint32_t n = grid.own_balls();
    return cube_from(grid, n / workers * w + n % workers * w / workers);
  };
  const auto first_ball = [&grid](uint32_t cube) {
    return cube < grid.own_cubes() ? grid.balls_in(cube).first : grid.own_balls();
  };
  const uint32_t first = first_cube(worker);
  const uint32_t last = first_cube(worker + 1);
  return {first, last, {first_ball(first), first_ball(last)}};
}

BoundaryWorker::BoundaryWorker() = default;

void BoundaryWorker::carve(Workspace &workspace, const BoundaryLimits &limits, BoundaryArrays &arrays, uint32_t worker,
                           Span<uint32_t> scratch) {
  caps.carve(workspace, limits.neighbours);
  finder_.carve(workspace, limits.neighbours);
  face_finder_.carve(workspace, limits.neighbours);
  lanes.carve(workspace, limits.neighbours);
  workspace.take_each(limits.balls, arriving_, leaving_);
  if (worker == 0) {
    vertices_ = arrays.vertices;
    circles_ = arrays.circles;
    parent_ = arrays.component_origin;
    idle_while_searching_ = idle_while_searching(arrays, scratch);
    return;
  }
  vertices_ = FixedVector<VertexRecord>(workspace.take<VertexRecord>(limits.vertices));
  circles_ = FixedVector<CircleRecord>(workspace.take<CircleRecord>(limits.circles));
  parent_ = workspace.take<uint32_t>(limits.balls);
  idle_while_searching_ = LaneSearch::take_candidates(workspace, limits.neighbours);
}

void BoundaryWorker::start(const BallShare &share, const uint32_t *selected, bool joins, const Executor *executor) {
  patience_ = Patience(executor);
  caps.met = 0;
  share_ = share;
  selected_ = selected;
  joins_ = joins;
  vertices_.clear();
  circles_.clear();
  met_ = {share.balls.first, share.balls.first};
  neighbours_ = 0;
}

// Every ball of the block that is not in a set becomes a set by itself.
void BoundaryWorker::cover(const CubeBlock &block) {
  const uint32_t first = block.range[0].first;
  const uint32_t last = block.range[block.ranges - 1].last;
  while (met_.first > first) {
    --met_.first;
    parent_[met_.first] = met_.first;
  }
  for (; met_.last < last; ++met_.last) parent_[met_.last] = met_.last;
}

// Cube by cube, so that the block of neighbouring cubes is looked up once for all balls of a cube.
void BoundaryWorker::search(const CubeGrid &grid, uint8_t *ball_state) {
  const BallSet &balls = grid.balls();
  DisjointSets components(parent_.part(0, balls.n));
  DisjointSets *const joined = joins_ ? &components : nullptr;
  BlockSweep sweep(grid);
  lanes.start(idle_while_searching_);
  for (uint32_t cube = share_.first_cube; cube < share_.last_cube; ++cube) {
    const BallRange own = grid.balls_in(cube);
    if (leaves_out(own)) {
      for (uint32_t i = own.first; i < own.last; ++i) ball_state[i] = BoundaryArrays::left_out;
      continue;
    }
    const CubeBlock &block = sweep.block_around(cube);
    cover(block);
    const bool in_lanes = lanes.start_cube(grid, cube, block);
    if (may_be_nested(balls, own)) {
      search_nested(balls, block, own, in_lanes, joined, ball_state);
    } else {
      for (uint32_t i = own.first; i < own.last; ++i) search_ball(balls, block, i, in_lanes, joined, ball_state);
    }
  }
  lanes.end();
}

// Searches the balls of one cube. Balls inside another one with the same centre are contained and are not searched; if
// the cube has many balls, nor are the others that lie inside the largest ball around.
void BoundaryWorker::search_nested(const BallSet &balls, const CubeBlock &block, BallRange own, bool in_lanes,
                                   DisjointSets *components, uint8_t *ball_state) {
  const uint32_t largest = own.last - own.first >= many_in_a_cube ? largest_ball(balls, block, own) : no_id;
  for (uint32_t i = own.first; i < own.last;) {
    const BallRange around_centre = concentric(balls, i, own.last);
    const uint32_t outermost = largest_ball(balls, around_centre, i);
    for (; i < around_centre.last; ++i) {
      uint32_t outer = outermost;
      if (i == outermost && largest != no_id && lies_inside(balls, i, largest)) outer = largest;
      if (outer == i || is_left_out(i)) {
        search_ball(balls, block, i, in_lanes, components, ball_state);
        continue;
      }
      if (components != nullptr) components->join(i, outer);
      ball_state[i] = BoundaryArrays::contained | BoundaryArrays::without_caps;
    }
  }
}

// Whether all balls of a range are left out.
bool BoundaryWorker::leaves_out(BallRange range) const {
  if (selected_ == nullptr) return false;
  for (uint32_t i = range.first; i < range.last; ++i) {
    if (!is_left_out(i)) return false;
  }
  return true;
}

// If balls are left out, a record may have a ball that is left out and comes before the ball at which it was found. So
// its balls are sorted. Every exchange of two balls changes the sign of a vertex.
void BoundaryWorker::order_balls_of_records(uint32_t first_vertex, uint32_t first_circle) {
  const auto before = [](uint32_t p, uint32_t q) { return p < q; };
  for (uint32_t v = first_vertex; v < vertices_.size(); ++v) {
    VertexRecord &vertex = vertices_[v];
    if (before(vertex.ball[0], vertex.ball[1])) continue;  // as most are: later balls ascend
    const OrderedVertex ordered = in_order(vertex, before);
    const uint32_t tied = vertex.code & VertexRecord::tied_bit;
    vertex = {{ordered.ball[0], ordered.ball[1], ordered.ball[2]},
              tied | (ordered.sign > 0 ? VertexRecord::positive_bit : 0U)};
  }
  for (uint32_t c = first_circle; c < circles_.size(); ++c) {
    const auto [p, q] = circles_[c].ball;
    if (q < p) circles_[c] = {{q, p}, {no_id, no_id}};
  }
}

void BoundaryWorker::search(const BallSet &balls, const double (&centre)[3], double side, uint8_t *ball_state) {
  const CubeBlock everything{{{0, balls.n}}, 1};
  cover(everything);
  lanes.start(idle_while_searching_);
  const bool in_lanes = lanes.start_block(balls, everything, 0, centre, side);
  for (uint32_t i = 0; i < share_.balls.last; ++i) search_ball(balls, everything, i, in_lanes, nullptr, ball_state);
  lanes.end();
}

void BoundaryWorker::search_ball(const BallSet &balls, const CubeBlock &block, uint32_t i, bool in_lanes,
                                 DisjointSets *components, uint8_t *ball_state) {
  if (is_left_out(i)) {
    ball_state[i] = BoundaryArrays::left_out;
    return;
  }
  // An estimate from the ball before, as the neighbours of this one are not known yet.
  const uint64_t before = caps.met;
  if (!patience_.allows(2000 + (500 + before) * before)) return;
  // Once a ball has more neighbours than there is room for, only the largest number of neighbours is looked for.
  if (in_lanes && neighbours_ > caps.capacity() && lanes.certainly_meets_few(i, neighbours_)) return;
  const bool by_lanes = in_lanes && lanes.gather(balls, i, caps, components, selected_);
  if (!by_lanes) caps.gather(balls, block, i, components);
  if (!by_lanes && selected_ != nullptr) caps.put_selected_first(selected_);
  ball_state[i] = static_cast<uint8_t>((caps.contained ? BoundaryArrays::contained : 0) |
                                       (caps.count == 0 ? BoundaryArrays::without_caps : 0));
  if (caps.contained) return;
  if (caps.met > neighbours_) neighbours_ = caps.met;
  // In that case the vertices of further balls are not looked for.
  if (neighbours_ > caps.capacity()) return;
  uint32_t clusters = 0;
  const uint32_t first_vertex = vertices_.size(), first_circle = circles_.size();
  if (by_lanes) {
    clusters = lanes.find(balls, caps, finder_, face_finder_.idle_while_searching(), vertices_, circles_);
  } else if (finder_.keep_exposed(caps)) {
    if (NearCaps::are_many(caps, caps.b.data())) {
      finder_.find(balls, caps, face_finder_.idle_while_searching().near_caps(), vertices_, circles_);
    } else if (CapBoxes::are_many(caps)) {
      finder_.find(balls, caps, face_finder_.idle_while_searching().cap_boxes(), vertices_, circles_);
    } else {
      finder_.cull_and_find(balls, caps, vertices_, circles_);
    }
  }
  if (selected_ != nullptr) order_balls_of_records(first_vertex, first_circle);
  ball_state[i] |= static_cast<uint8_t>(face_finder_.count_clusters(caps, clusters) * BoundaryArrays::one_cluster);
}

void BoundaryWorker::find_root_discriminants(const BallSet &balls, uint32_t first, uint32_t last, BoundaryArrays &a) {
  const Span<const VertexRecord> vertices = a.vertices.room();
  const auto find_exactly = [&](uint32_t v) {
    const VertexRecord &vertex = vertices[v];
    const exact::LatticeBall origin = balls.ball(vertex.ball[0]);
    a.root_discriminant[v] =
        std::sqrt(exact::discriminant(exact::sphere_of(origin), exact::plane_of(origin, balls.ball(vertex.ball[1])),
                                      exact::plane_of(origin, balls.ball(vertex.ball[2]))));
  };
  if constexpr (has_lanes) {
    static_assert(sizeof(VertexRecord) == 4 * sizeof(uint32_t));
    uint32_t done = 0;
    const bool certain = first == last || find_roots_in_lanes(a.target, arrays_of(balls), vertices[first].ball,
                                                              last - first, &a.root_discriminant[first], done);
    for (uint32_t v = first; !certain && v < first + done; ++v) {
      if (a.root_discriminant[v] == doubtful_root) find_exactly(v);
    }
    first += done;
  }
  for (uint32_t v = first; v < last; ++v) find_exactly(v);
}

void BoundaryWorker::join_components(DisjointSets &components) const {
  for (uint32_t i = met_.first; i < met_.last; ++i) components.join(i, parent_[i]);
}

// Two balls that meet are around each other's cubes, and records are in the order of their first balls: records before
// the first ball that this worker has met are of no ball of its share. If balls are left out, the order may be another.
void BoundaryWorker::count(BoundaryArrays &a) {
  const auto first_met = [this](const auto &records, IdRange placed) {
    if (selected_ != nullptr) return UINT32_C(0);
    return first_index(0, placed.first, [&](uint32_t id) { return records[id].ball[0] >= met_.first; });
  };
  touching.balls = share_.balls;
  touching.vertices = {first_met(a.vertices, placed_vertices), placed_vertices.last};
  touching.circles = {first_met(a.circles, placed_circles), placed_circles.last};
  counts = count_half_edges(touching, patience_, a);
}

// The loops of a worker are numbered from the largest possible number of loops before its balls: a loop has two
// half-edges at least, or is closed. Faces are numbered likewise: a face has a loop, or is a whole sphere.
void BoundaryWorker::link(const BallSet &balls, BlockSweep &sweep, const Boundary &boundary, Span<uint32_t> scratch,
                          BoundaryArrays &a) {
  const BallRange own = share_.balls;
  const auto most_loops_before = [&a](uint32_t ball) {
    return a.first[ball].half_edge / 2 + a.first[ball].closed_half_edge;
  };
  const HalfEdgeChain chain(arriving_, leaving_, {met_.first, met_.last});
  loops.first = most_loops_before(own.first);
  loops.last = link_half_edges(balls, own, chain, loops.first, patience_, a);
  faces.first = loops.first + own.first;
  faces.last = face_finder_.find(balls, sweep, boundary, own, loops, faces.first, caps, finder_,
                                 scratch.part(loops.first, most_loops_before(own.last)), patience_, a);
}

void BoundaryWorker::move_down(uint32_t loops_down, uint32_t faces_down, BoundaryArrays &a) const {
  for (const uint32_t loop : loops) {
    a.loop_start[loop - loops_down] = a.loop_start[loop];
    a.loop_face[loop - loops_down] = a.loop_face[loop] - faces_down;
  }
  for (const uint32_t f : faces) {
    const FaceRecord &face = a.faces[f];
    a.faces[f - faces_down] = {face.ball, face.first_loop - loops_down, no_id};
  }
}

void BoundaryWorker::renumber(uint32_t loops_down, uint32_t faces_down, BoundaryArrays &a) const {
  const BallRange own = share_.balls;
  for (uint32_t i = own.first; i < own.last; ++i) {
    a.first[i].loop -= loops_down;
    a.first[i].face -= faces_down;
  }
  for (HalfEdge &half_edge : a.half_edges.part(a.first[own.first].half_edge, a.first[own.last].half_edge)) {
    half_edge.loop -= loops_down;
  }
  const Span<const ClosedHalfEdge> closed =
      a.closed_half_edge.part(a.first[own.first].closed_half_edge, a.first[own.last].closed_half_edge);
  for (const ClosedHalfEdge e : closed) a.circles[e.circle()].loop[e.side()] -= loops_down;
}

}  // namespace hsp
