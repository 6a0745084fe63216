// The balls around a point, of a set or of a periodic box, for ways up from any point. A search writes its result and
// nothing else, so that several threads may search at once.
#pragma once

#include "model/queries.hpp"
#include "periodic/periodic_queries.hpp"

namespace hsp {

// A ball of the caller, moved by `shift` boxes from its place in the caller's list.
struct NearImage {
  uint32_t ball;
  BoxShift shift;
};

class BallsAround {
 public:
  static constexpr uint32_t most = 192;

  BallsAround(const CubeGrid &grid);
  BallsAround(const PeriodicUnion &periodic) : grid_(&periodic.grid()), periodic_(&periodic) {}

  bool are_none() const { return grid_->balls().n == 0; }
  const BallSet &set() const { return grid_->balls(); }
  // The box around all centres; not set for a periodic box.
  const LatticeBox &centres() const { return centres_; }
  // The periodic box; null without one.
  const PeriodicBox *box() const { return periodic_ == nullptr ? nullptr : &periodic_->images().box(); }
  exact::LatticeBall ball(const NearImage &image) const {
    exact::LatticeBall ball = set().ball(grid_->grid_index(image.ball));
    if (periodic_ == nullptr) return ball;
    const exact::Vector by = box()->translation(image.shift);
    ball.centre = {ball.centre.x + by.x, ball.centre.y + by.y, ball.centre.z + by.z};
    return ball;
  }
  // Returns how many balls meet the query ball; lists them in `near` if there is room for all. room: at most `most`.
  uint32_t find(const LatticeQuery &query, NearImage *near, uint32_t room) const;
  // The same for the balls that the point is in so deeply that its distance to their spheres is at most `reach`, which
  // is below 0, by doubles. Looks at all balls that the point is in.
  uint32_t find_deep(const exact::Vector &point, double reach, NearImage *near, uint32_t room) const;
  // Calls sink(image) for all balls that meet the query ball, however many.
  template <class Sink>
  void visit(const LatticeQuery &query, Sink sink) const;

 private:
  const CubeGrid *grid_;
  const PeriodicUnion *periodic_ = nullptr;
  LatticeBox centres_;
};

template <class Sink>
void BallsAround::visit(const LatticeQuery &query, Sink sink) const {
  if (periodic_ != nullptr) {
    exact::Vector at = query.centre;
    BoxShift away;
    if (box()->wrap(at, away) != Status::ok) return;
    return visit_images_at(*periodic_, at, query.radius, [&](uint32_t ball, const BoxShift &shift) {
      sink(NearImage{ball, away + shift});
    });
  }
  const auto found = [&](uint32_t ball) { sink(NearImage{ball, {}}); };
  if (query.radius <= set().largest_radius) return visit_balls_at(*grid_, query.centre, query.radius, found);
  visit_meeting(set(), {0, set().n}, query.centre, query.radius, [&](uint32_t k) { found(set().caller[k]); });
}

}  // namespace hsp
