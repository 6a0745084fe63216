#include "picture/byte_sink.hpp"

namespace hsp {

// The only call through a pointer in the library; tests/packaging/stack_usage.awk knows it by this function's name.
void ByteSink::flush() {
  if (!refused_ && filled_ > 0) {
    refused_ = function_(context_, buffer_, filled_) != 0;
    if (!refused_) taken_ += filled_;
  }
  position_ += filled_;
  filled_ = 0;
}

}  // namespace hsp
