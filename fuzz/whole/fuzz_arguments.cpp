// Any function with base arguments (tests/laws/support) of which some are replaced: by NULL, addresses without a live
// handle of the kind, other numbers, less room, structs with other fields. The status must be documented, a function
// that fails must write nothing but what it may, and no memory outside of the arguments may be touched.
#include <hardsphere.h>

#include <array>
#include <cstring>
#include <string>

#include "call.h"
#include "call_checks.hpp"
#include "fenced_memory.h"

namespace {

using fuzz::Bytes;

// Whether an argument is replaced: only few are, so that the others still have a meaning.
bool is_changed(Bytes &bytes) {
  return bytes.one_in(6);
}

uint32_t word(Bytes &bytes) {
  static constexpr uint32_t special[] = {0xFFFFFFFF, 0xFFFFFFFE,    0x80000000,
                                         0x7FFFFFFF, HSP_MAX_BALLS, HSP_MAX_BALLS + 1};
  return bytes.one_in(3) ? special[bytes.below(static_cast<uint32_t>(std::size(special)))] : bytes.below(24);
}

class ChangedCall {
 public:
  ChangedCall(Bytes &bytes, const function &f) : bytes_(bytes) {
    const uint32_t room = bytes_.below(2) == 0 ? uint32_t{PLENTY} : bytes_.below(40);
    call_numbers(&call_, &f, room);
    for (int i = 0; i < f.count; ++i) {
      if (argument_at(i).kind == KIND_value && is_changed(bytes_)) change_number(i);
    }
    call_pointers(&call_, room);
    if (struct_size_ >= 0) largest_struct(struct_size_ - 1);
    for (int i = 0; i < f.count; ++i) {
      if (is_changed(bytes_)) change_pointer(i);
    }
  }

  void check() {
    call_run(&call_);
    const char *const found = call_finds(&call_);
    if (found != nullptr) fail(found);
    if (call_.f->result == RESULT_number || call_.f->result == RESULT_text) return;
    const bool is_id = call_.f->result == RESULT_id;
    const bool succeeded = is_id ? static_cast<uint32_t>(call_.result) != HSP_NONE : call_.result == HSP_OK;
    if (must_fail_ && succeeded) fail("NULL or no handle, and not refused");
    if (is_id || succeeded) return;
    const char *const written = call_wrote(&call_, may_be_written());
    if (written != nullptr) fail((std::string("written although it failed: ") + written).c_str());
  }

 private:
  const argument &argument_at(int i) const { return call_.f->arguments[i]; }

  void fail(const char *text) const {
    std::fprintf(stderr, "%s: %lld\n", call_.f->name, static_cast<long long>(call_.result));
    FUZZ_REQUIRE(false, text);
  }

  // The names of the outputs that a function may write when it fails, by the comments of the header.
  const char *may_be_written() const {
    switch (call_.result) {
      case HSP_E_HANDLE:
        return "";
      case HSP_E_CAPACITY:
        return "|needed|words_needed|first|limits|first_bad|bytes|brick|";
      case HSP_E_CONFLICT:
        return "|conflict|brick|";
      default:
        return std::strcmp(call_.f->noun, "picture") == 0 ? "|bytes|" : "|needed|first_bad|brick|";
    }
  }

  // Whether argument i is the length of an array. Such numbers stay small, as arrays are made that long.
  bool is_extent(int i) const {
    for (int k = 0; k < call_.f->count; ++k) {
      const char *const extent = argument_at(k).extent;
      if (extent != nullptr && std::strcmp(extent, argument_at(i).name) == 0) return true;
    }
    return false;
  }

  void change_number(int i) {
    const argument &a = argument_at(i);
    value &v = call_.v[i];
    if (std::strcmp(a.base, "double") == 0) {
      v.d = fuzz::number(bytes_, true);
    } else if (std::strcmp(a.base, "size_t") == 0) {
      v.z -= bytes_.below(static_cast<uint32_t>(v.z < 200 ? v.z : 200));
    } else if (std::strcmp(a.base, "int32_t") == 0) {
      v.i = -static_cast<int32_t>(bytes_.byte());
    } else if (std::strcmp(a.name, "struct_size") == 0) {
      v.u = bytes_.below(1100);
      struct_size_ = i;
    } else {
      v.u = is_extent(i) ? bytes_.below(12) : word(bytes_);
    }
  }

  void change_pointer(int i) {
    const argument &a = argument_at(i);
    switch (a.kind) {
      case KIND_value:
      case KIND_capacity:
      case KIND_context:
        return;
      case KIND_handle:
        change_handle(i);
        return;
      case KIND_sized:
      case KIND_sized_in:
      case KIND_outputs:
        if (!bytes_.one_in(4)) {
          change_struct(i, largest_struct(i), largest);
          return;
        }
        break;
      case KIND_array_in:
      case KIND_struct_in:
        if (fence_size(i) > 0 && !bytes_.one_in(4)) {
          change_entry(i);
          return;
        }
        break;
      case KIND_memory:
        if (bytes_.below(2) == 0) {
          call_.v[i].p = fence_take(i, fence_size(i), bytes_.below(16));
          return;
        }
        break;
      case KIND_callback:
        if (bytes_.below(2) == 0) {
          call_.v[i].f = [](void *, const char *, size_t) -> int32_t { return 1; };
          return;
        }
        break;
      default:
        if (!is_pointer(&a)) return;
        break;
    }
    must_fail_ = must_fail_ || a.null == NULL_never;
    call_put_null(&call_, i);
  }

  void change_handle(int i) {
    const int noun = argument_at(i).noun;
    auto *const own = static_cast<unsigned char *>(call_.v[i].p);
    const uint32_t other = 1 + (static_cast<uint32_t>(noun) + bytes_.below(NOUNS - 2)) % (NOUNS - 1);
    const uint32_t way = bytes_.below(7);
    const bool may_be_null = argument_at(i).null == NULL_always;
    must_fail_ = must_fail_ || way < 5 || (way == 6 && !may_be_null);
    switch (way) {
      case 0:  // random bytes
        for (unsigned char &byte : elsewhere_) byte = bytes_.byte();
        call_.v[i].p = elsewhere_.data();
        return;
      case 1:
        call_.v[i].p = given.handle[other];
        return;
      case 2:  // moved: the first word is all that is looked at
        std::memcpy(elsewhere_.data(), own, sizeof(uintptr_t));
        call_.v[i].p = elsewhere_.data();
        return;
      case 3:  // what is left of one whose memory was used for something else
        call_spoils(own);
        std::memset(own, bytes_.byte(), sizeof(uintptr_t));
        return;
      case 4:
        call_.v[i].p = own + 1 + bytes_.below(7);
        return;
      case 5:  // a live one, without results
        call_.v[i].p = given.fresh[noun];
        return;
      default:
        call_put_null(&call_, i);
    }
  }

  // The struct of base arguments with zeros behind it, in as much memory as any struct may have.
  unsigned char *largest_struct(int i) {
    auto *const at = static_cast<unsigned char *>(call_put(&call_, i, largest));
    std::memset(at, 0, largest);
    fill_base(&argument_at(i), at, 1);
    return at;
  }

  // Changes one field of a struct, but no address; fields of 64 bits may be addresses and are left alone.
  void change_struct(int i, void *at, size_t bytes) {
    const argument &a = argument_at(i);
    size_t count = 0;
    for (size_t k = 0; k < registry_fields_size; ++k) count += std::strcmp(registry_fields[k].of, a.base) == 0;
    if (count == 0) return;
    size_t which = bytes_.below(static_cast<uint32_t>(count));
    for (size_t k = 0; k < registry_fields_size; ++k) {
      const field &part = registry_fields[k];
      if (std::strcmp(part.of, a.base) != 0 || which-- > 0) continue;
      if (std::strcmp(part.base, "uint64_t") == 0 || std::strchr(part.base, '*') != nullptr) return;
      auto *const out = static_cast<unsigned char *>(at) + part.offset;
      if (part.offset == 0 && a.kind != KIND_array_in && a.kind != KIND_struct_in) {
        const uint32_t size = bytes_.below(static_cast<uint32_t>(bytes) + 1);
        std::memcpy(out, &size, sizeof size);
      } else if (std::strcmp(part.base, "double") == 0) {
        const double number = fuzz::number(bytes_, true);
        std::memcpy(out + 8 * bytes_.below(static_cast<uint32_t>(part.count)), &number, sizeof number);
      } else {
        const uint32_t number = word(bytes_);
        std::memcpy(out + 4 * bytes_.below(static_cast<uint32_t>(part.count)), &number, sizeof number);
      }
      return;
    }
  }

  void change_entry(int i) {
    const argument &a = argument_at(i);
    auto *const at = static_cast<unsigned char *>(call_.v[i].p);
    const size_t entry = a.size * bytes_.below(static_cast<uint32_t>(fence_size(i) / a.size));
    if (std::strcmp(a.base, "double") == 0) {
      const double number = fuzz::number(bytes_, true);
      std::memcpy(at + entry, &number, sizeof number);
    } else if (std::strncmp(a.base, "hsp_", 4) == 0) {
      change_struct(i, at + entry, a.size);
    } else {
      const uint32_t number[2] = {word(bytes_), 0};  // an entry has 4 or 8 bytes
      std::memcpy(at + entry, number, a.size);
    }
  }

  static constexpr size_t largest = 1024;

  Bytes &bytes_;
  call call_{};
  bool must_fail_ = false;
  int struct_size_ = -1;
  alignas(16) std::array<unsigned char, 1024> elsewhere_{};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  Bytes bytes(data, size);
  const char *why = nullptr;
  if (fences_exist(&why) == 0) return 0;
  call_with_balls(bytes.one_in(3) ? bytes.below(FIXTURE_BALLS) : uint32_t{FIXTURE_BALLS});
  while (!bytes.empty()) {
    const function &f = registry[bytes.below(static_cast<uint32_t>(registry_size))];
    ChangedCall(bytes, f).check();
  }
  return 0;
}
