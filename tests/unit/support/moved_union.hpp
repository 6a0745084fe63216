// Balls that move, beside the same balls computed afresh by the library's boundary and measures: every number is
// compared bit for bit.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "ball_list.hpp"
#include "boundary/boundary_builder.hpp"
#include "built_grid.hpp"
#include "energy_of_all.hpp"
#include "lattice_lengths.hpp"
#include "measure/tangency.hpp"
#include "moving/moving_balls.hpp"

// All numbers that are compared: of the whole union, and of each ball.
struct UnionNumbers {
  hsp::BallMeasure totals;
  hsp::Energy energy;
  std::vector<double> of_ball;  // area, volume, four derivatives
  std::vector<bool> one_sided;
  hsp::MovingCounts counts;

  void add(const hsp::BallMeasure &measure, const hsp::EnergyGradient &gradient) {
    of_ball.insert(of_ball.end(), {measure.area, measure.volume, gradient.centre[0], gradient.centre[1],
                                   gradient.centre[2], gradient.radius});
    one_sided.push_back(gradient.one_sided);
  }
};

inline bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

// Empty, or what differs.
inline std::string difference(const UnionNumbers &a, const UnionNumbers &b) {
  const auto same_counts = [](const hsp::MovingCounts &p, const hsp::MovingCounts &q) {
    return p.exposed == q.exposed && p.contained == q.contained && p.half_edges == q.half_edges &&
           p.circle_sides == q.circle_sides && p.loops == q.loops && p.faces == q.faces;
  };
  if (!same_counts(a.counts, b.counts)) return "counts";
  if (a.counts.components != b.counts.components) {
    return "components: " + std::to_string(a.counts.components) + ", " + std::to_string(b.counts.components);
  }
  const char *const names[] = {"area", "volume", "x", "y", "z", "radius"};
  for (size_t k = 0; k < a.of_ball.size(); ++k) {
    if (!same_bits(a.of_ball[k], b.of_ball[k])) return names[k % 6] + (" of ball " + std::to_string(k / 6));
  }
  if (a.one_sided != b.one_sided) return "flags";
  if (!same_bits(a.totals.area, b.totals.area)) return "area";
  if (!same_bits(a.totals.volume, b.totals.volume)) return "volume";
  const hsp::Energy &e = a.energy, &f = b.energy;
  return same_bits(e.area, f.area) && same_bits(e.volume, f.volume) && same_bits(e.value, f.value) &&
                 same_bits(e.by_probe, f.by_probe)
             ? ""
             : "energy";
}

class MovedUnion {
 public:
  MovedUnion(const support::BallList &balls, double largest_radius, uint32_t neighbours,
             const hsp::EnergyTerms &terms = {{}, 1.0, 0.0}, double probe = 0.0, double step = 1.0)
      : balls_(balls), largest_(largest_radius), probe_(probe), step_(step), terms_(terms) {
    const uint32_t n = balls.size();
    const uint32_t small = n < 64 ? n : 1;  // of sets in which all may meet
    grid_memory_.carve(grid_, n);
    written_memory_.carve(written_, n);
    boundary_memory_.carve(builder_, hsp::BoundaryLimits{n, n, 64 + 8 * n * small, 16 + 2 * n * small});
    memory_.carve(moving_, hsp::MovingLimits{n, neighbours});
    status_ = read();
    if (status_ == hsp::Status::ok) status_ = moving_.set(grid_, terms_);
  }

  hsp::Status status() const { return status_; }
  hsp::MovingBalls &moving() { return moving_; }
  const support::BallList &balls() const { return balls_; }

  hsp::Status move(const std::vector<uint32_t> &ids, const support::BallList &to) {
    uint32_t first_bad = 0;
    const hsp::Status status =
        moving_.move({static_cast<uint32_t>(ids.size()), ids.data(), to.xyz.data(), to.radius.data()}, first_bad);
    if (status != hsp::Status::ok) return status;
    before_ = balls_;
    for (size_t k = 0; k < ids.size(); ++k) {
      for (size_t axis = 0; axis < 3; ++axis) balls_.xyz[3 * ids[k] + axis] = to.xyz[3 * k + axis];
      balls_.radius[ids[k]] = to.radius[k];
    }
    return status;
  }
  hsp::Status undo() {
    const hsp::Status status = moving_.undo();
    if (status == hsp::Status::ok) balls_ = before_;
    return status;
  }

  // Empty, or the name of what differs between the moved balls and the same balls computed afresh.
  std::string complaint(bool wide = true) {
    if (read() != hsp::Status::ok) return "the grid";
    if (!writes_that_grid()) return "the grid that is written";
    builder_.use(wide ? hsp::best_target() : hsp::Target::baseline, wide && hsp::has_lanes);
    if (builder_.build(grid_) != hsp::Status::ok) return "the boundary";
    return difference(moved_numbers(), fresh_numbers());
  }

  UnionNumbers moved_numbers() const {
    UnionNumbers numbers;
    for (uint32_t i = 0; i < moving_.size(); ++i) numbers.add(moving_.measure(i), moving_.gradient(i));
    numbers.totals = moving_.totals();
    numbers.energy = moving_.energy();
    numbers.counts = moving_.counts();
    return numbers;
  }

 private:
  // Whether writing the moved balls as a grid gives the same grid as reading the balls afresh.
  bool writes_that_grid() {
    if (moving_.write(written_) != hsp::Status::ok) return false;
    const hsp::BallSet &given = grid_.balls(), &balls = written_.balls();
    bool same = given.n == balls.n && given.probe_steps == balls.probe_steps && grid_.side() == written_.side() &&
                given.largest_radius == balls.largest_radius && grid_.cubes() == written_.cubes() &&
                same_bits(given.lattice.step(), balls.lattice.step());
    for (uint32_t i = 0; same && i < balls.n; ++i) {
      same = given.x[i] == balls.x[i] && given.y[i] == balls.y[i] && given.z[i] == balls.z[i] &&
             given.r[i] == balls.r[i] && given.caller[i] == balls.caller[i] &&
             grid_.grid_index(i) == written_.grid_index(i);
    }
    for (uint32_t cube = 0; same && cube < grid_.cubes(); ++cube) {
      same = grid_.cube_list().coordinates(cube) == written_.cube_list().coordinates(cube) &&
             grid_.balls_in(cube).first == written_.balls_in(cube).first &&
             grid_.balls_in(cube).last == written_.balls_in(cube).last;
    }
    return same;
  }
  hsp::Status read() {
    uint32_t first_bad = 0;
    return grid_.build({balls_.size(), balls_.xyz.data(), balls_.radius.data(), probe_, step_, largest_}, first_bad);
  }
  UnionNumbers fresh_numbers() const {
    const hsp::Boundary &boundary = builder_.boundary();
    UnionNumbers numbers;
    const uint32_t n = grid_.balls().n;
    std::vector<hsp::BallMeasure> measures(n);
    std::vector<hsp::EnergyGradient> gradients(n);
    numbers.totals = hsp::measure_union(grid_, boundary, nullptr,
                                        [&](uint32_t i, const hsp::BallMeasure &measure) { measures[i] = measure; });
    numbers.energy = support::differentiate_energy(
        grid_, boundary, terms_, [&](uint32_t i, const hsp::EnergyGradient &gradient) { gradients[i] = gradient; });
    hsp::visit_free_inner_contacts(grid_, boundary, [&](uint32_t inner, uint32_t outer) {
      gradients[grid_.balls().caller[inner]].one_sided = gradients[grid_.balls().caller[outer]].one_sided = true;
    });
    for (uint32_t i = 0; i < n; ++i) {
      numbers.add(measures[i], gradients[i]);
      numbers.counts.exposed += boundary.is_exposed(i) ? 1U : 0U;
      numbers.counts.contained += boundary.is_contained(i) ? 1U : 0U;
    }
    numbers.counts.components = boundary.component_count();
    numbers.counts.half_edges = boundary.half_edge_count();
    numbers.counts.circle_sides = 2 * static_cast<uint64_t>(boundary.circle_count());
    numbers.counts.loops = boundary.loop_count();
    numbers.counts.faces = boundary.face_count();
    return numbers;
  }

  support::BallList balls_, before_;
  double largest_, probe_, step_;
  hsp::EnergyTerms terms_;
  CarvedMemory grid_memory_, written_memory_, boundary_memory_, memory_;
  hsp::CubeGrid grid_, written_;
  hsp::BoundaryBuilder builder_;
  hsp::MovingBalls moving_;
  hsp::Status status_ = hsp::Status::ok;
};
