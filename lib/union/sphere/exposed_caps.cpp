#include "sphere/exposed_caps.hpp"

#include "sphere/outer_cell.hpp"

namespace hsp {
namespace {

void load(const Caps &caps, const uint32_t *numbers, uint32_t count, CapBatch &batch) {
  batch.count = count;
  for (uint32_t k = 0; k < count; ++k) {
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
void ExposedCaps::order_by_size(const Caps &caps) {
  constexpr uint32_t classes = 64;
  uint32_t start[classes + 1] = {};
  for (uint32_t k = 0; k < caps.count; ++k) {
    state_[k] = static_cast<uint8_t>(size_class(caps.b[k], classes));
    ++start[state_[k] + 1];
  }
  for (uint32_t c = 0; c < classes; ++c) start[c + 1] += start[c];
  for (uint32_t k = 0; k < caps.count; ++k) order_[start[state_[k]]++] = k;
}

bool ExposedCaps::find(const Caps &caps) {
  const uint32_t count = caps.count;
  order_by_size(caps);
  for (uint32_t k = 0; k < count; ++k) state_[k] = dropped;
  OuterCell cell;
  cell.start();
  CapBatch batch{};
  for (uint32_t t = 0; t < count; t += CapBatch::most) {
    load(caps, &order_[t], count - t < CapBatch::most ? count - t : CapBatch::most, batch);
    for (uint32_t bits = caps_that_may_cut(caps.target, cell, batch); bits != 0;) {
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
          if (bits != 0) bits &= caps_that_may_cut(caps.target, cell, batch);
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
  for (uint32_t t = 0; t < asked; t += CapBatch::most) {
    load(caps, &order_[t], asked - t < CapBatch::most ? asked - t : CapBatch::most, batch);
    const uint32_t bits = caps_that_may_cut(caps.target, cell, batch);
    for (uint32_t k = 0; k < batch.count; ++k) {
      if ((bits >> k & 1U) == 0) state_[order_[t + k]] = dropped;
    }
  }
  return true;
}

}  // namespace hsp
