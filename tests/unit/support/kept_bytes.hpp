// A sink that keeps its bytes, for tests of what writes into one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "picture/byte_sink.hpp"

struct KeptBytes {
  std::string text;
  size_t largest = 0;
  size_t room = SIZE_MAX;
  int calls = 0;
};

inline int32_t keep_bytes(void *context, const char *bytes, size_t count) {
  KeptBytes &kept = *static_cast<KeptBytes *>(context);
  ++kept.calls;
  kept.largest = std::max(kept.largest, count);
  if (kept.text.size() + count > kept.room) return 1;
  kept.text.append(bytes, count);
  return 0;
}

// What `put` writes into the sink it is called with.
template <class Put>
std::string text_of(Put put) {
  KeptBytes kept;
  hsp::ByteSink sink(keep_bytes, &kept);
  put(sink);
  sink.flush();
  return kept.text;
}
