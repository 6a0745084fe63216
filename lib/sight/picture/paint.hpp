// Which colour each path gets: the ball's own, the light on it, and fog.
#pragma once

#include "picture/page.hpp"
#include "picture/shading.hpp"

namespace hsp {

// Number of fog levels of gradients and lines, besides no fog. Fog is rounded before it is mixed in: channels rounded
// one by one would turn greys into tints.
constexpr uint32_t fog_levels = 10;

class Paint {
 public:
  // scratch: as many entries as there are paths.
  Paint(const PictureInput &input, const PictureOptions &options, const Page &page, Span<uint32_t> scratch);

  // Every path in one colour, or shades.
  bool flat() const { return style_ == PictureStyle::flat; }
  // Lines along the outline of each path, or lines of their own after all paths.
  bool lines_along() const { return along_; }
  bool own_lines() const { return lines_ && !along_; }
  uint32_t background() const { return background_; }

  // Whether a path has one colour, and which one: in a picture of shades that halfway to the rim.
  bool flat(uint32_t path) const { return flat() || input_.paths.is_plain(path); }
  uint32_t flat_colour(uint32_t path) const;

  // The different shades, and which of them a path has. None if the style is flat, and in SVG, which has lights.
  const Shading &shading() const { return shading_; }
  uint32_t shades() const { return shades_.size(); }
  uint32_t shade_of(uint32_t path) const;
  uint32_t shade_colour(uint32_t shade, uint32_t stop) const { return lit_colour(shades_[shade], stop); }

  // The same as light apart from colour, for formats that can lay one over the other: what is laid over a ball's colour
  // depends on its level of fog alone, where that is mixed into both.
  uint32_t unlit_colour(uint32_t path) const;
  Shading::Glaze glaze(uint32_t level, uint32_t stop) const;

  // Lines fade, too; does not increase in drawing order, up to rounding.
  uint32_t fog_level(uint32_t path) const;
  uint32_t line_colour(uint32_t level) const { return faded_line(outline_, level); }
  uint32_t faded_line(uint32_t colour, uint32_t level) const;
  // The share of the background that is mixed into a ball where fog is not rounded to levels.
  double fog(uint32_t path) const { return fog_ * fog_share(path); }

 private:
  // How far into the fog, from 0 to 1.
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
  Span<uint32_t> shades_;  // fog level and colour, ascending
};

}  // namespace hsp
