#include "sphere/caps.hpp"

namespace hsp {

void Caps::carve(Workspace &workspace, uint32_t capacity) {
  const uint64_t one_more = static_cast<uint64_t>(capacity) + 1;
  ux = workspace.take<double>(one_more);
  uy = workspace.take<double>(one_more);
  uz = workspace.take<double>(one_more);
  b = workspace.take<double>(one_more);
  plane = workspace.take<exact::Plane>(one_more);
  ball = workspace.take<uint32_t>(one_more);
}

void Caps::gather(const BallSet &balls, const CubeBlock &block, uint32_t i, DisjointSets *components) {
  const exact::LatticeBall own = balls.ball(i);
  const double x = balls.x[i];
  const double y = balls.y[i];
  const double z = balls.z[i];
  const double radius = balls.r[i];
  const double inverse_diameter = 0.5 / radius;  // infinite for radius 0, whose caps are decided by the planes alone
  origin = i;
  sphere = exact::sphere_of(own);
  length_squared = static_cast<double>(sphere.W);
  count = 0;
  first_later = 0;
  met = 0;
  contained = false;
  // Of two balls that meet, one is earlier in rank; the representative of a component is its ball of lowest rank.
  const auto by_rank = [&balls](uint32_t p, uint32_t q) { return exact::ranks_before(balls.ball(p), balls.ball(q)); };

  const double *const xs = balls.x.data();
  const double *const ys = balls.y.data();
  const double *const zs = balls.z.data();
  const double *const rs = balls.r.data();
  for (uint32_t k = 0; k < block.ranges; ++k) {
    const BallRange range = block.range[k];
    for (uint32_t j = range.first; j < range.last; ++j) {
      // The differences and the sum are exact, the squares have a relative error below 4e: a certainly
      // disjoint pair stops here.
      const double dx = xs[j] - x;
      const double dy = ys[j] - y;
      const double dz = zs[j] - z;
      const double s = rs[j] + radius;
      const double squared = dx * dx + dy * dy + dz * dz;
      if (squared > s * s * (1.0 + 8 * unit_roundoff)) continue;
      if (j == i) continue;
      const exact::LatticeBall other = balls.ball(j);
      // Likewise a certainly proper circle needs no integers.
      const double difference = rs[j] - radius;
      const bool certainly_circle =
          squared < s * s * (1.0 - 8 * unit_roundoff) && squared > difference * difference * (1.0 + 8 * unit_roundoff);
      const exact::PairRelation relation =
          certainly_circle ? exact::PairRelation::circle : exact::pair_relation(own, other);
      if (relation == exact::PairRelation::disjoint) continue;
      if (components != nullptr && (j > i || relation == exact::PairRelation::first_in_second)) {
        components->join(i, j, by_rank);
      }
      if (relation == exact::PairRelation::first_in_second) {
        contained = true;
        count = 0;
        return;
      }
      ++met;
      if (relation == exact::PairRelation::second_in_first || overflowed()) continue;
      const exact::Plane cap = exact::plane_of(own, other);
      const double U = static_cast<double>(dot(cap.v, cap.v));
      const double inverse = 1.0 / std::sqrt(U);
      if (U > length_squared) length_squared = U;
      if (j < i) first_later = count + 1;
      plane[count] = cap;
      ball[count] = j;
      ux[count] = dx * inverse;
      uy[count] = dy * inverse;
      uz[count] = dz * inverse;
      b[count] = static_cast<double>(cap.h) * inverse * inverse_diameter;
      ++count;
    }
  }
}

void Caps::set_spare_great_circle(const exact::Vector &normal) {
  const double inverse = 1.0 / std::sqrt(static_cast<double>(dot(normal, normal)));
  ux[count] = static_cast<double>(normal.x) * inverse;
  uy[count] = static_cast<double>(normal.y) * inverse;
  uz[count] = static_cast<double>(normal.z) * inverse;
  b[count] = 0.0;
}

void Caps::add_half_sphere(const exact::Vector &normal) {
  set_spare_great_circle(normal);
  plane[count] = exact::virtual_plane(normal, 0);
  plane[count].index = no_id;
  ball[count] = no_id;
  const double U = static_cast<double>(dot(normal, normal));
  if (U > length_squared) length_squared = U;
  ++count;
}

uint32_t Caps::cap_of(uint32_t other) const {
  uint32_t low = 0;
  uint32_t high = count;
  while (high - low > 1) {
    const uint32_t middle = low + (high - low) / 2;
    if (ball[middle] <= other) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

}  // namespace hsp
