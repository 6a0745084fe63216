// When standard output cannot be written, or the file cannot be read, the program says so and fails.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "program_runner.hpp"

namespace {

void expect_refusal(const Outcome &outcome, const std::string &line) {
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "hardsphere: " + line + "\n");
}

TEST(OutputFailures, FullDevice) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  for (const std::vector<std::string> &arguments :
       {std::vector<std::string>{"model", "good/water.pdb"},
        std::vector<std::string>{"measure", "good/water.pdb", "--json"}, std::vector<std::string>{"--help"},
        std::vector<std::string>{"--version"}, std::vector<std::string>{"query", "--help"}}) {
    expect_refusal(run_program(arguments, "/dev/full"), "standard output: No space left on device");
  }
}

TEST(OutputFailures, Folder) {
  const std::string folder = testing::TempDir() + "hardsphere_folder.pdb";
  std::filesystem::create_directory(folder);
  expect_refusal(run_program({"model", folder}), folder + ": Is a directory");
  std::filesystem::remove(folder);
}

TEST(OutputFailures, UnreadableFile) {
  if (geteuid() == 0) GTEST_SKIP() << "root reads everything";
  const std::string file = testing::TempDir() + "hardsphere_unreadable.pdb";
  std::filesystem::copy_file(inputs_folder() + "/good/water.pdb", file,
                             std::filesystem::copy_options::overwrite_existing);
  chmod(file.c_str(), 0);
  expect_refusal(run_program({"model", file}), file + ": Permission denied");
  std::filesystem::remove(file);
}

// A name may hold anything; the message stays on one line.
TEST(OutputFailures, NameWithALineBreak) {
  expect_refusal(run_program({"model", "no\nsuch\tfile.pdb"}), "no?such?file.pdb: No such file or directory");
}

}  // namespace
