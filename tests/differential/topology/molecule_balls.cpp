#include "molecule_balls.hpp"

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace {

// All bytes that a command writes.
std::string output_of(const std::string &command) {
  std::FILE *pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string text;
  char buffer[65536];
  for (size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) text.append(buffer, n);
  if (pclose(pipe) != 0) throw std::runtime_error("failed: " + command);
  return text;
}

std::string contents_of(const std::filesystem::path &file) {
  if (file.extension() == ".gz") {
    if (file.string().find('\'') != std::string::npos) throw std::runtime_error("a quote in " + file.string());
    return output_of("gzip -dc '" + file.string() + "'");
  }
  std::ifstream input(file);
  if (!input) throw std::runtime_error("cannot open " + file.string());
  std::ostringstream text;
  text << input.rdbuf();
  return text.str();
}

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
  std::istringstream input(contents_of(file));
  oracle::Balls balls;
  for (std::string line; std::getline(input, line);) {
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

std::filesystem::path bench_molecule(const std::string &file) {
  return std::filesystem::path(HSP_MOLECULE_FOLDER) / file;
}

std::optional<std::filesystem::path> further_molecule(const std::string &file) {
  const char *named = std::getenv("HSP_MOLECULES");
  const std::filesystem::path folder = named != nullptr ? named : HSP_FURTHER_MOLECULES;
  if (folder.empty() || !std::filesystem::exists(folder / file)) return std::nullopt;
  return folder / file;
}
