// Long work says on a terminal what it is at, in one line that is gone at the end. Nobody else sees it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Words = std::vector<std::string>;

// Rows of balls that do not meet; blanks make the lines longer.
std::string balls(int count, const std::string &tail = "") {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += std::to_string(3 * (i % 150)) + " " + std::to_string(3 * (i / 150)) + " 0 1" + tail + "\n";
  return text;
}

// The texts that a terminal's one line shows one after the other; what stands there at the end is the last one.
Words shown(const std::string &err) {
  Words texts;
  size_t at = 0;
  while (at < err.size()) {
    EXPECT_EQ(err[at], '\r') << err;
    const size_t end = std::min(err.find('\r', at + 1), err.size());
    const std::string text = err.substr(at + 1, end - at - 1);
    EXPECT_TRUE(text.empty() || text.size() >= 60) << "does not cover what stood there: " << text;
    texts.push_back(text.substr(0, text.find_last_not_of(' ') + 1));
    at = end;
  }
  return texts;
}

struct Long {
  Words arguments;  // before the file
  Words texts;
};

TEST(Progress, OnTerminalsOnly) {
  const TemporaryFile large("large.xyzr", balls(20001)), small("small.xyzr", balls(20000));
  const TemporaryFile picture("large.svg");
  const std::string model = "building the model", boundary = "computing the boundary";
  const std::vector<Long> runs = {
      {{"model"}, {model, "counting overlaps"}},
      {{"boundary"}, {model, boundary, "computing the topology"}},
      {{"measure"}, {model, boundary, "measuring"}},
      {{"measure", "--gradient", "--csv"}, {model, boundary, "measuring", "computing derivatives", "making the table"}},
      {{"voids", "--json"}, {model, boundary, "computing the topology"}},
      {{"query", "--point", "0,0,0"}, {model}},
      {{"draw", "-o", picture.path()}, {model, "shading", "cutting and sorting", "writing"}},
      {{"draw", "--occlusion", "0.5", "--pieces", "h", "-o", picture.path()},
       {model, "shading", boundary, "cutting and sorting", "writing"}},
  };
  for (Long run : runs) {
    SCOPED_TRACE(testing::PrintToString(run.arguments));
    Words few = run.arguments;
    run.arguments.push_back(large.path());
    few.push_back(small.path());
    const Outcome quiet = run_program(run.arguments);
    EXPECT_EQ(quiet.status, 0);
    EXPECT_EQ(quiet.err, "");
    const auto watched = run_program_watched(run.arguments), short_one = run_program_watched(few);
    if (!watched || !short_one) GTEST_SKIP() << "the system has no terminal to give";
    EXPECT_EQ(short_one->status, 0);
    EXPECT_EQ(short_one->err, "");
    EXPECT_EQ(watched->status, 0);
    EXPECT_EQ(watched->out, quiet.out);
    Words texts = shown(watched->err);
    // Output is counted as it grows.
    std::erase_if(texts, [](const std::string &text) { return text.rfind("writing: ", 0) == 0; });
    run.texts.insert(run.texts.end(), {"", ""});  // covered, and back at the beginning of the line
    EXPECT_EQ(texts, run.texts);
  }
}

// A file of that many bytes shows how far it is read, however few balls are in it.
TEST(Progress, OfReading) {
  const std::string tail(2000, ' ');
  const TemporaryFile large("large.xyzr", balls(2100, tail)), small("small.xyzr", balls(900, tail));
  EXPECT_EQ(run_program({"model", large.path()}).err, "");
  const auto watched = run_program_watched({"model", large.path()});
  const auto short_one = run_program_watched({"model", small.path()});
  if (!watched || !short_one) GTEST_SKIP() << "the system has no terminal to give";
  EXPECT_EQ(short_one->err, "");
  const Words texts = shown(watched->err);
  ASSERT_EQ(texts.size(), 4u) << watched->err;
  EXPECT_EQ(texts[0].rfind("reading: 2.", 0), 0u) << texts[0];
  EXPECT_EQ(texts[1].rfind("reading: 4.", 0), 0u) << texts[1];
  EXPECT_EQ(texts[2] + texts[3], "");
}

// An error has a line to itself.
TEST(Progress, IsGoneBeforeAFailureIsReported) {
  const TemporaryFile large("large.xyzr", balls(20001)), weights("few.txt", "1\n");
  const TemporaryFile long_one("long.xyzr", balls(1100, std::string(2000, ' ')) + "x\n");
  for (const Words &arguments :
       {Words{"measure", large.path(), "--weights", weights.path()},
        Words{"draw", large.path(), "-o", "/no/such/folder/out.svg"}, Words{"measure", long_one.path()}}) {
    const Outcome quiet = run_program(arguments);
    EXPECT_NE(quiet.status, 0);
    const auto watched = run_program_watched(arguments);
    if (!watched) GTEST_SKIP() << "the system has no terminal to give";
    EXPECT_EQ(watched->status, quiet.status);
    const size_t line = watched->err.find("hardsphere: ");
    ASSERT_NE(line, std::string::npos);
    // A terminal begins a new line by two characters.
    EXPECT_EQ(watched->err.substr(line), quiet.err.substr(0, quiet.err.size() - 1) + "\r\n");
    ASSERT_GT(line, 0u);
    EXPECT_EQ(shown(watched->err.substr(0, line)).back(), "") << watched->err;
  }
}

}  // namespace
