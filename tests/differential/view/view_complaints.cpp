#include "view_complaints.hpp"

#include <view_invariants.h>

#include "computed_balls.hpp"
#include "exact_depth.hpp"
#include "random_balls.hpp"

namespace {

using oracle::Balls;

class ComputedView {
 public:
  ComputedView(const ComputedBalls &balls, const ViewChoice &choice) {
    const hsp_view_options options = choice.options();
    expect_ok(view_result_make(balls.get(), &options, choice.boundary ? 1 : 0, &view_), "view_result_make");
  }
  ~ComputedView() { view_result_release(&view_); }
  ComputedView(const ComputedView &) = delete;
  ComputedView &operator=(const ComputedView &) = delete;

  const view_result *get() const { return &view_; }

 private:
  view_result view_{};
};

ViewChoice all_of_boundary(const Direction &towards) {
  return {HSP_PIECES_OUTSIDE_ALL, HSP_VIEW_ALL_BALLS, true, towards, {}};
}

std::string depths_disagree(const view_result &view, const Balls &balls) {
  const std::array<int64_t, 3> direction = integer_direction(std::to_array(view.options.towards));
  for (uint32_t p = 1; p < view.info.pieces; ++p) {
    const uint32_t a = view.pieces[p - 1].ball;
    const uint32_t b = view.pieces[p].ball;
    if (!is_farther(balls[a], balls[b], direction))
      return "ball " + std::to_string(a) + " is painted before ball " + std::to_string(b);
  }
  if (view.options.pieces != HSP_PIECES_OUTSIDE_FARTHER) return "";
  for (uint32_t a = 0; a < view.info.arcs; ++a) {
    const uint32_t other = view.arcs[a].other_ball;
    const uint32_t ball = view.pieces[view.arcs[a].piece].ball;
    if (other != HSP_NONE && !is_farther(balls[other], balls[ball], direction))
      return "a G-piece of ball " + std::to_string(ball) + " is cut by the nearer ball " + std::to_string(other);
  }
  return "";
}

}  // namespace

std::string view_invariant_broken(const Balls &balls, const Direction &towards, const Direction &up) {
  const ComputedBalls set(balls);
  for (const ViewChoice &choice : all_choices(towards, up)) {
    const ComputedView view(set, choice);
    std::string broken = complaint_of(broken_view(view.get()));
    if (broken.empty()) broken = depths_disagree(*view.get(), balls);
    if (!broken.empty()) return choice.text() + ": " + broken;
  }
  return "";
}

std::string view_regions_disagree(const Balls &balls, uint32_t points, const Direction &towards) {
  const ComputedBalls set(balls);
  for (const ViewChoice &choice :
       {ViewChoice{HSP_PIECES_OUTSIDE_FARTHER, HSP_VIEW_ALL_BALLS, false, towards, {}}, all_of_boundary(towards)}) {
    const ComputedView view(set, choice);
    const std::string broken = complaint_of(broken_view_regions(view.get(), points, balls.size()));
    if (!broken.empty()) return choice.text() + ": " + broken;
  }
  return "";
}

std::string view_orders_disagree(const Balls &balls, const Direction &towards) {
  const ComputedBalls set(balls);
  oracle::RandomSource random(balls.size());
  for (int attempt = 0; attempt < 2; ++attempt) {
    const ComputedBalls other(oracle::permuted(balls, random.permutation(balls.size())));
    for (const ViewChoice &choice : all_choices(towards)) {
      const ComputedView one(set, choice);
      const ComputedView two(other, choice);
      const std::string what = complaint_of(view_difference_after_permutation(one.get(), two.get()));
      if (!what.empty()) return choice.text() + ": " + what;
    }
  }
  return "";
}

std::string opposite_areas_disagree(const Balls &balls, const Direction &towards) {
  const ComputedBalls set(balls);
  const ComputedView front(set, all_of_boundary(towards));
  const ComputedView back(set, all_of_boundary({-towards[0], -towards[1], -towards[2]}));
  return complaint_of(view_difference_from_behind(front.get(), back.get()));
}

std::string depths_disagree(const Balls &balls, const Direction &towards) {
  const ComputedBalls set(balls);
  for (const ViewChoice &choice : all_choices(towards)) {
    const ComputedView view(set, choice);
    const std::string what = depths_disagree(*view.get(), balls);
    if (!what.empty()) return choice.text() + ": " + what;
  }
  return "";
}
