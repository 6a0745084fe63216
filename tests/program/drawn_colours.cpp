#include "drawn_colours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
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

namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple times(const Matrix &matrix, const Triple &vector) {
  Triple product = {0, 0, 0};
  for (size_t row = 0; row < 3; ++row) {
    for (size_t column = 0; column < 3; ++column) product[row] += matrix[row][column] * vector[column];
  }
  return product;
}

Triple lab(const Triple &linear) {
  const Matrix to_xyz = {{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
  const Triple xyz = times(to_xyz, linear), white = {0.9505, 1, 1.089};
  Triple f;
  for (size_t k = 0; k < 3; ++k) {
    const double share = xyz[k] / white[k];
    f[k] = share > 216.0 / 24389 ? std::cbrt(share) : (24389.0 / 27 * share + 16) / 116;
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

Triple linear_of(const std::string &colour) {
  Triple linear;
  for (size_t k = 0; k < 3; ++k) {
    const double value = std::stoi(colour.substr(2 * k, 2), nullptr, 16) / 255.0;
    linear[k] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  }
  return linear;
}

}  // namespace

double least_difference(const std::vector<std::string> &colours) {
  const Matrix without_red = {
      {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
  const Matrix without_green = {
      {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
  double least = 1000;
  for (const Matrix &matrix : {without_red, without_green}) {
    std::vector<Triple> seen;
    for (const std::string &colour : colours) {
      Triple linear = times(matrix, linear_of(colour));
      for (double &channel : linear) channel = std::clamp(channel, 0.0, 1.0);
      const Triple one = lab(linear);
      for (const Triple &other : seen) {
        least = std::min(least, std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]));
      }
      seen.push_back(one);
    }
  }
  return least;
}

double contrast(const std::string &one, const std::string &other) {
  const Triple share = {0.2126, 0.7152, 0.0722};
  double light[2] = {0.05, 0.05};
  for (size_t k = 0; k < 3; ++k) {
    light[0] += share[k] * linear_of(one)[k];
    light[1] += share[k] * linear_of(other)[k];
  }
  return std::max(light[0], light[1]) / std::min(light[0], light[1]);
}
