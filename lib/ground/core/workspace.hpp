// Carves arrays out of one block of caller memory.
//
//   memory              first multiple of 64
//   |  slack (0..63)    |  array 0  | pad |  array 1  | pad |  ...  |
//
// The same layout function runs twice: with a null base it only measures, with the caller's block it carves. So the
// reported size and the memory that is used cannot disagree.
//
// In tests and fuzz harnesses under the address sanitizer the pads are poisoned, so that an access past an array ends
// the program although it stays inside the caller's block. Every array but an empty one then has a pad, of 1 to 64
// bytes instead of 0 to 63. A test that uses such a block for something else takes a new one; carving it again
// unpoisons it.
#pragma once

#include <new>
#include <type_traits>

#include "core/poison.hpp"
#include "core/span.hpp"
#include "lanes/target.hpp"

namespace hsp {

class Workspace {
 public:
  static constexpr size_t alignment = 64;

  // A workspace that only measures.
  Workspace() = default;
  Workspace(void *memory, size_t bytes) : base_(static_cast<unsigned char *>(memory)), bytes_(bytes) {
    used_ = padding();
    unpoison(memory, bytes);
    target_ = best_target();
  }

  // The target of the kernels for structures that are carved here. The processor is asked once for a handle, and never
  // for a size: in a virtual machine that traps to the host and takes tens of microseconds.
  Target target() const { return has_further_targets ? target_ : Target::baseline; }

  // An array of `count` T, or an empty span while measuring. It has no values, whatever initialisers T has: memory is
  // touched when something is kept there, so that generous limits cost no time.
  template <class T>
  Span<T> take(uint64_t count) {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignment);
    void *memory = reserve(count, sizeof(T));
    if (memory == nullptr) return {};
    // An array of bytes makes the objects in it.
    ::new (memory) unsigned char[static_cast<size_t>(count) * sizeof(T)];
    return {std::launder(static_cast<T *>(memory)), static_cast<uint32_t>(count)};
  }

  // The same with objects that begin as default-initialised.
  template <class T>
  Span<T> make(uint64_t count) {
    void *memory = reserve(count, sizeof(T));
    if (memory == nullptr) return {};
    T *first = static_cast<T *>(memory);
    for (uint64_t k = 0; k < count; ++k) ::new (static_cast<void *>(first + k)) T;
    return {first, static_cast<uint32_t>(count)};
  }

  // The same for several arrays, one after the other.
  template <class... T>
  void take_each(uint64_t count, Span<T> &...arrays) {
    ((arrays = take<T>(count)), ...);
  }

  // Bytes that suffice for any alignment of the block; 0 if they do not fit a size_t, or an array no span.
  size_t bytes() const { return overflow_ || used_ > SIZE_MAX - alignment ? 0 : used_ + alignment; }

 private:
  // Reserves the bytes of an array and of the pad behind it. Null while measuring, and if the array does not fit the
  // block. Not inlined: handles are carved into dozens of arrays.
  [[gnu::noinline]] void *reserve(uint64_t count, size_t size) {
    // Padding can exceed half of SIZE_MAX. A span has no more than 2^32 - 1 items.
    if (used_ > SIZE_MAX / 2 || count > (SIZE_MAX / 2 - used_) / size || count > UINT32_MAX) {
      overflow_ = true;
      return nullptr;
    }
    const size_t begin = used_;
    used_ += static_cast<size_t>(count) * size;
    const size_t end = used_;
    if (poisons && count > 0) ++used_;
    used_ += padding();
    if (base_ != nullptr && end < bytes_) poison(base_ + end, (used_ < bytes_ ? used_ : bytes_) - end);
    return base_ == nullptr || end > bytes_ ? nullptr : base_ + begin;
  }
  // Bytes to the next aligned address. While measuring the block is taken to be aligned; bytes() adds the slack.
  size_t padding() const { return (alignment - (reinterpret_cast<uintptr_t>(base_) + used_) % alignment) % alignment; }

  unsigned char *base_ = nullptr;
  size_t bytes_ = 0;
  size_t used_ = 0;
  bool overflow_ = false;
  Target target_ = Target::baseline;
};

}  // namespace hsp
