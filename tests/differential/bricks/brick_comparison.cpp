#include "brick_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace {

using support::OwnedBalls;
using support::Random;
using support::Summary;

hsp_boundary_counts counts_of(const hsp_boundary *boundary) {
  hsp_boundary_counts counts;
  support::need(hsp_boundary_get_counts(boundary, &counts), "counts");
  return counts;
}

// Statuses of a block whose bytes are not as they were written.
bool is_refused(const Summary &damaged, const Summary &sound) {
  hsp_brick_totals totals;
  Summary merged;
  return support::get_totals(damaged, totals) == HSP_E_DAMAGED &&
         support::merge(damaged, sound, merged) == HSP_E_DAMAGED &&
         support::merge(sound, damaged, merged) == HSP_E_DAMAGED;
}

}  // namespace

// Ids ascend up to 2^50, and have nothing to do with the order in which balls were made.
void BrickComparison::take(const BrickSet &set, Random &random) {
  oracle::Balls shuffled = set.balls;
  for (size_t k = shuffled.size(); k > 1; --k)
    std::swap(shuffled[k - 1], shuffled[random.below(static_cast<uint32_t>(k))]);
  balls_ = {};
  uint64_t id = random.one_in(2) ? UINT64_C(1) << 49 : 0;
  int64_t largest = 1;
  for (const oracle::LatticeBall &ball : shuffled) {
    const double centre[3] = {static_cast<double>(ball.x), static_cast<double>(ball.y), static_cast<double>(ball.z)};
    balls_.push(centre, static_cast<double>(ball.radius), id += static_cast<uint64_t>(random.in(1, 1000)), 0);
    largest = std::max(largest, ball.radius);
  }
  if (random.one_in(2)) largest = std::min(2 * largest, (INT64_C(1) << 30) - 1);
  largest_radius_ = static_cast<double>(largest);
}

std::string BrickComparison::one_piece() {
  whole_.compute(balls_, largest_radius_);
  const Summary summary = whole_.summarise(balls_, 0, 1, HSP_BRICK_KEEP_SHELLS);
  if (const int32_t status = support::get_totals(summary, totals_); status != HSP_OK) return hsp_status_text(status);
  hsp_brick_totals dropped;
  const Summary without = whole_.summarise(balls_, 0, 1, 0);
  if (support::get_totals(without, dropped) != HSP_OK || !support::same_bits(totals_, dropped)) {
    return "totals without kept shells";
  }
  const hsp_boundary_counts counts = counts_of(whole_.work().boundary);
  if (totals_.balls != counts.balls || totals_.exposed_balls != counts.exposed_balls ||
      totals_.contained_balls != counts.contained_balls || totals_.vertices != counts.vertices ||
      totals_.arcs != counts.arcs || totals_.circles != counts.circles || totals_.faces != counts.faces ||
      totals_.loops != counts.loops || totals_.shells != counts.shells || totals_.components != counts.components ||
      totals_.voids != counts.voids || totals_.tied_vertices != counts.tied_vertices || totals_.euler != counts.euler) {
    return "counts of one piece";
  }
  hsp_totals measured;
  support::need(hsp_boundary_measure(whole_.work().boundary, nullptr, &measured, nullptr, nullptr, 0, nullptr),
                "measure");
  const double size = 13 * largest_radius_ * largest_radius_ * (1.0 + counts.faces);
  if (std::fabs(totals_.area - measured.area) > 1e-13 * size) return "area of one piece";
  shells_ = support::shells_of(summary);
  return shells_differ();
}

// Against the topology. Its shells in the order of records: by the lowest id of their components, then as they are.
std::string BrickComparison::shells_differ() {
  if (hsp_workspace_topology(&whole_.work()) != HSP_OK) return "topology";
  hsp_topology_counts of;
  support::need(hsp_topology_get_counts(whole_.work().topology, &of), "counts");
  std::vector<hsp_shell> shells(of.shells);
  std::vector<hsp_ball> balls(balls_.size());
  uint32_t needed = 0;
  support::need(hsp_topology_get_shells(whole_.work().topology, shells.data(), of.shells, &needed), "shells");
  support::need(hsp_boundary_get_balls(whole_.work().boundary, balls.data(), balls_.size(), &needed), "balls");
  std::vector<uint64_t> lowest(of.components, UINT64_MAX);
  for (uint32_t i = balls_.size(); i-- > 0;) lowest[balls[i].component] = balls_.id[i];
  std::vector<uint32_t> order(of.shells);
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](uint32_t s) {
    const hsp_shell &shell = shells[s];
    return std::tuple(lowest[shell.component], shell.kind, shell.faces, shell.euler, shell.area);
  };
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
  if (shells_.size() != of.shells) return "number of shells";
  double extent = 0;
  for (uint32_t i = 0; i < balls_.size(); ++i) {
    for (int k = 0; k < 3; ++k)
      extent = std::max(extent, std::fabs(static_cast<double>(balls_.at(i, k) - balls_.at(0, k))));
  }
  double volume = 0, voids = 0;
  for (uint32_t k = 0; k < of.shells; ++k) {
    const hsp_brick_shell &mine = shells_[k];
    const hsp_shell &theirs = shells[order[k]];
    const double area = 13 * largest_radius_ * largest_radius_ * static_cast<double>(mine.faces);
    if (mine.component != lowest[theirs.component] || mine.kind != theirs.kind) return "component or kind of a shell";
    if (mine.faces != theirs.faces || mine.euler != theirs.euler) return "faces or Euler number of a shell";
    (mine.kind == HSP_SHELL_VOID ? voids : volume) += mine.volume;
    // Where shells tie up to rounding, either may come first.
    const bool alone =
        (k == 0 || key(order[k - 1]) < key(order[k])) && (k + 1 == of.shells || key(order[k]) < key(order[k + 1]));
    if (std::fabs(mine.area - theirs.area) > 1e-11 * area) return "area of a shell";
    if (alone && std::fabs(mine.volume - theirs.volume) > 1e-10 * area * (largest_radius_ + 2 * extent)) {
      return "volume of a shell";
    }
  }
  const double all = 1e-10 * (1 + static_cast<double>(totals_.faces)) * 13 * largest_radius_ * largest_radius_ *
                     (largest_radius_ + 2 * extent);
  if (std::fabs(voids - totals_.void_volume) > all) return "volume of voids";
  return std::fabs(volume - voids - totals_.volume) > all ? "volume of the union" : "";
}

std::string BrickComparison::damage_is_seen(Random &random, const Summary &summary) {
  Summary bad = summary;
  if (random.one_in(2))
    bad.resize(random.below(static_cast<uint32_t>(bad.size())));
  else
    bad[random.below(static_cast<uint32_t>(bad.size()))] ^= static_cast<uint8_t>(1U << random.below(8));
  bad.reserve(1);  // an address even of none
  ++counters_.refused;
  return is_refused(bad, summary) ? "" : "damage is not seen";
}

std::string BrickComparison::merges_differ(Random &random, std::vector<Summary> parts, bool kept) {
  while (parts.size() > 1) {
    const uint32_t count = static_cast<uint32_t>(parts.size());
    const uint32_t a = random.below(count);
    const uint32_t b = (a + 1 + random.below(count - 1)) % count;
    Summary merged;
    if (const int32_t status = support::merge(parts[a], parts[b], merged); status != HSP_OK) {
      return std::string("merge: ") + hsp_status_text(status);
    }
    if (random.one_in(20)) {
      if (const std::string wrong = damage_is_seen(random, merged); !wrong.empty()) return wrong;
    }
    parts[a].swap(merged);
    parts.erase(parts.begin() + b);
    ++counters_.merges;
  }
  hsp_brick_totals totals;
  if (const int32_t status = support::get_totals(parts[0], totals); status != HSP_OK) {
    return std::string("totals: ") + hsp_status_text(status);
  }
  if (!support::same_bits(totals, totals_)) return "totals";
  return kept && !support::same_bits(support::shells_of(parts[0]), shells_) ? "shells" : "";
}

// A brick twice, one that is missing, another lattice, another number of bricks, other flags.
std::string BrickComparison::faults_are_seen(const std::vector<Summary> &parts) {
  if (parts.size() < 2) return "";
  uint32_t brick = HSP_NONE;
  Summary merged = parts[1];
  hsp_brick_totals totals;
  if (support::merge(parts[0], parts[0], merged, &brick) != HSP_E_ID || brick != 0) return "a brick twice";
  for (size_t k = 2; k < parts.size(); ++k) {
    if (support::merge(merged, parts[k], merged, &brick) != HSP_OK || brick != HSP_NONE) return "merge of a part";
  }
  if (support::get_totals(merged, totals, &brick) != HSP_E_STATE || brick != 0) return "a missing brick";
  const std::vector<uint8_t> none(balls_.size());
  const OwnedBalls empty = balls_.part(none);
  const uint32_t bricks = static_cast<uint32_t>(parts.size());
  const auto is_refused_as_one_of = [&](double largest, uint32_t of, uint32_t flags) {
    maker_.compute(empty, largest);
    const Summary other = maker_.summarise(empty, 1, of, flags);
    counters_.refused += 1;
    return support::merge(parts[0], other, merged, &brick) == HSP_E_ARGUMENT && brick == 1;
  };
  if (!is_refused_as_one_of(largest_radius_ == 1 ? 2 : 1, bricks, 0)) return "another lattice";
  if (!is_refused_as_one_of(largest_radius_, bricks + 1, 0)) return "another number of bricks";
  return is_refused_as_one_of(largest_radius_, bricks, HSP_BRICK_KEEP_SHELLS) ? "" : "other flags";
}

std::string BrickComparison::split_differs(Random &random) {
  const uint32_t bricks = split_at_random(random, balls_);
  const uint32_t kind = random.below(3);
  const Halos halos(balls_, whole_.work().model, static_cast<int64_t>(largest_radius_));
  std::vector<Summary> parts, kept;
  for (uint32_t brick = 0; brick < bricks; ++brick) {
    const OwnedBalls model = halos.model_of(brick, kind, random);
    maker_.compute(model, largest_radius_);
    if (random.one_in(10)) maker_.forget_memory();
    parts.push_back(maker_.summarise(model, brick, bricks, 0));
    if (maker_.calls() > 3) return "too many calls of summarise";
    kept.push_back(maker_.summarise(model, brick, bricks, HSP_BRICK_KEEP_SHELLS));
    counters_.bytes += parts.back().size();
    if (random.one_in(20)) {
      if (const std::string wrong = damage_is_seen(random, parts.back()); !wrong.empty()) return wrong;
    }
  }
  counters_.bricks += bricks;
  if (const std::string wrong = merges_differ(random, parts, false); !wrong.empty()) return wrong;
  if (const std::string wrong = merges_differ(random, kept, true); !wrong.empty()) return "kept: " + wrong;
  return random.one_in(5) ? faults_are_seen(parts) : "";
}

std::string BrickComparison::complaint(const BrickSet &set, Random &random, int splits) {
  try {
    take(set, random);
    ++counters_.sets;
    if (const std::string wrong = one_piece(); !wrong.empty()) return set.family + ", one piece: " + wrong;
    counters_.voids += totals_.voids;
    counters_.tied += totals_.tied_vertices;
    for (int k = 0; k < splits; ++k) {
      ++counters_.splits;
      if (const std::string wrong = split_differs(random); !wrong.empty()) return set.family + ": " + wrong;
    }
  } catch (const std::exception &fault) {
    return set.family + ": " + fault.what();
  }
  return "";
}
