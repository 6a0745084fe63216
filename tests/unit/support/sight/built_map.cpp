#include "built_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "lattice_lengths.hpp"

namespace {

using Vector3 = std::array<double, 3>;

Vector3 cross_product(const Vector3 &a, const Vector3 &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The curve centre + cos t first + sin t second. On a crease, the circle of two spheres, `second` is horizontal: the
// height depends on cos t alone.
struct Curve {
  Vector3 centre{}, first{}, second{};

  [[nodiscard]] double at(size_t axis, double t) const {
    return centre[axis] + std::cos(t) * first[axis] + std::sin(t) * second[axis];
  }
};

Curve curve_of(const hsp::VisibilityMap &map, const hsp::MapEdge &edge) {
  const hsp::SeenBall &far = map.scene.balls[edge.body];
  if (edge.nearer == hsp::no_id) return {{far.x, far.y, far.z}, {far.r, 0, 0}, {0, far.r, 0}};
  const hsp::SeenBall &near = map.scene.balls[edge.nearer];
  const Vector3 d = {near.x - far.x, near.y - far.y, near.z - far.z};
  const double length = std::hypot(d[0], d[1], d[2]);
  // By Heron: the radius of the circle is twice the area over the distance.
  const double s = (far.r + near.r + length) / 2;
  const double rho = 2 * std::sqrt(s * (s - far.r) * (s - near.r) * (s - length)) / length;
  const double height = (length * length + far.r * far.r - near.r * near.r) / (2 * length);
  Vector3 horizontal = {d[1], -d[0], 0};
  if (d[0] == 0 && d[1] == 0) horizontal = {0, 1, 0};
  const double across = std::hypot(horizontal[0], horizontal[1]);
  Vector3 n{};
  for (size_t k = 0; k < 3; ++k) {
    n[k] = d[k] / length;
    horizontal[k] /= across;
  }
  const Vector3 steep = cross_product(horizontal, n);
  Curve curve;
  for (size_t k = 0; k < 3; ++k) {
    curve.centre[k] = std::array{far.x, far.y, far.z}[k] + height * n[k];
    curve.first[k] = rho * steep[k];
    curve.second[k] = rho * horizontal[k];
  }
  return curve;
}

// Where a row meets an edge, and the owners on either side.
struct Crossing {
  double x;
  uint32_t left, right;
};

uint32_t owner_beside(const hsp::VisibilityMap &map, uint32_t half_edge) {
  return map.faces[map.face_of(half_edge)].owner;
}

}  // namespace

BuiltMap::BuiltMap(const oracle::Balls &balls, const std::array<double, 3> &towards)
    : grid_(oracle::in_lengths(balls, 1)) {
  status_ = grid_.status();
  if (status_ != hsp::Status::ok) return;
  hsp::MapLimits limits;
  hsp::default_limits(static_cast<uint32_t>(balls.size()), limits);
  take(limits);
  look(towards);
}

void BuiltMap::take(const hsp::MapLimits &limits) {
  map_memory_.carve(builder_, limits);
}

void BuiltMap::look(const std::array<double, 3> &towards) {
  for (int left = 3;; --left) {
    status_ = builder_.build(grid(), {{towards[0], towards[1], towards[2]}, {0, 1, 0}});
    if (status_ != hsp::Status::capacity || left == 0) return;
    take(builder_.retry_limits());
  }
}

uint32_t BuiltMap::caller(uint32_t ball) const {
  return ball == hsp::no_id ? oracle::no_ball : grid().balls().caller[map().scene.balls[ball].ball];
}

std::vector<oracle::PlainBall> BuiltMap::seen() const {
  const hsp::BallSet &balls = grid().balls();
  std::vector<oracle::PlainBall> result(balls.n);
  for (uint32_t i = 0; i < balls.n; ++i) {
    const hsp::Vec3 centre = map().frame.centre_of(balls, i);
    result[balls.caller[i]] = {{centre.x, centre.y, centre.z}, balls.r[i]};
  }
  return result;
}

MapImage painted(const BuiltMap &built, const oracle::PixelGrid &grid) {
  const hsp::VisibilityMap &map = built.map();
  std::vector<std::vector<Crossing>> rows(grid.rows);
  for (uint32_t e = 0; e < map.edges.size(); ++e) {
    const hsp::MapEdge &edge = map.edges[e];
    const Curve curve = curve_of(map, edge);
    const uint32_t left = owner_beside(map, 2 * e);
    const uint32_t right = owner_beside(map, 2 * e + 1);
    const double amplitude = std::hypot(curve.first[1], curve.second[1]);
    const double phase = std::atan2(curve.second[1], curve.first[1]);
    const auto row_of = [&](double y) {
      return std::clamp((y - grid.bottom) / grid.side, -1.0, static_cast<double>(grid.rows));
    };
    const auto first = static_cast<int64_t>(std::ceil(row_of(curve.centre[1] - amplitude)));
    const auto last = static_cast<int64_t>(std::floor(row_of(curve.centre[1] + amplitude)));
    for (int64_t row = std::max<int64_t>(first, 0); row <= last && row < static_cast<int64_t>(grid.rows); ++row) {
      const double u = (grid.y(static_cast<size_t>(row)) - curve.centre[1]) / amplitude;
      if (std::abs(u) >= 1) continue;
      for (const double t0 : {phase - std::acos(u), phase + std::acos(u)})
        for (int turn = -3; turn <= 3; ++turn) {
          const double t = t0 + 2 * std::numbers::pi * turn;
          if (t < edge.from || t >= edge.to) continue;
          const bool upwards = -std::sin(t) * curve.first[1] + std::cos(t) * curve.second[1] > 0;
          rows[static_cast<size_t>(row)].push_back({curve.at(0, t), upwards ? left : right, upwards ? right : left});
        }
    }
  }
  MapImage image;
  image.ball.assign(grid.pixels(), oracle::no_ball);
  image.on_edge.assign(grid.pixels(), 0);
  for (size_t row = 0; row < grid.rows; ++row) {
    auto &crossings = rows[row];
    std::sort(crossings.begin(), crossings.end(), [](const Crossing &a, const Crossing &b) { return a.x < b.x; });
    // Edges that are nearly in one place are sorted so that the owners between them agree.
    for (size_t k = 0; k < crossings.size(); ++k) {
      const uint32_t before = k == 0 ? hsp::no_id : crossings[k - 1].right;
      for (size_t other = k; other < crossings.size() && crossings[other].x - crossings[k].x < 1e-9 * grid.side;
           ++other)
        if (crossings[other].left == before) {
          std::swap(crossings[k], crossings[other]);
          break;
        }
    }
    for (size_t k = 0; k <= crossings.size(); ++k) {
      const uint32_t before = k == 0 ? hsp::no_id : crossings[k - 1].right;
      const uint32_t after = k == crossings.size() ? hsp::no_id : crossings[k].left;
      const bool close = k > 0 && k < crossings.size() && crossings[k].x - crossings[k - 1].x < 1e-5 * grid.side;
      if (before != after && !close) ++image.breaks;
    }
    size_t next = 0;
    uint32_t owner = hsp::no_id;
    for (size_t column = 0; column < grid.columns; ++column) {
      const double x = grid.x(column);
      for (; next < crossings.size() && crossings[next].x < x; ++next) owner = crossings[next].right;
      const size_t pixel = row * grid.columns + column;
      image.ball[pixel] = built.caller(owner);
      const double margin = 1e-6 * grid.side;
      if ((next > 0 && x - crossings[next - 1].x < margin) ||
          (next < crossings.size() && crossings[next].x - x < margin))
        image.on_edge[pixel] = 1;
    }
  }
  return image;
}

std::string map_disagrees(const BuiltMap &built, size_t pixels) {
  std::ostringstream text;
  if (built.status() != hsp::Status::ok) {
    text << "status " << static_cast<int>(built.status());
    return text.str();
  }
  const hsp::VisibilityMap &map = built.map();
  const std::vector<oracle::PlainBall> seen = built.seen();
  const oracle::PixelGrid grid = oracle::grid_around(seen, pixels);
  const std::vector<oracle::SeenPixel> image = oracle::z_buffer(seen, grid);
  const MapImage own = painted(built, grid);
  double largest = 0;
  for (const oracle::PlainBall &ball : seen) largest = std::max(largest, ball.radius);
  // A shift by e changes heights near a rim by at most sqrt(2 r e).
  const double shift = map.perturbation + 1e-9 * largest;
  const double tolerance = map.perturbation > 0 ? 8 * std::sqrt(2 * largest * shift) : 1e-9 * largest;
  size_t wrong = 0;
  for (size_t k = 0; k < grid.pixels(); ++k) {
    const uint32_t shown = own.ball[k];
    if (shown == image[k].ball || own.on_edge[k] != 0) continue;
    const double x = grid.x(k % grid.columns);
    const double y = grid.y(k / grid.columns);
    const double height = shown == oracle::no_ball ? -1e300 : oracle::front_of(seen[shown], x, y);
    if (image[k].ball != oracle::no_ball && std::abs(height - image[k].depth) < tolerance) continue;
    if (map.perturbation > 0) {
      // The same pixel seen a little beside its centre.
      bool near_rim = false;
      for (const uint32_t ball : {shown, image[k].ball}) {
        if (ball == oracle::no_ball) continue;
        const double distance = std::hypot(x - seen[ball].centre[0], y - seen[ball].centre[1]);
        if (std::abs(distance - seen[ball].radius) < 4 * shift) near_rim = true;
      }
      if (near_rim) continue;
    }
    if (wrong++ == 0) {
      text << "at (" << x << ", " << y << ") " << static_cast<int64_t>(static_cast<int32_t>(shown)) << " instead of "
           << static_cast<int64_t>(static_cast<int32_t>(image[k].ball));
    }
  }
  if (wrong > 0) text << ", " << wrong << " wrong pixels";
  if (own.breaks > 0 && map.perturbation == 0) text << " " << own.breaks << " breaks";
  // The pixels of a ball against its visible area; the error is at most the pixels on its edges.
  std::vector<double> area(seen.size(), 0), length(seen.size(), 0);
  for (uint32_t f = 1; f < map.faces.size(); ++f)
    if (map.faces[f].owner != hsp::no_id) area[built.caller(map.faces[f].owner)] += map.faces[f].area;
  for (uint32_t h = 0; h < map.half_edges.size(); ++h) {
    const uint32_t owner = map.faces[map.face_of(h)].owner;
    const hsp::MapEdge &edge = map.edges[h / 2];
    if (owner != hsp::no_id) length[built.caller(owner)] += (edge.to - edge.from) * map.scene.balls[edge.body].r;
  }
  std::vector<double> counted(seen.size(), 0);
  for (const oracle::SeenPixel &pixel : image)
    if (pixel.ball != oracle::no_ball) counted[pixel.ball] += grid.side * grid.side;
  for (size_t i = 0; i < seen.size(); ++i)
    if (std::abs(area[i] - counted[i]) > grid.side * length[i] + 8 * grid.side * grid.side && wrong == 0 &&
        map.perturbation == 0)
      text << " area of ball " << i << ": " << area[i] << ", pixels: " << counted[i];
  return text.str();
}
