#include "program_runner.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

namespace {

// A file without a name, for one stream of the child.
class Capture {
 public:
  Capture() : file_(std::tmpfile()) {
    if (file_ == nullptr) {
      std::cerr << "cannot make a temporary file\n";
      std::abort();
    }
  }
  ~Capture() { std::fclose(file_); }
  Capture(const Capture &) = delete;
  Capture &operator=(const Capture &) = delete;

  int descriptor() const { return fileno(file_); }

  std::string text() const {
    std::string all;
    std::rewind(file_);
    for (int c = std::fgetc(file_); c != EOF; c = std::fgetc(file_)) all.push_back(static_cast<char>(c));
    return all;
  }

 private:
  std::FILE *file_;
};

[[noreturn]] void become_program(const std::vector<std::string> &arguments, int out, int err) {
  std::vector<char *> argv;
  std::string name = "hardsphere";
  argv.push_back(name.data());
  std::vector<std::string> copies = arguments;
  for (std::string &argument : copies) argv.push_back(argument.data());
  argv.push_back(nullptr);
  if (chdir(HSP_PROGRAM_INPUTS) == 0 && dup2(out, STDOUT_FILENO) >= 0 && dup2(err, STDERR_FILENO) >= 0) {
    execv(HSP_PROGRAM, argv.data());
  }
  _exit(127);
}

}  // namespace

Outcome run_program(const std::vector<std::string> &arguments, const std::string &out_path) {
  const Capture out;
  const Capture err;
  int out_descriptor = out.descriptor();
  if (!out_path.empty()) out_descriptor = open(out_path.c_str(), O_WRONLY | O_CLOEXEC);
  Outcome outcome;
  const pid_t child = fork();
  if (child == 0) become_program(arguments, out_descriptor, err.descriptor());
  int state = 0;
  if (child > 0 && waitpid(child, &state, 0) == child) {
    outcome.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
  }
  if (!out_path.empty() && out_descriptor >= 0) close(out_descriptor);
  outcome.out = out.text();
  outcome.err = err.text();
  return outcome;
}

std::string inputs_folder() {
  return HSP_PROGRAM_INPUTS;
}
std::string transcripts_folder() {
  return HSP_PROGRAM_TRANSCRIPTS;
}
std::string molecules_folder() {
  return HSP_PROGRAM_MOLECULES;
}

std::string read_file(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) {
    std::cerr << "cannot read " << path << '\n';
    std::abort();
  }
  return text.str();
}
