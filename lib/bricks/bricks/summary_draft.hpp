// A summary while it is written. At first it has all pieces and components, in their final place or behind it. finish()
// adds up those that are complete, and moves the rest together.
//
//   memory   header | bricks | pieces | components | seams ..          .. words of scratch memory |
#pragma once

#include "bricks/summary_block.hpp"
#include "core/span.hpp"

namespace hsp {

// Scratch words at the end of the memory to which a summary is written. The words are aligned, the memory need not be.
class DraftWords {
 public:
  // So many bytes suffice for `count` words.
  static constexpr uint64_t bytes(uint64_t count) { return sizeof(uint32_t) * (count + 1); }

  DraftWords(uint8_t *memory, uint64_t size) : end_(memory + size) {
    end_ -= reinterpret_cast<uintptr_t>(end_) % sizeof(uint32_t);
  }
  Span<uint32_t> take(uint64_t count);

 private:
  uint8_t *end_;
};

class SummaryDraft {
 public:
  explicit SummaryDraft(uint8_t *memory) : memory_(memory) {}

  // The header. Until finish() its numbers of records are those of the draft.
  SummaryHeader header;

  void put_brick(uint32_t k, uint32_t brick) { store_little(brick, memory_ + header.bricks_at() + 4 * uint64_t{k}); }
  template <class Record>
  Record get(uint32_t k) const {
    return load_record<Record>(memory_ + header.at<Record>(k));
  }
  template <class Record>
  void put(uint32_t k, const Record &record) {
    store_record(record, memory_ + header.at<Record>(k));
  }
  ShellPiece piece(uint32_t k) const { return get<ShellPiece>(k); }
  ComponentPart component(uint32_t k) const { return get<ComponentPart>(k); }
  void sort_seams();

  // Finishes the summary, which then has header.bytes() bytes. False if pieces and components contradict each other.
  // of_piece, of_component: scratch memory, a word for each piece and for each component.
  bool finish(Span<uint32_t> of_piece, Span<uint32_t> of_component);

 private:
  void mark_open(Span<uint32_t> of_piece, Span<uint32_t> of_component) const;
  uint32_t add_up_pieces(Span<uint32_t> of_piece, Span<const uint32_t> of_component);
  bool move_components(uint32_t pieces, Span<const uint32_t> of_piece, Span<uint32_t> of_component);
  template <class Record>
  void move_seams(const SummaryHeader &before, Span<const uint32_t> label);

  uint8_t *memory_;
};

}  // namespace hsp
