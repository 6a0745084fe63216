#include "pockets/pockets.hpp"

#include "core/sorting.hpp"

namespace hsp {

void PocketFinder::carve(Workspace &workspace, const PoreLimits &limits) {
  const uint64_t maxima = limits.maxima, gates = limits.gates;
  pockets_ = FixedVector<Pocket>(workspace.take<Pocket>(maxima));
  parents_ = workspace.take<uint32_t>(maxima + 1);
  label_ = workspace.take<uint32_t>(maxima);
  region_of_ = workspace.take<uint32_t>(maxima);
  maxima_ = workspace.take<uint32_t>(maxima);
  mouths_ = workspace.take<uint32_t>(gates);
  balls_ = workspace.take<uint32_t>(4 * maxima + 3 * gates + limits.tied);
}

uint32_t PocketFinder::pocket_at(uint32_t end) const {
  return end == pore_outside || end >= known_ ? no_id : label_[end];
}

namespace {
constexpr uint32_t of_no_pocket = no_id - 1;
}

void PocketFinder::begin_leaks(const PoresBuilder &pores) {
  forget();
  for (uint32_t k = 0; k < pores.maxima().size(); ++k) label_[k] = no_id;
}

void PocketFinder::mark(uint32_t maximum, uint32_t pocket) {
  if (maximum == pore_outside || label_[maximum] != no_id) return;
  label_[maximum] = pocket == no_id ? of_no_pocket : pocket;
}

// Gates are taken in descending order, so that each part grows along its widest ways. Two parts with different marks
// are never joined.
void PocketFinder::find_leaks(const PoresBuilder &pores) {
  DisjointSets sets(parents_.part(0, pores.maxima().size() + 1));
  sets.reset();
  const auto mark_of = [&](uint32_t node) { return node == 0 ? of_no_pocket : label_[node - 1]; };
  for (uint32_t k = 0; k < pores.gates().size(); ++k) {
    const PoreGate &gate = pores.gates()[k];
    if (!(gate.point.level > 0.0)) break;
    const uint32_t a = sets.find(node_of(gate.end[0])), b = sets.find(node_of(gate.end[1]));
    const uint32_t one = mark_of(a), other = mark_of(b);
    if (a == b) continue;
    if (one != no_id && other != no_id && one != other) {
      mouths_[mouth_count_++] = k;
      continue;
    }
    sets.join(a, b);
    const uint32_t root = sets.find(a);
    if (root > 0) label_[root - 1] = one != no_id ? one : other;
  }
}

void PocketFinder::find(PoresBuilder &pores, double narrow, double wide) {
  const uint32_t maxima = pores.maxima().size();
  forget();
  pores.join_above(wide);
  const Windings &joined = pores.joined();
  for (uint32_t k = 0; k < maxima; ++k) {
    const uint32_t node = node_of(k);
    const bool fits = node < joined.size();
    const uint32_t part = fits ? joined.component(node) : no_id;
    label_[k] = fits && (part == joined.component(0) || joined.lattice(part).rank > 0) ? 0 : no_id;
  }
  DisjointSets sets(parents_.part(0, maxima + 1));
  sets.reset();
  for (const PoreGate &gate : pores.gates()) {
    if (!(gate.point.level > narrow)) break;
    const auto is_reached = [&](uint32_t end) { return end == pore_outside || label_[end] == 0; };
    if (!is_reached(gate.end[0]) && !is_reached(gate.end[1])) sets.join(node_of(gate.end[0]), node_of(gate.end[1]));
  }
  known_ = maxima;
  narrow_ = narrow;
  number_maxima(pores, narrow);
  gather(pores, narrow);
}

// A set has the number of its highest maximum, so that pockets come in descending order.
void PocketFinder::number_maxima(const PoresBuilder &pores, double narrow) {
  DisjointSets sets(parents_.part(0, known_ + 1));
  for (uint32_t k = 0; k < known_; ++k) {
    const bool there = label_[k] == no_id && pores.maxima()[k].point.level > narrow;
    const uint32_t first = sets.find(k + 1) - 1;
    label_[k] = !there ? no_id : first == k ? pockets_.size() : label_[first];
    if (there && first == k) pockets_.push({k, no_id, 0, 0, 0, 0, 0, 0});
    if (there) ++pockets_[label_[k]].last_maximum;
  }
}

// Lists are counted first, then filled: the counts become the ranges of the pockets.
void PocketFinder::gather(const PoresBuilder &pores, double narrow) {
  const auto for_maxima = [&](auto visit) {
    for (uint32_t k = 0; k < known_; ++k) {
      if (label_[k] != no_id) visit(k, pockets_[label_[k]]);
    }
  };
  const auto for_gates = [&](auto visit) {
    for (uint32_t k = 0; k < pores.gates().size(); ++k) {
      const PoreGate &gate = pores.gates()[k];
      if (!(gate.point.level > narrow)) break;
      const uint32_t a = pocket_at(gate.end[0]), b = pocket_at(gate.end[1]);
      if (a != no_id || b != no_id) visit(k, gate, pockets_[a != no_id ? a : b], a == no_id || b == no_id);
    }
  };
  for_maxima([&](uint32_t k, Pocket &pocket) { pocket.last_ball += pores.maxima()[k].point.tied; });
  for_gates([&](uint32_t, const PoreGate &gate, Pocket &pocket, bool is_mouth) {
    pocket.last_ball += gate.point.tied;
    pocket.last_mouth += is_mouth ? 1 : 0;
  });
  uint32_t maxima = 0, mouths = 0, balls = 0;
  const auto begin = [](uint32_t &total, uint32_t &first, uint32_t &last) {
    first = total;
    total += last;
    last = first;
  };
  for (Pocket &pocket : pockets_.items()) {
    begin(maxima, pocket.first_maximum, pocket.last_maximum);
    begin(mouths, pocket.first_mouth, pocket.last_mouth);
    begin(balls, pocket.first_ball, pocket.last_ball);
  }
  mouth_count_ = mouths;
  const auto add_balls = [&](const CriticalPoint &point, Pocket &pocket) {
    for (const uint32_t ball : pores.tied(point)) balls_[pocket.last_ball++] = ball;
  };
  for_maxima([&](uint32_t k, Pocket &pocket) {
    maxima_[pocket.last_maximum++] = k;
    add_balls(pores.maxima()[k].point, pocket);
  });
  for_gates([&](uint32_t k, const PoreGate &gate, Pocket &pocket, bool is_mouth) {
    if (is_mouth) mouths_[pocket.last_mouth++] = k;
    add_balls(gate.point, pocket);
  });
  for (Pocket &pocket : pockets_.items()) {
    if (pocket.last_mouth > pocket.first_mouth) pocket.mouth = mouths_[pocket.first_mouth];
    const Span<uint32_t> all = balls_.part(pocket.first_ball, pocket.last_ball);
    sort_ascending(all);
    uint32_t kept = 0;
    for (uint32_t k = 0; k < all.size(); ++k) {
      if (k == 0 || all[k] != all[kept - 1]) all[kept++] = all[k];
    }
    pocket.last_ball = pocket.first_ball + kept;
  }
}

}  // namespace hsp
