#include "sphere/meridian_sectors.hpp"

#include "core/extremes.hpp"
#include "core/rows.hpp"

namespace hsp {
namespace {

// A cap that reaches into more sectors is wide.
constexpr uint32_t most_sectors = 16;

// The position of a direction on the half turn from (1, 0) to (-1, 0), from 0 to 2. It grows with the angle but is not
// in proportion to it.
double part_of_turn(double x, double y) {
  if (y < 0.0 || (y == 0.0 && x < 0.0)) {
    x = -x;
    y = -y;
  }
  return x >= 0.0 ? y / (x + y) : 1.0 - x / (y - x);
}

}  // namespace

uint32_t MeridianSectors::sector_of(double x, double y, uint32_t sectors) {
  const double sector = part_of_turn(x, y) * (0.5 * sectors);
  return sector < sectors ? static_cast<uint32_t>(sector) : sectors - 1;
}

// A meridian with the normal n meets a cap with the axis u only if |u.n| is at most the sine of the cap's angle. Seen
// from above, the meridian's direction is then no farther from u than an angle whose sine is the cap's sine, divided by
// the horizontal length of u. The square of the sine is enlarged by more than the error from b, 16 units of 2^-53, and
// the sine by more than all other errors.
MeridianSectors::Reach MeridianSectors::reach_of(const Caps &caps, uint32_t cap, uint32_t sectors) {
  const Reach wide{0, no_id};
  const double x = caps.ux[cap], y = caps.uy[cap], b = caps.b[cap];
  const double squared = 1.0 - b * b + 0x1p-40, across = std::sqrt(x * x + y * y);
  if (!(b > 0.5 && squared > 0.0 && across > 0x1p-10)) return wide;
  const double sine = std::sqrt(squared) / across + 0x1p-30;
  if (!(sine < 0.5)) return wide;
  const double cosine = std::sqrt(1.0 - sine * sine);
  const uint32_t first = sector_of(x * cosine + y * sine, y * cosine - x * sine, sectors);
  const uint32_t last = sector_of(x * cosine - y * sine, y * cosine + x * sine, sectors);
  return {first, (last >= first ? last - first : last + sectors - first) + 1};
}

namespace {

void fill(Span<uint8_t> marks, uint8_t mark) {
  for (uint8_t &each : marks) each = mark;
}

}  // namespace

void MeridianSectors::clear_marks() const {
  fill(marks_, 0);
}

void MeridianSectors::mark(const Caps &caps, uint32_t cap) const {
  const uint32_t all = marks_.size();
  const Reach reach = reach_of(caps, cap, all);
  const uint32_t count = smaller_of(reach.count, all), before_end = smaller_of(count, all - reach.first);
  fill(marks_.part(reach.first, reach.first + before_end), 1);
  fill(marks_.part(0, count - before_end), 1);
}

void MeridianSectors::start(const Caps &caps, const Memory &memory) {
  first_ = memory.first.data();
  listed_ = memory.listed.data();
  const uint32_t count = caps.count;
  // As many sectors as there is room for, with at least as much for the marks behind them.
  const Span<uint32_t> first = memory.first;
  sectors_ = 1;
  while (4 * sectors_ < first.size()) sectors_ *= 2;
  for (;; sectors_ /= 2) {
    for (uint32_t s = 0; s <= sectors_; ++s) first[s] = 0;
    all_ = 0;
    for (uint32_t k = 0; k < count; ++k) {
      const Reach reach = reach_of(caps, k, sectors_);
      all_ += reach.count > most_sectors ? 1 : reach.count;
      for (uint32_t s = 0; s < reach.count && reach.count <= most_sectors; ++s) ++first[(reach.first + s) % sectors_];
    }
    if (all_ <= memory.listed.size()) break;
  }
  marks_ = {reinterpret_cast<uint8_t *>(first_ + sectors_ + 1), 4 * (first.size() - sectors_ - 1)};
  placed_ = end_rows(first, sectors_);
  uint32_t wide = all_;
  for (uint32_t k = count; k-- > 0;) {
    const Reach reach = reach_of(caps, k, sectors_);
    if (reach.count > most_sectors) memory.listed[--wide] = k;
    for (uint32_t s = 0; s < reach.count && reach.count <= most_sectors; ++s) {
      memory.listed[--first[(reach.first + s) % sectors_]] = k;
    }
  }
}

}  // namespace hsp
