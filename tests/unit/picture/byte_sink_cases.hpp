// Bytes arrive in blocks, in order, and stop at the first refusal.
#pragma once

#include "cases.hpp"
#include "kept_text.hpp"

namespace cases {

using ManyBytes = KeptText<5000>;

struct Blocks {
  size_t bytes, room;
  size_t taken;
  uint32_t calls;
};
constexpr Blocks blocks[] = {{0, 5000, 0, 0},
                             {1, 5000, 1, 1},
                             {1023, 5000, 1023, 1},
                             {1024, 5000, 1024, 1},
                             {1025, 5000, 1025, 2},
                             {2048, 5000, 2048, 2},
                             {5000, 5000, 5000, 5},
                             // Refused with the first block that does not fit; no call after that.
                             {4000, 0, 0, 1},
                             {4000, 1, 0, 1},
                             {4000, 1023, 0, 1},
                             {4000, 1024, 1024, 2},
                             {4000, 1025, 1024, 2},
                             {4000, 3000, 2048, 3},
                             {4000, 3072, 3072, 4}};

inline uint32_t blocks_of_bytes() {
  return first_failing(blocks, [](const Blocks &c) {
    ManyBytes kept;
    kept.room = c.room;
    hsp::ByteSink sink(ManyBytes::keep, &kept);
    for (size_t k = 0; k < c.bytes; ++k) {
      sink.put(static_cast<char>('a' + k % 26));
      if (sink.position() != k + 1) return false;
    }
    sink.flush();
    for (size_t k = 0; k < kept.size; ++k) {
      if (kept.text[k] != static_cast<char>('a' + k % 26)) return false;
    }
    return kept.size == c.taken && kept.calls == c.calls && kept.largest <= 1024 && sink.taken() == c.taken &&
           sink.refused() == (c.taken < c.bytes) && sink.position() == c.bytes;
  });
}

inline constexpr Check picture_byte_sink[] = {{"blocks_of_bytes", blocks_of_bytes}};

}  // namespace cases
