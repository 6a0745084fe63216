// Decimals against printf, besides the cases.
#include "number_text_cases.hpp"

#include <cmath>
#include <cstdio>
#include <string>

#include "expect_cases.hpp"
#include "random_balls.hpp"

namespace {

// The text that printf writes, without zeros that say nothing.
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

TEST(NumberText, Cases) {
  expect_cases(cases::picture_number_text);
}

TEST(NumberText, IsThatOfPrintf) {
  oracle::RandomSource random(3);
  int compared = 0;
  for (int k = 0; k < 300000; ++k) {
    const int decimals = static_cast<int>(random.in(0, 10));
    const double unit = random.fraction() - 0.5;
    const double value = unit * std::pow(10.0, static_cast<double>(random.in(-6, 7)));
    // Where the next digit is close to a 5 the product's rounding may decide differently.
    const double product = std::fabs(value) * std::pow(10.0, decimals);
    const double beyond = product - std::floor(product);
    if (std::fabs(beyond - 0.5) < 1e-15 * product + 1e-12) continue;
    ++compared;
    ASSERT_EQ(cases::text_of([&](hsp::ByteSink &sink) { hsp::put_decimal(sink, value, decimals); }).text,
              by_printf(value, decimals))
        << value << " with " << decimals;
  }
  EXPECT_GT(compared, 290000);
}

}  // namespace
