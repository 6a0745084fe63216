// Pockets: the places that a narrow probe reaches and a wide one does not reach from the outside; in a periodic box,
// from free space in which it goes on for ever. A pocket is a set of maxima at which the narrow probe fits, joined by
// gates that it passes. Its mouths are the gates that the narrow probe passes to places that the wide probe reaches,
// too.
//
//     balls           mouth
//     ______         .......         ______    the narrow probe passes the mouth and the gate g, the wide one not the
//           \_______/       \_______/          mouth: the maxima M and m are one pocket with one mouth, and its balls
//            \        M          /             are those that line both cavities
//             \________g_________/
//                 \    m   /
//                  \______/
#pragma once

#include "core/disjoint_sets.hpp"
#include "core/fixed_vector.hpp"
#include "pockets/region_finder.hpp"
#include "pores/pores_builder.hpp"

namespace hsp {

struct Pocket {
  uint32_t maximum;                      // its highest maximum
  uint32_t mouth;                        // its widest mouth, a gate; no_id if it has none
  uint32_t first_maximum, last_maximum;  // the range of maxima()
  uint32_t first_mouth, last_mouth;      // the range of mouths()
  uint32_t first_ball, last_ball;        // the range of balls()
};

class PocketFinder {
 public:
  void carve(Workspace &workspace, const PoreLimits &limits);
  // Finds the pockets for two probes, given by their levels in steps. The memory of carve() suffices for pores within
  // its limits. pores.joined() becomes that of the wide probe.
  void find(PoresBuilder &pores, double narrow, double wide);
  void forget() {
    pockets_.clear();
    mouth_count_ = known_ = 0;
  }

  // The pockets, the one with the highest maximum first.
  Span<const Pocket> pockets() const { return pockets_.items(); }
  // The maxima, and the mouths, of a pocket, the highest first.
  Span<const uint32_t> maxima(const Pocket &pocket) const {
    return maxima_.part(pocket.first_maximum, pocket.last_maximum);
  }
  Span<const uint32_t> mouths(const Pocket &pocket) const {
    return mouths_.part(pocket.first_mouth, pocket.last_mouth);
  }
  // The mouths of all pockets, pocket after pocket; or the leaks, after find_leaks().
  Span<const uint32_t> all_mouths() const { return mouths_.part(0, mouth_count_); }
  // Notes the region of each maximum above the narrow probe in other pores: those of the same balls, grown by that
  // probe, with plugs in the mouths. region_at(maximum, region) sets the region, if there is one.
  template <class RegionAt>
  Status match(const PoresBuilder &pores, RegionFinder &regions, RegionAt region_at) {
    for (uint32_t k = 0; k < known_; ++k) {
      uint32_t &region = region_of_[k];
      region = no_id;
      if (!(pores.maxima()[k].point.level > narrow_)) continue;
      if (const Status status = region_at(k, region); status != Status::ok) return status;
      if (region != no_id) regions.claim(region, label_[k]);
    }
    return Status::ok;
  }
  // After match(): calls open(pocket) for each pocket that its plugs do not close: one of its maxima is in a region
  // with a maximum of another pocket or of none, or in a region that goes on for ever. Calls add(pocket, region) for
  // all other regions of a pocket.
  template <class Open, class Add>
  void visit_regions(Span<const PoreRegion> regions, Open open, Add add) const {
    const auto is_open = [](const PoreRegion &region) { return region.is_shared || region.is_accessible(); };
    for (uint32_t k = 0; k < known_; ++k) {
      if (label_[k] != no_id && region_of_[k] != no_id && is_open(regions[region_of_[k]])) open(label_[k]);
    }
    for (const PoreRegion &region : regions) {
      if (region.owner != no_id && !is_open(region)) add(region.owner, region);
    }
  }
  // For pores with plugs. begin_leaks() forgets pockets and mouths. mark() marks a maximum with the pocket from whose
  // maxima a way up reaches it; with no_id if it is also reached from elsewhere. find_leaks() makes the leaks the
  // mouths: the gates above level 0 at which a part with the mark of a pocket meets one with another mark.
  void begin_leaks(const PoresBuilder &pores);
  void mark(uint32_t maximum, uint32_t pocket);
  void find_leaks(const PoresBuilder &pores);
  uint32_t pocket_of(uint32_t maximum) const { return label_[maximum]; }
  // The balls that line a pocket: the nearest balls of its maxima, of the gates between them and of its mouths;
  // ascending, each once.
  Span<const uint32_t> balls(const Pocket &pocket) const { return balls_.part(pocket.first_ball, pocket.last_ball); }

 private:
  void number_maxima(const PoresBuilder &pores, double narrow);
  void gather(const PoresBuilder &pores, double narrow);
  uint32_t pocket_at(uint32_t end) const;

  FixedVector<Pocket> pockets_;
  Span<uint32_t> parents_;    // [maxima + 1]
  Span<uint32_t> label_;      // [maxima] the pocket of each maximum, or no_id
  Span<uint32_t> region_of_;  // [maxima] the regions that match() found
  Span<uint32_t> maxima_, mouths_, balls_;
  uint32_t mouth_count_ = 0;
  uint32_t known_ = 0;  // how many maxima have a label
  double narrow_ = 0.0;
};

}  // namespace hsp
