// Compressed PDF files hold what others hold, and their tables lead to all objects.
#include <gtest/gtest.h>
#include <hardsphere.h>

#include <cstddef>
#include <string>
#include <vector>

#include "small_picture.hpp"

#if HSP_HAS_ZLIB
#include <zlib.h>

namespace {

using cases::staggered;

std::string file(hsp::PictureStyle style, bool compressed) {
  static std::vector<unsigned char> memory(HSP_PICTURE_MEMORY);
  hsp::PictureOptions options;
  options.format = hsp::PictureFormat::pdf;
  options.style = style;
  if (compressed) {
    options.memory = memory.data();
    options.memory_bytes = memory.size();
  }
  EXPECT_TRUE(cases::small_view().succeeds(staggered, 4));
  const cases::PictureText &text = cases::written(hsp::write_pdf, cases::picture_input(nullptr, "balls"), options);
  return {text.text, text.size};
}

std::string between(const std::string &text, const std::string &before, const std::string &after) {
  const size_t start = text.find(before);
  if (start == std::string::npos) return "no " + before;
  const size_t from = start + before.size();
  return text.substr(from, text.find(after, from) - from);
}

// The number that is object `number`.
size_t number_object(const std::string &text, const std::string &number) {
  return std::stoul(between(text, '\n' + number + " 0 obj\n", "\nendobj"));
}

// The stream of object `number`, whose length is object `length`, before it was compressed.
std::string inflated(const std::string &text, const std::string &number, const std::string &length) {
  const size_t from = text.find("stream\n", text.find('\n' + number + " 0 obj\n")) + 7;
  const size_t bytes = number_object(text, length);
  EXPECT_EQ(text.substr(from + bytes, 11), "\nendstream\n");
  std::string again(1 << 20, '\0');
  uLongf count = again.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef *>(again.data()), &count,
                       reinterpret_cast<const Bytef *>(text.data() + from), bytes),
            Z_OK);
  again.resize(count);
  return again;
}

uint64_t big_endian(const std::string &bytes) {
  uint64_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

class CompressedPdf : public testing::TestWithParam<hsp::PictureStyle> {};

TEST_P(CompressedPdf, HoldsWhatOthersHold) {
  const std::string plain = file(GetParam(), false), packed = file(GetParam(), true);
  ASSERT_FALSE(packed.empty());
  EXPECT_EQ(packed.substr(0, 9), "%PDF-1.5\n");
  EXPECT_EQ(packed.substr(packed.size() - 6), "%%EOF\n");
  EXPECT_EQ(inflated(packed, "5", "6"), between(plain, "<</Length 6 0 R>>\nstream\n", "endstream"));
  EXPECT_EQ(inflated(packed, "8", "9"), "4 0\n" + between(plain, "\n4 0 obj\n", "\nendobj"));
  for (const std::string number : {"1", "2", "3", "7"}) {
    const std::string begin = '\n' + number + " 0 obj\n";
    EXPECT_EQ(between(packed, begin, "\nendobj"), between(plain, begin, "\nendobj"));
  }
}

TEST_P(CompressedPdf, HasATableThatLeadsToAllObjects) {
  const std::string text = file(GetParam(), true);
  const size_t start = std::stoul(between(text, "\nstartxref\n", "\n%%EOF"));
  ASSERT_EQ(text.substr(start, 9), "10 0 obj\n");
  const std::string heading = between(text.substr(start), "obj\n", "\nstream\n");
  EXPECT_EQ(heading, "<</Type/XRef/Size 11/W[1 8 2]/Root 1 0 R/Info 7 0 R/Length 121>>");
  const size_t entries = text.find("stream\n", start) + 7;
  ASSERT_EQ(text.substr(entries + 121, 11), "\nendstream\n");
  for (size_t object = 0; object <= 10; ++object) {
    const std::string entry = text.substr(entries + 11 * object, 11);
    const uint64_t place = big_endian(entry.substr(1, 8));
    if (object == 0) {
      EXPECT_EQ(big_endian(entry), 65535U);
    } else if (object == 4) {
      EXPECT_EQ(entry[0], 2);
      EXPECT_EQ(place, 8U);
    } else {
      EXPECT_EQ(entry[0], 1);
      const std::string begin = std::to_string(object) + " 0 obj\n";
      EXPECT_EQ(text.substr(static_cast<size_t>(place), begin.size()), begin);
    }
    EXPECT_EQ(big_endian(entry.substr(9)), object == 0 ? 65535U : 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Styles, CompressedPdf,
                         testing::Values(hsp::PictureStyle::flat, hsp::PictureStyle::headlight,
                                         hsp::PictureStyle::soft));

}  // namespace
#endif
