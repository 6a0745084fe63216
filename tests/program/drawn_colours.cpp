#include "drawn_colours.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <cstdio>
#include <sstream>

#include "program_runner.hpp"
#include "temporary_file.hpp"

std::string crambin() {
  return molecules_folder() + "/crambin.pdb";
}

std::vector<std::string> atoms_of(const std::string &file) {
  std::istringstream lines(read_file(file));
  std::vector<std::string> atoms;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("ATOM", 0) == 0 || line.rfind("HETATM", 0) == 0) atoms.push_back(line);
  }
  return atoms;
}

std::string drawn(const std::string &file, std::vector<std::string> options, const std::string &extension) {
  const TemporaryFile out("colours" + extension);
  options.insert(options.begin(), {"draw", file, "-o", out.path()});
  const Outcome outcome = run_program(options);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return outcome.status == 0 ? read_file(out.path()) : "";
}

std::map<int, std::string> fills(const std::string &file, std::vector<std::string> options) {
  options.insert(options.end(), {"--style", "flat", "--fog", "0", "--all-balls"});
  const std::string svg = drawn(file, options);
  const std::string path = " data-ball=\"";
  std::map<int, std::string> found;
  for (size_t at = svg.find(path); at != std::string::npos; at = svg.find(path, at + 1)) {
    int ball = -1;
    char colour[7] = "";
    EXPECT_EQ(std::sscanf(svg.c_str() + at + path.size(), "%d\" fill=\"#%6[0-9A-Fa-f]\"", &ball, colour), 2);
    for (char &digit : colour) digit = static_cast<char>(std::toupper(static_cast<unsigned char>(digit)));
    found[ball] = colour;
  }
  return found;
}

double brightness(const std::string &colour) {
  double sum = 0;
  for (size_t at = 0; at < 6; at += 2) sum += std::stoi(colour.substr(at, 2), nullptr, 16);
  return sum;
}
