// Lines of any length and with any ends, wherever the blocks end that a file is read in, against the text that was
// written.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "temporary_file.hpp"

extern "C" {
#include "read/line_reader.h"
}

namespace {

struct Line {
  std::string text;
  std::string ending;
};

bool operator==(const Line &a, const Line &b) {
  return a.text == b.text && a.ending == b.ending;
}

// The text that is read; `why` is set if it ends before the file does.
std::vector<Line> lines_of(const std::string &text, failure *why) {
  const TemporaryFile file("lines.txt", text);
  line_reader reader;
  std::vector<Line> lines;
  *why = FAILURE_NONE;
  EXPECT_TRUE(line_reader_open(&reader, file.path().c_str(), why));
  while (line_reader_next(&reader, why) == LINE_READ) {
    EXPECT_EQ(reader.text[reader.length], '\0');
    lines.push_back({std::string(reader.text, reader.length), reader.ending});
    EXPECT_EQ(reader.number, lines.size());
  }
  line_reader_close(&reader);
  return lines;
}

void check(const std::vector<Line> &lines) {
  std::string text;
  for (const Line &line : lines) text += line.text + line.ending;
  failure why;
  const std::vector<Line> read = lines_of(text, &why);
  EXPECT_EQ(why.reason, std::string());
  ASSERT_EQ(read.size(), lines.size());
  for (size_t i = 0; i < lines.size(); ++i) ASSERT_TRUE(read[i] == lines[i]) << i;
}

TEST(LineReader, EndsThatBlocksCutInTwo) {
  for (const size_t block : {size_t{LINE_READER_BLOCK}, size_t{2} * LINE_READER_BLOCK}) {
    for (size_t back = 0; back < 4; ++back) {
      for (const char *ending : {"\n", "\r\n", "\r"}) {
        check({{"first", ending},
               {std::string(block - 5 - std::string(ending).size() - back, 'x'), ending},
               {"last", ""}});
        check({{std::string(block - back, 'y'), ending}, {"", ending}, {"z", ending}});
      }
    }
  }
}

TEST(LineReader, LinesOfAnyLength) {
  std::mt19937 random(3);
  for (int round = 0; round < 40; ++round) {
    std::vector<Line> lines;
    for (int i = 0; i < 300; ++i) {
      const size_t length = random() % 40 == 0 ? random() % 90000 : random() % 100;
      // A line that is empty behind one that ends in CR must not begin with LF.
      std::string text;
      for (size_t k = 0; k < length; ++k) text += "ab \t\x81\xFF~1"[random() % 8];
      const char *const ends[] = {"\n", "\r\n", "\r"};
      std::string ending = ends[random() % 3];
      if (text.empty() && ending == "\n" && !lines.empty() && lines.back().ending == "\r") ending = "\r\n";
      lines.push_back({text, ending});
    }
    check(lines);
  }
}

TEST(LineReader, TheMarkAtTheBeginning) {
  failure why;
  const std::vector<Line> lines = lines_of("\xEF\xBB\xBFone\n\xEF\xBB\xBFtwo", &why);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].text, "one");
  EXPECT_EQ(lines[1].text, "\xEF\xBB\xBFtwo");
  EXPECT_TRUE(lines_of("", &why).empty());
}

// Lines that are passed at once, and those between them, are all lines of the file. None that is passed begins with the
// mark, ends otherwise or breaks off; and no line that might have been is read by itself.
TEST(LineReader, LinesThatArePassed) {
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round) {
    std::string text, joined;
    for (int i = 0; i < 800; ++i) {
      const size_t length = random() % 60 == 0 ? random() % 9000 : random() % 40;
      std::string line;
      for (size_t k = 0; k < length; ++k) line += "ab $\t\x81\xFF~"[random() % 8];
      if (random() % 3 > 0 && !line.empty() && line[0] == '$') line[0] = 'c';
      text += line + (random() % (round % 2 == 0 ? 100 : 9) > 0 || line.empty() ? "\n"
                      : random() % 2 == 0                                       ? "\r\n"
                                                                                : "\r");
    }
    const TemporaryFile file("lines.txt", text);
    line_reader reader;
    failure why = FAILURE_NONE;
    ASSERT_TRUE(line_reader_open(&reader, file.path().c_str(), &why));
    size_t passes = 0;
    for (;;) {
      const char *passed = nullptr;
      size_t bytes = 0;
      const uint64_t before = reader.number, count = line_reader_pass(&reader, '$', &passed, &bytes);
      const std::string lines(passed == nullptr ? "" : passed, bytes);
      ASSERT_EQ(reader.number, before + count);
      ASSERT_EQ(static_cast<uint64_t>(std::count(lines.begin(), lines.end(), '\n')), count);
      ASSERT_EQ(lines.find('\r'), std::string::npos);
      ASSERT_TRUE(bytes == 0 || (lines[0] != '$' && lines.find("\n$") == std::string::npos && lines.back() == '\n'));
      joined += lines;
      passes += count > 1 ? 1 : 0;
      const size_t next = reader.next, filled = reader.filled;
      if (line_reader_next(&reader, &why) != LINE_READ) break;
      const bool within = reader.filled == filled && reader.next > next;
      ASSERT_TRUE(!within || reader.text[0] == '$' || std::string(reader.ending) != "\n") << reader.text;
      joined += std::string(reader.text, reader.length) + reader.ending;
    }
    EXPECT_EQ(why.reason, std::string());
    ASSERT_TRUE(joined == text);
    EXPECT_GT(passes, 20U);
    line_reader_close(&reader);
  }
}

// In any place of a word: every control character but a tab.
// Ctrl-Z ends a text if nothing but ends of lines follows, wherever blocks end; elsewhere it is no text.
TEST(LineReader, TheMarkAtTheEnd) {
  const std::string mark = "\x1A";
  for (const size_t length : {size_t{3}, size_t{LINE_READER_BLOCK} - 2, size_t{LINE_READER_BLOCK} - 1,
                              size_t{LINE_READER_BLOCK}, size_t{LINE_READER_BLOCK} + 1}) {
    for (const std::string &ending : {std::string(), std::string("\n"), std::string("\r\n"), std::string("\r")}) {
      const std::string line(length, 'a');
      for (const std::string &behind : {std::string(), std::string("\n"), std::string("\r\n\r\n"),
                                        std::string(3 * size_t{LINE_READER_BLOCK}, '\n')}) {
        std::string text = line;
        text.append(ending).append(mark).append(behind);
        failure why;
        const std::vector<Line> lines = lines_of(text, &why);
        EXPECT_EQ(why.reason, std::string());
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_TRUE(lines[0] == (Line{line, ending}));
        text += "a";
        lines_of(text, &why);
        EXPECT_NE(std::string(why.reason).find("binary data (byte 0x1A)"), std::string::npos) << why.reason;
        EXPECT_EQ(why.line, ending.empty() ? 1U : 2U);
      }
    }
  }
  failure why;
  EXPECT_TRUE(lines_of(mark, &why).empty());
  EXPECT_EQ(why.reason, std::string());
  lines_of(mark + mark, &why);
  EXPECT_NE(why.reason[0], '\0');
}

TEST(LineReader, BytesOfNoText) {
  for (int byte = 0; byte < 256; ++byte) {
    const bool control = (byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7F;
    for (size_t at = 0; at < 17; ++at) {
      std::string text(40, 'a');
      text[at] = static_cast<char>(byte);
      failure why;
      lines_of("one\n" + text, &why);
      ASSERT_EQ(why.reason[0] != '\0', control) << byte << ' ' << at;
      if (control) {
        ASSERT_EQ(why.line, 2U);
      }
    }
  }
}

}  // namespace
