// The vertices of a boundary as the centres of probes that touch three balls, sorted by cubes of side 2p: probes that
// overlap are in neighbouring cubes.
//
// A cube (x, y, z) belongs to bucket x + B y + C z modulo the number of buckets, so that three cubes of a row are
// neighbouring buckets, and their probes are one range of the sorted probes, or two ranges if bucket numbers start anew
// between them. B and C keep the nine rows around a cube apart. A bucket may hold the probes of several cubes;
// distances tell them apart. Input can be made whose cubes share a bucket. If a bucket has too many probes of cubes
// other than that of its first probe, all probes are sorted by their cubes instead, and binary search finds the rows:
// near probes are found in the same order.
#pragma once

#include "boundary/boundary.hpp"
#include "core/patience.hpp"
#include "measure/boundary_positions.hpp"
#include "surface/near_probes.hpp"
#include "surface/probe_triangles.hpp"

namespace hsp {

// Where the probes stand: each relative to the ball of lowest rank that it touches.
struct ProbePositions {
  Span<uint32_t> ball;
  Span<Vec3> offset;
  // The slots of the three balls in the record of the vertex, by rank, in two bits each; and above them whether the
  // vertex is p- of the circles of balls 1 and 2 on ball 0, in this order.
  Span<uint8_t> order;

  static constexpr uint32_t negative_bit = UINT32_C(1) << 6;

  Position operator[](uint32_t vertex) const { return {ball[vertex], offset[vertex]}; }
};

inline Vec3 difference(const BallSet &balls, const Position &from, const Position &to) {
  return balls.difference(from.ball, to.ball) + (to.offset - from.offset);
}

class ProbeGrid {
 public:
  // For at most so many vertices; with a measuring workspace it only counts. Once all searches are done the memory is
  // free for other use: two arrays of at least `shared` numbers each, and for every vertex a vector and two doubles.
  void carve(Workspace &workspace, uint32_t vertices, uint64_t shared = 0);
  Span<uint32_t> first_shared() const { return first_; }
  Span<uint32_t> second_shared() const { return position_.ball; }
  Span<Vec3> shared_vectors() const { return position_.offset; }
  Span<double> shared_doubles() const { return doubles_; }
  // The boundary must not have more vertices than carve() made room for, and the probe must not be 0. False if
  // `patience` stops it.
  bool build(const BallSet &balls, const Boundary &boundary, Patience &patience);

  const ProbePositions &positions() const { return position_; }
  Position position(uint32_t vertex) const { return position_[vertex]; }
  // The vector from one vertex to another. The reverse vector is its negative, bit for bit.
  Vec3 difference(const BallSet &balls, uint32_t from, uint32_t to) const {
    return hsp::difference(balls, position_[from], position_[to]);
  }

  bool has_buckets() const { return buckets_ != 0; }

  // Fills in a search around this vertex, but for its triangle (aim). The search finds the vertex itself, too.
  void start_search(const BallSet &balls, uint32_t vertex, ProbeSearch &search) const;

 private:
  void choose_units(const BallSet &balls);
  void lay_out(uint32_t vertices);
  bool place_all(const BallSet &balls, const Boundary &boundary, Patience &patience);
  Vec3 in_units(const BallSet &balls, const Position &position) const;
  uint32_t bucket_of(const Vec3 &at) const;
  CubeCoordinates cube_of(const BallSet &balls, uint32_t vertex) const;
  bool mixes_cubes(const BallSet &balls) const;
  void sort_by_cubes(const BallSet &balls, Patience &patience);
  void store(uint32_t to, const Vec3 &at, uint32_t vertex);
  uint32_t first_from(const BallSet &balls, const CubeCoordinates &cube) const;

  ProbePositions position_;
  Span<uint32_t> first_;   // [buckets + 1]
  Span<double> doubles_;   // the memory of the next four; twice as many as vertices, and more
  Span<float> x_, y_, z_;  // by buckets; seven spare ones may be read behind the last
  Span<uint32_t> vertex_;  // as these
  uint32_t buckets_ = 1;   // a power of two; 0 if probes are sorted by their cubes
  uint32_t probes_ = 0;
  Vec3 centre_{0, 0, 0};  // in lattice steps, integers
  double inverse_side_ = 0.0;
  float square_of_reach_ = 0.0F, inverse_square_of_reach_ = 0.0F, margin_ = 0.0F;
};

// gather_triangles finds the balls of vertices from `first` on, by rank, with signs and discriminants;
// measure_triangles finds everything about their triangles. Behind the last vertex lanes repeat it.
void gather_triangles(const Boundary &boundary, const ProbePositions &positions, uint32_t first,
                      ProbeTriangles &triangles);
void measure_triangles(const BallSet &balls, const Boundary &boundary, const ProbePositions &positions, uint32_t first,
                       ProbeTriangles &triangles);
// The same for one vertex after the other, from the first on. Returns the lane of this one.
uint32_t measure_next_triangle(const BallSet &balls, const Boundary &boundary, const ProbePositions &positions,
                               uint32_t vertex, ProbeTriangles &triangles);
// Makes the triangle in this lane the one of the search.
void aim(const ProbeTriangles &triangles, uint32_t lane, ProbeSearch &search);

}  // namespace hsp
