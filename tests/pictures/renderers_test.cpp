// What other programs make of the files: they accept them without a word, and SVG, EPS and PDF look the same up to
// anti-aliasing. Each test is skipped where one of its programs is missing.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "drawn_map.hpp"
#include "drawn_view.hpp"
#include "molecule_balls.hpp"
#include "raster.hpp"

namespace {

const DrawnView &crambin() {
  static const DrawnView view(read_molecule(support::own_molecule("crambin.pdb")));
  return view;
}
// Some of its arcs run clockwise, others are seen edge on.
const DrawnView &caffeine() {
  static const DrawnView view(read_molecule(support::own_molecule("caffeine.pdb")), {0, 0, 1}, HSP_PIECES_OUTSIDE_ALL);
  return view;
}

// What is seen of each ball, side by side, and lines of their own.
const DrawnMap &crambin_map() {
  static const DrawnMap map(read_molecule(support::own_molecule("crambin.pdb")));
  return map;
}

hsp_picture_options options_of(uint32_t format, uint32_t style) {
  hsp_picture_options options = picture_options(format, style);
  options.width = 500;
  options.height = 500;
  return options;
}

const char *const title = "Crambin & \"friends\" <1CRN> (\\)";
const char *const description =
    "\xC3\xA9t\xC3\xA9; a long text to be wrapped, a long text to be wrapped, a long text, "
    "a long text to be wrapped, a long text to be wrapped.";

template <class Drawn>
Raster from_svg(const Drawn &drawn, uint32_t style) {
  const std::string file = drawn.picture(options_of(HSP_FORMAT_SVG, style), title, description);
  return read_png(run_on(file, "in.svg", "rsvg-convert -o out.png in.svg", "out.png"));
}
template <class Drawn>
Raster from_eps(const Drawn &drawn, uint32_t style) {
  const std::string file = drawn.picture(options_of(HSP_FORMAT_EPS, style), title, description);
  return read_ppm(run_on(file, "in.eps",
                         "gs -q -dSAFER -dBATCH -dNOPAUSE -dEPSCrop -r96 -dGraphicsAlphaBits=4 -sDEVICE=ppmraw "
                         "-sOutputFile=out.ppm in.eps",
                         "out.ppm"));
}
template <class Drawn>
Raster from_pdf(const Drawn &drawn, uint32_t style) {
  const std::string file = drawn.picture(options_of(HSP_FORMAT_PDF, style), title, description);
  return read_ppm(run_on(file, "in.pdf", "pdftoppm -r 96 -singlefile in.pdf out", "out.ppm"));
}
template <class Drawn>
Raster from_browser(const Drawn &drawn, uint32_t style) {
  const std::string file = drawn.picture(options_of(HSP_FORMAT_SVG, style), title, description);
  const std::string page = "<!DOCTYPE html><html><body style=\"margin:0\">" + file + "</body></html>";
  // It talks about buses and displays that are not there.
  return read_png(run_on(page, "in.html",
                         "timeout 120 sh -c 'chromium --headless --no-sandbox --disable-gpu --hide-scrollbars "
                         "--user-data-dir=profile --force-device-scale-factor=1 --window-size=500,500 "
                         "--screenshot=out.png in.html >log 2>&1'",
                         "out.png"));
}

// Measured: means up to 1.9 and .06 % displaced pixels.
void expect_alike(const Raster &a, const Raster &b, const char *what) {
  const RasterDifference found = difference(a, b);
  if (std::getenv("HSP_VERBOSE") != nullptr) {
    std::printf("%s: mean %.2f, far off %.4f, displaced %.5f\n", what, found.mean, found.far_off, found.displaced);
  }
  EXPECT_LT(found.mean, 3) << what;
  EXPECT_LT(found.displaced, 0.002) << what;
}

class Renderers : public testing::TestWithParam<uint32_t> {};

TEST_P(Renderers, AgreeOnSvgAndPdf) {
  if (!has_program("rsvg-convert") || !has_program("pdftoppm")) GTEST_SKIP() << "rsvg-convert or pdftoppm is missing";
  expect_alike(from_svg(crambin(), GetParam()), from_pdf(crambin(), GetParam()), "crambin, SVG and PDF");
  expect_alike(from_svg(caffeine(), GetParam()), from_pdf(caffeine(), GetParam()), "caffeine, SVG and PDF");
  expect_alike(from_svg(crambin_map(), GetParam()), from_pdf(crambin_map(), GetParam()), "map of crambin, SVG and PDF");
}

TEST_P(Renderers, AgreeOnEpsAndPdf) {
  if (!has_program("gs") || !has_program("pdftoppm")) GTEST_SKIP() << "gs or pdftoppm is missing";
  expect_alike(from_eps(crambin(), GetParam()), from_pdf(crambin(), GetParam()), "crambin, EPS and PDF");
  expect_alike(from_eps(caffeine(), GetParam()), from_pdf(caffeine(), GetParam()), "caffeine, EPS and PDF");
  expect_alike(from_eps(crambin_map(), GetParam()), from_pdf(crambin_map(), GetParam()), "map of crambin, EPS and PDF");
}

TEST_P(Renderers, AgreeWithABrowser) {
  if (!has_program("chromium") || !has_program("pdftoppm")) GTEST_SKIP() << "chromium or pdftoppm is missing";
  Raster shot;
  try {
    shot = from_browser(crambin(), GetParam());
  } catch (const std::exception &error) {
    GTEST_SKIP() << "chromium does not run here: " << error.what();
  }
  expect_alike(shot, from_pdf(crambin(), GetParam()), "crambin, browser and PDF");
}

TEST_P(Renderers, FindValidXml) {
  if (!has_program("xmllint")) GTEST_SKIP() << "xmllint is missing";
  for (const char *text : {title, "\x01\xFF\xC3\xED\xA0\x80 ]]>", description}) {
    const std::string file = crambin().picture(options_of(HSP_FORMAT_SVG, GetParam()), text, text);
    EXPECT_NO_THROW(run_on(file, "in.svg", "xmllint --noout in.svg", ""));
  }
}

INSTANTIATE_TEST_SUITE_P(Styles, Renderers, testing::Values(HSP_STYLE_FLAT, HSP_STYLE_HEADLIGHT, HSP_STYLE_SOFT));

// A map's picture is that of the view, but for seams and lines: what is painted over is not seen.
TEST(MapPictures, LookLikeViews) {
  if (!has_program("pdftoppm")) GTEST_SKIP() << "pdftoppm is missing";
  expect_alike(from_pdf(crambin_map(), HSP_STYLE_FLAT), from_pdf(crambin(), HSP_STYLE_FLAT), "map and view of crambin");
}

// The comparison is not blind.
TEST(RasterComparison, TellsPicturesApart) {
  if (!has_program("pdftoppm")) GTEST_SKIP() << "pdftoppm is missing";
  const DrawnView behind(read_molecule(support::own_molecule("crambin.pdb")), {0, 0, -1});
  const RasterDifference found = difference(from_pdf(crambin(), HSP_STYLE_FLAT), from_pdf(behind, HSP_STYLE_FLAT));
  EXPECT_GT(found.mean, 12);
  EXPECT_GT(found.displaced, 0.05);
}

TEST(PdfInformation, HoldsTitleAndDescription) {
  if (!has_program("pdfinfo")) GTEST_SKIP() << "pdfinfo is missing";
  const std::string file = crambin().picture(options_of(HSP_FORMAT_PDF, HSP_STYLE_FLAT), title, "A (sub)ject\\");
  const std::string told = run_on(file, "in.pdf", "pdfinfo in.pdf >out", "out");
  EXPECT_NE(told.find("Crambin & \"friends\" <1CRN> (\\)\n"), std::string::npos) << told;
  EXPECT_NE(told.find("A (sub)ject\\\n"), std::string::npos) << told;
  EXPECT_NE(told.find("375 x 375 pts"), std::string::npos) << told;
}

}  // namespace
