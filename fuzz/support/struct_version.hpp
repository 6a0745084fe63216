// A struct as programs compiled with other versions of the headers have it: larger or smaller, with anything behind the
// part that this header knows.
#pragma once

#include <cstring>

#include "fuzz_input.hpp"

namespace fuzz {

// earlier: the size of the struct in an earlier header, if it has grown.
template <class Struct, uint32_t earlier = sizeof(Struct)>
class StructVersion {
 public:
  // Chooses a size, mostly the one of this header.
  StructVersion(const Struct &value, Bytes &bytes) {
    std::memcpy(storage_, &value, sizeof value);
    if (!bytes.one_in(20)) return;
    const uint32_t size = bytes.one_in(4)   ? 0xFFFFFF00 + bytes.below(256)
                          : bytes.one_in(4) ? earlier
                                            : bytes.below(room);
    get()->struct_size = size;
    good_ = size == earlier || (size >= sizeof(Struct) && size <= 1024 && size % 4 == 0);
    if (size > sizeof(Struct) && bytes.one_in(3)) {
      const size_t at = sizeof(Struct) + bytes.below(room - static_cast<uint32_t>(sizeof(Struct)));
      storage_[at] = 1;
      good_ = good_ && at >= size;
    }
  }

  Struct *get() { return reinterpret_cast<Struct *>(storage_); }
  // Whether the struct is large enough to hold all of the value.
  bool whole() { return get()->struct_size >= sizeof(Struct); }
  // Whether the library has to accept its size.
  bool good() const { return good_; }

 private:
  static constexpr uint32_t room = 1100;
  alignas(8) unsigned char storage_[room] = {};
  bool good_ = true;
};

}  // namespace fuzz
