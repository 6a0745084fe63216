// A few balls with the solvent-excluded surface over their boundary, in memory of fixed size. Lengths are lattice
// steps, of 1e-8 for scenes like molecules.
#pragma once

#include "small_union.hpp"
#include "surface/surface_areas.hpp"
#include "surface/surface_builder.hpp"

namespace cases {

struct SurfaceScene {
  uint32_t n;
  SmallBall ball[8];
  int32_t probe;
};
constexpr SurfaceScene with_probe(SurfaceScene scene, int32_t probe) {
  scene.probe = probe;
  return scene;
}
inline constexpr int32_t usual_probe = 140000000;
inline constexpr int32_t carbon = 170000000;

// Three balls whose probes see each other through the throat between them.
constexpr SurfaceScene three_throat = {
    3,
    {{290000000, 0, 0, carbon}, {-145000000, 251147367, 0, carbon}, {-145000000, -251147367, 0, carbon}},
    usual_probe};
constexpr SurfaceScene three_almost = {
    3,
    {{309000000, 0, 0, carbon}, {-154500000, 267601850, 0, carbon}, {-154500000, -267601850, 0, carbon}},
    usual_probe};
// Three balls that the boundary joins, and that cusps of the surface separate.
constexpr SurfaceScene three_open = {
    3,
    {{320000000, 0, 0, carbon}, {-160000000, 277128129, 0, carbon}, {-160000000, -277128129, 0, carbon}},
    usual_probe};
// Four balls around a void, where probes inside and outside overlap.
constexpr SurfaceScene void_in_tetrahedron = {4,
                                              {{179555934, 179555934, 179555934, carbon},
                                               {179555934, -179555934, -179555934, carbon},
                                               {-179555934, 179555934, -179555934, carbon},
                                               {-179555934, -179555934, 179555934, carbon}},
                                              usual_probe};
// Eight spheres through one point, where the outside shrinks to it.
constexpr SurfaceScene eight_through_a_point = {8,
                                                {{-80000000, -160000000, -160000000, 100000000},
                                                 {-80000000, -160000000, 160000000, 100000000},
                                                 {-80000000, 160000000, -160000000, 100000000},
                                                 {-80000000, 160000000, 160000000, 100000000},
                                                 {80000000, -160000000, -160000000, 100000000},
                                                 {80000000, -160000000, 160000000, 100000000},
                                                 {80000000, 160000000, -160000000, 100000000},
                                                 {80000000, 160000000, 160000000, 100000000}},
                                                usual_probe};
// Four balls of a square whose spheres meet in a point of its axis.
constexpr SurfaceScene four_through_a_point = {
    4,
    {{210000000, 0, 0, carbon}, {0, 210000000, 0, carbon}, {-210000000, 0, 0, carbon}, {0, -210000000, 0, carbon}},
    usual_probe};

class SmallSurface {
 public:
  static constexpr hsp::SurfaceLimits most = {60, 40, 30, 60, 400, 30};

  bool build(const SurfaceScene &scene, const hsp::SurfaceLimits &limits = most) {
    if (!carve(scene, limits)) return false;
    status_ = builder_.build(small_union().balls(), small_union().boundary());
    return status_ == hsp::Status::ok;
  }
  // Builds the surface over some shells of the boundary alone.
  bool build_of(const SurfaceScene &scene, const uint32_t *shells, uint32_t count) {
    if (!carve(scene, most)) return false;
    const hsp::Span<const uint32_t> chosen(shells, count);
    status_ = builder_.build(small_union().balls(), small_union().boundary(), hsp::Patience(), &chosen);
    return status_ == hsp::Status::ok;
  }

  hsp::Status status() const { return status_; }
  const hsp::SurfaceBuilder &builder() const { return builder_; }
  hsp::SurfaceMeasure of_ball(uint32_t input) const {
    return hsp::measure_surface_of_ball(small_union().balls(), small_union().boundary(), builder_.surface(),
                                        small_union().grid().grid_index(input));
  }
  hsp::SurfaceMeasure total() const {
    return hsp::measure_surface(small_union().grid(), small_union().boundary(), builder_.surface(),
                                [](uint32_t, const hsp::SurfaceMeasure &) {});
  }

 private:
  bool carve(const SurfaceScene &scene, const hsp::SurfaceLimits &limits) {
    if (!small_union().build(scene.ball, scene.n, scene.probe)) return false;
    hsp::Workspace measured;
    builder_.carve(measured, limits);
    if (measured.bytes() > sizeof memory_) return false;
    hsp::Workspace workspace(memory_, sizeof memory_);
    builder_.carve(workspace, limits);
    return true;
  }

  hsp::SurfaceBuilder builder_;
  hsp::Status status_ = hsp::Status::state;
  alignas(64) unsigned char memory_[72 * 1024];
};

inline SmallSurface &small_surface() {
  static SmallSurface one;
  return one;
}

}  // namespace cases
