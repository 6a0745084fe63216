// Views of balls and sticks, and their pictures against a z-buffer of balls and cylinders (tests/oracle/z_buffer.hpp
// and seen_cylinders.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "built_grid.hpp"
#include "lattice_ball.hpp"
#include "maps/stick_view_builder.hpp"
#include "seen_cylinders.hpp"

class BuiltSticks {
 public:
  using Ends = std::array<uint32_t, 2>;

  // Lattice step 1. Limits grow until they suffice, twelve times at most. as_map: make a map even if there is a
  // painting order. strands: stick k has strands[k modulo their number]; without any, each stick is one strand.
  BuiltSticks(const oracle::Balls &balls, std::vector<Ends> ends, double radius,
              const std::array<double, 3> &towards = {0, 0, 1}, bool whole = false, bool as_map = false,
              std::vector<hsp::StickStrands> strands = {});

  void look(const std::array<double, 3> &towards);
  void take(const hsp::StickLimits &limits) { memory_.carve(builder_, limits); }
  hsp::Status build(const std::array<double, 3> &towards);

  hsp::Status status() const { return status_; }
  const hsp::StickView &view() const { return builder_.structure(); }
  const hsp::StickViewBuilder &builder() const { return builder_; }
  const hsp::BallSet &balls() const { return grid_.grid().balls(); }
  const std::vector<Ends> &ends() const { return ends_; }
  double radius() const { return radius_; }
  bool whole() const { return whole_; }
  hsp::StickStrands strands_of(size_t k) const {
    return strands_.empty() ? hsp::StickStrands::one : strands_[k % strands_.size()];
  }
  // The conflict and its numbers as text.
  std::string violation() const;

 private:
  BuiltGrid grid_;
  CarvedMemory memory_;
  hsp::StickViewBuilder builder_;
  std::vector<Ends> ends_;
  double radius_;
  bool whole_;
  bool as_map_;
  std::vector<hsp::StickStrands> strands_;
  hsp::Status status_ = hsp::Status::ok;
};

// Bonds between atoms that are closer than .6 times the sum of their van der Waals radii; the balls of the picture have
// a part of these radii.
struct StickModel {
  oracle::Balls balls;
  std::vector<BuiltSticks::Ends> ends;
};
StickModel sticks_between_close(oracle::Balls atoms, double part);

// The scene of a z-buffer, in view coordinates: balls by the caller's numbers, then two names for each stick,
// that of its first ball first.
struct PlainSticks {
  std::vector<oracle::PlainBall> balls;
  std::vector<oracle::PlainCylinder> cylinders;
  double largest = 0;  // radius of a ball

  explicit PlainSticks(const BuiltSticks &built);
  [[nodiscard]] std::vector<oracle::SeenPixel> image(const oracle::PixelGrid &grid) const;
};
// The name of a ball of grid order or of a part of a stick.
uint32_t plain_name(const BuiltSticks &built, uint32_t ball, uint32_t stick);

// Empty, or the differences between the painted picture, the z-buffer of balls and cylinders, and the map's answers.
std::string sticks_disagree(const BuiltSticks &built, size_t pixels);
