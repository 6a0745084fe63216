#include "molecule_balls.hpp"

#include <cctype>
#include <map>
#include <stdexcept>

namespace {

// A number with three decimals, "%8.3f", in thousandths.
int64_t thousandths(const std::string &columns) {
  int64_t value = 0;
  int decimals = -1;
  bool negative = false;
  for (const char c : columns) {
    if (c == '-') negative = true;
    if (c == '.') decimals = 0;
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) continue;
    value = 10 * value + (c - '0');
    if (decimals >= 0) ++decimals;
  }
  if (decimals != 3) throw std::runtime_error("not a coordinate with three decimals: " + columns);
  return negative ? -value : value;
}

// Columns 77 and 78, or where they are empty the letters of columns 13 and 14.
std::string element_of(const std::string &line) {
  std::string element;
  for (const size_t first : {76U, 12U}) {
    if (!element.empty() || line.size() < first + 2) continue;
    for (const char c : line.substr(first, 2))
      if (std::isalpha(static_cast<unsigned char>(c)) != 0)
        element += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return element;
}

}  // namespace

oracle::Balls read_molecule(const std::filesystem::path &file, Records records) {
  static const std::map<std::string, int64_t> radii = {{"C", 1700}, {"N", 1550}, {"O", 1520},  {"S", 1800},
                                                       {"P", 1800}, {"H", 1100}, {"CU", 1400}, {"ZN", 1390}};
  oracle::Balls balls;
  for (const std::string &line : lines_of(file)) {
    if (line.starts_with("ENDMDL")) break;
    if (!line.starts_with("ATOM  ") && (records == Records::protein || !line.starts_with("HETATM"))) continue;
    if (line.size() < 54) throw std::runtime_error(file.string() + ": a short record");
    if (line[16] != ' ' && line[16] != 'A') continue;
    const auto radius = radii.find(element_of(line));
    if (radius == radii.end()) throw std::runtime_error(file.string() + ": no radius for " + element_of(line));
    balls.push_back({thousandths(line.substr(30, 8)), thousandths(line.substr(38, 8)), thousandths(line.substr(46, 8)),
                     radius->second});
  }
  if (balls.empty()) throw std::runtime_error(file.string() + ": no atoms");
  return balls;
}

oracle::Balls grown(const oracle::Balls &balls, int64_t probe) {
  oracle::Balls result = balls;
  for (oracle::LatticeBall &ball : result) ball.radius += probe;
  return result;
}
