#include "picture/writers.hpp"

#include "picture/escaped_text.hpp"
#include "picture/number_text.hpp"
#include "picture/page_walker.hpp"

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

class EpsWriter : private PageWalker<EpsWriter> {
  friend PageWalker<EpsWriter>;

 public:
  using PageWalker::PageWalker;

  void write() {
    put_head();
    put_prolog();
    put_page();
    sink_.put("showpage\n%%Trailer\nrestore end\n%%EOF\n");
  }

 private:
  struct Pen {
    EpsWriter &writer;
    int decimals = point_decimals;

    void begin(const PagePoint &point) { writer.put_point(point, "M\n", decimals); }
    void line_to(const PagePoint &point) { writer.put_point(point, "L\n", decimals); }
    void follow(const PageArc &arc) { writer.put_arc(arc); }
    void follow(const InkCurve &curve, bool closes) {
      writer.put_point(curve.handle(curve.start), "", decimals);
      writer.put_point(curve.handle(curve.end), "", decimals);
      writer.put_point(curve.end, closes ? "V Z\n" : "V\n", decimals);
    }
    void close() { writer.sink_.put("Z\n"); }
  };

  void put_point(const PagePoint &point, const char *command, int decimals = point_decimals) {
    put_number(point.x, decimals);
    put_number(point.y, decimals);
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
    walk_paths();
    if (paint_.own_lines()) sink_.put("1 setlinecap\n");
    walk_lines();
  }

  uint32_t path_level(uint32_t path) const { return paint_.lines_along() ? paint_.fog_level(path) : no_level; }
  void begin_level(uint32_t level, uint32_t) { put_packed(paint_.line_colour(level), " C\n"); }
  void put_path(uint32_t path) {
    put_arcs(path, PathPart::outline, Pen{*this});
    if (paint_.flat(path)) {
      put_packed(paint_.flat_colour(path), " F\n");
    } else {
      put_shaded(path);
    }
    put_contours(path);
  }
  void put_lines(uint32_t path, uint32_t &level) {
    change_level(paint_.fog_level(path), level);
    put_arcs(path, PathPart::lines, Pen{*this});
    sink_.put("stroke\n");
  }
  Pen contour_pen() { return {*this, page_.decimals}; }
  void begin_contours(InkLevel, uint32_t) {}
  void end_contours(InkLevel level, uint32_t path) { put_packed(ink_.colour(level, paint_.fog_level(path)), " J\n"); }

  void put_shaded(uint32_t path) {
    const PagePoint at = page_.centre_of(input_, path);
    put_number(at.x, 4);
    put_number(at.y, 4);
    put_scaled(sink_, scaled_radius(path, point_decimals), point_decimals);
    sink_.put(' ');
    put_integer(sink_, paint_.shade_of(path));
    sink_.put(" G\n");
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
};

}  // namespace

void write_eps(ByteSink &sink, const PictureInput &input, const PictureOptions &options, const Page &page,
               const Paint &paint) {
  EpsWriter(sink, input, options, page, paint).write();
}

}  // namespace hsp
