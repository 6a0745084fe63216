// What files are put together from: numbers, texts, shades, and blocks of bytes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "picture/escaped_text.hpp"
#include "picture/number_text.hpp"
#include "picture/shading.hpp"

namespace {

struct Kept {
  std::string text;
  size_t largest = 0;
  size_t room = SIZE_MAX;
  int calls = 0;
};

int32_t keep(void *context, const char *bytes, size_t count) {
  Kept &kept = *static_cast<Kept *>(context);
  ++kept.calls;
  kept.largest = std::max(kept.largest, count);
  if (kept.text.size() + count > kept.room) return 1;
  kept.text.append(bytes, count);
  return 0;
}

template <class Put>
std::string text_of(Put put) {
  Kept kept;
  hsp::ByteSink sink(keep, &kept);
  put(sink);
  sink.flush();
  return kept.text;
}

// What printf writes, without zeros that say nothing.
std::string by_printf(double value, int decimals) {
  char buffer[400];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  std::string text = buffer;
  if (text.find('.') != std::string::npos) {
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  const bool negative = text.starts_with('-');
  if (negative) text.erase(0, 1);
  if (text.starts_with("0.")) text.erase(0, 1);
  return text == "0" || !negative ? text : "-" + text;
}

TEST(Numbers, AreThoseOfPrintf) {
  std::mt19937_64 random(3);
  int compared = 0;
  for (int k = 0; k < 300000; ++k) {
    const int decimals = static_cast<int>(random() % 11);
    const double unit = static_cast<double>(random() >> 11) * 0x1p-53 - 0.5;
    const double value = unit * std::pow(10.0, static_cast<double>(random() % 14) - 6);
    // Where the next digit is close to a 5 the product's rounding may decide differently.
    const double product = std::fabs(value) * std::pow(10.0, decimals);
    const double beyond = product - std::floor(product);
    if (std::fabs(beyond - 0.5) < 1e-15 * product + 1e-12) continue;
    ++compared;
    ASSERT_EQ(text_of([&](hsp::ByteSink &sink) { hsp::put_decimal(sink, value, decimals); }),
              by_printf(value, decimals))
        << value << " with " << decimals;
  }
  EXPECT_GT(compared, 290000);
}

TEST(Numbers, OfNote) {
  const auto decimal = [](double value, int decimals) {
    return text_of([&](hsp::ByteSink &sink) { hsp::put_decimal(sink, value, decimals); });
  };
  EXPECT_EQ(decimal(0, 3), "0");
  EXPECT_EQ(decimal(-0.0, 3), "0");
  EXPECT_EQ(decimal(-0.0004, 3), "0");
  EXPECT_EQ(decimal(-0.0006, 3), "-.001");
  EXPECT_EQ(decimal(0.5, 0), "1");
  EXPECT_EQ(decimal(-2.5, 0), "-3");
  EXPECT_EQ(decimal(1000, 2), "1000");
  EXPECT_EQ(decimal(999.996, 2), "1000");
  EXPECT_EQ(decimal(10.05, 1), "10.1");
  EXPECT_EQ(decimal(4.5e6, 12), "4500000");
  EXPECT_EQ(text_of([](hsp::ByteSink &sink) { hsp::put_scaled(sink, INT64_MIN, 0); }), "-9223372036854775808");
  EXPECT_EQ(text_of([](hsp::ByteSink &sink) { hsp::put_integer(sink, UINT64_MAX); }), "18446744073709551615");
  EXPECT_EQ(text_of([](hsp::ByteSink &sink) { hsp::put_integer(sink, 15, 10); }), "0000000015");
  EXPECT_EQ(text_of([](hsp::ByteSink &sink) { hsp::put_integer(sink, 0); }), "0");
  EXPECT_EQ(text_of([](hsp::ByteSink &sink) { hsp::put_colour(sink, 0x0A1B2C); }), "0a1b2c");
}

// The headlight's stops before they are rounded to colours: linear in between, within .0034 of the light's range.
TEST(Shades, OfTheHeadlightAreWhereTheyServeBest) {
  const hsp::Shading shading(false);
  const auto light = [&](uint32_t stop) { return shading.lit({{255, 255, 255}}, stop).channel[1]; };
  const double rim = light(shading.intervals());
  const double rise = light(0) - rim;
  double worst = 0;
  for (uint32_t k = 0; k < shading.intervals(); ++k) {
    for (int i = 0; i <= 100; ++i) {
      const double share = i / 100.0;
      const double rho = shading.offset(k) + (shading.offset(k + 1) - shading.offset(k)) * share;
      const double drawn = light(k) + (light(k + 1) - light(k)) * share;
      worst = std::fmax(worst, std::fabs((drawn - rim) / rise - std::sqrt(1 - rho * rho)));
    }
  }
  EXPECT_LE(worst, 0.0034);
}

std::string xml(const char *text) {
  return text_of([text](hsp::ByteSink &sink) { hsp::put_xml_text(sink, text); });
}

TEST(Texts, ForXml) {
  EXPECT_EQ(xml("a<b>&\"c\""), "a&lt;b&gt;&amp;&quot;c&quot;");
  EXPECT_EQ(xml("\x01\x1F\x7F\t\n\r"), "???\t\n?");
  EXPECT_EQ(xml("\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80"), "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
  EXPECT_EQ(xml("\xC3"), "?");
  EXPECT_EQ(xml("\xE2\x82x"), "??x");
  EXPECT_EQ(xml("\x80\xFF\xC0\xAF"), "????");
  EXPECT_EQ(xml("\xED\xA0\x80"), "???");
  EXPECT_EQ(xml("\xF4\x90\x80\x80"), "????");
  EXPECT_EQ(xml("\xE0\x80\x80\xF0\x80\x80\x80"), "???????");
  EXPECT_EQ(xml("\xEF\xBF\xBE\xEF\xBF\xBF\xEF\xBF\xBD"), "??\xEF\xBF\xBD");
  EXPECT_EQ(xml("\xC2\x85\xC2\xA0"), "?\xC2\xA0");
}

TEST(Texts, InParentheses) {
  const auto parenthesized = [](const char *text, uint32_t most) {
    return text_of([&](hsp::ByteSink &sink) { sink.put(hsp::put_parenthesized(sink, text, most)); });
  };
  EXPECT_EQ(parenthesized("a(b)\\c", 0), "(a\\(b\\)\\\\c)");
  EXPECT_EQ(parenthesized("\xC3\xA9t\xE2\x82\n", 0),
            "(?t??"
            "?)");
  EXPECT_EQ(parenthesized("((((", 2), "(\\(\\()((");
  EXPECT_EQ(parenthesized("\x1F ~\x7F", 0), "(? ~?)");
  EXPECT_EQ(parenthesized("", 0), "()");
}

TEST(ByteSinks, HandOnAllBytesInBlocks) {
  for (const size_t count : {0U, 1U, 1023U, 1024U, 1025U, 2048U, 5000U}) {
    Kept kept;
    hsp::ByteSink sink(keep, &kept);
    std::string expected;
    for (size_t k = 0; k < count; ++k) {
      expected += static_cast<char>('a' + k % 26);
      sink.put(expected.back());
      ASSERT_EQ(sink.position(), k + 1);
    }
    sink.flush();
    EXPECT_EQ(kept.text, expected);
    EXPECT_EQ(sink.taken(), count);
    EXPECT_FALSE(sink.refused());
    EXPECT_LE(kept.largest, 1024U);
    EXPECT_EQ(kept.calls, static_cast<int>((count + 1023) / 1024));
  }
}

TEST(ByteSinks, StopWhereTheFunctionRefuses) {
  for (const size_t room : {0U, 1U, 1023U, 1024U, 1025U, 3000U, 3072U}) {
    Kept kept;
    kept.room = room;
    hsp::ByteSink sink(keep, &kept);
    for (int k = 0; k < 4000; ++k) sink.put('x');
    sink.flush();
    EXPECT_TRUE(sink.refused());
    EXPECT_EQ(sink.taken(), room / 1024 * 1024);
    EXPECT_EQ(sink.taken(), kept.text.size());
    EXPECT_EQ(kept.calls, static_cast<int>(room / 1024 + 1));
    EXPECT_EQ(sink.position(), 4000U);
  }
}

}  // namespace
