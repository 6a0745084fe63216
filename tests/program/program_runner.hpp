// Runs the program and the examples as a shell would, and keeps what they print.
#pragma once

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

// The same with a terminal for its stderr; nothing if the system has none to give.
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
