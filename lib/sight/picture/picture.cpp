#include "picture/picture.hpp"

#include "picture/writers.hpp"

namespace hsp {

Status write_picture(const PictureInput &input, const PictureOptions &options, Span<uint32_t> scratch,
                     SinkFunction function, void *context, uint64_t &bytes) {
  const Page page = lay_out(input, options);
  if (!page.possible) return Status::range;
  const Paint paint(input, options, page, scratch);
  ByteSink sink(function, context);
  switch (options.format) {
    case PictureFormat::eps:
      write_eps(sink, input, options, page, paint);
      break;
    case PictureFormat::pdf:
      write_pdf(sink, input, options, page, paint);
      break;
    default:
      write_svg(sink, input, options, page, paint);
  }
  sink.flush();
  bytes = sink.taken();
  return sink.refused() ? Status::sink : Status::ok;
}

}  // namespace hsp
