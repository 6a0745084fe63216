// hsp_cells and hsp_pores in memory of their own, pockets and what measures them, for the benchmarks; see handles.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "handles.hpp"
#include "owned_spaces.hpp"

namespace bench {

// The cells of free space of a model.
class FreeSpace {
 public:
  // Makes as much room as is needed, and computes the cells.
  explicit FreeSpace(const Model &model);

  void compute();
  hsp_cells_counts counts() const;
  // Locates points [count][3] in cells. Returns how many points are in none.
  size_t locate(const std::vector<double> &points) const;

 private:
  const Model *model_;
  support::OwnedHandle<support::CellsKind> cells_;
};

// All maxima and gates above the floor 0, and the tree of their classes.
class Pores {
 public:
  // before: earlier pores of fewer balls, as in hsp_pores_options, or null.
  explicit Pores(const Model &model, const hsp_pores *before = nullptr) : model_(model) {
    support::expect_ok(hsp_pores_options_init(&options_, sizeof options_), "hsp_pores_options_init");
    options_.before = before;
    hsp_pores_limits limits;
    support::expect_ok(hsp_pores_limits_init(&limits, sizeof limits, model.size()), "hsp_pores_limits_init");
    pores_.take(limits);
    pores_.compute([&](hsp_pores *pores, hsp_pores_limits *asked) {
      return hsp_pores_compute(pores, model_.get(), &options_, asked);
    });
  }
  void compute() {
    support::expect_ok(hsp_pores_compute(pores_.get(), model_.get(), &options_, nullptr), "hsp_pores_compute");
  }
  // The regions of free space beside the balls, with area and volume.
  hsp_pore_access find_regions(const Boundary &boundary) {
    hsp_pore_access access{};
    support::expect_ok(hsp_pores_find_regions(pores_.get(), boundary.get(), &access, nullptr),
                       "hsp_pores_find_regions");
    return access;
  }
  hsp_pores *get() const { return pores_.get(); }

 private:
  const Model &model_;
  hsp_pores_options options_{};
  support::OwnedHandle<support::PoresKind> pores_;
};

// The pockets of a model between two probes, and pores of its balls with plugs in their mouths.
class Pockets {
 public:
  explicit Pockets(const Model &model);

  // Finds the pockets in maxima and gates. Returns the number of pockets.
  uint32_t find();
  // Lists plugs for all mouths behind the balls. Returns the number of plugs.
  uint32_t list_plugs();
  // Computes the pores of balls and plugs from those of the balls. Returns the number of balls and plugs.
  uint32_t compute_plugged();
  // Finds the sizes of pockets. Leaks are left open. Returns the number of pockets that are closed.
  uint32_t measure();

 private:
  static constexpr double narrow = 0.8, wide = 3.0;

  Pores pores_;
  uint32_t count_, balls_;
  Balls plugged_balls_;
  Model plugged_model_;
  Boundary plugged_boundary_;
  Pores plugged_;
  std::vector<hsp_pore_pocket_size> sizes_;
};

}  // namespace bench
