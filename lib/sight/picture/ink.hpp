// Contours along silhouettes as areas whose width follows what lies behind: lunes, which a stroke could not be.
//
// A contour's width at a point of a silhouette depends on the gap g, in mean radii of the model's balls, between the
// silhouette and what lies behind it there, the way one looks:
//   border  before the background        b
//   depth   before a ball               d (min(1, g / 3))^(5/8)
//   group   before a ball of another group   max(s min(1, 2 g), as depth)
// times 1 - f for fog f. So it is 0 where a silhouette goes over into a crease: there g is 0. Where along a silhouette
// what lies behind changes, the gap jumps; there the thinner side is widened to the width of the thicker one, which
// falls off along twice the largest width, or along the arc if that is shorter, slowly at first and at last. That makes
// widths continuous, leaves 0 at tangencies, and an arc of next to no length, as planar molecules have them where
// depths differ by noise, changes next to nothing.
//
// Where no background is behind what is seen of a ball's silhouette between two nearer bodies, that is a gap in which
// wide contours would clot: if its length is a share of eight times the largest width, all widths are the square of
// that share.
//
// Where a silhouette goes over into a crease with a ball, what lies behind may rise steeply. There widths fall off like
// a parabola, so that no contour ends bluntly: along four times the largest width, or twice that if another silhouette
// crosses so near to the end, which goes on from there. Borders go on with their widths.
//
// Contours are painted directly after their ball: whatever is nearer then covers their ends, which go on under it.
#pragma once

#include "picture/paint.hpp"

namespace hsp {

enum class InkLevel : uint32_t { border = 0, group = 1, depth = 2 };
// In the order in which those of one ball are painted.
constexpr InkLevel ink_levels[] = {InkLevel::depth, InkLevel::group, InkLevel::border};

// The points (1 - t)^2 start + 2 t (1 - t) control + t^2 end.
struct InkCurve {
  PagePoint start, control, end;
  bool behind_line;  // a line leads to the start

  PagePoint at(double t) const {
    const double a = (1.0 - t) * (1.0 - t), b = 2 * t * (1.0 - t), c = t * t;
    return {a * start.x + b * control.x + c * end.x, a * start.y + b * control.y + c * end.y};
  }
  // The same curve as a cubic: the handle next to one of its ends.
  PagePoint handle(const PagePoint &at_end) const {
    return {(at_end.x + 2 * control.x) / 3, (at_end.y + 2 * control.y) / 3};
  }
};

// Takes the curves around a contour one after the other. `first` begins one; to where that starts a line leads from
// the end of the one that `closes`.
struct InkVisitor {
  void *context;
  void (*take)(void *context, const InkCurve &curve, bool first, bool closes);

  void operator()(const InkCurve &curve, bool first, bool closes) const { take(context, curve, first, closes); }
};

class Ink {
 public:
  Ink(const PictureInput &input, const PictureOptions &options, const Page &page, const Paint &paint)
      : input_(input), options_(options), page_(page), paint_(paint) {}

  bool is_drawn() const { return input_.silhouettes.exist(); }
  uint32_t colour(InkLevel level, uint32_t fog_level) const {
    return paint_.faded_line(options_.ink_colour[static_cast<uint32_t>(level)], fog_level);
  }

  // Calls visit(curve, first, closes) around the contours of a path's body that have a level.
  template <class Visit>
  void visit(uint32_t path, InkLevel level, Visit visit) const {
    const InkVisitor visitor{&visit, [](void *context, const InkCurve &curve, bool first, bool closes) {
                               (*static_cast<Visit *>(context))(curve, first, closes);
                             }};
    visit_contours(path, level, visitor);
  }

 private:
  void visit_contours(uint32_t path, InkLevel level, const InkVisitor &visitor) const;

  const PictureInput &input_;
  const PictureOptions &options_;
  const Page &page_;
  const Paint &paint_;
};

}  // namespace hsp
