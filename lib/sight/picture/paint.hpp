// The colour of each path: the ball's own colour, the light on it, and fog.
#pragma once

#include "picture/page.hpp"
#include "picture/shading.hpp"

namespace hsp {

// The number of fog levels of gradients and lines, besides no fog. Fog is rounded to a level before it is mixed in: if
// channels were rounded one by one, greys would become tints.
constexpr uint32_t fog_levels = 10;

class Paint {
 public:
  // scratch: as many entries as there are paths.
  Paint(const PictureInput &input, const PictureOptions &options, const Page &page, Span<uint32_t> scratch);

  // Whether every path has one colour; else balls are shaded.
  bool flat() const { return style_ == PictureStyle::flat; }
  // Whether lines run along the outline of each path; whether lines of their own follow after all paths.
  bool lines_along() const { return along_; }
  bool own_lines() const { return lines_ && !along_; }
  uint32_t background() const { return background_; }

  // Whether a path has one colour, and that colour; in a picture of shades it is the one halfway to the rim.
  bool flat(uint32_t path) const { return flat() || input_.paths.is_plain(path); }
  uint32_t flat_colour(uint32_t path) const;

  // The different shades, and which of them a path has. There are none if the style is flat, and for SVG, which has
  // lights instead.
  const Shading &shading() const { return shading_; }
  uint32_t shades() const { return shades_.size(); }
  uint32_t shade_of(uint32_t path) const;
  uint32_t shade_colour(uint32_t shade, uint32_t stop) const { return lit_colour(shades_[shade], stop); }

  // A shade as colour and light apart, for formats that can lay a glaze over a colour. Fog is mixed into both, so that
  // the glaze of a ball depends on its fog level alone.
  uint32_t unlit_colour(uint32_t path) const;
  Shading::Glaze glaze(uint32_t level, uint32_t stop) const;

  // The fog level of a path. It does not increase in drawing order, up to rounding. Lines fade, too.
  uint32_t fog_level(uint32_t path) const;
  uint32_t line_colour(uint32_t level) const { return faded_line(outline_, level); }
  uint32_t faded_line(uint32_t colour, uint32_t level) const;
  // The share of the background that is mixed into a ball, with fog not rounded to levels.
  double fog(uint32_t path) const { return fog_ * fog_share(path); }

 private:
  // How far a path is in the fog, from 0 to 1.
  double fog_share(uint32_t path) const;
  uint32_t key_of(uint32_t path) const;
  uint32_t lit_colour(uint32_t key, uint32_t stop) const;
  void find_shades(Span<uint32_t> scratch);

  const PictureInput &input_;
  PictureStyle style_;
  bool lines_, along_;
  double fog_;
  uint32_t background_, outline_;
  double farthest_, nearest_;
  Shading shading_;
  Span<uint32_t> shades_;  // the different pairs of fog level and colour, ascending
};

}  // namespace hsp
