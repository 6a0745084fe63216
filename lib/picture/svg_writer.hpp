// Scalable Vector Graphics 1.1: user units are px, y down.
#pragma once

#include "picture/byte_sink.hpp"
#include "picture/paint.hpp"

namespace hsp {

void write_svg(ByteSink &sink, const PictureInput &input, const PictureOptions &options, const Page &page,
               const Paint &paint);

}  // namespace hsp
