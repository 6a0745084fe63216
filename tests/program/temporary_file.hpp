// A file for one test, gone when the test is over.
#pragma once

#include <string>

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
