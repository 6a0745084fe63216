// Output arrays that tell what was written to them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fuzz {

// An output array of exactly `capacity` records between guards, or none at all.
template <class Record>
class Output {
 public:
  Output(uint32_t capacity, bool null)
      : capacity_(capacity), null_(null), memory_((capacity + 2) * sizeof(Record), 0xA5) {}

  Record *data() { return null_ ? nullptr : reinterpret_cast<Record *>(memory_.data()) + 1; }
  uint32_t capacity() const { return capacity_; }

  // Nothing but the first `written` records was touched.
  bool untouched_from(uint32_t written) const {
    for (size_t i = 0; i < memory_.size(); ++i) {
      const bool inside = i >= sizeof(Record) && i < (1 + size_t{written}) * sizeof(Record);
      if (!inside && memory_[i] != 0xA5) return false;
    }
    return true;
  }

 private:
  uint32_t capacity_;
  bool null_;
  std::vector<uint8_t> memory_;
};

}  // namespace fuzz
