// Ctrl-C and --timeout: the run ends in time, with a status of its own, and all files are as they were.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

// Whose pores take seconds.
std::string many_balls() {
  std::string text;
  for (int i = 0; i < 8000; ++i) {
    text += std::to_string(3 * (i % 20)) + "." + std::to_string(i * 7 % 10) + " " + std::to_string(3 * (i / 20 % 20)) +
            "." + std::to_string(i * 3 % 10) + " " + std::to_string(3 * (i / 400)) + " 1.6\n";
  }
  return text;
}

TEST(Stopping, CtrlCEndsTheLibrarysWork) {
  const TemporaryFile balls("many.xyzr", many_balls());
  for (const char *const threads : {"1", "2"}) {
    const pid_t child = start_program({"pores", balls.path(), "--threads", threads});
    ASSERT_GT(child, 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    kill(child, SIGINT);
    int state = 0;
    ASSERT_EQ(waitpid(child, &state, 0), child);
    EXPECT_TRUE(WIFEXITED(state));
    EXPECT_EQ(WEXITSTATUS(state), 130);
  }
}

TEST(Stopping, ATimeThatIsOverEndsIt) {
  const TemporaryFile balls("many.xyzr", many_balls());
  const Outcome outcome = run_program({"pores", balls.path(), "--timeout", "0.2"});
  EXPECT_EQ(outcome.status, 124);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "hardsphere: stopped, as --timeout 0.2 is over\n");
}

TEST(Stopping, OfEveryCommand) {
  const TemporaryFile balls("many.xyzr", many_balls());
  const TemporaryFolder folder("stopping");
  const std::string out = folder.write("out.svg", "old"), ply = folder.write("out.ply", "old");
  const std::string path = balls.path();
  const std::vector<std::vector<std::string>> commands = {
      {"model", path},           {"query", path, "0", "0", "0"},
      {"boundary", path},        {"measure", path},
      {"measure", path, path},   {"contacts", path},
      {"voids", path},           {"complex", path},
      {"cells", path},           {"path", path, "80,80,80", "90,90,90"},
      {"pores", path},           {"clash", path, path},
      {"mesh", path, "-o", ply}, {"draw", path, "-o", out},
  };
  for (std::vector<std::string> command : commands) {
    command.insert(command.end(), {"--timeout", "1e-6"});
    const Outcome outcome = run_program(command);
    EXPECT_EQ(outcome.status, 124) << command[0] << outcome.err;
    EXPECT_EQ(outcome.out, "") << command[0];
    EXPECT_EQ(outcome.err, "hardsphere: stopped, as --timeout 1e-06 is over\n") << command[0];
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"out.ply", "out.svg"}));
  EXPECT_EQ(read_file(out), "old");
  EXPECT_EQ(read_file(ply), "old");
}

TEST(Stopping, EnoughTimeChangesNothing) {
  const TemporaryFile balls("few.xyzr", "0 0 0 1\n1 0 0 1\n");
  EXPECT_EQ(run_program({"measure", balls.path(), "--timeout", "1000"}).out,
            run_program({"measure", balls.path()}).out);
}

TEST(Stopping, TimesAreAboveZero) {
  for (const char *const seconds : {"0", "-1", "x"}) {
    EXPECT_EQ(run_program({"measure", "-", "--timeout", seconds}).status, 2) << seconds;
  }
}

}  // namespace
