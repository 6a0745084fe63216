#include "molecule_files.hpp"

#include <stdio.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace {

std::vector<std::string> words_of(const std::string &line) {
  std::istringstream text(line);
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  return words;
}

std::string without_blanks(const std::string &text) {
  const std::vector<std::string> words = words_of(text);
  return words.empty() ? "" : words.front();
}

// Columns 31 to 54 hold the coordinates, 77 and 78 the element.
std::vector<Atom> atoms_of_pdb(const std::vector<std::string> &lines) {
  std::vector<Atom> atoms;
  for (const std::string &line : lines)
    if (line.starts_with("ATOM  ") || line.starts_with("HETATM"))
      atoms.push_back({without_blanks(line.substr(76, 2)),
                       {std::stod(line.substr(30, 8)), std::stod(line.substr(38, 8)), std::stod(line.substr(46, 8))}});
  return atoms;
}

std::vector<Atom> atoms_of_xyz(const std::vector<std::string> &lines) {
  std::vector<Atom> atoms;
  for (size_t k = 2; k < lines.size(); ++k) {
    const std::vector<std::string> words = words_of(lines[k]);
    atoms.push_back({words.at(0), {std::stod(words.at(1)), std::stod(words.at(2)), std::stod(words.at(3))}});
  }
  return atoms;
}

// The columns of the loop over _atom_site are in the order in which its names are listed.
std::vector<Atom> atoms_of_cif(const std::vector<std::string> &lines) {
  std::map<std::string, size_t> columns;
  std::vector<Atom> atoms;
  for (const std::string &line : lines) {
    if (line.starts_with("_atom_site.")) {
      columns.emplace(without_blanks(line.substr(11)), columns.size());
    } else if (line.starts_with("ATOM ")) {
      const std::vector<std::string> words = words_of(line);
      const auto value = [&](const char *column) { return words.at(columns.at(column)); };
      atoms.push_back({value("type_symbol"),
                       {std::stod(value("Cartn_x")), std::stod(value("Cartn_y")), std::stod(value("Cartn_z"))}});
    }
  }
  return atoms;
}

}  // namespace

std::vector<std::string> lines_of(const std::filesystem::path &file) {
  std::stringstream text;
  if (file.extension() == ".gz") {
    // Between single quotes a shell takes everything as it stands but single quotes themselves.
    if (file.string().find('\'') != std::string::npos) throw std::runtime_error(file.string() + ": a quote in a path");
    FILE *pipe = popen(("gzip -dc '" + file.string() + "'").c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error(file.string() + ": gzip cannot be started");
    std::array<char, 65536> block;
    for (size_t n = fread(block.data(), 1, block.size(), pipe); n > 0; n = fread(block.data(), 1, block.size(), pipe))
      text.write(block.data(), static_cast<std::streamsize>(n));
    if (pclose(pipe) != 0) throw std::runtime_error(file.string() + ": gzip fails");
  } else {
    std::ifstream input(file);
    if (!input) throw std::runtime_error(file.string() + ": cannot be read");
    text << input.rdbuf();
  }
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

double radius_of(const std::string &element) {
  static const std::map<std::string, double> radii = {{"C", 1.70}, {"N", 1.55}, {"O", 1.52},
                                                      {"S", 1.80}, {"P", 1.80}, {"H", 1.10}};
  const auto found = radii.find(element);
  return found == radii.end() ? 1.80 : found->second;
}

std::vector<Atom> read_atoms(const std::filesystem::path &file) {
  const std::vector<std::string> lines = lines_of(file);
  const std::filesystem::path unpacked = file.extension() == ".gz" ? file.stem() : file.filename();
  std::vector<Atom> atoms;
  if (unpacked.extension() == ".pdb") atoms = atoms_of_pdb(lines);
  if (unpacked.extension() == ".xyz") atoms = atoms_of_xyz(lines);
  if (unpacked.extension() == ".cif") atoms = atoms_of_cif(lines);
  if (atoms.empty()) throw std::runtime_error(file.string() + ": no atoms");
  return atoms;
}

oracle::Balls balls_of_atoms(const std::vector<Atom> &atoms, double probe, double units_per_angstrom) {
  const auto units = [&](double length) { return static_cast<int64_t>(std::llround(length * units_per_angstrom)); };
  oracle::Balls balls;
  for (const Atom &atom : atoms)
    balls.push_back(
        {units(atom.centre[0]), units(atom.centre[1]), units(atom.centre[2]), units(radius_of(atom.element) + probe)});
  return balls;
}

std::filesystem::path own_molecule(const std::string &name) {
  return std::filesystem::path(HSP_OWN_MOLECULES) / name;
}

std::optional<std::filesystem::path> further_molecule(const std::string &name) {
  const char *chosen = std::getenv("HSP_MOLECULES");
  const std::filesystem::path folder = chosen != nullptr ? chosen : HSP_FURTHER_MOLECULES;
  if (folder.empty() || !std::filesystem::exists(folder / name)) return std::nullopt;
  return folder / name;
}
