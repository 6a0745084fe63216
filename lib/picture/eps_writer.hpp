// Encapsulated PostScript, language level 3. In the file px are the unit and y is up.
#pragma once

#include "picture/byte_sink.hpp"
#include "picture/paint.hpp"

namespace hsp {

// The end of each arc, as written, is within 1e-6 px of the start of the next.
void write_eps(ByteSink &sink, const PictureInput &input, const PictureOptions &options, const Page &page,
               const Paint &paint);

}  // namespace hsp
