#include "molecule_file.hpp"

#include <stdio.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace support {
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

std::string unpacked_text(const std::filesystem::path &file) {
  // Between single quotes a shell takes everything as it stands but single quotes themselves.
  if (file.string().find('\'') != std::string::npos) throw std::runtime_error(file.string() + ": a quote in a path");
  FILE *pipe = popen(("gzip -dc '" + file.string() + "'").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error(file.string() + ": gzip cannot be started");
  std::string text;
  std::array<char, 65536> block;
  for (size_t n = fread(block.data(), 1, block.size(), pipe); n > 0; n = fread(block.data(), 1, block.size(), pipe))
    text.append(block.data(), n);
  if (pclose(pipe) != 0) throw std::runtime_error(file.string() + ": gzip fails");
  return text;
}

std::vector<std::string> lines_of(const std::filesystem::path &file) {
  std::stringstream text;
  if (file.extension() == ".gz") {
    text << unpacked_text(file);
  } else {
    std::ifstream input(file);
    if (!input) throw std::runtime_error(file.string() + ": cannot be read");
    text << input.rdbuf();
  }
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

// Columns 31 to 54 hold the coordinates, 77 and 78 the element.
std::vector<Atom> atoms_of_pdb(const std::vector<std::string> &lines, Records records) {
  std::vector<Atom> atoms;
  for (const std::string &line : lines)
    if (line.starts_with("ATOM  ") || (records == Records::all && line.starts_with("HETATM")))
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

using RadiusOfElement = std::map<std::string, double>;

const RadiusOfElement &table(Radii radii) {
  static const RadiusOfElement paper = {{"C", 1.52}, {"CA", 3.48}, {"H", 0.70},  {"N", 1.36}, {"O", 1.28},
                                        {"P", 2.18}, {"S", 2.10},  {"CU", 2.50}, {"ZN", 2.50}};
  static const RadiusOfElement van_der_waals = {{"C", 1.70}, {"H", 1.10}, {"N", 1.55},  {"O", 1.52},
                                                {"P", 1.80}, {"S", 1.80}, {"CU", 1.40}, {"ZN", 1.39}};
  static const RadiusOfElement metals_as_sulfur = [] {
    RadiusOfElement changed = van_der_waals;
    changed["CU"] = changed["ZN"] = 1.80;
    return changed;
  }();
  switch (radii) {
    case Radii::paper:
      return paper;
    case Radii::van_der_waals:
      return van_der_waals;
    case Radii::metals_as_sulfur:
      break;
  }
  return metals_as_sulfur;
}

}  // namespace

std::vector<Atom> read_atoms(const std::filesystem::path &file, Records records) {
  const std::vector<std::string> lines = lines_of(file);
  const std::filesystem::path unpacked = file.extension() == ".gz" ? file.stem() : file.filename();
  std::vector<Atom> atoms;
  try {
    if (unpacked.extension() == ".pdb") atoms = atoms_of_pdb(lines, records);
    if (unpacked.extension() == ".xyz") atoms = atoms_of_xyz(lines);
    if (unpacked.extension() == ".cif") atoms = atoms_of_cif(lines);
  } catch (const std::logic_error &error) {  // of what is too short or no number
    throw std::runtime_error(file.string() + ": an atom cannot be read: " + error.what());
  }
  if (atoms.empty()) throw std::runtime_error(file.string() + ": no atoms");
  return atoms;
}

std::string_view describe(Radii radii) {
  switch (radii) {
    case Radii::paper:
      return "Section 2 of the paper: C 1.52, H 0.70, N 1.36, O 1.28, P 2.18, S 2.10; Cu, Zn 2.50";
    case Radii::van_der_waals:
      return "C 1.70, N 1.55, O 1.52, S 1.80, P 1.80, H 1.10, Cu 1.40, Zn 1.39";
    case Radii::metals_as_sulfur:
      break;
  }
  return "C 1.70, N 1.55, O 1.52, S 1.80, P 1.80, H 1.10, Cu 1.80, Zn 1.80";
}

BallList with_radii(const std::vector<Atom> &atoms, Radii radii) {
  BallList balls;
  for (const Atom &atom : atoms) {
    const auto found = table(radii).find(atom.element);
    if (found == table(radii).end()) throw std::runtime_error("no radius for element " + atom.element);
    balls.add(atom.centre[0], atom.centre[1], atom.centre[2], found->second);
  }
  return balls;
}

std::filesystem::path own_molecule(const std::string &name) {
  return std::filesystem::path(HSP_OWN_MOLECULES) / name;
}

std::vector<const char *> bench_molecules() {
  return {"caffeine.pdb", "acetyl_coa.pdb", "crambin.pdb", "felix_model.pdb", "ubiquitin.pdb", "sod_stand_in.pdb"};
}

std::optional<std::filesystem::path> further_molecule(const std::string &name) {
  const char *chosen = std::getenv("HSP_MOLECULES");
  const std::filesystem::path folder = chosen != nullptr ? chosen : HSP_FURTHER_MOLECULES;
  if (folder.empty() || !std::filesystem::exists(folder / name)) return std::nullopt;
  return folder / name;
}

}  // namespace support
