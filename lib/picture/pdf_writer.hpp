// Portable Document Format 1.4, without compression. In the page's content px are the unit and y is up.
#pragma once

#include "picture/byte_sink.hpp"
#include "picture/paint.hpp"

namespace hsp {

void write_pdf(ByteSink &sink, const PictureInput &input, const PictureOptions &options, const Page &page,
               const Paint &paint);

}  // namespace hsp
