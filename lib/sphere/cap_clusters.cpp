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
  const exact::Plane &P = caps.plane[j];
  const exact::Plane &Q = caps.plane[k];
  return predicates.crossing(P, Q).sign > 0 || predicates.side(P, Q).sign > 0 || predicates.side(Q, P).sign > 0;
}

}  // namespace

uint32_t CapClusters::find(const Caps &caps) {
  DisjointSets clusters(cluster_.part(0, caps.count));
  clusters.reset();
  const exact::Predicates predicates = caps.predicates();
  uint32_t count = caps.count;
  for (uint32_t j = 0; j < caps.count && count > 1; ++j) {
    for (uint32_t k = j + 1; k < caps.count; ++k) {
      if (clusters.find(j) != clusters.find(k) && caps_meet(caps, predicates, j, k)) {
        clusters.join(j, k);
        --count;
      }
    }
  }
  return count;
}

}  // namespace hsp
