// Runs the program and the examples as a shell would, and keeps what they print.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

struct Outcome {
  int status = -1;  // exit status; 128 + signal if a signal ended it
  std::string out;
  std::string err;
};

// Run the program with these arguments in the folder of the test inputs. If out_path is given, standard output goes
// there instead of into Outcome::out.
Outcome run_program(const std::vector<std::string> &arguments, const std::string &out_path = "");

// The surroundings of a run, beside its arguments.
struct Surroundings {
  std::string in_path;           // standard input; none of its own if empty
  bool in_is_pipe = false;       // whether that is given to it as a pipe
  std::string out_path;          // standard output; Outcome::out if empty
  bool err_is_out = false;       // standard error goes there too
  long most_file_bytes = -1;     // the size that no file may exceed; -1: any
  bool as_nobody = false;        // as a user without any rights, if the test may choose
  std::function<void()> before;  // what else happens in its process before it begins
};

Outcome run_program_in(const Surroundings &surroundings, const std::vector<std::string> &arguments);

// Begin to run the program; its process, whose end is somebody else's to wait for. The program's output is lost.
int start_program(const std::vector<std::string> &arguments);

// The same as run_program with a terminal for its stderr; nothing if the system has none to give.
std::optional<Outcome> run_program_watched(const std::vector<std::string> &arguments);

// Run an example of capi/examples in the same folder. Watched: as above.
Outcome run_example(const std::string &name, const std::vector<std::string> &arguments);
std::optional<Outcome> run_example_watched(const std::string &name, const std::vector<std::string> &arguments);

// The folders of this project that tests read from.
std::string inputs_folder();
std::string transcripts_folder();
std::string molecules_folder();
std::string pictures_folder();

std::string read_file(const std::string &path);

// How often it stands in a text.
size_t count_of(const std::string &text, const std::string &part);
