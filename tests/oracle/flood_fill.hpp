// The complement of a union of balls, filled column by column, with proofs: what is certainly free and what is perhaps
// free are kept apart, so that every statement made here holds for the balls themselves and not only for a grid.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

struct Box {
  LatticePoint low = {0, 0, 0};
  LatticePoint high = {0, 0, 0};
};

// The smallest box around the balls, larger by a margin on all sides.
Box box_around(const Balls &balls, int64_t margin);

// A box is cut into upright square columns. In each, z is free for certain where no ball meets the square at that
// height, and not free for certain where one ball covers the whole square; what remains is perhaps free. Both sets are
// unions of open runs in z with whole ends (rounded so that the statements stay true). Runs of columns that share a
// side are joined where they overlap. So
//   - all points of one certain region lie in one component of the complement;
//   - a component of the complement that meets a perhaps free region either lies in it or reaches the box's border:
//     a region that does not reach the border holds whole components, and if it holds a certain region, a void.
class FloodFill {
 public:
  // A connected set of runs.
  struct Region {
    bool reaches_border = false;
    long double volume = 0;
    Box extent;
    LatticePoint point = {0, 0, 0};  // the middle of the longest run, in the middle of its column
    int64_t longest = 0;             // that run's length
    uint32_t perhaps = 0;            // of a certain region: the perhaps free region around it
    uint32_t certain = 0;            // of a perhaps free region: how many certain ones it holds
  };

  // Columns of width `side`, an even number, from box.low; the last ones may stick out. Coordinates and radii below
  // 2^30.
  FloodFill(const Balls &balls, const Box &box, int64_t side);

  [[nodiscard]] const std::vector<Region> &certain() const { return certain_.regions; }
  [[nodiscard]] const std::vector<Region> &perhaps() const { return perhaps_.regions; }

  // The region around a point of the box.
  [[nodiscard]] std::optional<uint32_t> certain_at(const LatticePoint &point) const {
    return region_at(certain_, point);
  }
  [[nodiscard]] std::optional<uint32_t> perhaps_at(const LatticePoint &point) const {
    return region_at(perhaps_, point);
  }

  // A point in every certain run: what a finer or smaller filling finds again.
  struct Sample {
    LatticePoint point;
    uint32_t region;
  };
  [[nodiscard]] std::vector<Sample> certain_samples() const;

 private:
  struct Run {
    int64_t low;
    int64_t high;
    uint32_t region;
  };
  struct Layer {
    std::vector<Run> runs;
    std::vector<size_t> first;  // of each column; one more at the end
    std::vector<Region> regions;
  };
  struct Interval {
    int64_t low;
    int64_t high;
  };

  void append_gaps(std::vector<Interval> &closed, int64_t shortest, Layer &layer) const;
  void join_runs(Layer &layer) const;
  void find_regions_around();
  [[nodiscard]] std::optional<uint32_t> region_at(const Layer &layer, const LatticePoint &point) const;
  [[nodiscard]] LatticePoint middle(size_t column, const Run &run) const;

  Box box_;
  int64_t side_;
  size_t columns_x_;
  size_t columns_y_;
  Layer certain_;
  Layer perhaps_;
};

}  // namespace oracle
