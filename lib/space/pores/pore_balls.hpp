// The balls that are nearest somewhere, those of a set that are not inside another one; in a periodic box with images
// of them, without end.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/patience.hpp"
#include "model/queries.hpp"
#include "periodic/periodic_images.hpp"
#include "pores/pores.hpp"

namespace hsp {

class PoreBalls {
 public:
  // balls: with as many images as surround() makes; near: how many may be around one point.
  void carve(Workspace &workspace, uint32_t balls, uint32_t near);

  // Status::capacity: needed_balls() or needed_near() is more than there is room for. Status::range: a box that is more
  // than a hundred times longer than wide.
  Status take(const CubeGrid &grid, Patience &patience);
  Status take(const PeriodicImages &images, Patience &patience);
  // Puts all images behind the balls whose centres are within `reach` of the box.
  Status surround(int64_t reach);

  // After take() without a box: compares with balls that others have, as they took them. False unless all of these are
  // in the grid as well, and have grown by one length since; then is_new() is known.
  bool compare(const CubeGrid &grid, const PoreBalls &others, int64_t &grown);
  // Whether a ball is none of the others.
  bool is_new(uint32_t own_ball) const { return ball_of_[own_ball] == no_id; }
  // That of the caller; no_id if it is inside another one.
  uint32_t own_ball(uint32_t callers) const { return own_slot(callers).bits; }

  // Without images.
  uint32_t own() const { return own_; }
  const BallSet &set() const { return set_; }
  const PeriodicBox *box() const { return box_; }
  uint32_t callers(uint32_t own_ball) const { return callers_[own_ball]; }
  // Of ball or image k.
  uint32_t ball_of(uint32_t k) const { return k < own_ ? k : ball_of_[k - own_]; }
  BoxShift shift_of(uint32_t k) const { return k < own_ ? BoxShift{} : shift_of_[k - own_].shift(); }
  exact::LatticeBall image(uint32_t own_ball, const BoxShift &shift) const {
    exact::LatticeBall ball = set_.ball(own_ball);
    if (box_ != nullptr && !shift.is_zero()) ball.centre = moved(ball.centre, box_->translation(shift));
    return ball;
  }
  // Ways to move all balls of a box together so that each comes to where an image is: symmetry of the crystal beyond
  // that of the box. The first is none at all.
  uint32_t translations() const { return translation_count_; }
  struct Image {
    uint32_t ball;
    BoxShift shift;
  };
  Image moved_image(uint32_t own_ball, const BoxShift &shift, uint32_t translation) const;
  // The sides of a brick at the origin whose copies by these and by the vectors of the box fill space.
  const exact::Vector &brick() const { return brick_; }
  // From any point the nearest centre of an image of any one ball is no farther than two thirds of this: a half of the
  // diagonal of the box.
  int64_t longest_reach() const { return longest_reach_; }

  // Calls sink(ball, shift) for each ball or image that meets a ball. False without room for so many.
  template <class Sink>
  bool visit_near(const LatticeQuery &query, Sink sink) {
    if (box_ == nullptr) return visit_own(query, BoxShift{}, sink);
    exact::Vector at = query.centre;
    BoxShift away;
    if (box_->wrap(at, away) != Status::ok) return false;
    bool room = visit_own({at, query.radius}, away, sink);
    box_->visit_images(at, query.radius + set_.largest_radius, [&](const BoxShift &shift) {
      room = visit_own({moved(at, box_->translation(shift)), query.radius}, away - shift, sink) && room;
    });
    return room;
  }
  uint32_t needed_near() const { return needed_near_; }
  uint32_t needed_balls() const { return needed_balls_; }

 private:
  static exact::Vector moved(const exact::Vector &p, const exact::Vector &t) {
    return {p.x + t.x, p.y + t.y, p.z + t.z};
  }
  template <class Sink>
  bool visit_own(const LatticeQuery &query, const BoxShift &shift, Sink sink) {
    QueryResult result{near_.data(), near_.size(), 0};
    find_balls_at_ball(grid_, query, result);
    needed_near_ = larger_count(needed_near_, result.hits);
    if (result.hits > near_.size()) return false;
    for (uint32_t k = 0; k < result.hits; ++k) sink(near_[k], shift);
    return true;
  }
  // Own numbers of the caller's balls, at the end of the memory for images.
  SmallShift &own_slot(uint32_t callers) const { return shift_of_[shift_of_.size() - given_ + callers]; }
  Status keep_outer(Patience &patience);
  uint32_t ball_at(const exact::Vector &position) const;
  void find_translations();
  bool note_translation(const exact::Vector &by, uint64_t &left);

  BallSet set_;  // each knows its own number; images are behind the others
  CubeGrid grid_;
  Span<uint32_t> callers_;
  Span<uint32_t> ball_of_;  // of images
  Span<SmallShift> shift_of_;
  Span<uint32_t> near_;
  const PeriodicBox *box_ = nullptr;
  int64_t longest_reach_ = 0;
  static constexpr uint32_t most_translations = 64;
  exact::Vector translation_[most_translations];
  exact::Vector brick_{};
  uint32_t translation_count_ = 1;
  uint32_t own_ = 0, given_ = 0, needed_near_ = 0, needed_balls_ = 0;
};

// Some balls and images, gathered around one way.
class NearBalls {
 public:
  void carve(Workspace &workspace, uint32_t room, uint32_t balls);
  void reset(const PoreBalls &balls);
  // Without any.
  void begin() { set_.n = 0; }
  // Its number here, also if it was here before; no_id without room.
  uint32_t add(uint32_t ball, const BoxShift &shift);

  const BallSet &set() const { return set_; }
  uint32_t size() const { return set_.n; }
  uint32_t needed() const { return needed_; }
  uint32_t ball(uint32_t k) const { return set_.caller[k]; }
  const BoxShift &shift(uint32_t k) const { return shift_[k]; }

 private:
  const PoreBalls *balls_ = nullptr;
  BallSet set_;  // each knows which ball it is an image of
  Span<BoxShift> shift_;
  Span<uint32_t> last_;    // of each ball its last image here; only if that is one of it
  Span<uint32_t> before_;  // the image of the same ball before; no_id for none
  uint32_t needed_ = 0;
};

}  // namespace hsp
