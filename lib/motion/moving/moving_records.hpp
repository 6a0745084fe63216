// Balls with the record of each, and a journal of the balls that an update changes, with their former records. With the
// journal an update is taken back: because it failed, or because the caller rejects it.
#pragma once

#include "measure/gradients.hpp"

namespace hsp {

// The record of one ball.
struct MovingBall {
  BallGradient own;  // in lattice steps; the term of the volume is about the origin of its component
  uint32_t half_edges, circles, loops, faces;
  // The ball of lowest rank in its component; the next and the previous ball in the ring of the component's balls.
  uint32_t origin, next, previous;
  bool contained;
  bool one_sided;  // its derivatives are one-sided: it touches another ball at a free point
};

struct JournalEntry {
  uint32_t ball;
  bool moved;
  bool listed;  // whether its numbers may have changed, and not only links of its component
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

  // Begins with n balls and an empty journal.
  void clear(uint32_t n) {
    balls.n = n;
    count_ = 0;
    for (uint32_t &entry : entry_.part(0, n)) entry = no_id;
  }

  // Enters ball i in the journal. To be called before anything of it changes.
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
  // The entries of the journal, in the order in which they were made.
  uint32_t noted() const { return count_; }
  const JournalEntry &entry(uint32_t k) const { return journal_[k]; }
  // Forgets the journal.
  void begin() {
    for (uint32_t k = 0; k < count_; ++k) entry_[journal_[k].ball] = no_id;
    count_ = 0;
  }

  BallSet balls;          // any order
  Span<MovingBall> ball;  // [n]
  // [n] the parent of each ball in a tree that spans its component: a ball that it meets; no_id for the root.
  Span<uint32_t> parent;

 private:
  Span<JournalEntry> journal_;
  Span<uint32_t> entry_;
  uint32_t count_ = 0;
};

}  // namespace hsp
