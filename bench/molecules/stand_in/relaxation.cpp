#include "relaxation.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace stand_in {
namespace {

constexpr int sweeps = 1200;
constexpr int growing_sweeps = 700;  // contacts grow from half their size during these
constexpr int shaking_sweeps = 500;  // and atoms are shaken during these
constexpr int final_sweeps = 100;    // bonds and angles weigh more in these
constexpr int sweeps_per_list = 8;   // between two searches for pairs that may come into contact
constexpr Length list_reach = milliangstrom(4700);
constexpr Length remote_contact = milliangstrom(2920);  // least distance of atoms three bonds apart

struct Pair {
  uint32_t a;
  uint32_t b;
  Length least;
};

// Move a pair `fraction`/8 of the way to the given distance, half of it each.
void project(Point &a, Point &b, Length wanted, int64_t fraction) {
  Point apart = b - a;
  int64_t distance = integer_square_root(dot(apart, apart));
  if (distance == 0) {
    apart = {1, 0, 0};
    distance = 1;
  }
  const Point move = scaled(apart, (wanted - distance) * fraction, 16 * distance);
  a = a - move;
  b = b + move;
}

class Relaxation {
 public:
  Relaxation(Assembly &assembly, support::Random &random) : assembly_(assembly), random_(random) {
    const size_t count = assembly_.atoms.size();
    bonded_.resize(count);
    fixed_.resize(count);
    third_.resize(count);
    for (const Link &bond : assembly_.bonds) {
      bonded_[bond.a].push_back(bond.b);
      bonded_[bond.b].push_back(bond.a);
      fix(bond);
    }
    for (const Link &distance : assembly_.distances) fix(distance);
    for (uint32_t centre = 0; centre < count; ++centre) fix_angles(centre);
    find_third_neighbours();
  }

  void run() {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      if (sweep % sweeps_per_list == 0) list_pairs();
      if (sweep < shaking_sweeps) shake(milliangstrom(120) * (shaking_sweeps - sweep) / shaking_sweeps);
      const int64_t grown = std::min(sweep + growing_sweeps, 2 * growing_sweeps);
      keep_apart(grown);
      keep_in_lobes();
      const int repetitions = sweep < sweeps - final_sweeps ? 2 : 8;
      for (int i = 0; i < repetitions; ++i) keep_links();
    }
  }

 private:
  void fix(const Link &link) {
    links_.push_back(link);
    fixed_[link.a].push_back(link.b);
    fixed_[link.b].push_back(link.a);
  }

  bool is_fixed(uint32_t a, uint32_t b) const {
    return std::find(fixed_[a].begin(), fixed_[a].end(), b) != fixed_[a].end();
  }

  Length length_of(uint32_t a, uint32_t b) const {
    const Atom &first = assembly_.atoms[a];
    const Atom &second = assembly_.atoms[b];
    return bond_length(first.element, first.shape, second.element, second.shape);
  }

  bool share_five_ring(uint32_t a, uint32_t b) const {
    for (const auto &ring : assembly_.five_rings) {
      if (std::find(ring.begin(), ring.end(), a) != ring.end() &&
          std::find(ring.begin(), ring.end(), b) != ring.end()) {
        return true;
      }
    }
    return false;
  }

  // The angle at `centre` fixes the distance of each two atoms bonded to it, by the law of cosines.
  void fix_angles(uint32_t centre) {
    const auto &around = bonded_[centre];
    for (size_t i = 0; i < around.size(); ++i) {
      for (size_t j = i + 1; j < around.size(); ++j) {
        const uint32_t a = around[i];
        const uint32_t b = around[j];
        if (is_fixed(a, b)) continue;
        const Length first = length_of(centre, a);
        const Length second = length_of(centre, b);
        const int64_t square =
            first * first + second * second - 2 * first * second / 1000 * cosine_per_mille(centre, a, b);
        fix({a, b, integer_square_root(square)});
      }
    }
  }

  int64_t cosine_per_mille(uint32_t centre, uint32_t a, uint32_t b) const {
    const bool trigonal = assembly_.atoms[centre].shape == Shape::trigonal;
    if (share_five_ring(centre, a) && share_five_ring(centre, b)) return trigonal ? -309 : -250;  // 108, 104.5 degrees
    if (trigonal && (share_five_ring(centre, a) || share_five_ring(centre, b))) return -588;      // 126 degrees
    if (assembly_.atoms[centre].element == Element::sulphur) return -190;                         // 101 degrees
    return trigonal ? -500 : -355;                                                                // 120, 111 degrees
  }

  void find_third_neighbours() {
    for (const Link &middle : assembly_.bonds) {
      for (const uint32_t a : bonded_[middle.a]) {
        for (const uint32_t b : bonded_[middle.b]) {
          if (a == b || a == middle.b || b == middle.a || is_fixed(a, b)) continue;
          third_[a].push_back(b);
          third_[b].push_back(a);
        }
      }
    }
  }

  // All pairs that are near enough to come into contact before the next list, found by sorting along x.
  void list_pairs() {
    const auto &atoms = assembly_.atoms;
    std::vector<uint32_t> order(atoms.size());
    for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
      return atoms[a].at.x != atoms[b].at.x ? atoms[a].at.x < atoms[b].at.x : a < b;
    });
    pairs_.clear();
    for (size_t i = 0; i < order.size(); ++i) {
      for (size_t j = i + 1; j < order.size(); ++j) {
        const uint32_t a = order[i];
        const uint32_t b = order[j];
        const Point apart = atoms[b].at - atoms[a].at;
        if (apart.x > list_reach) break;
        if (dot(apart, apart) > list_reach * list_reach || is_fixed(a, b)) continue;
        const bool third = std::find(third_[a].begin(), third_[a].end(), b) != third_[a].end();
        const Length contact = contact_distance(atoms[a].element, atoms[b].element);
        pairs_.push_back({a, b, third ? std::min(contact, remote_contact) : contact});
      }
    }
  }

  void shake(Length by) {
    for (Atom &atom : assembly_.atoms) {
      atom.at.x += random_.in(-by, by);
      atom.at.y += random_.in(-by, by);
      atom.at.z += random_.in(-by, by);
    }
  }

  void keep_apart(int64_t grown) {
    for (const Pair &pair : pairs_) {
      Point &a = assembly_.atoms[pair.a].at;
      Point &b = assembly_.atoms[pair.b].at;
      const Length least = pair.least * grown / (2 * growing_sweeps);
      const Point apart = b - a;
      if (dot(apart, apart) < least * least) project(a, b, least, 4);
    }
  }

  void keep_in_lobes() {
    for (Atom &atom : assembly_.atoms) {
      const Lobe &lobe = assembly_.lobes[atom.lobe];
      const Length reach = lobe.radius + atom.out;
      const Point from_centre = atom.at - lobe.centre;
      const int64_t distance = integer_square_root(dot(from_centre, from_centre));
      if (distance <= reach) continue;
      atom.at = atom.at - scaled(from_centre, (distance - reach) / 4, distance);
    }
  }

  void keep_links() {
    for (const Link &link : links_) {
      project(assembly_.atoms[link.a].at, assembly_.atoms[link.b].at, link.length, 8);
    }
  }

  Assembly &assembly_;
  support::Random &random_;
  std::vector<std::vector<uint32_t>> bonded_;
  std::vector<std::vector<uint32_t>> fixed_;  // partners at a fixed distance, at most two bonds away or in a plane
  std::vector<std::vector<uint32_t>> third_;  // partners three bonds away
  std::vector<Link> links_;
  std::vector<Pair> pairs_;
};

}  // namespace

void relax(Assembly &assembly, support::Random &random) {
  Relaxation(assembly, random).run();
}

}  // namespace stand_in
