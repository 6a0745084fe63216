#include "picture/byte_sink.hpp"

namespace hsp {

// The only call through a pointer in the library but for paths; tests/packaging/stack_usage.awk knows it by this class.
void ByteSink::hand_on(const char *bytes, size_t count) {
  if (!refused_ && count > 0) {
    refused_ = function_(context_, bytes, count) != 0;
    if (!refused_) taken_ += count;
  }
  position_ += count;
}

void ByteSink::flush() {
  if (deflater_ != nullptr) {
    deflater_->take(buffer_, filled_, [this](const char *bytes, size_t count) { hand_on(bytes, count); });
  } else {
    hand_on(buffer_, filled_);
  }
  filled_ = 0;
}

void ByteSink::finish_compressed() {
  flush();
  deflater_->finish([this](const char *bytes, size_t count) { hand_on(bytes, count); });
  deflater_ = nullptr;
}

}  // namespace hsp
