#include "mesh/saddle_grids.hpp"

namespace hsp {

namespace {

// Whether diagonal a b is no longer than diagonal c d; true if there was no room for the vertices' positions.
bool is_shorter(const FixedVector<MeshVertex> &vertices, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  if (vertices.overflowed()) return true;
  const auto square = [&](uint32_t from, uint32_t to) {
    double sum = 0.0;
    for (uint32_t axis = 0; axis < 3; ++axis) {
      const double step = vertices[to].position[axis] - vertices[from].position[axis];
      sum += step * step;
    }
    return sum;
  };
  return square(a, b) <= square(c, d);
}

}  // namespace

// A part of a band: how many points its edges have, and their numbers.
struct SaddleGrids::Grid {
  uint32_t part, patch;
  uint32_t turns, rows;   // segments of rims and sides
  bool closed;            // a whole circle
  uint32_t rim[2];        // first samples; of a rim that is a cusp, no_id
  uint32_t side[2];       // first samples, by ends of the arc
  uint32_t corner[2][2];  // by ends and balls; cusps are corners, too
  uint32_t inner;         // first point inside

  // An upper bound: rows at cusps have half as many.
  double triangles() const { return 2.0 * turns * rows; }
  uint32_t at(uint32_t k, uint32_t l) const {
    const uint32_t turn = closed && k == turns ? 0 : k;
    const bool at_end = !closed && (k == 0 || k == turns);
    const uint32_t end = k == 0 ? 0 : 1;
    const uint32_t before = closed ? 0 : 1;  // points of a rim before its first sample
    if (l == 0 || l == rows) {
      const uint32_t ball = l == 0 ? 0 : 1;
      return at_end || rim[ball] == no_id ? corner[end][ball] : rim[ball] + (turn - before);
    }
    return at_end ? side[end] + (l - 1) : inner + (turn - before) * (rows - 1) + (l - 1);
  }
};

SaddleGrids::Grid SaddleGrids::grid_of(uint32_t saddle, uint32_t part, const SaddleBand &band, double length) const {
  const SurfaceMap &map = curves_.map();
  const uint32_t rim[2] = {2 * saddle, 2 * saddle + 1};
  const uint32_t h = 2 * rim[part] + part;  // with the saddle on its left
  Grid grid{};
  grid.part = part;
  grid.patch = map.left(h);
  grid.closed = curves_.is_closed(rim[part]);
  grid.turns = curves_.curve(rim[0]).segments;
  for (uint32_t k = 0; k < 2; ++k) {
    grid.rim[k] = band.has_cusps() && k != part ? no_id : curves_.curve(rim[k]).first_sample;
  }
  if (grid.closed) {
    const double rows = segments_of(band.length(part), length, 1.0);
    grid.rows = rows < max_count ? static_cast<uint32_t>(rows) : max_count;
    if (!band.has_cusps()) return grid;
    const uint32_t cusp = map.cusp_at(map.cusped_circle_of(map.element_of(saddle, part)), band.ball(part));
    grid.corner[0][1 - part] = grid.corner[1][1 - part] = cusp;
    return grid;
  }
  // The sides at the ends of the arc, from ball 0 to ball 1.
  const uint32_t side[2] = {(part == 0 ? map.previous(h) : map.next(h)) & ~UINT32_C(1),
                            (part == 0 ? map.next(h) : map.previous(h)) & ~UINT32_C(1)};
  grid.rows = curves_.curve(side[0] / 2).segments;
  for (uint32_t k = 0; k < 2; ++k) {
    grid.side[k] = curves_.curve(side[k] / 2).first_sample;
    grid.corner[k][0] = map.origin(side[k]);
    grid.corner[k][1] = map.origin(SurfaceMap::twin(side[k]));
  }
  return grid;
}

// Calls visit(band, grid) for the parts of chosen patches, until it returns false.
template <class Visit>
bool SaddleGrids::for_each_grid(double length, Patience &patience, Visit visit) const {
  for (uint32_t k = 0; k < curves_.saddle_count(); ++k) {
    if (!patience.allows(2000)) return false;
    const SaddleBand band = curves_.band_of(curves_.map().element_of(k, 1));
    for (uint32_t part = 0; part < band.parts(); ++part) {
      Grid grid = grid_of(k, part, band, length);
      if (curves_.map().is_chosen(grid.patch) && !visit(band, grid)) return false;
    }
  }
  return true;
}

bool SaddleGrids::fit(double length, Patience &patience) const {
  double triangles = 0.0;
  return for_each_grid(length, patience, [&](const SaddleBand &, const Grid &grid) {
    triangles += grid.triangles();
    return triangles <= max_count;
  });
}

bool SaddleGrids::add_triangles(double length, Patience &patience, FixedVector<MeshVertex> &vertices,
                                FixedVector<MeshTriangle> &triangles) const {
  return for_each_grid(length, patience, [&](const SaddleBand &band, Grid &grid) {
    if (grid.triangles() + static_cast<double>(triangles.required()) > max_count) return false;
    if (!patience.allows(200 * uint64_t{grid.turns} * grid.rows)) return false;
    add_grid(band, grid, vertices, triangles);
    return true;
  });
}

void SaddleGrids::add_grid(const SaddleBand &band, Grid &grid, FixedVector<MeshVertex> &vertices,
                           FixedVector<MeshTriangle> &triangles) const {
  grid.inner = clamped_count(vertices.required());
  for (uint32_t k = grid.closed ? 0 : 1; k < grid.turns; ++k) {
    const Vec3 outward = band.outward(k, grid.turns);
    for (uint32_t l = 1; l < grid.rows; ++l) {
      vertices.push(vertex_of_band(curves_.balls(), band.at(outward, grid.part, l, grid.rows)));
    }
  }
  for (uint32_t l = 0; l < grid.rows; ++l) {
    const uint32_t ball = band.ball_of_row(grid.part, l, grid.rows);
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
      triangles.push({{a, b, c}, grid.patch, ball, grid.closed ? PatchKind::circle_saddle : PatchKind::saddle});
    };
    for (uint32_t k = 0; k < grid.turns; ++k) {
      const uint32_t corner[4] = {grid.at(k, l), grid.at(k + 1, l), grid.at(k + 1, l + 1), grid.at(k, l + 1)};
      if (l == 0 && grid.rim[0] == no_id) {
        add(corner[0], corner[2], corner[3]);
      } else if (l + 1 == grid.rows && grid.rim[1] == no_id) {
        add(corner[0], corner[1], corner[2]);
      } else if (is_shorter(vertices, corner[0], corner[2], corner[1], corner[3])) {
        add(corner[0], corner[1], corner[2]);
        add(corner[0], corner[2], corner[3]);
      } else {
        add(corner[1], corner[2], corner[3]);
        add(corner[1], corner[3], corner[0]);
      }
    }
  }
}

void SaddleGrids::add_sizes(double length, MeshSizes &sizes) const {
  for (uint32_t k = 0; k < curves_.saddle_count(); ++k) {
    const SaddleBand band = curves_.band_of(curves_.map().element_of(k, 1));
    const double turns = segments_of(band.width(), length, fewest_of_circle);
    for (uint32_t part = 0; part < band.parts(); ++part) {
      sizes.add_points(turns * segments_of(band.length(part), length, 1.0));
    }
  }
}

}  // namespace hsp
