// A view as a vector picture.
#pragma once

#include "picture/byte_sink.hpp"
#include "picture/picture_input.hpp"

namespace hsp {

// scratch: as many entries as there are pieces. Status::sink if the sink refused; bytes: those that it has taken.
Status write_picture(const PictureInput &input, const PictureOptions &options, Span<uint32_t> scratch,
                     SinkFunction function, void *context, uint64_t &bytes);

}  // namespace hsp
