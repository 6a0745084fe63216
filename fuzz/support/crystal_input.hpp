// Lengths and the vectors of periodic boxes, made from the bytes of an input.
#pragma once

#include <array>

#include "fuzz_input.hpp"

namespace fuzz {

using BoxVectors = std::array<double, 9>;

// Lengths of whole steps, mostly from few values.
class StepLengths {
 public:
  explicit StepLengths(Bytes &bytes) : bytes_(bytes), fine_(bytes.one_in(3)) {}

  double operator()(int64_t least, int64_t most) {
    const int64_t whole = least + bytes_.below(static_cast<uint32_t>(most - least + 1));
    return static_cast<double>(fine_ ? 100 * whole + bytes_.below(100) : 2 * whole);
  }
  // Its sides are from 3 to `most`; half of the boxes lean, by at most `lean`.
  BoxVectors box(int64_t most, int64_t lean) {
    StepLengths &length = *this;
    BoxVectors box = {
        length(3, most), 0, 0, length(-lean, lean), length(3, most), 0, length(-lean, lean), length(-lean, lean),
        length(3, most)};
    if (bytes_.one_in(2)) box[3] = box[6] = box[7] = 0;
    return box;
  }

 private:
  Bytes &bytes_;
  bool fine_;
};

}  // namespace fuzz
