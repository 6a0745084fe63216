// The results of the readers of pictures: painted paths, on a page with y up.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

using PagePoint = std::array<double, 2>;

double distance(const PagePoint &a, const PagePoint &b);

// A part of a path as the file tells it. A line has no axes; start and end of an arc are computed from its numbers if
// the format has no numbers for them.
struct Segment {
  enum class Kind { line, arc, cubic };
  Kind kind = Kind::line;
  PagePoint start{};
  PagePoint end{};
  // centre + cos t axis[0] + sin t axis[1], t from `from` to `to`.
  PagePoint centre{};
  std::array<PagePoint, 2> axis{};
  double from = 0;
  double to = 0;
  std::array<PagePoint, 2> handle{};

  // The point at a share of the segment's parameters.
  [[nodiscard]] PagePoint at(double share) const;
};

// A quadratic curve, which is a cubic one.
Segment quadratic(const PagePoint &start, const PagePoint &control, const PagePoint &end);

struct Loop {
  PagePoint start{};
  std::vector<Segment> segments;
  bool closed = false;  // lines may be open
};

struct PaintedPath {
  std::vector<Loop> loops;
  std::string paint;  // as in the file
  uint32_t ball = 0xFFFFFFFFU;
  std::string name;   // the class of a contour, in SVG
  size_t behind = 0;  // how many paths of balls come before a contour
};

// A file with all its paths in drawing order. Anything that is not understood throws std::runtime_error.
struct PictureFile {
  double width = 0;  // px
  double height = 0;
  std::vector<PaintedPath> paths;
  std::vector<PaintedPath> lines;  // that are not filled
  std::vector<PaintedPath> ink;    // contours; of the ball whose path comes before, except in PDF
};

PictureFile read_svg(const std::string &text);
PictureFile read_eps(const std::string &text);
// Checks the file's structure too: objects where the table says, the stream's length.
PictureFile read_pdf(const std::string &text);
