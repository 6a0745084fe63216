#include "sphere/exposed_caps.hpp"

#include "sphere/outer_cell.hpp"

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

}  // namespace

// Equal balls follow each other, as the grid has them: of these all but the outermost are dropped. Copies of a plane
// that cuts would stay in doubt. b: equal for equal balls.
template <class Real>
void ExposedCaps::drop_equal(const Caps &caps, const Real *b) {
  const BallSet &balls = caps.balls();
  uint32_t outer = 0;
  for (uint32_t k = 0; k < caps.count; ++k) {
    state_[k] = waits;
    if (k == 0 || b[k] != b[outer]) {
      outer = k;
    } else if (lies_inside(balls, caps.ball[k], caps.ball[outer])) {
      state_[k] = dropped;
    } else {
      if (lies_inside(balls, caps.ball[outer], caps.ball[k])) state_[outer] = dropped;
      outer = k;
    }
  }
}

// The largest caps come first: after few of them most balls are known to be buried.
template <class Real>
Span<const uint32_t> ExposedCaps::order_by_size(const Real *b, uint32_t count) {
  constexpr uint32_t classes = 64;
  uint32_t start[classes + 1] = {};
  for (uint32_t k = 0; k < count; ++k) {
    if (state_[k] == dropped) continue;
    const uint32_t size = size_class(b[k], classes);
    state_[k] = static_cast<uint8_t>(size + 1);  // not that of one that is dropped
    ++start[size + 1];
  }
  for (uint32_t c = 0; c < classes; ++c) start[c + 1] += start[c];
  for (uint32_t k = 0; k < count; ++k) {
    if (state_[k] != dropped) order_[start[state_[k] - 1]++] = k;
  }
  return order_.part(0, start[classes - 1]);
}

// The polyhedron of one ball, and its caps some at a time.
class ExposedCaps::Cutting {
 public:
  Cutting(const Caps &caps, Part part, bool balls_alone, Span<uint8_t> state)
      : caps_(caps), part_(part), balls_alone_(balls_alone), state_(state) {
    cell_.start();
  }

  // Cuts by those whose planes go deeper than that; the others wait. False if nothing is left.
  bool cut_by(Span<const uint32_t> numbers, double least_depth) {
    for (uint32_t t = 0; t < numbers.size();) {
      if (!load(numbers.part(t, numbers.size()))) {
        state_[numbers[t++]] = doubtful;
        continue;
      }
      for (uint32_t k = 0; k < batch_.count; ++k) state_[numbers[t + k]] = dropped;
      for (uint32_t bits = may_cut(batch_.all()); bits != 0;) {
        const uint32_t k = deepest_of(batch_, bits), number = numbers[t + k];
        if (batch_.depth[k] < least_depth) {
          for (; bits != 0; bits &= bits - 1) state_[numbers[t + static_cast<uint32_t>(__builtin_ctz(bits))]] = waits;
          break;
        }
        bits &= ~(1U << k);
        switch (cell_.cut(caps_.target, {batch_.ux[k], batch_.uy[k], batch_.uz[k], batch_.b[k]})) {
          case OuterCell::Cut::misses:
            break;
          case OuterCell::Cut::buries:
            return false;
          case OuterCell::Cut::doubtful:
            state_[number] = doubtful;
            break;
          case OuterCell::Cut::cuts:
            if (part_ == Part::sphere && cell_.lies_inside_sphere()) return false;
            state_[number] = has_cut;
            if (bits != 0) bits = may_cut(bits);
            break;
        }
      }
      t += batch_.count;
    }
    return true;
  }

  // Drops those that miss what is left. Faces do not: their planes go through vertices.
  void drop(Span<const uint32_t> numbers) {
    for (uint32_t t = 0; t < numbers.size();) {
      if (!load(numbers.part(t, numbers.size()))) {
        ++t;
        continue;
      }
      const uint32_t bits = may_cut(batch_.all());
      for (uint32_t k = 0; k < batch_.count; ++k) {
        if ((bits >> k & 1U) == 0) state_[numbers[t + k]] = dropped;
      }
      t += batch_.count;
    }
  }

 private:
  uint32_t may_cut(uint32_t asked) { return caps_that_may_cut(caps_.target, cell_, batch_, asked); }

  // The first ones, a whole batch if there are as many. False if the first is not certain to be a circle.
  bool load(Span<const uint32_t> numbers) {
    batch_.count = numbers.size() < CapBatch::most ? numbers.size() : CapBatch::most;
    if (balls_alone_) {
      const CapArrays to{batch_.ux, batch_.uy, batch_.uz, batch_.b, nullptr};
      batch_.count = caps_.make_doubles_of(numbers.part(0, batch_.count), to);
      return batch_.count > 0;
    }
    for (uint32_t k = 0; k < batch_.count; ++k) {
      const uint32_t from = numbers[k];
      batch_.ux[k] = caps_.ux[from];
      batch_.uy[k] = caps_.uy[from];
      batch_.uz[k] = caps_.uz[from];
      batch_.b[k] = caps_.b[from];
    }
    return true;
  }

  const Caps &caps_;
  Part part_;
  bool balls_alone_;
  Span<uint8_t> state_;
  OuterCell cell_;
  CapBatch batch_{};
};

// Of all caps those in some states, in their order.
template <class Chosen>
Span<const uint32_t> ExposedCaps::in_state(uint32_t count, Chosen chosen) {
  uint32_t found = 0;
  for (uint32_t k = 0; k < count; ++k) {
    if (chosen(state_[k])) order_[found++] = k;
  }
  return order_.part(0, found);
}

bool ExposedCaps::find(Part part, const Caps &caps, const float *sizes) {
  // Where planes nearly agree, as of copies of one ball, the deepest of all is to cut, not one after the other.
  constexpr double deep = 0x1p-5;
  const uint32_t count = caps.count;
  const auto order = [&](const auto *b) {
    drop_equal(caps, b);
    return order_by_size(b, count);
  };
  const Span<const uint32_t> in_order = sizes != nullptr ? order(sizes) : order(caps.b.data());
  Cutting cutting(caps, part, sizes != nullptr, state_);
  if (!cutting.cut_by(in_order, deep)) return false;
  if (!cutting.cut_by(in_state(count, [](uint8_t state) { return state == waits; }), 0.0)) return false;
  cutting.drop(in_state(count, [](uint8_t state) { return state == has_cut || state == doubtful; }));
  return true;
}

bool ExposedCaps::keep(Part part, Caps &caps) {
  if (are_many(caps)) {
    if (!find(part, caps)) return false;
  } else if (!small_code && caps.met > caps.count) {
    // Where the ball has another one inside, as of copies of a set each has, others may be there several times.
    drop_equal(caps, caps.b.data());
  } else {
    return true;
  }
  caps.keep_numbers([this](uint32_t k) { return has(k); });
  return true;
}

}  // namespace hsp
