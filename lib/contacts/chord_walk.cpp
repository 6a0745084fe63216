#include "contacts/chord_walk.hpp"

#include "contacts/chord_cuts.hpp"
#include "contacts/unit_chord.hpp"

namespace hsp {
namespace {

// An end that nothing is known of yet, beside no_id for a vertex of the boundary.
constexpr uint32_t unknown = no_id - 1;
// A ball that is in contact with an earlier one, but no arrivals are left to it; beside no_id for one that is not.
constexpr uint32_t no_arrival = no_id - 1;

// The exact stage: of later caps in the direction in which they cut, the one whose power vertex is nearer to its balls
// than to any other.
uint32_t cut_exactly(const Caps &caps, uint32_t j, uint32_t k, uint32_t side) {
  const exact::Predicates predicates = caps.predicates();
  const exact::Plane &P = caps.plane(j);
  const exact::Plane &Q = caps.plane(k);
  const int direction = side == 1 ? 1 : -1;
  uint32_t nearest = no_id;
  for (uint32_t l = caps.first_later; l < caps.count; ++l) {
    if (l == j || l == k) continue;
    const exact::Plane &R = caps.plane(l);
    if (exact::Exact::triple_product_sign(P.v, Q.v, R.v) != direction) continue;
    if (nearest == no_id || predicates.near(P, Q, caps.plane(nearest), R).sign < 0) nearest = l;
  }
  return nearest;
}

// Caps that nothing lies in behind the last one, for who reads whole registers.
void pad(Caps &caps) {
  for (uint32_t k = caps.count; k < caps.ux.size() && k < caps.count + 3; ++k) {
    caps.ux[k] = caps.uy[k] = caps.uz[k] = 0.0;
    caps.b[k] = 4.0;
  }
}

}  // namespace

void ChordWalk::carve(Workspace &workspace, const ContactLimits &limits) {
  clipper_.carve(workspace, limits.neighbours);
  chords_ = workspace.take<FoundChord>(3 * static_cast<uint64_t>(limits.neighbours));
  first_chord_ = workspace.take<uint32_t>(limits.neighbours);
  cap_of_ball_ = workspace.take<uint32_t>(limits.balls);
  first_arrival_ = workspace.take<uint32_t>(limits.balls);
  arrival_balls_ = workspace.take<uint32_t>(2 * static_cast<uint64_t>(limits.contacts));
  arrival_clipper_ = workspace.take<uint32_t>(limits.contacts);
  next_arrival_ = workspace.take<uint32_t>(limits.contacts);
}

void ChordWalk::start(uint32_t balls, uint32_t own) {
  own_ = own;
  for (uint32_t i = 0; i < balls; ++i) first_arrival_[i] = no_id;
  arrivals_ = 0;
  next_vertex_ = 0;
  lost_ = false;
}

void ChordWalk::find(const Boundary &boundary, Caps &caps) {
  count_ = 0;
  for (uint32_t k = 0; k < caps.count; ++k) {
    cap_of_ball_[caps.ball[k]] = k;
    first_chord_[k] = no_id;
  }
  if (lost_) return try_pairs(caps, false);
  if (asks_for_all_caps(boundary, caps.origin)) try_pairs(caps, true);
  start_from_ends(boundary, caps);
  if (count_ == 0) return;
  pad(caps);
  follow(caps, boundary.has_wide_code());
}

void ChordWalk::start_from_ends(const Boundary &boundary, const Caps &caps) {
  for (; next_vertex_ < boundary.vertex_count(); ++next_vertex_) {
    const VertexRecord &vertex = boundary.vertex(next_vertex_);
    if (vertex.ball[0] != caps.origin) break;
    FoundChord &chord = chord_of(cap_of(vertex.ball[1]), cap_of(vertex.ball[2]));
    chord.clipper[vertex.positive() ? 1 : 0] = no_id;
    chord.vertex = next_vertex_;
  }
  uint32_t a = first_arrival_[caps.origin];
  if (a == no_id) return;
  for (; a != no_arrival; a = next_arrival_[a]) {
    const uint32_t p = cap_of(arrival_balls_[2 * a]);
    const uint32_t q = cap_of(arrival_balls_[2 * a + 1]);
    FoundChord &chord = p < q ? chord_of(p, q) : chord_of(q, p);
    chord.clipper[p < q ? 1 : 0] = arrival_clipper_[a];
  }
}

// All chords, or one, whose ends are at later balls then.
void ChordWalk::try_pairs(const Caps &caps, bool one_is_enough) {
  clipper_.start(caps);
  for (uint32_t j = caps.first_later; j < caps.count; ++j) {
    for (uint32_t k = j + 1; k < caps.count; ++k) {
      ChordEnds ends;
      if (!clipper_.clip(caps, j, k, ends)) continue;
      for (uint32_t side = 0; side < 2; ++side) {
        const uint32_t clipper = ends.clipper[side];
        if (one_is_enough) {
          add_power_vertex(caps, j, k, clipper, side);
        } else {
          chord_of(j, k).clipper[side] = clipper == no_id ? no_id : caps.ball[clipper];
        }
      }
      if (one_is_enough) return;
    }
  }
}

// The chord of caps j < k, which is new or not.
FoundChord &ChordWalk::chord_of(uint32_t j, uint32_t k) {
  uint32_t *place = &first_chord_[j];
  while (*place != no_id && chords_[*place].cap[1] < k) place = &chords_[*place].next;
  if (*place != no_id && chords_[*place].cap[1] == k) return chords_[*place];
  const uint32_t after = *place;
  *place = count_;
  chords_[count_] = {{j, k}, {unknown, unknown}, no_id, after};
  return chords_[count_++];
}

// To the other ends of all chords, and of those that are found there.
void ChordWalk::follow(const Caps &caps, bool wide) {
  for (uint32_t c = 0; c < count_; ++c) {
    const FoundChord chord = chords_[c];
    for (uint32_t side = 0; side < 2; ++side) {
      if (chord.clipper[side] != unknown) continue;
      const auto [j, k] = chord.cap;
      add_power_vertex(caps, j, k, cut_of(caps, j, k, side, wide), side);
    }
  }
}

// Of a chord that survives and does not end in a vertex of the boundary at this side.
uint32_t ChordWalk::cut_of(const Caps &caps, uint32_t j, uint32_t k, uint32_t side, [[maybe_unused]] bool wide) const {
  const CapPair pair(caps, j, k);
  if (pair.certainly_cross()) {
    const UnitChord chord(caps, j, k, pair);
    const double direction = side == 1 ? 1.0 : -1.0;
    const ChordRay ray{{chord.m.x, chord.m.y, chord.m.z},
                       {direction * chord.w.x, direction * chord.w.y, direction * chord.w.z}};
    const CapColumns columns{caps.ux.data(), caps.uy.data(), caps.uz.data(), caps.b.data()};
#if HSP_AVX2
    const NearestCut cut = wide ? nearest_cut_avx2(columns, caps.first_later, caps.count, ray)
                                : nearest_cut(columns, caps.first_later, caps.count, ray);
#else
    const NearestCut cut = nearest_cut(columns, caps.first_later, caps.count, ray);
#endif
    const double gap = 8 * chord.error / ChordRay::least_slope;
    if (chord.error <= ChordRay::most_error && cut.unclear == 2 && cut.s < 2.0 && cut.second - cut.s > gap) {
      return cut.cap;
    }
  }
  return cut_exactly(caps, j, k, side);
}

// Of caps a < b < c the ends lie at the side of p+ for the pairs a b and b c, and of p- for a c, if their axes are a
// right-handed system; and the other way round. Seen from ball a, whose chord with b and c ends at the ball at hand, it
// is the other way round too.
void ChordWalk::add_power_vertex(const Caps &caps, uint32_t j, uint32_t k, uint32_t clipper, uint32_t side) {
  const uint32_t a = clipper < j ? clipper : j;
  const uint32_t c = clipper < k ? k : clipper;
  const uint32_t b = j ^ k ^ clipper ^ a ^ c;
  const uint32_t even = side ^ (b == clipper ? 1U : 0U);
  const uint32_t second = caps.ball[b];
  const uint32_t third = caps.ball[c];
  chord_of(a, b).clipper[even] = third;
  chord_of(a, c).clipper[1 - even] = second;
  chord_of(b, c).clipper[even] = caps.ball[a];

  if (caps.ball[a] >= own_) return;  // as are b and c
  uint32_t &first = first_arrival_[caps.ball[a]];
  const uint32_t next = first == no_id ? no_arrival : first;
  if (arrivals_ < next_arrival_.size()) {
    first = arrivals_++;
    arrival_balls_[2 * first] = even == 0 ? second : third;
    arrival_balls_[2 * first + 1] = even == 0 ? third : second;
    arrival_clipper_[first] = caps.origin;
    next_arrival_[first] = next;
  } else {
    first = no_arrival;
    lost_ = true;
  }
  if (first_arrival_[second] == no_id) first_arrival_[second] = no_arrival;
  if (first_arrival_[third] == no_id) first_arrival_[third] = no_arrival;
}

}  // namespace hsp
