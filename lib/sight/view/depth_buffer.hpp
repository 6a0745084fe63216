// A grid over the view plane. Each cell holds its floor, a depth below which nothing is seen there, because one ball
// fills the cell above it. A ball whose front lies below the floor wherever it appears is hidden. All comparisons carry
// a margin for rounding: a ball that is found hidden is hidden, but not every hidden ball is found. A coarse cell of 4
// x 4 cells holds the lowest floor among them, and a tile of 4 x 4 coarse cells the lowest of these; that suffices for
// most deep balls. The values of coarse cells and tiles may be out of date, hence too low; they are computed again when
// they do not suffice.
#pragma once

#include "core/workspace.hpp"
#include "view/depth_rows.hpp"
#include "view/view_frame.hpp"

namespace hsp {

// A ball in view coordinates.
struct ProjectedBall {
  double x, y, z, r;
};

// A box around the discs of some balls in the view plane.
struct BoundingBox {
  double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;
};

class DepthBuffer {
 public:
  void carve(Workspace &workspace, uint32_t balls);

  // Makes the grid for balls within a box, with coordinates up to `extent` in size and radii of about `radius` > 0, and
  // lowers it below all of them.
  void lay_out(const BoundingBox &box, double extent, double radius);

  // Whether the floor lies above a height everywhere in a box. Then hides() is true for all balls within the box whose
  // tops are at most at that height.
  bool is_above(const BoundingBox &box, double height);
  // Whether the floor lies above the ball's front everywhere.
  bool hides(const ProjectedBall &disc) const;
  // Raises the floor to the ball's front, in the cells that it fills.
  void raise(const ProjectedBall &disc);

 private:
  template <class Visit>
  bool visit_cells(double x, double y, double radius, double squared, CellEdge edge, Visit visit) const;
  FloorCells floor_cells() const { return {floor_.data(), columns_, stale_.data(), coarse_columns_}; }
  void look_after_coarse_cell(uint32_t coarse_column, uint32_t coarse_row);
  void look_after_tile(uint32_t tile_column, uint32_t tile_row);

  Span<float> floor_;                 // [columns * rows]
  Span<float> coarse_;                // [coarse columns * coarse rows] the lowest floor of a coarse cell, or less
  Span<uint8_t> stale_;               // whether coarse_ may be less
  Span<float> tile_;                  // [tile columns * tile rows] the lowest value of its coarse cells, or less
  Span<uint8_t> stale_tile_;          // whether tile_ may be less
  double left_ = 0.0, bottom_ = 0.0;  // the corner of cell 0
  double cell_ = 1.0, cells_per_length_ = 1.0;
  double margin_ = 0.0;
  uint32_t columns_ = 0, rows_ = 0;
  uint32_t coarse_columns_ = 0, coarse_rows_ = 0;
  uint32_t tile_columns_ = 0;
  Target target_ = Target::baseline;
};

}  // namespace hsp
