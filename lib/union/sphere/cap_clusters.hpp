// Clusters of the caps of one sphere: the connected components of their union.
//
// As an example caps around directions at 0, 30 and 90 degrees on a great circle, of 20, 15 and 10 degrees. The first
// two overlap, as 30 < 20 + 15; the third is 60 degrees from the second and meets neither: two clusters.
#pragma once

#include "sphere/near_caps.hpp"

namespace hsp {

class CapClusters {
 public:
  void carve(Workspace &workspace, uint32_t capacity) {
    cluster_ = workspace.take<uint32_t>(capacity);
    taken_ = workspace.take<uint32_t>(capacity);
  }

  // Puts caps that touch or overlap into one cluster; returns the number of clusters.
  uint32_t find(const Caps &caps);
  // The same for very many caps, by an index.
  uint32_t find(const Caps &caps, NearCaps near);
  // After find(): whether a cap represents its cluster. Each cluster has one such cap.
  bool is_representative(uint32_t cap) const { return cluster_[cap] == cap; }

 private:
  void bring_largest(const Caps &caps, uint32_t first, uint32_t last);

  Span<uint32_t> cluster_;  // for each cap, the representative of its cluster
  Span<uint32_t> taken_;    // the caps in the order in which clusters take them
};

}  // namespace hsp
