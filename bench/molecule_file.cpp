#include "molecule_file.hpp"

#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>
#include <utility>

namespace bench {
namespace {

// Columns first to last of a line, counted from 1 as in the PDB format, without blanks.
std::string columns(const std::string &line, size_t first, size_t last) {
  std::string text;
  for (size_t i = first - 1; i < last && i < line.size(); ++i) {
    if (std::isspace(static_cast<unsigned char>(line[i])) == 0) text += line[i];
  }
  return text;
}

// Columns 77-78; files without them align one-letter elements to column 14 and two-letter ones to column 13.
std::string element_of(const std::string &line) {
  std::string element = columns(line, 77, 78);
  if (element.empty()) element = columns(line, 13, 14);
  std::string letters;
  for (const char c : element) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      letters += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
  }
  return letters;
}

double coordinate(const std::string &line, size_t first, const std::filesystem::path &file) {
  const std::string text = columns(line, first, first + 7);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw std::runtime_error(file.string() + ": not a coordinate: '" + text + "'");
  }
  return value;
}

const std::map<std::string, double> &table(Radii radii) {
  static const std::map<std::string, double> paper{{"C", 1.52}, {"CA", 3.48}, {"H", 0.70},  {"N", 1.36}, {"O", 1.28},
                                                   {"P", 2.18}, {"S", 2.10},  {"CU", 2.50}, {"ZN", 2.50}};
  static const std::map<std::string, double> van_der_waals{{"C", 1.70}, {"H", 1.10}, {"N", 1.55},  {"O", 1.52},
                                                           {"P", 1.80}, {"S", 1.80}, {"CU", 1.40}, {"ZN", 1.39}};
  return radii == Radii::paper ? paper : van_der_waals;
}

std::filesystem::path further_folder() {
  const char *folder = std::getenv("HSP_MOLECULES");
  return folder != nullptr ? std::filesystem::path(folder) : std::filesystem::path(BENCH_FURTHER_MOLECULES);
}

}  // namespace

std::string_view describe(Radii radii) {
  return radii == Radii::paper ? "Section 2 of the paper: C 1.52, H 0.70, N 1.36, O 1.28, P 2.18, S 2.10; Cu, Zn 2.50"
                               : "C 1.70, N 1.55, O 1.52, S 1.80, P 1.80, H 1.10, Cu 1.40, Zn 1.39";
}

Molecule read_pdb(const std::filesystem::path &file, std::string name) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  Molecule molecule;
  molecule.name = std::move(name);
  std::map<std::string, char> location_of_atom;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("ENDMDL")) break;
    if (!line.starts_with("ATOM  ") && !line.starts_with("HETATM")) continue;
    const char location = line.size() > 16 ? line[16] : ' ';
    if (location != ' ') {
      const std::string atom = columns(line, 22, 27) + '/' + columns(line, 13, 16);
      if (location_of_atom.emplace(atom, location).first->second != location) continue;
    }
    for (const size_t first : {31U, 39U, 47U}) molecule.xyz.push_back(coordinate(line, first, file));
    molecule.elements.push_back(element_of(line));
  }
  if (molecule.elements.empty()) throw std::runtime_error(file.string() + ": no atoms");
  return molecule;
}

Balls with_radii(const Molecule &molecule, Radii radii) {
  Balls balls;
  balls.name = molecule.name;
  balls.xyz = molecule.xyz;
  for (const std::string &element : molecule.elements) {
    const auto found = table(radii).find(element);
    if (found == table(radii).end()) throw std::runtime_error(molecule.name + ": no radius for element " + element);
    balls.radius.push_back(found->second);
  }
  return balls;
}

std::vector<Molecule> paper_molecules() {
  const std::filesystem::path folder(BENCH_MOLECULES);
  return {read_pdb(folder / "caffeine.pdb", "caffeine"), read_pdb(folder / "acetyl_coa.pdb", "acetyl"),
          read_pdb(folder / "crambin.pdb", "crambin"), read_pdb(folder / "felix_model.pdb", "felix_model"),
          read_pdb(folder / "sod_stand_in.pdb", "sod_stand_in")};
}

std::optional<Molecule> further_molecule(const std::string &file, std::string name) {
  const std::filesystem::path folder = further_folder();
  if (folder.empty() || !std::filesystem::exists(folder / file)) return std::nullopt;
  return read_pdb(folder / file, std::move(name));
}

}  // namespace bench
