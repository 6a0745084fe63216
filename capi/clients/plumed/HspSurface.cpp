// PLUMED: area and volume of a union of balls as collective variables, exact, with exact derivatives by atoms and box.
// The page capi/guide/plumed.md has all keywords and inputs. PLUMED 2.10 or later, its sources or what it installs:
//   g++ -std=c++20 -O2 -fPIC -shared -I PLUMED/src -I PLUMED/src/include HspSurface.cpp -o HspSurface.so
//     $(pkg-config --cflags --libs hardsphere) -Wl,--exclude-libs,ALL                                 in one line
// and the first line of plumed.dat is  LOAD FILE=HspSurface.so
// Lengths are those of PLUMED's input: nm unless UNITS says else.
#include "colvar/Colvar.h"
#include "core/ActionRegister.h"

#include <hardsphere.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace PLMD::colvar {

class HspSurface : public Colvar {
 public:
  static void registerKeywords(Keywords &keys) {
    Colvar::registerKeywords(keys);
    keys.add("atoms", "ATOMS", "the atoms whose area is measured");
    keys.add("atoms", "BLOCKING", "atoms that only block");
    keys.add("numbered", "GROUP", "some of the atoms, whose area is a component of its own");
    keys.add("optional", "RADII", "the radius of all atoms, or of each of ATOMS and then of BLOCKING");
    keys.add("optional", "PDB", "a file that says which atom has which radius, by their serial numbers");
    keys.add("compulsory", "SET", "BONDI",
             "radii for PDB: BONDI by element; PROTOR, NACCESS by residue, without hydrogens");
    keys.add("compulsory", "PROBE", "0.14", "the radius of the probe");
    keys.add("compulsory", "THREADS", "1", "threads that share the work");
    keys.addFlag("SMOOTH", false, "of the solvent-excluded surface");
    keys.addFlag("PERIODIC", false, "with all images in the periodic box");
    keys.addFlag("NOVOLUME", false, "no volume; with PERIODIC in a third of the time");
    keys.addOutputComponent("area", "default", "scalar",
                            "the area of ATOMS; area-1, area-2, .. those of GROUP1, GROUP2, ..");
    keys.addOutputComponent("volume", "default", "scalar", "the volume of the union, without BLOCKING");
  }

  explicit HspSurface(const ActionOptions &ao) : PLUMED_COLVAR_INIT(ao) {
    std::vector<AtomNumber> atoms, blocking;
    std::string pdb, set;
    unsigned threads = 1;
    bool no_volume = false;
    parseAtomList("ATOMS", atoms);
    parseAtomList("BLOCKING", blocking);
    std::vector<std::vector<AtomNumber>> groups;
    for (std::vector<AtomNumber> group;; groups.push_back(group)) {
      parseAtomList("GROUP", static_cast<int>(groups.size() + 1), group);
      if (group.empty()) break;
    }
    parseVector("RADII", radius_);
    parse("PDB", pdb);
    parse("SET", set);
    parse("PROBE", how_.probe);
    parse("THREADS", threads);
    parseFlag("SMOOTH", smooth_);
    parseFlag("PERIODIC", periodic_);
    parseFlag("NOPBC", no_pbc_);
    parseFlag("NOVOLUME", no_volume);
    checkRead();
    const size_t measured = atoms.size();
    if (measured == 0) error("ATOMS has to name some");
    atoms.insert(atoms.end(), blocking.begin(), blocking.end());
    for (size_t i = 0; i < atoms.size(); ++i) {
      if (!place_.emplace(atoms[i].serial(), i).second)
        error("atom " + std::to_string(atoms[i].serial()) + " is named twice");
    }
    if (pdb.empty() == radius_.empty()) error("give RADII, or give PDB");
    if (!pdb.empty()) radius_ = radii_of(pdb, set, atoms);
    if (radius_.size() == 1) radius_.resize(atoms.size(), radius_[0]);
    if (radius_.size() != atoms.size()) error("RADII has to be one number, or one for each of ATOMS and BLOCKING");
    if (periodic_ && smooth_) error("SMOOTH is not there with PERIODIC");
    how_.largest_radius = *std::max_element(radius_.begin(), radius_.end());  // one lattice for the whole run

    add("area", {1, 0, {}}, measured, atoms.size());
    if (blocking.empty() && !no_volume) add("volume", {0, 1, {}}, atoms.size(), atoms.size());
    for (size_t k = 0; k < groups.size(); ++k) {
      Component &area = add("area-" + std::to_string(k + 1), {1, 0, {}}, 0, atoms.size());
      for (const AtomNumber atom : groups[k]) {
        const auto at = place_.find(atom.serial());
        if (at == place_.end())
          error("atom " + std::to_string(atom.serial()) + " of a group is not among ATOMS and BLOCKING");
        area.sigma[at->second] = 1;
      }
    }
    for (size_t i = 0; i < atoms.size(); ++i) {
      weighed_.push_back(std::any_of(components_.begin(), components_.end(), [i](const Component &component) {
        return component.sigma.empty() || component.sigma[i] != 0;
      }));
    }
    box_.areas_alone(!blocking.empty() || no_volume);
    box_.use(hardsphere::threads(threads));
    work_.use(hardsphere::threads(threads));
    requestAtoms(atoms);
    log.printf("  exact %s of %zu atoms, %zu more block, %zu groups; hardsphere %s\n",
               smooth_ ? "solvent-excluded surface" : "surface", measured, blocking.size(), groups.size(),
               HSP_VERSION_STRING);
  }

  void calculate() override {
    if (!no_pbc_ && !periodic_) makeWhole();
    keep_atoms();
    try {
      if (periodic_) {
        std::vector<double> vectors;
        for (unsigned k = 0; k < 9; ++k) vectors.push_back(getBox()[k / 3][k % 3]);
        box_.set(xyz_, kept_radius_, vectors, how_);
      } else {
        work_.set(xyz_, kept_radius_, how_);
      }
      for (const Component &component : components_) put(component);
    } catch (const hardsphere::error &failure) {
      const uint32_t ball = failure.ball();
      error(std::string("hardsphere: ") + failure.what() +
            (ball < kept_.size() ? ", atom " + std::to_string(getAbsoluteIndex(kept_[ball]).serial()) : ""));
    }
  }

 private:
  struct Component {
    std::string name;
    hardsphere::energy_terms terms;
    std::vector<double> sigma;  // empty: all ones
  };

  // One that weighs the first so many atoms by 1, and the others by 0.
  Component &add(const std::string &name, const hardsphere::energy_terms &terms, size_t weighed, size_t all) {
    addComponentWithDerivatives(name);
    componentIsNotPeriodic(name);
    std::vector<double> sigma(weighed == all ? 0 : all);
    std::fill_n(sigma.begin(), sigma.empty() ? 0 : weighed, 1.0);
    components_.push_back({name, terms, sigma});
    return components_.back();
  }

  // The atoms of this step. An atom's area depends on those alone that it meets, so that in open space others are left
  // out, but not of the solvent-excluded surface: atoms farther away stop its probe, too.
  void keep_atoms() {
    const size_t n = getNumberOfAtoms();
    const double reach = 2.001 * (how_.largest_radius + how_.probe);
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < n; ++i) {
      for (unsigned k = 0; k < 3 && weighed_[i]; ++k) {
        const double at = getPosition(static_cast<int>(i))[k];
        low[k] = std::min(low[k], at - reach), high[k] = std::max(high[k], at + reach);
      }
    }
    kept_.clear(), kept_radius_.clear(), xyz_.clear();
    for (size_t i = 0; i < n; ++i) {
      const Vector at = getPosition(static_cast<int>(i));
      bool out = false;
      for (unsigned k = 0; k < 3; ++k) out = out || at[k] < low[k] || at[k] > high[k];
      if (out && !periodic_ && !smooth_) continue;
      kept_.push_back(static_cast<int>(i));
      kept_radius_.push_back(radius_[i]);
      xyz_.insert(xyz_.end(), {at[0], at[1], at[2]});
    }
  }

  // A value and its derivatives by all atoms and the box.
  void put(const Component &component) {
    Value *const value = getPntrToComponent(component.name);
    hardsphere::energy_terms terms = component.terms;
    std::vector<double> sigma;
    for (size_t k = 0; k < kept_.size() && !component.sigma.empty(); ++k)
      sigma.push_back(component.sigma[static_cast<size_t>(kept_[k])]);
    terms.sigma = sigma;
    hardsphere::box_gradients found;
    if (periodic_) {
      found = box_.gradient(terms);
    } else {
      static_cast<hardsphere::gradients &>(found) = smooth_ ? work_.smooth_gradient(terms) : work_.gradient(terms);
    }
    for (int i = 0; i < static_cast<int>(getNumberOfAtoms()); ++i) setAtomsDerivatives(value, i, Vector(0, 0, 0));
    for (size_t k = 0; k < kept_.size(); ++k) {
      const double *const d = &found.d_centre[3 * k];
      setAtomsDerivatives(value, kept_[k], Vector(d[0], d[1], d[2]));
    }
    value->set(found.energy.value);
    if (!periodic_) return setBoxDerivativesNoPbc(value);
    Tensor virial;  // as setBoxDerivativesNoPbc has it: - sum of x_q dE/dx_p
    for (unsigned k = 0; k < 9; ++k) virial[k % 3][k / 3] = -found.d_strain[k];
    setBoxDerivatives(value, virial);
  }

  // In PLUMED's unit of length, by the rows of a PDB file.
  std::vector<double> radii_of(const std::string &path, const std::string &set, const std::vector<AtomNumber> &atoms) {
    const std::map<std::string, uint32_t> sets = {
        {"BONDI", HSP_RADII_BONDI}, {"PROTOR", HSP_RADII_PROTOR}, {"NACCESS", HSP_RADII_NACCESS}};
    if (sets.count(set) == 0) error("SET is BONDI, PROTOR or NACCESS, and not " + set);
    std::vector<double> found(atoms.size(), -1);
    std::ifstream file(path);
    if (!file) error(path + " cannot be read");
    for (std::string row; std::getline(file, row);) {
      if (row.compare(0, 6, "ATOM  ") != 0 && row.compare(0, 6, "HETATM") != 0) continue;
      row.resize(std::max<size_t>(row.size(), 80), ' ');
      const auto at = place_.find(static_cast<unsigned>(std::strtoul(row.substr(6, 5).c_str(), nullptr, 10)));
      if (at == place_.end()) continue;
      uint32_t number = 0;
      double radius = 0;
      const bool by_residue = set != "BONDI" && hsp_residue_radius(sets.at(set), row.substr(17, 3).c_str(),
                                                                   row.substr(12, 4).c_str(), &radius) == HSP_OK;
      if (!by_residue) {
        if (hsp_element_number(row.substr(76, 2).c_str(), &number) != HSP_OK)
          error("no element in columns 77 and 78: " + row);
        hardsphere::check(hsp_element_radius(HSP_RADII_BONDI, number, &radius, nullptr));
      }
      found[at->second] = 0.1 * radius / getUnits().getLength();
    }
    for (size_t i = 0; i < atoms.size(); ++i) {
      if (found[i] < 0) error(path + " has no atom " + std::to_string(atoms[i].serial()));
    }
    return found;
  }

  hardsphere::workspace work_;
  hardsphere::box box_;
  hardsphere::options how_;
  std::vector<Component> components_;
  std::map<unsigned, size_t> place_;  // of an atom among all, by its serial number
  std::vector<bool> weighed_;         // whether the area of an atom is asked for
  std::vector<double> radius_;
  std::vector<int> kept_;  // atoms of this step, with the next two
  std::vector<double> kept_radius_, xyz_;
  bool smooth_ = false, periodic_ = false, no_pbc_ = false;
};

PLUMED_REGISTER_ACTION(HspSurface, "HSP_SURFACE")

}  // namespace PLMD::colvar
