// Hidden surface removal by the painter's order (Section 5.1): balls that may be seen, sorted by depth, each with the
// piece of it that is painted.
#pragma once

#include "view/depth_order.hpp"
#include "view/front_piece.hpp"
#include "view/hidden_balls.hpp"
#include "view/view_structure.hpp"

namespace hsp {

enum class PieceKind : uint32_t { outside_farther, outside_all };  // G and H of the paper

struct ViewRequest {
  ViewDirection direction{};
  PieceKind kind = PieceKind::outside_farther;
  bool all_balls = false;
};

class ViewBuilder {
 public:
  void carve(Workspace &workspace, const ViewLimits &limits);

  // boundary may be null for pieces outside farther balls. Status::capacity if a limit is too small; needed() then
  // tells what suffices, with 0 for what is not known yet.
  Status build(const CubeGrid &grid, const BoundaryStructure *boundary, const ViewRequest &request);

  const ViewStructure &structure() const { return structure_; }
  const ViewLimits &needed() const { return needed_; }
  PieceKind kind() const { return kind_; }

 private:
  void choose_balls(const CubeGrid &grid, const BoundaryStructure *boundary, bool all_balls);
  void cut_pieces(const CubeGrid &grid, const BoundaryStructure *boundary);
  void add_piece(const BallSet &balls);
  void sort_pieces(const BallSet &balls);

  ViewLimits limits_;
  ViewLimits needed_;
  ViewStructure structure_;
  PieceKind kind_ = PieceKind::outside_farther;
  HiddenBalls hidden_;
  FrontPiece piece_;
  Span<uint8_t> visible_;         // [balls]
  FixedVector<PieceRecord> cut_;  // [balls] pieces in the order of the grid
  Span<DepthKey> keys_;           // [balls]
};

}  // namespace hsp
