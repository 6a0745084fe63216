#include "mesh/flat_strips.hpp"

namespace hsp {

FlatStrips::FlatStrips(const SphericalPatch &patch, const Vec3 &normal) : patch_(patch), normal_(normal) {}

Vec3 FlatStrips::direction(uint32_t sample) const {
  const Vec3 &d = patch_.sample(sample).direction;
  return combine(1.0, d, -dot(d, normal_), normal_);
}

// Between points of a border, of less than half a turn.
double FlatStrips::turn(uint32_t from, uint32_t to) const {
  const Vec3 a = direction(from);
  const Vec3 b = direction(to);
  return arc_tangent(dot(cross(a, b), normal_), dot(a, b));
}

uint32_t FlatStrips::beside(const Border &border) const {
  const IdRange range = patch_.samples_of_loop(border.loop);
  if (border.backwards) return border.sample > range.first ? border.sample - 1 : range.last - 1;
  return border.sample + 1 < range.last ? border.sample + 1 : range.first;
}

void FlatStrips::step(Border &border) const {
  const uint32_t next = beside(border);
  border.angle += turn(border.sample, next);
  border.sample = next;
  --border.left;
}

// Where the directions of a loop begin and where they end.
void FlatStrips::find_ends(uint32_t loop, uint32_t &first, uint32_t &last) const {
  const IdRange range = patch_.samples_of_loop(loop);
  Border border{loop, range.first, range.size(), 0.0, false};
  double least = 0.0;
  double most = 0.0;
  first = last = range.first;
  while (border.left > 1) {
    step(border);
    if (border.angle < least) {
      least = border.angle;
      first = border.sample;
    }
    if (border.angle > most) {
      most = border.angle;
      last = border.sample;
    }
  }
  // Without extent any two will do.
  if (first == last) last = first + 1 < range.last ? first + 1 : range.first;
}

FlatStrips::Border FlatStrips::forwards_of(uint32_t loop) const {
  const IdRange range = patch_.samples_of_loop(loop);
  if (has_second_loop(loop)) return {loop, range.first, range.size(), 0.0, false};
  uint32_t first;
  uint32_t last;
  find_ends(loop, first, last);
  return {loop, first, (last + range.size() - first) % range.size(), 0.0, false};
}

FlatStrips::Border FlatStrips::backwards_of(uint32_t loop) const {
  const IdRange range = patch_.samples_of_loop(loop);
  uint32_t first;
  uint32_t last;
  find_ends(loop, first, last);
  return {loop, first, (first + range.size() - last) % range.size(), 0.0, true};
}

// The other loop of a ring, from the point that is nearest to where the first one begins.
FlatStrips::Border FlatStrips::ring_behind(uint32_t loop, const Border &forwards) const {
  const IdRange range = patch_.samples_of_loop(loop + 1);
  Border best{loop + 1, range.first, range.size(), 0.0, true};
  double nearest = 2 * pi;
  for (uint32_t k = range.first; k < range.last; ++k) {
    const double angle = turn(forwards.sample, k);
    if (angle < 0.0 || angle >= nearest) continue;
    nearest = angle;
    best.sample = k;
    best.angle = angle;
  }
  return best;
}

bool FlatStrips::is_monotone(Border border) const {
  while (border.left > 0) {
    const double before = border.angle;
    step(border);
    if (border.angle < before - 1e-6) return false;
  }
  return true;
}

bool FlatStrips::are_strips() const {
  if (patch_.loop_count() == 0) return false;
  for (uint32_t loop = 0; loop < patch_.loop_count();) {
    if (patch_.samples_of_loop(loop).size() < 3) return false;
    const bool ring = has_second_loop(loop);
    const Border forwards = forwards_of(loop);
    const Border backwards = ring ? ring_behind(loop, forwards) : backwards_of(loop);
    if (!is_monotone(forwards) || !is_monotone(backwards)) return false;
    loop += ring ? 2 : 1;
    if (ring && loop < patch_.loop_count() && patch_.face_of_loop(loop) == patch_.face_of_loop(loop - 1)) return false;
  }
  return true;
}

Vec3 FlatStrips::middle(const Border &one, const Border &other) const {
  const Vec3 &a = patch_.sample(one.sample).direction;
  const Vec3 &b = patch_.sample(other.sample).direction;
  const Vec3 sum = combine(1.0 / std::sqrt(dot(a, a)), a, 1.0 / std::sqrt(dot(b, b)), b);
  return dot(sum, sum) > 0.0 ? sum : a;
}

}  // namespace hsp
