// Transcripts: sessions with the program as they must go, in transcripts/*.txt. Their lines are
//   # ...                 a remark
//   $ hardsphere ARGS     a call; arguments stand between blanks, quotes "..." hold them together
//   ...                   what it prints on stdout
//   ! ...                 what it prints on stderr
//   ? N                   its exit status; 0 if the line is missing
//   $ hardsphere ARGS  ? N  MESSAGE
//                         a call that is refused, in one line: N is its exit status, it prints nothing on stdout and
//                         "hardsphere: MESSAGE" on stderr
// Blank lines before the next "$" or "#" do not count.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "program_runner.hpp"

namespace {

struct Call {
  std::string where;
  std::string command;
  std::vector<std::string> arguments;
  std::string out;
  std::string err;
  int status = 0;
};

std::vector<std::string> split_arguments(const std::string &command) {
  std::vector<std::string> arguments;
  std::string argument;
  bool quoted = false;
  bool begun = false;
  for (const char c : command + " ") {
    if (c == '"') {
      quoted = !quoted;
      begun = true;
    } else if (c == ' ' && !quoted) {
      if (begun) arguments.push_back(argument);
      argument.clear();
      begun = false;
    } else {
      argument.push_back(c);
      begun = true;
    }
  }
  return arguments;
}

void drop_blank_tail(std::string &text) {
  while (text.size() > 1 && text[text.size() - 1] == '\n' && text[text.size() - 2] == '\n') text.pop_back();
  if (text == "\n") text.clear();
}

std::vector<Call> read_transcript(const std::filesystem::path &path) {
  std::vector<Call> calls;
  std::istringstream lines(read_file(path.string()));
  const std::string prompt = "$ hardsphere";
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("#", 0) == 0) continue;
    if (line.rfind(prompt, 0) == 0) {
      Call call;
      const size_t end = line.find("  ? ");
      call.command = line.substr(2, end == std::string::npos ? end : end - 2);
      call.arguments = split_arguments(call.command.substr(prompt.size() - 2));
      if (end != std::string::npos) {
        call.status = line.at(end + 4) - '0';
        call.err = "hardsphere: " + line.substr(end + 7) + "\n";
      }
      call.where = path.stem().string() + "_" + std::to_string(calls.size() + 1);
      calls.push_back(call);
    } else if (calls.empty()) {
      EXPECT_EQ(line, "") << path << " begins with something else than a call";
    } else if (line.rfind("! ", 0) == 0) {
      calls.back().err += line.substr(2) + "\n";
    } else if (line.rfind("? ", 0) == 0) {
      calls.back().status = std::stoi(line.substr(2));
    } else {
      calls.back().out += line + "\n";
    }
  }
  for (Call &call : calls) drop_blank_tail(call.out);
  return calls;
}

std::vector<Call> all_calls() {
  std::vector<std::filesystem::path> paths;
  for (const auto &entry : std::filesystem::directory_iterator(transcripts_folder())) {
    if (entry.path().extension() == ".txt") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Call> calls;
  for (const auto &path : paths) {
    for (const Call &call : read_transcript(path)) calls.push_back(call);
  }
  return calls;
}

class Transcript : public testing::TestWithParam<Call> {};

TEST_P(Transcript, GoesAsWritten) {
  const Call &call = GetParam();
  const Outcome outcome = run_program(call.arguments);
  EXPECT_EQ(outcome.out, call.out) << call.command;
  EXPECT_EQ(outcome.err, call.err) << call.command;
  EXPECT_EQ(outcome.status, call.status) << call.command;
}

std::string test_name(const testing::TestParamInfo<Call> &parameter) {
  return parameter.param.where;
}

INSTANTIATE_TEST_SUITE_P(Program, Transcript, testing::ValuesIn(all_calls()), test_name);

// A refused call must keep to the rules for errors, also where the transcripts expect something else.
TEST(TranscriptRules, ErrorsAreOneLineOnStderrAndNothingOnStdout) {
  int refused = 0;
  for (const Call &call : all_calls()) {
    std::istringstream lines(call.err);
    for (std::string line; std::getline(lines, line);) EXPECT_EQ(line.rfind("hardsphere: ", 0), 0u) << call.command;
    if (call.status == 0) continue;
    ++refused;
    EXPECT_EQ(call.out, "") << call.command;
    EXPECT_EQ(std::count(call.err.begin(), call.err.end(), '\n'), 1) << call.command;
    EXPECT_TRUE(call.status == 1 || call.status == 2) << call.command;
  }
  EXPECT_GT(refused, 50);
}

// Every bad input is called by some transcript, and refused there.
TEST(TranscriptRules, EveryBadInputIsRefusedSomewhere) {
  const std::vector<Call> calls = all_calls();
  for (const auto &entry : std::filesystem::directory_iterator(inputs_folder() + "/bad")) {
    const std::string name = "bad/" + entry.path().filename().string();
    const bool refused = std::any_of(calls.begin(), calls.end(), [&](const Call &call) {
      return call.status == 1 && call.err.find(name + ":") != std::string::npos;
    });
    EXPECT_TRUE(refused) << name;
  }
}

// Help is asked for in five ways. Its keys are held by program_help_keys, its options by packaging_man_page, its
// examples by packaging_readme_commands.
TEST(Help, IsTheSameHoweverItIsAskedFor) {
  const auto printed = [](const std::vector<std::string> &arguments) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.status, 0) << arguments.front();
    EXPECT_EQ(outcome.err, "") << arguments.front();
    return outcome.out;
  };
  const std::string all = printed({"--help"}), begin = "  hardsphere ";
  EXPECT_EQ(printed({"-h"}), all);
  EXPECT_EQ(printed({"help"}), all);
  int commands = 0;
  std::istringstream lines(all);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(begin, 0) != 0 || line.find(" FILE ") == std::string::npos) continue;
    const std::string command = line.substr(begin.size(), line.find(' ', begin.size()) - begin.size());
    ++commands;
    const std::string help = printed({command, "--help"});
    EXPECT_EQ(help.rfind("hardsphere " + command + " FILE ", 0), 0U) << help;
    EXPECT_NE(help.find("\nExample: hardsphere " + command + " "), std::string::npos) << help;
    EXPECT_EQ(printed({command, "-h"}), help);
    EXPECT_EQ(printed({command, "good/nothing.pdb", "--help"}), help);
    EXPECT_EQ(printed({"help", command}), help);
    EXPECT_EQ(printed({"--help", command}), help);
  }
  EXPECT_GE(commands, 15);
}

}  // namespace
