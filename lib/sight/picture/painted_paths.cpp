#include "picture/painted_paths.hpp"

namespace hsp {
namespace {

uint32_t ball_of_piece(const void *view, uint32_t piece) {
  return static_cast<const View *>(view)->pieces[piece].ball;
}

void visit_piece(const void *view, const BallSet &balls, uint32_t piece, const ArcVisitor &visitor) {
  visit_arcs(balls, *static_cast<const View *>(view), piece, visitor);
}

constexpr PaintedPaths::Functions of_view{ball_of_piece, visit_piece, nullptr};

}  // namespace

PaintedPaths paths_of(const View &view) {
  return {view.frame, view.pieces.size(), &view, of_view};
}

ViewBox box_of(const BallSet &balls, const PaintedPaths &paths) {
  ViewBox box{};
  for (uint32_t p = 0; p < paths.size(); ++p) {
    const uint32_t ball = paths.ball_of(p);
    const Vec3 centre = paths.frame().centre_of(balls, ball);
    const double r = balls.r[ball];
    const auto widen = [p](double low_value, double high_value, double &low, double &high) {
      low = p == 0 || low_value < low ? low_value : low;
      high = p == 0 || high_value > high ? high_value : high;
    };
    widen(centre.x - r, centre.x + r, box.low[0], box.high[0]);
    widen(centre.y - r, centre.y + r, box.low[1], box.high[1]);
    widen(centre.z, centre.z, box.depth_low, box.depth_high);
  }
  return box;
}

}  // namespace hsp
