// The library's search for the free part of a sphere, by all caps of the ball or by an index of them: the two must
// agree.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "built_grid.hpp"
#include "lattice_lengths.hpp"
#include "random_balls.hpp"
#include "sphere/cap_clusters.hpp"
#include "sphere/great_circles.hpp"
#include "sphere/vertex_finder.hpp"

// Vertices and circles found on one ball.
inline std::string text_of(hsp::Span<const hsp::VertexRecord> vertices, hsp::Span<const hsp::CircleRecord> circles) {
  std::string text;
  for (const hsp::VertexRecord &v : vertices) {
    text += std::to_string(v.ball[1]) + " " + std::to_string(v.ball[2]) + " " + std::to_string(v.code) + "\n";
  }
  for (const hsp::CircleRecord &c : circles) text += std::to_string(c.ball[1]) + "\n";
  return text;
}

class IndexedSearch {
 public:
  explicit IndexedSearch(const oracle::Balls &balls)
      : built_(oracle::in_lengths(balls, 1)), n_(static_cast<uint32_t>(balls.size())) {
    memory_of_caps_.carve(caps, n_);
    memory_of_finder_.carve(finder_, n_);
    memory_of_clusters_.carve(clusters_, n_);
    memory_of_index_.carve(intervals_, n_);
    vertices_.resize(6 * size_t{n_} * std::min(n_, 60U) + 16);
    circles_.resize(n_ + 1);
  }

  // Gathers the caps of one ball; false if there are none to be indexed.
  bool gather(uint32_t ball) {
    caps.gather(built_.grid().balls(), built_.grid().block_around(built_.grid().cube_at(balls().ball(ball).centre)),
                ball, nullptr);
    return !caps.contained && caps.count > 0 && balls().r[ball] > 0;
  }
  hsp::NearCaps near_caps() const { return intervals_.near_caps(); }
  hsp::CapBoxes cap_boxes() const { return intervals_.cap_boxes(); }
  uint32_t size() const { return balls().n; }
  const hsp::BallSet &balls() const { return built_.grid().balls(); }

  // All that is found of the free part, as text: by all caps, or by an index.
  template <class... Index>
  std::string found(Index... index) {
    hsp::FixedVector<hsp::VertexRecord> vertices({vertices_.data(), static_cast<uint32_t>(vertices_.size())});
    hsp::FixedVector<hsp::CircleRecord> circles({circles_.data(), static_cast<uint32_t>(circles_.size())});
    finder_.find(balls(), caps, index..., vertices, circles);
    return text_of(vertices.items(), circles.items());
  }
  template <class... Index>
  std::string clusters(Index... index) {
    return std::to_string(clusters_.find(caps, index...)) + " clusters";
  }
  // The number of caps that represent a cluster in the index.
  uint32_t representatives() const {
    uint32_t count = 0;
    for (uint32_t k = 0; k < caps.count; ++k) count += clusters_.is_representative(k) ? 1U : 0U;
    return count;
  }

  hsp::Caps caps;

 private:
  BuiltGrid built_;
  uint32_t n_;
  CarvedMemory memory_of_caps_, memory_of_finder_, memory_of_clusters_, memory_of_index_;
  hsp::VertexFinder finder_;
  hsp::CapClusters clusters_;
  hsp::FreeIntervals intervals_;
  std::vector<hsp::VertexRecord> vertices_;
  std::vector<hsp::CircleRecord> circles_;
};
