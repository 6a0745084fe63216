// The program's JSON, as every test wants it: a run that succeeds, keeps quiet on stderr but for a note that is
// expected, and prints one strict object.
#pragma once

#include <string>
#include <vector>

#include "json_reader.hpp"

// Run the program with these arguments and --json. Anything amiss fails the test; then the result is null.
Json run_json(std::vector<std::string> arguments, const std::string &note = "");

// The output of a command about the balls: its JSON up to the last key, which tells what was read.
std::string without_input(const std::string &json);

// The same without the names of atoms and residues: what files of different formats agree on.
std::string geometry_alone(const std::string &json);
