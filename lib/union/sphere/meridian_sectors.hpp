// Of one ball with very many caps, those that a meridian may meet: an index by longitude.
//
//        . 2 .        A meridian is a whole circle, so that longitudes half a turn apart are the same: four sectors
//      3   |   1      of the half turn, from above. A cap is listed in each sector that it reaches into, the meridian
//     ---- + ---- 0   is in one of them. A few caps that reach into many, those around the poles for instance, are
//      1   |   3      in no sector and are always looked at.
//        ' 2 '
#pragma once

#include "core/span.hpp"
#include "sphere/caps.hpp"

namespace hsp {

class MeridianSectors {
 public:
  // Fewer caps are looked at one by one: that is as quick.
  static constexpr uint32_t fewest = 256;

  // Memory, [sectors_for(caps) + 1] and [entries_for_each caps].
  static constexpr uint32_t entries_for_each = 3;
  static constexpr uint32_t sectors_for(uint32_t caps) { return caps / 8; }  // of which half and more is for marks
  struct Memory {
    Span<uint32_t> first, listed;
  };

  // Of all caps, once before the others.
  void start(const Caps &caps, const Memory &memory);

  // Marks of the caller's, first none, then where a cap reaches: in sectors finer than those that caps are listed in.
  void clear_marks() const;
  void mark(const Caps &caps, uint32_t cap) const;
  bool is_marked(double along_x, double along_y) const {
    return marks_.data()[sector_of(along_x, along_y, marks_.size())] != 0;
  }

  // Calls visit(cap), with ascending numbers, for all caps that have a common point with the meridian in a direction,
  // a horizontal unit vector, until it returns false.
  template <class Visit>
  void visit(double along_x, double along_y, Visit visit) const {
    const uint32_t sector = sector_of(along_x, along_y, sectors_);
    const Span<const uint32_t> near(listed_ + first_[sector], first_[sector + 1] - first_[sector]);
    const Span<const uint32_t> wide(listed_ + placed_, all_ - placed_);
    uint32_t k = 0;
    for (const uint32_t cap : near) {
      for (; k < wide.size() && wide[k] < cap; ++k) {
        if (!visit(wide[k])) return;
      }
      if (!visit(cap)) return;
    }
    for (; k < wide.size(); ++k) {
      if (!visit(wide[k])) return;
    }
  }

 private:
  // Sectors from the first to the last into which a cap reaches, counted on from their number where the half turn ends;
  // no_id if it may reach into all.
  struct Reach {
    uint32_t first, count;
  };

  static uint32_t sector_of(double x, double y, uint32_t sectors);
  static Reach reach_of(const Caps &caps, uint32_t cap, uint32_t sectors);

  uint32_t *first_;  // [sectors_ + 1]
  const uint32_t *listed_;
  Span<uint8_t> marks_;
  uint32_t sectors_;
  uint32_t placed_, all_;  // entries in sectors, and with the wide caps behind them
};

}  // namespace hsp
