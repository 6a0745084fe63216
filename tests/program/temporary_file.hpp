// A file for one test, gone when the test is over.
#pragma once

#include <string>
#include <vector>

class TemporaryFile {
 public:
  // A name of its own that ends like `name`; with text the file is written, without there is none yet.
  explicit TemporaryFile(const std::string &name);
  TemporaryFile(const std::string &name, const std::string &text);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile &) = delete;
  TemporaryFile &operator=(const TemporaryFile &) = delete;

  const std::string &path() const { return path_; }

 private:
  std::string path_;
};

// The same for a folder and all that is in it.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::string &name);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &operator=(const TemporaryFolder &) = delete;

  // The path of a file in it; with text the file is written.
  std::string path(const std::string &name) const { return path_ + "/" + name; }
  std::string write(const std::string &name, const std::string &text) const;
  const std::string &path() const { return path_; }

  // The names of all that is in it, in alphabetical order.
  std::vector<std::string> names() const;

 private:
  std::string path_;
};
