// Numbers as text against the C library: the first of 15, 16 and 17 digits that strtod reads back, "%.*g"
// and "%.*f".
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
#include "read/number_text.h"
}

namespace {

constexpr int kMostDecimals = 10;

std::string exact(double value) {
  char text[NUMBER_BYTES];
  const size_t length = number_text_exact(text, value);
  EXPECT_EQ(length, std::strlen(text));
  return text;
}

std::string fixed(double value, int decimals) {
  char text[NUMBER_BYTES];
  const size_t length = number_text_fixed(text, value, decimals);
  EXPECT_EQ(length, std::strlen(text));
  return text;
}

std::string general(double value, int digits) {
  char text[NUMBER_BYTES];
  const size_t length = number_text_general(text, value, digits);
  EXPECT_EQ(length, std::strlen(text));
  return text;
}

std::string exact_by_trial(double value) {
  char text[64];
  for (int digits = 15; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value == 0.0 ? 0.0 : value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return text;
}

std::string fixed_by_printf(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string general_by_printf(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

// Both signs, as the text must not depend on it.
void check(double value, int decimals) {
  for (const double number : {value, -value}) {
    ASSERT_EQ(exact(number), exact_by_trial(number)) << std::hexfloat << number;
    for (const int digits : {decimals + 1, 17 - decimals}) {
      ASSERT_EQ(general(number, digits), general_by_printf(number, digits)) << std::hexfloat << number << ' ' << digits;
    }
    if (std::fabs(number) >= 1e21) continue;
    ASSERT_EQ(fixed(number, decimals), fixed_by_printf(number, decimals)) << std::hexfloat << number;
  }
}

void check_all_decimals(double value) {
  for (int decimals = 0; decimals <= kMostDecimals; ++decimals) check(value, decimals);
}

// The double and the three on either side of it.
void check_around(double value) {
  for (int step = -3; step <= 3; ++step) {
    double number = value;
    for (int k = 0; k < std::abs(step); ++k) number = std::nextafter(number, step < 0 ? 0.0 : HUGE_VAL);
    if (std::isfinite(number)) check_all_decimals(number);
  }
}

TEST(NumberText, PowersOfTwo) {
  for (int power = -1074; power <= 1023; ++power) check_around(std::ldexp(1.0, power));
}

TEST(NumberText, PowersOfTen) {
  for (int power = -323; power <= 308; ++power)
    check_around(std::strtod(("1e" + std::to_string(power)).c_str(), nullptr));
}

TEST(NumberText, ZerosAndTheLeastAndTheLargest) {
  EXPECT_EQ(exact(0.0), "0");
  EXPECT_EQ(exact(-0.0), "0");
  EXPECT_EQ(general(0.0, 9), "0");
  EXPECT_EQ(general(-0.0, 9), "-0");
  EXPECT_EQ(general(999999.5, 6), "1e+06");
  EXPECT_EQ(general(0.0000999996, 5), "0.0001");
  EXPECT_EQ(fixed(0.0, 4), "0.0000");
  EXPECT_EQ(fixed(-0.0, 1), "-0.0");
  EXPECT_EQ(exact(0.1), "0.1");
  EXPECT_EQ(exact(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(exact(0.0001), "0.0001");
  EXPECT_EQ(exact(0.00001), "1e-05");
  EXPECT_EQ(exact(1.5e-7), "1.5e-07");
  EXPECT_EQ(fixed(9.99995, 4), fixed_by_printf(9.99995, 4));
  check_around(std::numeric_limits<double>::denorm_min());
  check_around(std::numeric_limits<double>::min());
  check_around(std::numeric_limits<double>::max());
}

TEST(NumberText, WhatIsNotFinite) {
  for (const double value : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(exact(value), exact_by_trial(value));
    EXPECT_EQ(general(value, 9), general_by_printf(value, 9));
    EXPECT_EQ(fixed(value, 3), fixed_by_printf(value, 3));
  }
}

// Halves of the last decimal are exact in binary for a few decimals: ties go to the even digit.
TEST(NumberText, HalvesOfTheLastDecimal) {
  for (int whole = 0; whole < 200; ++whole) {
    for (int part = 1; part < 256; part += 2) check_all_decimals(whole + part / 256.0);
    check_all_decimals(whole + 0.5);
  }
  for (int decimals = 0; decimals <= kMostDecimals; ++decimals) {
    for (int k = 0; k < 2000; ++k) check((k + 0.5) * std::pow(10.0, -decimals), decimals);
  }
}

// Decimals as files write them, halves between two doubles, and any doubles.
TEST(NumberText, RandomNumbers) {
  std::mt19937_64 random(20261124);
  for (int round = 0; round < 1000000 / 16; ++round) {
    const auto part = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const int decimals = static_cast<int>(random() % (kMostDecimals + 1));
    const auto of_bits = [&](uint64_t bits) {
      double value;
      std::memcpy(&value, &bits, sizeof value);
      return value;
    };
    const uint64_t exponent = 1023 - 36 + random() % 90;
    check(part() * 60, decimals);
    check(part() * 1e5, decimals);
    check(static_cast<double>(random() % 2000000) / 1000.0, decimals);
    check(static_cast<double>(random() % 200000000) / 1e5, decimals);
    check(part() * 1e-6, decimals);
    check(std::fabs(of_bits((random() & ((UINT64_C(1) << 52) - 1)) | exponent << 52)), decimals);
    check(static_cast<double>(static_cast<float>(part() * 200)), decimals);
    const double any = std::fabs(of_bits(random()));
    if (std::isfinite(any)) check(any, decimals);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
