// Number parsing against numbers whose nearest double is known, and against the C library on random text.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>

extern "C" {
#include "read/number.h"
}

namespace {

double parsed(const std::string &text) {
  double value = -12345;
  EXPECT_EQ(number_parse(text.data(), text.size(), &value), NUMBER_OK) << text.substr(0, 60);
  return value;
}

number_status status_of(const std::string &text) {
  double value = -12345;
  const number_status status = number_parse(text.data(), text.size(), &value);
  if (status != NUMBER_OK) {
    EXPECT_EQ(value, -12345) << text;
  }
  return status;
}

TEST(Number, Spellings) {
  for (const char *one : {"1", "+1", "1.", "1.0", "01", "001.000", "1e0", "1E0", "1d0", "1D+0", "10e-1", ".1e1",
                          "0.1d01", "100000e-5", "1e-0", "0.00001e5", "1e+00000000000000000000000"}) {
    EXPECT_EQ(parsed(one), 1.0) << one;
  }
  EXPECT_EQ(parsed(".5"), 0.5);
  EXPECT_EQ(parsed("5."), 5.0);
  EXPECT_EQ(parsed("-.5"), -0.5);
  EXPECT_EQ(parsed("1d3"), 1000.0);
  EXPECT_EQ(parsed("0.1"), 0.1);
  EXPECT_EQ(parsed("12345678.90625"), 12345678.90625);
}

// A power of ten is part of the number before it is rounded: 0.3 x 10 is 3, and 2.9 is the double nearest to it.
TEST(Number, TimesAPowerOfTen) {
  const auto times = [](const std::string &text, int power) {
    double value = -12345;
    EXPECT_EQ(number_parse_times(text.data(), text.size(), power, &value), NUMBER_OK) << text;
    return value;
  };
  EXPECT_EQ(times("0.29", 1), 2.9);
  EXPECT_EQ(times("-0.0586", 1), -0.586);
  EXPECT_EQ(times("58.6", -1), 5.86);
  EXPECT_EQ(times("12345678901234567890123", -22), 1.2345678901234567890123);
  EXPECT_EQ(times("0", 5), 0.0);
  EXPECT_EQ(times("1e-2", 3), 10.0);
  double value = 7;
  EXPECT_EQ(number_parse_times("1e308", 5, 1, &value), NUMBER_TOO_LARGE);
}

TEST(Number, Zeros) {
  for (const char *zero : {"0", "-0", "0.000", ".0", "0.", "0e999999999999999999999999", "0d-99999999999999999999"}) {
    EXPECT_EQ(parsed(zero), 0.0) << zero;
  }
  EXPECT_TRUE(std::signbit(parsed("-0")));
}

TEST(Number, Refused) {
  for (const char *text :
       {"",      "+",   "-",     ".",    "e5",    ".e5",  "1e",       "1e+",           "1d-",   "1e5.0", "1.2.3",
        "--1",   "+-1", "1-",    "1,5",  "1 ",    " 1",   "0x10",     "0x1p3",         "1f",    "1.0L",  "1_0",
        "1e5e5", "one", "1e5d5", "nano", "infin", "1..2", "\xC2\xBD", "1\xE2\x88\x92", "1'000", "nan(1)"}) {
    EXPECT_EQ(status_of(text), NUMBER_SYNTAX) << text;
  }
  for (const char *text : {"nan", "NaN", "-nan", "inf", "+Inf", "-INF", "infinity", "-Infinity"}) {
    EXPECT_EQ(status_of(text), NUMBER_NOT_FINITE) << text;
  }
  for (const char *text : {"1e309", "-1e309", "1.7976931348623159e308", "1e999999999999999999999999", "2d308"}) {
    EXPECT_EQ(status_of(text), NUMBER_TOO_LARGE) << text;
  }
}

// The text ends at its length, whatever stands behind.
TEST(Number, ReadsNoFurtherThanToldTo) {
  const char text[] = "12345";
  double value = 0;
  ASSERT_EQ(number_parse(text, 3, &value), NUMBER_OK);
  EXPECT_EQ(value, 123.0);
  uint64_t count = 0;
  ASSERT_EQ(number_parse_count(text, 2, &count), NUMBER_OK);
  EXPECT_EQ(count, 12u);
}

TEST(Number, ExtremesOfTheDouble) {
  using limits = std::numeric_limits<double>;
  EXPECT_EQ(parsed("1.7976931348623157e308"), limits::max());
  EXPECT_EQ(parsed("1.7976931348623158e308"), limits::max());
  EXPECT_EQ(parsed("2.2250738585072014e-308"), limits::min());
  EXPECT_EQ(parsed("4.9406564584124654e-324"), limits::denorm_min());
  EXPECT_EQ(parsed("2.4703282292062328e-324"), limits::denorm_min());  // just above half of it
  EXPECT_EQ(parsed("2.4703282292062327e-324"), 0.0);                   // just below half of it
  EXPECT_EQ(parsed("1e-400"), 0.0);
  EXPECT_EQ(parsed("1e-999999999999999999999999999"), 0.0);
  EXPECT_EQ(parsed("0." + std::string(400, '0') + "1e401"), 1.0);
  EXPECT_EQ(parsed("1" + std::string(400, '0') + "e-400"), 1.0);
  EXPECT_EQ(parsed("0." + std::string(100000, '0') + "1e100001"), 1.0);
  EXPECT_EQ(parsed("1" + std::string(100000, '0') + "e-100000"), 1.0);
}

// 2^53 + 1 lies midway between two doubles: ties go to the even one, anything beyond the tie goes up, however far
// behind the point it stands.
TEST(Number, TiesAndWhatBreaksThem) {
  const double below = 9007199254740992.0;
  const double above = 9007199254740994.0;
  EXPECT_EQ(parsed("9007199254740993"), below);
  for (const int zeros : {0, 1, 20, 700, 783, 784, 785, 799, 800, 801, 5000}) {
    const std::string many(static_cast<size_t>(zeros), '0');
    EXPECT_EQ(parsed("9007199254740993." + many), below) << zeros;
    EXPECT_EQ(parsed("9007199254740993." + many + "1"), above) << zeros;
    EXPECT_EQ(parsed("9007199254740993" + many + "1e-" + std::to_string(zeros + 1)), above) << zeros;
  }
  const std::string nines(5000, '9');
  EXPECT_EQ(parsed("9007199254740992." + nines), below);
  EXPECT_EQ(parsed("9007199254740995." + nines), 9007199254740996.0);
}

std::string random_digits(std::mt19937_64 &random, int most) {
  std::string digits;
  const int count = static_cast<int>(random() % static_cast<unsigned>(most + 1));
  for (int i = 0; i < count; ++i) digits.push_back(static_cast<char>('0' + random() % 10));
  return digits;
}

TEST(Number, AgreesWithTheCLibraryOnRandomText) {
  std::mt19937_64 random(20240917);
  for (int round = 0; round < 200000; ++round) {
    std::string text = random() % 3 == 0 ? "-" : "";
    text += random_digits(random, 30);
    if (random() % 2 == 0) text.append(".").append(random_digits(random, 40));
    if (text.find_first_of("0123456789") == std::string::npos) text += "7";
    if (random() % 2 == 0) {
      text.append("e").append(std::to_string(static_cast<int>(random() % 700) - 350));
    }
    const double expected = std::strtod(text.c_str(), nullptr);
    if (std::isinf(expected)) {
      EXPECT_EQ(status_of(text), NUMBER_TOO_LARGE) << text;
    } else {
      const double actual = parsed(text);
      EXPECT_EQ(std::memcmp(&actual, &expected, sizeof actual), 0) << text;
    }
  }
}

// Every double comes back from 17 digits.
TEST(Number, RoundTrips) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 200000; ++round) {
    const uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    const double actual = parsed(text);
    EXPECT_EQ(std::memcmp(&actual, &value, sizeof actual), 0) << text;
  }
}

TEST(Number, Counts) {
  uint64_t count = 99;
  EXPECT_EQ(number_parse_count("0", 1, &count), NUMBER_OK);
  EXPECT_EQ(count, 0u);
  EXPECT_EQ(number_parse_count("+24", 3, &count), NUMBER_OK);
  EXPECT_EQ(count, 24u);
  EXPECT_EQ(number_parse_count("18446744073709551615", 20, &count), NUMBER_OK);
  EXPECT_EQ(count, UINT64_MAX);
  EXPECT_EQ(number_parse_count("18446744073709551616", 20, &count), NUMBER_TOO_LARGE);
  for (const char *text : {"", "+", "-1", "1.0", "1e3", "0x1", "a", "1 "}) {
    EXPECT_EQ(number_parse_count(text, std::strlen(text), &count), NUMBER_SYNTAX) << text;
  }
}

}  // namespace
