// Decimals with a pitfall, integers and colours as text.
#pragma once

#include "cases.hpp"
#include "kept_text.hpp"
#include "picture/number_text.hpp"

namespace cases {

struct DecimalText {
  double value;
  int decimals;
  const char *expected;
};
constexpr DecimalText decimal_texts[] = {
    {0, 3, "0"},     {-0.0, 3, "0"},    {-0.0004, 3, "0"},    {-0.0006, 3, "-.001"}, {0.5, 0, "1"},
    {-2.5, 0, "-3"}, {1000, 2, "1000"}, {999.996, 2, "1000"}, {10.05, 1, "10.1"},    {4.5e6, 12, "4500000"}};

inline uint32_t decimals_with_a_pitfall() {
  return first_failing(decimal_texts, [](const DecimalText &c) {
    return text_of([&c](hsp::ByteSink &sink) { hsp::put_decimal(sink, c.value, c.decimals); }).is(c.expected);
  });
}

struct IntegerText {
  uint64_t value;
  int digits;
  const char *expected;
};
constexpr IntegerText integer_texts[] = {{UINT64_MAX, 1, "18446744073709551615"}, {15, 10, "0000000015"}, {0, 1, "0"}};

inline uint32_t integers() {
  return first_failing(integer_texts, [](const IntegerText &c) {
    return text_of([&c](hsp::ByteSink &sink) { hsp::put_integer(sink, c.value, c.digits); }).is(c.expected);
  });
}

inline uint32_t least_number_and_colour() {
  const bool conditions[] = {
      text_of([](hsp::ByteSink &sink) { hsp::put_scaled(sink, INT64_MIN, 0); }).is("-9223372036854775808"),
      text_of([](hsp::ByteSink &sink) { hsp::put_colour(sink, 0x0A1B2C); }).is("0a1b2c")};
  return first_false(conditions);
}

inline constexpr Check picture_number_text[] = {{"decimals_with_a_pitfall", decimals_with_a_pitfall},
                                                {"integers", integers},
                                                {"least_number_and_colour", least_number_and_colour}};

}  // namespace cases
