// Hidden surface removal by the painter's order (Section 5.1): balls that may be seen, sorted by depth, each with the
// piece of it that is painted.
//
// Pieces that are cut by farther balls alone show what is seen. Proof: at a point of the view plane let ball m have the
// highest front. That point of the front lies in no ball, so it is in m's piece. Let ball j be painted later, so that
// its centre is no farther than m's, and let its disc hold the point, too. There j's front is at least as high as j's
// centre, hence as m's centre, and at most as high as m's front. So it lies inside ball m, which is farther, and is not
// in j's piece. A ball that is hidden as a whole is never m, so that it needs neither be painted nor cut others.
#pragma once

#include "view/depth_order.hpp"
#include "view/occlusion.hpp"
#include "view/view.hpp"
#include "view/visible_piece.hpp"

namespace hsp {

enum class PieceKind : uint32_t { outside_farther, outside_all };  // G and H of the paper

struct ViewRequest {
  ViewDirection direction{};
  PieceKind kind = PieceKind::outside_farther;
  bool all_balls = false;
};

class ViewBuilder : public Limited<ViewLimits> {
 public:
  void carve(Workspace &workspace, const ViewLimits &limits);

  // boundary may be null for pieces outside farther balls. Status::capacity if a limit is too small; needed() then
  // tells what suffices, with 0 for what is not known yet. Status::stopped if patience has ended.
  Status build(const CubeGrid &grid, const Boundary *boundary, const ViewRequest &request,
               Patience patience = Patience());

  const View &structure() const { return structure_; }
  PieceKind kind() const { return kind_; }
  // Scratch memory for writers of pictures; [balls].
  Span<uint32_t> scratch() { return scratch_; }

 private:
  bool choose_balls(const CubeGrid &grid, const Boundary *boundary, bool all_balls, Patience &patience);
  bool cut_pieces(const CubeGrid &grid, const Boundary *boundary, Patience &patience);
  void add_piece(const BallSet &balls);
  bool sort_pieces(const BallSet &balls, Patience &patience);

  View structure_;
  PieceKind kind_ = PieceKind::outside_farther;
  OcclusionCuller hidden_;
  VisiblePiece piece_;
  Span<uint8_t> visible_;         // [balls]
  FixedVector<PieceRecord> cut_;  // [balls] pieces in the order of the grid
  Span<uint32_t> scratch_;        // [balls]
  Span<DepthKey> keys_;           // [balls]
};

}  // namespace hsp
