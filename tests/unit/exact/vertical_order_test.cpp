// The order of entries along a vertical line against roots worked out to more than enough binary places.
#include "vertical_order_cases.hpp"

#include <algorithm>
#include <array>

#include "expect_cases.hpp"
#include "random_balls.hpp"
#include "root_sums.hpp"
#include "sweep_length.hpp"

namespace {

using hsp::exact::compare_entries;
using hsp::exact::sign_with_root;

constexpr int64_t largest_T = (int64_t{1} << 31) - 1;
constexpr int64_t largest_square = (int64_t{1} << 60) - 1;
constexpr int64_t largest_root = (int64_t{1} << 30) - 1;
constexpr int64_t largest_E = INT64_MAX;

class Numbers : public oracle::RandomSource {
 public:
  using RandomSource::RandomSource;
  // As many small numbers as large ones.
  int64_t up_to(int64_t largest) { return in(0, largest >> in(0, 62)); }
  int64_t either_sign(int64_t value) { return (next() & 1U) != 0 ? value : -value; }
};

void expect_sign_with_root(int64_t E, int64_t T, int64_t b) {
  ASSERT_EQ(sign_with_root(E, T, b), sign_of_sum_with_root(E, T, b)) << E << " + " << T << " sqrt(" << b << ")";
}

TEST(SignWithRoot, OfExtremeValues) {
  for (const int64_t E : {-largest_E, int64_t{-1}, int64_t{0}, int64_t{1}, largest_E}) {
    for (const int64_t T : {-largest_T, int64_t{-1}, int64_t{0}, int64_t{1}, largest_T}) {
      for (const int64_t b : {int64_t{0}, int64_t{1}, int64_t{2}, largest_square - 1, largest_square}) {
        expect_sign_with_root(E, T, b);
      }
    }
  }
  // Where the two terms come nearest at that size.
  for (const int64_t b : {largest_square, largest_root * largest_root, largest_root * largest_root + 1}) {
    for (const int64_t off : {-1, 0, 1}) {
      expect_sign_with_root(-largest_T * largest_root + off, largest_T, b);
      expect_sign_with_root(largest_T * largest_root + off, -largest_T, b);
    }
  }
}

TEST(SignWithRoot, OfRandomValues) {
  Numbers numbers(1);
  for (int k = 0; k < oracle::numbers(750); ++k) {
    expect_sign_with_root(numbers.either_sign(numbers.up_to(largest_E)), numbers.either_sign(numbers.up_to(largest_T)),
                          numbers.up_to(largest_square));
  }
}

TEST(SignWithRoot, OfTiesAndNextToThem) {
  Numbers numbers(2);
  std::array<int, 3> seen{};
  for (int k = 0; k < oracle::numbers(750); ++k) {
    const int64_t root = numbers.up_to(largest_root);
    const int64_t T = numbers.either_sign(numbers.up_to(largest_T));
    const int64_t b = std::clamp(root * root + numbers.in(-1, 1), int64_t{0}, largest_square);
    const int64_t E = -T * root + numbers.in(-1, 1);
    expect_sign_with_root(E, T, b);
    ++seen[static_cast<size_t>(sign_with_root(E, T, b) + 1)];
  }
  for (const int times : seen) EXPECT_GT(times, 50);
}

void expect_order(int64_t z, int64_t a, int64_t b) {
  ASSERT_EQ(compare_entries(z, a, b), sign_of_root_difference(z, b, a))
      << z << " + sqrt(" << b << ") - sqrt(" << a << ")";
  ASSERT_EQ(compare_entries(-z, b, a), -compare_entries(z, a, b)) << z << ' ' << a << ' ' << b;
}

TEST(CompareEntries, OfExtremeValues) {
  constexpr int64_t far = int64_t{1} << 51;
  constexpr int64_t beyond = int64_t{1} << 30;
  for (const int64_t z : {int64_t{0}, int64_t{1}, beyond - 2, beyond - 1, beyond, beyond + 1, far - 1, far}) {
    for (const int64_t a : {int64_t{0}, int64_t{1}, largest_root * largest_root, largest_square}) {
      for (const int64_t b : {int64_t{0}, int64_t{1}, largest_root * largest_root, largest_square}) {
        expect_order(z, a, b);
        expect_order(-z, a, b);
      }
    }
  }
}

TEST(CompareEntries, OfRandomValues) {
  Numbers numbers(3);
  for (int k = 0; k < oracle::numbers(750); ++k) {
    expect_order(numbers.either_sign(numbers.up_to(int64_t{1} << 51)), numbers.up_to(largest_square),
                 numbers.up_to(largest_square));
  }
}

// Differences of roots that are whole, or nearly.
TEST(CompareEntries, OfTiesAndNextToThem) {
  Numbers numbers(4);
  std::array<int, 3> seen{};
  for (int k = 0; k < oracle::numbers(1000); ++k) {
    const int64_t root_a = numbers.up_to(largest_root);
    const int64_t root_b = numbers.up_to(largest_root);
    const int64_t a = std::clamp(root_a * root_a + numbers.in(-1, 1), int64_t{0}, largest_square);
    const int64_t b = std::clamp(root_b * root_b + numbers.in(-1, 1), int64_t{0}, largest_square);
    const int64_t z = root_a - root_b + (numbers.in(0, 3) == 0 ? numbers.in(-1, 1) : 0);
    expect_order(z, a, b);
    ++seen[static_cast<size_t>(compare_entries(z, a, b) + 1)];
    // One number twice is a tie without whole roots.
    expect_order(0, a, a);
  }
  for (const int times : seen) EXPECT_GT(times, 50);
}

TEST(VerticalOrder, Cases) {
  expect_cases(cases::exact_vertical_order);
}

}  // namespace
