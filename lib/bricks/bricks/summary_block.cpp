#include "bricks/summary_block.hpp"

#include "core/first_index.hpp"
#include "lanes/floating_point.hpp"

namespace hsp {
namespace {

// Whether each seam joins one brick that is in the summary and one that is not, and has a valid label; and names
// ascend.
template <class Record>
bool are_seams(const SummaryBlock &block, uint32_t labels) {
  Seam before;
  for (uint32_t k = 0; k < block.header().seams<Record>(); ++k) {
    const Seam seam = block.get<Record>(k);
    if (seam.label >= labels || seam.a >= seam.b || seam.b >= block.header().all_bricks) return false;
    if (k > 0 && !(before < seam)) return false;
    if (block.has(seam.a) == block.has(seam.b)) return false;
    before = seam;
  }
  return true;
}

}  // namespace

uint64_t check_sum(const uint8_t *bytes, uint64_t count) {
  uint64_t sum = UINT64_C(0xCBF29CE484222325);
  for (uint64_t k = 0; k < count; k += 4) {
    sum = (sum ^ load_little<uint32_t>(bytes + k)) * UINT64_C(0x9E3779B97F4A7C15);
    sum ^= sum >> 32;
  }
  return sum;
}

bool SummaryBlock::has(uint32_t wanted) const {
  const uint32_t first = first_index(0, header_.bricks, [&](uint32_t k) { return brick(k) >= wanted; });
  return first < header_.bricks && brick(first) == wanted;
}

SummaryFault SummaryBlock::read(const uint8_t *bytes, uint64_t count) {
  if (count % 4 != 0 || count < SummaryHeader{}.bytes()) return SummaryFault::damaged;
  const uint64_t check_at = count - sizeof(uint64_t);
  if (check_sum(bytes, check_at) != load_little<uint64_t>(bytes + check_at)) return SummaryFault::damaged;
  bytes_ = bytes;
  header_ = load_record<SummaryHeader>(bytes);
  if (header_.magic != SummaryHeader::name) return SummaryFault::damaged;
  if (header_.version > SummaryHeader::newest) return SummaryFault::newer;
  return header_.bytes() == count && is_sound() ? SummaryFault::none : SummaryFault::damaged;
}

bool SummaryBlock::is_sound() const {
  if (header_.version == 0 || (header_.flags & ~SummaryHeader::keeps_shells) != 0 || header_.bricks == 0) return false;
  const double step = std::bit_cast<double>(header_.lattice.step);
  if (!is_finite(step) || step <= 0.0) return false;
  if (header_.lattice.largest_radius < 0 || header_.lattice.largest_radius >> 31 != 0) return false;
  for (uint32_t k = 0; k < header_.bricks; ++k) {
    if (brick(k) >= header_.all_bricks || (k > 0 && brick(k) <= brick(k - 1))) return false;
  }
  for (uint32_t k = 0; k < header_.pieces; ++k) {
    if (piece(k).component >= header_.components) return false;
  }
  for (uint32_t k = 0; k < header_.components; ++k) {
    const uint32_t top = component(k).top_piece;
    if (top != no_id && (top >= header_.pieces || piece(top).component != k)) return false;
  }
  return are_seams<ShellSeam>(*this, header_.pieces) && are_seams<ComponentSeam>(*this, header_.components);
}

}  // namespace hsp
