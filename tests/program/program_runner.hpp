// Runs the program as a shell would, and keeps what it prints.
#pragma once

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

// The folders of this project that tests read from.
std::string inputs_folder();
std::string transcripts_folder();
std::string molecules_folder();

std::string read_file(const std::string &path);
