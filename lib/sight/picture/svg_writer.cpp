#include "picture/writers.hpp"

#include <cstring>

#include "picture/escaped_text.hpp"
#include "picture/page_walker.hpp"
#include "picture/svg_path.hpp"

namespace hsp {
namespace {

// Names begin with a number below the fourth power of the count of digits and letters.
constexpr uint32_t name_digits = 62;
constexpr uint32_t different_names = name_digits * name_digits * name_digits * name_digits;

class SvgWriter : private PageWalker<SvgWriter> {
  friend PageWalker<SvgWriter>;

 public:
  using PageWalker::PageWalker;

  void write() {
    put_head();
    if (!paint_.flat() || input_.atom_class != nullptr) names_ = key_of_names();
    if (!paint_.flat()) put_gradients();
    end_group(walk_paths());
    end_group(walk_lines());
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
  void put_element(const char *name, const char *text, const char *behind) {
    if (is_blank(text)) return;
    sink_.put('<');
    sink_.put(name);
    sink_.put('>');
    put_xml_text(sink_, text);
    sink_.put("</");
    sink_.put(name);
    sink_.put('>');
    sink_.put(behind);
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
    sink_.put("\" role=\"img\">\n");
    put_element("title", input_.title, "\n");
    put_element("desc", input_.description, "\n");
    if (!options_.backdrop) return;
    put_attribute("<rect width", page_.width, 6);
    put_attribute(" height", page_.height, 6);
    put_paint(" fill", paint_.background());
    sink_.put("/>\n");
  }

  // A hash of all data that named things depend on, as they are rounded in the file. So pictures on one page share
  // names only if they share the things named: light, paths and balls.
  uint32_t key_of_names() const {
    constexpr uint64_t offset_basis = 0xCBF29CE484222325u;  // Fowler, Noll and Vo: FNV-1a
    constexpr uint64_t prime = 0x100000001B3u;
    uint64_t key = offset_basis;
    const auto add = [&key](uint64_t value) {
      for (int byte = 0; byte < 8; ++byte, value >>= 8) key = (key ^ (value & 0xFF)) * prime;
    };
    const auto add_number = [&add](double value) {
      uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      add(bits);
    };
    const auto add_rounded = [&](double px) { add(static_cast<uint64_t>(scaled(px, page_.decimals))); };
    add(static_cast<uint64_t>(options_.style));
    add(paint_.background());
    add_number(options_.fog);
    add(static_cast<uint64_t>(scaled(page_.line, 4)));
    for (uint32_t p = 0; p < input_.paths.size(); ++p) {
      const Disc disc = disc_of(p);
      add(paint_.fog_level(p));
      add(input_.colour_of(input_.paths.ball_of(p)));
      add_rounded(disc.centre.x);
      add_rounded(disc.centre.y);
      add_rounded(disc.radius);
      if (paint_.flat(p)) continue;
      input_.paths.visit(input_.balls, p, PathPart::outline, [&](const ProjectedArc &arc, bool, bool) {
        const PagePoint start = page_.to_page(arc.start);
        add_rounded(start.x);
        add_rounded(start.y);
        add_rounded(arc.ellipse.centre[0] * page_.scale);
      });
    }
    return static_cast<uint32_t>((key >> 32) % different_names);
  }
  // Names are short, as each ball has up to four of them.
  void put_name(char kind, uint32_t number) {
    sink_.put(kind);
    for (uint32_t weight = different_names / name_digits; weight > 0; weight /= name_digits) {
      const uint32_t digit = names_ / weight % name_digits;
      sink_.put(static_cast<char>(digit < 10 ? '0' + digit : digit < 36 ? 'A' + (digit - 10) : 'a' + (digit - 36)));
    }
    sink_.put('-');
    put_integer(sink_, number);
  }

  // A path's ball.
  struct Disc {
    PagePoint centre;
    double radius;
  };
  Disc disc_of(uint32_t path) const {
    const double radius = input_.balls.r[input_.paths.ball_of(path)] * page_.scale;
    // Renderers fail on a radius of 0.
    const double least = 1.0 / power_of_ten[page_.decimals];
    return {page_.centre_of(input_, path), radius > least ? radius : least};
  }
  SvgFrame frame_of_page() const { return {{0.0, page_.height}, 1.0}; }
  // The decimals of numbers in a frame that make steps like those of the page.
  int decimals_in(const SvgFrame &frame) const {
    return decimals_for(1.0 / (frame.unit * power_of_ten[page_.decimals]), 0, finest_svg_decimals);
  }

  // The light of each fog level on a ball of radius 1. Each gradient is written in full: not every renderer lets
  // gradients share stops.
  void put_gradients() {
    const Shading &shading = paint_.shading();
    uint32_t seen = 0;
    for (uint32_t p = 0; p < input_.paths.size(); ++p) {
      if (!paint_.flat(p)) seen |= UINT32_C(1) << paint_.fog_level(p);
    }
    sink_.put("<defs>\n");
    for (uint32_t level = 0; level <= fog_levels; ++level) {
      if ((seen >> level & 1) == 0) continue;
      sink_.put("<radialGradient id=\"");
      put_name('g', level);
      sink_.put("\" gradientUnits=\"userSpaceOnUse\" cx=\"0\" cy=\"0\" r=\"1\"");
      if (shading.focus_x() != 0.0 || shading.focus_y() != 0.0) {
        put_attribute(" fx", shading.focus_x(), 4);
        put_attribute(" fy", -shading.focus_y(), 4);
      }
      sink_.put('>');
      for (uint32_t stop = 0; stop <= shading.intervals(); ++stop) {
        const Shading::Glaze glaze = paint_.glaze(level, stop);
        put_attribute("<stop offset", shading.offset(stop), 6);
        put_paint(" stop-color", hsp::packed(glaze.colour));
        put_attribute(" stop-opacity", glaze.opacity, 4);
        sink_.put("/>");
      }
      sink_.put("</radialGradient>\n");
    }
    sink_.put("</defs>\n");
  }

  void put_stroke(uint32_t level) {
    put_paint(" stroke", paint_.line_colour(level));
    put_line_shape();
  }
  void put_line_shape() {
    put_attribute(" stroke-width", page_.line, 4);
    sink_.put(" stroke-linejoin=\"round\"");
  }

  void end_group(uint32_t open) {
    if (open != no_level) sink_.put("</g>\n");
  }

  // A ball with classes has its number in an id, so that links find it, too. The halves of sticks have none, as a ball
  // may have several.
  void put_ball(uint32_t path) {
    const uint32_t ball = input_.paths.ball_of(path);
    const bool has_class = !is_blank(input_.class_of(ball));
    if (options_.ids && has_class && !input_.paths.is_plain(path)) {
      sink_.put(" id=\"");
      put_name('a', input_.balls.caller[ball]);
      sink_.put('"');
    } else if (options_.ids) {
      sink_.put(" data-ball=\"");
      put_integer(sink_, input_.balls.caller[ball]);
      sink_.put('"');
    }
    if (!has_class) return;
    sink_.put(" class=\"");
    put_xml_text(sink_, input_.class_of(ball));
    sink_.put('"');
  }
  // Text that browsers show beside the pointer.
  void put_title(uint32_t path) { put_element("title", input_.title_of(input_.paths.ball_of(path)), ""); }
  // Puts the stroke of a path, unless a group has set it.
  void put_own_stroke(uint32_t level) {
    const bool groups_say_it = paint_.flat() && !ink_.is_drawn();
    if (paint_.lines_along() && !groups_say_it) put_paint(" stroke", paint_.line_colour(level));
  }

  void put_flat(uint32_t path, uint32_t level) {
    const Shape shape = shape_of(path, frame_of_page());
    put_shape(shape);
    put_ball(path);
    put_paint(" fill", paint_.flat_colour(path));
    put_own_stroke(level);
    put_outline(path, shape);
    if (is_blank(input_.title_of(input_.paths.ball_of(path)))) {
      sink_.put("/>\n");
      return;
    }
    sink_.put('>');
    put_title(path);
    sink_.put(shape.disc ? "</circle>\n" : "</path>\n");
  }

  // A group has the ball's colour; in it is the ball's outline, and the same outline with light over it. So another
  // colour of the group keeps the light. Lines belong to the outline with light. The ball's disc is the unit circle
  // around the origin.
  void put_lit(uint32_t path, uint32_t level) {
    const Disc disc = disc_of(path);
    sink_.put("<g");
    put_ball(path);
    put_paint(" fill", paint_.unlit_colour(path));
    sink_.put(" transform=\"translate(");
    put_decimal(sink_, disc.centre.x, page_.decimals);
    sink_.put(' ');
    put_decimal(sink_, page_.height - disc.centre.y, page_.decimals);
    sink_.put(")scale(");
    put_decimal(sink_, disc.radius, page_.decimals);
    sink_.put(")\">");
    put_title(path);
    const Shape shape = shape_of(path, {disc.centre, disc.radius});
    put_shape(shape);
    sink_.put(" id=\"");
    put_name('p', path);
    sink_.put('"');
    put_outline(path, shape);
    sink_.put("/><use xlink:href=\"#");
    put_name('p', path);
    sink_.put("\" fill=\"url(#");
    put_name('g', paint_.fog_level(path));
    sink_.put(")\"");
    if (paint_.lines_along()) {
      put_paint(" stroke", paint_.line_colour(level));
      put_attribute(" stroke-width", page_.line / disc.radius,
                    decimals_for(1e-4 / disc.radius, 0, finest_svg_decimals));
    }
    sink_.put("/></g>\n");
  }

  // There is a group for each colour of lines along the paths, or of contours, which are filled and have no lines.
  uint32_t path_level(uint32_t path) const {
    return paint_.lines_along() || ink_.is_drawn() ? paint_.fog_level(path) : 0;
  }
  // Ends the group of level `open`, and begins one of another level.
  void begin_level(uint32_t level, uint32_t open) {
    end_group(open);
    sink_.put("<g");
    if (lines_) {
      sink_.put(" fill=\"none\" pointer-events=\"none\"");
      put_stroke(level);
      sink_.put(" stroke-linecap=\"round\"");
    } else if (ink_.is_drawn()) {
      put_paint(" fill", ink_.colour(InkLevel::border, level));
      if (paint_.lines_along()) put_line_shape();
    } else if (paint_.lines_along() && paint_.flat()) {
      put_stroke(level);
    } else if (paint_.lines_along()) {
      put_line_shape();
    }
    sink_.put(">\n");
  }
  void put_path(uint32_t path) {
    if (paint_.flat(path)) {
      put_flat(path, path_level(path));
    } else {
      put_lit(path, path_level(path));
    }
    put_contours(path);
  }

  // A click on a line goes to the path below.
  void put_lines(uint32_t path, uint32_t &level) {
    lines_ = true;
    if (is_empty(path, PathPart::lines)) return;
    change_level(paint_.fog_level(path), level);
    sink_.put("<path d=\"");
    put_data(path, PathPart::lines, frame_of_page());
    sink_.put("\"/>\n");
  }

  // A renderer finds the centre of an arc from its ends. If these are rounded by u, the centre of an ellipse with
  // semi-axes a > b moves along the major axis by about u a / b. So flatter ellipses need more decimals.
  int decimals_of(uint32_t path, PathPart part, const SvgFrame &frame) const {
    int decimals = decimals_in(frame);
    input_.paths.visit(input_.balls, path, part, [&](const ProjectedArc &plane_arc, bool, bool) {
      const PageArc arc = page_.to_page(plane_arc);
      if (page_.is_line(arc)) return;
      const double flatness = arc.semi_axis[1] / arc.semi_axis[0];
      decimals = decimals_for((flatness < 1.0 ? flatness : 1.0) / (10 * frame.unit), decimals, finest_svg_decimals);
    });
    return decimals;
  }

  // The kind of a path's outline in some frame: a whole circle, or anything else.
  struct Shape {
    SvgFrame frame;
    bool disc;
    PagePoint centre;
    double radius;
  };
  Shape shape_of(uint32_t path, const SvgFrame &frame) const {
    Shape shape{frame, false, {0.0, 0.0}, 0.0};
    uint32_t arcs = 0;
    input_.paths.visit(input_.balls, path, PathPart::outline,
                       [&](const ProjectedArc &plane_arc, bool first, bool closes) {
                         const PageArc arc = page_.to_page(plane_arc);
                         shape.disc = ++arcs == 1 && first && closes && arc.circle;
                         shape.centre = arc.centre;
                         shape.radius = arc.semi_axis[0];
                       });
    return shape;
  }
  void put_shape(const Shape &shape) { sink_.put(shape.disc ? "<circle" : "<path"); }
  void put_outline(uint32_t path, const Shape &shape) {
    const SvgFrame &frame = shape.frame;
    if (!shape.disc) {
      sink_.put(" d=\"");
      put_data(path, PathPart::outline, frame);
      sink_.put('"');
      return;
    }
    const int decimals = decimals_in(frame);
    put_coordinate(" cx", (shape.centre.x - frame.origin.x) / frame.unit, decimals);
    put_coordinate(" cy", (frame.origin.y - shape.centre.y) / frame.unit, decimals);
    put_attribute(" r", shape.radius / frame.unit, decimals);
  }
  // A coordinate that is left out is 0.
  void put_coordinate(const char *name, double value, int decimals) {
    if (scaled(value, decimals) != 0) put_attribute(name, value, decimals);
  }

  struct Pen {
    SvgPath data;
    int circle_decimals;

    void begin(const PagePoint &point) { data.begin(point); }
    void line_to(const PagePoint &point) { data.line_to(point); }
    void follow(const PageArc &arc) { data.follow(arc, circle_decimals); }
    void follow(const InkCurve &curve, bool closes) {
      data.follow(curve);
      if (closes) data.close();
    }
    void close() { data.close(); }
  };
  void put_data(uint32_t path, PathPart part, const SvgFrame &frame) {
    put_arcs(path, part, Pen{{sink_, frame, decimals_of(path, part, frame)}, decimals_in(frame)});
  }

  Pen contour_pen() { return {{sink_, frame_of_page(), page_.decimals}, page_.decimals}; }
  void begin_contours(InkLevel level, uint32_t path) {
    static constexpr const char *class_of[] = {"border", "group", "depth"};
    sink_.put("<path class=\"");
    sink_.put(class_of[static_cast<uint32_t>(level)]);
    sink_.put('"');
    const uint32_t colour = ink_.colour(level, paint_.fog_level(path));
    if (colour != ink_.colour(InkLevel::border, paint_.fog_level(path))) put_paint(" fill", colour);
    sink_.put(" d=\"");
  }
  void end_contours(InkLevel, uint32_t) { sink_.put("\"/>\n"); }

  uint32_t names_ = 0;  // all names of the file begin with this number
  bool lines_ = false;  // whether paths are done, and lines follow
};

}  // namespace

void write_svg(ByteSink &sink, const PictureInput &input, const PictureOptions &options, const Page &page,
               const Paint &paint) {
  SvgWriter(sink, input, options, page, paint).write();
}

}  // namespace hsp
