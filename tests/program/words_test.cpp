// Characters eight and sixteen at a time against the same one by one, and numbers in columns against number_parse.
#include <gtest/gtest.h>

#include <algorithm>
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
    char other[16];
    for (char &c : other) c = text[static_cast<size_t>(&c - other) ^ random() % 2];
    const char byte = static_cast<char>(random() % 256), limit = static_cast<char>(1 + random() % 127);
    uint32_t equal = 0, below = 0, either = 0, differ = 0, control = 0;
    for (unsigned i = 0; i < 16; ++i) {
      equal |= static_cast<uint32_t>(text[i] == byte) << i;
      below |= static_cast<uint32_t>(static_cast<unsigned char>(text[i]) < static_cast<unsigned char>(limit)) << i;
      either |= static_cast<uint32_t>(text[i] == byte || text[i] == limit) << i;
      differ |= static_cast<uint32_t>(text[i] != other[i]) << i;
      const auto code = static_cast<unsigned char>(text[i]);
      control |= static_cast<uint32_t>((code < ' ' && code != '\t') || code == 0x7F) << i;
    }
    ASSERT_EQ(equal_in_16(text, byte), equal);
    ASSERT_EQ(below_in_16(text, limit), below);
    ASSERT_EQ(either_in_16(text, byte, limit), either);
    ASSERT_EQ(differ_in_16(text, other), differ);
    ASSERT_EQ(control_in_16(text), control);
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

// Accepted words are right, and words that files write are accepted.
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
  }
  EXPECT_GT(taken, written);
}

// The same of numbers of up to sixteen characters, also of ten times as much; of those that files write all are taken.
TEST(Words, DecimalsOfTwoWords) {
  static const char alphabet[] = "0123456789.. -+eE d1.9x\t";
  std::mt19937_64 random(10);
  size_t taken = 0;
  for (int round = 0; round < 600000; ++round) {
    std::string text;
    const int decimals = static_cast<int>(random() % 9), power = round % 2;
    const bool as_written = round % 3 != 0;
    if (as_written) {
      char number[64];
      const double size[] = {1e-3, 20.0, 2000.0, 1e5, 1e7};
      const double value = (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5) * size[random() % 5];
      std::snprintf(number, sizeof number, "%.*f", decimals, value);
      text = number;
      if (random() % 8 == 0 && decimals > 0 && text[text[0] == '-' ? 1 : 0] == '0') text.erase(text.find('0'), 1);
    } else {
      text.resize(1 + random() % 18);
      for (char &c : text) c = alphabet[random() % (round % 2 == 0 ? 24 : 12)];
    }
    double value = -1.0, expected = -2.0;
    const number_status status = number_parse_times(text.data(), text.size(), power, &expected);
    const std::string behind = text + "7.7777777777777777";
    if (word_decimal(behind.data(), text.size(), power, &value)) {
      ASSERT_EQ(status, NUMBER_OK) << text;
      ASSERT_EQ(std::memcmp(&value, &expected, sizeof value), 0) << text << " times 10^" << power;
      ++taken;
    } else if (as_written) {
      ASSERT_GT(text.size(), 15U) << text;
    }
  }
  EXPECT_GT(taken, 300000U);
  for (const char *text : {"-                ", ".                ", "-.               ", "1.2.3            "}) {
    double value = 0.0;
    EXPECT_FALSE(word_decimal(text, std::string(text).find(' '), 0, &value)) << text;
  }
}

// Fields between blanks as one finds them character by character, in lines of any length.
TEST(Words, FieldsOfALine) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 100000; ++round) {
    const size_t length = random() % (round % 10 == 0 ? 150 : 40);
    std::string text(length + 16, 'x');
    for (size_t i = 0; i < length; ++i) text[i] = "ab  \tcd\x80"[random() % 8];
    const size_t capacity = random() % 8;
    field fields[8];
    size_t count = 0;
    const size_t found = fields_split(text.data(), length, fields, capacity);
    for (size_t at = 0; at < length;) {
      const size_t begin = text.find_first_not_of(" \t", at);
      if (begin >= length) break;
      const size_t end = std::min(text.find_first_of(" \t", begin), length);
      if (count < capacity) {
        ASSERT_EQ(fields[count].text, text.data() + begin);
        ASSERT_EQ(fields[count].length, end - begin);
      }
      ++count;
      at = end;
    }
    ASSERT_EQ(found, count) << text.substr(0, length);
  }
}

TEST(Words, WhatIsNoNumber) {
  for (const char *text : {"        ", "       -", "       .", "      -.", "    1.2.", "   1 2.0", " 1.0    ",
                           "    +1.0", "   1.0e3", "     nan", "\t    1.0", "    1,50"}) {
    double value = 0.0;
    EXPECT_FALSE(word_number(word_at(text), &value)) << text;
  }
}

}  // namespace
