#include "periodic/periodic_images.hpp"

#include "core/first_index.hpp"

namespace hsp {

void PeriodicImages::carve(Workspace &workspace, uint32_t balls, uint32_t images) {
  const uint64_t all = uint64_t{balls} + images;
  n_ = images_ = 0;
  ball_of_ = workspace.take<uint32_t>(all);
  shift_ = workspace.take<ImageShift>(images);
  first_image_ = workspace.take<uint32_t>(uint64_t{balls} + 1);
  home_ = workspace.take<BoxShift>(balls);
  xyz_ = workspace.take<double>(3 * all);
  radius_ = workspace.take<double>(all);
}

Status PeriodicImages::build(const BallInput &input, const double vector[9], uint32_t &first_bad) {
  n_ = images_ = 0;
  counted_ = 0;
  const Status status = fill(input, vector, first_bad);
  if (status != Status::ok) n_ = images_ = 0;
  return status;
}

Status PeriodicImages::fill(const BallInput &input, const double vector[9], uint32_t &first_bad) {
  first_bad = no_id;
  BallRounding rounding;
  if (const Status status = rounding.prepare(input, first_bad); status != Status::ok) return status;
  lattice_ = rounding.lattice();
  probe_steps_ = rounding.probe_steps();
  if (const Status status = box_.set(lattice_, vector); status != Status::ok) return status;
  const uint32_t room = home_.size();
  largest_radius_ = 0;
  for (uint32_t i = 0; i < input.n; ++i) {
    exact::LatticeBall ball;
    BoxShift home;
    Status status = rounding.round(i, ball);
    if (status == Status::ok) status = box_.wrap(ball.centre, home);
    if (status != Status::ok) {
      first_bad = i;
      return status;
    }
    if (ball.radius > largest_radius_) largest_radius_ = ball.radius;
    if (i >= room) continue;
    home_[i] = home;
    ball_of_[i] = i;
    put(i, ball.centre, ball.radius);
  }
  if (!box_.suits(largest_radius_)) return Status::range;
  for (uint32_t i = 0; i < input.n; ++i) {
    exact::LatticeBall ball;
    if (i < room) {
      ball = stored(i);
      first_image_[i] = clamped_count(counted_);
    } else {
      BoxShift home;
      static_cast<void>(rounding.round(i, ball));
      static_cast<void>(box_.wrap(ball.centre, home));
    }
    // Whatever meets a ball in the box is that near to it.
    box_.visit_images(ball.centre, ball.radius + largest_radius_, [&](const BoxShift &shift) {
      if (input.n <= room && counted_ < shift_.size()) {
        const uint32_t image = static_cast<uint32_t>(counted_);
        const exact::Vector t = box_.translation(shift);
        for (int axis = 0; axis < 3; ++axis) shift_[image].k[axis] = static_cast<int8_t>(shift.k[axis]);
        ball_of_[input.n + image] = i;
        put(input.n + image, {ball.centre.x + t.x, ball.centre.y + t.y, ball.centre.z + t.z}, ball.radius);
      }
      ++counted_;
    });
  }
  if (input.n > room || counted_ > shift_.size()) return Status::capacity;
  n_ = input.n;
  images_ = static_cast<uint32_t>(counted_);
  first_image_[n_] = images_;
  return Status::ok;
}

void PeriodicImages::put(uint32_t k, const exact::Vector &centre, int64_t radius) {
  xyz_[3 * k] = static_cast<double>(centre.x);
  xyz_[3 * k + 1] = static_cast<double>(centre.y);
  xyz_[3 * k + 2] = static_cast<double>(centre.z);
  radius_[k] = static_cast<double>(radius);
}

exact::LatticeBall PeriodicImages::stored(uint32_t k) const {
  const double *const at = &xyz_[3 * k];
  return {{static_cast<int64_t>(at[0]), static_cast<int64_t>(at[1]), static_cast<int64_t>(at[2])},
          static_cast<int64_t>(radius_[k]),
          k};
}

uint32_t PeriodicImages::find(uint32_t ball, const BoxShift &shift) const {
  if (shift.is_zero()) return ball;
  const uint32_t last = first_image_[ball + 1];
  const uint32_t image =
      first_index(first_image_[ball], last, [&](uint32_t k) { return !visited_before(shift_of(n_ + k), shift); });
  return image < last && shift_of(n_ + image) == shift ? n_ + image : no_id;
}

BallInput PeriodicImages::in_steps() const {
  BallInput input;
  input.n = size();
  input.xyz = xyz_.data();
  input.radius = radius_.data();
  input.step = 1.0;
  return input;
}

}  // namespace hsp
