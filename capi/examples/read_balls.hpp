// Balls from a file, for examples: x y z r on each line, # begins a comment.
#ifndef READ_BALLS_HPP
#define READ_BALLS_HPP

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

struct Balls {
  std::vector<double> xyz, radius;
};

inline void add_balls(Balls &balls, const std::string &path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  for (std::string line; std::getline(file, line);) {
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r\n") == std::string::npos) continue;
    std::istringstream words(line);
    double x, y, z, r;
    if (!(words >> x >> y >> z >> r)) throw std::runtime_error(path + ": expected x y z r on each line");
    balls.xyz.insert(balls.xyz.end(), {x, y, z});
    balls.radius.push_back(r);
  }
  if (file.bad()) throw std::runtime_error(path + ": cannot be read");
}

#endif
