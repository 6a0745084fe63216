// How large files become, that shades are shared, and what a picture's page is.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "drawn_ink.hpp"
#include "drawn_view.hpp"
#include "molecule_balls.hpp"
#include "picture_paths.hpp"

namespace {

size_t count(const std::string &text, const std::string &part) {
  size_t found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

const DrawnView &crambin() {
  static const DrawnView view(read_molecule(support::own_molecule("crambin.pdb")));
  return view;
}

TEST(PictureSizes, StayWithinTheirBudgets) {
  EXPECT_LT(crambin().picture(picture_options(HSP_FORMAT_SVG, HSP_STYLE_FLAT)).size(), 55000U);
  EXPECT_LT(crambin().picture(picture_options(HSP_FORMAT_SVG, HSP_STYLE_HEADLIGHT)).size(), 115000U);
  EXPECT_LT(crambin().picture(picture_options(HSP_FORMAT_SVG, HSP_STYLE_SOFT)).size(), 115000U);
  const DrawnView large(read_molecule(support::own_molecule("sod_stand_in.pdb")));
  EXPECT_LT(large.picture(picture_options(HSP_FORMAT_SVG, HSP_STYLE_FLAT)).size(), 650000U);
}

// Pages of 170 mm, as the program makes them.
TEST(PictureSizes, CompressedPdfStaysWithinItsBudgets) {
  std::vector<unsigned char> memory(HSP_PICTURE_MEMORY);
  const auto options_of = [&memory](uint32_t style) {
    hsp_picture_options options = picture_options(HSP_FORMAT_PDF, style);
    options.width = 170;
    options.unit = HSP_UNIT_MM;
    options.memory = memory.data();
    options.memory_bytes = memory.size();
    return options;
  };
  EXPECT_LT(crambin().picture(options_of(HSP_STYLE_FLAT)).size(), 30000U);
  const DrawnInk inked(read_molecule(support::own_molecule("crambin.pdb")));
  EXPECT_LT(inked.picture(options_of(HSP_STYLE_SOFT)).size(), 90000U);
  // Along its shortest axis, as the program draws it.
  const DrawnInk large(read_molecule(support::own_molecule("sod_stand_in.pdb")), {0.9053, -0.4247, 0});
  EXPECT_LT(large.picture(options_of(HSP_STYLE_FLAT)).size(), 360000U);
}

// In SVG a light for each level of fog; a shade for each level and colour else, of which each element has one.
TEST(PictureSizes, ShadesAreShared) {
  const std::string svg = crambin().picture(picture_options(HSP_FORMAT_SVG, HSP_STYLE_SOFT));
  const size_t levels = count(svg, "<radialGradient ");
  EXPECT_LE(levels, 11U);
  EXPECT_GT(levels, 4U);
  EXPECT_EQ(count(svg, "<use "), crambin().pieces().size());
  EXPECT_EQ(count(svg, "<stop "), levels * 13);
  const size_t shades = count(crambin().picture(picture_options(HSP_FORMAT_EPS, HSP_STYLE_SOFT)), ">S\n");
  EXPECT_LE(shades, 4U * levels);  // C, N, O, S
  EXPECT_GT(shades, levels);
  EXPECT_EQ(count(crambin().picture(picture_options(HSP_FORMAT_PDF, HSP_STYLE_SOFT)), "/ShadingType 3"), shades);
  const std::string headlight = crambin().picture(picture_options(HSP_FORMAT_SVG, HSP_STYLE_HEADLIGHT));
  EXPECT_EQ(count(headlight, "<stop "), levels * 17);
  hsp_picture_options clear = picture_options(HSP_FORMAT_SVG, HSP_STYLE_SOFT);
  clear.fog = 0;
  EXPECT_EQ(count(crambin().picture(clear), "<radialGradient "), 1U);
}

TEST(PictureSizes, NoIdsAndNoBackground) {
  hsp_picture_options options = picture_options(HSP_FORMAT_SVG, HSP_STYLE_FLAT);
  const std::string with = crambin().picture(options);
  EXPECT_EQ(count(with, "data-ball="), crambin().pieces().size());
  EXPECT_EQ(count(with, "<rect "), 1U);
  options.flags = HSP_PICTURE_NO_IDS | HSP_PICTURE_NO_BACKGROUND;
  const std::string without = crambin().picture(options);
  EXPECT_EQ(count(without, "data-ball="), 0U);
  EXPECT_EQ(count(without, "<rect "), 0U);
  options.format = HSP_FORMAT_EPS;
  EXPECT_EQ(count(crambin().picture(options), "rectfill"), 0U);
  options.format = HSP_FORMAT_PDF;
  EXPECT_EQ(count(crambin().picture(options), "re f"), 0U);
}

TEST(PictureSizes, NoLines) {
  hsp_picture_options options = picture_options(HSP_FORMAT_SVG, HSP_STYLE_FLAT);
  options.outline = 0;
  EXPECT_EQ(count(crambin().picture(options), "stroke"), 0U);
  options.format = HSP_FORMAT_EPS;
  EXPECT_EQ(count(crambin().picture(options), "stroke"), 0U);
  options.format = HSP_FORMAT_PDF;
  EXPECT_EQ(count(crambin().picture(options), "B\n"), 0U);
}

// To EPS and PDF a line of width 0 is a hairline: what would be written as 0 is no line.
TEST(PictureSizes, LinesTooThinToWriteAreNone) {
  for (const uint32_t format : {HSP_FORMAT_SVG, HSP_FORMAT_EPS, HSP_FORMAT_PDF}) {
    for (const uint32_t style : {HSP_STYLE_FLAT, HSP_STYLE_SOFT}) {
      hsp_picture_options options = picture_options(format, style);
      options.outline = 0;
      const std::string without = crambin().picture(options);
      for (const double outline : {5e-324, 1e-9, 4.9e-5}) {
        options.outline = outline;
        EXPECT_EQ(crambin().picture(options), without) << format << ' ' << outline;
      }
      options.outline = 6e-5;
      // In PDF the unit is .01 px.
      const char *const width = format == HSP_FORMAT_PDF ? " 1 j .01 w\n" : ".0001";
      EXPECT_NE(crambin().picture(options).find(width), std::string::npos) << format;
    }
  }
}

// The chosen width: .9 px where the mean radius is 34 px.
TEST(PictureSizes, LinesSuitTheBalls) {
  const DrawnView one({{0, 0, 0, 1000}});
  hsp_picture_options options = picture_options(HSP_FORMAT_SVG, HSP_STYLE_FLAT);
  options.margin = 0;
  for (const double radius : {1.0, 10.0, 34.0, 60.0, 500.0}) {
    options.width = 2 * radius;
    const std::string text = one.picture(options);
    const size_t at = text.find("stroke-width=\"");
    ASSERT_NE(at, std::string::npos);
    const double expected = 0.9 * std::fmin(1.9, std::fmax(0.45, std::sqrt(radius / 34)));
    EXPECT_NEAR(std::stod(text.substr(at + 14)), expected, 6e-5);
  }
  options.outline = 2;
  options.unit = HSP_UNIT_MM;
  EXPECT_NE(one.picture(options).find("stroke-width=\"7.5591\""), std::string::npos);
}

// Without a margin the outermost lines are seen in their whole width; where they would fill the page, half is left.
TEST(PicturePages, LeaveRoomForLines) {
  const DrawnView one({{0, 0, 0, 1000}});
  const DrawnView wide({{0, 0, 0, 1000}, {6000, 0, 0, 1000}});
  hsp_picture_options options = picture_options(HSP_FORMAT_SVG, HSP_STYLE_FLAT);
  options.margin = 0;
  options.width = 100;
  options.outline = 10;
  EXPECT_NE(one.picture(options).find(" cx=\"50\" cy=\"50\" r=\"45\""), std::string::npos) << one.picture(options);
  EXPECT_NE(wide.picture(options).find(" cx=\"27.5\" cy=\"12.5\" r=\"7.5\""), std::string::npos)
      << wide.picture(options);
  options.outline = 200;
  EXPECT_NE(one.picture(options).find(" cx=\"50\" cy=\"50\" r=\"25\""), std::string::npos) << one.picture(options);
  options.outline = 10;
  options.margin = 0.125;  // 10 px of 100, half of which suffice
  EXPECT_NE(one.picture(options).find(" cx=\"50\" cy=\"50\" r=\"40\""), std::string::npos) << one.picture(options);
}

TEST(PicturePages, FollowFromTheOtherSide) {
  const DrawnView wide({{0, 0, 0, 1000}, {6000, 0, 0, 1000}});  // 8 by 2
  hsp_picture_options options = picture_options(HSP_FORMAT_SVG, HSP_STYLE_FLAT);
  options.margin = 0.125;  // 10 by 4
  options.width = 500;
  PictureFile file = read_svg(wide.picture(options));
  EXPECT_NEAR(file.width, 500, 1e-6);
  EXPECT_NEAR(file.height, 200, 1e-6);
  options.width = 0;
  options.height = 100;
  options.unit = HSP_UNIT_MM;
  const std::string text = wide.picture(options);
  EXPECT_NE(text.find("width=\"250mm\" height=\"100mm\""), std::string::npos);
  file = read_svg(text);
  EXPECT_NEAR(file.width, 250 / 25.4 * 96, 1e-5);
  EXPECT_NEAR(file.height, 100 / 25.4 * 96, 1e-5);
}

// Neither a page without a width nor one without a height; what is smaller than 0.01 counts as that.
TEST(PicturePages, HaveAWidthAndAHeight) {
  const DrawnView wide({{0, 0, 0, 1000}, {6000, 0, 0, 1000}});
  hsp_picture_options options = picture_options(HSP_FORMAT_SVG, HSP_STYLE_FLAT);
  for (const double size : {5e-324, 1e-9, 0.0099, 0.01}) {
    options.width = size;
    options.height = 7;
    EXPECT_NE(wide.picture(options).find("width=\".01px\" height=\"7px\""), std::string::npos) << size;
    options.width = 0;
    options.height = size;
    const PictureFile file = read_svg(wide.picture(options));
    EXPECT_NEAR(file.height, 0.01, 1e-9);
    EXPECT_NEAR(file.width, 0.01 * 8.48 / 2.48, 1e-6);  // the margin is .03 of 8 on each side
    options.width = size;
    options.format = HSP_FORMAT_PDF;
    EXPECT_NE(wide.picture(options).find("/MediaBox[0 0 .0075 .0075]"), std::string::npos);
    options.format = HSP_FORMAT_EPS;
    EXPECT_NE(wide.picture(options).find("%%HiResBoundingBox: 0 0 .0075 .0075\n"), std::string::npos);
    options.format = HSP_FORMAT_SVG;
  }
}

TEST(PicturePages, CanBeExtreme) {
  const DrawnView apart({{0, 0, 0, 1}, {int64_t{1} << 49, 0, 0, 1}});
  for (const uint32_t format : {HSP_FORMAT_SVG, HSP_FORMAT_EPS, HSP_FORMAT_PDF}) {
    for (const double size : {1e-9, 1e6}) {
      for (const bool upright : {false, true}) {
        hsp_picture_options options = picture_options(format, HSP_STYLE_SOFT);
        options.margin = 0;
        options.width = upright ? 0 : size;
        options.height = upright ? size : 0;
        const std::string text = apart.picture(options);
        EXPECT_EQ(text.find("nan"), std::string::npos);
        EXPECT_LT(text.size(), 20000U);
      }
    }
  }
}

// Gradients of balls that are smaller than any number in the file: renderers fail on a radius or a scale of 0.
TEST(PicturePages, NoGradientIsScaledToNothing) {
  const DrawnView apart({{0, 0, 0, 1}, {int64_t{1} << 49, 0, 0, 1}});
  hsp_picture_options options = picture_options(HSP_FORMAT_SVG, HSP_STYLE_SOFT);
  options.fog = 0;
  EXPECT_EQ(count(apart.picture(options), "scale(.01)"), 2U);
  options.format = HSP_FORMAT_EPS;
  EXPECT_EQ(count(apart.picture(options), " .0000001 0 G\n"), 2U);
  options.format = HSP_FORMAT_PDF;
  EXPECT_EQ(count(apart.picture(options), "W n 1 0 0 1 "), 2U);
}

TEST(PicturePages, BoundingBoxesAreRoundedUp) {
  const DrawnView one({{0, 0, 0, 1000}});
  hsp_picture_options options = picture_options(HSP_FORMAT_EPS, HSP_STYLE_FLAT);
  options.width = 100.1;
  options.height = 200;
  const std::string text = one.picture(options);
  EXPECT_NE(text.find("\n%%BoundingBox: 0 0 76 150\n"), std::string::npos);
  EXPECT_NE(text.find("\n%%HiResBoundingBox: 0 0 75.075 150\n"), std::string::npos);
}

// A PostScript comment goes on with %%+, as lines have at most 255 characters.
TEST(PicturePages, LongTitlesTakeSeveralLines) {
  const DrawnView one({{0, 0, 0, 1000}});
  const std::string title(250, 't');
  const std::string text = one.picture(picture_options(HSP_FORMAT_EPS, HSP_STYLE_FLAT), title.c_str());
  const auto part = [&](size_t first) { return std::string(1, '(').append(title, first, 120).append(")\n"); };
  EXPECT_NE(text.find("\n%%Title: " + part(0) + "%%+ " + part(120) + "%%+ " + part(240) + "%%Creator"),
            std::string::npos);
}

// However narrow the balls' box is, a side that follows from the other one is neither nothing nor endless.
TEST(PicturePages, SidesThatFollowHaveBounds) {
  const int64_t far = int64_t{1} << 49;
  const DrawnView wide({{0, 0, 0, 1}, {far, 0, 0, 1}});
  const DrawnView high({{0, 0, 0, 1}, {0, far, 0, 1}});
  hsp_picture_options options = picture_options(HSP_FORMAT_SVG, HSP_STYLE_FLAT);
  options.margin = 0;
  options.width = 1000;
  EXPECT_NE(wide.picture(options).find(" height=\".01px\""), std::string::npos);
  EXPECT_NE(high.picture(options).find(" height=\"1000000px\""), std::string::npos);
  options.width = 0;
  options.height = 1000;
  EXPECT_NE(wide.picture(options).find(" width=\"1000000px\""), std::string::npos);
  EXPECT_NE(high.picture(options).find(" width=\".01px\""), std::string::npos);
}

// The headlight leaves of a colour a + b sqrt(1 - rho^2) at the offsets; in between it is linear within the promised
// .0034.
TEST(PictureShades, FollowLambertsLaw) {
  const DrawnView one({{0, 0, 0, 1000}});
  const std::string text = one.picture(picture_options(HSP_FORMAT_SVG, HSP_STYLE_HEADLIGHT));
  std::vector<double> offset;
  std::vector<double> level;
  for (size_t at = text.find("<stop "); at != std::string::npos; at = text.find("<stop ", at + 1)) {
    offset.push_back(std::stod(text.substr(text.find("offset=\"", at) + 8)));
    level.push_back(1 - std::stod(text.substr(text.find("stop-opacity=\"", at) + 14)));
  }
  ASSERT_EQ(offset.size(), 17U);
  ASSERT_EQ(offset.front(), 0);
  ASSERT_EQ(offset.back(), 1);
  const double rim = level.back();
  const double rise = level.front() - rim;
  ASSERT_NEAR(rise, 0.64, 1e-4);
  for (size_t k = 0; k + 1 < offset.size(); ++k) {
    ASSERT_LT(offset[k], offset[k + 1]);
    for (int i = 0; i <= 100; ++i) {
      const double share = i / 100.0;
      const double rho = offset[k] + (offset[k + 1] - offset[k]) * share;
      const double drawn = level[k] + (level[k + 1] - level[k]) * share;
      EXPECT_NEAR(drawn, rim + rise * std::sqrt(1 - rho * rho), 0.0034 * rise + 1e-4) << rho;
    }
  }
}

}  // namespace
