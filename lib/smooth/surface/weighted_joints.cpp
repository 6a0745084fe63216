#include "surface/weighted_joints.hpp"

#include "core/extremes.hpp"
#include "sphere/arc_geometry.hpp"
#include "surface/saddle_kernel.hpp"
#include "surface/surface_areas.hpp"
#include "surface/surface_positions.hpp"
#include "surface/vertex_contacts.hpp"

namespace hsp {
namespace {

using JointKernel = SaddleKernel<1>;
using Profile = JointKernel::Profile;

JointKernel::Real lane(double x) {
  return JointKernel::L::all(x);
}

// The circle of two balls, and the profiles of the probe on it.
struct SaddleCircle {
  double probe, radius, half_way, height, other_height, distance, ball_radius, other_ball_radius;

  // Computed on the ball of lower rank, so that both balls have the same bits.
  SaddleCircle(const BallSet &balls, uint32_t a, uint32_t b)
      : probe(static_cast<double>(balls.probe_steps)), ball_radius(balls.r[a]), other_ball_radius(balls.r[b]) {
    const Vec3 between = balls.difference(a, b);
    distance = std::sqrt(dot(between, between));
    const bool in_order = balls.ranks_before(a, b);
    const CircleGeometry circle(balls, in_order ? a : b, in_order ? b : a);
    radius = circle.radius;
    // Most circles are larger than the probe for certain.
    half_way = probe < (1.0 - 0x1p-40) * radius ? 0.0 : half_way_between_cusps(balls, a, b);
    height = in_order ? circle.height : distance - circle.height;
    other_height = in_order ? distance - circle.height : circle.height;
  }
  // The profile seen from a, with a factor each for the parts at a and b.
  Profile weighted(double weight, double other_weight) const {
    const auto part = [this](double own_height, double own_radius, double opposite_height, double opposite_radius) {
      return Profile(lane(probe), lane(radius), lane(half_way), lane(own_height), lane(own_radius),
                     lane(opposite_height), lane(opposite_radius));
    };
    return {weight, part(height, ball_radius, other_height, other_ball_radius), other_weight,
            part(other_height, other_ball_radius, height, ball_radius)};
  }
};

// The side between the saddle of balls a and b and a concave patch. Its conormal speed, times the difference of the
// weights and integrated along the side, is linear in the speeds of the vertex and of the centres: the factors for the
// vertex and for a's centre.
struct SideSpeed {
  double of_vertex = 0.0, of_centre = 0.0;

  SideSpeed() = default;
  // For any arc in a plane through the circle's axis, from its integrals of 1, cosine and sine.
  SideSpeed(const SaddleCircle &circle, double T, double S, double Q) {
    if (!(circle.radius > 0.0)) return;
    const double p = circle.probe;
    of_vertex = p * (T - p * S / circle.radius);
    of_centre = p * p * (circle.other_height * S - circle.radius * Q) / (circle.radius * circle.distance);
  }
};
SideSpeed speed_of_side(const BallSet &balls, uint32_t a, uint32_t b, double weight, double other_weight) {
  if (weight == 0.0 && other_weight == 0.0) return {};
  const SaddleCircle circle(balls, a, b);
  const Profile profile = circle.weighted(weight, other_weight);
  return {circle, profile.T[0], profile.S[0], profile.Q[0]};
}

}  // namespace

// The mean of the weights of a vertex's balls: exactly the weight if all are equal, and independent of the balls'
// order.
double WeightedJoints::weight_of_vertex(uint32_t vertex) const {
  const VertexRecord &record = boundary_.vertex(vertex);
  const double a = weight_of(record.ball[0]), b = weight_of(record.ball[1]), c = weight_of(record.ball[2]);
  const double least = smaller_of(smaller_of(a, b), c);
  return least + ((a - least) + (b - least) + (c - least)) / 3;
}

void WeightedJoints::add_saddles(const ArcBatch &batch, const SaddlePatches &saddles) {
  const SaddleCircles &circles = saddles.circles();
  for (uint32_t s = 0; s < batch.count; ++s) {
    const double other_weight = weight_of(batch.other[s]);
    if (other_weight == weight_ || !batch.has_piece(s) || !(circles.radius[s] > 0.0)) continue;
    const JointKernel::Slot slot(batch, circles, saddles.rolled(), s);
    const Profile other = slot.other_profile();
    JointKernel::DerivativeSums part;
    part.add(slot, Profile(0.0, other, other_weight - weight_, other));
    sums_.centre = sums_.centre + Vec3{part.area.a[0], part.area.b[0], part.area.c[0]};
    sums_.radius += part.area.d[0];
    sums_.offset += part.area_offset[0];
    if (!(circles.half_way[s] > 0.0)) add_waist(batch, s, circles.radius[s], weight_ - other_weight);
  }
}

// For a circle without cusps. If its plane lies beyond one ball's centre, the whole saddle is the other ball's, up to
// the border of the convex patch of that one ball. This changes abruptly when the plane passes through the centre, so
// it is decided in integers, alike for both balls.
void WeightedJoints::add_waist(const ArcBatch &batch, uint32_t s, double rho, double difference) {
  const double height = 0.5 * batch.twice_height[s];
  const double other_height = 1.0 / batch.inverse_distance[s] - height;
  const double per_distance = difference * batch.inverse_distance[s];
  const double angle = batch.angle[s];
  const double R = balls_.r[ball_];
  const double other_R = balls_.r[batch.other[s]];
  const Vec3 u{batch.ux[s], batch.uy[s], batch.uz[s]};
  const Vec3 rho_I = 0.5 * Vec3{batch.Xx[s], batch.Xy[s], batch.Xz[s]};
  const exact::LatticeBall own = balls_.ball(ball_), opposite = balls_.ball(batch.other[s]);
  const int64_t own_h = exact::plane_of(own, opposite).h, other_h = exact::plane_of(opposite, own).h;
  sums_.one_sided = sums_.one_sided || (p_ > 0.0 && (own_h == 0 || other_h == 0));
  if (own_h >= 0 && other_h >= 0) {
    const double waist = per_distance * (rho - p_);
    sums_.centre = sums_.centre + combine(waist * angle * height, u, waist * (1.0 - p_ / rho), rho_I);
    sums_.radius += waist * angle * R;
  } else if (other_h < 0) {
    const double shrinkage = shrinkage_of_faces(balls_, batch.other[s]);
    const double ring = per_distance * shrinkage * shrinkage * other_R;
    sums_.centre = sums_.centre + combine(ring * height * angle, u, ring, rho_I);
    sums_.radius += ring * angle * R;
  } else {
    const double shrinkage = shrinkage_of_faces(balls_, ball_);
    const double inclined = per_distance * shrinkage * shrinkage * (rho * rho - height * other_height);
    const double along = -difference * shrinkage * (1.0 - shrinkage) * rho / R;
    sums_.centre = sums_.centre + combine(along * height / rho, rho_I, -along * rho * angle, u);
    sums_.centre = sums_.centre + combine(inclined / R, rho_I, inclined * height * angle / R, u);
    sums_.radius += inclined * angle;
  }
}

// For creases between patches of different weights: the integrals that multiply the speed of the vertex, in addition to
// those for equal weights. On a crease with the axis a towards the vertex across, at the height c, the conormals n and
// n' of the two sides are (a - c w)/s and (-a - c w')/s: half the sum of the two weights belongs to n + n', half their
// difference to n - n' = 2 s a.
Vec3 WeightedJoints::crease_part(uint32_t vertex, const Vec3 &offset, double mean) {
  Vec3 sum{0.0, 0.0, 0.0};
  const CutPatches &cut = surface_.cut_patches();
  if (!cut.is_cut(vertex)) return sum;
  for (const uint32_t a : cut.arcs_of_vertex(vertex)) {
    const PatchArc &arc = cut.arc(a);
    if (arc.is_side()) continue;
    const double half_difference = 0.5 * (mean - weight_of_vertex(arc.across));
    if (half_difference == 0.0) continue;
    const VertexCrease found = crease_on_probe({balls_, boundary_, surface_}, a);
    const SphereArc &crease = found.arc;
    const double c = crease.height;
    const Vec3 radial = cross(crease.chord, crease.axis);
    if (found.is_certain && turn_crease(vertex, arc.across, crease, offset, half_difference, sum)) {
      sum = combine(1.0, sum, p_ * half_difference * c, combine(c * crease.angle, crease.axis, 1.0, radial));
      continue;
    }
    sums_.one_sided = sums_.one_sided || !found.is_certain;
    sum = combine(1.0, sum, p_ * half_difference, combine(crease.angle, crease.axis, c > 0.0 ? 1.0 / c : 0.0, radial));
  }
  return sum;
}

// The part of the weights' difference on a crease between two vertices of one circle. The crease's plane turns with the
// circle's axis, like that of a side, and contains the middle of the two vertices (PROOFS.md, section 9). False if they
// are not on one circle, or if their middle is nearer to the axis than to the vertices: then their distance is the more
// precise measure.
bool WeightedJoints::turn_crease(uint32_t vertex, uint32_t across, const SphereArc &crease, const Vec3 &offset,
                                 double half_difference, Vec3 &by_vertex) {
  uint32_t ball[2];
  if (!find_common_circle(boundary_, vertex, across, ball)) return false;
  const uint32_t own = ball_ == ball[1] ? ball[1] : ball[0];
  const uint32_t other = own == ball[1] ? ball[0] : ball[1];
  SaddleCircle circle(balls_, own, other);
  const double aside = p_ * crease.height;
  const double middle = (circle.radius - aside) * (circle.radius + aside);
  if (!(middle > aside * aside)) return false;
  circle.radius = std::sqrt(middle);
  const Vec3 along = (1.0 / circle.distance) * balls_.difference(own, other);
  const Vec3 radial = cross(crease.axis, along);
  const bool is_outward = dot(offset - balls_.difference(ball_, own), radial) > 0.0;
  const double weight = half_difference * (1.0 - crease.height) * (1.0 + crease.height);
  const Vec3 directions = weight * cross(crease.chord, crease.axis);
  const double inward = is_outward ? -dot(directions, radial) : dot(directions, radial);
  const SideSpeed speed(circle, weight * crease.angle, inward, dot(directions, along));
  if (ball_ == own) sums_.centre = combine(1.0, sums_.centre, speed.of_centre, crease.axis);
  by_vertex = combine(1.0, by_vertex, speed.of_vertex, crease.axis);
  return true;
}

// A function of its own, so that its temporaries are not on the stack of computations without weights.
[[gnu::noinline]] void WeightedJoints::add_vertex(uint32_t vertex, const Vec3 &offset, const Vec3 &equal_weights) {
  const double mean = weight_of_vertex(vertex);
  add_sides(vertex, offset, mean, combine(mean - weight_, equal_weights, 1.0, crease_part(vertex, offset, mean)));
}

// by_vertex: the other factors of the vertex's speed. A function of its own, so that its temporaries are not on the
// stack while creases are computed.
[[gnu::noinline]] void WeightedJoints::add_sides(uint32_t vertex, const Vec3 &offset, double mean, Vec3 by_vertex) {
  // With a small determinant the vertex moves so far that rounding is visible in what each ball gets. That error is
  // large for one ball, but not for the sum over the three, if all three use the same sums and normals.
  constexpr double most_inverse = 0x1p9;
  VertexContacts contacts(balls_, boundary_, vertex, ball_, offset);
  if (contacts.inverse > most_inverse) contacts.see_as_all(balls_, position_of_vertex(balls_, boundary_, vertex));
  // Side k faces ball k. Its conormal out of the saddle points towards that ball, at right angles to the plane through
  // the other two balls' centres and the vertex.
  Vec3 part[3];
  for (uint32_t k = 0; k < 3; ++k) {
    const uint32_t a = k == 0 ? 1 : 0;
    const uint32_t b = k == 2 ? 1 : 2;
    const SideSpeed speed = speed_of_side(balls_, contacts.ball[a], contacts.ball[b],
                                          weight_of(contacts.ball[a]) - mean, weight_of(contacts.ball[b]) - mean);
    const Vec3 normal = cross(contacts.normal[a], contacts.normal[b]);
    const double sine = std::sqrt(dot(normal, normal));
    const double scale = sine > 0.0 ? (k == 1 ? contacts.sign : -contacts.sign) / sine : 0.0;
    part[k] = scale * speed.of_vertex * normal;
    if (k != 0) sums_.centre = combine(1.0, sums_.centre, scale * speed.of_centre, normal);
  }
  for (uint32_t slot = 0; slot < 3; ++slot) by_vertex = by_vertex + part[(slot + 3 - contacts.slot) % 3];
  const double z = dot(by_vertex, contacts.share);
  sums_.centre = combine(1.0, sums_.centre, z, contacts.normal[0]);
  sums_.radius += z;
}

}  // namespace hsp
