// "-" as a file: standard input, whatever it is, and standard output.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

std::string input(const std::string &name) {
  return inputs_folder() + "/" + name;
}

Outcome run_with_input(const std::string &path, bool pipe, const std::vector<std::string> &arguments) {
  Surroundings surroundings;
  surroundings.in_path = path;
  surroundings.in_is_pipe = pipe;
  return run_program_in(surroundings, arguments);
}

TEST(StandardStreams, InputInEveryFormat) {
  for (const std::string format : {"pdb", "pqr", "xyz"}) {
    const std::string file = "good/water." + format;
    const Outcome expected = run_program({"measure", file, "--per-ball", "--json"});
    for (const bool pipe : {false, true}) {
      const Outcome outcome =
          run_with_input(input(file), pipe, {"measure", "-", "--format", format, "--per-ball", "--json"});
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_EQ(without_input(outcome.out), without_input(expected.out)) << format;
    }
  }
}

// --format counts for files as well, in any case of its letters.
TEST(StandardStreams, FormatBeforeExtension) {
  const TemporaryFile odd("water.txt", read_file(input("good/water.pdb")));
  const Outcome expected = run_program({"measure", "good/water.pdb", "--json"});
  for (const std::string format : {"pdb", "PDB", "Pdb"}) {
    EXPECT_EQ(without_input(run_program({"measure", odd.path(), "--format=" + format, "--json"}).out),
              without_input(expected.out));
  }
  EXPECT_EQ(run_program({"measure", "good/water.pdb", "--format", "xyz"}).status, 1);
}

TEST(StandardStreams, TablesSayWhereTheBallsCameFrom) {
  const std::string table = run_program({"measure", "good/water.pdb"}).out;
  const std::string expected = "standard input" + table.substr(table.find('\n'));
  EXPECT_EQ(run_with_input(input("good/water.pdb"), true, {"measure", "--format", "pdb", "-"}).out, expected);
  const Outcome bad = run_with_input(input("bad/nan.pdb"), true, {"measure", "--format", "pdb", "-"});
  EXPECT_EQ(bad.err, "hardsphere: standard input:2: y (columns 39-46): 'nan' is not finite\n");
  EXPECT_EQ(bad.status, 1);
}

// A file that was read once is needed again, even if it came through a pipe.
TEST(StandardStreams, PdbFromInputToOutput) {
  const TemporaryFile out("areas.pdb");
  for (const std::string &file : {input("good/water_two_models.pdb"), molecules_folder() + "/crambin.pdb"}) {
    EXPECT_EQ(run_program({"measure", file, "--pdb-out", out.path()}).status, 0);
    const std::string expected = read_file(out.path());
    for (const bool pipe : {false, true}) {
      for (const char *to : {"-", "/dev/stdout"}) {
        const Outcome outcome = run_with_input(file, pipe, {"measure", "-", "--format", "pdb", "--pdb-out", to});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.out, expected) << to;
      }
    }
  }
}

TEST(StandardStreams, WeightsFromInput) {
  const Outcome expected = run_program({"measure", "good/water.pdb", "--weights", "good/water.weights", "--json"});
  const Outcome outcome =
      run_with_input(input("good/water.weights"), true, {"measure", "good/water.pdb", "--weights", "-", "--json"});
  EXPECT_EQ(outcome.out, expected.out);
  EXPECT_EQ(outcome.status, 0);
}

// Pictures go to standard output alone: SVG unless --picture says otherwise.
TEST(StandardStreams, Pictures) {
  for (const std::string format : {"svg", "eps", "pdf"}) {
    const TemporaryFile out("picture." + format);
    EXPECT_EQ(run_program({"draw", "good/water.pdb", "-o" + out.path()}).status, 0);
    const Outcome outcome = run_program({"draw", "good/water.pdb", "--picture", format, "--output=-"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, read_file(out.path())) << format;
    if (format == "svg") {
      EXPECT_EQ(run_program({"draw", "good/water.pdb", "-o", "-"}).out, outcome.out);
      EXPECT_EQ(run_program({"draw", "good/water.pdb", "-o-"}).out, outcome.out);
    }
  }
}

TEST(StandardStreams, FullOutput) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  for (const std::vector<std::string> &arguments :
       {std::vector<std::string>{"draw", "good/water.pdb", "-o", "-"},
        std::vector<std::string>{"draw", molecules_folder() + "/crambin.pdb", "-o", "-"},
        std::vector<std::string>{"measure", "good/water.pdb", "--pdb-out", "-"}}) {
    const Outcome outcome = run_program(arguments, "/dev/full");
    EXPECT_EQ(outcome.err, "hardsphere: standard output: No space left on device\n");
    EXPECT_EQ(outcome.status, 1);
  }
}

// "<file >file" and the like.
TEST(StandardStreams, NothingReadIsWrittenOver) {
  const std::string text = read_file(input("good/water.pdb"));
  const TemporaryFile file("water.pdb", text);
  const Outcome outcome =
      run_with_input(file.path(), false, {"measure", "-", "--format", "pdb", "--pdb-out", file.path()});
  EXPECT_EQ(outcome.err, "hardsphere: --pdb-out would write over the file that is read\n");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(read_file(file.path()), text);
}

// Standard input is one thing, and neither it nor a pipe can be read for each of several files.
TEST(StandardStreams, InputsThatAreReadOnce) {
  const TemporaryFile groups("groups.ndx", "[ oxygen ]\n1\n");
  const std::vector<std::string> of_group = {"--format", "pdb", "--only", "group:oxygen", "--index"};
  const auto with = [&](std::vector<std::string> arguments, const std::string &path) {
    arguments.insert(arguments.end(), of_group.begin(), of_group.end());
    arguments.push_back(path);
    return arguments;
  };
  for (const bool pipe : {false, true}) {
    const Outcome outcome = run_with_input(groups.path(), pipe, with({"measure", "good/water.pdb"}, "-"));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, run_program(with({"measure", "good/water.pdb"}, groups.path())).out);
    const Outcome each = run_with_input(groups.path(), pipe, with({"measure", "good/water.pdb", "--models=all"}, "-"));
    EXPECT_EQ(each.status, 0) << each.err;
  }
  const std::string two = "standard input is one file, not two", once = " can be read once, and serves for one file";
  const std::string weights_of_each = "--weights: standard input can be read once, and serves for one molecule";
  struct Case {
    std::vector<std::string> arguments;
    std::string reason;
  };
  std::vector<Case> cases = {
      {with({"measure", "-"}, "-"), two},
      {with({"measure", "good/water.pdb", "--weights", "-"}, "-"), two},
      {{"measure", "-", "--format", "pdb", "--weights", "-"}, two},
      {{"measure", "-", "--format", "pdb", "--trajectory", "-"}, two},
      {with({"measure", "good/water.pdb", "--trajectory", "-"}, "-"), two},
      {{"clash", "-", "good/water.pdb", "--format", "pdb", "--trajectory", "-"}, two},
      {with({"clash", "good/water.pdb", "good/one.pdb"}, "-"), "--index: standard input" + once},
      {with({"measure", "good/water.pdb", "good/one.pdb"}, "-"), "--index: standard input" + once},
      {with({"measure", "good/water.pdb", "--rows"}, "-"), "--index: standard input" + once},
      {{"measure", "good/water.pdb", "--models", "all", "--weights", "-"}, weights_of_each}};
  if (std::filesystem::exists("/dev/fd/0")) {
    cases.push_back({with({"measure", "good/water.pdb", "--rows"}, "/dev/fd/0"), "--index: /dev/fd/0" + once});
    cases.push_back({{"measure", "/dev/fd/0", "--format", "pdb", "--pdb-out", "/dev/null"},
                     "--pdb-out: /dev/fd/0 can be read once, and is needed again; as standard input, -, it is kept"});
    cases.push_back(
        {{"measure", "good/water.pdb", "good/one.cif", "--radii", "/dev/fd/0"}, "--radii: /dev/fd/0" + once});
    cases.push_back(
        {{"measure", "good/water.pdb", "good/one.cif", "--weights", "/dev/fd/0"}, "--weights: /dev/fd/0" + once});
  }
  for (const Case &each : cases) {
    const Outcome outcome = run_with_input(input("good/water.pdb"), true, each.arguments);
    EXPECT_EQ(outcome.status, 2) << each.reason;
    EXPECT_EQ(outcome.out, "") << each.reason;
    EXPECT_EQ(outcome.err, "hardsphere: " + each.reason + "\n");
  }
}

}  // namespace
