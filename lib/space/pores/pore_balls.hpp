// The balls that are nearest somewhere: those of a set that are not inside another one. In a periodic box their images
// come in, of which there is no end.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/patience.hpp"
#include "model/queries.hpp"
#include "periodic/periodic_images.hpp"
#include "pores/pores.hpp"

namespace hsp {

class PoreBalls {
 public:
  // balls: room for the balls and the images that surround() makes; near: how many balls may be around one point.
  void carve(Workspace &workspace, uint32_t balls, uint32_t near);

  // Status::capacity: needed_balls() or needed_near() is more than there is room for. Status::range: a box that is more
  // than a hundred times longer than wide.
  Status take(const CubeGrid &grid, Patience &patience);
  Status take(const PeriodicImages &images, Patience &patience);
  // Puts behind the balls all images whose centres are within `reach` of the box.
  Status surround(int64_t reach);

  // After take() without a box: compares these balls with `others`. True if all balls of `others` are in the grid, too,
  // at the same places, with radii larger by one length, `grown`. Then is_new() is known.
  bool compare(const CubeGrid &grid, const PoreBalls &others, int64_t &grown);
  // After compare(): whether a ball is not one of `others`.
  bool is_new(uint32_t own_ball) const { return ball_of_[own_ball] == no_id; }
  // The own number of a ball of the caller; no_id if it is inside another one.
  uint32_t own_ball(uint32_t callers) const { return own_slot(callers).bits; }

  // How many balls there are without images. Ball and image numbers: the own balls first, then the images.
  uint32_t own() const { return own_; }
  const BallSet &set() const { return set_; }
  const PeriodicBox *box() const { return box_; }
  // Sets the corners of the box around the centres of the own balls; 0 without balls.
  void find_box(Vec3 &low, Vec3 &high) const;
  uint32_t callers(uint32_t own_ball) const { return callers_[own_ball]; }
  // The own ball that number k is or is an image of; and its shift.
  uint32_t ball_of(uint32_t k) const { return k < own_ ? k : ball_of_[k - own_]; }
  BoxShift shift_of(uint32_t k) const { return k < own_ ? BoxShift{} : shift_of_[k - own_].shift(); }
  exact::LatticeBall image(uint32_t own_ball, const BoxShift &shift) const {
    exact::LatticeBall ball = set_.ball(own_ball);
    if (box_ != nullptr && !shift.is_zero()) ball.centre = moved(ball.centre, box_->translation(shift));
    return ball;
  }
  // Translations that take every ball of the box to the place of an equal ball or image: symmetry of the crystal beyond
  // that of the box. Translation 0 moves nothing.
  uint32_t translations() const { return translation_count_; }
  struct Image {
    uint32_t ball;
    BoxShift shift;
  };
  Image moved_image(uint32_t own_ball, const BoxShift &shift, uint32_t translation) const;
  // The sides of a brick at the origin. Its copies by the translations and by the vectors of the box fill space.
  const exact::Vector &brick() const { return brick_; }
  // Three quarters of the diagonal of the box, and a little more. From any point the nearest image of any one ball has
  // its centre no farther than two thirds of this, half of the diagonal.
  int64_t longest_reach() const { return longest_reach_; }

  // Calls sink(ball, shift) for each ball or image that meets the query ball. False without room for so many.
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
  // own_ball() of the caller's balls, kept at the end of the memory for the shifts of images.
  SmallShift &own_slot(uint32_t callers) const { return shift_of_[shift_of_.size() - given_ + callers]; }
  Status keep_outer(Patience &patience);
  uint32_t ball_at(const exact::Vector &position) const;
  void find_translations();
  bool note_translation(const exact::Vector &by, uint64_t &left);

  BallSet set_;  // `caller` of each is its own number; images are behind the own balls
  CubeGrid grid_;
  Span<uint32_t> callers_;
  Span<uint32_t> ball_of_;  // of images; without a box of own balls, the number in compare()'s `others`
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

// Some balls and images, gathered around one way up.
class NearBalls {
 public:
  void carve(Workspace &workspace, uint32_t room, uint32_t balls);
  void reset(const PoreBalls &balls);
  // Forgets all balls.
  void begin() { set_.n = 0; }
  // Adds an image unless it is there; returns its number here, or no_id without room.
  uint32_t add(uint32_t ball, const BoxShift &shift);

  const BallSet &set() const { return set_; }
  uint32_t size() const { return set_.n; }
  uint32_t needed() const { return needed_; }
  uint32_t ball(uint32_t k) const { return set_.caller[k]; }
  const BoxShift &shift(uint32_t k) const { return shift_[k]; }

 private:
  const PoreBalls *balls_ = nullptr;
  BallSet set_;  // `caller` of each is the ball that it is an image of
  Span<BoxShift> shift_;
  Span<uint32_t> last_;    // [ball] its last image here; of no meaning if that is an image of another ball
  Span<uint32_t> before_;  // [image] the image of the same ball that was added before; no_id for none
  uint32_t needed_ = 0;
};

}  // namespace hsp
