// The first steps of a visibility map: balls in view coordinates, and the grid of their discs.
#pragma once

#include <array>

#include "built_grid.hpp"
#include "lattice_lengths.hpp"
#include "maps/disc_grid.hpp"
#include "random_balls.hpp"

class PlacedBalls {
 public:
  explicit PlacedBalls(const oracle::Balls &balls, const std::array<double, 3> &towards = {0, 0, 1},
                       double perturbation = 0)
      : grid_(oracle::in_lengths(balls, 1)) {
    seen_memory_.carve(seen, size(), size());
    disc_memory_.carve(discs, size());
    hsp::ViewFrame frame;
    hsp::look_from({{towards[0], towards[1], towards[2]}, {0, 1, 0}}, frame);
    hsp::centre_on(grid_.grid().balls(), frame);
    hsp::Patience endless;
    seen.choose(grid_.grid(), frame, endless);
    seen.place(grid_.grid().balls(), frame, hsp::Perturbation{perturbation, 0}, endless);
    discs.build(seen.balls());
    discs.mark_inside(seen.balls(), endless);
  }

  uint32_t size() const { return grid_.grid().balls().n; }

 private:
  BuiltGrid grid_;
  CarvedMemory seen_memory_, disc_memory_;

 public:
  hsp::SeenBalls seen;
  hsp::DiscGrid discs;
};
