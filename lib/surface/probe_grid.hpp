// The vertices of a boundary as the centres of probes that touch three balls, sorted by cubes of side 2p: probes that
// overlap are in neighbouring cubes.
#pragma once

#include "boundary/boundary.hpp"
#include "measure/boundary_positions.hpp"

namespace hsp {

class ProbeGrid {
 public:
  // For at most so many vertices; with a measuring workspace it only counts.
  void carve(Workspace &workspace, uint32_t vertices);
  // The boundary must not have more vertices, the probe must not be 0.
  void build(const BallSet &balls, const Boundary &boundary);

  const Position &position(uint32_t vertex) const { return position_[vertex]; }
  // From one vertex to another. The reverse is the negative, bit for bit.
  Vec3 difference(const BallSet &balls, uint32_t from, uint32_t to) const {
    const Position &p = position_[from];
    const Position &q = position_[to];
    return balls.difference(p.ball, q.ball) + (q.offset - p.offset);
  }

  // Calls visit(w) for all vertices w in the 27 cubes around vertex v, itself included. Their order depends on ids.
  template <class Visit>
  void visit_around(const BallSet &balls, uint32_t v, Visit visit) const {
    const CubeCoordinates centre = cube_of(balls, v);
    for (int64_t z = centre.z - 1; z <= centre.z + 1; ++z) {
      for (int64_t y = centre.y - 1; y <= centre.y + 1; ++y) {
        for (int64_t x = centre.x - 1; x <= centre.x + 1; ++x) {
          const uint64_t key = linear_hash({x, y, z});
          const uint32_t bucket = bucket_of(key);
          for (uint32_t k = first_[bucket]; k < first_[bucket + 1]; ++k) {
            if (entry_[k].key == static_cast<uint32_t>(key)) visit(entry_[k].vertex);
          }
        }
      }
    }
  }

 private:
  // A bucket holds the vertices of several cubes. The key tells apart those of neighbouring cubes, which is all it has
  // to: it is linear in the coordinates, and that of no sum of two steps to neighbours is 0.
  struct Entry {
    uint32_t key, vertex;
  };
  uint32_t bucket_of(uint64_t key) const { return CubeProbe(key, buckets_).slot; }
  CubeCoordinates cube_of(const BallSet &balls, uint32_t v) const;

  Span<Position> position_;
  Span<uint32_t> first_;  // [buckets + 1]
  Span<Entry> entry_;     // [vertices]
  uint32_t buckets_ = 1;  // a power of two
  int64_t side_ = 1;
};

}  // namespace hsp
