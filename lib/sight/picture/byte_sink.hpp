// A buffer in front of the caller's sink. Bytes that do not fit go out in blocks of at most 1024 bytes. In between it
// may be compressed.
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

  // Hands on what is in the buffer. After the function has refused, bytes are dropped.
  void flush();

  // Bytes that were put, compressed ones as they go out, whether or not they were refused. Not while they are
  // compressed.
  uint64_t position() const { return position_ + filled_; }
  // Bytes that the function has taken.
  uint64_t taken() const { return taken_; }
  bool refused() const { return refused_; }

 private:
  void hand_on(const char *bytes, size_t count);

  SinkFunction function_;
  void *context_;
  uint64_t position_ = 0;  // of the buffer's first byte
  uint64_t taken_ = 0;
  uint32_t filled_ = 0;
  bool refused_ = false;
  Deflater *deflater_ = nullptr;
  char buffer_[1024];
};

}  // namespace hsp
