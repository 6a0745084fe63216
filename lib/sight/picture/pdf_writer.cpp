#include "picture/writers.hpp"

#include "picture/cubic_arcs.hpp"
#include "picture/escaped_text.hpp"
#include "picture/page_walker.hpp"

namespace hsp {
namespace {

constexpr uint32_t catalog = 1, page_tree = 2, only_page = 3, resources = 4, contents = 5, length_of_contents = 6,
                   about = 7;
// More objects of a compressed file: a stream that holds the resources, its length, and the table of objects.
constexpr uint32_t packed = 8, length_of_packed = 9, table = 10;
constexpr uint32_t objects = 10;

class PdfWriter : private PageWalker<PdfWriter> {
  friend PageWalker<PdfWriter>;

 public:
  using PageWalker::PageWalker;

  // The resources hold a dictionary for each shade; many shades are most of the file. Since PDF 1.5 they may stand in a
  // stream, which can be compressed.
  void write() {
    sink_.put(compressed() ? "%PDF-1.5\n" : "%PDF-1.4\n");
    put_structure();
    if (compressed()) {
      put_stream(packed, length_of_packed, "/Type/ObjStm/N 1/First 4", [this] {
        sink_.put("4 0\n");
        put_resources();
      });
    } else {
      begin(resources);
      put_resources();
      end();
    }
    put_stream(contents, length_of_contents, "", [this] { put_contents(); });
    begin(about);
    put_about();
    end();
    if (compressed()) {
      put_table_stream();
    } else {
      put_table();
    }
    sink_.put("\n%%EOF\n");
  }

 private:
  struct Pen {
    PdfWriter &writer;

    void put(const PagePoint &point, const char *command) {
      writer.put_point(point);
      writer.sink_.put(command);
    }
    void begin(const PagePoint &point) { put(point, "m\n"); }
    void line_to(const PagePoint &point) { put(point, "l\n"); }
    void follow(const PageArc &arc) {
      CubicArc(arc, writer.decimals_).visit([&](const UnitPoint &from, const UnitPoint &to, const UnitPoint &end) {
        writer.put_point(from);
        writer.put_point(to);
        writer.put_point(end);
        writer.sink_.put("c\n");
      });
    }
    void follow(const InkCurve &curve, bool closes) {
      put(curve.handle(curve.start), "");
      put(curve.handle(curve.end), "");
      put(curve.end, closes ? "c\nh\n" : "c\n");
    }
    void close() { writer.sink_.put("h\n"); }
  };

  void begin(uint32_t object) {
    offset_[object] = sink_.position();
    put_integer(sink_, object);
    sink_.put(" 0 obj\n");
  }
  void end() { sink_.put("\nendobj\n"); }
  bool compressed() const { return options_.memory_bytes > 0; }

  // A stream, and its length as an object of its own.
  template <class Put>
  void put_stream(uint32_t object, uint32_t length, const char *entries, Put put) {
    begin(object);
    sink_.put("<<");
    sink_.put(entries);
    sink_.put("/Length ");
    put_integer(sink_, length);
    sink_.put(compressed() ? " 0 R/Filter/FlateDecode>>\nstream\n" : " 0 R>>\nstream\n");
    const uint64_t start = sink_.position();
    if (compressed()) {
      Workspace workspace(options_.memory, options_.memory_bytes);
      Deflater deflater;
      deflater.carve(workspace);
      sink_.start_compressed(deflater);
      put();
      sink_.finish_compressed();
    } else {
      put();
    }
    const uint64_t bytes = sink_.position() - start;
    sink_.put(compressed() ? "\nendstream" : "endstream");
    end();
    begin(length);
    put_integer(sink_, bytes);
    end();
  }

  void put_channels(uint32_t colour) {
    for (const double channel : unpacked(colour).channel) put_number(channel / 255.0, 3);
  }

  void put_structure() {
    begin(catalog);
    sink_.put("<</Type/Catalog/Pages 2 0 R>>");
    end();
    begin(page_tree);
    sink_.put("<</Type/Pages/Kids[3 0 R]/Count 1>>");
    end();
    begin(only_page);
    sink_.put("<</Type/Page/Parent 2 0 R/Resources 4 0 R/Contents 5 0 R/MediaBox[0 0 ");
    put_number(page_.width * points_per_px, 6);
    put_decimal(sink_, page_.height * points_per_px, 6);
    sink_.put("]>>");
    end();
  }

  void put_resources() {
    sink_.put(
        "<</ProcSet[/PDF/Text]/Font<</F1<</Type/Font/Subtype/Type1/BaseFont/Helvetica/Encoding/WinAnsiEncoding>>>>");
    if (paint_.shades() > 0) {
      sink_.put("/Shading<<\n");
      for (uint32_t s = 0; s < paint_.shades(); ++s) put_shade(s);
      sink_.put(">>");
    }
    sink_.put(">>");
  }

  void put_shade(uint32_t shade) {
    const Shading &shading = paint_.shading();
    sink_.put("/S");
    put_integer(sink_, shade);
    sink_.put("<</ShadingType 3/ColorSpace/DeviceRGB/Extend[true true]/Coords[");
    put_number(shading.focus_x(), 3);
    put_number(shading.focus_y(), 3);
    sink_.put("0 0 0 1]/Function<</FunctionType 3/Domain[0 1]/Bounds[");
    for (uint32_t stop = 1; stop < shading.intervals(); ++stop) put_number(shading.offset(stop), 6);
    sink_.put("]/Encode[");
    for (uint32_t k = 0; k < shading.intervals(); ++k) sink_.put("0 1 ");
    sink_.put("]/Functions[\n");
    for (uint32_t k = 0; k < shading.intervals(); ++k) {
      sink_.put("<</FunctionType 2/Domain[0 1]/N 1/C0[");
      put_channels(paint_.shade_colour(shade, k));
      sink_.put("]/C1[");
      put_channels(paint_.shade_colour(shade, k + 1));
      sink_.put("]>>\n");
    }
    sink_.put("]>>>>\n");
  }

  // The unit of all numbers that follow is that of the last decimal. So they are integers: short, and the same for
  // every reader. The coordinates of a ball count from its centre, so that equal shapes are written alike.
  void put_contents() {
    const int fine = decimals_ + 4;
    sink_.put("q\n");
    put_decimal(sink_, points_per_px / power_of_ten[decimals_], fine);
    sink_.put(" 0 0 ");
    put_decimal(sink_, points_per_px / power_of_ten[decimals_], fine);
    sink_.put(" 0 0 cm 1 j ");
    const int line_decimals = decimals_ > 4 ? decimals_ : 4;
    put_scaled(sink_, scaled(page_.line, line_decimals), line_decimals - decimals_);
    sink_.put(" w\n");
    if (options_.backdrop) {
      put_channels(paint_.background());
      sink_.put("rg 0 0 ");
      put_whole(scaled(page_.width, decimals_) + 1);
      put_whole(scaled(page_.height, decimals_) + 1);
      sink_.put("re f\n");
    }
    walk_paths();
    if (paint_.own_lines()) sink_.put("1 J\n");
    walk_lines();
    sink_.put("Q\n");
  }

  uint32_t path_level(uint32_t path) const { return paint_.lines_along() ? paint_.fog_level(path) : no_level; }
  void begin_level(uint32_t level, uint32_t) {
    put_channels(paint_.line_colour(level));
    sink_.put("RG\n");
  }
  void put_path(uint32_t path) {
    begin_ball(path);
    if (paint_.flat(path)) {
      put_channels(paint_.flat_colour(path));
      sink_.put("rg\n");
      put_arcs(path, PathPart::outline, Pen{*this});
      sink_.put(paint_.lines_along() ? "B\n" : "f\n");
    } else {
      put_shaded(path);
    }
    put_contours(path);
    sink_.put("Q\n");
  }
  void put_lines(uint32_t path, uint32_t &level) {
    change_level(paint_.fog_level(path), level);
    begin_ball(path);
    put_arcs(path, PathPart::lines, Pen{*this});
    sink_.put(is_empty(path, PathPart::lines) ? "Q\n" : "S\nQ\n");
  }
  Pen contour_pen() { return {*this}; }
  void begin_contours(InkLevel level, uint32_t path) {
    put_channels(ink_.colour(level, paint_.fog_level(path)));
    sink_.put("rg\n");
  }
  void end_contours(InkLevel, uint32_t) { sink_.put("f\n"); }

  void put_whole(int64_t n) {
    put_scaled(sink_, n, 0);
    // Readers need not know larger integers.
    constexpr int64_t largest = 0x7FFFFFFF;
    sink_.put(n > largest || n < -largest ? ". " : " ");
  }
  void put_point(const UnitPoint &point) {
    put_whole(point.x - origin_.x);
    put_whole(point.y - origin_.y);
  }
  void put_point(const PagePoint &point) { put_point(in_units(point, decimals_)); }

  // From here to Q coordinates count from the ball's centre.
  void begin_ball(uint32_t path) {
    origin_ = {0, 0};
    sink_.put("q 1 0 0 1 ");
    const UnitPoint centre = in_units(page_.centre_of(input_, path), decimals_);
    put_point(centre);
    sink_.put("cm\n");
    origin_ = centre;
  }

  // The path is written twice: painting ends it, and a line along it must not be clipped by it.
  void put_shaded(uint32_t path) {
    sink_.put("q\n");
    put_arcs(path, PathPart::outline, Pen{*this});
    sink_.put("W n ");
    const int64_t radius = scaled_radius(path, decimals_);
    put_whole(radius);
    sink_.put("0 0 ");
    put_whole(radius);
    sink_.put("0 0 cm /S");
    put_integer(sink_, paint_.shade_of(path));
    sink_.put(" sh Q\n");
    if (!paint_.lines_along()) return;
    put_arcs(path, PathPart::outline, Pen{*this});
    sink_.put("S\n");
  }

  void put_about() {
    sink_.put("<</Producer(hardsphere)");
    if (!is_blank(input_.title)) {
      sink_.put("/Title");
      put_pdf_text(sink_, input_.title);
    }
    if (!is_blank(input_.description)) {
      sink_.put("/Subject");
      put_pdf_text(sink_, input_.description);
    }
    sink_.put(">>");
  }

  void put_table() {
    const uint64_t start = sink_.position();
    sink_.put("xref\n0 8\n0000000000 65535 f \n");
    for (uint32_t object = 1; object <= about; ++object) {
      put_integer(sink_, offset_[object], 10);
      sink_.put(" 00000 n \n");
    }
    sink_.put("trailer\n<</Size 8/Root 1 0 R/Info 7 0 R>>\nstartxref\n");
    put_integer(sink_, start);
  }

  // For each object: 0 if it is free, 1 and its offset, or 2 and the stream that it stands in; and one more number.
  void put_table_stream() {
    begin(table);
    sink_.put("<</Type/XRef/Size 11/W[1 8 2]/Root 1 0 R/Info 7 0 R/Length 121>>\nstream\n");
    for (uint32_t object = 0; object <= objects; ++object) {
      put_bytes(object == 0 ? 0 : object == resources ? 2 : 1, 1);
      put_bytes(object == 0 ? 0 : object == resources ? packed : offset_[object], 8);
      put_bytes(object == 0 ? 65535 : 0, 2);
    }
    sink_.put("\nendstream");
    end();
    sink_.put("startxref\n");
    put_integer(sink_, offset_[table]);
  }
  // The highest byte first.
  void put_bytes(uint64_t value, int bytes) {
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) sink_.put(static_cast<char>(value >> shift & 255U));
  }

  const int decimals_ = page_.decimals;  // of the unit in the contents
  UnitPoint origin_{0, 0};               // what coordinates count from
  uint64_t offset_[objects + 1] = {};
};

}  // namespace

void write_pdf(ByteSink &sink, const PictureInput &input, const PictureOptions &options, const Page &page,
               const Paint &paint) {
  PdfWriter(sink, input, options, page, paint).write();
}

}  // namespace hsp
