#include "view/visible_piece.hpp"

#include "core/sorting.hpp"
#include "sphere/cap_pair.hpp"

namespace hsp {
namespace {

using exact::Plane;

// Tells whether a crossing point of two circles, or a circle that does not cross the silhouette, lies on the half of
// the sphere behind the centre, which is the last cap.
class BackHalf {
 public:
  explicit BackHalf(const Caps &caps) : caps_(caps), predicates_(caps.predicates()), back_(caps.count - 1) {}

  bool holds_point(uint32_t in, uint32_t out) const {
    const CapPair pair(caps_, in, out);
    if (pair.certainly_cross()) {
      const CrossingPoints points(caps_, in, out, pair);
      const double depth =
          caps_.ux[back_] * points.x[1] + caps_.uy[back_] * points.y[1] + caps_.uz[back_] * points.z[1];
      if (depth > points.error) return true;
      if (depth < -points.error) return false;
    }
    return predicates_.inside(caps_.plane(in), caps_.plane(out), +1, caps_.plane(back_)) > 0;
  }
  bool meets_circle(uint32_t cap) const {
    const CapPair pair(caps_, cap, back_);
    if (pair.certainly_cross()) return true;
    if (pair.certainly_apart() && pair.certainly_inside()) return true;
    if (pair.certainly_apart() && pair.certainly_outside()) return false;
    return predicates_.crossing(caps_.plane(cap), caps_.plane(back_)).sign > 0 ||
           predicates_.side(caps_.plane(cap), caps_.plane(back_)).sign > 0;
  }

 private:
  const Caps &caps_;
  const exact::Predicates predicates_;
  const uint32_t back_;
};

exact::Vector opposite(const exact::Vector &v) {
  return {-v.x, -v.y, -v.z};
}

}  // namespace

// The union of m caps of one sphere has at most 6 m - 12 vertices, for m >= 3.
void VisiblePiece::carve(Workspace &workspace, uint32_t neighbours) {
  const uint64_t caps = static_cast<uint64_t>(neighbours) + 1;
  planes_ = workspace.take<exact::Plane>(caps);
  caps_.carve(workspace, neighbours);
  finder_.carve(workspace, neighbours + 1);
  vertices_ = FixedVector<VertexRecord>(workspace.take<VertexRecord>(6 * caps));
  circles_ = FixedVector<CircleRecord>(workspace.take<CircleRecord>(caps));
  half_edges_ = workspace.take<PieceHalfEdge>(6 * caps);
  const Span<uint32_t> arriving = workspace.take<uint32_t>(caps);
  chain_ = HalfEdgeChain(arriving, workspace.take<uint32_t>(caps));
  whole_ = workspace.take<uint32_t>(caps);
}

// False if the ball has no piece or there is no room for its caps.
bool VisiblePiece::gather(const BallSet &balls, const CubeBlock &block, uint32_t i) {
  half_edge_count_ = 0;
  circle_count_ = 0;
  vertices_.clear();
  circles_.clear();
  caps_.gather(balls, block, i, nullptr);
  caps_.first_later = 0;
  return !caps_.contained && !caps_.overflowed();
}

void VisiblePiece::find_all(const BallSet &balls, const exact::Vector &direction) {
  const exact::Vector back = opposite(direction);
  const bool many = ExposedCaps::are_many(caps_);
  if (many && !finder_.keep_exposed(caps_)) return;
  caps_.add_half_sphere(back);
  if (!finder_.search(balls, caps_, !many, vertices_, circles_) && !small_code) {  // small code never gives up
    --caps_.count;
    if (!finder_.exposed_caps().keep(ExposedCaps::Part::sphere, caps_, 0)) return;
    caps_.add_half_sphere(back);
    finder_.find(balls, caps_, vertices_, circles_);
  }
  link();
}

void VisiblePiece::cut_faces(const BallSet &balls, const CubeBlock &block, const Boundary &boundary,
                             const exact::Vector &direction, uint32_t i) {
  if (!gather(balls, block, i)) return;
  caps_.add_half_sphere(opposite(direction));
  finder_.find_on_last(balls, caps_, vertices_, circles_);
  add_front_of_faces(boundary);
  link();
}

// At the vertex p+ of circles j and k a loop of a face comes in along j and leaves along k.
void VisiblePiece::add_front_of_faces(const Boundary &boundary) {
  const BackHalf back(caps_);
  const uint32_t i = caps_.origin;
  for (const uint32_t u : boundary.half_edges(i)) {
    const HalfEdge &half_edge = boundary.half_edge(u);
    const uint32_t previous_circle = boundary.previous_circle(i, half_edge);
    if (back.holds_point(caps_.cap_of(previous_circle), caps_.cap_of(half_edge.circle))) continue;
    vertices_.push({{i, previous_circle, half_edge.circle}, VertexRecord::positive_bit});
  }
  for (const ClosedHalfEdge closed : boundary.circles(i)) {
    const uint32_t other = boundary.neighbour(closed);
    if (!back.meets_circle(caps_.cap_of(other))) circles_.push({{i, other}, {no_id, no_id}});
  }
}

// Chains half-edges to loops, in an order that does not depend on ids.
void VisiblePiece::link() {
  for (const VertexRecord &vertex : vertices_.items()) {
    const uint32_t first = caps_.cap_of(vertex.ball[1]);
    const uint32_t second = caps_.cap_of(vertex.ball[2]);
    const bool positive = vertex.positive();
    half_edges_[half_edge_count_++] = {positive ? first : second, positive ? second : first, no_id, no_id};
  }
  for (const CircleRecord &circle : circles_.items()) whole_[circle_count_++] = caps_.cap_of(circle.ball[1]);
  for (uint32_t k = 0; k < caps_.count; ++k) planes_[k] = caps_.plane(k);
  const auto by_rank = [this](uint32_t a, uint32_t b) { return exact::ranks_before(planes_[a], planes_[b]); };
  sort_in_place(whole_.part(0, circle_count_), by_rank);
  const Span<PieceHalfEdge> items = half_edges_.part(0, half_edge_count_);
  sort_in_place(items, [&by_rank](const PieceHalfEdge &a, const PieceHalfEdge &b) {
    return a.circle != b.circle ? by_rank(a.circle, b.circle) : by_rank(a.previous_circle, b.previous_circle);
  });
  chain_.link(items, 0, &PieceHalfEdge::previous_circle, [this](uint32_t cap) { return planes_[cap].v; });
  uint32_t loops = 0;
  for (uint32_t start = 0; start < items.size(); ++start) {
    if (items[start].loop != no_id) continue;
    for (uint32_t e = start; items[e].loop == no_id; e = items[e].next) items[e].loop = loops;
    ++loops;
  }
}

}  // namespace hsp
