// Nested boxes in one array. Each box is followed by the boxes in it, or by the caps that it lists.
//
// As an example a cube that is halved, and two of its parts: the first lists caps 3 and 8, the other one cap 5.
//     word   0               6              14
//          | cube, ends at 21 | part, lists 2 | 3 8 | part, lists 1 | 5 |
// A search for a plane that misses a box goes on where the box ends.
#include "sphere/cap_boxes.hpp"

namespace hsp {
namespace {

// False if a box certainly has no point of the sphere.
bool touches_sphere(const CellBox &box) {
  constexpr double doubt = 0x1p-40;
  double nearest = 0.0, farthest = 0.0;
  const double centre[3] = {box.x, box.y, box.z};
  for (const double part : centre) {
    const double along = std::fabs(part), inner = along > box.half ? along - box.half : 0.0;
    nearest += inner * inner;
    farthest += (along + box.half) * (along + box.half);
  }
  return nearest <= 1.0 + doubt && farthest >= 1.0 - doubt;
}

}  // namespace

// The centre of a box, in units from the corner of the cube, and half of its side.
struct CapBoxes::Box {
  uint32_t x, y, z, half;

  static constexpr uint32_t words = 6;  // with its end and the number of caps that it lists

  // One of the eight parts that halving its three sides gives.
  Box part(uint32_t number) const {
    const uint32_t quarter = half / 2;
    const auto moved = [&](uint32_t centre, uint32_t bit) {
      return (number >> bit & 1U) != 0 ? centre + quarter : centre - quarter;
    };
    return {moved(x, 0), moved(y, 1), moved(z, 2), quarter};
  }

  CellBox in_space() const {
    const auto place = [](uint32_t units) { return (static_cast<double>(units) - all_units) * unit; };
    return {place(x), place(y), place(z), half * unit};
  }
};

struct CapBoxes::Found {
  Span<const uint32_t> caps;
  bool may_be_free;  // otherwise the caps cover all of the sphere in the box
};

// The caps that matter in a box. above: the caps that matter in a box around it.
CapBoxes::Found CapBoxes::find_in(const Caps &caps, const CellBox &box, Span<const uint32_t> above) {
  CellCutting cutting(caps, CellCutting::Part::sphere, false, state_, box);
  const auto left_of = [&](Span<const uint32_t> numbers) {
    cutting.drop(numbers);
    uint32_t left = 0;
    for (const uint32_t k : numbers) {
      if (state_[k] != CapState::dropped) near_[left++] = k;
    }
    return near_.part(0, left);
  };
  for (const uint32_t k : above) state_[k] = CapState::waits;
  Span<const uint32_t> near = left_of(above);
  for (double least_depth = 0.125; near.size() > most_listed_ && least_depth > 0x1p-13; least_depth *= 0.125) {
    if (!cutting.cut_by(near, least_depth * box.half)) return {near_.part(0, cutting.covering(near_)), false};
    near = left_of(near);
  }
  return {near, true};
}

void CapBoxes::write(uint32_t at, const Box &box, uint32_t end, uint32_t listed) const {
  const uint32_t words[Box::words] = {box.x, box.y, box.z, box.half, end, listed};
  for (uint32_t k = 0; k < Box::words; ++k) boxes_[at + k] = words[k];
}

// Writes a box, its parts, and theirs, one after the other. The caps of the boxes that are being halved are a stack,
// which grows down from the end of the memory. False if there is no room, or if it takes too long: planes that hardly
// differ are together even in the smallest boxes.
bool CapBoxes::halve(const Caps &caps, const Box &whole) {
  constexpr uint32_t parts = 8, most_tried = 384;  // for each cap
  struct Halved {
    Box box;
    uint32_t at;            // where it is written
    uint32_t above, count;  // where its caps are
    uint32_t part;          // the next part
  };
  Halved halved[most_halvings];
  uint32_t depth = 0, first_above = boxes_.size() - caps.count;
  for (uint32_t k = 0; k < caps.count; ++k) boxes_[first_above + k] = k;
  halved[0] = {whole, 0, first_above, caps.count, 0};
  end_ = Box::words;
  for (;;) {
    Halved &now = halved[depth];
    if (now.part == parts) {
      write(now.at, now.box, end_, 0);
      if (depth-- == 0) return true;
      first_above = halved[depth].above;
      continue;
    }
    const Box box = now.box.part(now.part++);
    const CellBox place = box.in_space();
    if (!touches_sphere(place)) continue;
    tried_ += now.count;
    if (tried_ > uint64_t{most_tried} * caps.count) return false;
    const Found found = find_in(caps, place, boxes_.part(now.above, now.above + now.count));
    const uint32_t count = found.caps.size();
    if (count == 0) continue;
    const bool is_halved = found.may_be_free && count > most_listed_ && depth + 1 < most_halvings;
    // A part with nearly all caps of its box uses the list of the box.
    const bool has_own = !is_halved || 4 * uint64_t{count} < 3 * uint64_t{now.count};
    if (first_above - end_ < Box::words + (has_own ? count : 0)) return false;
    const uint32_t first = end_ + Box::words;
    const uint32_t to = !is_halved ? first : has_own ? first_above - count : now.above;
    for (uint32_t k = 0; k < count && has_own; ++k) boxes_[to + k] = found.caps[k];
    if (is_halved) {
      halved[++depth] = {box, end_, to, has_own ? count : now.count, 0};
      first_above = to;
      end_ = first;
    } else {
      write(end_, box, first + count, count);
      end_ = first + count;
    }
  }
}

bool CapBoxes::start(const Caps &caps) {
  const uint32_t count = caps.count, words = count / 32 + 1, states = count / 4 + 1;
  near_ = memory_.part(0, count);
  marks_ = memory_.part(count, count + words);
  state_ = {reinterpret_cast<uint8_t *>(memory_.data() + count + words), count};
  boxes_ = memory_.part(count + words + states, memory_.size());
  for (uint32_t &word : marks_) word = 0;
  tried_ = 0;
  const Box whole{all_units, all_units, all_units, all_units};
  for (most_listed_ = fewest_listed; most_listed_ < count; most_listed_ *= 2) {
    if (halve(caps, whole)) return true;
  }
  end_ = 0;
  return false;
}

Span<const uint32_t> CapBoxes::around(const Caps &caps, uint32_t j) {
  // More than the errors of u and b.
  constexpr double doubt = 0x1p-40;
  uint32_t found = 0;
  if (end_ == 0) {
    for (; found < caps.count; ++found) near_[found] = found;
    return near_;
  }
  const double x = caps.ux[j], y = caps.uy[j], z = caps.uz[j], b = caps.b[j] + all_units * unit * (x + y + z);
  const double across = std::fabs(x) + std::fabs(y) + std::fabs(z);
  const auto mark = [&](uint32_t k) { marks_[k / 32] |= 1U << k % 32; };
  mark(j);
  for (uint32_t at = 0; at < end_;) {
    const uint32_t *const box = &boxes_[at];
    const double depth = unit * (x * box[0] + y * box[1] + z * box[2]) - b;
    if (std::fabs(depth) > unit * box[3] * across + doubt) {
      at = box[4];
      continue;
    }
    const uint32_t first = at + Box::words;
    at = first + box[5];
    for (const uint32_t k : boxes_.part(first, at)) mark(k);
  }
  for (uint32_t word = 0; word < marks_.size(); ++word) {
    for (uint32_t bits = marks_[word]; bits != 0; bits &= bits - 1) {
      near_[found++] = 32 * word + static_cast<uint32_t>(__builtin_ctz(bits));
    }
    marks_[word] = 0;
  }
  return near_.part(0, found);
}

}  // namespace hsp
