// The vertices of a boundary as the centres of probes that touch three balls, sorted by cubes of side 2p: probes that
// overlap are in neighbouring cubes.
//
// A cube (x, y, z) belongs to bucket x + B y + C z modulo the number of buckets, so that three cubes of a row are
// neighbouring buckets and what lies in them is one range of the sorted probes, or two where buckets start anew. B and
// C keep the nine rows around a cube apart. A bucket may hold the probes of several cubes; distances tell them apart.
#pragma once

#include "boundary/boundary.hpp"
#include "measure/boundary_positions.hpp"
#include "surface/near_probes.hpp"
#include "surface/probe_triangles.hpp"

namespace hsp {

class ProbeGrid {
 public:
  // For at most so many vertices; with a measuring workspace it only counts.
  void carve(Workspace &workspace, uint32_t vertices);
  // The boundary must not have more vertices, the probe must not be 0.
  void build(const BallSet &balls, const Boundary &boundary);

  // Changes with every build.
  uint32_t builds() const { return builds_; }

  Span<const Position> positions() const { return position_; }
  const Position &position(uint32_t vertex) const { return position_[vertex]; }
  // From one vertex to another. The reverse is the negative, bit for bit.
  Vec3 difference(const BallSet &balls, uint32_t from, uint32_t to) const {
    const Position &p = position_[from];
    const Position &q = position_[to];
    return balls.difference(p.ball, q.ball) + (q.offset - p.offset);
  }

  // What a search around this vertex needs, but for the triangle. It finds the vertex itself, too.
  void start_search(const BallSet &balls, uint32_t vertex, ProbeSearch &search) const;

 private:
  void choose_units(const BallSet &balls);
  void place_all(const BallSet &balls, const Boundary &boundary);
  Vec3 in_units(const BallSet &balls, const Position &position) const;
  uint32_t bucket_of(const Vec3 &place) const;

  Span<Position> position_;
  Span<uint32_t> bucket_;  // [vertices]
  Span<uint32_t> first_;   // [buckets + 1]
  Span<float> x_, y_, z_;  // by buckets; seven spare ones may be read behind the last
  Span<uint32_t> vertex_;  // as these
  uint32_t buckets_ = 1;   // a power of two
  uint32_t builds_ = 0;
  Vec3 centre_{0, 0, 0};  // in lattice steps, integers
  double inverse_side_ = 0.0;
  float square_of_reach_ = 0.0F, inverse_square_of_reach_ = 0.0F, margin_ = 0.0F;
};

// The balls of four vertices from `first` on, or up to the last one, by rank, with signs and discriminants.
void gather_triangles(const BallSet &balls, const Boundary &boundary, uint32_t first, ProbeTriangles &triangles);

}  // namespace hsp
