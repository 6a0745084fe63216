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
  ShellPiece piece(uint32_t k) const { return load_record<ShellPiece>(piece_at(k)); }
  void put(uint32_t k, const ShellPiece &piece) { store_record(piece, piece_at(k)); }
  ComponentPart component(uint32_t k) const { return load_record<ComponentPart>(component_at(k)); }
  void put(uint32_t k, const ComponentPart &part) { store_record(part, component_at(k)); }
  void put(uint32_t k, const ShellSeam &seam) { store_record(seam, seam_at<ShellSeam>(header.shell_seams_at(), k)); }
  void put(uint32_t k, const ComponentSeam &seam) {
    store_record(seam, seam_at<ComponentSeam>(header.component_seams_at(), k));
  }
  void sort_seams();

  // Finishes the summary, which then has header.bytes() bytes. False if pieces and components contradict each other.
  // of_piece, of_component: scratch memory, a word for each piece and for each component.
  bool finish(Span<uint32_t> of_piece, Span<uint32_t> of_component);

 private:
  uint8_t *piece_at(uint32_t k) const { return memory_ + header.pieces_at() + uint64_t{little_bytes<ShellPiece>} * k; }
  uint8_t *component_at(uint32_t k) const {
    return memory_ + header.components_at() + uint64_t{little_bytes<ComponentPart>} * k;
  }
  template <class Record>
  uint8_t *seam_at(uint64_t list, uint32_t k) const {
    return memory_ + list + uint64_t{little_bytes<Record>} * k;
  }
  void mark_open(Span<uint32_t> of_piece, Span<uint32_t> of_component) const;
  uint32_t add_up_pieces(Span<uint32_t> of_piece, Span<const uint32_t> of_component);
  bool move_components(uint32_t pieces, Span<const uint32_t> of_piece, Span<uint32_t> of_component);
  template <class Record>
  void move_seams(uint64_t from, uint64_t to, uint32_t count, Span<const uint32_t> label);

  uint8_t *memory_;
};

}  // namespace hsp
