#include "surface/probe_grid.hpp"

#include "core/begin_array.hpp"
#include "core/decimal.hpp"
#include "core/extremes.hpp"
#include "core/first_index.hpp"
#include "core/rows.hpp"
#include "core/sorting.hpp"
#include "sphere/caps.hpp"

namespace hsp {
namespace {

constexpr uint32_t spare_probes = 7;
constexpr uint32_t least_buckets = 128;
// The most probes in one bucket that are not in the cube of its first probe.
constexpr uint32_t most_of_others = 64;

// B and C of probe_grid.hpp. Their low bits, 5 and 25, keep the rows apart within 128 buckets; their high bits spread
// rows over more.
constexpr uint64_t step_y = (UINT64_C(0x9E3779B97F4A7C15) & ~UINT64_C(127)) + 5;
constexpr uint64_t step_z = (UINT64_C(0xC2B2AE3D27D4EB4F) & ~UINT64_C(127)) + 25;

constexpr bool keeps_rows_apart() {
  for (int64_t z = -2; z <= 2; ++z) {
    for (int64_t y = -2; y <= 2; ++y) {
      const uint64_t step = (static_cast<uint64_t>(y) * step_y + static_cast<uint64_t>(z) * step_z) % least_buckets;
      if ((y != 0 || z != 0) && (step < 3 || step > least_buckets - 3)) return false;
    }
  }
  return true;
}
static_assert(keeps_rows_apart());

// The doubles whose memory holds one float for each vertex.
constexpr uint64_t doubles_for(uint32_t vertices) {
  return (uint64_t{vertices} + spare_probes + 1) / 2;
}

uint32_t buckets_for(uint32_t vertices) {
  uint64_t buckets = least_buckets;
  while (buckets < vertices / 2) buckets *= 2;
  return static_cast<uint32_t>(buckets);
}

CubeCoordinates cube_at(const Vec3 &at) {
  return {floor_of(at.x), floor_of(at.y), floor_of(at.z)};
}

// The slots of a vertex's balls in its record, by rank, in two bits each; and a bit for the vertex's sign in this order
// of its balls. Mostly without branches: which of three balls comes first cannot be predicted.
uint8_t order_of_rank(const BallSet &balls, const VertexRecord &vertex) {
  double x[3] = {balls.x[vertex.ball[0]], balls.x[vertex.ball[1]], balls.x[vertex.ball[2]]};
  const auto code = [](uint32_t first, uint32_t second, uint32_t third, bool negative) {
    return static_cast<uint8_t>(first | second << 2 | third << 4 | (negative ? ProbePositions::negative_bit : 0));
  };
  if (x[0] == x[1] || x[1] == x[2] || x[0] == x[2]) [[unlikely]] {
    const OrderedVertex ordered =
        in_order(vertex, [&balls](uint32_t a, uint32_t b) { return balls.ranks_before(a, b); });
    const uint32_t *const ball = ordered.ball;
    return code(vertex.slot_of(ball[0]), vertex.slot_of(ball[1]), vertex.slot_of(ball[2]), ordered.sign < 0);
  }
  uint32_t slot[3] = {0, 1, 2};
  uint32_t exchanges = vertex.positive() ? 0 : 1;
  const auto order = [&](int a, int b) {
    const bool exchange = x[b] < x[a];
    const uint32_t mask = 0U - static_cast<uint32_t>(exchange);
    const uint32_t difference = (slot[a] ^ slot[b]) & mask;
    slot[a] ^= difference;
    slot[b] ^= difference;
    const double smaller = exchange ? x[b] : x[a];
    x[b] = exchange ? x[a] : x[b];
    x[a] = smaller;
    exchanges += static_cast<uint32_t>(exchange);
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return code(slot[0], slot[1], slot[2], (exchanges & 1U) != 0);
}

uint32_t vertex_in_lane(const Boundary &boundary, uint32_t first, uint32_t lane) {
  return smaller_of(first + lane, boundary.vertex_count() - 1);
}

}  // namespace

void gather_triangles(const Boundary &boundary, const ProbePositions &positions, uint32_t first,
                      ProbeTriangles &triangles) {
  for (uint32_t lane = 0; lane < ProbeTriangles::lanes; ++lane) {
    const uint32_t v = vertex_in_lane(boundary, first, lane);
    const VertexRecord &vertex = boundary.vertex(v);
    const uint32_t order = positions.order[v];
    for (int k = 0; k < 3; ++k) triangles.ball[k][lane] = vertex.ball[order >> 2 * k & 3U];
    triangles.sign[lane] = (order & ProbePositions::negative_bit) != 0 ? -1.0 : 1.0;
    triangles.root_discriminant[lane] = boundary.root_discriminant(v);
  }
}

void measure_triangles(const BallSet &balls, const Boundary &boundary, const ProbePositions &positions, uint32_t first,
                       ProbeTriangles &triangles) {
  gather_triangles(boundary, positions, first, triangles);
  for (uint32_t lane = 0; lane < ProbeTriangles::lanes; ++lane) {
    const Vec3 &offset = positions.offset[vertex_in_lane(boundary, first, lane)];
    triangles.offset[0][lane] = offset.x;
    triangles.offset[1][lane] = offset.y;
    triangles.offset[2][lane] = offset.z;
  }
  measure_triangles(boundary.target(), arrays_of(balls), triangles);
}

uint32_t measure_next_triangle(const BallSet &balls, const Boundary &boundary, const ProbePositions &positions,
                               uint32_t vertex, ProbeTriangles &triangles) {
  const uint32_t lane = vertex % ProbeTriangles::lanes;
  if (lane == 0) measure_triangles(balls, boundary, positions, vertex, triangles);
  return lane;
}

void aim(const ProbeTriangles &triangles, uint32_t lane, ProbeSearch &search) {
  for (int k = 0; k < 3; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      search.inward[k][axis] = static_cast<float>(triangles.inward[k][axis][lane]);
      search.corner[k][axis] = static_cast<float>(triangles.corner[k][axis][lane]);
    }
    search.cosine[k] = static_cast<float>(triangles.cosine[k][lane]);
  }
}

void ProbeGrid::carve(Workspace &workspace, uint32_t vertices, uint64_t shared) {
  const auto at_least = [shared](uint64_t count) { return count > shared ? count : shared; };
  position_.offset = workspace.take<Vec3>(vertices);
  position_.ball = workspace.take<uint32_t>(at_least(vertices));
  position_.order = workspace.take<uint8_t>(vertices);
  first_ = workspace.take<uint32_t>(at_least(uint64_t{buckets_for(vertices)} + 1));
  doubles_ = workspace.take<double>(4 * doubles_for(vertices));
}

// Four arrays in the memory of doubles.
void ProbeGrid::lay_out(uint32_t vertices) {
  const uint32_t doubles = static_cast<uint32_t>(doubles_for(vertices));
  const auto part = [&](uint32_t k) { return doubles_.part(k * doubles, (k + 1) * doubles); };
  x_ = begin_array<float>(part(0));
  y_ = begin_array<float>(part(1));
  z_ = begin_array<float>(part(2));
  vertex_ = begin_array<uint32_t>(part(3));
}

// The centre has integer coordinates, so the differences of balls to it are exact; sums with offsets are rounded.
// Positions have an error of 2^-52 of the set's extent, less than a step, for which the side of the cubes has room.
// Floats have another relative error of 2^-24.
void ProbeGrid::choose_units(const BallSet &balls) {
  const Span<double> *const axes[3] = {&balls.x, &balls.y, &balls.z};
  double extent = 0.0, middle[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double *const x = axes[axis]->data();
    double low = x[0], high = x[0];
    for (uint32_t i = 1; i < balls.n; ++i) {
      low = smaller_of(x[i], low);
      high = larger_of(x[i], high);
    }
    middle[axis] = static_cast<double>(nearest(0.5 * low + 0.5 * high));
    extent = larger_of(high - middle[axis] + 1.0, extent);
  }
  centre_ = {middle[0], middle[1], middle[2]};
  const double diameter = 2 * static_cast<double>(balls.probe_steps);
  const double side = diameter * (1.0 + 0x1p-12) + 4.0;
  inverse_side_ = 1.0 / side;
  extent = (extent + static_cast<double>(balls.largest_radius)) * inverse_side_;
  // The error of a difference's coordinate: those of both positions, and its own rounding.
  const double error = 2 * 0x1.001p-24 * extent + 0x1p-23;
  const double reach = diameter * inverse_side_;
  const double longest = reach + 2 * error;
  square_of_reach_ = static_cast<float>(longest * longest + 0x1p-20);
  inverse_square_of_reach_ = static_cast<float>(1.0 / (reach * reach));
  margin_ = static_cast<float>(4 * error + 0x1p-19);
}

Vec3 ProbeGrid::in_units(const BallSet &balls, const Position &position) const {
  const uint32_t b = position.ball;
  return {((balls.x[b] - centre_.x) + position.offset.x) * inverse_side_,
          ((balls.y[b] - centre_.y) + position.offset.y) * inverse_side_,
          ((balls.z[b] - centre_.z) + position.offset.z) * inverse_side_};
}

CubeCoordinates ProbeGrid::cube_of(const BallSet &balls, uint32_t vertex) const {
  return cube_at(in_units(balls, position_[vertex]));
}

uint32_t ProbeGrid::bucket_of(const Vec3 &at) const {
  const CubeCoordinates cube = cube_at(at);
  const uint64_t bucket =
      static_cast<uint64_t>(cube.x) + static_cast<uint64_t>(cube.y) * step_y + static_cast<uint64_t>(cube.z) * step_z;
  return static_cast<uint32_t>(bucket) & (buckets_ - 1);
}

bool ProbeGrid::mixes_cubes(const BallSet &balls) const {
  for (uint32_t bucket = 0; bucket < buckets_; ++bucket) {
    const uint32_t first = first_[bucket], last = first_[bucket + 1];
    if (last - first <= most_of_others) continue;
    const CubeCoordinates cube = cube_of(balls, vertex_[first]);
    uint32_t others = 0;
    for (uint32_t k = first; k < last; ++k) others += static_cast<uint32_t>(!(cube_of(balls, vertex_[k]) == cube));
    if (others > most_of_others) return true;
  }
  return false;
}

// Sorts by cubes, and within a cube by vertices, as in a bucket of one cube.
void ProbeGrid::sort_by_cubes(const BallSet &balls, Patience &patience) {
  buckets_ = 0;
  sort_in_place(vertex_.part(0, probes_), [&](uint32_t v, uint32_t w) {
    if (!patience.allows(100)) return false;
    const CubeCoordinates a = cube_of(balls, v), b = cube_of(balls, w);
    return a == b ? v < w : comes_before(a, b);
  });
  for (uint32_t k = 0; k < probes_; ++k) store(k, in_units(balls, position_[vertex_[k]]), vertex_[k]);
}

void ProbeGrid::store(uint32_t to, const Vec3 &at, uint32_t vertex) {
  x_[to] = static_cast<float>(at.x);
  y_[to] = static_cast<float>(at.y);
  z_[to] = static_cast<float>(at.z);
  vertex_[to] = vertex;
}

// If probes are sorted by their cubes: the first probe in this cube or behind it.
uint32_t ProbeGrid::first_from(const BallSet &balls, const CubeCoordinates &cube) const {
  return first_index(0, probes_, [&](uint32_t k) { return !comes_before(cube_of(balls, vertex_[k]), cube); });
}

bool ProbeGrid::place_all(const BallSet &balls, const Boundary &boundary, Patience &patience) {
  const uint32_t n = boundary.vertex_count();
  in_parts(patience, IdRange{0, n}, 50, [&](IdRange some) {
    for (const uint32_t v : some) position_.order[v] = order_of_rank(balls, boundary.vertex(v));
  });
  ProbeTriangles triangles;
  for (uint32_t first = 0; first < n; first += ProbeTriangles::lanes) {
    if (!patience.allows(2000)) return false;
    gather_triangles(boundary, position_, first, triangles);
    place_probes(boundary.target(), arrays_of(balls), triangles);
    for (uint32_t lane = 0; lane < ProbeTriangles::lanes && first + lane < n; ++lane) {
      const uint32_t v = first + lane;
      const double x = triangles.offset[0][lane];
      const Position position =
          x == x ? Position{triangles.ball[0][lane], {x, triangles.offset[1][lane], triangles.offset[2][lane]}}
                 : position_of_vertex(balls, boundary, v);
      position_.ball[v] = position.ball;
      position_.offset[v] = position.offset;
    }
  }
  return true;
}

bool ProbeGrid::build(const BallSet &balls, const Boundary &boundary, Patience &patience) {
  const uint32_t n = boundary.vertex_count();
  choose_units(balls);
  if (!place_all(balls, boundary, patience)) return false;
  lay_out(n);
  probes_ = n;
  buckets_ = buckets_for(n);
  Vec3 at{0.0, 0.0, 0.0};
  sort_to_rows(
      first_, buckets_, n,
      [&](uint32_t v) {
        static_cast<void>(patience.allows(100));
        at = in_units(balls, position_[v]);
        return bucket_of(at);
      },
      [&](uint32_t to, uint32_t v) { store(to, at, v); });
  if (!patience.allows(100 * uint64_t{n})) return false;
  if (mixes_cubes(balls)) sort_by_cubes(balls, patience);
  for (uint32_t k = n; k < n + spare_probes; ++k) x_[k] = y_[k] = z_[k] = 0.0F;
  return patience.allows(0);
}

void ProbeGrid::start_search(const BallSet &balls, uint32_t vertex, ProbeSearch &search) const {
  search.x = x_.data();
  search.y = y_.data();
  search.z = z_.data();
  search.vertex = vertex_.data();
  const Vec3 at = in_units(balls, position_[vertex]);
  search.own[0] = static_cast<float>(at.x);
  search.own[1] = static_cast<float>(at.y);
  search.own[2] = static_cast<float>(at.z);
  search.square_of_reach = square_of_reach_;
  search.inverse_square_of_reach = inverse_square_of_reach_;
  search.margin = margin_;
  search.at = 0;
  uint32_t ranges = 0;
  const auto add_range = [&](uint32_t first, uint32_t last) {
    search.range[ranges] = {first, last};
    ranges += static_cast<uint32_t>(first != last);
  };
  if (buckets_ == 0) {
    const CubeCoordinates cube = cube_at(at);
    for (int64_t z = cube.z - 1; z <= cube.z + 1; ++z) {
      for (int64_t y = cube.y - 1; y <= cube.y + 1; ++y) {
        add_range(first_from(balls, {cube.x - 1, y, z}), first_from(balls, {cube.x + 2, y, z}));
      }
    }
    search.ranges = ranges;
    return;
  }
  const auto add = [&](uint32_t first, uint32_t last) { add_range(first_[first], first_[last]); };
  const uint32_t mask = buckets_ - 1;
  const uint32_t bucket = bucket_of(at);
  for (uint32_t z = 0; z < 3; ++z) {
    for (uint32_t y = 0; y < 3; ++y) {
      const uint64_t step = (uint64_t{y} - 1) * step_y + (uint64_t{z} - 1) * step_z - 1;
      const uint32_t row = (bucket + static_cast<uint32_t>(step)) & mask;
      if (row + 3 <= buckets_) [[likely]] {
        add(row, row + 3);
      } else {
        add(row, buckets_);
        add(0, row + 3 - buckets_);
      }
    }
  }
  search.ranges = ranges;
}

}  // namespace hsp
