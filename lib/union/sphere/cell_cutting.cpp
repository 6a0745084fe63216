// Cuts a polyhedron by caps, a batch at a time.
//
// As an example the cube around the unit sphere and the caps
//   A   x >= 0.5     goes 0.625 deep: it cuts first
//   B   x >= 0.9     misses what A leaves, and is dropped
//   C   y >= 1.0     goes 0.125 deep: it waits if deeper planes are asked for first, and cuts later
//   D   x >= 0.5     A once more: its plane is too near four vertices for doubles, and integers decide
#include "sphere/cell_cutting.hpp"

namespace hsp {
namespace {

// Among the caps with these bits, the one whose plane cuts deepest. If it comes first, few planes cut.
uint32_t deepest_of(const CapBatch &batch, uint32_t bits) {
  uint32_t deepest = static_cast<uint32_t>(__builtin_ctz(bits));
  for (bits &= bits - 1; bits != 0; bits &= bits - 1) {
    const uint32_t k = static_cast<uint32_t>(__builtin_ctz(bits));
    deepest = batch.depth[k] > batch.depth[deepest] ? k : deepest;
  }
  return deepest;
}

}  // namespace

bool CellCutting::cut_by(Span<const uint32_t> numbers, double least_depth) {
  CapBatch batch{};
  for (uint32_t t = 0; t < numbers.size();) {
    if (!load(numbers.part(t, numbers.size()), batch)) {
      state_[numbers[t++]] = stays;
      continue;
    }
    for (uint32_t k = 0; k < batch.count; ++k) state_[numbers[t + k]] = dropped;
    for (uint32_t bits = may_cut(batch, batch.all()); bits != 0;) {
      const uint32_t k = deepest_of(batch, bits), number = numbers[t + k];
      if (batch.depth[k] < least_depth) {
        some_wait_ = true;
        for (; bits != 0; bits &= bits - 1) state_[numbers[t + static_cast<uint32_t>(__builtin_ctz(bits))]] = waits;
        break;
      }
      bits &= ~(1U << k);
      switch (cell_.cut(caps_.target, plane_of(batch, k, number))) {
        case OuterCell::Cut::misses:
          break;
        case OuterCell::Cut::buries:
          buried_by_ = number;
          return false;
        case OuterCell::Cut::unsure:
          state_[number] = near_vertex;
          break;
        case OuterCell::Cut::full:
          lacks_room_ = true;
          [[fallthrough]];
        case OuterCell::Cut::refused:
          state_[number] = stays;
          break;
        case OuterCell::Cut::cuts:
          if (leaves_nothing()) return false;
          state_[number] = has_cut;
          if (bits != 0) bits = may_cut(batch, bits);
          break;
      }
    }
    t += batch.count;
  }
  return true;
}

bool CellCutting::cut_anew(Span<uint32_t> numbers) {
  constexpr uint32_t few = 8, part = 8;
  cell_.start();
  lacks_room_ = false;
  bool goes_deep = true;
  uint32_t most = numbers.size() - numbers.size() / part;
  for (uint32_t tried = 1; !numbers.empty() && !lacks_room_; ++tried) {
    numbers = keep_deepest_first(numbers, goes_deep);
    if (!goes_deep) break;
    if (tried % few == 0) {
      if (numbers.size() > most) break;
      most = numbers.size() - numbers.size() / part;
    }
    if (!cut_by(numbers.part(0, 1), 0.0)) return false;
    numbers = numbers.part(1, numbers.size());
  }
  return true;
}

uint32_t CellCutting::covering(Span<uint32_t> numbers) const {
  uint32_t found = 0;
  if (buried_by_ != no_id) numbers[found++] = buried_by_;
  for (uint64_t left = cell_.faces; left != 0; left &= left - 1) {
    const uint32_t cap = cell_.cap[__builtin_ctzll(left)];
    if (cap != no_id) numbers[found++] = cap;
  }
  return found;
}

void CellCutting::drop(Span<const uint32_t> numbers) {
  CapBatch batch{};
  for (uint32_t t = 0; t < numbers.size();) {
    if (!load(numbers.part(t, numbers.size()), batch)) {
      ++t;
      continue;
    }
    const uint32_t bits = may_cut(batch, batch.all());
    for (uint32_t k = 0; k < batch.count; ++k) {
      if ((bits >> k & 1U) == 0) state_[numbers[t + k]] = dropped;
    }
    t += batch.count;
  }
}

bool CellCutting::cut_by_integers(Span<uint32_t> numbers, const CellTies &ties) {
  constexpr uint32_t most_deep = 32;
  bool some_go_deep = true;
  for (uint32_t t = 0, together = 1; t < numbers.size();) {
    if (some_go_deep && t < most_deep) {
      const uint32_t left = keep_deepest_first(numbers.part(t, numbers.size()), some_go_deep).size();
      numbers = numbers.part(0, t + left);
      if (left == 0) break;
    }
    Sides found;
    const uint32_t end = together < numbers.size() - t ? t + together : numbers.size();
    const uint32_t asked = find_sides(numbers.part(t, end), ties, found);
    together = together < Sides::most ? 2 * together : together;
    uint32_t k = 0;
    while (k < asked) {
      const uint32_t number = numbers[t + k];
      const OuterCell::Cut cut = cell_.cut(plane_of(number), found.sides[k].outside);
      ++k;
      if (cut == OuterCell::Cut::buries) return false;
      if (cut != OuterCell::Cut::cuts) continue;
      state_[number] = has_cut;
      if (leaves_nothing()) return false;
      together = 1;
      break;
    }
    t += asked > 0 ? k : 1;
  }
  return true;
}

void CellCutting::drop_by_integers(Span<uint32_t> numbers, const CellTies &ties, TiedSets &sets) {
  uint32_t others = 0;
  for (const uint32_t number : numbers) {
    if (state_[number] == dropped || is_face(number)) continue;
    state_[number] = stays;
    numbers[others++] = number;
  }
  for (uint32_t t = 0; t < others;) {
    Sides found;
    const uint32_t asked = find_sides(numbers.part(t, others), ties, found);
    for (uint32_t k = 0; k < asked; ++k) {
      if ((found.sides[k].outside[0] | found.sides[k].outside[1]) != 0) continue;
      const VertexBits &on_plane = found.on_plane[k];
      const uint32_t set = on_plane.empty() ? TiedSets::most : sets.number_of(on_plane);
      if (set < TiedSets::most) {
        state_[numbers[t + k]] = static_cast<uint8_t>(tied + set);
      } else if (on_plane.empty()) {
        state_[numbers[t + k]] = dropped;
      }
    }
    t += asked > 0 ? asked : 1;
  }
}

OuterCell::Plane CellCutting::plane_of(uint32_t number) const {
  CapBatch batch{};
  load({&number, 1}, batch);
  return plane_of(batch, 0, number);
}

bool CellCutting::is_face(uint32_t number) const {
  for (uint64_t left = cell_.faces; left != 0; left &= left - 1) {
    if (cell_.cap[__builtin_ctzll(left)] == number) return true;
  }
  return false;
}

bool CellCutting::takes_nothing(const OuterCell::Plane &plane) const {
  const OuterCell::Taken taken = cell_.part_taken(plane);
  return taken == OuterCell::Taken::point_outside_sphere ||
         (taken == OuterCell::Taken::point_inside_sphere && part_ == Part::sphere);
}

uint32_t CellCutting::find_sides(Span<const uint32_t> numbers, const CellTies &ties, Sides &found) {
  const uint32_t count = find_certain_sides(numbers, found);
  ties.decide(cell_, numbers.part(0, count), found.sides, found.on_plane);
  return count;
}

uint32_t CellCutting::find_certain_sides(Span<const uint32_t> numbers, Sides &found) const {
  CapBatch batch{};
  if (!load(numbers.part(0, numbers.size() < Sides::most ? numbers.size() : Sides::most), batch)) return 0;
  for (uint32_t k = 0; k < batch.count; ++k) {
    const OuterCell::Plane plane = plane_of(batch, k, numbers[k]);
    found.sides[k] = takes_nothing(plane) ? VertexSides{} : sides_of_vertices(caps_.target, cell_, plane);
  }
  return batch.count;
}

Span<uint32_t> CellCutting::keep_deepest_first(Span<uint32_t> numbers, bool &goes_deep) {
  CapBatch batch{};
  constexpr double least = 0x1p-20;
  double most = least;
  uint32_t left = 0, deepest = 0;
  for (uint32_t t = 0; t < numbers.size();) {
    if (!load(numbers.part(t, numbers.size()), batch)) {
      numbers[left++] = numbers[t++];
      continue;
    }
    const uint32_t bits = may_cut(batch, batch.all());
    for (uint32_t k = 0; k < batch.count; ++k) {
      const uint32_t number = numbers[t + k];
      if ((bits >> k & 1U) == 0) {
        state_[number] = dropped;
        continue;
      }
      if (batch.depth[k] > most) {
        most = batch.depth[k];
        deepest = left;
      }
      numbers[left++] = number;
    }
    t += batch.count;
  }
  goes_deep = most > least;
  const uint32_t number = numbers[deepest];
  numbers[deepest] = numbers[0];
  numbers[0] = number;
  return numbers.part(0, left);
}

uint32_t CellCutting::may_cut(CapBatch &batch, uint32_t asked) const {
  return caps_that_may_cut(caps_.target, cell_, batch, asked);
}

bool CellCutting::load(Span<const uint32_t> numbers, CapBatch &batch) const {
  batch.count = numbers.size() < CapBatch::most ? numbers.size() : CapBatch::most;
  if (balls_alone_) {
    const CapArrays to{batch.ux, batch.uy, batch.uz, batch.b, nullptr};
    batch.count = caps_.make_doubles_of(numbers.part(0, batch.count), to);
    return batch.count > 0;
  }
  for (uint32_t k = 0; k < batch.count; ++k) {
    const uint32_t from = numbers[k];
    batch.ux[k] = caps_.ux[from];
    batch.uy[k] = caps_.uy[from];
    batch.uz[k] = caps_.uz[from];
    batch.b[k] = caps_.b[from];
  }
  return true;
}

}  // namespace hsp
