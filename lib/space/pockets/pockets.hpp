// Pockets: where a narrow probe gets and a wide one does not get in from the outside, or in a periodic box from where
// it goes on for ever. One is made up of maxima where the narrow probe fits, joined by gates that it passes; its mouths
// are such gates to where the wide probe gets, too.
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
  uint32_t maximum;                      // the one of the highest level
  uint32_t mouth;                        // the widest one: a gate, or no_id
  uint32_t first_maximum, last_maximum;  // of maxima()
  uint32_t first_mouth, last_mouth;      // of mouths()
  uint32_t first_ball, last_ball;        // of balls()
};

class PocketFinder {
 public:
  void carve(Workspace &workspace, const PoreLimits &limits);
  // The levels of the two probes, in steps. The memory suffices for pores of the limits. pores.joined() becomes that of
  // the wide probe.
  void find(PoresBuilder &pores, double narrow, double wide);
  void forget() {
    pockets_.clear();
    mouth_count_ = known_ = 0;
  }

  // The one with the highest maximum first.
  Span<const Pocket> pockets() const { return pockets_.items(); }
  // Of pockets, one after the other; the highest first.
  Span<const uint32_t> maxima(const Pocket &pocket) const {
    return maxima_.part(pocket.first_maximum, pocket.last_maximum);
  }
  Span<const uint32_t> mouths(const Pocket &pocket) const {
    return mouths_.part(pocket.first_mouth, pocket.last_mouth);
  }
  // Of all pockets, in their order; or the leaks.
  Span<const uint32_t> all_mouths() const { return mouths_.part(0, mouth_count_); }
  // Notes in which region of other pores each maximum above the narrow probe is: those of the same balls, grown by that
  // probe, with plugs in the mouths. region_at(maximum, region) sets a region that it found, if any.
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
  // After that: calls open(pocket) for pockets that their plugs do not close, as a maximum is in a region with a
  // maximum of no pocket or of another one, or which goes on for ever; and add(pocket, region) for all other regions of
  // each.
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
  // Of pores with plugs: forgets pockets and mouths. Then marks each maximum with the pocket whose ascents reach it,
  // and with no_id where any other ascent does. Mouths become the gates, above the level 0, where a part with the mark
  // of a pocket meets one with another mark.
  void begin_leaks(const PoresBuilder &pores);
  void mark(uint32_t maximum, uint32_t pocket);
  void find_leaks(const PoresBuilder &pores);
  uint32_t pocket_of(uint32_t maximum) const { return label_[maximum]; }
  // Nearest balls of its maxima, of the gates between them and of its mouths; ascending, each once.
  Span<const uint32_t> balls(const Pocket &pocket) const { return balls_.part(pocket.first_ball, pocket.last_ball); }

 private:
  void number_maxima(const PoresBuilder &pores, double narrow);
  void gather(const PoresBuilder &pores, double narrow);
  uint32_t pocket_at(uint32_t end) const;

  FixedVector<Pocket> pockets_;
  Span<uint32_t> parents_;    // [maxima + 1]
  Span<uint32_t> label_;      // [maxima] the pocket of each one, or no_id
  Span<uint32_t> region_of_;  // [maxima] of match()
  Span<uint32_t> maxima_, mouths_, balls_;
  uint32_t mouth_count_ = 0;
  uint32_t known_ = 0;  // maxima with a label
  double narrow_ = 0.0;
};

}  // namespace hsp
