// The walk along chords from end to end.
//
// As an example balls 0 to 3 of radius 6 at 0, (6,0,0), (0,6,0) and (0,0,6). The planes of equal power to ball 0 are
// x = 3, y = 3 and z = 3. They meet in (3, 3, 3), which is in all balls, as 27 < 36: a power vertex.
//   at ball 0     from the free end (3, 3, -4.24) the chord of 0, 1 and 2 leads up to z = 3, where ball 3 cuts it
//                 there the chords of 0, 1, 3 and of 0, 2, 3 begin, which lead to free ends
//                 and the chord of 1, 2 and 3, which does not belong to ball 0: it is kept for ball 1
//   at ball 1     this chord leads from (3, 3, 3) along x = y = z to the free end (4, 4, 4): (4-6)^2 + 4^2 + 4^2 = 36
// So one search finds 4 chords, each with one free end, and 1 power vertex: 4 triangles and a tetrahedron.
#include "contacts/chord_walk.hpp"

#include "contacts/empty_cell.hpp"
#include "core/first_index.hpp"
#include "core/small_code.hpp"
#include "sphere/float_caps.hpp"

namespace hsp {
namespace {

// In first_arrival_: the ball is known to be in contact with an earlier one, but has no arrivals. no_id: neither.
constexpr uint32_t no_arrival = no_id - 1;

// Bounds, in doubles, of the place where a cap cuts a chord on the way to one of its ends: 0 is the point of the sphere
// where the way begins, 1 the point where it ends (exact/PROOFS.md, section 7, "First cuts").
class CutBounds {
 public:
  CutBounds(const Caps &caps, const ChordEnd &end) : caps_(caps), points_(caps, end.j, end.k), to_(end.side) {}

  struct Bounds {
    double least, most;
  };
  Bounds of(uint32_t l) const {
    const double error = points_.error, h = height(l, 1 - to_), H = height(l, to_), fall = h - H;
    if (H > error) return {never, never};
    if (!(fall > 2.0 * error)) return {0.0, never};
    return {(h - error) / fall - roundings, (h + error) / fall + roundings};
  }

  static constexpr double never = 4.0;

 private:
  static constexpr double roundings = 0x1p-48;
  double height(uint32_t l, uint32_t point) const {
    return caps_.b[l] - dot(caps_.axis(l), {points_.x[point], points_.y[point], points_.z[point]});
  }

  const Caps &caps_;
  const CrossingPoints points_;
  const uint32_t to_;
};

// The least of the upper bounds: the first cut is not beyond it.
template <class CapAt>
double most_of_first(const CutBounds &bounds, uint32_t count, CapAt cap_at) {
  double first = CutBounds::never;
  for (uint32_t n = 0; n < count; ++n) {
    const double most = bounds.of(cap_at(n)).most;
    first = most < first ? most : first;
  }
  return first;
}

// The exact stage: of the caps cap_at(0) to cap_at(count - 1) that cut the chord in this direction, the one that cuts
// it first: its power vertex is nearer to its balls than to any other. Integers are asked only about caps that may be
// the first, as far as doubles tell: if there are thousands whose planes nearly agree, as for balls on several lines,
// about one or two.
template <class CapAt>
uint32_t cut_exactly(const Caps &caps, uint32_t count, CapAt cap_at, const ChordEnd &end) {
  const auto cut = [&](auto may_be_first) {
    const exact::Predicates predicates = caps.predicates();
    const exact::Plane P = caps.plane(end.j);
    const exact::Plane Q = caps.plane(end.k);
    const int direction = end.side == 1 ? 1 : -1;
    uint32_t nearest = no_id;
    for (uint32_t n = 0; n < count; ++n) {
      const uint32_t l = cap_at(n);
      if (l == end.j || l == end.k || !may_be_first(l)) continue;
      const exact::Plane R = caps.plane(l);
      if (exact::Exact::triple_product_sign(P.v, Q.v, R.v) != direction) continue;
      if (nearest == no_id || predicates.near(P, Q, caps.plane(nearest), R).sign < 0) nearest = l;
    }
    return nearest;
  };
  if constexpr (small_code) {
    return cut([](uint32_t) { return true; });
  } else {
    const CutBounds bounds(caps, end);
    const double first = most_of_first(bounds, count, cap_at);
    return cut([&](uint32_t l) { return !(bounds.of(l).least > first); });
  }
}

template <class Caps>
CapPointers<double> pointers_of(const Caps &caps) {
  return {caps.ux.data(), caps.uy.data(), caps.uz.data(), caps.b.data()};
}

// Writes caps in which nothing lies after the last one, for kernels that read whole registers.
template <class Caps>
void pad(const Caps &caps) {
  for (uint32_t k = caps.count; k < caps.ux.size() && k < caps.count + 3; ++k) {
    caps.ux[k] = caps.uy[k] = caps.uz[k] = 0.0;
    caps.b[k] = 4.0;
  }
}

}  // namespace

// Finds the cap that cuts a chord first, of very many: a cap whose plane meets the chord inside the ball has points in
// common with both caps of the chord, so that it is near them. The index of the caps is in the second halves of some
// arrays; the caps near the smaller one of the two are put side by side in the first halves.
class ChordWalk::NearCuts {
 public:
  NearCuts(const Caps &caps, CapTests &memory)
      : caps_(caps),
        memory_(memory),
        half_(memory.ux.size() / 2),
        near_({words(memory.ux),
               words(memory.uy),
               words(memory.uz),
               {reinterpret_cast<float *>(words(memory.b).data()), memory.ux.size()}}) {
    near_.start(caps);
  }

  uint32_t cut_of(const ChordEnd &end, Target target) const {
    Span<const uint32_t> near = near_.around(caps_, caps_.b[end.j] < caps_.b[end.k] ? end.k : end.j);
    near = near.part(index_in(near, caps_.first_later), near.size());
    const uint32_t count = near.size();
    if (count + 3 <= half_) {
      for (uint32_t n = 0; n < count; ++n) {
        memory_.ux[n] = caps_.ux[near[n]];
        memory_.uy[n] = caps_.uy[near[n]];
        memory_.uz[n] = caps_.uz[near[n]];
        memory_.b[n] = caps_.b[near[n]];
      }
      memory_.count = count;
      pad(memory_);
      const uint32_t cut =
          nearest_cut(target, pointers_of(memory_), 0, count, index_in(near, end.j), index_in(near, end.k), end.side);
      if (cut != no_cut) return near[cut];
    }
    return cut_exactly(
        caps_, count, [near](uint32_t n) { return near[n]; }, end);
  }

 private:
  // The index of the first number that is not less than `cap`.
  static uint32_t index_in(Span<const uint32_t> near, uint32_t cap) {
    return first_index(0, near.size(), [&](uint32_t n) { return near[n] >= cap; });
  }
  Span<uint32_t> words(Span<double> array) const {
    return {reinterpret_cast<uint32_t *>(array.data() + half_), array.size()};
  }

  const Caps &caps_;
  CapTests &memory_;
  const uint32_t half_;
  NearCaps near_;
};

void ChordWalk::carve(Workspace &workspace, const ContactLimits &limits) {
  clipper_.carve(workspace, limits.neighbours);
  chords_ = workspace.take<FoundChord>(3 * static_cast<uint64_t>(limits.neighbours));
  vertices_ = workspace.take<FoundVertex>(2 * static_cast<uint64_t>(limits.neighbours));
  heads_ = workspace.take<uint32_t>(limits.neighbours);
  cap_of_ball_ = workspace.take<uint32_t>(limits.balls);
  first_arrival_ = workspace.take<uint32_t>(limits.balls);
  arrival_balls_ = workspace.take<uint32_t>(2 * static_cast<uint64_t>(limits.contacts));
  next_arrival_ = workspace.take<uint32_t>(limits.contacts);
}

void ChordWalk::start(uint32_t balls, uint32_t own) {
  own_ = own;
  for (uint32_t i = 0; i < balls; ++i) first_arrival_[i] = no_id;
  arrivals_ = 0;
  spare_arrival_ = no_arrival;
  next_vertex_ = 0;
  lost_ = false;
}

bool ChordWalk::gather_in_floats(const BallSet &balls, uint32_t i, uint32_t n, Caps &caps) {
  if constexpr (has_lanes) {
    const CapTests &memory = clipper_.memory();
    const auto half = [](const Span<double> &array) { return reinterpret_cast<float *>(array.data()); };
    const FloatCaps floats{half(memory.ux), half(memory.uy), half(memory.uz), half(memory.b)};
    if (n <= MaskedChords::most_caps &&
        make_float_caps(caps.target, arrays_of(balls), i, caps.ball.data(), n, floats)) {
      floats_ = {floats.x, floats.y, floats.z, floats.b};
      lacks_doubles_ = true;
      caps.take_circles(balls, i, n, 0, nullptr);
      return true;
    }
  }
  return false;
}

void ChordWalk::find(const Boundary &boundary, Caps &caps) {
  const uint32_t *const ball = caps.ball.data();
  uint32_t *const cap_of_ball = cap_of_ball_.data();
  for (uint32_t k = caps.first_later, last = caps.count; k < last; ++k) cap_of_ball[ball[k]] = k;
  chord_count_ = vertex_count_ = 0;
  if (lost_) {
    if (!skips(caps)) try_all_pairs(caps);
    return;
  }
  const uint32_t first = caps.first_later;
  const uint32_t later = caps.count - first;
  if (later <= MaskedChords::most_caps) {
    walk(boundary, caps, MaskedChords(chords_, first, later));
  } else {
    walk(boundary, caps, ListedChords(chords_, heads_, first, later));
  }
}

bool ChordWalk::has_whole_chords(const Boundary &boundary, uint32_t ball, IdRange &ends) {
  const uint32_t arrival = first_arrival_[ball];
  if (lost_ || arrival < no_arrival || (arrival == no_id && !boundary.is_exposed(ball))) return false;
  const uint32_t count = boundary.vertex_count();
  uint32_t v = next_vertex_;
  for (; v < count; v += 2) {
    const VertexRecord &vertex = boundary.vertex(v);
    if (vertex.ball[0] != ball) break;
    if (v + 1 == count) return false;
    const VertexRecord &next = boundary.vertex(v + 1);
    if (next.ball[0] != ball || next.ball[1] != vertex.ball[1] || next.ball[2] != vertex.ball[2]) return false;
  }
  ends = {next_vertex_, v};
  next_vertex_ = v;
  return true;
}

template <class Chords>
void ChordWalk::walk(const Boundary &boundary, Caps &caps, Chords &&chords) {
  const bool from_any = asks_for_all_caps(boundary, caps.origin);
  start_from_ends(boundary, caps, chords);
  if (from_any) start_from_any(caps, chords);
  ChordEnd open{};
  if (chords.next_open(open)) {
    const auto walk_on = [&](auto cut_of) {
      do {
        add_power_vertex<!small_code && !Chords::for_many>(caps, open, cut_of(open), chords);
      } while (chords.next_open(open));
    };
    const Target target = boundary.target();
    const bool are_many = Chords::for_many && NearCaps::are_many(caps, caps.b.data());
    if constexpr (Chords::for_many && !small_code) {
      if (are_many) {
        const NearCuts near(caps, clipper_.memory());
        walk_on([&](const ChordEnd &end) { return near.cut_of(end, target); });
      }
    }
    if (!are_many) {
      if (!in_floats()) pad(caps);
      walk_on([&](const ChordEnd &end) { return cut_of(caps, end, target); });
    }
  }
  chord_count_ = chords.count();
  floats_ = {};
  lacks_doubles_ = false;
}

template <class Chords>
void ChordWalk::start_from_ends(const Boundary &boundary, const Caps &caps, Chords &chords) {
  for (; next_vertex_ < boundary.vertex_count(); ++next_vertex_) {
    const VertexRecord &vertex = boundary.vertex(next_vertex_);
    if (vertex.ball[0] != caps.origin) break;
    chords.set_end(cap_of(vertex.ball[1]), cap_of(vertex.ball[2]), vertex.positive() ? 1 : 0);
  }
  for (uint32_t n = 0; n < chords.count(); ++n) chords_[n].free_ends = static_cast<uint8_t>(chords.known_ends(n));
  const uint32_t first = first_arrival_[caps.origin];
  if (first >= no_arrival) return;
  uint32_t last = first;
  for (uint32_t a = first; a != no_arrival; a = next_arrival_[a / 2]) {
    last = a;
    const uint32_t p = cap_of(arrival_balls_[a]);
    const uint32_t q = cap_of(arrival_balls_[a + 1]);
    const bool ascending = p < q;
    chords.set_end(ascending ? p : q, ascending ? q : p, ascending ? 1 : 0);
  }
  next_arrival_[last / 2] = spare_arrival_;
  spare_arrival_ = first;
}

// At a power vertex three chords of the ball at hand end; the vertex is found at the chord of its first two caps.
void ChordWalk::try_all_pairs(const Caps &caps) {
  clipper_.start(caps);
  for (uint32_t j = caps.first_later; j < caps.count; ++j) {
    for (uint32_t k = j + 1; k < caps.count; ++k) {
      ChordEnds ends;
      if (!clipper_.clip(caps, j, k, ends)) continue;
      chords_[chord_count_++] = {{j, k}, static_cast<uint8_t>(ends.free_ends()), 0, no_id};
      for (const uint32_t l : ends.clipper) {
        if (l != no_id && l > k) vertices_[vertex_count_++] = {{j, k, l}, 7};
      }
    }
  }
}

// Searches all pairs for one chord; its ends are power vertices with later balls. Mostly there is none.
template <class Chords>
void ChordWalk::start_from_any(const Caps &caps, Chords &chords) {
  constexpr uint32_t many_pairs = 256;
  clipper_.start(caps);
  uint32_t pairs = 0;
  for (uint32_t j = caps.first_later; j < caps.count; ++j) {
    for (uint32_t k = j + 1; k < caps.count; ++k) {
      if (++pairs == many_pairs && has_empty_cell(caps)) return;
      ChordEnds ends;
      if (!clipper_.clip(caps, j, k, ends)) continue;
      for (uint32_t side = 0; side < 2; ++side) add_power_vertex<false>(caps, {j, k, side}, ends.clipper[side], chords);
      return;
    }
  }
}

// The cap that cuts a chord first. The chord survives, and does not end in a vertex of the boundary at this side.
uint32_t ChordWalk::cut_in_doubles(Caps &caps, const ChordEnd &end, Target target) {
  if (lacks_doubles_) {
    lacks_doubles_ = false;
    caps.make_doubles();
    pad(caps);
  }
  const uint32_t first = caps.first_later;
  const uint32_t cut = nearest_cut(target, pointers_of(caps), first, caps.count, end.j, end.k, end.side);
  if (cut != no_cut) return cut;
  return cut_exactly(
      caps, caps.count - first, [first](uint32_t n) { return first + n; }, end);
}

// A power vertex of the ball at hand with caps a < b < c. If their axes are a right-handed system, it is the end at the
// side of p+ for the chords a b and b c, and of p- for a c; else the other way round. For the chord of the balls of a,
// b and c, seen from ball a, it is the opposite side of that of b c. is_known: the table need not be given this end of
// the chord that led here; else it is given the ends of all three chords.
template <bool is_known, class Chords>
void ChordWalk::add_power_vertex(const Caps &caps, const ChordEnd &end, uint32_t clipper, Chords &chords) {
  const auto [j, k, side] = end;
  const uint32_t behind_j = clipper > j ? 1 : 0, before_k = clipper < k ? 1 : 0;
  const uint32_t a = behind_j != 0 ? j : clipper;
  const uint32_t c = before_k != 0 ? k : clipper;
  const uint32_t b = j ^ k ^ clipper ^ a ^ c;
  const uint32_t even = side ^ (behind_j & before_k);
  FoundVertex &vertex = vertices_[vertex_count_++];
  vertex.cap[0] = a;
  vertex.cap[1] = b;
  vertex.cap[2] = c;
  if constexpr (is_known) {
    const uint32_t with_j = chords.set_end(a, behind_j != 0 ? clipper : j, side ^ behind_j) ? 1 : 0;
    const uint32_t with_k = chords.set_end(before_k != 0 ? clipper : k, c, side ^ before_k) ? 1 : 0;
    vertex.new_chords = with_j << (1 - before_k) | with_k << (1 + behind_j);
  } else {
    const uint32_t ab = chords.set_end(a, b, even) ? 1 : 0;
    const uint32_t ac = chords.set_end(a, c, 1 - even) ? 2 : 0;
    vertex.new_chords = ab | ac | (chords.set_end(b, c, even) ? 4 : 0);
  }

  const uint32_t first = caps.ball[a];
  const uint32_t second = caps.ball[b];
  const uint32_t third = caps.ball[c];
  if (first >= own_) return;  // then so are b and c
  // These balls are in contact with an earlier one: no_id becomes no_arrival.
  static_assert((no_id & ~1U) == no_arrival);
  uint32_t *const arrived = first_arrival_.data();
  arrived[first] &= ~1U;
  arrived[second] &= ~1U;
  arrived[third] &= ~1U;
  const bool is_spare = spare_arrival_ != no_arrival;
  if (!is_spare && arrivals_ == next_arrival_.size()) {
    arrived[first] = no_arrival;
    lost_ = true;
    return;
  }
  const uint32_t arrival = is_spare ? spare_arrival_ : 2 * arrivals_++;
  if (is_spare) spare_arrival_ = next_arrival_[arrival / 2];
  next_arrival_[arrival / 2] = arrived[first];
  arrived[first] = arrival;
  arrival_balls_[arrival + even] = second;
  arrival_balls_[arrival + (1 - even)] = third;
}

}  // namespace hsp
