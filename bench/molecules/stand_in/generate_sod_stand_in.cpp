// Writes the stand-in for the paper's SOD: 4392 balls of protein density whose Section 2 figures print as SOD's.
//
// Four globular chains, each grown from random amino-acid residues with textbook bonds and angles, settled in integer
// arithmetic: the bytes are the same on every machine, and nothing in them is taken from an experimental structure.
// Usage: generate_sod_stand_in > sod_stand_in.pdb. Exit status 1 if the figures are not the paper's.
#include <cinttypes>
#include <cstdio>
#include <string>
#include <vector>

#include "chains.hpp"
#include "relaxation.hpp"
#include "section_2_figures.hpp"

namespace {

using namespace stand_in;

constexpr size_t atoms_per_chain = 1098;
constexpr Length lobe_radius = milliangstrom(18500);
constexpr Length lobe_offset = milliangstrom(15500);  // from the middle to a lobe along each axis
constexpr int64_t strained_bond = 1161;               // milliangstrom: the C=O of each chain that makes rho 0.763

Assembly assemble(support::Random &random) {
  Assembly assembly;
  const Point corners[] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  int axis = 0;
  for (const Point &corner : corners) {
    const Lobe lobe{scaled(corner, lobe_offset, 1), lobe_radius};
    append_chain(assembly, static_cast<char>('A' + axis), lobe, axis % 3, atoms_per_chain, random);
    ++axis;
  }
  return assembly;
}

int64_t nearest_milliangstrom(Length length) {
  const Length half = steps_per_milliangstrom / 2;
  return (length >= 0 ? length + half : length - half) / steps_per_milliangstrom;
}

std::vector<LatticeBall> lattice_balls(const Assembly &assembly) {
  std::vector<LatticeBall> balls;
  for (const Atom &atom : assembly.atoms) {
    balls.push_back(
        {{nearest_milliangstrom(atom.at.x), nearest_milliangstrom(atom.at.y), nearest_milliangstrom(atom.at.z)},
         paper_radius_milliangstrom(atom.element)});
  }
  return balls;
}

// Every refined structure has bonds that are too short; here it is the first carbonyl of each chain.
void strain_first_carbonyls(const Assembly &assembly, std::vector<LatticeBall> &balls) {
  for (size_t i = 1; i < balls.size(); ++i) {
    const Atom &oxygen = assembly.atoms[i];
    if (oxygen.residue_number != 1 || oxygen.name != "O" || assembly.atoms[i - 1].name != "C") continue;
    const Point bond = balls[i].centre - balls[i - 1].centre;
    const int64_t length = integer_square_root(dot(bond, bond));
    balls[i].centre = balls[i - 1].centre + scaled(bond, strained_bond, length);
  }
}

// "  -1.234" in columns 31-54 of the PDB format.
std::string coordinate(int64_t milliangstroms) {
  const int64_t size = milliangstroms < 0 ? -milliangstroms : milliangstroms;
  std::string decimals = std::to_string(size % 1000);
  decimals.insert(0, 3 - decimals.size(), '0');
  std::string text = std::to_string(size / 1000);
  text += '.';
  text += decimals;
  if (milliangstroms < 0) text.insert(0, 1, '-');
  text.insert(0, text.size() < 8 ? 8 - text.size() : 0, ' ');
  return text;
}

void write_atom(size_t serial, const Atom &atom, const LatticeBall &ball) {
  const std::string element(symbol(atom.element));
  // The atom's name begins in column 14, in column 13 where the element has two letters.
  std::string name(atom.name);
  if (element.size() == 1) name.insert(0, 1, ' ');
  const std::string residue(atom.residue);
  std::printf("%-6s%5zu %-4s %3s %c%4d    %s%s%s  1.00  0.00          %2s\n", atom.hetero ? "HETATM" : "ATOM", serial,
              name.c_str(), residue.c_str(), atom.chain, atom.residue_number, coordinate(ball.centre.x).c_str(),
              coordinate(ball.centre.y).c_str(), coordinate(ball.centre.z).c_str(), element.c_str());
}

void write_file(const Assembly &assembly, const std::vector<LatticeBall> &balls) {
  std::printf(
      "REMARK  SYNTHETIC STAND-IN FOR THE PAPER'S SOD (4392 ATOMS), NOT A MOLECULE.\n"
      "REMARK  MADE BY bench/molecules/stand_in/generate_sod_stand_in.cpp.\n"
      "REMARK  FOUR RANDOM CHAINS OF PROTEIN-LIKE COMPOSITION, GEOMETRY AND DENSITY,\n"
      "REMARK  WITH THE SECTION 2 FIGURES OF THE PAPER'S SOD (CU AND ZN: RADIUS 2.50).\n");
  for (size_t i = 0; i < balls.size(); ++i) write_atom(i + 1, assembly.atoms[i], balls[i]);
  std::printf("END\n");
}

// Whether the figures print as the paper's row: SOD, k 1.95, rho 0.76, max 16, aver. 5.5.
bool prints_as_sod(const SectionTwoFigures &figures) {
  const int64_t k = thousandths(figures.largest_radius, figures.smallest_radius);
  // 0.755 <= rho < 0.765, squared.
  const bool rho = figures.rho_numerator * 1000000 >= 755 * 755 * figures.rho_denominator &&
                   figures.rho_numerator * 1000000 < 765 * 765 * figures.rho_denominator;
  const int64_t mean = thousandths(figures.overlaps, figures.balls);
  std::fprintf(
      stderr,
      "balls %" PRId64 ", k %" PRId64 "/1000, rho^2 %" PRId64 "/1000, max %" PRId64 ", aver. %" PRId64 "/1000\n",
      figures.balls, k, thousandths(figures.rho_numerator, figures.rho_denominator), figures.most_overlaps, mean);
  return k >= 1945 && k < 1955 && rho && figures.most_overlaps == 16 && mean >= 5450 && mean < 5550;
}

}  // namespace

int main() {
  support::Random random(4392);
  Assembly assembly = assemble(random);
  relax(assembly, random);
  std::vector<LatticeBall> balls = lattice_balls(assembly);
  strain_first_carbonyls(assembly, balls);
  write_file(assembly, balls);
  return prints_as_sod(section_2_figures(balls)) ? 0 : 1;
}
