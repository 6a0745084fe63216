// The loops that bound what is painted of one ball: how many there are by hand, that they are chained, and that the
// front of a ball's faces is its front hemisphere outside all others.
#pragma once

#include "small_scenes.hpp"
#include "small_view.hpp"

namespace cases {

inline hsp::CubeBlock block_around(uint32_t ball) {
  const hsp::CubeGrid &grid = small_union().grid();
  return grid.block_around(grid.cube_at(grid.balls().ball(ball).centre));
}

inline constexpr hsp::exact::Vector along_z{0, 0, 1};

// Ball 0, seen along the z axis, outside those of the others that cut it.
struct Cut {
  uint32_t n;
  SmallBall ball[6];
  uint32_t cutting;  // bit k: ball k does
  uint32_t half_edges, loops, circles;
};
constexpr Cut cuts[] = {
    {1, {{0, 0, 0, 500}}, 0, 0, 0, 1},
    // Beside it, before it and behind it.
    {2, {{0, 0, 0, 500}, {600, 0, 0, 500}}, 2, 2, 1, 0},
    {2, {{0, 0, 0, 500}, {600, 0, 0, 500}}, 0, 0, 0, 1},
    {2, {{0, 0, 0, 500}, {0, 0, 600, 500}}, 2, 0, 0, 2},
    {2, {{0, 0, 0, 500}, {0, 0, -600, 500}}, 2, 0, 0, 1},
    // The whole front is in another ball, or the whole ball.
    {2, {{0, 0, 0, 500}, {0, 0, 400, 700}}, 2, 0, 0, 0},
    {2, {{0, 0, 0, 500}, {0, 0, 100, 700}}, 2, 0, 0, 0},
    // A strip between two balls; one of them alone; a ring with a bite; two balls that meet; a strip in two parts.
    {3, {{0, 0, 0, 500}, {600, 0, 0, 500}, {-600, 0, 0, 500}}, 6, 4, 1, 0},
    {3, {{0, 0, 0, 500}, {600, 0, 0, 500}, {-600, 0, 0, 500}}, 4, 2, 1, 0},
    {3, {{0, 0, 0, 500}, {0, 0, 600, 500}, {-600, 0, -10, 300}}, 6, 2, 1, 1},
    {3, {{0, 0, 0, 500}, {600, 0, 0, 500}, {0, 0, 600, 500}}, 6, 4, 1, 0},
    {3, {{0, 0, 0, 500}, {500, 0, 450, 550}, {-500, 0, 450, 550}}, 6, 6, 2, 0},
    // As many vertices as five caps and the back can have: 6 times 6 less 12.
    {6,
     {{0, 0, 0, 1000},
      {0, 0, 1638, 1000},
      {1329, 0, 484, 1000},
      {0, 1329, 484, 1000},
      {-1329, 0, 484, 1000},
      {0, -1329, 484, 1000}},
     62,
     24,
     8,
     0}};

inline uint32_t loops_by_hand() {
  return first_failing(cuts, [](const Cut &c) {
    // With room for the neighbours that there are, no more.
    hsp::ViewLimits limits = SmallView::roomy;
    limits.neighbours = c.n - 1;
    if (!small_view().build(c.ball, c.n, {}, limits)) return false;
    hsp::VisiblePiece &piece = small_view().piece();
    const uint32_t own = small_union().grid().grid_index(0);
    const auto is_cutting = [&](uint32_t other) { return (c.cutting >> small_view().balls().caller[other] & 1) != 0; };
    piece.cut_hemisphere(small_view().balls(), block_around(own), along_z, own, is_cutting);
    uint32_t loops = 0;
    for (const hsp::PieceHalfEdge &half_edge : piece.half_edges()) {
      loops = half_edge.loop >= loops ? half_edge.loop + 1 : loops;
    }
    return piece.half_edges().size() == c.half_edges && loops == c.loops && piece.circles().size() == c.circles;
  });
}

// Each ball of a scene from every direction.
template <class Holds>
bool holds_everywhere(const SmallBall *balls, uint32_t n, Holds holds) {
  constexpr hsp::exact::Vector directions[] = {{0, 0, 1},   {0, 0, -1}, {0, 1, 0},  {3, 1, 2},  {-5, 2, 1},
                                               {1, -4, -2}, {3, -2, 0}, {-3, 2, 0}, {0, 2, -1}, {0, -2, 1}};
  if (!small_view().build(balls, n)) return false;
  for (const hsp::exact::Vector &direction : directions) {
    for (uint32_t i = 0; i < n; ++i) {
      if (!holds(small_view().piece(), direction, i)) return false;
    }
  }
  return true;
}

// Vertices exactly on silhouettes, and circles that touch them.
struct TiedScene {
  uint32_t n;
  SmallBall ball[3];
};
constexpr TiedScene tied_scenes[] = {{3, {{0, 0, 0, 7}, {4, 0, 0, 7}, {0, 6, 0, 7}}},
                                     {3, {{4, 6, 0, 7}, {0, 6, 0, 7}, {4, 0, 0, 7}}},
                                     {2, {{0, 0, 0, 25}, {18, 0, 24, 25}}},
                                     {2, {{0, 0, 0, 25}, {-18, 0, 24, 25}}}};

// A half-edge is followed by one that starts on its circle; loops are numbered by their first half-edges.
inline bool is_chained(const hsp::VisiblePiece &piece) {
  const hsp::Span<const hsp::PieceHalfEdge> all = piece.half_edges();
  uint32_t loops = 0;
  for (uint32_t k = 0; k < all.size(); ++k) {
    if (all[k].loop > loops) return false;
    if (all[k].loop < loops) continue;
    uint32_t passed = 0;
    uint32_t e = k;
    do {
      const hsp::PieceHalfEdge &next = all[all[e].next];
      if (all[e].loop != loops || next.previous_circle != all[e].circle || ++passed > all.size()) return false;
      e = all[e].next;
    } while (e != k);
    for (const hsp::PieceHalfEdge &other : all) passed -= other.loop == loops ? 1 : 0;
    if (passed != 0) return false;
    ++loops;
  }
  return true;
}

// The front of the faces and the front hemisphere outside all others, which are found in different ways, are the same.
inline bool front_of_faces_is_outside_all(hsp::VisiblePiece &piece, const hsp::exact::Vector &direction, uint32_t i) {
  const hsp::BallSet &balls = small_view().balls();
  const hsp::CubeBlock block = block_around(i);
  piece.cut_hemisphere(balls, block, direction, i, [](uint32_t) { return true; });
  if (!is_chained(piece)) return false;
  hsp::PieceHalfEdge kept[60];
  uint32_t kept_circles[12];
  const uint32_t count = piece.half_edges().size(), circles = piece.circles().size();
  if (count > 60 || circles > 12) return false;
  for (uint32_t k = 0; k < count; ++k) kept[k] = piece.half_edges()[k];
  for (uint32_t k = 0; k < circles; ++k) kept_circles[k] = piece.circles()[k];

  piece.cut_faces(balls, block, small_union().boundary(), direction, i);
  if (piece.half_edges().size() != count || piece.circles().size() != circles) return false;
  for (uint32_t k = 0; k < count; ++k) {
    const hsp::PieceHalfEdge &a = kept[k], &b = piece.half_edges()[k];
    if (a.circle != b.circle || a.previous_circle != b.previous_circle || a.next != b.next || a.loop != b.loop) {
      return false;
    }
  }
  for (uint32_t k = 0; k < circles; ++k) {
    if (kept_circles[k] != piece.circles()[k]) return false;
  }
  return true;
}

inline uint32_t fronts_of_faces() {
  return first_failing(scenes,
                       [](const Scene &c) { return holds_everywhere(c.ball, c.n, front_of_faces_is_outside_all); });
}
inline uint32_t fronts_of_faces_with_ties() {
  return first_failing(tied_scenes,
                       [](const TiedScene &c) { return holds_everywhere(c.ball, c.n, front_of_faces_is_outside_all); });
}

inline constexpr Check view_visible_piece[] = {{"loops_by_hand", loops_by_hand},
                                               {"fronts_of_faces", fronts_of_faces},
                                               {"fronts_of_faces_with_ties", fronts_of_faces_with_ties}};

}  // namespace cases
