// The arcs of pieces: spans and starts that follow from one arc cosine, and windings against points of the front.
#pragma once

#include "small_scenes.hpp"
#include "small_view.hpp"
#include "view/piece_arcs.hpp"

namespace cases {

// The front hemisphere of one ball outside all others, as the only piece of a view.
class OnePiece {
 public:
  OnePiece(const hsp::exact::Vector &towards, uint32_t ball, uint32_t most_arcs = 60) {
    const double v[3] = {static_cast<double>(towards.x), static_cast<double>(towards.y),
                         static_cast<double>(towards.z)};
    const hsp::BallSet &balls = small_view().balls();
    hsp::look_from({{v[0], v[1], v[2]}, {0, 1, 0}}, view_.frame);
    hsp::VisiblePiece &piece = small_view().piece();
    const hsp::CubeGrid &grid = small_union().grid();
    piece.cut_hemisphere(balls, grid.block_around(grid.cube_at(balls.ball(ball).centre)), view_.frame.direction, ball,
                         [](uint32_t) { return true; });
    view_.pieces = hsp::FixedVector<hsp::PieceRecord>({piece_memory_, 1});
    view_.loops = hsp::FixedVector<uint32_t>({loop_memory_, most_arcs});
    view_.arcs = hsp::FixedVector<hsp::ArcRecord>({arc_memory_, most_arcs});
    hsp::add_loops(balls, piece, view_);
    view_.pieces.push({ball, 0, view_.loops.size(), 0, view_.arcs.size()});
  }
  const hsp::View &view() const { return view_; }

 private:
  hsp::View view_;
  hsp::PieceRecord piece_memory_[1];
  uint32_t loop_memory_[60];
  hsp::ArcRecord arc_memory_[60];
};

constexpr double whole = 2 * hsp::pi;
constexpr uint32_t nothing = 9;

// Arcs of ball 0, whose centre is the origin, seen along the z axis.
struct HandArc {
  uint32_t other;  // a ball of the input; nothing: the silhouette
  double span;     // to - from
  double start[2];
};
struct HandPiece {
  uint32_t n;
  SmallBall ball[3];
  uint32_t loops, arcs;
  HandArc arc[4];  // in any order
};
// 12.5 sqrt(7).
constexpr double y_75 = 33.07189138830738;
constexpr HandPiece hand_pieces[] = {
    {1, {{0, 0, 0, 5}}, 1, 1, {{nothing, whole, {-5, 0}}}},
    // Circles before the silhouette: face on, and shortened to .8.
    {2, {{0, 0, 0, 5}, {0, 0, 6, 5}}, 2, 2, {{nothing, whole, {-5, 0}}, {1, -whole, {-4, 0}}}},
    {2, {{0, 0, 0, 50}, {48, 0, 64, 50}}, 2, 2, {{nothing, whole, {-50, 0}}, {1, -whole, {24, -30}}}},
    {2, {{0, 0, 0, 50}, {48, 0, -64, 50}}, 1, 1, {{nothing, whole, {-50, 0}}}},
    // Edge on: the silhouette without 2 acos .6, and half of a circle.
    {2, {{0, 0, 0, 5}, {6, 0, 0, 5}}, 1, 2, {{nothing, 4.42859487, {3, 4}}, {1, -whole / 2, {3, -4}}}},
    {2, {{0, 0, 0, 5}, {0, -6, 0, 5}}, 1, 2, {{nothing, 4.42859487, {4, -3}}, {1, -whole / 2, {-4, -3}}}},
    {3,
     {{0, 0, 0, 5}, {-8, 0, 0, 5}, {8, 0, 0, 5}},
     1,
     4,
     {{nothing, 1.85459044, {4, 3}},
      {nothing, 1.85459044, {-4, -3}},
      {1, -whole / 2, {-4, 3}},
      {2, -whole / 2, {4, -3}}}},
    // The silhouette without 2 acos .75, and pi plus or less 2 asin .5625 of a circle before or behind.
    {2,
     {{0, 0, 0, 50}, {48, 0, 36, 50}},
     1,
     2,
     {{nothing, 4.837716811552756, {37.5, y_75}}, {1, -4.336405487, {37.5, -y_75}}}},
    {2,
     {{0, 0, 0, 50}, {48, 0, -36, 50}},
     1,
     2,
     {{nothing, 4.837716811552756, {37.5, y_75}}, {1, 1.946779820, {37.5, -y_75}}}},
    // Circles that touch the silhouette: by the symbolic perturbation those of equal balls cross it. The arc behind is
    // no more than the point. Those of a small ball nearby move away.
    {2, {{0, 0, 0, 50}, {36, 0, 48, 50}}, 1, 2, {{nothing, whole, {50, 0}}, {1, -whole, {50, 0}}}},
    {2, {{0, 0, 0, 50}, {36, 0, -48, 50}}, 1, 2, {{nothing, whole, {50, 0}}, {1, 0, {50, 0}}}},
    {2, {{0, 0, 0, 150}, {33, 0, 44, 125}}, 2, 2, {{nothing, whole, {-150, 0}}, {1, -whole, {54, -120}}}},
    {2, {{0, 0, 0, 150}, {33, 0, -44, 125}}, 1, 1, {{nothing, whole, {-150, 0}}}},
    {2, {{0, 0, 0, 50}, {-36, 0, 48, 50}}, 1, 2, {{nothing, whole, {-50, 0}}, {1, -whole, {-50, 0}}}},
    {2, {{0, 0, 0, 50}, {-36, 0, -48, 50}}, 1, 2, {{nothing, whole, {-50, 0}}, {1, 0, {-50, 0}}}}};

inline uint32_t arcs_by_hand() {
  return first_failing(hand_pieces, [](const HandPiece &c) {
    if (!small_view().build(c.ball, c.n)) return false;
    const OnePiece piece({0, 0, 1}, small_union().grid().grid_index(0));
    const hsp::View &view = piece.view();
    if (view.loops.size() != c.loops || view.arcs.size() != c.arcs) return false;
    uint32_t found = 0;
    for (const hsp::ArcRecord &arc : view.arcs.items()) {
      const uint32_t other = arc.other_ball == hsp::no_id ? nothing : small_view().balls().caller[arc.other_ball];
      for (uint32_t k = 0; k < c.arcs; ++k) {
        const HandArc &e = c.arc[k];
        if (other == e.other && near(arc.to - arc.from, e.span, 1e-8) && near(arc.start[0], e.start[0], 1e-12 * 50) &&
            near(arc.start[1], e.start[1], 1e-12 * 50)) {
          found |= UINT32_C(1) << k;
        }
      }
    }
    return found + 1 == UINT32_C(1) << c.arcs;
  });
}

// A point of the disc is within the loops, once, if the ball's front there is outside all other balls; points near a
// circle are left out.
inline bool winds_around_what_is_free(const OnePiece &one, uint32_t i, uint32_t &compared) {
  const hsp::BallSet &balls = small_view().balls();
  const hsp::Vec3 centre = one.view().frame.centre_of(balls, i);
  const double r = balls.r[i];
  for (int row = -8; row < 8; ++row) {
    for (int column = -8; column < 8; ++column) {
      const double x = centre.x + r * (column + .437) / 7, y = centre.y + r * (row + .561) / 7;
      const double distance = std::sqrt((x - centre.x) * (x - centre.x) + (y - centre.y) * (y - centre.y));
      if (near(distance, r, .01 * r)) continue;
      bool expected = distance < r, certain = true;
      const double z = front_of(balls, one.view().frame, i, x, y);
      for (uint32_t j = 0; j < balls.n && expected && certain; ++j) {
        if (j == i) continue;
        const hsp::Vec3 other = one.view().frame.centre_of(balls, j);
        const hsp::Vec3 v{x - other.x, y - other.y, z - other.z};
        certain = !near(std::sqrt(dot(v, v)), balls.r[j], .08 * r);
        expected = dot(v, v) > balls.r[j] * balls.r[j];
      }
      if (!certain) continue;
      ++compared;
      if (winding_number(balls, one.view(), 0, x, y) != (expected ? 1 : 0)) return false;
    }
  }
  return true;
}

inline uint32_t windings() {
  return first_failing(scenes, [](const Scene &c) {
    if (!small_view().build(c.ball, c.n)) return false;
    uint32_t compared = 0;
    constexpr hsp::exact::Vector directions[] = {{0, 0, 1}, {0, 0, -1}, {3, 1, 2}, {-5, 2, 1}};
    for (const hsp::exact::Vector &direction : directions) {
      for (uint32_t i = 0; i < c.n; ++i) {
        const OnePiece one(direction, i);
        for (const hsp::ArcRecord &arc : one.view().arcs.items()) {
          if (!(std::fabs(arc.to - arc.from) <= whole)) return false;
        }
        if (!winds_around_what_is_free(one, i, compared)) return false;
      }
    }
    return compared > 500 * c.n;  // of 4 times 256 points
  });
}

// Arcs of a whole turn, up to the symbolic perturbation: rounding must not make them longer.
struct WholeTurn {
  uint32_t n;
  SmallBall ball[4];
};
constexpr WholeTurn whole_turns[] = {{3, {{-3, 9, 3, 9}, {9, 9, 0, 6}, {-9, -3, 0, 15}}},
                                     {3, {{-4, 4, 0, 4}, {4, -6, -4, 4}, {-4, -6, -2, 6}}},
                                     {3, {{6, 6, 6, 9}, {9, 6, 9, 9}, {6, -6, 3, 6}}},
                                     {4, {{-2, -6, 2, 4}, {-4, 6, -6, 6}, {-2, 2, 4, 6}, {6, 2, 2, 4}}}};

inline uint32_t whole_turns_are_no_more() {
  return first_failing(whole_turns, [](const WholeTurn &c) {
    if (!small_view().build(c.ball, c.n)) return false;
    double longest_span = 0;
    for (uint32_t i = 0; i < c.n; ++i) {
      const OnePiece one({1, 1, 0}, i);
      if (one.view().loops.size() == one.view().arcs.size()) continue;  // no vertices
      for (const hsp::ArcRecord &arc : one.view().arcs.items()) {
        longest_span = std::fmax(longest_span, std::fabs(arc.to - arc.from));
      }
    }
    return longest_span <= whole && longest_span > whole - 1e-9;
  });
}

inline uint32_t arcs_that_do_not_fit_are_counted() {
  return first_failing(hand_pieces, [](const HandPiece &c) {
    if (!small_view().build(c.ball, c.n)) return false;
    for (uint32_t most = 0; most <= c.arcs; ++most) {
      const OnePiece piece({0, 0, 1}, small_union().grid().grid_index(0), most);
      if (piece.view().arcs.required() != c.arcs || piece.view().loops.required() != c.loops) return false;
    }
    return true;
  });
}

inline constexpr Check view_piece_arcs[] = {{"arcs_by_hand", arcs_by_hand},
                                            {"windings", windings},
                                            {"whole_turns_are_no_more", whole_turns_are_no_more},
                                            {"arcs_that_do_not_fit_are_counted", arcs_that_do_not_fit_are_counted}};

}  // namespace cases
