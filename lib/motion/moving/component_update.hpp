// Connected components of the union while balls move. The balls of a component are a ring of links, and each knows the
// ball of lowest rank among them. Trees of balls that meet span the components. As long as balls that move still meet
// those next to them in their trees, no component comes apart. Where they do not, its pieces are searched side by side,
// until all of them are joined again or all of them but one are known as a whole.
#pragma once

#include "core/disjoint_sets.hpp"
#include "core/patience.hpp"
#include "moving/ball_cells.hpp"
#include "moving/moving_records.hpp"

namespace hsp {

class ComponentUpdate {
 public:
  void carve(Workspace &workspace, uint32_t balls);
  // Of so many balls nothing is known.
  void clear(uint32_t n);
  // The first update: trees that span the components of balls that have none.
  // Not of all if it is stopped: then abandon() follows.
  void span(MovingRecords &records, const BallCells &cells, Patience &patience);

  // Any other update. The first `former` balls of the journal are those that moved, at their new positions, and
  // what these met before.
  void begin(MovingRecords &records, uint32_t former);
  // Then, for each ball that moved, all that it meets now.
  void connect(const MovingRecords &records, uint32_t moved, uint32_t other);
  // In the end one of the two: apply brings origins, rings and trees up to date, and notes what it changes, also if it
  // is stopped;
  void apply(MovingRecords &records, const BallCells &cells, uint32_t former, Patience &patience);
  // abandon forgets the update.
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

  // Bits of a ball: its component's tree has lost an edge; its set is a component as a whole.
  static constexpr uint8_t wounded = 1;
  static constexpr uint8_t closed = 2;
  static constexpr uint8_t rival = 4;
  static constexpr uint32_t nobody = no_id - 1;

  // Of balls that take part: those that are connected now, as far as that is known. With each ball a whole tree is.
  DisjointSets sets_;
  Span<uint32_t> set_;  // no_id for balls that take no part
  Span<uint32_t> touched_, list_;
  Span<Link> links_;                         // pairs that meet by which sets became one
  Span<uint32_t> first_, last_, following_;  // of each set, the balls whose neighbours are not known yet
  Span<uint32_t> of_;                        // of some balls: a set, or a ball of a ring
  Span<uint8_t> flags_;
  uint32_t touched_count_ = 0, list_count_ = 0, link_count_ = 0;
  bool cut_ = false, searching_ = false;
};

}  // namespace hsp
