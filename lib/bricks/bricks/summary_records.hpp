// The rest of a brick, or of several, when their balls are gone: sums of what is complete; open pieces of shells and
// open components; and seams, by which these join what other bricks have. The records are those of the block of bytes,
// field by field.
#pragma once

#include <compare>

#include "bricks/exact_sums.hpp"
#include "bricks/little_endian.hpp"
#include "core/status.hpp"

namespace hsp {

// A part of a shell: faces of owned balls that are joined over arcs, circles and vertices of owned balls alone.
struct ShellPiece {
  uint32_t component = no_id;
  uint64_t faces = 0, loops = 0;
  uint64_t corners = 0;  // of faces: three of them make a vertex, two an arc
  AreaSum area{};
  AreaSum normal[3]{};                                                                              // vector area N
  VolumeSum radial{};                                                                               // sum of r A
  VolumeSum moment{};                                                                               // sum of c . N
  int64_t low[3] = {INT64_MAX, INT64_MAX, INT64_MAX}, high[3] = {INT64_MIN, INT64_MIN, INT64_MIN};  // of these balls

  template <class Io, class Piece>
  static constexpr void visit(Io &io, Piece &p) {
    io(p.component), io(p.faces), io(p.loops), io(p.corners), io(p.area);
    for (auto &n : p.normal) io(n);
    io(p.radial), io(p.moment);
    for (auto &c : p.low) io(c);
    for (auto &c : p.high) io(c);
  }
  void widen(const int64_t *from, const int64_t *to) {
    for (uint32_t k = 0; k < 3; ++k) {
      if (from[k] < low[k]) low[k] = from[k];
      if (to[k] > high[k]) high[k] = to[k];
    }
  }
  void add(const ShellPiece &other) {
    faces += other.faces;
    loops += other.loops;
    corners += other.corners;
    area = area + other.area;
    for (uint32_t k = 0; k < 3; ++k) normal[k] = normal[k] + other.normal[k];
    radial = radial + other.radial;
    moment = moment + other.moment;
    widen(other.low, other.high);
  }
  // Six times the Euler characteristic, of all faces of a shell: V - E + sum of (2 - loops), with corners as above.
  uint64_t six_euler() const { return 12 * faces - 6 * loops - corners; }
  // Three times the volume enclosed, in quanta times steps; negative for a void. Computed about the lowest corner of
  // the box, which is near, so that the rounding of N does no harm.
  VolumeSum thrice_volume() const {
    VolumeSum sum = radial + moment;
    for (uint32_t k = 0; k < 3; ++k) sum = sum - times(normal[k], low[k]);
    return sum;
  }
};

// The place of a ball in the order of the symbolic perturbation, among all balls of the whole (exact/rank.hpp).
struct GlobalRank {
  int64_t x = 0, y = 0, z = 0, r = 0;
  uint64_t id = 0;

  auto operator<=>(const GlobalRank &) const = default;
};

// A part of a component: balls that are joined through balls that the brick knows.
struct ComponentPart {
  uint64_t balls = 0;  // owned ones
  uint64_t voids = 0;  // its shells that are complete and cannot be the outer one
  uint64_t lowest_id = ~uint64_t{0};
  // The ball that reaches highest, and the piece with its highest point; no_id if that ball is not owned.
  uint32_t top_piece = no_id;
  int64_t height = 0;
  GlobalRank top{};

  template <class Io, class Part>
  static constexpr void visit(Io &io, Part &p) {
    io(p.balls), io(p.voids), io(p.lowest_id), io(p.top_piece), io(p.height);
    io(p.top.x), io(p.top.y), io(p.top.z), io(p.top.r), io(p.top.id);
  }
  void add(const ComponentPart &other) {
    balls += other.balls;
    voids += other.voids;
    if (other.lowest_id < lowest_id) lowest_id = other.lowest_id;
    if (other.top_piece == no_id) return;
    const bool is_higher = height != other.height ? height < other.height : other.top < top;
    if (top_piece != no_id && !is_higher) return;
    top_piece = other.top_piece;
    height = other.height;
    top = other.top;
  }
};

// A seam, at which bricks a < b join. Both bricks find the same name for it. A seam between pieces of shells is a curve
// on which balls of a meet balls of b. It is named by its lowest vertex: three ids and the sign; or by a free circle:
// two ids and sign 0. A seam between parts of components is named by the lowest id among balls that are linked by pairs
// that meet, one of a and one of b.
struct SeamName {
  uint32_t a = 0, b = 0;
  uint64_t id[3] = {0, 0, 0};
  int32_t sign = 0;

  auto operator<=>(const SeamName &) const = default;
};
struct Seam : SeamName {
  uint32_t label = 0;  // the number of the piece or component
};
struct ShellSeam : Seam {
  template <class Io, class Seam>
  static constexpr void visit(Io &io, Seam &s) {
    io(s.a), io(s.b);
    for (auto &each : s.id) io(each);
    io(s.sign), io(s.label);
  }
};
struct ComponentSeam : Seam {
  template <class Io, class Seam>
  static constexpr void visit(Io &io, Seam &s) {
    io(s.a), io(s.b), io(s.id[0]), io(s.label);
  }
};

// Sums over balls, and over shells and components that are complete.
struct SummaryTotals {
  uint64_t balls = 0, exposed = 0, contained = 0;
  uint64_t faces = 0, loops = 0, corners = 0, half_circles = 0, tied_corners = 0;
  uint64_t shells = 0, components = 0, voids = 0, six_euler = 0;
  AreaSum area{};             // of balls
  VolumeSum thrice_volume{};  // of shells: of the union
  VolumeSum thrice_voids{};   // of the space that shells of voids enclose

  // Each field of one or more totals.
  template <class Io, class... Totals>
  static constexpr void visit(Io &io, Totals &...t) {
    io(t.balls...), io(t.exposed...), io(t.contained...), io(t.faces...), io(t.loops...), io(t.corners...);
    io(t.half_circles...), io(t.tied_corners...), io(t.shells...), io(t.components...), io(t.voids...);
    io(t.six_euler...), io(t.area...), io(t.thrice_volume...), io(t.thrice_voids...);
  }
  void add_shell(const ShellPiece &shell, bool is_void) {
    const VolumeSum volume = shell.thrice_volume();
    ++shells;
    voids += is_void;
    six_euler += shell.six_euler();
    thrice_volume = thrice_volume + volume;
    if (is_void) thrice_voids = thrice_voids - volume;
  }
  void add(const SummaryTotals &more) {
    const auto add_field = [](auto &sum, const auto &term) { sum = sum + term; };
    visit(add_field, *this, more);
  }
};

}  // namespace hsp
