// Other programs and the files: they accept them without a word, and find what stands there. Each test is skipped where
// one of its programs is missing.
#include <gtest/gtest.h>

#include "drawn_map.hpp"
#include "drawn_view.hpp"
#include "molecule_balls.hpp"
#include "raster.hpp"

namespace {

const DrawnView &crambin() {
  static const DrawnView view(read_molecule(support::own_molecule("crambin.pdb")));
  return view;
}
// The visible part of each ball, side by side, and lines of their own.
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
Raster from_pdf(const Drawn &drawn, uint32_t style) {
  const std::string file = drawn.picture(options_of(HSP_FORMAT_PDF, style), title, description);
  return read_ppm(run_on(file, "in.pdf", "pdftoppm -r 96 -singlefile in.pdf out", "out.ppm"));
}
class Renderers : public testing::TestWithParam<uint32_t> {};

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
  const RasterDifference found =
      difference(from_pdf(crambin_map(), HSP_STYLE_FLAT), from_pdf(crambin(), HSP_STYLE_FLAT));
  EXPECT_LT(found.mean, 3);
  EXPECT_LT(found.displaced, 0.002);
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
