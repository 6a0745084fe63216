// Views and maps as vector pictures. Ranges of the options are checked at the C interface.
#pragma once

#include "picture/byte_sink.hpp"
#include "picture/painted_paths.hpp"

namespace hsp {

enum class PictureFormat : uint32_t { svg = 0, eps = 1, pdf = 2 };
enum class PictureStyle : uint32_t { flat = 0, headlight = 1, soft = 2 };

struct PictureOptions {
  PictureFormat format = PictureFormat::svg;
  PictureStyle style = PictureStyle::flat;
  bool millimetres = false;  // otherwise px, 1/96 inch
  double width = 1000.0;     // 0: follows from height, and the other way round
  double height = 0.0;
  double margin = 0.03;
  double outline = -1.0;  // 0: none; < 0: select
  double fog = 0.3;
  uint32_t outline_colour = 0x23202B;
  uint32_t background = 0xFFFFFF;
  bool ids = true;
  bool backdrop = true;  // paint the background
  double scale = 0.0;    // of a fixed frame, px or mm per unit of length; 0: all that is seen is fitted into the page
  double centre[3] = {0.0, 0.0, 0.0};  // the point in the middle of a fixed frame
  void *memory = nullptr;              // memory for a Deflater, for PDF; null: PDF is not compressed
  size_t memory_bytes = 0;
  double ink_width[3] = {-1.0, -1.0, -1.0};  // by InkLevel; < 0: select
  uint32_t ink_colour[3] = {0x23202B, 0x23202B, 0x23202B};
};

constexpr uint32_t plain_colour = 0xD2CDC3;

struct PictureInput {
  const BallSet &balls;
  PaintedPaths paths;
  const uint32_t *colour;  // by the caller's index, or null: all plain
  const char *title;       // may be null
  const char *description;
  SeenSilhouettes silhouettes{};    // of the same balls, to be drawn with ink; or none
  const uint32_t *group = nullptr;  // by the caller's index, or null: all balls are of one
  // SVG: classes and tooltips, by the caller's index; null, as each of them may be, for none.
  const char *const *atom_class = nullptr;
  const char *const *atom_title = nullptr;

  uint32_t colour_of(uint32_t ball) const { return colour == nullptr ? plain_colour : colour[balls.caller[ball]]; }
  uint32_t group_of(uint32_t ball) const { return group == nullptr ? 0 : group[balls.caller[ball]]; }
  const char *class_of(uint32_t ball) const { return text_of(atom_class, ball); }
  const char *title_of(uint32_t ball) const { return text_of(atom_title, ball); }
  const char *text_of(const char *const *texts, uint32_t ball) const {
    return texts == nullptr ? nullptr : texts[balls.caller[ball]];
  }
};

// scratch: as many entries as there are paths. Status::range if the balls are too large for a fixed frame;
// Status::sink if the sink refused. bytes: how many bytes the sink has taken.
Status write_picture(const PictureInput &input, const PictureOptions &options, Span<uint32_t> scratch,
                     SinkFunction function, void *context, uint64_t &bytes);

}  // namespace hsp
