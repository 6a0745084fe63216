#include "bricks/whole_set.hpp"

#include <bit>

namespace hsp {
namespace {

constexpr uint64_t corners_of_a_vertex = 3, corners_of_an_arc = 2, sides_of_a_circle = 2;

int64_t euler_of(uint64_t six_euler) {
  return static_cast<int64_t>(six_euler) / 6;
}

}  // namespace

WholeSet::WholeSet(const SummaryBlock &summary)
    : summary_(summary),
      sums_(summary.header().totals),
      quantum_(summary.header().lattice.largest_radius),
      lattice_(exact::Lattice::with_step(std::bit_cast<double>(summary.header().lattice.step))) {
  if (!summary.header().keeps()) return;
  // Pieces are whole shells, and parts whole components, only if all bricks are in the summary.
  for (uint32_t k = 0; k < summary_.header().pieces; ++k) {
    const ShellPiece piece = summary_.piece(k);
    sums_.add_shell(piece, !is_outer(piece, k));
  }
  sums_.components += summary_.header().components;
}

uint32_t WholeSet::first_missing() const {
  const SummaryHeader &header = summary_.header();
  if (header.bricks == header.all_bricks) return no_id;
  uint32_t k = 0;
  while (k < header.bricks && summary_.brick(k) == k) ++k;
  return k;
}

bool WholeSet::is_sound() const {
  const SummaryHeader &header = summary_.header();
  if (header.shell_seams != 0 || header.component_seams != 0) return false;
  if (!header.keeps() && (header.pieces != 0 || header.components != 0)) return false;
  for (uint32_t k = 0; k < header.components; ++k) {
    if (summary_.component(k).top_piece == no_id) return false;
  }
  return sums_.voids == sums_.shells - sums_.components && static_cast<int64_t>(sums_.six_euler) % 12 == 0 &&
         sums_.corners % (corners_of_a_vertex * corners_of_an_arc) == 0 && sums_.half_circles % sides_of_a_circle == 0;
}

WholeTotals WholeSet::totals() const {
  return {sums_.balls,
          sums_.exposed,
          sums_.contained,
          sums_.corners / corners_of_a_vertex,
          sums_.corners / corners_of_an_arc,
          sums_.half_circles / sides_of_a_circle,
          sums_.faces,
          sums_.loops,
          sums_.shells,
          sums_.components,
          sums_.voids,
          sums_.tied_corners / corners_of_a_vertex,
          euler_of(sums_.six_euler),
          lattice_.area(quantum_.area(sums_.area)),
          lattice_.volume(quantum_.volume(sums_.thrice_volume)),
          lattice_.volume(quantum_.volume(sums_.thrice_voids))};
}

WholeShell WholeSet::shell(uint32_t k) const {
  const ShellPiece piece = summary_.piece(k);
  const VolumeSum thrice = piece.thrice_volume();
  const bool is_void = !is_outer(piece, k);
  return {summary_.component(piece.component).lowest_id,
          piece.faces,
          euler_of(piece.six_euler()),
          lattice_.area(quantum_.area(piece.area)),
          lattice_.volume(quantum_.volume(is_void ? -thrice : thrice)),
          is_void};
}

}  // namespace hsp
