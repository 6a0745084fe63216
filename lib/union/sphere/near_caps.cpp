#include "sphere/near_caps.hpp"

#include "core/rows.hpp"
#include "core/sorting.hpp"

namespace hsp {
namespace {

// More than the errors of b and of distances: 16 and 40 units of 2^-53 in their squares.
constexpr double slack = 0x1p-40;

// No less than the chord of a cap's angle: its square is 2 - 2 b.
float reach_of(double b) {
  const double squared = 2.0 - 2.0 * b + slack;
  return static_cast<float>(std::sqrt(squared > slack ? squared : slack)) * (1.0F + 0x1p-20F);
}

}  // namespace

uint32_t NearCaps::square_of(double coordinate) const {
  const double square = (coordinate + 1.0) * per_length_;
  if (!(square > 0.0)) return 0;
  return square < squares_ ? static_cast<uint32_t>(square) : squares_ - 1;
}

// Chooses farthest_, a power of two that the reaches of few caps exceed, and sorts the others into squares.
void NearCaps::start(const Caps &caps) {
  constexpr uint32_t sizes = 24, most_far = 64;
  const uint32_t count = caps.count;
  uint32_t of_size[sizes] = {};
  const auto size_of = [](float reach) {  // 2^(1 - size) is no less than the reach
    uint32_t size = 0;
    for (float half = 1.0F; size + 1 < sizes && reach <= half; half *= 0.5F) ++size;
    return size;
  };
  for (uint32_t k = 0; k < count; ++k) {
    memory_.reach[k] = reach_of(caps.b[k]);
    ++of_size[size_of(memory_.reach[k])];
  }
  uint32_t size = 0;
  for (uint32_t far = of_size[0]; far <= most_far && size + 1 < sizes; far += of_size[size]) ++size;
  farthest_ = 2.0;
  for (uint32_t k = 0; k < size; ++k) farthest_ *= 0.5;
  // Fewer squares than caps.
  squares_ = 1;
  while ((squares_ + 1) * (squares_ + 1) < count && (squares_ + 1) * farthest_ <= 2.0) ++squares_;
  per_length_ = 0.5 * squares_;
  const uint32_t all_squares = squares_ * squares_;
  const auto is_far = [&](uint32_t k) { return static_cast<double>(memory_.reach[k]) > farthest_; };
  const auto square_of_cap = [&](uint32_t k) { return square_of(caps.uy[k]) * squares_ + square_of(caps.ux[k]); };
  placed_ = sort_to_rows(
      memory_.square_first, all_squares, count, [&](uint32_t k) { return is_far(k) ? all_squares : square_of_cap(k); },
      [&](uint32_t position, uint32_t k) { memory_.in_square[position] = k; });
  uint32_t far = placed_;
  for (uint32_t k = 0; k < count; ++k) {
    if (is_far(k)) memory_.in_square[far++] = k;
  }
}

Span<const uint32_t> NearCaps::around(const Caps &caps, uint32_t j) const {
  const double x = caps.ux[j], y = caps.uy[j], z = caps.uz[j], reach = static_cast<double>(memory_.reach[j]);
  uint32_t found = 0;
  const auto add_those = [&](uint32_t first, uint32_t last) {
    for (const uint32_t k : memory_.in_square.part(first, last)) {
      const double dx = caps.ux[k] - x, dy = caps.uy[k] - y, dz = caps.uz[k] - z;
      const double both = reach + static_cast<double>(memory_.reach[k]);
      if (dx * dx + dy * dy + dz * dz <= both * both + slack) memory_.near[found++] = k;
    }
  };
  const double farthest = reach + farthest_ + slack;
  const uint32_t left = square_of(x - farthest), right = square_of(x + farthest);
  const uint32_t low = square_of(y - farthest), high = square_of(y + farthest);
  for (uint32_t row = low; row <= high; ++row) {
    const uint32_t first = row * squares_ + left, last = row * squares_ + right;
    add_those(memory_.square_first[first], memory_.square_first[last + 1]);
  }
  add_those(placed_, caps.count);
  sort_ascending(memory_.near.part(0, found));
  return memory_.near.part(0, found);
}

}  // namespace hsp
