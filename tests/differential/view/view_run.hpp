// Views of the C interface that own their memory, and their pieces as paths.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "library_run.hpp"
#include "owned_views.hpp"
#include "path_painter.hpp"
#include "z_buffer.hpp"

using Direction = std::array<double, 3>;

// The input of hsp_view_compute; directions of zeros mean the defaults.
struct ViewChoice {
  uint32_t pieces = HSP_PIECES_OUTSIDE_FARTHER;
  uint32_t flags = 0;
  bool boundary = false;
  Direction towards{};
  Direction up{};

  [[nodiscard]] hsp_view_options options() const;
  [[nodiscard]] std::string text() const;
};

// G-pieces without and with boundary and H-pieces, each of the balls that may be seen and of all balls.
std::vector<ViewChoice> all_choices(const Direction &towards, const Direction &up = {});

// A model of lattice balls, and its boundary.
class LibraryScene {
 public:
  explicit LibraryScene(const oracle::Balls &balls, double step = 1, double probe = 0);

  [[nodiscard]] const hsp_model *model() const { return boundary_.model(); }
  [[nodiscard]] const hsp_boundary *boundary() const { return boundary_.handle(); }
  // The balls in lengths, probe included.
  [[nodiscard]] const std::vector<oracle::PlainBall> &balls() const { return balls_; }

 private:
  LibraryBoundary boundary_;
  std::vector<oracle::PlainBall> balls_;
};

// All that a view says.
struct ViewRecords {
  hsp_view_info info{};
  std::vector<hsp_view_piece> pieces;
  std::vector<hsp_view_loop> loops;
  std::vector<hsp_view_arc> arcs;

  [[nodiscard]] oracle::ViewAxes axes() const;
  // One path per piece. Throws std::out_of_range if a piece has arcs that are not there.
  [[nodiscard]] std::vector<oracle::Path> paths() const;
};

// The area within a path.
double area_of(const oracle::Path &path);

// A computed view. Calls that fail throw std::runtime_error.
class LibraryView {
 public:
  LibraryView(const LibraryScene &scene, const ViewChoice &choice);

  [[nodiscard]] hsp_view *handle() const { return view_.get(); }
  [[nodiscard]] ViewRecords records() const;

 private:
  support::OwnedView view_;
};

// The records of a view that is computed for them.
ViewRecords view_of(const LibraryScene &scene, const ViewChoice &choice);
