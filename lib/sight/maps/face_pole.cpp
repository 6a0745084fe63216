#include "maps/face_pole.hpp"

#include <initializer_list>
#include <limits>

#include "core/extremes.hpp"
#include "maps/edge_geometry.hpp"
#include "maps/trigonometric_roots.hpp"

namespace hsp {
namespace {

void look_along_line(const EdgeEllipse &line, double x, double y, NearestPoint &nearest) {
  const double *const half = line.first;
  const double squared = half[0] * half[0] + half[1] * half[1];
  const double along = (x - line.centre[0]) * half[0] + (y - line.centre[1]) * half[1];
  if (!(std::fabs(along) < squared)) return;  // its ends are as near as all
  const double part = along / squared;
  look_at_point(line.centre[0] + part * half[0], line.centre[1] + part * half[1], x, y, nearest);
}

void look_along_circle(const EdgeCurve &curve, double x, double y, NearestPoint &nearest) {
  const EdgeEllipse &circle = curve.ellipse;
  const double dx = x - circle.centre[0];
  const double dy = y - circle.centre[1];
  const double squared = dx * dx + dy * dy;
  if (squared == 0.0) return;  // its ends are as near as all
  double t = arc_tangent(dy, dx);
  while (t >= curve.from) t -= 2 * pi;
  while (t < curve.from) t += 2 * pi;
  const double scale = circle.first[0] / std::sqrt(squared);
  if (t <= curve.to) look_at_point(circle.centre[0] + scale * dx, circle.centre[1] + scale * dy, x, y, nearest);
}

// Half the derivative of the squared distance is B cos t - A sin t - K sin t cos t. A and B are the products of the
// vector from the point to the centre with both semi-axes, and K is the difference of the squares of the semi-axes.
// With t = s + pi / 4 the product becomes a square: sin t cos t = cos^2 s - 1/2.
void look_along_ellipse(const EdgeCurve &curve, double x, double y, NearestPoint &nearest) {
  constexpr double eighth = 0.25 * pi, root_half = 0.7071067811865476;
  const EdgeEllipse &ellipse = curve.ellipse;
  const double wx = ellipse.centre[0] - x;
  const double wy = ellipse.centre[1] - y;
  const double *const p = ellipse.first;
  const double *const q = ellipse.second;
  const double A = wx * p[0] + wy * p[1];
  const double B = wx * q[0] + wy * q[1];
  const double K = p[0] * p[0] + p[1] * p[1] - q[0] * q[0] - q[1] * q[1];
  const TrigonometricPolynomial slope{0.5 * K, root_half * (B - A), -root_half * (A + B), -K};
  double root[most_trigonometric_roots];
  const uint32_t count = find_roots(slope, curve.from - eighth, curve.to - eighth, root);
  for (uint32_t k = 0; k < count; ++k) {
    const SinCos t = sin_cos(root[k] + eighth);
    look_at_point(ellipse.x(t), ellipse.y(t), x, y, nearest);
  }
}

}  // namespace

void look_at_point(double to_x, double to_y, double x, double y, NearestPoint &nearest) {
  const double dx = to_x - x;
  const double dy = to_y - y;
  const double squared = dx * dx + dy * dy;
  if (squared < nearest.squared) nearest = {to_x, to_y, squared};
}

void look_along(const EdgeCurve &curve, bool silhouette, double x, double y, NearestPoint &nearest) {
  const double *const second = curve.ellipse.second;
  if (second[0] == 0.0 && second[1] == 0.0) {
    look_along_line(curve.ellipse, x, y, nearest);
  } else if (silhouette) {
    look_along_circle(curve, x, y, nearest);
  } else {
    look_along_ellipse(curve, x, y, nearest);
  }
}

namespace {

constexpr uint32_t most_waiting = 192;
constexpr uint32_t most_circles = 8;
constexpr uint32_t most_shrinkings = 12;
constexpr double half_diagonal = 1.4142135623730952;  // of a square of half side 1, rounded up

struct Square {
  double x, y, half;
  double most;  // no point of the square lies deeper in the face
};

struct Box {
  double low[2], high[2];
};

// The nearest edges to a point: of each its point next to it.
class NearEdges {
 public:
  void add(const NearestPoint &point) {
    if (point.squared < nearest_.squared) nearest_ = point;
    if (count_ < most) {
      point_[count_++] = point;
      return;
    }
    uint32_t farthest = 0;
    for (uint32_t k = 1; k < count_; ++k) {
      if (point_[k].squared > point_[farthest].squared) farthest = k;
    }
    if (point.squared < point_[farthest].squared) point_[farthest] = point;
  }
  const NearestPoint &nearest() const { return nearest_; }

  // A bound of how far a point of the square is from all these points. The square is cut in sixteen; for each small
  // square and each of the points the farthest corner counts.
  double farthest_in(const Square &square) const {
    const double part = 0.25 * square.half;
    double largest = 0.0;
    for (int row = -3; row <= 3; row += 2) {
      for (int column = -3; column <= 3; column += 2) {
        double least = std::numeric_limits<double>::infinity();
        for (uint32_t k = 0; k < count_; ++k) {
          const double dx = std::fabs(square.x + column * part - point_[k].x) + part;
          const double dy = std::fabs(square.y + row * part - point_[k].y) + part;
          const double squared = dx * dx + dy * dy;
          if (squared < least) least = squared;
        }
        if (least > largest) largest = least;
      }
    }
    return std::sqrt(largest);
  }

 private:
  static constexpr uint32_t most = 8;
  NearestPoint point_[most];
  NearestPoint nearest_;
  uint32_t count_ = 0;
};

template <class Map>
class PoleFinder {
 public:
  PoleFinder(const Map &map, uint32_t face) : map_(map), face_(face) {}

  FacePole find() {
    const uint32_t outer = map_.faces[face_].first_loop;
    const uint32_t first = map_.loops[outer].first_half_edge;
    const Box box = box_around(outer);
    const double width = box.high[0] - box.low[0];
    const double height = box.high[1] - box.low[1];
    const double half = 0.5 * (width > height ? width : height);
    const MapVertex &start = map_.vertices[map_.origin(first)];
    best_ = {start.x, start.y, 0.0, 0.0};
    lay_circles(half);
    look({0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1]), half, 0.0});
    while (count_ > 0 && looks_ < most_pole_looks) {
      const Square square = take_deepest();
      if (!may_be_better(square.most)) {
        keep_bound(square.most);
        break;
      }
      const double quarter = 0.5 * square.half;
      for (const double dy : {-quarter, quarter}) {
        for (const double dx : {-quarter, quarter}) look({square.x + dx, square.y + dy, quarter, 0.0});
      }
    }
    for (uint32_t k = 0; k < count_; ++k) keep_bound(waiting_[k].most);
    best_.bound = bound_ > best_.radius ? bound_ : best_.radius;
    return best_;
  }

 private:
  bool may_be_better(double most) const { return most > best_.radius * (1.0 + pole_tolerance); }
  void keep_bound(double most) {
    if (most > bound_) bound_ = most;
  }

  // The box around a loop: around its vertices and the extreme points of its curves.
  Box box_around(uint32_t loop) const {
    const MapVertex &start = map_.vertices[map_.origin(map_.loops[loop].first_half_edge)];
    Box box{{start.x, start.y}, {start.x, start.y}};
    const auto widen = [&box](double x, double y) {
      const double at[2] = {x, y};
      for (int axis = 0; axis < 2; ++axis) {
        if (at[axis] < box.low[axis]) box.low[axis] = at[axis];
        if (at[axis] > box.high[axis]) box.high[axis] = at[axis];
      }
    };
    map_.visit_loop(loop, [&](uint32_t h) {
      const EdgeCurve curve = curve_of(map_, h / 2);
      for (int axis = 0; axis < 2; ++axis) {
        double t = arc_tangent(curve.ellipse.second[axis], curve.ellipse.first[axis]);
        while (t >= curve.from) t -= pi;
        while (t < curve.from) t += pi;
        for (; t <= curve.to; t += pi) {
          const SinCos at = sin_cos(t);
          widen(curve.ellipse.x(at), curve.ellipse.y(at));
        }
      }
      const MapVertex &v = map_.vertices[map_.origin(h)];
      widen(v.x, v.y);
    });
    return box;
  }

  // The edges near a point: at least all whose distance is at most `farther` more than that of the nearest.
  NearEdges edges_near(double x, double y, double farther) {
    ++looks_;
    NearEdges near;
    map_.visit_loops(face_, [&](uint32_t l) {
      map_.visit_loop(l, [&](uint32_t h) {
        const double reach = std::sqrt(near.nearest().squared) + farther;
        NearestPoint nearest;
        nearest.squared = reach * reach;
        look_at_edge(map_, h / 2, x, y, nearest);
        if (nearest.squared < reach * reach) near.add(nearest);
      });
    });
    return near;
  }

  // A point lies in the face if an odd number of its loops surrounds it.
  bool is_inside(double x, double y) const {
    bool inside = false;
    map_.visit_loops(face_, [&](uint32_t l) { inside ^= surrounds(map_, l, x, y); });
    return inside;
  }

  // Looks at the middle of a square, and keeps the square if some point of it may be better.
  void look(Square square) {
    const double beyond = half_diagonal * square.half;
    const NearEdges near = edges_near(square.x, square.y, 2 * beyond);
    const double distance = std::sqrt(near.nearest().squared);
    square.most = smaller_of(distance + beyond, near.farthest_in(square));
    if (!may_be_better(square.most)) return keep_bound(square.most);
    const bool inside = is_inside(square.x, square.y);
    if (inside && distance > best_.radius) best_ = {square.x, square.y, distance, 0.0};
    if (!inside) square.most = smaller_of(square.most, beyond - distance);
    if (may_be_better(square.most)) return add(square);
    keep_bound(square.most);
  }

  // Adds a square that waits to be cut. Without room the square with the least bound is dropped, and only its bound
  // kept.
  void add(const Square &square) {
    if (count_ < most_waiting) {
      waiting_[count_++] = square;
      return;
    }
    uint32_t least = 0;
    for (uint32_t k = 1; k < count_; ++k) {
      if (waiting_[k].most < waiting_[least].most) least = k;
    }
    if (square.most <= waiting_[least].most) return keep_bound(square.most);
    keep_bound(waiting_[least].most);
    waiting_[least] = square;
  }
  Square take_deepest() {
    uint32_t deepest = 0;
    for (uint32_t k = 1; k < count_; ++k) {
      if (waiting_[k].most > waiting_[deepest].most) deepest = k;
    }
    const Square square = waiting_[deepest];
    waiting_[deepest] = waiting_[--count_];
    return square;
  }

  // Lays circles at edges of the outer loop; if there are many edges, at some that are spread over it.
  void lay_circles(double largest) {
    uint32_t edges = 0;
    map_.visit_loop(map_.faces[face_].first_loop, [&edges](uint32_t) { ++edges; });
    const uint32_t stride = (edges + most_circles - 1) / most_circles;
    uint32_t k = 0;
    map_.visit_loop(map_.faces[face_].first_loop, [&](uint32_t h) {
      if (k++ % stride == 0) lay_circle(h, largest);
    });
  }

  // Lays a circle that touches the middle of a half-edge from its left. As long as an edge reaches into the circle, it
  // shrinks to one that ends at that edge.
  void lay_circle(uint32_t h, double radius) {
    const EdgeCurve curve = curve_of(map_, h / 2);
    const EdgeEllipse &ellipse = curve.ellipse;
    const SinCos t = sin_cos(0.5 * (curve.from + curve.to));
    const double px = ellipse.x(t);
    const double py = ellipse.y(t);
    const double tx = ellipse.second[0] * t.cosine - ellipse.first[0] * t.sine;
    const double ty = ellipse.second[1] * t.cosine - ellipse.first[1] * t.sine;
    const double length = (h % 2 == 0 ? 1.0 : -1.0) * std::sqrt(tx * tx + ty * ty);
    if (length == 0.0) return;
    const double nx = -ty / length;
    const double ny = tx / length;
    for (uint32_t step = 0; step < most_shrinkings; ++step) {
      const double x = px + radius * nx;
      const double y = py + radius * ny;
      const NearestPoint nearest = edges_near(x, y, 0.0).nearest();
      const double distance = std::sqrt(nearest.squared);
      if (distance > best_.radius && is_inside(x, y)) best_ = {x, y, distance, 0.0};
      const double dx = nearest.x - px;
      const double dy = nearest.y - py;
      const double along = dx * nx + dy * ny;
      const double next = 0.5 * (dx * dx + dy * dy) / along;
      if (!(along > 0.0) || !(next < 0.999 * radius)) return;
      radius = next;
    }
  }

  const Map &map_;
  uint32_t face_;
  FacePole best_{};
  double bound_ = 0.0;
  uint32_t looks_ = 0;
  uint32_t count_ = 0;
  Square waiting_[most_waiting];
};

}  // namespace

FacePole find_pole(const VisibilityMap &map, uint32_t face) {
  return PoleFinder<VisibilityMap>(map, face).find();
}
FacePole find_pole(const StickMap &map, uint32_t face) {
  return PoleFinder<StickMap>(map, face).find();
}

}  // namespace hsp
