// Characters eight and sixteen at a time against the same one by one, and numbers in columns against number_parse.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>

extern "C" {
#include "read/fields.h"
#include "read/number.h"
#include "read/words.h"
}

namespace {

std::string without_blanks(const std::string &text) {
  const size_t begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

TEST(Words, BitsOfSixteenCharacters) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 20000; ++round) {
    char text[16];
    for (char &c : text) c = static_cast<char>(random() % (round % 2 == 0 ? 256 : 40));
    const char byte = static_cast<char>(random() % 256), limit = static_cast<char>(1 + random() % 127);
    uint32_t equal = 0, below = 0;
    for (unsigned i = 0; i < 16; ++i) {
      equal |= static_cast<uint32_t>(text[i] == byte) << i;
      below |= static_cast<uint32_t>(static_cast<unsigned char>(text[i]) < static_cast<unsigned char>(limit)) << i;
    }
    ASSERT_EQ(equal_in_16(text, byte), equal);
    ASSERT_EQ(below_in_16(text, limit), below);
  }
}

TEST(Words, TheFirstOfACharacter) {
  for (int at = 0; at < 9; ++at) {
    std::string text = "abcd\x81_\xFF~";
    if (at < 8) text[static_cast<size_t>(at)] = '.';
    const uint64_t found = word_find(word_at(text.data()), '.');
    if (at == 8) {
      EXPECT_EQ(found, 0U);
    } else {
      EXPECT_EQ(lowest_bit(found) / 8, static_cast<unsigned>(at));
    }
  }
}

TEST(Words, LabelsAreColumnsWithoutBlanks) {
  std::mt19937_64 random(8);
  for (int round = 0; round < 20000; ++round) {
    std::string text(8, ' ');
    for (char &c : text) c = " AB1"[random() % 4];
    const unsigned width = 1 + static_cast<unsigned>(random() % 8);
    char label[9] = "";
    word_put(label, word_label(word_at(text.data()), width));
    ASSERT_EQ(std::string(label), without_blanks(text.substr(0, width))) << text << '|' << width;
  }
}

// What is taken is right, and what files write is taken.
TEST(Words, NumbersInEightColumns) {
  static const char alphabet[] = "0123456789.. -+eE d1.9x\t";
  std::mt19937_64 random(9);
  size_t taken = 0, written = 0;
  for (int round = 0; round < 400000; ++round) {
    std::string text(8, ' ');
    const bool as_written = round % 2 == 0;
    if (as_written) {
      char number[64];
      const double value = (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5) * (round % 3 == 0 ? 20.0 : 2000.0);
      std::snprintf(number, sizeof number, "%8.*f", static_cast<int>(random() % 4), value);
      text = std::string(number).substr(0, 8);
      ++written;
    } else {
      for (char &c : text) c = alphabet[random() % 24];
    }
    double value = -1.0, expected = -2.0;
    const std::string digits = without_blanks(text);
    const number_status status = number_parse(digits.data(), digits.size(), &expected);
    if (word_number(word_at(text.data()), &value)) {
      ASSERT_EQ(status, NUMBER_OK) << text;
      ASSERT_EQ(std::memcmp(&value, &expected, sizeof value), 0) << text;
      ++taken;
    } else {
      ASSERT_FALSE(as_written) << text;
    }
    std::string behind = digits + "1111111";
    const bool token = word_token(behind.data(), digits.size(), &value);
    if (as_written) {
      ASSERT_TRUE(token) << digits;
    }
    if (token) {
      ASSERT_EQ(status, NUMBER_OK) << digits;
      ASSERT_EQ(std::memcmp(&value, &expected, sizeof value), 0) << digits;
    }
  }
  EXPECT_GT(taken, written);
}

TEST(Words, WhatIsNoNumber) {
  for (const char *text : {"        ", "       -", "       .", "      -.", "    1.2.", "   1 2.0", " 1.0    ",
                           "    +1.0", "   1.0e3", "     nan", "\t    1.0", "    1,50"}) {
    double value = 0.0;
    EXPECT_FALSE(word_number(word_at(text), &value)) << text;
  }
}

}  // namespace
