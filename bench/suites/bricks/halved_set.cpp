#include "halved_set.hpp"

#include <algorithm>
#include <cmath>

namespace bench {

HalvedSet::HalvedSet(const Balls &balls, double probe) {
  constexpr double steps = 1e8;  // of the lattice in an Angstrom
  const auto n = static_cast<uint32_t>(balls.radius.size());
  size_t longest = 0;
  double extent = -1;
  std::vector<double> cut;  // the places along that axis, in their order
  for (size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> place(n);
    for (uint32_t i = 0; i < n; ++i) place[i] = balls.xyz[3 * size_t{i} + axis];
    std::sort(place.begin(), place.end());
    if (place.back() - place.front() <= extent) continue;
    extent = place.back() - place.front();
    longest = axis;
    cut = place;
  }
  const double middle = cut[n / 2];
  for (const double radius : balls.radius)
    largest_radius_ = std::max(largest_radius_, std::nearbyint((radius + probe) * steps));
  for (uint32_t i = 0; i < n; ++i) {
    const double *const at = &balls.xyz[3 * size_t{i}];
    const uint32_t owner = at[longest] < middle ? 0 : 1;
    double centre[3];
    for (size_t k = 0; k < 3; ++k) centre[k] = std::nearbyint(at[k] * steps);
    const double radius = std::nearbyint((balls.radius[i] + probe) * steps);
    owned_ += owner == 0 ? 1 : 0;
    for (uint32_t half = 0; half < 2; ++half) {
      const bool near = std::abs(at[longest] - middle) * steps <= 2 * largest_radius_ + 1;
      if (owner == half || near) half_[half].push(centre, radius, i, owner);
    }
  }
  maker_.compute(half_[1], largest_radius_);
  summary_[1] = maker_.summarise(half_[1], 1, 2, 0);
  compute_first();
  summarise_first();
  merge();
}

void HalvedSet::merge() {
  support::need(support::merge(summary_[0], summary_[1], whole_), "hsp_brick_merge");
}

}  // namespace bench
