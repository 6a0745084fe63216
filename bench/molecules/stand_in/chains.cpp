#include "chains.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace stand_in {
namespace {

// A pleated sheet: rise per residue, distance of strands, distance of sheets that leaves room for side chains.
constexpr Length rise = milliangstrom(3300);
constexpr Length strand_spacing = milliangstrom(4800);
constexpr Length sheet_spacing = milliangstrom(9000);

constexpr size_t residues_per_chain = 141;  // times 7.7 atoms of a mean residue: what 1098 atoms have room for
constexpr size_t metals_per_chain = 2;
constexpr size_t ligands_per_metal = 4;
constexpr size_t most_waters = 6;

// Each residue has its own bound about the lobe, this much further out or in at most: surfaces of proteins are rough.
constexpr Length roughness = milliangstrom(5000);
constexpr Length metal_to_ring_carbon = milliangstrom(3060);

struct Place {
  Point at;                         // of the alpha carbon
  Point outwards;                   // where the side chain goes, about 1.5 Angstrom long
  size_t metal = metals_per_chain;  // the metal that it binds, if less than metals_per_chain
};

Point turned(Point p, int axis) {
  if (axis == 1) return {p.z, p.x, p.y};
  if (axis == 2) return {p.y, p.z, p.x};
  return p;
}

Point shaken(Point p, Length by, support::Random &random) {
  // One statement each: the order in which arguments are evaluated is the compiler's choice.
  p.x += random.in(-by, by);
  p.y += random.in(-by, by);
  p.z += random.in(-by, by);
  return p;
}

// A winding path through a sphere about the origin: strand after strand, sheet after sheet, each against the last.
std::vector<Place> winding_path(Length radius) {
  std::vector<Place> path;
  const int64_t reach = radius / rise + 1;
  int64_t strand_direction = 1;
  int64_t sheet_direction = 1;
  for (int64_t sheet = -reach; sheet <= reach; ++sheet) {
    const size_t before_sheet = path.size();
    for (int64_t y = -reach; y <= reach; ++y) {
      const size_t before_strand = path.size();
      for (int64_t x = -reach; x <= reach; ++x) {
        const int64_t along = strand_direction * x;
        const Point at{along * rise, sheet_direction * y * strand_spacing, sheet * sheet_spacing + sheet_spacing / 2};
        if (dot(at, at) > radius * radius) continue;
        path.push_back({at, {0, 0, milliangstrom(along % 2 == 0 ? 1500 : -1500)}});
      }
      if (path.size() > before_strand) strand_direction = -strand_direction;
    }
    if (path.size() > before_sheet) sheet_direction = -sheet_direction;
  }
  return path;
}

std::vector<Place> shortest_sufficient_path() {
  Length radius = milliangstrom(10000);
  std::vector<Place> path;
  while (path.size() < residues_per_chain) {
    path = winding_path(radius);
    radius += milliangstrom(50);
  }
  path.resize(residues_per_chain);
  return path;
}

std::array<Point, metals_per_chain> metal_places() {
  return {Point{milliangstrom(-3300), 0, 0}, Point{milliangstrom(3300), 0, 0}};
}

// The places nearest to each metal are to bind it: their side chains point at it.
void choose_ligands(std::vector<Place> &path) {
  const auto metals = metal_places();
  for (size_t metal = 0; metal < metals_per_chain; ++metal) {
    for (size_t ligand = 0; ligand < ligands_per_metal; ++ligand) {
      Place *nearest = nullptr;
      int64_t least = 0;
      for (Place &place : path) {
        const Point apart = place.at - metals[metal];
        if (place.metal < metals_per_chain || (nearest != nullptr && dot(apart, apart) >= least)) continue;
        nearest = &place;
        least = dot(apart, apart);
      }
      nearest->metal = metal;
      nearest->outwards = scaled(metals[metal] - nearest->at, milliangstrom(1500), integer_square_root(least));
    }
  }
}

const Residue *histidine() {
  for (const Residue &residue : residues()) {
    if (residue.name == "HIS") return &residue;
  }
  return nullptr;
}

const Residue *random_residue(support::Random &random) {
  int64_t whole = 0;
  for (const Residue &residue : residues()) whole += residue.per_mille;
  auto draw = static_cast<int64_t>(random.next() % static_cast<uint64_t>(whole));
  for (const Residue &residue : residues()) {
    draw -= residue.per_mille;
    if (draw < 0) return &residue;
  }
  return nullptr;
}

// Draw sequences until one leaves no more atoms over than a few waters.
std::vector<const Residue *> random_sequence(const std::vector<Place> &path, size_t atoms, support::Random &random) {
  for (;;) {
    std::vector<const Residue *> sequence;
    size_t total = 1 + metals_per_chain;  // the oxygen that ends the chain, and the metals
    for (const Place &place : path) {
      sequence.push_back(place.metal < metals_per_chain ? histidine() : random_residue(random));
      total += backbone().size() + sequence.back()->side_chain.size();
    }
    if (total <= atoms && atoms - total <= most_waters) return sequence;
  }
}

// The ring nitrogen that binds a metal, and the carbons beside it.
struct Ligand {
  uint32_t nitrogen;
  std::array<uint32_t, 2> carbons;
};

// One chain while it grows.
class Builder {
 public:
  Builder(Assembly &assembly, char chain, int axis, support::Random &random)
      : assembly_(assembly), chain_(chain), axis_(axis), random_(random), path_(shortest_sufficient_path()) {
    choose_ligands(path_);
  }

  void build(size_t atoms) {
    const size_t end = assembly_.atoms.size() + atoms;
    const std::vector<const Residue *> sequence = random_sequence(path_, atoms, random_);
    for (size_t i = 0; i < sequence.size(); ++i) append_residue(*sequence[i], i);
    append({"OXT", Element::oxygen, Shape::trigonal, "C"}, sequence.back()->name, path_.back().at);
    bond(last(), find("C"));
    append_metals();
    while (assembly_.atoms.size() < end) {
      ++number_;
      append({"O", Element::oxygen, Shape::tetrahedral, ""}, "HOH", shaken({}, lobe().radius / 2, random_), true);
    }
  }

 private:
  const Lobe &lobe() const { return assembly_.lobes.back(); }
  uint32_t last() const { return static_cast<uint32_t>(assembly_.atoms.size() - 1); }

  // The atom of this name in the residue that is being built, or in the one that many residues before it.
  uint32_t find(std::string_view name, int residues_back = 0) const {
    for (size_t i = assembly_.atoms.size(); i-- > 0;) {
      const Atom &atom = assembly_.atoms[i];
      if (atom.name == name && atom.residue_number == number_ - residues_back) return static_cast<uint32_t>(i);
    }
    return last();
  }

  void append(const ResidueAtom &what, std::string_view residue, Point at, bool hetero = false) {
    Atom atom;
    atom.name = what.name;
    atom.residue = residue;
    atom.element = what.element;
    atom.shape = what.shape;
    atom.chain = chain_;
    atom.lobe = static_cast<uint8_t>(assembly_.lobes.size() - 1);
    atom.hetero = hetero;
    atom.residue_number = number_;
    atom.out = out_;
    atom.at = lobe().centre + turned(at, axis_);
    assembly_.atoms.push_back(atom);
  }

  void bond(uint32_t a, uint32_t b) {
    const Atom &first = assembly_.atoms[a];
    const Atom &second = assembly_.atoms[b];
    assembly_.bonds.push_back({a, b, bond_length(first.element, first.shape, second.element, second.shape)});
  }

  void apart(uint32_t a, uint32_t b, Length length) { assembly_.distances.push_back({a, b, length}); }

  void append_residue(const Residue &residue, size_t i) {
    ++number_;
    out_ = random_.in(-roughness, roughness);
    const Place &place = path_[i];
    // A third of the way towards the neighbours in the chain stand N and C.
    const Point before = i > 0 ? scaled(path_[i - 1].at - place.at, 1, 3) : Point{milliangstrom(-1300), 0, 0};
    const Point after =
        i + 1 < path_.size() ? scaled(path_[i + 1].at - place.at, 1, 3) : Point{milliangstrom(1300), 0, 0};
    for (const ResidueAtom &atom : backbone()) {
      Point at = place.at;
      if (atom.name == "N") at = at + before;
      if (atom.name == "C") at = at + after;
      if (atom.name == "O") at = at + after - scaled(place.outwards, 3, 4);
      append(atom, residue.name, shaken(at, milliangstrom(200), random_));
      if (!atom.parent.empty()) bond(find(atom.parent), last());
    }
    int64_t count = 0;
    for (const ResidueAtom &atom : residue.side_chain) {
      ++count;
      append(atom, residue.name, shaken(place.at + scaled(place.outwards, 1 + count, 2), milliangstrom(500), random_));
      bond(find(atom.parent), last());
    }
    close_ring(residue);
    if (i > 0) join_to_previous();
    if (place.metal < metals_per_chain) ligands_[place.metal].push_back({find("NE2"), {find("CD2"), find("CE1")}});
  }

  void close_ring(const Residue &residue) {
    const auto ring = residue.ring;
    if (ring.empty()) return;
    if (ring.size() == 5) {
      std::vector<uint32_t> members;
      for (const std::string_view name : ring) members.push_back(find(name));
      assembly_.five_rings.push_back(members);
    } else {
      for (size_t i = 0; i < 3; ++i) apart(find(ring[i]), find(ring[i + 3]), milliangstrom(2780));
    }
    // The parents make a tree: the one bond of the ring that no parent names is the one that closes it.
    for (size_t i = 0; i < ring.size(); ++i) {
      const std::string_view a = ring[i];
      const std::string_view b = ring[(i + 1) % ring.size()];
      if (!is_parent(residue, a, b) && !is_parent(residue, b, a)) bond(find(a), find(b));
    }
  }

  static bool is_parent(const Residue &residue, std::string_view parent, std::string_view child) {
    if (parent == "N" && child == "CA") return true;
    for (const ResidueAtom &atom : residue.side_chain) {
      if (atom.name == child && atom.parent == parent) return true;
    }
    return false;
  }

  // The peptide bond, trans and flat.
  void join_to_previous() {
    bond(find("C", 1), find("N"));
    apart(find("CA", 1), find("CA"), milliangstrom(3800));
    apart(find("O", 1), find("CA"), milliangstrom(2770));
  }

  void append_metals() {
    const auto places = metal_places();
    for (size_t metal = 0; metal < metals_per_chain; ++metal) {
      ++number_;
      const Element element = metal == 0 ? Element::copper : Element::zinc;
      append({symbol(element), element, Shape::tetrahedral, ""}, symbol(element), places[metal], true);
      for (const Ligand &ligand : ligands_[metal]) {
        apart(last(), ligand.nitrogen, bond_length(element, Shape::tetrahedral, Element::nitrogen, Shape::trigonal));
        for (const uint32_t carbon : ligand.carbons) apart(last(), carbon, metal_to_ring_carbon);
      }
    }
  }

  Assembly &assembly_;
  char chain_;
  int axis_;
  support::Random &random_;
  std::vector<Place> path_;
  std::array<std::vector<Ligand>, metals_per_chain> ligands_;
  int number_ = 0;
  Length out_ = 0;
};

}  // namespace

void append_chain(Assembly &assembly, char chain, const Lobe &lobe, int axis, size_t atoms, support::Random &random) {
  assembly.lobes.push_back(lobe);
  Builder(assembly, chain, axis, random).build(atoms);
}

}  // namespace stand_in
