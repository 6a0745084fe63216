// Clips chords by one cap after the other.
//
// As an example the balls of radius 6 at 0, (6,0,0), (0,6,0) and (0,0,6), and at the first of them the chord of the
// second and the third. It runs from p- = (3, 3, -4.24) to p+ = (3, 3, 4.24). The cap of the fourth ball is z >= 3: it
// holds p+ and not p-, so that it clips the end at p+, in (3, 3, 3). The chord from (3, 3, -4.24) to (3, 3, 3) is left,
// with one free end.
//   clipper      no_id, and the number of the fourth ball's cap
#include "contacts/chord_clipper.hpp"

#include "lanes/wide.hpp"
#include "sphere/cap_pair.hpp"

namespace hsp {
namespace {

using Two = Wide<double, 2>;

// A chord on the unit sphere, to be tested against two caps at a time.
struct LaneChord {
  Two::Real mx, my, mz, wx, wy, wz;

  explicit LaneChord(const UnitChord &chord)
      : mx(Two::all(chord.m.x)),
        my(Two::all(chord.m.y)),
        mz(Two::all(chord.m.z)),
        wx(Two::all(chord.w.x)),
        wy(Two::all(chord.w.y)),
        wz(Two::all(chord.w.z)) {}

  // Depths of p- and p+ in the test caps t and t + 1.
  struct Depths {
    Two::Real end[2];
  };
  Depths depths(const CapTests &tests, uint32_t t) const {
    const Two::Real x = Two::load(&tests.ux[t]);
    const Two::Real y = Two::load(&tests.uy[t]);
    const Two::Real z = Two::load(&tests.uz[t]);
    const Two::Real f = mx * x + my * y + mz * z - Two::load(&tests.b[t]);
    const Two::Real g = wx * x + wy * y + wz * z;
    return {{f - g, f + g}};
  }
  // Whether one of the caps t to t + 3 certainly holds both ends.
  bool inside_one(const CapTests &tests, uint32_t t, const Two::Real &bound) const {
    const Depths a = depths(tests, t);
    const Depths b = depths(tests, t + Two::lanes);
    return Two::any(((a.end[0] > bound) & (a.end[1] > bound)) | ((b.end[0] > bound) & (b.end[1] > bound)));
  }
};

// The point where a cap clips: s = -f/g with |f| < |g|. Let the errors of f and g together be at most E, and |g| >= 2E.
// The quotient is off by at most E/(|g| - E) <= 2E/|g|; its own rounding is below E/|g|, as E >= 256e and |g| <= 1 + E.
struct Clip {
  double s, error;
  uint32_t cap;
};

// The exact stage. The order in which caps are asked about does not matter, as answers agree with each other. The cap
// that held all of the last chord comes first: if many spheres go through one point, it mostly holds this chord, too.
bool clip_exactly(const Caps &caps, uint32_t j, uint32_t k, ChordEnds &ends, uint32_t &holder) {
  const exact::Predicates predicates = caps.predicates();
  const exact::Plane P = caps.plane(j);
  const exact::Plane Q = caps.plane(k);
  if (predicates.crossing(P, Q).sign < 0) return false;
  ends = {{no_id, no_id}};
  const uint32_t first = holder;
  for (uint32_t n = 0; n < caps.count; ++n) {
    const uint32_t l = with_one_first(n, first);
    if (l == j || l == k) continue;
    const exact::Plane R = caps.plane(l);
    const exact::PointStatus status = predicates.point_status(P, Q, R);
    if (status.side[0] > 0 && status.side[1] > 0) {
      holder = l;
      return false;
    }
    for (int end = 0; end < 2; ++end) {
      uint32_t &clipper = ends.clipper[end];
      if (status.side[end] < 0) continue;
      if (clipper == no_id || predicates.near(P, Q, caps.plane(clipper), R).sign < 0) clipper = l;
    }
  }
  return ends.free_ends() > 0 ||
         predicates.near(P, Q, caps.plane(ends.clipper[0]), caps.plane(ends.clipper[1])).sign > 0;
}

// Whether the cap of `next` clips the chord by more than that of `now`. direction: 1 at the side of p+, -1 at p-.
bool clips_more(const Caps &caps, uint32_t j, uint32_t k, const Clip &now, const Clip &next, double direction) {
  if (now.cap == no_id) return true;
  const double nearer = (now.s - next.s) * direction;
  const double error = now.error + next.error;
  if (nearer > error) return true;
  if (nearer < -error) return false;
  return caps.predicates().near(caps.plane(j), caps.plane(k), caps.plane(now.cap), caps.plane(next.cap)).sign < 0;
}

}  // namespace

void ChordClipper::carve(Workspace &workspace, uint32_t capacity) {
  tests_.carve(workspace, capacity);
  covered_ = workspace.take<uint8_t>(capacity);
}

void ChordClipper::start(const Caps &caps) {
  tests_.fill(caps);
  for (uint32_t j = 0; j < caps.count; ++j) covered_[j] = 0;
  hint_ = holder_ = 0;
}

bool ChordClipper::clip(const Caps &caps, uint32_t j, uint32_t k, ChordEnds &ends) {
  if ((covered_[j] | covered_[k]) != 0) return false;
  const CapPair pair(caps, j, k);
  if (pair.certainly_apart()) {
    if (pair.certainly_inside()) covered_[j] = 1;
    if (pair.certainly_contains()) covered_[k] = 1;
    return false;
  }
  if (pair.certainly_cross()) {
    const Answer answer = clip_in_doubles(caps, j, k, pair, ends);
    if (answer != Answer::uncertain) return answer == Answer::left;
  }
  return clip_exactly(caps, j, k, ends, holder_);
}

// Certain only if doubles tell for all caps but the chord's own two on which side of their planes its ends are.
ChordClipper::Answer ChordClipper::clip_in_doubles(const Caps &caps, uint32_t j, uint32_t k, const CapPair &pair,
                                                   ChordEnds &ends) {
  static_assert(CapTests::group == 2 * Two::lanes);
  const UnitChord chord(caps, j, k, pair);
  const LaneChord lanes(chord);
  const Two::Real bound = Two::all(chord.error);
  if (lanes.inside_one(tests_, hint_, bound)) return Answer::gone;

  Clip clip[2] = {{-1.0, 0.0, no_id}, {1.0, 0.0, no_id}};
  uint32_t near = 0;
  bool certain = true;
  for (uint32_t t = 0; t < tests_.count; t += Two::lanes) {
    const auto [end] = lanes.depths(tests_, t);
    // Most caps hold neither end, and none is near.
    if (!Two::any(~((end[0] < -bound) & (end[1] < -bound)))) continue;
    const Two::Mask holds[2] = {end[0] > bound, end[1] > bound};
    if (Two::any(holds[0] & holds[1])) {
      hint_ = t - t % CapTests::group;
      return Answer::gone;
    }
    near += Two::count(((end[0] >= -bound) & (end[0] <= bound)) | ((end[1] >= -bound) & (end[1] <= bound)));
    const Two::Mask cuts = (holds[0] & (end[1] < -bound)) | (holds[1] & (end[0] < -bound));
    if (!Two::any(cuts)) continue;
    for (uint32_t lane = 0; lane < Two::lanes; ++lane) {
      if (cuts[lane] == 0) continue;
      const uint32_t side = holds[1][lane] != 0 ? 1 : 0;
      const double f = 0.5 * (end[1][lane] + end[0][lane]);
      const double g = 0.5 * (end[1][lane] - end[0][lane]);
      const double size = g < 0.0 ? -g : g;
      certain = certain && size >= 2 * chord.error;
      const Clip next{-f / g, 3 * chord.error / size, tests_.cap[t + lane]};
      if (clips_more(caps, j, k, clip[side], next, side == 1 ? 1.0 : -1.0)) clip[side] = next;
    }
    if (clip[0].s - clip[1].s > clip[0].error + clip[1].error && certain) return Answer::gone;
  }
  if (near != 2 || !certain) return Answer::uncertain;
  ends = {{clip[0].cap, clip[1].cap}};
  if (ends.free_ends() > 0 || clip[1].s - clip[0].s > clip[0].error + clip[1].error) return Answer::left;
  const exact::Sign sign =
      caps.predicates().near(caps.plane(j), caps.plane(k), caps.plane(ends.clipper[0]), caps.plane(ends.clipper[1]));
  return sign.sign > 0 ? Answer::left : Answer::gone;
}

}  // namespace hsp
