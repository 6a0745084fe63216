// Compressed bytes are read by zlib as they were.
#include "picture/deflate.hpp"

#include <gtest/gtest.h>
#include <hardsphere.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "random_balls.hpp"

#if HSP_HAS_ZLIB
#include <zlib.h>
#endif

namespace {

using oracle::RandomSource;

// In portions of at most so many bytes.
std::string compressed(const std::string &bytes, size_t portion) {
  std::vector<unsigned char> memory(HSP_PICTURE_MEMORY + 1);
  hsp::Workspace workspace(memory.data() + 1, HSP_PICTURE_MEMORY);
  hsp::Deflater deflater;
  deflater.carve(workspace);
  std::string result;
  const auto append = [&result](const char *piece, size_t count) {
    EXPECT_LE(count, 1024U);
    result.append(piece, count);
  };
  for (size_t k = 0; k < bytes.size(); k += portion) {
    deflater.take(bytes.data() + k, std::min(portion, bytes.size() - k), append);
  }
  deflater.finish(append);
  return result;
}

// Bytes of an alphabet, and repeats of what has been.
std::string repetitive(RandomSource &random, size_t bytes, int64_t alphabet) {
  std::string text;
  while (text.size() < bytes) {
    if (text.size() > 10 && random.one_in(4)) {
      const auto from = static_cast<size_t>(random.in(0, static_cast<int64_t>(text.size()) - 1));
      const auto length = static_cast<size_t>(random.in(1, 400));
      for (size_t k = 0; k < length; ++k) text += text[from + k];
    } else {
      text += static_cast<char>(random.in(0, alphabet - 1));
    }
  }
  return text;
}

TEST(Deflate, NeedsNoMoreMemoryThanTheHeaderSays) {
  hsp::Workspace measuring;
  hsp::Deflater deflater;
  deflater.carve(measuring);
  EXPECT_LE(measuring.bytes(), HSP_PICTURE_MEMORY);
}

TEST(Deflate, DoesNotDependOnPortions) {
  RandomSource random(21);
  for (int k = 0; k < 20; ++k) {
    const std::string text = repetitive(random, static_cast<size_t>(random.in(0, 60000)), random.in(1, 256));
    const std::string whole = compressed(text, text.size() + 1);
    for (const size_t portion : {size_t{1}, size_t{1000}, size_t{1024}, size_t{9000}}) {
      EXPECT_EQ(compressed(text, portion), whole);
    }
  }
}

#if HSP_HAS_ZLIB
// Numbers as pictures have them.
std::string numbers(RandomSource &random, size_t bytes) {
  std::string text;
  while (text.size() < bytes) {
    text += std::to_string(random.in(0, 999)) + '.' + std::to_string(random.in(0, 999)) + ' ';
    if (random.one_in(6)) text += "c\n";
  }
  return text;
}

void expect_whole(const std::string &text) {
  const std::string stream = compressed(text, 1024);
  std::string again(text.size() + 1, '\0');
  uLongf count = again.size();
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef *>(again.data()), &count, reinterpret_cast<const Bytef *>(stream.data()),
                       stream.size()),
            Z_OK);
  again.resize(count);
  ASSERT_TRUE(again == text);
}

TEST(Deflate, KeepsAllBytes) {
  RandomSource random(22);
  expect_whole("");
  for (int value = 0; value < 256; ++value) expect_whole(std::string(1, static_cast<char>(value)));
  for (size_t n = 2; n < 600; ++n) expect_whole(std::string(n, 'a'));
  for (int k = 0; k < 400; ++k) {
    expect_whole(repetitive(random, static_cast<size_t>(random.in(0, k < 360 ? 3000 : 70000)), random.in(1, 256)));
  }
  expect_whole(numbers(random, 300000));
}

TEST(Deflate, KeepsRepeatsAtAllDistances) {
  RandomSource random(23);
  for (const size_t distance : std::vector<size_t>{1, 2, 4, 5, 8191, 8192, 8193, 16383, 16384, 16385}) {
    for (const size_t length : std::vector<size_t>{2, 3, 10, 11, 257, 258, 259, 5000}) {
      std::string text = repetitive(random, 100, 256);
      const std::string first = repetitive(random, distance, 256).substr(0, distance);
      text += first;
      for (size_t k = 0; k < length; ++k) text += text[text.size() - distance];
      expect_whole(text);
    }
  }
}

TEST(Deflate, IsNearlyAsSmallAsZlibMakesIt) {
  RandomSource random(24);
  const std::string text = numbers(random, 200000);
  std::string best(compressBound(text.size()), '\0');
  uLongf count = best.size();
  ASSERT_EQ(compress2(reinterpret_cast<Bytef *>(best.data()), &count, reinterpret_cast<const Bytef *>(text.data()),
                      text.size(), 9),
            Z_OK);
  EXPECT_LT(static_cast<double>(compressed(text, 1024).size()), 1.05 * static_cast<double>(count));
}
#endif

}  // namespace
