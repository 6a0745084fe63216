#include "picture/writers.hpp"

#include "core/elementary.hpp"
#include "picture/escaped_text.hpp"
#include "picture/number_text.hpp"

namespace hsp {
namespace {

// Arcs given by their ends are badly conditioned near half a turn.
constexpr double longest_span = 0.9 * pi;

constexpr int finest_decimals = 10;

class SvgWriter {
 public:
  SvgWriter(ByteSink &sink, const PictureInput &input, const PictureOptions &options, const Page &page,
            const Paint &paint)
      : sink_(sink), input_(input), options_(options), page_(page), paint_(paint), ink_(input, options, page, paint) {}

  void write() {
    put_head();
    if (!paint_.flat()) put_gradients();
    put_paths();
    if (paint_.own_lines()) put_lines();
    sink_.put("</svg>\n");
  }

 private:
  void put_attribute(const char *name, double value, int decimals) {
    sink_.put(name);
    sink_.put("=\"");
    put_decimal(sink_, value, decimals);
    sink_.put('"');
  }
  void put_paint(const char *name, uint32_t colour) {
    sink_.put(name);
    sink_.put("=\"#");
    put_colour(sink_, colour);
    sink_.put('"');
  }
  void put_element(const char *name, const char *text) {
    if (is_blank(text)) return;
    sink_.put('<');
    sink_.put(name);
    sink_.put('>');
    put_xml_text(sink_, text);
    sink_.put("</");
    sink_.put(name);
    sink_.put(">\n");
  }
  void put_length(const char *name, double length) {
    sink_.put(name);
    sink_.put("=\"");
    put_decimal(sink_, length / page_.unit, 6);
    sink_.put(options_.millimetres ? "mm\"" : "px\"");
  }

  void put_head() {
    sink_.put("<svg xmlns=\"http://www.w3.org/2000/svg\"");
    if (!paint_.flat()) sink_.put(" xmlns:xlink=\"http://www.w3.org/1999/xlink\"");
    put_length(" width", page_.width);
    put_length(" height", page_.height);
    sink_.put(" viewBox=\"0 0 ");
    put_decimal(sink_, page_.width, 6);
    sink_.put(' ');
    put_decimal(sink_, page_.height, 6);
    sink_.put("\">\n");
    put_element("title", input_.title);
    put_element("desc", input_.description);
    if (!options_.backdrop) return;
    put_attribute("<rect width", page_.width, 6);
    put_attribute(" height", page_.height, 6);
    put_paint(" fill", paint_.background());
    sink_.put("/>\n");
  }

  // What gradients in the file depend on. Pictures beside each other in one page share their names only if they share
  // what is named.
  uint32_t key_of_gradients() const {
    constexpr uint64_t offset_basis = 0xCBF29CE484222325u;  // Fowler, Noll and Vo: FNV-1a
    constexpr uint64_t prime = 0x100000001B3u;
    uint64_t key = offset_basis;
    const auto add = [&key](uint64_t value) {
      for (int byte = 0; byte < 8; ++byte, value >>= 8) key = (key ^ (value & 0xFF)) * prime;
    };
    for (uint32_t s = 0; s < paint_.shades(); ++s) {
      for (uint32_t stop = 0; stop <= paint_.shading().intervals(); ++stop) add(paint_.shade_colour(s, stop));
    }
    for (uint32_t p = 0; p < input_.paths.size(); ++p) {
      if (paint_.flat(p)) continue;
      const Disc disc = disc_of(p);
      add(paint_.shade_of(p));
      add(static_cast<uint64_t>(disc.x));
      add(static_cast<uint64_t>(disc.y));
      add(static_cast<uint64_t>(disc.radius));
    }
    return static_cast<uint32_t>(key >> 40);
  }
  void put_name(char kind, uint32_t number) {
    sink_.put(kind);
    put_colour(sink_, names_);
    sink_.put('-');
    put_integer(sink_, number);
  }

  // Where a path's ball is, y down, in units of the last decimal.
  struct Disc {
    int64_t x, y, radius;
  };
  Disc disc_of(uint32_t path) const {
    const PagePoint at = page_.centre_of(input_, path);
    const int64_t radius = scaled(input_.balls.r[input_.paths.ball_of(path)] * page_.scale, page_.decimals);
    // Renderers fail on a radius of 0.
    return {scaled(at.x, page_.decimals), scaled(page_.height - at.y, page_.decimals), radius > 0 ? radius : 1};
  }
  void put_place(const char *name, int64_t place) {
    sink_.put(name);
    sink_.put("=\"");
    put_scaled(sink_, place, page_.decimals);
    sink_.put('"');
  }

  // The stops of each shade, and a gradient for each ball that refers to them. It holds all else itself: not every
  // renderer takes over more than stops.
  void put_gradients() {
    const Shading &shading = paint_.shading();
    names_ = key_of_gradients();
    sink_.put("<defs>\n");
    for (uint32_t s = 0; s < paint_.shades(); ++s) {
      sink_.put("<radialGradient id=\"");
      put_name('g', s);
      sink_.put("\">");
      for (uint32_t stop = 0; stop <= shading.intervals(); ++stop) {
        put_attribute("<stop offset", shading.offset(stop), 6);
        put_paint(" stop-color", paint_.shade_colour(s, stop));
        sink_.put("/>");
      }
      sink_.put("</radialGradient>\n");
    }
    for (uint32_t p = 0; p < input_.paths.size(); ++p) {
      if (paint_.flat(p)) continue;
      const Disc disc = disc_of(p);
      sink_.put("<radialGradient id=\"");
      put_name('b', p);
      sink_.put("\" xlink:href=\"#");
      put_name('g', paint_.shade_of(p));
      sink_.put("\" gradientUnits=\"userSpaceOnUse\"");
      put_place(" cx", disc.x);
      put_place(" cy", disc.y);
      put_place(" r", disc.radius);
      if (shading.focus_x() != 0.0 || shading.focus_y() != 0.0) {
        put_place(" fx", disc.x + moved(disc.radius, shading.focus_x()));
        put_place(" fy", disc.y - moved(disc.radius, shading.focus_y()));
      }
      sink_.put("/>\n");
    }
    sink_.put("</defs>\n");
  }
  static int64_t moved(int64_t radius, double share) { return scaled(static_cast<double>(radius) * share, 0); }

  void put_stroke(uint32_t level) {
    put_paint(" stroke", paint_.line_colour(level));
    put_line_shape();
  }
  void put_line_shape() {
    put_attribute(" stroke-width", page_.line, 4);
    sink_.put(" stroke-linejoin=\"round\"");
  }

  // Ends the open group, of level `open`, and begins that of `level`. False if they are the same.
  bool changes_group(uint32_t level, uint32_t &open) {
    if (level == open) return false;
    end_group(open);
    open = level;
    sink_.put("<g");
    return true;
  }
  void end_group(uint32_t open) {
    if (open <= fog_levels) sink_.put("</g>\n");
  }

  // A group of its own for each colour of lines along the paths, or of contours, which are filled and have no lines.
  void put_paths() {
    uint32_t open = fog_levels + 1;  // the group's level, or none
    for (uint32_t p = 0; p < input_.paths.size(); ++p) {
      const uint32_t level = paint_.lines_along() || ink_.is_drawn() ? paint_.fog_level(p) : 0;
      if (changes_group(level, open)) {
        if (ink_.is_drawn()) {
          put_paint(" fill", ink_.colour(InkLevel::border, level));
          if (paint_.lines_along()) put_line_shape();
        } else if (paint_.lines_along()) {
          put_stroke(level);
        }
        sink_.put(">\n");
      }
      sink_.put("<path");
      if (options_.ids) {
        sink_.put(" data-ball=\"");
        put_integer(sink_, input_.balls.caller[input_.paths.ball_of(p)]);
        sink_.put('"');
      }
      if (paint_.flat(p)) {
        put_paint(" fill", paint_.flat_colour(p));
      } else {
        sink_.put(" fill=\"url(#");
        put_name('b', p);
        sink_.put(")\"");
      }
      if (ink_.is_drawn() && paint_.lines_along()) put_paint(" stroke", paint_.line_colour(level));
      sink_.put(" d=\"");
      put_arcs(p, PathPart::outline);
      sink_.put("\"/>\n");
      if (ink_.is_drawn()) put_ink(p);
    }
    end_group(open);
  }

  // Whoever clicks on a line clicks on the path below.
  void put_lines() {
    uint32_t open = fog_levels + 1;
    for (uint32_t p = 0; p < input_.paths.size(); ++p) {
      bool any = false;
      input_.paths.visit(input_.balls, p, PathPart::lines, [&](const ProjectedArc &, bool, bool) { any = true; });
      if (!any) continue;
      if (changes_group(paint_.fog_level(p), open)) {
        sink_.put(" fill=\"none\" pointer-events=\"none\"");
        put_stroke(open);
        sink_.put(" stroke-linecap=\"round\">\n");
      }
      sink_.put("<path d=\"");
      put_arcs(p, PathPart::lines);
      sink_.put("\"/>\n");
    }
    end_group(open);
  }

  // A renderer finds the centre of an arc from its ends. Rounding these by u moves the centre of an ellipse with
  // semi-axes a > b along the major axis by about u a / b, hence the finer the flatter the ellipse.
  int decimals_of(uint32_t path, PathPart part) const {
    int decimals = page_.decimals;
    input_.paths.visit(input_.balls, path, part, [&](const ProjectedArc &plane_arc, bool, bool) {
      const PageArc arc = page_.place(plane_arc);
      if (page_.is_line(arc)) return;
      const double flatness = arc.semi_axis[1] / arc.semi_axis[0];
      decimals = decimals_for((flatness < 1.0 ? flatness : 1.0) / 10, decimals, finest_decimals);
    });
    return decimals;
  }

  void put_arcs(uint32_t path, PathPart part) {
    const int decimals = decimals_of(path, part);
    input_.paths.visit(input_.balls, path, part, [&](const ProjectedArc &arc, bool first, bool closes) {
      put_next(page_.place(arc), first, closes, decimals);
    });
  }
  void put_next(const PageArc &arc, bool first, bool closes, int decimals) {
    if (first) {
      sink_.put('M');
      put_point(arc.start, decimals);
    }
    if (page_.is_line(arc)) {
      visit_line(arc, [&](const PagePoint &point) {
        sink_.put('L');
        put_point(point, decimals);
      });
    } else {
      put_arc(arc, decimals);
    }
    if (closes) sink_.put('Z');
  }

  // Whoever clicks on ink clicks on the ball below.
  void put_ink(uint32_t path) {
    static constexpr const char *class_of[] = {"border", "group", "depth"};
    for (const InkLevel level : ink_levels) {
      bool any = false;
      ink_.visit(path, level, [&](const InkCurve &curve, bool first, bool closes) {
        if (!any) {
          sink_.put("<path class=\"");
          sink_.put(class_of[static_cast<uint32_t>(level)]);
          sink_.put('"');
          const uint32_t colour = ink_.colour(level, paint_.fog_level(path));
          if (colour != ink_.colour(InkLevel::border, paint_.fog_level(path))) put_paint(" fill", colour);
          sink_.put(" d=\"");
          any = true;
        }
        put_curve(curve, first);
        if (closes) sink_.put('Z');
      });
      if (any) sink_.put("\"/>\n");
    }
  }

  // By steps from the place of the pen, which are shorter.
  void put_curve(const InkCurve &curve, bool first) {
    const Place start = place_of(curve.start);
    if (first) {
      sink_.put('M');
      put_scaled(sink_, start.x, page_.decimals);
      put_step(start.y);
    } else if (curve.behind_line) {
      sink_.put('l');
      put_step_to(start);
    }
    pen_ = start;
    sink_.put('q');
    put_step_to(place_of(curve.control));
    const Place end = place_of(curve.end);
    if (end.x >= pen_.x) sink_.put(' ');
    put_step_to(end);
    pen_ = end;
  }
  // y down, in units of the last decimal.
  struct Place {
    int64_t x, y;
  };
  Place place_of(const PagePoint &point) const {
    return {scaled(point.x, page_.decimals), scaled(page_.height - point.y, page_.decimals)};
  }
  void put_step_to(const Place &place) {
    put_scaled(sink_, place.x - pen_.x, page_.decimals);
    put_step(place.y - pen_.y);
  }
  // Behind another number.
  void put_step(int64_t step) {
    if (step >= 0) sink_.put(' ');
    put_scaled(sink_, step, page_.decimals);
  }

  void put_point(const PagePoint &point, int decimals) {
    put_decimal(sink_, point.x, decimals);
    sink_.put(' ');
    put_decimal(sink_, page_.height - point.y, decimals);
  }

  // Counter-clockwise with y up is sweep 0 with y down. No part is longer than half a turn, hence no large arc.
  void put_arc(const PageArc &arc, int decimals) {
    double rotation = 0.0;
    if (!arc.circle) {
      rotation = arc_tangent(-arc.major.y, arc.major.x) * (180.0 / pi);
      rotation += rotation > 90.0 ? -180.0 : rotation <= -90.0 ? 180.0 : 0.0;
    }
    // The ends of the major axis shall move as little as by the rounding of the points.
    const double step = 60.0 / (arc.semi_axis[0] * power_of_ten[decimals]);
    const int rotation_decimals = decimals_for(step, 0, finest_decimals);
    const uint32_t parts = parts_of(arc.span(), longest_span);
    for (uint32_t k = 1; k <= parts; ++k) {
      sink_.put('A');
      put_decimal(sink_, arc.semi_axis[0], decimals);
      sink_.put(' ');
      put_decimal(sink_, arc.semi_axis[1], decimals);
      sink_.put(' ');
      put_decimal(sink_, rotation, rotation_decimals);
      sink_.put(arc.to > arc.from ? " 0 0 " : " 0 1 ");
      put_point(k == parts ? arc.end : arc.at(arc.from + (arc.to - arc.from) * k / parts), decimals);
    }
  }

  ByteSink &sink_;
  const PictureInput &input_;
  const PictureOptions &options_;
  const Page &page_;
  const Paint &paint_;
  const Ink ink_;
  Place pen_{0, 0};
  uint32_t names_ = 0;  // 24 bits that gradients' names begin with
};

}  // namespace

void write_svg(ByteSink &sink, const PictureInput &input, const PictureOptions &options, const Page &page,
               const Paint &paint) {
  SvgWriter(sink, input, options, page, paint).write();
}

}  // namespace hsp
