// Connected components of the union while balls move. The balls of a component are linked to a ring, and each knows the
// ball of lowest rank among them, the origin. Trees of balls that meet span the components. As long as balls that move
// still meet the balls next to them in their trees, no component comes apart. If one may come apart, its pieces are
// searched side by side, until all of them are joined again, or all but one are completely known.
#pragma once

#include "core/disjoint_sets.hpp"
#include "core/patience.hpp"
#include "moving/ball_cells.hpp"
#include "moving/moving_records.hpp"

namespace hsp {

class ComponentUpdate {
 public:
  void carve(Workspace &workspace, uint32_t balls);
  // Begins with n balls of which nothing is known.
  void clear(uint32_t n);
  // The first update: makes trees for balls that have none. If patience ends not all have one: then abandon() has to
  // follow.
  void span(MovingRecords &records, const BallCells &cells, Patience &patience);

  // Begins any other update. The first `former` balls of the journal are those that moved, at their new positions, and
  // the balls that these met before.
  void begin(MovingRecords &records, uint32_t former);
  // To be called then for each ball that moved, with each ball that it meets now.
  void connect(const MovingRecords &records, uint32_t moved, uint32_t other);
  // One of the next two ends the update. apply() brings origins, rings and trees up to date, and notes in the journal
  // the balls that it changes, also if patience ends.
  void apply(MovingRecords &records, const BallCells &cells, uint32_t former, Patience &patience);
  // abandon() forgets the update.
  void abandon(const MovingRecords &records, uint32_t former);

 private:
  struct Link {
    uint32_t a, b;
  };

  bool is_touched(uint32_t ball) const { return set_[ball] != no_id; }
  void start_set(uint32_t ball);
  void touch(const MovingRecords &records, uint32_t ball);
  uint32_t tree_of(const MovingRecords &records, uint32_t ball) const;
  bool unite(uint32_t a, uint32_t b);
  void link(MovingRecords &records, Link link);
  void find_pieces(const MovingRecords &records, const BallCells &cells, uint32_t former, Patience &patience);
  uint32_t find_rivals(const MovingRecords &records, uint32_t former);
  void begin_search(const MovingRecords &records);
  void search_further(const MovingRecords &records, const BallCells &cells, uint32_t root);
  void push(uint32_t ball);
  bool leaves(const MovingRecords &records, uint32_t ball);
  void take_out(MovingRecords &records, uint32_t ball);
  void renew_origins(MovingRecords &records);
  void merge_sets(MovingRecords &records, Patience &patience);

  // Flags of a ball. wounded: the tree of its component has lost an edge; closed: its set is a whole component; rival:
  // its set may be one of several pieces of a component (find_rivals()).
  static constexpr uint8_t wounded = 1;
  static constexpr uint8_t closed = 2;
  static constexpr uint8_t rival = 4;
  static constexpr uint32_t nobody = no_id - 1;

  // Sets of balls that take part and are known to be connected. Each ball stands for its whole tree.
  DisjointSets sets_;
  Span<uint32_t> set_;  // no_id for balls that take no part
  Span<uint32_t> touched_, list_;
  Span<Link> links_;                         // pairs of balls that meet, by which two sets became one
  Span<uint32_t> first_, last_, following_;  // of each set a queue of the balls whose neighbours are not known yet
  Span<uint32_t> of_;                        // for some balls: a set, or a ball of a ring
  Span<uint8_t> flags_;
  uint32_t touched_count_ = 0, list_count_ = 0, link_count_ = 0;
  bool cut_ = false, searching_ = false;
};

}  // namespace hsp
