#include "program_runner.hpp"

#include <fcntl.h>
#include <sys/resource.h>
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

// A terminal without a person: what is written to one side can be read from the other.
class Terminal {
 public:
  Terminal() : near_(posix_openpt(O_RDWR | O_NOCTTY)) {
    if (near_ >= 0 && grantpt(near_) == 0 && unlockpt(near_) == 0) far_ = open(ptsname(near_), O_RDWR | O_NOCTTY);
  }
  ~Terminal() {
    hang_up();
    if (near_ >= 0) close(near_);
  }
  Terminal(const Terminal &) = delete;
  Terminal &operator=(const Terminal &) = delete;

  bool works() const { return far_ >= 0; }
  int descriptor() const { return far_; }

  // Everything up to the end, which comes when nobody holds the other side.
  std::string text() {
    hang_up();
    std::string all;
    char chunk[256];
    for (ssize_t got = read(near_, chunk, sizeof chunk); got > 0; got = read(near_, chunk, sizeof chunk)) {
      all.append(chunk, static_cast<size_t>(got));
    }
    return all;
  }

 private:
  void hang_up() {
    if (far_ >= 0) close(far_);
    far_ = -1;
  }

  int near_;
  int far_ = -1;
};

[[noreturn]] void become(const std::string &program, const std::vector<std::string> &arguments, int out, int err) {
  std::vector<char *> argv;
  std::string name = program.substr(program.rfind('/') + 1);
  argv.push_back(name.data());
  std::vector<std::string> copies = arguments;
  for (std::string &argument : copies) argv.push_back(argument.data());
  argv.push_back(nullptr);
  if (chdir(HSP_PROGRAM_INPUTS) == 0 && dup2(out, STDOUT_FILENO) >= 0 && dup2(err, STDERR_FILENO) >= 0) {
    execv(program.c_str(), argv.data());
  }
  _exit(127);
}

int status_of(pid_t child) {
  int state = 0;
  if (child <= 0 || waitpid(child, &state, 0) != child) return -1;
  return WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
}

int run_child(const std::string &program, const std::vector<std::string> &arguments, int out, int err) {
  const pid_t child = fork();
  if (child == 0) become(program, arguments, out, err);
  return status_of(child);
}

// In a child: give standard input the bytes of a file through a pipe that another child fills.
bool pipe_in(const std::string &path) {
  int ends[2];
  if (pipe(ends) != 0) return false;
  const pid_t filler = fork();
  if (filler == 0) {
    const std::string text = read_file(path);
    size_t at = 0;
    while (at < text.size()) {
      const ssize_t put = write(ends[1], text.data() + at, text.size() - at);
      if (put <= 0) break;
      at += static_cast<size_t>(put);
    }
    _exit(0);
  }
  return filler > 0 && dup2(ends[0], STDIN_FILENO) >= 0 && close(ends[0]) == 0 && close(ends[1]) == 0;
}

// In a child: make its surroundings what they are to be.
bool settle(const Surroundings &surroundings) {
  if (!surroundings.in_path.empty()) {
    if (surroundings.in_is_pipe) {
      if (!pipe_in(surroundings.in_path)) return false;
    } else {
      const int in = open(surroundings.in_path.c_str(), O_RDONLY);
      if (in < 0 || dup2(in, STDIN_FILENO) < 0) return false;
    }
  }
  if (surroundings.most_file_bytes >= 0) {
    const rlim_t most = static_cast<rlim_t>(surroundings.most_file_bytes);
    const struct rlimit limit = {most, most};
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) return false;
  }
  if (surroundings.before) surroundings.before();
  const uid_t nobody = 65534;
  return !surroundings.as_nobody || geteuid() != 0 || (setgid(nobody) == 0 && setuid(nobody) == 0);
}

std::optional<Outcome> run_watched(const std::string &program, const std::vector<std::string> &arguments) {
  const Capture out;
  Terminal terminal;
  if (!terminal.works()) return std::nullopt;
  Outcome outcome;
  outcome.status = run_child(program, arguments, out.descriptor(), terminal.descriptor());
  outcome.out = out.text();
  outcome.err = terminal.text();
  return outcome;
}

}  // namespace

Outcome run_program_in(const Surroundings &surroundings, const std::vector<std::string> &arguments) {
  const Capture out;
  const Capture err;
  int out_descriptor = out.descriptor();
  if (!surroundings.out_path.empty()) out_descriptor = open(surroundings.out_path.c_str(), O_WRONLY | O_CLOEXEC);
  Outcome outcome;
  const pid_t child = fork();
  if (child == 0) {
    if (!settle(surroundings)) _exit(126);
    become(HSP_PROGRAM, arguments, out_descriptor, surroundings.err_is_out ? out_descriptor : err.descriptor());
  }
  outcome.status = status_of(child);
  if (!surroundings.out_path.empty() && out_descriptor >= 0) close(out_descriptor);
  outcome.out = out.text();
  outcome.err = err.text();
  return outcome;
}

Outcome run_program(const std::vector<std::string> &arguments, const std::string &out_path) {
  Surroundings surroundings;
  surroundings.out_path = out_path;
  return run_program_in(surroundings, arguments);
}

int start_program(const std::vector<std::string> &arguments) {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  const pid_t child = fork();
  if (child == 0) become(HSP_PROGRAM, arguments, nowhere, nowhere);
  close(nowhere);
  return child;
}

Outcome run_example(const std::string &name, const std::vector<std::string> &arguments) {
  const Capture out;
  const Capture err;
  Outcome outcome;
  outcome.status = run_child(HSP_EXAMPLES + name, arguments, out.descriptor(), err.descriptor());
  outcome.out = out.text();
  outcome.err = err.text();
  return outcome;
}

std::optional<Outcome> run_program_watched(const std::vector<std::string> &arguments) {
  return run_watched(HSP_PROGRAM, arguments);
}

std::optional<Outcome> run_example_watched(const std::string &name, const std::vector<std::string> &arguments) {
  return run_watched(HSP_EXAMPLES + name, arguments);
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
std::string pictures_folder() {
  return HSP_PROGRAM_PICTURES;
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

size_t count_of(const std::string &text, const std::string &part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}
