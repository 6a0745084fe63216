// An index by longitude for a ball with very many caps: it finds the caps that a meridian may meet.
//
//        . 2 .        The half turn of longitudes is divided into sectors; here there are four, seen from above. A
//      3   |   1      meridian is a whole circle, so that longitudes half a turn apart are in the same sector. A cap is
//     ---- + ---- 0   listed in each sector that it reaches into, and a meridian is in one sector. Caps that reach into
//      1   |   3      many sectors, as around the poles, are wide: they are in no sector and are always looked at.
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
  static constexpr uint32_t sectors_for(uint32_t caps) { return caps / 8; }  // half and more of this is for marks
  struct Memory {
    Span<uint32_t> first, listed;
  };

  // Builds the index, once, before the other functions.
  void start(const Caps &caps, const Memory &memory);

  // The caller's marks: clear_marks() removes all, mark() sets those of the sectors that a cap reaches into. The
  // sectors of marks are finer than those in which caps are listed.
  void clear_marks() const;
  void mark(const Caps &caps, uint32_t cap) const;
  bool is_marked(double along_x, double along_y) const {
    return marks_.data()[sector_of(along_x, along_y, marks_.size())] != 0;
  }

  // Calls visit(cap) with ascending numbers, until it returns false, for all caps that may have a point in common with
  // the meridian in the direction (along_x, along_y), a horizontal unit vector.
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
  // The sectors into which a cap reaches: `count` of them from `first` on, where sector 0 follows the last one. `count`
  // is no_id if it may reach into all.
  struct Reach {
    uint32_t first, count;
  };

  static uint32_t sector_of(double x, double y, uint32_t sectors);
  static Reach reach_of(const Caps &caps, uint32_t cap, uint32_t sectors);

  uint32_t *first_;  // [sectors_ + 1]
  const uint32_t *listed_;
  Span<uint8_t> marks_;
  uint32_t sectors_;
  uint32_t placed_, all_;  // number of entries in sectors; the same with the wide caps, which are behind them
};

}  // namespace hsp
