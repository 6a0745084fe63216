// A sink that keeps its bytes in memory of fixed size, for tests of what writes into one; and a reader of such texts.
#pragma once

#include <cstring>

#include "picture/byte_sink.hpp"

namespace cases {

template <size_t most>
struct KeptText {
  char text[most + 1] = "";  // ends with a zero
  size_t size = 0;
  size_t largest = 0;  // size of the largest block
  size_t room = most;  // a block that would lead beyond this size is refused
  uint32_t calls = 0;

  void clear() {
    size = largest = calls = 0;
    room = most;
    text[0] = '\0';
  }
  bool is(const char *expected) const { return std::strcmp(text, expected) == 0; }
  // How often a part stands in the text.
  uint32_t count(const char *part) const {
    uint32_t times = 0;
    for (const char *at = std::strstr(text, part); at != nullptr; at = std::strstr(at + 1, part)) ++times;
    return times;
  }

  static int32_t keep(void *context, const char *bytes, size_t count) {
    KeptText &kept = *static_cast<KeptText *>(context);
    ++kept.calls;
    if (count > kept.largest) kept.largest = count;
    if (count > kept.room - kept.size) return 1;
    std::memcpy(kept.text + kept.size, bytes, count);
    kept.size += count;
    kept.text[kept.size] = '\0';
    return 0;
  }
};

// The text that `put` writes into the sink it is called with.
template <size_t most = 100, class Put>
KeptText<most> text_of(Put put) {
  KeptText<most> kept;
  hsp::ByteSink sink(KeptText<most>::keep, &kept);
  put(sink);
  sink.flush();
  return kept;
}

// Reads a text from its beginning on.
class TextReader {
 public:
  explicit TextReader(const char *text) : at_(text) {}

  const char *rest() const { return at_; }
  // Goes behind the next part of this kind; where there is none, it stays.
  bool find(const char *part) {
    const char *found = std::strstr(at_, part);
    if (found != nullptr) at_ = found + std::strlen(part);
    return found != nullptr;
  }
  // Goes behind this part if the text goes on with it.
  bool take(const char *part) {
    const size_t length = std::strlen(part);
    if (std::strncmp(at_, part, length) != 0) return false;
    at_ += length;
    return true;
  }
  // The number with which the text goes on, after spaces: digits with or without a sign and a point, but no exponent.
  bool number(double &value) {
    const char *next = at_;
    while (*next == ' ' || *next == '\n') ++next;
    const bool negative = *next == '-';
    if (negative) ++next;
    const char *const first = next;
    double digits = 0.0, unit = 1.0;
    bool point = false;
    for (; (*next >= '0' && *next <= '9') || (*next == '.' && !point); ++next) {
      if (*next == '.') {
        point = true;
        continue;
      }
      digits = 10 * digits + (*next - '0');
      if (point) unit *= 10;
    }
    if (next == first) return false;
    at_ = next;
    value = negative ? -digits / unit : digits / unit;
    return true;
  }
  template <size_t n>
  bool numbers(double (&values)[n]) {
    for (double &value : values) {
      if (!number(value)) return false;
    }
    return true;
  }

 private:
  const char *at_;
};

}  // namespace cases
