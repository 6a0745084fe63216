// The block of bytes that a summary is: a header, then lists, then a check sum. Little-endian; every number has 4 bytes
// or 8, so that all lengths are multiples of 4.
//
//   header | bricks | pieces | components | shell seams | component seams | check sum
//
// Bricks ascend, and so do seams, by their names; each name is there once.
#pragma once

#include <type_traits>

#include "bricks/summary_records.hpp"

namespace hsp {

// Numbers that are the same for all bricks of one set.
struct SharedLattice {
  uint64_t step = 0;  // the length of a lattice step, as the bits of a double
  int64_t probe_steps = 0;
  int64_t largest_radius = 0;
  bool operator==(const SharedLattice &) const = default;
};

struct SummaryHeader {
  static constexpr uint64_t name = 0x4B43495242505348;  // HSPBRICK
  static constexpr uint32_t newest = 1;
  static constexpr uint32_t keeps_shells = 1;

  uint64_t magic = name;
  uint32_t version = newest;
  uint32_t flags = 0;
  SharedLattice lattice;
  uint32_t all_bricks = 0;                                                                // of the whole set
  uint32_t bricks = 0, pieces = 0, components = 0, shell_seams = 0, component_seams = 0;  // how many records there are
  SummaryTotals totals;

  template <class Io, class Header>
  static constexpr void visit(Io &io, Header &h) {
    io(h.magic), io(h.version), io(h.flags), io(h.lattice.step), io(h.lattice.probe_steps),
        io(h.lattice.largest_radius);
    io(h.all_bricks), io(h.bricks), io(h.pieces), io(h.components), io(h.shell_seams), io(h.component_seams);
    SummaryTotals::visit(io, h.totals);
  }
  bool keeps() const { return (flags & keeps_shells) != 0; }

  // The offsets of the lists, in bytes.
  uint64_t bricks_at() const { return little_bytes<SummaryHeader>; }
  uint64_t pieces_at() const { return bricks_at() + uint64_t{sizeof(uint32_t)} * bricks; }
  uint64_t components_at() const { return pieces_at() + uint64_t{little_bytes<ShellPiece>} * pieces; }
  uint64_t shell_seams_at() const { return components_at() + uint64_t{little_bytes<ComponentPart>} * components; }
  uint64_t component_seams_at() const { return shell_seams_at() + uint64_t{little_bytes<ShellSeam>} * shell_seams; }
  uint64_t check_at() const { return component_seams_at() + uint64_t{little_bytes<ComponentSeam>} * component_seams; }
  uint64_t bytes() const { return check_at() + sizeof(uint64_t); }
  // The offset of record k of the list of its kind, and how many seams of a kind there are.
  template <class Record>
  uint64_t at(uint32_t k) const {
    const uint64_t list = std::is_same_v<Record, ShellPiece>      ? pieces_at()
                          : std::is_same_v<Record, ComponentPart> ? components_at()
                          : std::is_same_v<Record, ShellSeam>     ? shell_seams_at()
                                                                  : component_seams_at();
    return list + uint64_t{little_bytes<Record>} * k;
  }
  template <class Record>
  uint32_t seams() const {
    return std::is_same_v<Record, ShellSeam> ? shell_seams : component_seams;
  }
};

// The check sum of bytes, a multiple of 4. A change of one number of 4 bytes always changes it.
uint64_t check_sum(const uint8_t *bytes, uint64_t count);

enum class SummaryFault : uint32_t {
  none,
  damaged,  // the bytes are no summary, or not as they were written
  newer     // the version is not known here
};

// A summary that is read in place. After a success all numbers of its records are in range, wherever the bytes come
// from.
class SummaryBlock {
 public:
  SummaryFault read(const uint8_t *bytes, uint64_t count);

  const SummaryHeader &header() const { return header_; }
  uint32_t brick(uint32_t k) const { return load_little<uint32_t>(bytes_ + header_.bricks_at() + 4 * uint64_t{k}); }
  template <class Record>
  Record get(uint32_t k) const {
    return load_record<Record>(bytes_ + header_.at<Record>(k));
  }
  ShellPiece piece(uint32_t k) const { return get<ShellPiece>(k); }
  ComponentPart component(uint32_t k) const { return get<ComponentPart>(k); }
  bool has(uint32_t wanted) const;

 private:
  bool is_sound() const;

  const uint8_t *bytes_ = nullptr;
  SummaryHeader header_;
};

}  // namespace hsp
