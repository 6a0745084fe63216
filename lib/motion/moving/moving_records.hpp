// Balls with what is known of each of them, and a journal of those that an update changes: what they were before. With
// it an update is taken back, whether it could not be finished or the caller does not like it.
#pragma once

#include "measure/gradients.hpp"

namespace hsp {

// One ball's part of everything.
struct MovingBall {
  BallGradient own;  // in lattice steps; the term of the volume is that about the origin of its component
  uint32_t half_edges, circles, loops, faces;
  // The ball of lowest rank of its component, and its neighbours in the ring of the component's balls.
  uint32_t origin, next, previous;
  bool contained;
  bool one_sided;  // its derivatives: it touches another ball at a free point
};

struct JournalEntry {
  uint32_t ball;
  bool moved;
  bool listed;  // as one of which numbers may have changed, and not links of its component alone
  exact::LatticeBall placed;
  MovingBall before;
  uint32_t parent;
};

class MovingRecords {
 public:
  void carve(Workspace &workspace, uint32_t capacity) {
    balls.carve(workspace, capacity);
    workspace.take_each(capacity, ball, parent, journal_, entry_);
  }

  // Everything that knows of no ball and no change.
  void clear(uint32_t n) {
    balls.n = n;
    count_ = 0;
    for (uint32_t &entry : entry_.part(0, n)) entry = no_id;
  }

  // To be called before anything of ball i changes.
  void note(uint32_t i) {
    if (entry_[i] != no_id) return;
    entry_[i] = count_;
    journal_[count_++] = {i, false, false, balls.ball(i), ball[i], parent[i]};
  }
  void note_moved(uint32_t i) {
    note(i);
    journal_[entry_[i]].moved = true;
  }
  void list(uint32_t k) { journal_[k].listed = true; }
  bool is_noted(uint32_t i) const { return entry_[i] != no_id; }
  bool is_moved(uint32_t i) const { return entry_[i] != no_id && journal_[entry_[i]].moved; }
  // Those noted, in this order.
  uint32_t noted() const { return count_; }
  const JournalEntry &entry(uint32_t k) const { return journal_[k]; }
  // Forgets the journal.
  void begin() {
    for (uint32_t k = 0; k < count_; ++k) entry_[journal_[k].ball] = no_id;
    count_ = 0;
  }

  BallSet balls;          // any order
  Span<MovingBall> ball;  // [n]
  // [n] a ball that meets this one: these are trees that span the components, whose roots have none, no_id.
  Span<uint32_t> parent;

 private:
  Span<JournalEntry> journal_;
  Span<uint32_t> entry_;
  uint32_t count_ = 0;
};

}  // namespace hsp
