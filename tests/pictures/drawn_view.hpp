// A computed view that pictures are written of.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "hardsphere.h"
#include "lattice_ball.hpp"
#include "view_run.hpp"

class DrawnView {
 public:
  // Lattice steps are thousandths. Colours follow from the radii, as read_molecule gives them to elements.
  explicit DrawnView(const oracle::Balls &balls, Direction towards = {0, 0, 1},
                     uint32_t pieces = HSP_PIECES_OUTSIDE_FARTHER);

  [[nodiscard]] std::string picture(const hsp_picture_options &options, const char *title = nullptr,
                                    const char *description = nullptr) const;

  [[nodiscard]] const hsp_view_info &info() const { return records_.info; }
  [[nodiscard]] const std::vector<hsp_view_piece> &pieces() const { return records_.pieces; }
  [[nodiscard]] const std::vector<hsp_view_loop> &loops() const { return records_.loops; }
  [[nodiscard]] const std::vector<hsp_view_arc> &arcs() const { return records_.arcs; }

 private:
  LibraryScene scene_;
  LibraryView view_;
  ViewRecords records_;
  std::vector<uint32_t> colours_;
};

// The common part of drawings: the lattice's step, colours, and a sink that appends to a std::string.
constexpr double drawn_step = 0x1p-10;
std::vector<uint32_t> colours_of(const oracle::Balls &balls);
int32_t append_bytes(void *context, const char *bytes, size_t count);
hsp_picture_options picture_options(uint32_t format, uint32_t style);
