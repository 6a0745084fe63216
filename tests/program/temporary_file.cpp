#include "temporary_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace {

// Tests of several programs run at a time and share one folder.
std::string own_path(const std::string &name) {
  return testing::TempDir() + "hardsphere_" + std::to_string(getpid()) + "_" + name;
}

void write_text(const std::string &path, const std::string &text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  EXPECT_TRUE(file.good()) << path;
}

}  // namespace

TemporaryFile::TemporaryFile(const std::string &name) : path_(own_path(name)) {}

TemporaryFile::TemporaryFile(const std::string &name, const std::string &text) : TemporaryFile(name) {
  write_text(path_, text);
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

TemporaryFolder::TemporaryFolder(const std::string &name) : path_(own_path(name)) {
  std::filesystem::remove_all(path_);
  std::filesystem::create_directory(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string &name, const std::string &text) const {
  write_text(path(name), text);
  return path(name);
}

std::vector<std::string> TemporaryFolder::names() const {
  std::vector<std::string> names;
  for (const auto &entry : std::filesystem::directory_iterator(path_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}
