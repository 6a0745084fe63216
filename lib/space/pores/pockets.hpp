// Pockets: where a narrow probe gets and a wide one does not get in from the outside, or in a periodic box from where
// it goes on for ever. One is made up of maxima where the narrow probe fits, joined by gates that it passes; its mouths
// are such gates to where the wide probe gets, too.
#pragma once

#include "core/disjoint_sets.hpp"
#include "core/fixed_vector.hpp"
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
  void forget() { pockets_.clear(); }

  // The one with the highest maximum first.
  Span<const Pocket> pockets() const { return pockets_.items(); }
  // Of pockets, one after the other; the highest first.
  Span<const uint32_t> maxima(const Pocket &pocket) const {
    return maxima_.part(pocket.first_maximum, pocket.last_maximum);
  }
  Span<const uint32_t> mouths(const Pocket &pocket) const {
    return mouths_.part(pocket.first_mouth, pocket.last_mouth);
  }
  // Nearest balls of its maxima, of the gates between them and of its mouths; ascending, each once.
  Span<const uint32_t> balls(const Pocket &pocket) const { return balls_.part(pocket.first_ball, pocket.last_ball); }

 private:
  void number_maxima(const PoresBuilder &pores, double narrow);
  void gather(const PoresBuilder &pores, double narrow);
  uint32_t pocket_at(uint32_t end) const;

  FixedVector<Pocket> pockets_;
  Span<uint32_t> parents_;  // [maxima + 1]
  Span<uint32_t> label_;    // [maxima] the pocket of each one, or no_id
  Span<uint32_t> maxima_, mouths_, balls_;
  uint32_t known_ = 0;  // maxima with a label
};

}  // namespace hsp
