// The balls around a point, of a set or of a periodic box, as ways up from any point look for them. Nothing is written
// for that but what they find, so that several threads may look.
#pragma once

#include "model/queries.hpp"
#include "periodic/periodic_queries.hpp"

namespace hsp {

// A ball of the caller, so many boxes from where it is listed.
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
  // Around all centres; of no use in a periodic box.
  const LatticeBox &centres() const { return centres_; }
  // Null without one.
  const PeriodicBox *box() const { return periodic_ == nullptr ? nullptr : &periodic_->images().box(); }
  exact::LatticeBall ball(const NearImage &image) const {
    exact::LatticeBall ball = set().ball(grid_->grid_index(image.ball));
    if (periodic_ == nullptr) return ball;
    const exact::Vector by = box()->translation(image.shift);
    ball.centre = {ball.centre.x + by.x, ball.centre.y + by.y, ball.centre.z + by.z};
    return ball;
  }
  // How many meet a ball; if they are no more than there is room for, these. room: at most `most`.
  uint32_t find(const LatticeQuery &query, NearImage *near, uint32_t room) const;
  // The same of those whose spheres are within a reach below 0 of a point, by doubles: a point in many balls is deep in
  // most of them. Looks at all that it is in.
  uint32_t find_deep(const exact::Vector &point, double reach, NearImage *near, uint32_t room) const;
  // Calls sink(image) for all that meet a ball, however many.
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
