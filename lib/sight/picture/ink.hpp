// Contours along silhouettes, as areas whose width depends on the body behind: lunes, which strokes could not draw.
//
// The width of a contour at a point of a silhouette depends on the gap g between the silhouette and the body behind it,
// along the line of sight and in mean radii of the model's balls:
//   border  before the background        b
//   depth   before a ball               d (min(1, g / 3))^(5/8)
//   group   before a ball of another group   max(s min(1, 2 g), as depth)
// times 1 - f for fog f; b, d and s are the largest widths (PictureOptions::ink_width). So the width is 0 at the point
// at which a silhouette goes over into a crease: there g is 0. The gap jumps at a point of a silhouette at which
// another body comes behind it. There the thinner side is widened to the width of the thicker one. The added width
// falls off along twice the largest width, or along the arc if that is shorter, slowly at both ends. That makes widths
// continuous and leaves them 0 at tangencies. An arc of almost no length, as planar molecules have if depths differ by
// noise, changes almost nothing.
//
// A visible part of a ball's silhouette between two nearer bodies, with no background behind it, lies in a gap in which
// wide contours would clot. If its length is the share q < 1 of eight times the largest width, all its widths are
// multiplied by q^2.
//
// Near the point at which a silhouette goes over into a crease with a ball, the surface behind may rise steeply. There
// widths fall off like a parabola, so that no contour ends bluntly: along four times the largest width, or twice it if
// another silhouette crosses so near to the end and goes on from there. Borders go on with their widths.
//
// Contours are painted directly after their ball: nearer bodies cover their ends, which go on under these.
#pragma once

#include "picture/paint.hpp"

namespace hsp {

enum class InkLevel : uint32_t { border = 0, group = 1, depth = 2 };
// The levels in the order in which the contours of one ball are painted.
constexpr InkLevel ink_levels[] = {InkLevel::depth, InkLevel::group, InkLevel::border};

// A quadratic curve: the points (1 - t)^2 start + 2 t (1 - t) control + t^2 end.
struct InkCurve {
  PagePoint start, control, end;
  bool behind_line;  // whether a line leads to the start

  PagePoint at(double t) const {
    const double a = (1.0 - t) * (1.0 - t), b = 2 * t * (1.0 - t), c = t * t;
    return {a * start.x + b * control.x + c * end.x, a * start.y + b * control.y + c * end.y};
  }
  // The handle of the same curve as a cubic, next to one of its ends.
  PagePoint handle(const PagePoint &at_end) const {
    return {(at_end.x + 2 * control.x) / 3, (at_end.y + 2 * control.y) / 3};
  }
};

// Takes the curves around a contour one after the other. `first` begins a contour, `closes` ends it: a line leads from
// the end of its last curve to the start of its first.
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

  // Calls visit(curve, first, closes) around the contours of one level of a path's body.
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
