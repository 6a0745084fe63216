#include "bricks/summary_draft.hpp"

#include <new>

#include "core/sorting.hpp"

namespace hsp {
namespace {

// Flags of a piece or component before it gets its number in the finished summary.
constexpr uint32_t is_open = 1;  // it has a seam, or is kept
constexpr uint32_t is_top = 2;   // the highest point of its component is on this piece

// A record as it lies in memory, so that records can be sorted there.
template <class Record>
struct Bytes {
  uint8_t byte[little_bytes<Record>];
};
template <class Record>
void sort_records(uint8_t *first, uint32_t count) {
  sort_in_place(Span<Bytes<Record>>(reinterpret_cast<Bytes<Record> *>(first), count),
                [](const Bytes<Record> &a, const Bytes<Record> &b) {
                  return load_record<Record>(a.byte) < load_record<Record>(b.byte);
                });
}

}  // namespace

Span<uint32_t> DraftWords::take(uint64_t count) {
  end_ -= sizeof(uint32_t) * count;
  auto *const first = reinterpret_cast<uint32_t *>(end_);
  for (uint64_t k = 0; k < count; ++k) ::new (static_cast<void *>(first + k)) uint32_t;
  return {first, static_cast<uint32_t>(count)};
}

void SummaryDraft::sort_seams() {
  sort_records<ShellSeam>(memory_ + header.shell_seams_at(), header.shell_seams);
  sort_records<ComponentSeam>(memory_ + header.component_seams_at(), header.component_seams);
}

void SummaryDraft::mark_open(Span<uint32_t> of_piece, Span<uint32_t> of_component) const {
  for (uint32_t &state : of_piece) state = header.keeps() ? is_open : 0;
  for (uint32_t &state : of_component) state = header.keeps() ? is_open : 0;
  for (uint32_t k = 0; k < header.shell_seams; ++k) {
    of_piece[get<ShellSeam>(k).label] |= is_open;
  }
  for (uint32_t k = 0; k < header.component_seams; ++k) {
    of_component[get<ComponentSeam>(k).label] |= is_open;
  }
  for (uint32_t k = 0; k < header.components; ++k) {
    const uint32_t top = component(k).top_piece;
    if (top != no_id) of_piece[top] |= is_top;
  }
}

// Adds up the complete pieces. The outer shell of a component has its highest point. So a piece without seams that is
// not the top of an open component is the shell of a void, whatever else of the component is open.
uint32_t SummaryDraft::add_up_pieces(Span<uint32_t> of_piece, Span<const uint32_t> of_component) {
  uint32_t kept = 0;
  for (uint32_t k = 0; k < header.pieces; ++k) {
    const ShellPiece shell = piece(k);
    const bool may_be_outer = (of_piece[k] & is_top) != 0;
    if ((of_piece[k] & is_open) != 0 || (may_be_outer && (of_component[shell.component] & is_open) != 0)) {
      put(kept, shell);
      of_piece[k] = kept++;
      continue;
    }
    of_piece[k] = no_id;
    header.totals.add_shell(shell, !may_be_outer);
    if (may_be_outer) continue;
    ComponentPart part = component(shell.component);
    ++part.voids;
    put(shell.component, part);
  }
  return kept;
}

bool SummaryDraft::move_components(uint32_t pieces, Span<const uint32_t> of_piece, Span<uint32_t> of_component) {
  const SummaryHeader before = header;
  header.pieces = pieces;
  header.components = 0;
  for (uint32_t k = 0; k < before.components; ++k) {
    const bool open = (of_component[k] & is_open) != 0;
    of_component[k] = open ? header.components : no_id;
    if (!open) {
      ++header.totals.components;
      continue;
    }
    auto part = load_record<ComponentPart>(memory_ + before.at<ComponentPart>(k));
    if (part.top_piece != no_id) part.top_piece = of_piece[part.top_piece];
    put(header.components++, part);
  }
  for (uint32_t k = 0; k < pieces; ++k) {
    ShellPiece shell = piece(k);
    shell.component = of_component[shell.component];
    if (shell.component == no_id) return false;
    put(k, shell);
  }
  for (uint32_t k = 0; k < header.components; ++k) {
    const uint32_t top = component(k).top_piece;
    if (top != no_id && piece(top).component != k) return false;
  }
  return true;
}

template <class Record>
void SummaryDraft::move_seams(const SummaryHeader &before, Span<const uint32_t> label) {
  for (uint32_t k = 0; k < header.seams<Record>(); ++k) {
    Record seam = load_record<Record>(memory_ + before.at<Record>(k));
    seam.label = label[seam.label];
    put(k, seam);
  }
}

bool SummaryDraft::finish(Span<uint32_t> of_piece, Span<uint32_t> of_component) {
  const SummaryHeader before = header;
  mark_open(of_piece, of_component);
  const uint32_t pieces = add_up_pieces(of_piece, of_component);
  if (!move_components(pieces, of_piece, of_component)) return false;
  move_seams<ShellSeam>(before, of_piece);
  move_seams<ComponentSeam>(before, of_component);
  store_record(header, memory_);
  store_little(check_sum(memory_, header.check_at()), memory_ + header.check_at());
  return true;
}

}  // namespace hsp
