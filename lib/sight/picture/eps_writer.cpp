#include "picture/writers.hpp"

#include "picture/escaped_text.hpp"
#include "picture/number_text.hpp"

namespace hsp {
namespace {

// Of px: the six numbers of a matrix put an error of at most 1.7e-7 px into a point, those of two arcs 3.4e-7.
constexpr int point_decimals = 7;
// A rounded angle moves a point by at most this; with two arcs the sum is 8.4e-7 px.
constexpr double angle_error = 2.5e-7;
constexpr int finest_angle = 12;

// Lines of a PostScript file that follow the conventions are at most 255 characters long.
constexpr uint32_t text_per_line = 120;

// Colours are integers 16#rrggbb or, one for each stop, bytes of a string.
//   n P r g b           n C -             set the colour
//   x y M, x y L, Z     the path's corners
//   x y r t u A         arc of a circle counter-clockwise, degrees; B: clockwise
//   t u [matrix] E      arc of the unit circle under a matrix; D: clockwise
//   n F                 fill and line     x y r k G   the same with shade k of the table T
//   k s S               put the shade with stops s into T
//   x y x y x y V       a cubic           n J            fill, without a line
constexpr char procedures[] =
    "/M{moveto}bind def/L{lineto}bind def/Z{closepath}bind def/A{arc}bind def/B{arcn}bind def\n"
    "/m matrix def\n"
    "/U{m currentmatrix 4 1 roll concat 0 0 1 5 3 roll}bind def\n"
    "/E{U arc setmatrix}bind def/D{U arcn setmatrix}bind def\n"
    "/P{3{dup 255 and 255 div exch -8 bitshift}repeat pop 3 1 roll exch}bind def\n"
    "/C{P setrgbcolor}bind def\n"
    "/F{gsave C fill grestore I}bind def\n";
constexpr char ink_procedure[] = "/V{curveto}bind def/J{gsave C fill grestore newpath}bind def\n";
constexpr char shade_procedures[] =
    "/K{3 mul s exch 3 getinterval[exch{255 div}forall]}bind def\n"
    "/S{/s exch def T exch<</ShadingType 3/ColorSpace/DeviceRGB/Coords[f 0 0 0 1]/Extend[true true]\n"
    "/Function<</FunctionType 3/Domain[0 1]/Bounds b/Encode[n{0 1}repeat]/Functions[0 1 n 1 sub{/k exch def\n"
    "<</FunctionType 2/Domain[0 1]/N 1/C0 k K/C1 k 1 add K>>}for]>>>>put}bind def\n"
    "/G{T exch get 4 1 roll gsave clip 3 1 roll translate dup scale shfill grestore I}bind def\n";

class EpsWriter {
 public:
  EpsWriter(ByteSink &sink, const PictureInput &input, const PictureOptions &options, const Page &page,
            const Paint &paint)
      : sink_(sink), input_(input), options_(options), page_(page), paint_(paint), ink_(input, options, page, paint) {}

  void write() {
    put_head();
    put_prolog();
    put_page();
    sink_.put("showpage\n%%Trailer\nrestore end\n%%EOF\n");
  }

 private:
  void put_number(double value, int decimals) {
    put_decimal(sink_, value, decimals);
    sink_.put(' ');
  }
  void put_point(const PagePoint &point, const char *command) {
    put_number(point.x, point_decimals);
    put_number(point.y, point_decimals);
    sink_.put(command);
  }
  void put_packed(uint32_t colour, const char *command) {
    sink_.put("16#");
    put_colour(sink_, colour);
    sink_.put(command);
  }
  static uint64_t rounded_up(double length) {
    const uint64_t whole = static_cast<uint64_t>(length);
    return static_cast<double>(whole) < length ? whole + 1 : whole;
  }

  void put_head() {
    const double width = page_.width * points_per_px;
    const double height = page_.height * points_per_px;
    sink_.put("%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 ");
    put_integer(sink_, rounded_up(width));
    sink_.put(' ');
    put_integer(sink_, rounded_up(height));
    sink_.put("\n%%HiResBoundingBox: 0 0 ");
    put_number(width, 6);
    put_decimal(sink_, height, 6);
    sink_.put('\n');
    if (!is_blank(input_.title)) {
      const char *rest = input_.title;
      for (sink_.put("%%Title: "); *rest != '\0'; sink_.put(*rest == '\0' ? "" : "%%+ ")) {
        rest = put_parenthesized(sink_, rest, text_per_line);
        sink_.put('\n');
      }
    }
    sink_.put("%%Creator: hardsphere\n%%LanguageLevel: 3\n%%Pages: 1\n%%EndComments\n");
    if (is_blank(input_.description)) return;
    for (const char *rest = input_.description; *rest != '\0'; sink_.put('\n')) {
      sink_.put("% ");
      for (uint32_t k = 0; k < text_per_line && *rest != '\0'; ++k) sink_.put(next_ascii(rest));
    }
  }

  void put_prolog() {
    sink_.put("%%BeginProlog\n/hardsphere 32 dict def hardsphere begin\n");
    sink_.put(procedures);
    sink_.put(paint_.lines_along() ? "/I{stroke}bind def\n" : "/I{newpath}bind def\n");
    if (ink_.is_drawn()) sink_.put(ink_procedure);
    if (!paint_.flat()) put_shading();
    sink_.put("%%EndProlog\n");
  }

  void put_shading() {
    const Shading &shading = paint_.shading();
    sink_.put("/n ");
    put_integer(sink_, shading.intervals());
    sink_.put(" def/f{");
    put_number(shading.focus_x(), 3);
    put_decimal(sink_, shading.focus_y(), 3);
    sink_.put("}def/b[");
    for (uint32_t stop = 1; stop < shading.intervals(); ++stop) put_number(shading.offset(stop), 6);
    sink_.put("]def\n");
    sink_.put(shade_procedures);
    sink_.put("/T ");
    put_integer(sink_, paint_.shades());
    sink_.put(" array def\n");
    for (uint32_t s = 0; s < paint_.shades(); ++s) {
      put_integer(sink_, s);
      sink_.put('<');
      for (uint32_t stop = 0; stop <= shading.intervals(); ++stop) put_colour(sink_, paint_.shade_colour(s, stop));
      sink_.put(">S\n");
    }
  }

  void put_page() {
    sink_.put("%%Page: 1 1\nsave\n.75 dup scale 1 setlinejoin ");
    put_number(page_.line, 4);
    sink_.put("setlinewidth\n");
    if (page_.cut) {
      sink_.put("0 0 ");
      put_number(page_.width, 6);
      put_number(page_.height, 6);
      sink_.put("rectclip\n");
    }
    if (options_.backdrop) {
      put_packed(paint_.background(), " C 0 0 ");
      put_number(page_.width, 6);
      put_number(page_.height, 6);
      sink_.put("rectfill\n");
    }
    uint32_t level = fog_levels + 1;  // of the colour in use, or of none
    for (uint32_t p = 0; p < input_.paths.size(); ++p) {
      if (paint_.lines_along()) put_line_colour(p, level);
      put_path(p, PathPart::outline);
      if (paint_.flat(p)) {
        put_packed(paint_.flat_colour(p), " F\n");
      } else {
        put_shaded(p);
      }
      if (ink_.is_drawn()) put_ink(p);
    }
    if (paint_.own_lines()) sink_.put("1 setlinecap\n");
    level = fog_levels + 1;
    for (uint32_t p = 0; paint_.own_lines() && p < input_.paths.size(); ++p) {
      put_line_colour(p, level);
      put_path(p, PathPart::lines);
      sink_.put("stroke\n");
    }
  }

  // level: that of the colour in use.
  void put_line_colour(uint32_t path, uint32_t &level) {
    if (paint_.fog_level(path) == level) return;
    level = paint_.fog_level(path);
    put_packed(paint_.line_colour(level), " C\n");
  }

  void put_shaded(uint32_t path) {
    const uint32_t ball = input_.paths.ball_of(path);
    const PagePoint at = page_.centre_of(input_, path);
    put_number(at.x, 4);
    put_number(at.y, 4);
    // A scale of 0 would be an error.
    const int64_t radius = scaled(input_.balls.r[ball] * page_.scale, point_decimals);
    put_scaled(sink_, radius > 0 ? radius : 1, point_decimals);
    sink_.put(' ');
    put_integer(sink_, paint_.shade_of(path));
    sink_.put(" G\n");
  }

  void put_path(uint32_t path, PathPart part) {
    input_.paths.visit(input_.balls, path, part, [&](const ProjectedArc &arc, bool first, bool closes) {
      put_next(page_.place(arc), first, closes);
    });
  }
  void put_next(const PageArc &arc, bool first, bool closes) {
    if (first) put_point(arc.start, "M\n");
    if (page_.is_line(arc)) {
      visit_line(arc, [&](const PagePoint &point) { put_point(point, "L\n"); });
    } else {
      put_arc(arc);
    }
    if (closes) sink_.put("Z\n");
  }

  void put_ink(uint32_t path) {
    for (const InkLevel level : ink_levels) {
      bool any = false;
      ink_.visit(path, level, [&](const InkCurve &curve, bool first, bool closes) {
        if (first) put_ink_point(curve.start, "M\n");
        if (curve.behind_line) put_ink_point(curve.start, "L\n");
        put_ink_point(curve.handle(curve.start), "");
        put_ink_point(curve.handle(curve.end), "");
        put_ink_point(curve.end, closes ? "V Z\n" : "V\n");
        any = true;
      });
      if (any) put_packed(ink_.colour(level, paint_.fog_level(path)), " J\n");
    }
  }
  void put_ink_point(const PagePoint &point, const char *command) {
    put_number(point.x, page_.decimals);
    put_number(point.y, page_.decimals);
    sink_.put(command);
  }

  void put_arc(const PageArc &arc) {
    const double degree = arc.semi_axis[0] * (pi / 180.0);
    const int decimals = decimals_for(2 * angle_error / degree, 0, finest_angle);
    const double from = arc.from * (180.0 / pi);
    const double to = arc.to * (180.0 / pi);
    const bool forward = arc.to > arc.from;
    if (arc.circle) {
      put_point(arc.centre, "");
      put_number(arc.semi_axis[0], point_decimals);
      put_number(from, decimals);
      put_number(to, decimals);
      sink_.put(forward ? "A\n" : "B\n");
      return;
    }
    put_number(from, decimals);
    put_decimal(sink_, to, decimals);
    sink_.put('[');
    put_point(arc.major, "");
    put_point(arc.minor, "");
    put_point(arc.centre, forward ? "]E\n" : "]D\n");
  }

  ByteSink &sink_;
  const PictureInput &input_;
  const PictureOptions &options_;
  const Page &page_;
  const Paint &paint_;
  const Ink ink_;
};

}  // namespace

void write_eps(ByteSink &sink, const PictureInput &input, const PictureOptions &options, const Page &page,
               const Paint &paint) {
  EpsWriter(sink, input, options, page, paint).write();
}

}  // namespace hsp
