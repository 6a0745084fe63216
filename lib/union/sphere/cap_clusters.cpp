// Finds clusters of caps, one after the other.
//
// As an example caps 0 to 3, from large to small, of which 0 meets 2 and 2 meets 3. The first cluster begins with 0,
// which takes 2, and 2 takes 3. None of the others is left that meets 3, so that the second cluster begins, with 1, and
// ends with it. Caps are taken in the order 0 2 3 1.
#include "sphere/cap_clusters.hpp"

#include "sphere/cap_pair.hpp"

namespace hsp {
namespace {

// Whether two caps have a common point.
bool caps_meet(const Caps &caps, const exact::Predicates &predicates, uint32_t j, uint32_t k) {
  const CapPair pair(caps, j, k);
  if (pair.certainly_cross()) return true;
  if (pair.certainly_apart()) {
    if (pair.certainly_inside() || pair.certainly_contains()) return true;
    if (pair.certainly_separate()) return false;
  }
  const exact::Plane P = caps.plane(j);
  const exact::Plane Q = caps.plane(k);
  return predicates.crossing(P, Q).sign > 0 || predicates.side(P, Q).sign > 0 || predicates.side(Q, P).sign > 0;
}

}  // namespace

// Exchanges the largest cap of taken_[first .. last - 1] with the first one.
void CapClusters::bring_largest(const Caps &caps, uint32_t first, uint32_t last) {
  uint32_t largest = first;
  double least = caps.b[taken_[first]];
  for (uint32_t k = first + 1; k < last; ++k) {
    const double b = caps.b[taken_[k]];
    largest = b < least ? k : largest;
    least = b < least ? b : least;
  }
  const uint32_t cap = taken_[largest];
  taken_[largest] = taken_[first];
  taken_[first] = cap;
}

// Cluster by cluster: each cap of the cluster takes into it all caps that it meets, of those that are left. The number
// of caps that are left falls quickly, as the largest caps, which meet most others, come first.
uint32_t CapClusters::find(const Caps &caps) {
  const uint32_t n = caps.count;
  for (uint32_t k = 0; k < n; ++k) taken_[k] = k;
  const exact::Predicates predicates = caps.predicates();
  uint32_t clusters = 0;
  uint32_t representative = no_id;
  uint32_t known = 0;  // caps that have been taken; they come first
  for (uint32_t member = 0; member < n; ++member) {
    const bool begins = member == known;
    if (known < n) bring_largest(caps, member, begins ? n : known);
    const uint32_t j = taken_[member];
    if (begins) {
      ++clusters;
      ++known;
      representative = j;
    }
    cluster_[j] = representative;
    for (uint32_t k = known; k < n; ++k) {
      const uint32_t other = taken_[k];
      if (!caps_meet(caps, predicates, j, other)) continue;
      taken_[k] = taken_[known];
      taken_[known++] = other;
    }
  }
  return clusters;
}

uint32_t CapClusters::find(const Caps &caps, NearCaps near) {
  DisjointSets clusters(cluster_.part(0, caps.count));
  clusters.reset();
  const exact::Predicates predicates = caps.predicates();
  uint32_t count = caps.count;
  near.start(caps);
  for (uint32_t j = 0; j < caps.count; ++j) {
    for (const uint32_t k : near.around(caps, j)) {
      if (k <= j || clusters.find(j) == clusters.find(k) || !caps_meet(caps, predicates, j, k)) continue;
      clusters.join(j, k);
      --count;
    }
  }
  return count;
}

}  // namespace hsp
