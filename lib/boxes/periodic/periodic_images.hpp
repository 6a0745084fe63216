// The balls of a periodic box, each moved into the box, and their images that may meet one of these. They are numbered
// as one set: first the balls in the order of the input, then the images by ball and by shift. So of images at one
// position those of the earlier ball come first in every copy of the box. The symbolic perturbation compares positions,
// radii and numbers: so it is the same in all copies.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/patience.hpp"
#include "core/workspace.hpp"
#include "model/ball_set.hpp"
#include "periodic/periodic_box.hpp"

namespace hsp {

class PeriodicImages {
 public:
  void carve(Workspace &workspace, uint32_t balls, uint32_t images);

  // On failure there are no balls, and first_bad names the ball to blame. Status::capacity if a limit is too small;
  // counted_images() then says how many images there are.
  Status build(const BallInput &input, const double vector[9], uint32_t &first_bad, Patience patience = Patience());

  uint32_t balls() const { return n_; }
  // The number of balls and images.
  uint32_t size() const { return n_ + images_; }
  uint64_t counted_images() const { return counted_; }
  bool is_image(uint32_t k) const { return k >= n_; }
  uint32_t ball_of(uint32_t k) const { return ball_of_[k]; }
  const uint32_t *balls_of_all() const { return ball_of_.data(); }
  // The shift from ball_of(k) to ball or image k, in vectors of the box.
  BoxShift shift_of(uint32_t k) const {
    if (!is_image(k)) return {};
    const ImageShift &shift = shift_[k - n_];
    return {{shift.k[0], shift.k[1], shift.k[2]}};
  }
  // The number of the first image of a ball, if it has any.
  uint32_t first_image(uint32_t ball) const { return n_ + first_image_[ball]; }
  // The number of the image of a ball with this shift, or of the ball itself for shift 0; no_id if it is not in the
  // set.
  uint32_t find(uint32_t ball, const BoxShift &shift) const;

  // home(): the shift from a ball's place in the box to where the caller has put it. shift_from_caller(): the shift
  // from where the caller has put the ball to ball or image k.
  const BoxShift &home(uint32_t ball) const { return home_[ball]; }
  BoxShift shift_from_caller(uint32_t k) const { return shift_of(k) - home_[ball_of(k)]; }
  // By which multiples of the given vectors the caller's second ball has to be moved, so that it lies to the caller's
  // ball `from` as ball or image `to` lies to the place of `from` in the box.
  BoxShift caller_shift(uint32_t from, uint32_t to) const {
    return box_.in_given_vectors(shift_from_caller(to) + home_[from]);
  }

  const PeriodicBox &box() const { return box_; }
  // The lattice of the input; lengths of the set are in steps.
  const exact::Lattice &lattice() const { return lattice_; }
  int64_t probe_steps() const { return probe_steps_; }
  int64_t largest_radius() const { return set_.largest_radius; }
  // All balls and images, in steps, for a grid.
  const BallSet &in_steps() const { return set_; }

 private:
  struct ImageShift {
    int8_t k[3];
  };

  Status fill(const BallInput &input, const double vector[9], uint32_t &first_bad, Patience &patience);
  // Finds ball i of the input, turned with the box, at its place in the box.
  Status place(const BallRounding &rounding, const BallInput &input, uint32_t i, exact::LatticeBall &ball,
               BoxShift &home) const;

  uint32_t n_ = 0, images_ = 0;
  uint64_t counted_ = 0;
  Span<uint32_t> ball_of_;      // [balls + images]
  Span<ImageShift> shift_;      // [images]
  Span<uint32_t> first_image_;  // [balls + 1]
  Span<BoxShift> home_;         // [balls]
  BallSet set_;                 // [balls + images]
  PeriodicBox box_;
  exact::Lattice lattice_;
  int64_t probe_steps_ = 0;
};

}  // namespace hsp
