#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "degenerate_set.hpp"

namespace degenerate {
namespace {

// The rest of a line without the blank in front.
std::string rest_of(std::istringstream &line) {
  std::string text;
  std::getline(line >> std::ws, text);
  return text;
}

Topology read_topology(std::istringstream &line) {
  Topology topology;
  line >> topology.components >> topology.voids >> topology.shells >> topology.euler;
  return topology;
}

}  // namespace

std::vector<DegenerateSet> read_sets(const std::filesystem::path &file) {
  std::ifstream input(file);
  if (!input) throw std::runtime_error("cannot open " + file.string());
  std::vector<DegenerateSet> sets;
  std::set<std::string> names;
  std::string text;
  std::string last;  // the keyword before
  const auto complete = [&] { return last.empty() || last == "expect" || last == "ball"; };
  for (int number = 1; std::getline(input, text); ++number) {
    const auto require = [&](bool condition, const char *what) {
      if (!condition) throw std::runtime_error(file.string() + ":" + std::to_string(number) + ": " + what);
    };
    if (text.empty() || text.front() == '#') continue;
    std::istringstream line(text);
    std::string keyword;
    line >> keyword;
    if (keyword == "set") {
      require(complete(), "the set before is not complete");
      sets.emplace_back();
      sets.back().name = rest_of(line);
      require(!sets.back().name.empty() && names.insert(sets.back().name).second, "no name, or one seen before");
    } else if (keyword == "step") {
      require(last == "set", "step without set");
      require(static_cast<bool>(line >> sets.back().step) && sets.back().step > 0, "not a step");
      require(rest_of(line).empty(), "more than a step");
    } else if (keyword == "expect") {
      require(last == "step", "expect without step");
      const Topology topology = read_topology(line);
      require(static_cast<bool>(line), "not four numbers");
      require(topology.shells == topology.components + topology.voids, "shells are components and voids");
      std::string from;
      line >> from;
      sets.back().expected = topology;
      sets.back().source = rest_of(line);
      const std::string &source = sets.back().source;
      require(from == "from" && (source == "construction" || source == "nerve" || source == "brute force"),
              "no source of the numbers");
    } else if (keyword == "ball") {
      require(last == "expect" || last == "ball", "ball without expect");
      oracle::LatticeBall ball;
      require(static_cast<bool>(line >> ball.x >> ball.y >> ball.z >> ball.radius), "not four numbers");
      require(ball.radius >= 0 && rest_of(line).empty(), "a negative radius, or more than a ball");
      sets.back().balls.push_back(ball);
    } else {
      require(false, "unknown keyword");
    }
    last = keyword;
  }
  if (!complete()) throw std::runtime_error(file.string() + ": the last set is not complete");
  return sets;
}

}  // namespace degenerate
