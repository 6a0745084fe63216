#include "face_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "disjoint_sets.hpp"

namespace oracle {
namespace {

using Real = long double;

constexpr Real pi = std::numbers::pi_v<Real>;

// Within a slab: the ball, and the ball at whose end the strip's arcs start.
using StripName = std::pair<size_t, size_t>;
using Strips = std::map<StripName, size_t>;  // index of each

// Do two arcs share an interval, as sets of directions?
bool overlap(const FreeSliceArc &a, const FreeSliceArc &b) {
  for (const Real turn : {-2 * pi, Real{0}, 2 * pi})
    if (std::max(a.from, b.from + turn) < std::min(a.to, b.to + turn)) return true;
  return false;
}

class Faces {
 public:
  explicit Faces(const std::vector<RealBall> &balls) : balls_(balls) {}

  void add_slab(const Slab &slab, Real step) {
    Strips strips;
    visit_tanh_sinh_nodes(slab.low, slab.high, step, [&](Real z, Real weight) { add_slice(slab, z, weight, strips); });
    // Close to a height where arcs open or close they change like roots of the distance: here by 1e-4 at most.
    const Real near = 1e-8L * (slab.high - slab.low);
    const std::vector<SliceCircle> bottom = circles_of_slice(balls_, slab.active, slab.low + near);
    for (const SliceCircle &above : bottom)
      for (const SliceCircle &below : top_)
        if (above.ball == below.ball) link(above, strips, below);
    top_ = circles_of_slice(balls_, slab.active, slab.high - near);
    top_strips_ = std::move(strips);
  }

  std::vector<FaceMeasures> joined() {
    std::map<size_t, FaceMeasures> faces;
    DisjointSets sets(strips_.size());
    for (const auto &[a, b] : links_) sets.join(a, b);
    for (size_t s = 0; s < strips_.size(); ++s) {
      FaceMeasures &face = faces[sets.find(s)];
      face.ball = strips_[s].ball;
      face.area += strips_[s].area;
      for (size_t k = 0; k < 3; ++k) face.vector_area[k] += strips_[s].vector_area[k];
    }
    std::vector<FaceMeasures> result;
    // The outermost nodes of a slab can see its ends' structure, by rounding: strips of next to no weight.
    for (const auto &[root, face] : faces)
      if (face.area > 1e-14L * balls_[face.ball].radius * balls_[face.ball].radius) result.push_back(face);
    return result;
  }

 private:
  size_t strip(Strips &strips, size_t ball, const FreeSliceArc &arc) {
    const auto [place, is_new] = strips.try_emplace({ball, arc.after}, strips_.size());
    if (is_new) strips_.push_back({ball, 0, {0, 0, 0}});
    return place->second;
  }

  void add_slice(const Slab &slab, Real z, Real weight, Strips &strips) {
    for (const SliceCircle &circle : circles_of_slice(balls_, slab.active, z)) {
      const RealBall &ball = balls_[circle.ball];
      for (const FreeSliceArc &arc : circle.arcs) {
        FaceMeasures &sum = strips_[strip(strips, circle.ball, arc)];
        sum.area += weight * ball.radius * (arc.to - arc.from);
        sum.vector_area[0] += weight * circle.radius * (std::sin(arc.to) - std::sin(arc.from));
        sum.vector_area[1] += weight * circle.radius * (std::cos(arc.from) - std::cos(arc.to));
        sum.vector_area[2] += weight * (z - ball.z) * (arc.to - arc.from);
      }
    }
  }

  void link(const SliceCircle &above, Strips &strips, const SliceCircle &below) {
    for (const FreeSliceArc &a : above.arcs)
      for (const FreeSliceArc &b : below.arcs)
        if (overlap(a, b)) links_.push_back({strip(strips, above.ball, a), strip(top_strips_, below.ball, b)});
  }

  const std::vector<RealBall> &balls_;
  std::vector<FaceMeasures> strips_;  // the parts of faces within slabs
  std::vector<std::pair<size_t, size_t>> links_;
  std::vector<SliceCircle> top_;  // of the slab before
  Strips top_strips_;
};

}  // namespace

std::vector<FaceMeasures> measure_faces_by_slices(const std::vector<RealBall> &balls, Real step) {
  const std::vector<RealBall> moved = around_their_middle(balls);
  Faces faces(moved);
  for (const Slab &slab : slabs_of(moved)) faces.add_slab(slab, step);
  return faces.joined();
}

}  // namespace oracle
