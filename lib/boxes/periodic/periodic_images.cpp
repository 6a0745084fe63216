#include "periodic/periodic_images.hpp"

#include "core/first_index.hpp"

namespace hsp {

void PeriodicImages::carve(Workspace &workspace, uint32_t balls, uint32_t images) {
  const uint64_t all = uint64_t{balls} + images;
  n_ = images_ = set_.n = 0;
  ball_of_ = workspace.take<uint32_t>(all);
  shift_ = workspace.take<ImageShift>(images);
  first_image_ = workspace.take<uint32_t>(uint64_t{balls} + 1);
  home_ = workspace.take<BoxShift>(balls);
  set_.carve(workspace, static_cast<uint32_t>(all));
}

Status PeriodicImages::build(const BallInput &input, const double vector[9], uint32_t &first_bad, Patience patience) {
  n_ = images_ = 0;
  counted_ = 0;
  const Status status = fill(input, vector, first_bad, patience);
  if (status != Status::ok) n_ = images_ = 0;
  set_.n = size();
  return status;
}

Status PeriodicImages::fill(const BallInput &input, const double vector[9], uint32_t &first_bad, Patience &patience) {
  first_bad = no_id;
  BallInput in_box = input;
  for (int k = 0; k < 9; ++k) {
    const double length = std::fabs(vector[k]);
    if (is_finite(length) && length > in_box.extent) in_box.extent = length;
  }
  BallRounding rounding;
  if (const Status status = rounding.prepare(in_box, first_bad); status != Status::ok) return status;
  lattice_ = rounding.lattice();
  probe_steps_ = rounding.probe_steps();
  if (const Status status = box_.set(lattice_, vector); status != Status::ok) return status;
  const uint32_t room = home_.size();
  set_.lattice = exact::Lattice::with_step(1.0);
  set_.largest_radius = 0;
  for (uint32_t i = 0; i < input.n; ++i) {
    if (!patience.allows(100)) return Status::stopped;
    exact::LatticeBall ball;
    BoxShift home;
    if (const Status status = place(rounding, input, i, ball, home); status != Status::ok) {
      first_bad = i;
      return status;
    }
    if (ball.radius > set_.largest_radius) set_.largest_radius = ball.radius;
    if (i >= room) continue;
    home_[i] = home;
    ball_of_[i] = i;
    set_.store(i, ball);
  }
  const int64_t largest_radius = set_.largest_radius;
  if (!box_.suits(largest_radius)) return Status::range;
  for (uint32_t i = 0; i < input.n; ++i) {
    if (!patience.allows(200)) return Status::stopped;
    exact::LatticeBall ball;
    if (i < room) {
      first_image_[i] = clamped_count(counted_);
      ball = set_.ball(i);
    } else {
      BoxShift home;
      static_cast<void>(place(rounding, input, i, ball, home));
    }
    // Any image that meets a ball in the box is as near as that.
    box_.visit_images(ball.centre, ball.radius + largest_radius, [&](const BoxShift &shift) {
      if (input.n <= room && counted_ < shift_.size()) {
        const uint32_t image = static_cast<uint32_t>(counted_);
        const exact::Vector t = box_.translation(shift);
        for (int axis = 0; axis < 3; ++axis) shift_[image].k[axis] = static_cast<int8_t>(shift.k[axis]);
        ball_of_[input.n + image] = i;
        set_.store(input.n + image,
                   {{ball.centre.x + t.x, ball.centre.y + t.y, ball.centre.z + t.z}, ball.radius, input.n + image});
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

// Status::range: a coordinate may become too large when it is turned.
Status PeriodicImages::place(const BallRounding &rounding, const BallInput &input, uint32_t i, exact::LatticeBall &ball,
                             BoxShift &home) const {
  Status status = Status::ok;
  if (box_.frame().turns()) {
    const double *const given = input.xyz + 3 * size_t{i};
    const Vec3 turned = box_.frame().turned_in(given);
    const double xyz[3] = {turned.x, turned.y, turned.z};
    status = round_ball(lattice_, probe_steps_, xyz, input.radius[i], i, ball);
    if (status != Status::ok && is_finite(given[0]) && is_finite(given[1]) && is_finite(given[2])) return Status::range;
  } else {
    status = rounding.round(i, ball);
  }
  return status == Status::ok ? box_.wrap(ball.centre, home) : status;
}

uint32_t PeriodicImages::find(uint32_t ball, const BoxShift &shift) const {
  if (shift.is_zero()) return ball;
  const uint32_t last = first_image_[ball + 1];
  const uint32_t image =
      first_index(first_image_[ball], last, [&](uint32_t k) { return !visited_before(shift_of(n_ + k), shift); });
  return image < last && shift_of(n_ + image) == shift ? n_ + image : no_id;
}

}  // namespace hsp
