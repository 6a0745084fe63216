#include "sphere/exposed_caps.hpp"

#include "sphere/outer_cell.hpp"

namespace hsp {
namespace {

// The first caps of some numbers: a whole batch if there are as many, fewer if one is not certain to be a circle.
void load(const Caps &caps, bool balls_alone, Span<const uint32_t> numbers, CapBatch &batch) {
  batch.count = numbers.size() < CapBatch::most ? numbers.size() : CapBatch::most;
  if (balls_alone) {
    batch.count = caps.make_doubles_of(numbers.part(0, batch.count), {batch.ux, batch.uy, batch.uz, batch.b, nullptr});
    return;
  }
  for (uint32_t k = 0; k < batch.count; ++k) {
    const uint32_t from = numbers[k];
    batch.ux[k] = caps.ux[from];
    batch.uy[k] = caps.uy[from];
    batch.uz[k] = caps.uz[from];
    batch.b[k] = caps.b[from];
  }
}

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

// The largest caps come first: after few of them most balls are known to be buried.
template <class Real>
void ExposedCaps::order_by_size(const Real *b, uint32_t count) {
  constexpr uint32_t classes = 64;
  uint32_t start[classes + 1] = {};
  for (uint32_t k = 0; k < count; ++k) {
    state_[k] = static_cast<uint8_t>(size_class(b[k], classes));
    ++start[state_[k] + 1];
  }
  for (uint32_t c = 0; c < classes; ++c) start[c + 1] += start[c];
  for (uint32_t k = 0; k < count; ++k) {
    order_[start[state_[k]]++] = k;
    state_[k] = dropped;
  }
}

bool ExposedCaps::find(const Caps &caps, const float *sizes) {
  const uint32_t count = caps.count;
  const bool balls_alone = sizes != nullptr;
  if (balls_alone) {
    order_by_size(sizes, count);
  } else {
    order_by_size(caps.b.data(), count);
  }
  OuterCell cell;
  cell.start();
  CapBatch batch{};
  for (uint32_t t = 0; t < count; t += batch.count) {
    load(caps, balls_alone, order_.part(t, count), batch);
    if (batch.count == 0) {
      state_[order_[t++]] = doubtful;
      continue;
    }
    for (uint32_t bits = caps_that_may_cut(caps.target, cell, batch, batch.all()); bits != 0;) {
      const uint32_t k = deepest_of(batch, bits), number = order_[t + k];
      bits &= ~(1U << k);
      switch (cell.cut(caps.target, {batch.ux[k], batch.uy[k], batch.uz[k], batch.b[k]}, number)) {
        case OuterCell::Cut::misses:
          break;
        case OuterCell::Cut::buries:
          return false;
        case OuterCell::Cut::doubtful:
          state_[number] = doubtful;
          break;
        case OuterCell::Cut::cuts:
          if (cell.lies_inside_sphere()) return false;
          state_[number] = cuts;
          if (bits != 0) bits = caps_that_may_cut(caps.target, cell, batch, bits);
          break;
      }
    }
  }
  for (uint64_t left = cell.faces; left != 0; left &= left - 1) {
    const uint32_t number = cell.cap[__builtin_ctzll(left)];
    if (number != no_id) state_[number] = face;
  }
  // Those whose face is gone, or has never been there.
  uint32_t asked = 0;
  for (uint32_t k = 0; k < count; ++k) {
    if (state_[k] == cuts || state_[k] == doubtful) order_[asked++] = k;
  }
  for (uint32_t t = 0; t<asked; t += batch.count> 0 ? batch.count : 1) {
    load(caps, balls_alone, order_.part(t, asked), batch);
    const uint32_t bits = caps_that_may_cut(caps.target, cell, batch, batch.all());
    for (uint32_t k = 0; k < batch.count; ++k) {
      if ((bits >> k & 1U) == 0) state_[order_[t + k]] = dropped;
    }
  }
  return true;
}

}  // namespace hsp
