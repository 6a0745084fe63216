#include "temporary_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

// Tests of several programs run at a time and share one folder.
TemporaryFile::TemporaryFile(const std::string &name)
    : path_(testing::TempDir() + "hardsphere_" + std::to_string(getpid()) + "_" + name) {}

TemporaryFile::TemporaryFile(const std::string &name, const std::string &text) : TemporaryFile(name) {
  std::ofstream file(path_, std::ios::binary);
  file << text;
  file.close();
  EXPECT_TRUE(file.good()) << path_;
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}
