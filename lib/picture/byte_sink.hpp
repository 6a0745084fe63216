// A buffer in front of the caller's sink. What does not fit goes out in blocks of at most 1024 bytes.
#pragma once

#include <cstddef>
#include <cstdint>

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

  // Hands on what is in the buffer. After the function has refused, bytes are dropped.
  void flush();

  // Bytes that were put, whether or not they were refused.
  uint64_t position() const { return position_ + filled_; }
  // Bytes that the function has taken.
  uint64_t taken() const { return taken_; }
  bool refused() const { return refused_; }

 private:
  SinkFunction function_;
  void *context_;
  uint64_t position_ = 0;  // of the buffer's first byte
  uint64_t taken_ = 0;
  uint32_t filled_ = 0;
  bool refused_ = false;
  char buffer_[1024];
};

}  // namespace hsp
