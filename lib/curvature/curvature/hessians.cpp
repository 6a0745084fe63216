#include "curvature/hessians.hpp"

#include "lanes/wide.hpp"

namespace hsp {

namespace {

// A sum of products left right^T of two vectors. Of each row two entries are in one register, and the third by itself.
class ProductSum {
 public:
  void add(double factor, const Vec3 &left, const Vec3 &right) {
    const Pair xy{right.x, right.y};
    const double rows[3] = {factor * left.x, factor * left.y, factor * left.z};
    for (uint32_t k = 0; k < 3; ++k) {
      xy_[k] += rows[k] * xy;
      z_[k] += rows[k] * right.z;
    }
  }
  void add_to_diagonal(double value) {
    xy_[0] += Pair{value, nothing};
    xy_[1] += Pair{nothing, value};
    z_[2] += value;
  }
  HessianBlock times(double factor) const {
    HessianBlock block;
    for (uint32_t k = 0; k < 3; ++k) {
      const Pair xy = factor * xy_[k];
      block.entry[3 * k] = xy[0];
      block.entry[3 * k + 1] = xy[1];
      block.entry[3 * k + 2] = factor * z_[k];
    }
    return block;
  }

 private:
  using Pair = Wide<double, 2>::Real;
  static constexpr double nothing = -0.0;  // changes no sum; +0 would change the sign of a sum that is -0

  Pair xy_[3] = {};
  double z_[3] = {};
};

}  // namespace

bool VertexRates::find(const BallSet &balls, const AreaWeights &weights, uint32_t ball, const ArcBatch &batch) {
  const double own = weights.of(balls, ball) * balls.r[ball];
  const auto less_growth_of = [&](uint32_t s) {
    return own - weights.of(balls, batch.other[s]) * batch.other_radius[s];
  };
  const auto centre_of = [&](uint32_t s) { return Vec3{batch.vx[s], batch.vy[s], batch.vz[s]}; };
  bool all = true;
  // A slot without an arc may have the vertex at the end of the arc before it.
  for (uint32_t s = 0; s < batch.count; ++s) {
    Vec3 rate{0.0, 0.0, 0.0};
    if (batch.root_discriminant[s] == 0.0) {
      all = all && batch.arc[s] == 0;
    } else {
      const uint32_t t = batch.previous[s];
      const Vec3 v = centre_of(s), w = centre_of(t);
      const Vec3 x{0.5 * batch.px[s], 0.5 * batch.py[s], 0.5 * batch.pz[s]};
      const Vec3 sum = combine(own, cross(v, w), less_growth_of(s), cross(w, x));
      rate = (-2.0 / batch.root_discriminant[s]) * combine(1.0, sum, less_growth_of(t), cross(x, v));
    }
    x_[s] = rate.x;
    y_[s] = rate.y;
    z_[s] = rate.z;
  }
  return all;
}

HessianArcs::HessianArcs(const BallSet &balls, const Boundary &boundary, const EnergyTerms &terms, uint32_t ball)
    : balls_(balls),
      terms_(terms),
      ball_(ball),
      pressure_(balls.lattice.length(terms.pressure)),
      growth_(growth(ball)),
      arcs_(balls, boundary, ball) {}

bool HessianArcs::next_batch() {
  if (!arcs_.next()) return false;
  const ArcBatch &batch = arcs_.batch();
  if (terms_.tension != 0.0 && !rates_.find(balls_, terms_.weights, ball_, batch)) flags_ |= singular_flag;
  count_ = batch.count;
  slot_ = 0;
  return true;
}

bool HessianArcs::next() {
  if (count_ > 0) ++slot_;
  while (slot_ < count_ || next_batch()) {
    const ArcBatch &batch = arcs_.batch();
    for (; slot_ < count_; ++slot_) {
      if (!batch.has_piece(slot_)) continue;
      const Touching touching = batch.any_touching ? batch.touching[slot_] : Touching::no;
      if (touching != Touching::no) flags_ |= one_sided_flag;
      if (counts(touching, terms_.weights.touching_balls)) return true;
    }
  }
  return false;
}

HessianBlock HessianArcs::block() const {
  const ArcBatch &batch = arcs_.batch();
  const uint32_t s = slot_;
  const double R = balls_.r[ball_], h = 0.5 * batch.twice_height[s];
  const double inverse_distance = batch.inverse_distance[s], angle = batch.angle[s];
  const double below = h - 1.0 / inverse_distance;  // -h_j
  const Vec3 u{batch.ux[s], batch.uy[s], batch.uz[s]};
  const auto end = [&](uint32_t t) {
    return Vec3{0.5 * batch.px[t] - h * u.x, 0.5 * batch.py[t] - h * u.y, 0.5 * batch.pz[t] - h * u.z};
  };
  const bool has_ends = batch.arc[s] != 0 && (!batch.any_touching || batch.touching[s] == Touching::no);
  const Vec3 p = has_ends ? end(batch.next[s]) : Vec3{0.0, 0.0, 0.0}, q = has_ends ? end(s) : Vec3{0.0, 0.0, 0.0};
  // A divisor, so it is computed from an end of the arc: for a small circle on a large ball R - h has hardly a digit.
  const double square_of_radius = has_ends ? dot(q, q) : (R - h) * (R + h);

  // The sum is along u u^T + first u X^T + second X u^T + across (1 - u u^T) + ends (X Y^T - (u x X)(u x Y)^T).
  double along = pressure_ * h * below * angle, across = 0.5 * pressure_ * square_of_radius * angle;
  double first = pressure_ * h, second = pressure_ * below, ends = 0.25 * pressure_;
  double plane_speed = 0.0, radius_growth = 0.0;  // h' and Q
  if (terms_.tension != 0.0) {
    plane_speed = (growth_ - growth(batch.other[s])) * inverse_distance;
    radius_growth = growth_ - h * plane_speed;
    along += terms_.tension * plane_speed * (h + below) * angle;
    across += terms_.tension * radius_growth * angle;
  }
  ProductSum sum;
  Vec3 X{0.0, 0.0, 0.0};
  if (has_ends) {
    X = {0.5 * batch.Xx[s], 0.5 * batch.Xy[s], 0.5 * batch.Xz[s]};
    if (terms_.tension != 0.0) {
      const double rate = radius_growth / square_of_radius, scale = terms_.tension / square_of_radius;
      first += terms_.tension * (plane_speed + rate * h);
      second += terms_.tension * (plane_speed + rate * below);
      ends += 0.5 * terms_.tension * rate;
      const auto add_end = [&](const Vec3 &e, uint32_t t, double sign) {
        const double turning = sign * scale * dot(cross(u, e), rates_.at(t));
        sum.add(turning, combine(h, u, 1.0, e), combine(below, u, 1.0, e));
      };
      add_end(q, s, 1.0);
      add_end(p, batch.next[s], -1.0);
    }
    const Vec3 Y = combine(1.0, p, 1.0, q);
    sum.add(ends, X, Y);
    sum.add(-ends, cross(u, X), cross(u, Y));
    sum.add(second, X, u);
  }
  sum.add(1.0, u, combine(along - across, u, first, X));
  sum.add_to_diagonal(across);
  return sum.times(-inverse_distance);
}

}  // namespace hsp
