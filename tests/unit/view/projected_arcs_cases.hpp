// Circles of spheres in the view plane: their bases by Pythagorean numbers, and their points against the two spheres
// that they lie on.
#pragma once

#include "small_scenes.hpp"
#include "small_view.hpp"

namespace cases {

inline bool equals(const hsp::Vec3 &p, const hsp::Vec3 &q, double tolerance) {
  return near(p.x, q.x, tolerance) && near(p.y, q.y, tolerance) && near(p.z, q.z, tolerance);
}

// A normal, seen along the z axis; s = sqrt(v_x^2 + v_y^2) and the length of v are integers.
struct NormalBasis {
  hsp::exact::Vector v;
  hsp::Vec3 axis, along, across;
  double turn;
};
constexpr NormalBasis normal_bases[] = {
    // Seen from the front the outside of the half-space lies around the circle, from behind within it.
    {{3, 0, 4}, {.6, 0, .8}, {0, 1, 0}, {-.8, 0, .6}, -1},
    {{3, 0, -4}, {.6, 0, -.8}, {0, 1, 0}, {-.8, 0, -.6}, 1},
    {{-5, 0, 12}, {-5.0 / 13, 0, 12.0 / 13}, {0, -1, 0}, {12.0 / 13, 0, 5.0 / 13}, -1},
    {{0, 8, 6}, {0, .8, .6}, {-1, 0, 0}, {0, -.6, .8}, -1},
    {{3, 4, 12}, {3.0 / 13, 4.0 / 13, 12.0 / 13}, {-.8, .6, 0}, {-36.0 / 65, -48.0 / 65, 25.0 / 65}, -1},
    // Edge on, the minor axis is none.
    {{7, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, -1},
    {{-3, -4, 0}, {-.6, -.8, 0}, {.8, -.6, 0}, {0, 0, 1}, -1},
    // Face on, any axis is the major one.
    {{0, 0, 9}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, -1},
    {{0, 0, -9}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 1}};

inline uint32_t bases_of_circles() {
  const hsp::CircleFrame silhouette;
  if (silhouette.axis.z != -1 || silhouette.along.x != 1 || silhouette.across.y != 1 || silhouette.turn != 1) return 0;
  return first_failing(normal_bases, [](const NormalBasis &c) {
    const hsp::CircleFrame found(hsp::ViewFrame(), c.v);
    return equals(found.axis, c.axis, 1e-15) && equals(found.along, c.along, 1e-15) &&
           equals(found.across, c.across, 1e-15) && found.turn == c.turn;
  });
}

// Ball 0 of each scene and the circles in which its sphere meets those of others.
struct SeenCircle {
  SmallBall ball[2];
  double radius;
};
constexpr SeenCircle seen_circles[] = {{{{0, 0, 0, 5}, {8, 0, 0, 5}}, 3},        {{{0, 0, 0, 5}, {0, 0, 6, 5}}, 4},
                                       {{{0, 0, 0, 5}, {0, 0, -8, 5}}, 3},       {{{7, 1, -3, 13}, {13, 1, 5, 13}}, 12},
                                       {{{7, 1, -3, 13}, {1, 9, -3, 13}}, 12},   {{{0, 0, 0, 4}, {3, 0, 0, 5}}, 4},
                                       {{{0, 0, 0, 10}, {-8, -4, 8, 10}}, 8},    {{{0, 0, 0, 10}, {12, 0, 0, 10}}, 8},
                                       {{{0, 0, 0, 25}, {20, 20, 10, 25}}, 20.}, {{{0, 0, 0, 5}, {0, 10, 0, 5}}, 0}};

// Every point of an ellipse has a depth at which it lies on both spheres.
inline uint32_t ellipses_lie_on_both_spheres() {
  return first_failing(seen_circles, [](const SeenCircle &c) {
    constexpr double views[][3] = {{0, 0, 1}, {1, 0, 0}, {2, -1, 2}, {-1, 7, 3}};
    for (const double(&towards)[3] : views) {
      if (!small_view().succeeds(c.ball, 2, seen_from(towards[0], towards[1], towards[2]))) return false;
      const hsp::BallSet &balls = small_view().balls();
      const hsp::ViewFrame &frame = small_view().view().frame;
      const uint32_t own = small_union().grid().grid_index(0), other = small_union().grid().grid_index(1);
      const hsp::ProjectedEllipse e = hsp::ellipse_of(balls, frame, own, other);
      const hsp::Vec3 p = frame.centre_of(balls, own), q = frame.centre_of(balls, other);
      const hsp::Vec3 v{q.x - p.x, q.y - p.y, q.z - p.z};
      const double r = c.ball[0].r, R = c.ball[1].r;
      // |P - p|^2 = r^2 less |P - q|^2 = R^2: the plane v . (P - p) = b.
      const double b = (dot(v, v) + r * r - R * R) / 2;
      const double length = std::sqrt(e.major[0] * e.major[0] + e.major[1] * e.major[1]);
      const double turn = e.major[0] * e.minor[1] - e.major[1] * e.minor[0];
      if (!near(length, c.radius, 1e-13) || turn < 0.0) return false;
      for (int k = 0; k < 24; ++k) {
        const double t = k * hsp::pi / 12;
        const double x = e.centre[0] + std::cos(t) * e.major[0] + std::sin(t) * e.minor[0] - p.x;
        const double y = e.centre[1] + std::cos(t) * e.major[1] + std::sin(t) * e.minor[1] - p.y;
        const double rest = b - v.x * x - v.y * y;
        if (std::fabs(v.z) < 1e-9) {
          if (!near(rest, 0, 1e-10) || x * x + y * y > r * r + 1e-10) return false;
        } else if (!near(x * x + y * y + rest / v.z * (rest / v.z), r * r, 1e-10)) {
          return false;
        }
      }
    }
    return true;
  });
}

// The arcs of a piece are visited loop after loop, each from the end of the one before it, and start and end on their
// ellipses.
inline uint32_t arcs_are_chained() {
  return first_failing(scenes, [](const Scene &c) {
    if (!small_view().succeeds(c.ball, c.n, seen_from(3, 1, 2))) return false;
    const hsp::View &view = small_view().view();
    uint32_t visited = 0, loops = 0;
    bool holds = true;
    for (uint32_t p = 0; p < view.pieces.size(); ++p) {
      const double r = small_view().balls().r[view.pieces[p].ball];
      double first_start[2] = {}, last_end[2] = {};
      bool closed = true;
      const auto same = [](const double(&a)[2], const double(&b)[2]) { return a[0] == b[0] && a[1] == b[1]; };
      hsp::visit_arcs(small_view().balls(), view, p, [&](const hsp::ProjectedArc &arc, bool first, bool last) {
        const auto lies_at = [&](const double(&point)[2], double t) {
          const hsp::ProjectedEllipse &e = arc.ellipse;
          return near(point[0], e.centre[0] + std::cos(t) * e.major[0] + std::sin(t) * e.minor[0], 1e-9 * r) &&
                 near(point[1], e.centre[1] + std::cos(t) * e.major[1] + std::sin(t) * e.minor[1], 1e-9 * r);
        };
        ++visited;
        loops += first ? 1 : 0;
        holds = holds && first == closed && (first || same(arc.start, last_end));
        if (first) {
          first_start[0] = arc.start[0];
          first_start[1] = arc.start[1];
        }
        last_end[0] = arc.end[0];
        last_end[1] = arc.end[1];
        closed = last;
        holds = holds && (!last || same(arc.end, first_start));
        holds = holds && lies_at(arc.start, arc.from) && lies_at(arc.end, arc.to);
      });
      holds = holds && closed;
    }
    return holds && visited == view.arcs.size() && loops == view.loops.size() && visited > 0;
  });
}

inline constexpr Check view_projected_arcs[] = {{"bases_of_circles", bases_of_circles},
                                                {"ellipses_lie_on_both_spheres", ellipses_lie_on_both_spheres},
                                                {"arcs_are_chained", arcs_are_chained}};

}  // namespace cases
