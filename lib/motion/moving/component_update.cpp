#include "moving/component_update.hpp"

#include <utility>

namespace hsp {

void ComponentUpdate::carve(Workspace &workspace, uint32_t balls) {
  workspace.take_each(balls, set_, touched_, list_, links_, first_, last_, following_, of_, flags_);
}

void ComponentUpdate::clear(uint32_t n) {
  sets_ = DisjointSets(set_.part(0, n));
  for (uint32_t i = 0; i < n; ++i) {
    set_[i] = of_[i] = no_id;
    flags_[i] = 0;
  }
  touched_count_ = link_count_ = 0;
}

// Breadth first, so that the trees are low.
void ComponentUpdate::span(MovingRecords &records, const BallCells &cells, Patience &patience) {
  cut_ = false;
  for (uint32_t root = 0; root < records.balls.n; ++root) {
    if (is_touched(root)) continue;
    const uint32_t first = touched_count_;
    start_set(root);
    for (uint32_t k = first; k < touched_count_; ++k) {
      if (!patience.allows(2000)) return;
      const uint32_t i = touched_[k];
      const exact::LatticeBall ball = records.balls.ball(i);
      cells.visit_around(ball, [&](uint32_t j) {
        if (is_touched(j) || !BallCells::is_met(records.balls, ball, j)) return;
        start_set(j);
        sets_.join(root, j);
        records.parent[j] = i;
      });
    }
  }
}

void ComponentUpdate::begin(MovingRecords &records, uint32_t former) {
  cut_ = false;
  for (uint32_t k = 0; k < former; ++k) {
    const JournalEntry &entry = records.entry(k);
    const uint32_t i = entry.ball, parent = records.parent[i];
    if (parent == no_id || !(entry.moved || records.is_moved(parent))) continue;
    if (BallCells::is_met(records.balls, records.balls.ball(i), parent)) continue;
    records.parent[i] = no_id;
    flags_[entry.before.origin] |= wounded;
    cut_ = true;
  }
  for (uint32_t k = 0; k < former; ++k) {
    const JournalEntry &entry = records.entry(k);
    if (entry.moved || (flags_[entry.before.origin] & wounded) != 0) touch(records, entry.ball);
  }
}

void ComponentUpdate::connect(const MovingRecords &records, uint32_t moved, uint32_t other) {
  touch(records, other);
  if (unite(moved, other)) links_[link_count_++] = {moved, other};
}

void ComponentUpdate::abandon(const MovingRecords &records, uint32_t former) {
  for (uint32_t k = 0; k < former; ++k) {
    if (records.entry(k).moved) flags_[records.entry(k).before.origin] = 0;
  }
  for (const uint32_t i : touched_.part(0, touched_count_)) {
    set_[i] = no_id;
    flags_[i] = 0;
  }
  touched_count_ = link_count_ = 0;
}

void ComponentUpdate::apply(MovingRecords &records, const BallCells &cells, uint32_t former, Patience &patience) {
  find_pieces(records, cells, former, patience);
  for (const Link &pair : links_.part(0, link_count_)) {
    if (!patience.allows(500)) break;
    link(records, pair);
  }

  // Balls that moved, and whole pieces, leave their components first; then components are put together.
  list_count_ = 0;
  const Span<const uint32_t> touched = touched_.part(0, touched_count_);
  for (const uint32_t i : touched) {
    static_cast<void>(patience.allows(100));
    if (leaves(records, i)) take_out(records, i);
  }
  renew_origins(records);
  for (const uint32_t i : touched) {
    if (leaves(records, i)) records.ball[i].origin = i;
  }
  merge_sets(records, patience);
  abandon(records, former);
}

void ComponentUpdate::start_set(uint32_t ball) {
  set_[ball] = ball;
  first_[ball] = no_id;
  touched_[touched_count_++] = ball;
}

void ComponentUpdate::touch(const MovingRecords &records, uint32_t ball) {
  if (is_touched(ball)) return;
  start_set(ball);
  const uint32_t tree = tree_of(records, ball);
  if (!is_touched(tree)) start_set(tree);
  unite(ball, tree);
}

// The ball that stands for all balls that are known to be connected with the given one after trees have lost edges: the
// root of its tree; or the origin of its component if that has lost no edge.
uint32_t ComponentUpdate::tree_of(const MovingRecords &records, uint32_t ball) const {
  const uint32_t origin = records.ball[ball].origin;
  if ((flags_[origin] & wounded) == 0) return origin;
  while (records.parent[ball] != no_id) ball = records.parent[ball];
  return ball;
}

// Unites two sets, and appends the queue of one to that of the other. False if they are one set already.
bool ComponentUpdate::unite(uint32_t a, uint32_t b) {
  a = sets_.find(a);
  b = sets_.find(b);
  if (a == b) return false;
  sets_.join(a, b);
  const uint32_t joined = sets_.find(a);
  const uint32_t absorbed = joined == a ? b : a;
  if (first_[absorbed] == no_id) return true;
  (first_[joined] == no_id ? first_[joined] : following_[last_[joined]]) = first_[absorbed];
  last_[joined] = last_[absorbed];
  return true;
}

// Joins two trees to one. In the tree in which the ball is nearer to the root, the way from ball to root is reversed.
void ComponentUpdate::link(MovingRecords &records, Link link) {
  const Span<uint32_t> parent = records.parent;
  uint32_t a = link.a, b = link.b;
  while (parent[a] != no_id && parent[b] != no_id) {
    a = parent[a];
    b = parent[b];
  }
  const bool from_a = parent[a] == no_id;
  uint32_t below = from_a ? link.b : link.a;
  for (uint32_t i = from_a ? link.a : link.b; i != no_id;) {
    const uint32_t above = parent[i];
    records.note(i);
    parent[i] = below;
    below = i;
    i = above;
  }
}

// Finds the pieces of components. Every piece has a ball that has met a ball that moved. So there are no more pieces
// than sets with such balls, and if one set is left there is one piece.
void ComponentUpdate::find_pieces(const MovingRecords &records, const BallCells &cells, uint32_t former,
                                  Patience &patience) {
  searching_ = false;
  if (!cut_) return;
  while (const uint32_t rivals = find_rivals(records, former)) {
    if (!searching_) {
      begin_search(records);
      continue;
    }
    for (uint32_t k = 0; k < rivals; ++k) {
      if (!patience.allows(10000)) return;
      search_further(records, cells, list_[k]);
    }
  }
}

// Lists in list_ the sets that may be pieces of one component and are not completely known. Returns their number; 0 if
// no component has two of them.
uint32_t ComponentUpdate::find_rivals(const MovingRecords &records, uint32_t former) {
  list_count_ = 0;
  const auto visit = [&](auto with) {
    for (uint32_t k = 0; k < former; ++k) {
      const JournalEntry &entry = records.entry(k);
      const uint32_t component = entry.before.origin;
      if (entry.moved || (flags_[component] & wounded) == 0) continue;
      const uint32_t root = sets_.find(entry.ball);
      if ((flags_[root] & closed) == 0) with(component, root);
    }
  };
  const auto add = [&](uint32_t root) {
    if ((flags_[root] & rival) != 0) return;
    flags_[root] |= rival;
    list_[list_count_++] = root;
  };
  visit([&](uint32_t component, uint32_t root) {
    uint32_t &first = of_[component];
    if (first == no_id) first = root;
    if (first == root) return;
    add(first);
    add(root);
  });
  visit([&](uint32_t component, uint32_t) { of_[component] = no_id; });
  for (const uint32_t root : list_.part(0, list_count_)) flags_[root] &= static_cast<uint8_t>(~rival);
  return list_count_;
}

// Fills the queues: first with balls near those that moved, then with roots of trees. The neighbours of balls that
// moved are known.
void ComponentUpdate::begin_search(const MovingRecords &records) {
  searching_ = true;
  const Span<const uint32_t> touched = touched_.part(0, touched_count_);
  for (const uint32_t i : touched) {
    if (records.is_noted(i) && !records.is_moved(i)) push(i);
  }
  for (const uint32_t i : touched) {
    if (!records.is_noted(i)) push(i);
  }
  for (const uint32_t i : touched) {
    if (sets_.find(i) == i && first_[i] == no_id) flags_[i] |= closed;
  }
}

void ComponentUpdate::push(uint32_t ball) {
  const uint32_t root = sets_.find(ball);
  following_[ball] = no_id;
  (first_[root] == no_id ? first_[root] : following_[last_[root]]) = ball;
  last_[root] = ball;
}

// Finds the neighbours of a few balls of a set, which may have been joined to another one meanwhile. Only a few, as
// neighbours cost far more than to find out whether there are rivals left.
void ComponentUpdate::search_further(const MovingRecords &records, const BallCells &cells, uint32_t root) {
  constexpr uint32_t a_few = 2;
  root = sets_.find(root);
  for (uint32_t k = 0; k < a_few && first_[root] != no_id; ++k) {
    const uint32_t i = first_[root];
    first_[root] = following_[i];
    cells.visit_meeting(records.balls, records.balls.ball(i), [&](uint32_t j) {
      const uint32_t known = touched_count_;
      touch(records, j);
      for (const uint32_t other : touched_.part(known, touched_count_)) push(other);
      if (unite(i, j)) links_[link_count_++] = {i, j};
    });
    root = sets_.find(root);
  }
  if (first_[root] == no_id) flags_[root] |= closed;
}

bool ComponentUpdate::leaves(const MovingRecords &records, uint32_t ball) {
  return records.is_moved(ball) || (searching_ && (flags_[sets_.find(ball)] & closed) != 0);
}

// Takes a ball out of its ring. of_ of its component, which is named by its origin, becomes any ball left in the ring.
void ComponentUpdate::take_out(MovingRecords &records, uint32_t ball) {
  records.note(ball);
  MovingBall &own = records.ball[ball];
  uint32_t &left = of_[own.origin];
  if (left == no_id) {
    left = own.origin;
    list_[list_count_++] = own.origin;
  }
  if (own.next == ball) {
    left = nobody;
    return;
  }
  if (left == ball) left = own.next;
  records.note(own.next);
  records.note(own.previous);
  records.ball[own.next].previous = own.previous;
  records.ball[own.previous].next = own.next;
  own.next = own.previous = ball;
}

// Finds the new origin of each component whose origin has left.
void ComponentUpdate::renew_origins(MovingRecords &records) {
  for (const uint32_t component : list_.part(0, list_count_)) {
    const uint32_t left = of_[component];
    of_[component] = no_id;
    if (left == nobody || !is_touched(component) || !leaves(records, component)) continue;
    uint32_t lowest = left;
    for (uint32_t i = records.ball[left].next; i != left; i = records.ball[i].next) {
      if (records.balls.ranks_before(i, lowest)) lowest = i;
    }
    uint32_t i = left;
    do {
      records.note(i);
      records.ball[i].origin = lowest;
      i = records.ball[i].next;
    } while (i != left);
  }
}

// Makes one component of those of the balls of each set. The one with the lowest origin takes in the others.
void ComponentUpdate::merge_sets(MovingRecords &records, Patience &patience) {
  const Span<const uint32_t> touched = touched_.part(0, touched_count_);
  const auto before = [&records](uint32_t a, uint32_t b) { return records.balls.ranks_before(a, b); };
  for (const uint32_t i : touched) {
    if (!patience.allows(50)) break;
    const uint32_t origin = records.ball[i].origin;
    uint32_t &lowest = of_[sets_.find(i)];
    if (lowest == no_id || (lowest != origin && before(origin, lowest))) lowest = origin;
  }
  for (const uint32_t i : touched) {
    if (!patience.allows(200)) break;
    uint32_t to = records.ball[of_[sets_.find(i)]].origin;
    uint32_t from = records.ball[i].origin;
    if (to == from) continue;
    if (before(from, to)) std::swap(from, to);
    uint32_t k = from;
    do {
      records.note(k);
      records.ball[k].origin = to;
      k = records.ball[k].next;
    } while (k != from);
    // Two rings become one.
    const uint32_t to_next = records.ball[to].next, from_last = records.ball[from].previous;
    records.note(to);
    records.note(to_next);
    records.ball[to].next = from;
    records.ball[from].previous = to;
    records.ball[from_last].next = to_next;
    records.ball[to_next].previous = from_last;
  }
  for (const uint32_t i : touched) {
    of_[sets_.find(i)] = no_id;
    static_cast<void>(patience.allows(50));
  }
}

}  // namespace hsp
