// Connected components of the union while balls move. The balls of a component are a ring of links, and each knows the
// ball of lowest rank among them. An update says which balls are connected now, near those that moved; only where that
// leaves open whether a component has come apart is it searched, from all of its possible pieces side by side, until
// all of them but one are known as a whole.
#pragma once

#include "core/disjoint_sets.hpp"
#include "updates/ball_cells.hpp"
#include "updates/moving_records.hpp"

namespace hsp {

class ComponentUpdate {
 public:
  void carve(Workspace &workspace, uint32_t balls);
  // Of so many balls nothing is known.
  void clear(uint32_t n);

  // For an update: balls that are connected now. All neighbours of the balls that moved, old and new ones, take part,
  // and these balls themselves, each with all of its neighbours or with one that contains it.
  void touch(uint32_t ball) {
    if (parent_[ball] != no_id) return;
    parent_[ball] = ball;
    touched_[touched_count_++] = ball;
  }
  void join(uint32_t a, uint32_t b) {
    touch(a);
    touch(b);
    sets_.join(a, b);
  }
  // Forgets these.
  void abandon();
  // Brings origins and rings up to date. The first `affected` balls of the journal are those with all of their
  // neighbours, the first `former` of them those that moved and what these met before; cells and balls are as they are
  // now. What it changes it notes.
  void apply(MovingRecords &records, const BallCells &cells, uint32_t former, uint32_t affected);

 private:
  void mark_wounded(const MovingRecords &records, uint32_t former);
  void find_pieces(const MovingRecords &records, const BallCells &cells, uint32_t former, uint32_t affected);
  uint32_t find_rivals(const MovingRecords &records, uint32_t former);
  void begin_search(const MovingRecords &records, uint32_t affected);
  void search_further(const MovingRecords &records, const BallCells &cells, uint32_t root);
  void push(uint32_t root, uint32_t ball);
  bool leaves(const MovingRecords &records, uint32_t ball);
  void take_out(MovingRecords &records, uint32_t ball);
  void renew_origins(MovingRecords &records);
  void merge_sets(MovingRecords &records);

  // Bits of a ball: its component has lost a ball that moved; its set is a component as a whole.
  static constexpr uint8_t wounded = 1;
  static constexpr uint8_t closed = 2;
  static constexpr uint8_t rival = 4;
  static constexpr uint32_t nobody = no_id - 1;

  DisjointSets sets_;
  Span<uint32_t> parent_;  // of the sets; no_id for balls that take no part
  Span<uint32_t> touched_, list_;
  Span<uint32_t> first_, last_, following_;  // of each set, the balls whose neighbours are not known yet
  Span<uint32_t> of_;                        // of some balls: a set, or a ball of a ring
  Span<uint8_t> flags_;
  uint32_t touched_count_ = 0, list_count_ = 0;
  bool searching_ = false;
};

}  // namespace hsp
