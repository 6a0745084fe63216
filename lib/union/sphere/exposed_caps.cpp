// Caps that may touch what is free, of a ball that has hundreds of them.
//
// As an example the unit sphere and the caps
//   A   x >= 0.5                     60 degrees around x
//   B   x >= 0.9                     26 degrees around x: inside A, hence discarded
//   C   0.6 x + 0.8 y >= 0.95        18 degrees around a direction 53 degrees from x: up to 71 degrees from x, out of
//                                    A, so that it stays
// Copies of A are dropped but one. Most discarded caps are inside one that is much larger: large ones are tried first.
#include "sphere/exposed_caps.hpp"

#include <cstring>

namespace hsp {
namespace {

// The one of those whose plane cuts deepest: few planes cut then.
uint32_t deepest_of(const CapBatch &batch, uint32_t bits) {
  uint32_t deepest = static_cast<uint32_t>(__builtin_ctz(bits));
  for (bits &= bits - 1; bits != 0; bits &= bits - 1) {
    const uint32_t k = static_cast<uint32_t>(__builtin_ctz(bits));
    deepest = batch.depth[k] > batch.depth[deepest] ? k : deepest;
  }
  return deepest;
}

// Equal balls follow each other, as the grid has them: of these all but the outermost are dropped. Copies of a plane
// that cuts would stay in doubt. numbers: ascending. Returns those that are left.
Span<const uint32_t> without_copies(const Caps &caps, Span<uint32_t> numbers) {
  const BallSet &balls = caps.balls();
  uint32_t left = 0;
  for (const uint32_t k : numbers) {
    const uint32_t ball = caps.ball[k], last = left > 0 ? caps.ball[numbers[left - 1]] : ball;
    if (balls.x[last] == balls.x[ball]) {
      if (lies_inside(balls, ball, last)) continue;
      if (lies_inside(balls, last, ball)) --left;
    }
    numbers[left++] = k;
  }
  return numbers.part(0, left);
}

}  // namespace

// Every so many-th cap, the largest first: after few of them most balls are known to be buried.
template <class Real>
Span<const uint32_t> ExposedCaps::order_by_size(const Real *b, uint32_t count, uint32_t step) {
  constexpr uint32_t classes = 64;
  uint32_t start[classes + 1] = {};
  Real least = b[0], most = b[0];
  for (uint32_t k = 0; k < count; k += step) {
    least = b[k] < least ? b[k] : least;
    most = b[k] > most ? b[k] : most;
  }
  const Real scale = classes / (most - least);
  std::memset(state_.data(), not_tried, count);
  for (uint32_t k = 0; k < count; k += step) {
    // The last class has the smallest, and NaN where all are of one size.
    const Real scaled = (b[k] - least) * scale;
    const uint32_t size = scaled < classes ? static_cast<uint32_t>(scaled) : classes - 1;
    state_[k] = static_cast<uint8_t>(not_tried + size);
    ++start[size + 1];
  }
  for (uint32_t c = 0; c < classes; ++c) start[c + 1] += start[c];
  for (uint32_t k = 0; k < count; k += step) order_[start[state_[k] - not_tried]++] = k;
  return order_.part(0, start[classes - 1]);
}

// The polyhedron of one ball, and its caps some at a time.
class ExposedCaps::Cutting {
 public:
  Cutting(const Caps &caps, Part part, bool balls_alone, Span<uint8_t> state)
      : caps_(caps), part_(part), balls_alone_(balls_alone), state_(state) {
    cell_.start();
  }

  // Cuts by those whose planes go deeper than that; the others wait. False if nothing is left. Out of line, as all that
  // has a batch: integers take the stack beside them.
  [[gnu::noinline]] bool cut_by(Span<const uint32_t> numbers, double least_depth) {
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
            return false;
          case OuterCell::Cut::unsure:
            state_[number] = near_vertex;
            break;
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

  // Drops those that miss what is left. Faces do not: their planes go through vertices.
  [[gnu::noinline]] void drop(Span<const uint32_t> numbers) {
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

  // Cuts by caps whose planes are near vertices, by integers. False if nothing is left. Those that go deep come first:
  // where planes have a line in common two of them leave the others nearly nothing, which in another order may cut one
  // after the other, until there is no room. Many are asked about together, but few behind one that cuts, since the
  // next may, too.
  bool cut_by_integers(Span<uint32_t> numbers, const CellTies &ties) {
    constexpr uint32_t most_deep = 32;
    bool some_go_deep = true;
    for (uint32_t t = 0, together = 1; t < numbers.size();) {
      some_go_deep = some_go_deep && t < most_deep && put_deepest_first(numbers.part(t, numbers.size()));
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

  // Drops those of them that miss what is left, but for the planes that go through vertices.
  void drop_by_integers(Span<uint32_t> numbers, const CellTies &ties, TiedSets &sets) {
    uint32_t others = 0;
    for (const uint32_t number : numbers) {
      if (is_face(number)) continue;
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

  const OuterCell &cell() const { return cell_; }
  bool some_wait() const { return some_wait_; }

 private:
  static OuterCell::Plane plane_of(const CapBatch &batch, uint32_t k, uint32_t number) {
    return {batch.ux[k], batch.uy[k], batch.uz[k], batch.b[k], number};
  }
  [[gnu::noinline]] OuterCell::Plane plane_of(uint32_t number) const {
    CapBatch batch{};
    load({&number, 1}, batch);
    return plane_of(batch, 0, number);
  }

  bool leaves_nothing() const { return part_ == Part::sphere && cell_.lies_inside_sphere(); }

  bool is_face(uint32_t number) const {
    for (uint64_t left = cell_.faces; left != 0; left &= left - 1) {
      if (cell_.cap[__builtin_ctzll(left)] == number) return true;
    }
    return false;
  }

  // Where all planes go through one point that is not on the sphere, integers would be asked about it again and again.
  bool takes_nothing(const OuterCell::Plane &plane) const {
    const OuterCell::Taken taken = cell_.part_taken(plane);
    return taken == OuterCell::Taken::point_outside_sphere ||
           (taken == OuterCell::Taken::point_inside_sphere && part_ == Part::sphere);
  }

  struct Sides {
    static constexpr uint32_t most = 16;
    VertexSides sides[most];
    VertexBits on_plane[most];
  };
  // Of the first ones, as many as there is room for: of how many. 0 if the first is not certain to be a circle.
  uint32_t find_sides(Span<const uint32_t> numbers, const CellTies &ties, Sides &found) {
    const uint32_t count = find_certain_sides(numbers, found);
    ties.decide(cell_, numbers.part(0, count), found.sides, found.on_plane);
    return count;
  }
  [[gnu::noinline]] uint32_t find_certain_sides(Span<const uint32_t> numbers, Sides &found) const {
    CapBatch batch{};
    if (!load(numbers.part(0, numbers.size() < Sides::most ? numbers.size() : Sides::most), batch)) return 0;
    for (uint32_t k = 0; k < batch.count; ++k) {
      const OuterCell::Plane plane = plane_of(batch, k, numbers[k]);
      found.sides[k] = takes_nothing(plane) ? VertexSides{} : sides_of_vertices(caps_.target, cell_, plane);
    }
    return batch.count;
  }

  // Puts the one whose plane goes deepest to the front. False if none goes deeper than doubles can tell.
  [[gnu::noinline]] bool put_deepest_first(Span<uint32_t> numbers) const {
    CapBatch batch{};
    double most = 0x1p-20;
    uint32_t deepest = no_id;
    for (uint32_t t = 0; t < numbers.size(); t += batch.count) {
      if (!load(numbers.part(t, numbers.size()), batch)) return false;
      const uint32_t bits = may_cut(batch, batch.all());
      if (bits == 0) continue;
      const uint32_t k = deepest_of(batch, bits);
      if (batch.depth[k] > most) {
        most = batch.depth[k];
        deepest = t + k;
      }
    }
    if (deepest == no_id) return false;
    const uint32_t number = numbers[deepest];
    numbers[deepest] = numbers[0];
    numbers[0] = number;
    return true;
  }

  uint32_t may_cut(CapBatch &batch, uint32_t asked) const {
    return caps_that_may_cut(caps_.target, cell_, batch, asked);
  }

  // The first ones, a whole batch if there are as many. False if the first is not certain to be a circle.
  bool load(Span<const uint32_t> numbers, CapBatch &batch) const {
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

  const Caps &caps_;
  Part part_;
  bool balls_alone_;
  Span<uint8_t> state_;
  OuterCell cell_;
  bool some_wait_ = false;
};

// Caps in these states, in their order.
Span<uint32_t> ExposedCaps::in_states(uint32_t count, uint8_t first, uint8_t last) {
  uint32_t found = 0;
  for (uint32_t k = 0; k < count; ++k) {
    uint64_t eight = 0;
    if (count - k >= sizeof eight) {
      std::memcpy(&eight, &state_[k], sizeof eight);
      if ((eight & UINT64_C(0x8080808080808080)) == 0) {
        k += sizeof eight - 1;
        continue;
      }
    }
    if (state_[k] >= first && state_[k] <= last) order_[found++] = k;
  }
  return order_.part(0, found);
}

// Of the planes that go through one set of vertices one stays, so that ties are seen. It is none of a ball inside
// another one that stays, which may not count as a tie.
void ExposedCaps::keep_planes_of_ties(const Caps &caps, TiedSets &sets) {
  const Span<const uint32_t> others = in_states(caps.count, has_cut, near_vertex);
  for (uint32_t k = 0; k < caps.count; ++k) {
    if (state_[k] < tied) continue;
    const uint32_t set = state_[k] - tied;
    bool drops = sets.is_kept(set);
    for (uint32_t n = 0; n < others.size() && !drops; ++n) {
      drops = lies_inside(caps.balls(), caps.ball[k], caps.ball[others[n]]);
    }
    state_[k] = drops ? dropped : stays;
    if (!drops) sets.keep(set);
  }
}

bool ExposedCaps::find(Part part, const Caps &caps, const FloatCaps *floats) {
  // Where planes nearly agree, as of copies of one ball, the deepest of all is to cut, not one after the other.
  constexpr double deep = 0x1p-5;
  const uint32_t count = caps.count;
  Cutting cutting(caps, part, floats != nullptr, state_);
  if (floats == nullptr) {
    if (!cutting.cut_by(order_by_size(caps.b.data(), count, 1), deep)) return false;
  } else {
    // The largest ones of some first; then floats tell which of the others are worth their doubles: few, once the
    // deepest have cut.
    constexpr uint32_t first = 2 * CapBatch::most, sample = 8 * CapBatch::most;
    const Span<const uint32_t> largest = order_by_size(floats->b, count, count / sample + 1);
    if (!cutting.cut_by(largest.part(0, largest.size() < first ? largest.size() : first), deep)) return false;
    uint32_t near = 0, deepest = 0;
    for (uint32_t cuts = 0; cuts < 4; ++cuts) {
      near = float_caps_that_may_cut(caps.target, cutting.cell(), *floats, count, order_.data(), deepest);
      if (near <= first || is_tried(deepest)) break;
      if (!cutting.cut_by({&deepest, 1}, 0.0)) return false;
    }
    uint32_t left = 0;
    for (const uint32_t k : order_.part(0, near)) {
      order_[left] = k;
      left += is_tried(k) ? 0U : 1U;
    }
    if (!cutting.cut_by(without_copies(caps, order_.part(0, left)), deep)) return false;
  }
  if (cutting.some_wait() && !cutting.cut_by(in_states(count, waits, waits), 0.0)) return false;
  cutting.drop(in_states(count, has_cut, near_vertex));
  const Span<uint32_t> near = in_states(count, near_vertex, near_vertex);
  if (near.size() >= fewest_ties) {
    const CellTies ties(caps);
    TiedSets sets;
    if (!cutting.cut_by_integers(near, ties)) return false;
    cutting.drop_by_integers(near, ties, sets);
    keep_planes_of_ties(caps, sets);
  }
  kept_ = without_copies(caps, in_states(count, has_cut, near_vertex)).size();
  return true;
}

bool ExposedCaps::keep(Part part, Caps &caps, uint32_t many) {
  if (small_code) return true;
  // Where the ball has another one inside, as of copies of a set each has, others may be there several times.
  if (caps.met > caps.count) {
    for (uint32_t k = 0; k < caps.count; ++k) order_[k] = k;
    caps.keep(without_copies(caps, order_.part(0, caps.count)));
  }
  if (caps.count < many) return true;
  if (!find(part, caps)) return false;
  caps.keep(kept());
  return true;
}

}  // namespace hsp
