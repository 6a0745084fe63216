#include "mesh/spherical_patch.hpp"

#include "mesh/ring_points.hpp"

namespace hsp {

// In units of the distance between points. Points inside keep away from borders by the first share. A point deeper in a
// cap than the second share cannot come to lie in the patch, although chords run beside their arcs.
constexpr double share_kept_off = 0.6;
constexpr double share_well_inside = 0.25;

void SphericalPatch::carve(Workspace &workspace, uint32_t points) {
  const uint64_t triangles = 2 * uint64_t{points};
  sphere_.carve(workspace, points);
  samples_ = FixedVector(workspace.take<BorderSample>(points));
  loops_ = FixedVector(workspace.take<Loop>(points));
  caps_ = FixedVector(workspace.take<Cap>(points));
  ears_ = FixedVector(workspace.take<Ear>(points));
  links_ = workspace.take<Link>(points);
  inputs_ = FixedVector(workspace.take<RoundedDirection>(points));
  sample_at_ = workspace.take<uint32_t>(points);
  parts_ = workspace.take<Part>(triangles);
  queue_ = workspace.take<uint32_t>(triangles);
  balance_ = workspace.take<int64_t>(points);
}

void SphericalPatch::begin(double spacing) {
  spacing_ = spacing < largest_ring_spacing ? spacing : largest_ring_spacing;
  all_coarse_ = false;
  has_corridors_ = false;
  latest_cap_ = 0;
  samples_.clear();
  loops_.clear();
  caps_.clear();
  ears_.clear();
  inputs_.clear();
}

// The cosines of a cap's angle a plus one angle and minus another. If the sum is beyond pi or the difference below 0,
// they are out of the range of cosines, so that all directions are near, or none is inside.
void SphericalPatch::keep_off(const Vec3 &axis, double cosine) {
  const double sine = std::sqrt(cosine < 1.0 ? (1.0 - cosine) * (1.0 + cosine) : 0.0);
  const SinCos more = sin_cos(share_kept_off * spacing_);
  const SinCos less = sin_cos(share_well_inside * spacing_);
  const double near = cosine > -more.cosine ? cosine * more.cosine - sine * more.sine : -2.0;
  const double inside = cosine < less.cosine ? cosine * less.cosine + sine * less.sine : 2.0;
  caps_.push({axis, cosine, inside, near});
}

void SphericalPatch::begin_loop(uint32_t face) {
  loops_.push({clamped_count(samples_.required()), face});
}

void SphericalPatch::add(const BorderSample &sample) {
  samples_.push(sample);
}

// Neighbouring points are mostly near the same cap.
bool SphericalPatch::is_near_cap(const Vec3 &direction) {
  const uint32_t n = caps_.size();
  if (n == 0) return false;
  if (dot(direction, caps_[latest_cap_].axis) > caps_[latest_cap_].near) return true;
  for (uint32_t k = 0; k < n; ++k) {
    if (dot(direction, caps_[k].axis) <= caps_[k].near) continue;
    latest_cap_ = k;
    return true;
  }
  return false;
}

// Whether all points of a circle of latitude are certainly near caps: a patch may be far smaller than its sphere, and
// most circles are nowhere near it. A walk goes around it, each time to the end of the cap that leads farthest.
bool SphericalPatch::is_circle_near_caps(double sine, double cosine) const {
  constexpr int most_turns = 24;
  constexpr double safe = 1e-9;  // far more than points are off their circle
  struct Way {
    double x, y;
  };
  // How far it is around the circle, 0 to 4, from one way counter-clockwise to another one.
  const auto turn_between = [](const Way &a, const Way &b) {
    const double x = a.x * b.x + a.y * b.y, y = a.x * b.y - a.y * b.x;
    const double part = y / (std::fabs(x) + std::fabs(y));
    return x < 0.0 ? 2.0 - part : y < 0.0 ? 4.0 + part : part;
  };
  const Way start{1.0, 0.0};
  Way at = start;
  for (int turn = 0; turn < most_turns; ++turn) {
    const double whole = turn == 0 ? 4.0 : turn_between(at, start);
    double farthest = 0.0;
    Way end = at;
    for (uint32_t k = 0; k < caps_.size(); ++k) {
      const Vec3 &axis = caps_[k].axis;
      const double least = caps_[k].near + safe - cosine * axis.z;
      if (!(sine * (at.x * axis.x + at.y * axis.y) > least + safe)) continue;
      const double square = axis.x * axis.x + axis.y * axis.y, along = least / sine;
      const double across = square - along * along;
      if (across <= 0.0 && along < 0.0) return true;
      if (across <= 0.0) continue;
      const double root = std::sqrt(across);
      const Way last{(along * axis.x - root * axis.y) / square, (along * axis.y + root * axis.x) / square};
      const double reached = turn_between(at, last);
      if (reached >= whole) return true;
      if (reached <= farthest) continue;
      farthest = reached;
      end = last;
    }
    if (farthest == 0.0) return false;
    at = end;
  }
  return false;
}

// Whether a direction is inside a cap whose circle a border runs on.
bool SphericalPatch::is_covered(const Vec3 &direction) const {
  const double length = std::sqrt(dot(direction, direction));
  bool covered = false;
  for (uint32_t k = 0; k < border_caps_; ++k) covered |= dot(direction, caps_[k].axis) > caps_[k].cosine * length;
  return covered;
}

// A free direction between two samples: half-way, or else nearer and nearer to one of them; that of sample a if none is
// free.
Vec3 SphericalPatch::direction_between(uint32_t a, uint32_t b) const {
  constexpr double most_weight = 31.0;
  const Vec3 from = to_double(sphere_.point(links_[a].point));
  const Vec3 to = to_double(sphere_.point(links_[b].point));
  for (double weight = 1.0; weight <= most_weight; weight = 2.0 * weight + 1.0) {
    const Vec3 nearer_from = combine(weight, from, 1.0, to);
    if (!is_covered(nearer_from)) return nearer_from;
    const Vec3 nearer_to = combine(1.0, from, weight, to);
    if (!is_covered(nearer_to)) return nearer_to;
  }
  return direction_of(a);
}

// The orientation with the fewest corners near a border.
uint32_t SphericalPatch::choose_octahedron() const {
  uint32_t best = 0;
  uint32_t fewest = no_id;
  for (uint32_t turn = 0; turn < SphereTriangulation::octahedron_turns && fewest > 0; ++turn) {
    uint32_t bad = 0;
    for (uint32_t k = 0; k < SphereTriangulation::octahedron_points; ++k) {
      const Vec3 corner = SphereTriangulation::octahedron_corner(turn, k);
      bool near = false;
      bool inside = false;
      for (uint32_t c = 0; c < caps_.size() && !inside; ++c) {
        const double cosine = dot(corner, caps_[c].axis);
        near |= cosine > caps_[c].near;
        inside = cosine > caps_[c].inside;
      }
      if (near && !inside) ++bad;
    }
    if (bad < fewest) {
      fewest = bad;
      best = turn;
    }
  }
  return best;
}

PatchState SphericalPatch::triangulate(bool pinched) {
  if (!(expected_ring_points(spacing_) < max_count)) {
    needed_points_ = uint64_t{max_count} + 1;
    return PatchState::capacity;
  }
  border_caps_ = caps_.size();
  const uint32_t turn = choose_octahedron();
  for (uint32_t k = 0; k < samples_.size(); ++k) inputs_.push(rounded(samples_[k].direction));
  const uint64_t samples_without_room = samples_.required() - samples_.size();
  for (uint32_t k = 0; k < SphereTriangulation::octahedron_points; ++k) {
    const Vec3 corner = SphereTriangulation::octahedron_corner(turn, k);
    if (!is_near_cap(corner)) keep_off(corner, 1.0);
  }
  add_inner_points();
  // Every loop and every cap has a sample, or is the octahedron's.
  needed_points_ = SphereTriangulation::octahedron_points + inputs_.required() + samples_without_room;
  if (needed_points_ > inputs_.capacity()) return PatchState::capacity;
  sphere_.start(turn);
  insert_points();
  link_samples();
  bool good = route_strands(pinched);
  if (good) {
    sphere_.restore_all();
    linked_samples_ = samples_.size();
    good = name_triangles() && close_wedges() && add_necks() && add_faces_without_extent();
  }
  if (good) {
    add_corridors();
    add_detours();
  }
  // This is done even if there was room, so that the need does not depend on the room.
  const uint64_t used = samples_.required() > ears_.required() ? samples_.required() : ears_.required();
  if (used > needed_points_) needed_points_ = used;
  if (samples_.overflowed() || ears_.overflowed()) {
    needed_points_ += needed_points_ / 2;  // it may want more than what it came to
    return PatchState::capacity;
  }
  if (good && has_right_numbers()) return PatchState::complete;
  all_coarse_ = !has_coarse_borders();
  return PatchState::too_coarse;
}

void SphericalPatch::add_inner_points() {
  for_each_ring_point(
      spacing_, [this](double sine, double cosine) { return !is_circle_near_caps(sine, cosine); },
      [this](const Vec3 &direction) {
        if (!is_near_cap(direction)) inputs_.push(rounded(direction));
      });
}

// Inserts few points first, then ever more, each time in the order of the inputs: so neither walks nor chains of flips
// are long.
void SphericalPatch::insert_points() {
  const uint32_t n = inputs_.size();
  for (uint32_t p = 0; p < SphereTriangulation::octahedron_points; ++p) sample_at_[p] = no_id;
  uint32_t stride = 1;
  while (stride < n) stride *= 2;
  for (; stride > 0; stride /= 2) {
    for (uint64_t k = stride - 1; k < n; k += 2 * uint64_t{stride}) {
      const auto input = static_cast<uint32_t>(k);
      const bool on_border = input < samples_.size();
      const uint32_t before = sphere_.point_count();
      const uint32_t p = sphere_.insert(inputs_[input]);
      if (p == before) sample_at_[p] = no_id;
      if (on_border) {
        sample_at_[p] = input;
        links_[input].point = p;
      }
    }
  }
}

void SphericalPatch::link_samples() {
  border_samples_ = linked_samples_ = samples_.size();
  for (uint32_t loop = 0; loop < loops_.size(); ++loop) {
    const uint32_t first = loops_[loop].first, last = end_of_loop(loop);
    for (uint32_t k = first; k < last; ++k) {
      const uint32_t next = k + 1 < last ? k + 1 : first, previous = k > first ? k - 1 : last - 1;
      links_[k] = {next, previous, links_[k].point, false, false, loops_[loop].face, no_id, no_id};
    }
  }
}

void SphericalPatch::mark_coarse(uint32_t point) {
  const uint32_t sample = sample_at_[point];
  if (sample != no_id) links_[sample].coarse = links_[links_[sample].previous].coarse = true;
}

bool SphericalPatch::has_coarse_borders() const {
  bool any = false;
  for (uint32_t k = 0; k < samples_.size() && !any; ++k) any = links_[k].coarse;
  return any;
}

// Borders without length are never marked: more points on them would change nothing.
void SphericalPatch::mark_longest_borders() {
  const auto square = [this](uint32_t k) {
    const Vec3 start = to_double(sphere_.point(links_[k].point));
    const Vec3 chord = to_double(sphere_.point(links_[links_[k].next].point)) - start;
    return dot(chord, chord);
  };
  double most = 0.0;
  for (uint32_t k = 0; k < samples_.size(); ++k) most = square(k) > most ? square(k) : most;
  for (uint32_t k = 0; k < samples_.size(); ++k) links_[k].coarse = square(k) > 0.25 * most;
}

// Says of every triangle which face it belongs to. Octahedron corners that are covered but on the left of a border's
// chord are removed. If that is impossible, borders are too coarse.
bool SphericalPatch::name_triangles() {
  if (!name_faces()) return false;
  // Only the octahedron's points may be covered there: other points keep off borders.
  uint32_t covered[SphereTriangulation::octahedron_points];
  uint32_t count = 0;
  for (uint32_t p = 0; p < SphereTriangulation::octahedron_points; ++p) {
    const bool is_inside = sample_at_[p] == no_id && parts_[sphere_.triangle_at(p)].face != no_id;
    if (is_inside && is_covered(to_double(sphere_.point(p)))) covered[count++] = p;
  }
  if (count == 0) return true;
  for (uint32_t k = 0; k < count; ++k) {
    if (sphere_.remove(covered[k])) continue;
    mark_longest_borders();
    return false;
  }
  sphere_.restore_all();
  return name_faces();
}

// V - E + T = 2 - loops for every face, where E = (3 T + B) / 2 and V = I + B, with B vertices and edges on its border
// and I vertices inside: 2 I + B - T = 2 (2 - loops). Ears are triangles, too.
bool SphericalPatch::has_right_numbers() {
  const uint32_t faces = loops_.size() == 0 ? 1 : loops_[loops_.size() - 1].face + 1;
  for (uint32_t face = 0; face < faces; ++face) balance_[face] = -4;
  for (uint32_t loop = 0; loop < loops_.size(); ++loop) balance_[loops_[loop].face] += 2;
  for (uint32_t k = 0; k < samples_.size(); ++k) balance_[links_[k].face] += is_extra(k) ? 2 : 1;
  for (uint32_t k = 0; k < ears_.size(); ++k) --balance_[ears_[k].face];
  Span<uint32_t> face_of_point = queue_;
  for (uint32_t p = 0; p < sphere_.point_count(); ++p) face_of_point[p] = no_id;
  for (uint32_t t = 0; t < sphere_.triangle_count(); ++t) {
    const uint32_t face = parts_[t].face;
    if (face == no_id) continue;
    --balance_[face];
    for (uint32_t c = 0; c < 3; ++c) {
      if (parts_[t].middle[c] != no_id) --balance_[face];
      const uint32_t p = sphere_.triangle(t).point[c];
      if (sample_at_[p] == no_id) {
        if (face_of_point[p] == no_id) balance_[face] += 2;
        face_of_point[p] = face;
      } else if (parts_[t].corner[c] == no_id) {
        return false;
      }
    }
  }
  for (uint32_t face = 0; face < faces; ++face) {
    if (balance_[face] != 0) return false;
  }
  return true;
}

}  // namespace hsp
