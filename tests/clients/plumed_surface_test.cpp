// capi/clients/plumed by our own declarations of PLUMED's names: values by closed forms and of the program, derivatives
// by atoms and box against difference quotients, lines of the guide's page, and lines that have to be refused.
//   plumed_surface_test PAGE CRAMBIN.pdb [EMPTY-FOLDER]
#include "../../capi/clients/plumed/HspSurface.cpp"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

namespace {

using Colvar = PLMD::Colvar;
constexpr double pi = std::numbers::pi;
int failed = 0;

void expect(bool holds, const std::string &said) {
  if (holds) return;
  std::fprintf(stderr, "not so: %s\n", said.c_str());
  failed = 1;
}
#define EXPECT(condition) expect(condition, #condition)

bool near(double a, double b, double most = 1e-9) {
  return std::fabs(a - b) <= most;
}

// The action of a line of plumed.dat, its label before it or not.
std::unique_ptr<Colvar> action(const std::string &line, double length = 1) {
  PLMD::ActionOptions options;
  options.length = length;
  std::istringstream stream(line);
  std::string word, directive;
  while (stream >> word) {
    const size_t equal = word.find('=');
    if (equal != std::string::npos) {
      if (!options.words.emplace(word.substr(0, equal), word.substr(equal + 1)).second) throw std::runtime_error(word);
    } else if (PLMD::registered_actions().actions.count(word) != 0) {
      directive = word;
    } else if (!directive.empty()) {
      options.words.emplace(word, "");
    }
  }
  const auto &registered = PLMD::registered_actions().actions.at(directive);
  registered.register_keywords(options.keys);
  return registered.make(options);
}

void calculate(Colvar &colvar, const std::vector<double> &xyz) {  // of all atoms, [serial - 1][3]
  colvar.position.clear();
  for (const PLMD::AtomNumber atom : colvar.requested) {
    const double *at = &xyz.at(3 * (atom.serial() - 1));
    colvar.position.emplace_back(at[0], at[1], at[2]);
  }
  colvar.calculate();
}

double value(const Colvar &colvar, const std::string &name) {
  EXPECT(colvar.computed.at(name)->not_periodic);
  return colvar.computed.at(name)->get();
}

void refused(const std::string &line, const std::string &why) {
  try {
    action(line);
  } catch (const std::runtime_error &error) {
    return expect(std::string(error.what()).find(why) != std::string::npos, line + ": " + error.what());
  }
  expect(false, line + " is refused");
}

std::string crambin_path;
std::vector<double> crambin() {  // in nm
  std::vector<double> xyz;
  std::ifstream file(crambin_path);
  for (std::string row; std::getline(file, row);) {
    if (row.compare(0, 4, "ATOM") != 0 && row.compare(0, 6, "HETATM") != 0) continue;
    for (const size_t column : {30U, 38U, 46U}) xyz.push_back(0.1 * std::stod(row.substr(column, 8)));
  }
  return xyz;
}

// Two spheres of radius 1 with the probe at distance 1: each loses a cap of height 1/2.
void test_closed_forms() {
  const std::vector<double> lens = {0, 0, 0, 1, 0, 0};
  const auto both = action("HSP_SURFACE ATOMS=1,2 RADII=0.8 PROBE=0.2 NOPBC GROUP1=2 GROUP2=1,2 THREADS=2");
  calculate(*both, lens);
  EXPECT(near(value(*both, "area"), 6 * pi) && near(value(*both, "volume"), 2 * pi * 27 / 24));
  EXPECT(near(value(*both, "area-1"), 3 * pi) && near(value(*both, "area-2"), 6 * pi));
  EXPECT(near(both->computed.at("area")->by_atom[1][0], 2 * pi, 1e-7));
  EXPECT(near(both->computed.at("volume")->by_atom[0][0], -pi * 3 / 4, 1e-7));
  EXPECT(near(both->computed.at("area")->virial[0][0], -2 * pi, 1e-7));
  const auto one = action("HSP_SURFACE ATOMS=2 BLOCKING=1 RADII=1 PROBE=0 NOPBC");
  calculate(*one, lens);
  EXPECT(near(value(*one, "area"), 3 * pi) && one->computed.size() == 1);
  EXPECT(near(one->computed.at("area")->by_atom[1][0], -pi, 1e-7));
  const auto unequal = action("HSP_SURFACE ATOMS=2 BLOCKING=1 RADII=1,0.1 PROBE=0 NOPBC");
  calculate(*unequal, lens);
  EXPECT(near(value(*unequal, "area"), 4 * pi - 2 * pi * (1 - (1 + 1 - 0.01) / 2), 1e-8));
  // A sphere that meets its own images along the first vector, which lies along y.
  const auto alone = action("HSP_SURFACE ATOMS=1 RADII=0.6 PROBE=0 PERIODIC");
  alone->box[0][1] = 1, alone->box[1][2] = 2, alone->box[2][0] = 2;
  calculate(*alone, {7.3, -2, 0.5});
  EXPECT(near(value(*alone, "area"), 4 * pi * 0.36 - 4 * pi * 0.6 * 0.1, 1e-8));
  EXPECT(near(alone->computed.at("area")->virial[1][1], -2 * pi * 0.6, 1e-7));
}

// Areas and volumes of the program.
void test_crambin() {
  const std::vector<double> xyz = crambin();
  const std::string all = "HSP_SURFACE ATOMS=1-327 NOPBC PDB=" + crambin_path;
  const auto plain = action(all + " GROUP1=1-40 GROUP2=41-327"), smooth = action(all + " SMOOTH");
  calculate(*plain, xyz);
  calculate(*smooth, xyz);
  EXPECT(near(value(*plain, "area"), 29.7132301600) && near(value(*plain, "volume"), 8.3573215455));
  EXPECT(near(value(*smooth, "area"), 23.1906488332) && near(value(*smooth, "volume"), 4.6648972708));
  EXPECT(near(value(*plain, "area-1") + value(*plain, "area-2"), value(*plain, "area")));
  const auto part = action("HSP_SURFACE ATOMS=1-40 BLOCKING=41-327 NOPBC PDB=" + crambin_path);
  calculate(*part, xyz);
  EXPECT(value(*part, "area") == value(*plain, "area-1"));
  size_t far = 0;  // those that nothing is asked of
  for (size_t i = 0; i < 327; ++i) {
    const PLMD::Vector &one = part->computed.at("area")->by_atom[i], &other = plain->computed.at("area-1")->by_atom[i];
    far += one[0] == 0 && one[1] == 0 && one[2] == 0;
    for (unsigned k = 0; k < 3; ++k) EXPECT(one[k] == other[k]);
  }
  EXPECT(far > 50);
  // In angstrom, and by residue.
  std::vector<double> larger = xyz;
  for (double &x : larger) x *= 10;
  const auto angstrom = action(all + " PROBE=1.4", 0.1);
  calculate(*angstrom, larger);
  EXPECT(near(value(*angstrom, "area"), 2971.3230159967, 1e-6));
  const auto protor = action(all + " PROBE=1.4 SET=PROTOR", 0.1);
  calculate(*protor, larger);
  EXPECT(near(value(*protor, "area"), 3001.4709900601, 1e-6));
  // Broken by a box, and whole again.
  const auto broken = action("HSP_SURFACE ATOMS=1-327 PDB=" + crambin_path);
  broken->box[0] = {4.1, 0, 0}, broken->box[1] = {0.3, 1.95, 0}, broken->box[2] = {-0.2, 0.15, 2.3};
  std::vector<double> moved = xyz;
  for (size_t i = 100; i < 200; ++i) {
    for (unsigned k = 0; k < 3; ++k) moved[3 * i + k] += broken->box[0][k] - broken->box[2][k];
  }
  calculate(*broken, moved);
  EXPECT(near(value(*broken, "area"), 29.7132301600, 1e-6));
}

// A probe that atoms stop which are farther away than those that an atom meets.
void test_smooth_surface_of_a_part() {
  std::mt19937 random(55);
  std::vector<double> xyz;
  for (int i = 0; i < 36; ++i) xyz.push_back(0.1 * static_cast<double>(random() % 17));
  const auto part = action("HSP_SURFACE ATOMS=1 BLOCKING=2-12 SMOOTH NOPBC RADII=0.1 PROBE=0.4");
  const auto all = action("HSP_SURFACE ATOMS=1-12 GROUP1=1 SMOOTH NOPBC RADII=0.1 PROBE=0.4");
  calculate(*part, xyz);
  calculate(*all, xyz);
  EXPECT(near(value(*part, "area"), value(*all, "area-1"), 1e-12) && near(value(*part, "area"), 0.2, 0.02));
}

// Differences by steps of 1e-4 nm, which the lattice carries, of some coordinates and of nine strains.
void test_derivatives() {
  const std::vector<double> xyz = crambin();
  const std::string pdb = " PDB=" + crambin_path;
  struct Case {
    std::string line;
    double most, most_virial;
  };
  const std::vector<Case> cases = {
      {"HSP_SURFACE ATOMS=1-327 NOPBC GROUP1=1-40,50 GROUP2=200-327" + pdb, 3e-5, 2e-5},
      {"HSP_SURFACE ATOMS=1-327 SMOOTH GROUP1=1-40,50" + pdb, 2e-4, 2e-5},
      {"HSP_SURFACE ATOMS=281-327 BLOCKING=1-280 NOPBC" + pdb, 3e-5, 2e-5},
      {"HSP_SURFACE ATOMS=1-327 PERIODIC GROUP1=1-40,50" + pdb, 3e-5, 5e-4},
      {"HSP_SURFACE ATOMS=281-327 BLOCKING=1-280 PERIODIC NOVOLUME" + pdb, 3e-5, 5e-4},
  };
  // Left-handed, and along no axis; no thinner than two of the largest spheres.
  const double box[9] = {0.3, 2.1, -0.2, 4.2, 0.4, 0.3, 0.5, -0.3, 2.6};
  std::mt19937 random(2);
  for (const Case &tried : cases) {
    const auto colvar = action(tried.line);
    const auto at = [&](const std::vector<double> &where, const double *vectors) {
      for (unsigned k = 0; k < 9; ++k) colvar->box[k / 3][k % 3] = vectors[k];
      calculate(*colvar, where);
      std::map<std::string, double> values;
      for (const auto &[name, component] : colvar->computed) values[name] = component->get();
      return values;
    };
    at(xyz, box);
    std::map<std::string, PLMD::Value> known;
    for (const auto &[name, component] : colvar->computed) known[name] = *component;
    std::map<std::string, double> worst, worst_virial;
    const double h = 1e-4, strain = 2e-5;
    for (int k = 0; k < 24; ++k) {
      const size_t place = random() % colvar->requested.size();
      const auto axis = static_cast<unsigned>(random() % 3);
      std::vector<double> moved = xyz;
      double &x = moved[3 * (colvar->requested[place].serial() - 1) + axis], kept = x;
      x = kept + h;
      auto up = at(moved, box);
      x = kept - h;
      auto down = at(moved, box);
      for (auto &[name, component] : known) {
        const double off = std::fabs((up[name] - down[name]) / (2 * h) - component.by_atom[place][axis]);
        worst[name] = std::max(worst[name], off);
      }
    }
    for (unsigned k = 0; k < 9; ++k) {  // x_p becomes x_p + e x_q
      std::map<std::string, double> found[2];
      for (int side = 0; side < 2; ++side) {
        std::vector<double> strained = xyz, vectors(box, box + 9);
        for (std::vector<double> *all : {&strained, &vectors}) {
          for (size_t i = 0; i < all->size(); i += 3)
            (*all)[i + k / 3] += (side == 0 ? strain : -strain) * (*all)[i + k % 3];
        }
        found[side] = at(strained, vectors.data());
      }
      for (auto &[name, component] : known) {
        const double off = std::fabs((found[0][name] - found[1][name]) / (2 * strain) + component.virial[k % 3][k / 3]);
        worst_virial[name] = std::max(worst_virial[name], off);
      }
    }
    for (const auto &[name, off] : worst) {
      std::printf("%-12.12s %-8s worst of 24 derivatives %.1e, of nine strains %.1e\n", tried.line.c_str() + 12,
                  name.c_str(), off, worst_virial[name]);
      expect(off < tried.most && worst_virial[name] < tried.most_virial, tried.line + ", " + name);
    }
  }
}

void test_page(const char *path) {
  std::ifstream page(path);
  int lines = 0;
  for (std::string line; std::getline(page, line);) {
    if (line.find(": HSP_SURFACE ") == std::string::npos) continue;
    const size_t name = line.find("crambin.pdb");
    if (name != std::string::npos) line.replace(name, 11, crambin_path);
    const auto colvar = action(line);
    colvar->box[0] = {4.1, 0, 0}, colvar->box[1] = {0, 3, 0}, colvar->box[2] = {0, 0, 3.3};
    calculate(*colvar, crambin());
    EXPECT(value(*colvar, "area") > 0);
    ++lines;
  }
  expect(lines >= 4, "lines of the page: " + std::to_string(lines));
}

void test_refusals() {
  const std::string pdb = " PDB=" + crambin_path;
  refused("HSP_SURFACE RADII=1", "ATOMS has to name some");
  refused("HSP_SURFACE ATOMS=1-3", "give RADII, or give PDB");
  refused("HSP_SURFACE ATOMS=1-3 RADII=1" + pdb, "give RADII, or give PDB");
  refused("HSP_SURFACE ATOMS=1-3 RADII=1,2", "one for each");
  refused("HSP_SURFACE ATOMS=1-3,2 RADII=1", "atom 2 is named twice");
  refused("HSP_SURFACE ATOMS=1-3 BLOCKING=3-5 RADII=1", "atom 3 is named twice");
  refused("HSP_SURFACE ATOMS=1-3 RADII=1 GROUP1=4", "atom 4 of a group");
  refused("HSP_SURFACE ATOMS=1-3 RADII=1 GROUP2=1", "GROUP2");  // without GROUP1
  refused("HSP_SURFACE ATOMS=1-3 RADII=1 SMOOTH PERIODIC", "SMOOTH");
  refused("HSP_SURFACE ATOMS=1-3 RADII=1 EDGE=3", "EDGE");
  refused("HSP_SURFACE ATOMS=1-328" + pdb, "has no atom 328");
  refused("HSP_SURFACE ATOMS=1 SET=UFF" + pdb, "SET is BONDI");
  refused("HSP_SURFACE ATOMS=1 PDB=none.pdb", "cannot be read");
  const auto lost = action("HSP_SURFACE ATOMS=1,2 RADII=1 NOPBC"),
             flat = action("HSP_SURFACE ATOMS=1 RADII=1 PERIODIC");
  for (const auto &[colvar, why] : {std::pair{lost.get(), ", atom 2"}, {flat.get(), "hardsphere: "}}) {
    try {
      calculate(*colvar, {0, 0, 0, 1, std::nan(""), 0});
      expect(false, "an action that fails says so");
    } catch (const std::runtime_error &error) {
      expect(std::string(error.what()).find(why) != std::string::npos, error.what());
    }
  }
}

}  // namespace

int main(int count, char **arguments) {
  if (count != 3) return 2;
  crambin_path = arguments[2];
  test_closed_forms();
  test_crambin();
  test_smooth_surface_of_a_part();
  test_derivatives();
  test_page(arguments[1]);
  test_refusals();
  return failed;
}
