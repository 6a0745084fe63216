// The writers of the picture formats. In the files px are the unit.
#pragma once

#include "picture/byte_sink.hpp"
#include "picture/ink.hpp"

namespace hsp {

// Scalable Vector Graphics 1.1; y down.
void write_svg(ByteSink &sink, const PictureInput &input, const PictureOptions &options, const Page &page,
               const Paint &paint);

// Encapsulated PostScript, language level 3; y up. The end of each arc, as written, is within 1e-6 px of the start of
// the next.
void write_eps(ByteSink &sink, const PictureInput &input, const PictureOptions &options, const Page &page,
               const Paint &paint);

// Portable Document Format 1.4, or 1.5 and compressed if the options have memory for that; y up. The unit of the page's
// contents is the page's last decimal, in px.
void write_pdf(ByteSink &sink, const PictureInput &input, const PictureOptions &options, const Page &page,
               const Paint &paint);

}  // namespace hsp
