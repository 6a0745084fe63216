// The program's JSON, as every test wants it: a run that succeeds, keeps quiet on stderr and prints one strict object.
#pragma once

#include <string>
#include <vector>

#include "json_reader.hpp"

// Run the program with these arguments and --json. Anything amiss fails the test; then the result is null.
Json run_json(std::vector<std::string> arguments);
