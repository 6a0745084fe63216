#include "versioned_struct.hpp"

namespace hsp::capi {

// A larger size is no size of a struct, but comes from memory that was never initialised.
constexpr uint32_t largest_struct = 1024;

bool is_struct_size(StructSize known, uint32_t struct_size) {
  if (struct_size < known.bytes) return known.earlier != 0 && struct_size == known.earlier;
  return struct_size <= largest_struct && struct_size % 4 == 0;
}

int32_t read_versioned(const void *given, StructSize known, void *complete) {
  if (given == nullptr) return HSP_E_ARGUMENT;
  uint32_t size = 0;
  std::memcpy(&size, given, sizeof size);
  if (!is_struct_size(known, size)) return HSP_E_VERSION;
  const auto *const bytes = static_cast<const unsigned char *>(given);
  for (uint32_t i = known.bytes; i < size; ++i) {
    if (bytes[i] != 0) return HSP_E_VERSION;
  }
  std::memcpy(complete, given, size < known.bytes ? size : known.bytes);
  std::memcpy(complete, &known.bytes, sizeof known.bytes);
  return HSP_OK;
}

int32_t write_versioned(const void *value, StructSize known, void *out, uint32_t struct_size) {
  if (out == nullptr) return HSP_E_ARGUMENT;
  if (!is_struct_size(known, struct_size)) return HSP_E_VERSION;
  const uint32_t common = struct_size < known.bytes ? struct_size : known.bytes;
  std::memcpy(out, value, common);
  std::memset(static_cast<unsigned char *>(out) + common, 0, struct_size - common);
  std::memcpy(out, &struct_size, sizeof struct_size);
  return HSP_OK;
}

int32_t read_limits(const void *given, LimitTable table, void *limits) {
  unsigned char complete[largest_limits] = {};
  if (const int32_t status = read_versioned(given, table.known, complete); status != HSP_OK) return status;
  auto *to = static_cast<unsigned char *>(limits);
  for (const uint8_t offset : table.offsets) {
    uint32_t limit = 0;
    std::memcpy(&limit, complete + offset, sizeof limit);
    if (limit > HSP_MAX_BALLS) return HSP_E_RANGE;
    std::memcpy(to, &limit, sizeof limit);
    to += sizeof limit;
  }
  return HSP_OK;
}

int32_t write_limits(const void *limits, LimitTable table, void *given, uint32_t struct_size) {
  unsigned char complete[largest_limits] = {};
  const auto *from = static_cast<const unsigned char *>(limits);
  for (const uint8_t offset : table.offsets) {
    std::memcpy(complete + offset, from, sizeof(uint32_t));
    from += sizeof(uint32_t);
  }
  return write_versioned(complete, table.known, given, struct_size);
}

}  // namespace hsp::capi
