// Drawings by other programs: all the same in every format. The reference is the PDF file, drawn by poppler four times
// as large and averaged. Each test is skipped where one of its programs is missing.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <ostream>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "drawn_map.hpp"
#include "drawn_view.hpp"
#include "molecule_balls.hpp"
#include "raster.hpp"

namespace {

// crambin as a view; caffeine, some of whose arcs run clockwise while others are seen edge on; what is seen of crambin
// side by side, with lines of their own.
enum class Subject { crambin, caffeine, map };

// As wide as the program draws by default.
constexpr int side = 1000;

std::string picture_of(Subject subject, uint32_t format, uint32_t style, int pixels = side) {
  static const DrawnView crambin(read_molecule(support::own_molecule("crambin.pdb")));
  static const DrawnView caffeine(read_molecule(support::own_molecule("caffeine.pdb")), {0, 0, 1},
                                  HSP_PIECES_OUTSIDE_ALL);
  static const DrawnMap map(read_molecule(support::own_molecule("crambin.pdb")));
  hsp_picture_options options = picture_options(format, style);
  options.width = pixels;
  options.height = pixels;
  if (subject == Subject::map) return map.picture(options);
  return (subject == Subject::crambin ? crambin : caffeine).picture(options);
}

struct Renderer {
  const char *name;
  const char *program;
  uint32_t format;
  const char *command;  // from `in` to out.png or out.ppm
  bool needs_desktop;   // or something else that is not there; it is skipped if it does not run
};
std::ostream &operator<<(std::ostream &out, const Renderer &renderer) {
  return out << renderer.name;
}

const char *const ghostscript =
    "gs -q -dSAFER -dBATCH -dNOPAUSE -dEPSCrop -r96 -dGraphicsAlphaBits=4 -sDEVICE=ppmraw -sOutputFile=out.ppm in";
const char *const chromium =
    "timeout 120 sh -c 'chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --user-data-dir=profile "
    "--force-device-scale-factor=1 --window-size=1000,1000 --screenshot=out.png in.html >log 2>&1'";

// Some talk about displays, buses and colour profiles that are not there.
const Renderer renderers[] = {
    {"Librsvg", "rsvg-convert", HSP_FORMAT_SVG, "rsvg-convert -o out.png in", false},
    {"Cairosvg", "cairosvg", HSP_FORMAT_SVG, "cairosvg in -o out.png", false},
    {"Inkscape", "inkscape", HSP_FORMAT_SVG,
     "sh -c 'mv in in.svg && HOME=. timeout 120 inkscape in.svg -o out.png 2>log'", true},
    {"Chromium", "chromium", HSP_FORMAT_SVG, nullptr, true},
    {"GhostscriptOfPdf", "gs", HSP_FORMAT_PDF, ghostscript, false},
    {"GhostscriptOfEps", "gs", HSP_FORMAT_EPS, ghostscript, false},
    {"PopplerSplash", "pdftoppm", HSP_FORMAT_PDF, "pdftoppm -r 96 -singlefile in out", false},
    {"PopplerCairo", "pdftocairo", HSP_FORMAT_PDF, "pdftocairo -png -r 96 -singlefile in out", false},
    {"Mupdf", "mutool", HSP_FORMAT_PDF, "sh -c 'mv in in.pdf && mutool draw -q -r 96 -o out.png in.pdf 2>log'", false},
};

std::string page_of(const std::string &body) {
  return "<!DOCTYPE html><html><body style=\"margin:0\">" + body + "</body></html>";
}
Raster screenshot(const std::string &page) {
  return read_png(run_on(page, "in.html", chromium, "out.png"));
}

Raster drawn_by(const Renderer &renderer, const std::string &file) {
  if (renderer.command == nullptr) return screenshot(page_of(file));
  const std::string command = renderer.command;
  const bool png = command.find("out.ppm") == std::string::npos && command.find("pdftoppm") == std::string::npos;
  return png ? read_png(run_on(file, "in", command, "out.png")) : read_ppm(run_on(file, "in", command, "out.ppm"));
}

// Programs find out from a few samples how much of a pixel is covered, and some brighten what they find. At a quarter
// of the size that matters a quarter as much.
const Raster &reference(Subject subject, uint32_t style) {
  static std::map<std::pair<Subject, uint32_t>, Raster> known;
  const auto at = known.find({subject, style});
  if (at != known.end()) return at->second;
  const std::string file = picture_of(subject, HSP_FORMAT_PDF, style);
  const Raster large = read_ppm(run_on(file, "in", "pdftoppm -r 384 -singlefile in out", "out.ppm"));
  return known[{subject, style}] = averaged(large, 4);
}

// Measured: means up to 1.28, by Ghostscript, which moves everything by half a pixel; others up to 0.9.
constexpr double most_mean = 1.5;
constexpr double most_displaced = 0.002;

class RendererMatrix : public testing::TestWithParam<std::tuple<Renderer, uint32_t>> {};

TEST_P(RendererMatrix, DrawsWhatTheReferenceShows) {
  const auto &[renderer, style] = GetParam();
  if (!has_program("pdftoppm")) GTEST_SKIP() << "pdftoppm is missing";
  if (!has_program(renderer.program)) GTEST_SKIP() << renderer.program << " is missing";
  for (const Subject subject : {Subject::crambin, Subject::caffeine, Subject::map}) {
    // Styles differ in the paint. Paths of all three are the same.
    if (subject != Subject::crambin && style != HSP_STYLE_SOFT) continue;
    const std::string file = picture_of(subject, renderer.format, style);
    Raster raster;
    try {
      raster = drawn_by(renderer, file);
    } catch (const std::runtime_error &error) {
      if (renderer.needs_desktop) GTEST_SKIP() << renderer.program << " does not run here: " << error.what();
      throw;
    }
    const RasterDifference found = difference(raster, reference(subject, style));
    if (std::getenv("HSP_VERBOSE") != nullptr) {
      std::printf("%s, subject %d, style %u: mean %.2f, displaced %.5f\n", renderer.name, static_cast<int>(subject),
                  style, found.mean, found.displaced);
    }
    EXPECT_EQ(raster.width, static_cast<size_t>(side));
    EXPECT_LE(found.mean, most_mean) << static_cast<int>(subject);
    EXPECT_LT(found.displaced, most_displaced) << static_cast<int>(subject);
  }
}

std::string name_of(const testing::TestParamInfo<std::tuple<Renderer, uint32_t>> &info) {
  static const char *const styles[] = {"Flat", "Headlight", "Soft"};
  return std::string(std::get<0>(info.param).name) + styles[std::get<1>(info.param)];
}
INSTANTIATE_TEST_SUITE_P(All, RendererMatrix,
                         testing::Combine(testing::ValuesIn(renderers),
                                          testing::Values(HSP_STYLE_FLAT, HSP_STYLE_HEADLIGHT, HSP_STYLE_SOFT)),
                         name_of);

// The comparison is not blind: as little as one angstrom of crambin's twenty is seen.
TEST(RendererReference, TellsPicturesApart) {
  if (!has_program("pdftoppm")) GTEST_SKIP() << "pdftoppm is missing";
  const RasterDifference shades =
      difference(reference(Subject::crambin, HSP_STYLE_SOFT), reference(Subject::crambin, HSP_STYLE_HEADLIGHT));
  EXPECT_GT(shades.mean, 2 * most_mean);
  const RasterDifference other =
      difference(reference(Subject::crambin, HSP_STYLE_SOFT), reference(Subject::caffeine, HSP_STYLE_SOFT));
  EXPECT_GT(other.displaced, 0.05);
}

std::string as_image(const std::string &file) {
  static const char *const digits = "0123456789ABCDEF";
  std::string text;
  for (const char c : file) {
    const auto byte = static_cast<unsigned char>(c);
    text += '%';
    text += digits[byte >> 4U];
    text += digits[byte & 15U];
  }
  return "<img src=\"data:image/svg+xml," + text + "\">";
}

// Pictures inline in one page do not take each other's gradients: two different ones, and one of them twice.
TEST(InlinePictures, LookLikeImages) {
  if (!has_program("chromium")) GTEST_SKIP() << "chromium is missing";
  std::string inlined;
  std::string images;
  for (const Subject subject : {Subject::caffeine, Subject::crambin, Subject::caffeine}) {
    const std::string file = picture_of(subject, HSP_FORMAT_SVG, HSP_STYLE_SOFT, 400);
    inlined += file;
    images += as_image(file);
  }
  const std::string style = "<style>svg, img { float: left }</style>";
  Raster shot;
  try {
    shot = screenshot(page_of(style + inlined));
  } catch (const std::runtime_error &error) {
    GTEST_SKIP() << "chromium does not run here: " << error.what();
  }
  const Raster expected = screenshot(page_of(style + images));
  const RasterDifference found = difference(shot, expected);
  EXPECT_LT(found.mean, 0.05);
  EXPECT_EQ(found.displaced, 0);
  // There are pictures.
  EXPECT_GT(difference(expected, screenshot(page_of(""))).mean, 10);
}

// Colours that style sheets change keep their light. With librsvg and Chromium, in front of the elements of the file.
std::string restyled(std::string file, const std::string &rules) {
  return file.insert(file.find('>') + 1, "<style>" + rules + "</style>");
}

class Recolouring : public testing::TestWithParam<Renderer> {
 protected:
  // Skips where the program is missing or does not run.
  static bool draws(const std::string &file, Raster &raster) {
    if (!has_program(GetParam().program)) return false;
    try {
      raster = drawn_by(GetParam(), file);
    } catch (const std::runtime_error &) {
      if (GetParam().needs_desktop) return false;
      throw;
    }
    return true;
  }
};

TEST_P(Recolouring, KeepsTheRatioOfCentreAndRim) {
  const DrawnView one({{0, 0, 0, 1000}});
  const char *const classes[] = {"el-C"};
  hsp_picture_options options = picture_options(HSP_FORMAT_SVG, HSP_STYLE_HEADLIGHT);
  options.atom_class = classes;
  options.margin = 0;
  options.outline = 0;
  options.width = side;
  options.height = side;
  const std::string file = one.picture(options);
  for (const char *rules : {"", ".el-C{fill:#3c8ce6}", ".el-C{fill:#ffe0a0}"}) {
    Raster raster;
    if (!draws(restyled(file, rules), raster)) GTEST_SKIP() << GetParam().program << " is missing or does not run";
    const uint8_t *centre = raster.pixel(500, 500);
    for (const size_t x : {100U, 900U}) {  // .8 from the centre: .36 + .64 x .6
      for (size_t channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(raster.pixel(x, 500)[channel], 0.744 * centre[channel], 2.5) << rules << x;
      }
    }
    if (*rules == '.') {
      for (size_t channel = 0; channel < 3; ++channel) {
        const std::string digits = std::string(rules).substr(12 + 2 * channel, 2);
        EXPECT_NEAR(centre[channel], std::stoi(digits, nullptr, 16), 1) << rules;
      }
    }
  }
}

// Red oxygen as a style sheet has it, and as the caller has it.
TEST_P(Recolouring, IsDrawingInThatColour) {
  const oracle::Balls balls = read_molecule(support::own_molecule("crambin.pdb"));
  const LibraryScene scene(balls, drawn_step);
  const LibraryView view(scene, ViewChoice{HSP_PIECES_OUTSIDE_FARTHER, 0, false, {0, 0, 1}, {}});
  std::vector<const char *> classes;
  for (const oracle::LatticeBall &ball : balls) classes.push_back(ball.radius == 1520 ? "el-O" : "el-C");
  hsp_picture_options options = picture_options(HSP_FORMAT_SVG, HSP_STYLE_SOFT);
  options.atom_class = classes.data();
  options.fog = 0;
  const auto drawn_in = [&](const std::vector<uint32_t> &colours) {
    std::string text;
    expect_ok(
        hsp_picture_write(view.handle(), colours.data(), &options, nullptr, nullptr, append_bytes, &text, nullptr),
        "hsp_picture_write");
    return text;
  };
  std::vector<uint32_t> colours = colours_of(balls);
  const std::string file = drawn_in(colours);
  for (size_t k = 0; k < balls.size(); ++k) {
    if (balls[k].radius == 1520) colours[k] = 0x2E8B57;
  }
  Raster by_rule;
  Raster by_caller;
  if (!draws(restyled(file, ".el-O{fill:#2e8b57}"), by_rule) || !draws(drawn_in(colours), by_caller)) {
    GTEST_SKIP() << GetParam().program << " is missing or does not run";
  }
  EXPECT_EQ(difference(by_rule, by_caller).mean, 0);
  Raster before;
  ASSERT_TRUE(draws(file, before));
  EXPECT_GT(difference(before, by_caller).mean, 2);
}

std::string name_of_renderer(const testing::TestParamInfo<Renderer> &info) {
  return info.param.name;
}
INSTANTIATE_TEST_SUITE_P(Browsers, Recolouring, testing::Values(renderers[0], renderers[3]), name_of_renderer);

}  // namespace
