// Blocks of a summary made of any records, right or wrong, with a right check sum.
#pragma once

#include <bit>
#include <vector>

#include "bricks/summary_block.hpp"

struct BlockParts {
  hsp::SummaryHeader header;
  std::vector<uint32_t> bricks;
  std::vector<hsp::ShellPiece> pieces;
  std::vector<hsp::ComponentPart> components;
  std::vector<hsp::ShellSeam> shell_seams;
  std::vector<hsp::ComponentSeam> component_seams;

  // more: bytes beyond, or that are missing, before the check sum.
  std::vector<uint8_t> bytes(int more = 0) const {
    hsp::SummaryHeader h = header;
    h.bricks = static_cast<uint32_t>(bricks.size());
    h.pieces = static_cast<uint32_t>(pieces.size());
    h.components = static_cast<uint32_t>(components.size());
    h.shell_seams = static_cast<uint32_t>(shell_seams.size());
    h.component_seams = static_cast<uint32_t>(component_seams.size());
    std::vector<uint8_t> result(h.check_at());
    hsp::store_record(h, result.data());
    for (size_t k = 0; k < bricks.size(); ++k) hsp::store_little(bricks[k], &result[h.bricks_at() + 4 * k]);
    put(pieces, h.pieces_at(), result);
    put(components, h.components_at(), result);
    put(shell_seams, h.shell_seams_at(), result);
    put(component_seams, h.component_seams_at(), result);
    result.resize(result.size() + static_cast<size_t>(static_cast<std::ptrdiff_t>(more)));
    const uint64_t sum = hsp::check_sum(result.data(), result.size());
    result.resize(result.size() + sizeof sum);
    hsp::store_little(sum, &result[result.size() - sizeof sum]);
    return result;
  }

 private:
  template <class Record>
  static void put(const std::vector<Record> &records, uint64_t at, std::vector<uint8_t> &result) {
    for (size_t k = 0; k < records.size(); ++k)
      hsp::store_record(records[k], &result[at + hsp::little_bytes<Record> * k]);
  }
};

template <class Record>
Record seam_between(uint32_t a, uint32_t b, uint64_t id, uint32_t label) {
  Record seam;
  seam.a = a;
  seam.b = b;
  seam.id[0] = id;
  seam.label = label;
  return seam;
}

// Bricks 1 and 4 of six, with two pieces and components that go on in bricks 0, 2 and 3.
inline BlockParts two_open_parts() {
  BlockParts parts;
  parts.header.lattice = {std::bit_cast<uint64_t>(1.0), 0, 5};
  parts.header.all_bricks = 6;
  parts.bricks = {1, 4};
  parts.pieces.resize(2);
  parts.pieces[0].component = 0;
  parts.pieces[1].component = 1;
  parts.pieces[1].faces = 3;
  parts.components.resize(2);
  parts.components[0].top_piece = 0;
  parts.components[1].lowest_id = 70;
  parts.shell_seams = {seam_between<hsp::ShellSeam>(0, 4, 90, 1), seam_between<hsp::ShellSeam>(3, 4, 91, 1)};
  parts.shell_seams[1].id[1] = 92;
  parts.shell_seams[1].id[2] = 93;
  parts.component_seams = {seam_between<hsp::ComponentSeam>(1, 2, 70, 0),
                           seam_between<hsp::ComponentSeam>(3, 4, 91, 1)};
  return parts;
}
