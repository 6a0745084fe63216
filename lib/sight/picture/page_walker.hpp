// The common part of the writers of all formats: the walk over the page in painting order. Each path is followed by the
// contours along its silhouette; after all paths come their lines, if these are drawn apart.
#pragma once

#include "picture/byte_sink.hpp"
#include "picture/ink.hpp"
#include "picture/number_text.hpp"

namespace hsp {

// A writer has
//   path_level(path)                      the fog level that has to be set before a path; no_level: none
//   begin_level(level, before)            sets a level that differs from the one before
//   put_path(path)                        fills a path; put_contours follows if there is ink
//   put_lines(path, level)                draws the lines of a path; level: the one set, which it updates
//   contour_pen()                         a pen for contours
//   begin_contours(level, path), end_contours(level, path)  called around the contours of one ink level, if any
// and a pen begin(point), line_to(point), follow(arc) or for contours follow(curve, closes), and close().
template <class Writer>
class PageWalker {
 public:
  PageWalker(ByteSink &sink, const PictureInput &input, const PictureOptions &options, const Page &page,
             const Paint &paint)
      : sink_(sink), input_(input), options_(options), page_(page), paint_(paint), ink_(input, options, page, paint) {}

 protected:
  static constexpr uint32_t no_level = fog_levels + 1;

  // Returns the level that is set at the end.
  uint32_t walk_paths() {
    uint32_t level = no_level;
    for (uint32_t p = 0; p < input_.paths.size(); ++p) {
      change_level(writer().path_level(p), level);
      writer().put_path(p);
    }
    return level;
  }
  uint32_t walk_lines() {
    uint32_t level = no_level;
    for (uint32_t p = 0; paint_.own_lines() && p < input_.paths.size(); ++p) writer().put_lines(p, level);
    return level;
  }
  void change_level(uint32_t to, uint32_t &level) {
    if (to == level) return;
    writer().begin_level(to, level);
    level = to;
  }

  template <class Pen>
  void put_arcs(uint32_t path, PathPart part, Pen &&pen) const {
    input_.paths.visit(input_.balls, path, part, [&](const ProjectedArc &plane_arc, bool first, bool closes) {
      const PageArc arc = page_.to_page(plane_arc);
      if (first) pen.begin(arc.start);
      if (page_.is_line(arc)) {
        visit_line(arc, [&](const PagePoint &point) { pen.line_to(point); });
      } else {
        pen.follow(arc);
      }
      if (closes) pen.close();
    });
  }
  bool is_empty(uint32_t path, PathPart part) const {
    bool empty = true;
    input_.paths.visit(input_.balls, path, part, [&](const ProjectedArc &, bool, bool) { empty = false; });
    return empty;
  }

  void put_contours(uint32_t path) {
    if (!ink_.is_drawn()) return;
    for (const InkLevel level : ink_levels) {
      auto pen = writer().contour_pen();
      bool any = false;
      ink_.visit(path, level, [&](const InkCurve &curve, bool first, bool closes) {
        if (!any) writer().begin_contours(level, path);
        any = true;
        if (first) {
          pen.begin(curve.start);
        } else if (curve.behind_line) {
          pen.line_to(curve.start);
        }
        pen.follow(curve, closes);
      });
      if (any) writer().end_contours(level, path);
    }
  }

  // Not 0, as scales and radii of 0 would be errors.
  int64_t scaled_radius(uint32_t path, int decimals) const {
    const int64_t radius = scaled(input_.balls.r[input_.paths.ball_of(path)] * page_.scale, decimals);
    return radius > 0 ? radius : 1;
  }
  void put_number(double value, int decimals) {
    put_decimal(sink_, value, decimals);
    sink_.put(' ');
  }

  ByteSink &sink_;
  const PictureInput &input_;
  const PictureOptions &options_;
  const Page &page_;
  const Paint &paint_;
  const Ink ink_;

 private:
  Writer &writer() { return static_cast<Writer &>(*this); }
};

}  // namespace hsp
