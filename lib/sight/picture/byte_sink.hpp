// A buffer in front of the caller's sink. When it is full its bytes go out, in blocks of at most 1024 bytes. A part of
// the bytes may be compressed.
#pragma once

#include <cstddef>
#include <cstdint>

#include "picture/deflate.hpp"

namespace hsp {

using SinkFunction = int32_t (*)(void *context, const char *bytes, size_t count);

class ByteSink {
 public:
  ByteSink(SinkFunction function, void *context) : function_(function), context_(context) {}

  void put(char byte) {
    buffer_[filled_++] = byte;
    if (filled_ == sizeof buffer_) flush();
  }
  void put(const char *text) {
    for (; *text != '\0'; ++text) put(*text);
  }

  // Bytes from here to finish_compressed() go out as a zlib stream.
  void start_compressed(Deflater &deflater) {
    flush();
    deflater_ = &deflater;
  }
  void finish_compressed();

  // Hands the buffered bytes to the caller's function. After that has refused, bytes are dropped.
  void flush();

  // How many bytes were put, refused or not; compressed ones count as they go out. Not valid while bytes are
  // compressed.
  uint64_t position() const { return position_ + filled_; }
  // How many bytes the function has taken.
  uint64_t taken() const { return taken_; }
  bool refused() const { return refused_; }

 private:
  void hand_on(const char *bytes, size_t count);

  SinkFunction function_;
  void *context_;
  uint64_t position_ = 0;  // the position of the buffer's first byte
  uint64_t taken_ = 0;
  uint32_t filled_ = 0;
  bool refused_ = false;
  Deflater *deflater_ = nullptr;
  char buffer_[1024];
};

}  // namespace hsp
