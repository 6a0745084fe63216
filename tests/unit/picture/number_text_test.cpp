// Decimals against printf, and numbers with a pitfall.
#include "picture/number_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "kept_bytes.hpp"

namespace {

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

}  // namespace
