// The probes that cut concave patches: octants, whose sides are known, and which vertices count.
#pragma once

#include "measure/areas.hpp"
#include "small_surface.hpp"
#include "surface/probe_caps.hpp"

namespace cases {

struct ProbeScene {
  alignas(64) unsigned char memory[24 * 1024];
  hsp::ProbeGrid grid;
  hsp::ProbeCaps probe;
  hsp::ChosenFaces chosen;

  bool build(const SurfaceScene &scene, uint32_t neighbours = 30) {
    if (!small_union().build(scene.ball, scene.n, scene.probe)) return false;
    const uint32_t vertices = small_union().boundary().vertex_count();
    hsp::Workspace measured;
    grid.carve(measured, vertices);
    probe.carve(measured, neighbours);
    if (measured.bytes() > sizeof memory) return false;
    hsp::Workspace workspace(memory, sizeof memory);
    grid.carve(workspace, vertices);
    probe.carve(workspace, neighbours);
    hsp::Patience endless;
    grid.build(small_union().balls(), small_union().boundary(), endless);
    return true;
  }
  bool gather(uint32_t vertex) {
    return probe.gather(small_union().balls(), small_union().boundary(), chosen, grid, vertex);
  }
};
inline ProbeScene &probe_scene() {
  static ProbeScene one;
  return one;
}

// Spheres of radius 3000 about points at that distance on the axes: the directions of both vertices, the origin and
// 2000 (1, 1, 1), are orthogonal.
constexpr SurfaceScene octant_balls = {3, {{3000, 0, 0, 2000}, {0, 3000, 0, 2000}, {0, 0, 3000, 2000}}, 1000};

inline uint32_t whole_triangles() {
  ProbeScene &scene = probe_scene();
  if (!scene.build(octant_balls) || small_union().boundary().vertex_count() != 2) return 0;
  for (uint32_t v = 0; v < 2; ++v) {
    if (scene.gather(v) || scene.probe.is_doubtful() || scene.probe.met() != 0) return 1 + v;
  }
  return all_hold;
}

// The other vertex is at a distance of 2000 sqrt(3) = 3464.1.
inline uint32_t probes_that_overlap() {
  struct Overlap {
    int32_t probe;
    bool crossed;
  };
  constexpr Overlap overlaps[] = {{1732, false}, {1733, true}};
  return first_failing(overlaps, [](const Overlap &c) {
    SurfaceScene scene = octant_balls;
    for (SmallBall &ball : scene.ball) ball.r = 3000 - c.probe;
    scene.probe = c.probe;
    if (!probe_scene().build(scene)) return false;
    for (uint32_t v = 0; v < 2; ++v) {
      if (probe_scene().gather(v) != c.crossed) return false;
      if (!c.crossed) continue;
      const hsp::Caps &caps = probe_scene().probe.caps();
      if (caps.count != 4 || caps.ball[3] != 1 - v || !near(caps.b[3], 3464.1016151377545 / (2 * c.probe), 1e-14)) {
        return false;
      }
      // The sides face away from the three directions, the fourth cap faces the other vertex.
      const hsp::ProbeCaps &probe = probe_scene().probe;
      const hsp::Vec3 middle = probe.corner(0) + probe.corner(1) + probe.corner(2);
      for (uint32_t k = 0; k < 4; ++k) {
        if ((dot(caps.axis(k), middle) < 0) != (k < 3)) return false;
      }
      if (!(probe_scene().probe.amplification() >= 1)) return false;
    }
    return true;
  });
}

// A small circle with two free arcs: each of its four vertices meets three others, of which the one across the gap
// counts. The covering balls are apart, so that no two vertices share but this circle or two of it.
constexpr SurfaceScene two_arcs = {4, {{0, 0, 0, 200}, {800, 0, 0, 200}, {400, 300, 0, 40}, {400, -300, 0, 40}}, 300};

inline uint32_t one_of_a_circle_counts() {
  ProbeScene &scene = probe_scene();
  if (!scene.build(two_arcs)) return 0;
  const hsp::Boundary &boundary = small_union().boundary();
  if (boundary.vertex_count() != 4) return 1;
  for (uint32_t v = 0; v < 4; ++v) {
    const bool crossed = scene.gather(v);
    if (scene.probe.is_doubtful()) return 2;
    const hsp::Caps &caps = scene.probe.caps();
    // The vertex across the gap has the same three balls.
    for (uint32_t k = 3; crossed && k < caps.count; ++k) {
      for (int t = 0; t < 3; ++t) {
        if (boundary.vertex(caps.ball[k]).ball[t] != boundary.vertex(v).ball[t]) return 3;
      }
    }
    if (scene.probe.met() > 1) return 4;
  }
  return all_hold;
}

// A ball that touches the circle of two others: its two vertices are one point, the gap between them is closed. And one
// of four, of which two do: those on the circle's other arc as well.
inline uint32_t closed_gaps_are_doubtful() {
  const SurfaceScene scenes[] = {{3, {{0, 0, 0, 400}, {800, 0, 0, 400}, {400, 400, 0, 0}}, 100},
                                 {4, {{0, 0, 0, 400}, {800, 0, 0, 400}, {400, 400, 0, 0}, {400, -400, 0, 0}}, 100}};
  return first_failing(scenes, [](const SurfaceScene &scene) {
    if (!probe_scene().build(scene)) return false;
    for (uint32_t v = 0; v < small_union().boundary().vertex_count(); ++v) {
      probe_scene().gather(v);
      if (!probe_scene().probe.is_doubtful()) return false;
    }
    return true;
  });
}

// Four spheres through one point: its two vertices there do not cut each other.
inline uint32_t coincident_vertices_do_not_cut() {
  if (!probe_scene().build(four_through_a_point)) return 0;
  const uint32_t vertices = small_union().boundary().vertex_count();
  for (uint32_t v = 0; v < vertices; ++v) {
    if (probe_scene().gather(v) || probe_scene().probe.is_doubtful()) return 1 + v;
  }
  return vertices == 4 ? all_hold : 0;
}

inline uint32_t overflow_tells_what_suffices() {
  if (!probe_scene().build(three_throat, 0)) return 0;
  const bool crossed = probe_scene().gather(0);
  return crossed && probe_scene().probe.overflowed() && probe_scene().probe.met() == 1 ? all_hold : 1;
}

inline constexpr Check surface_probe_caps[] = {{"whole_triangles", whole_triangles},
                                               {"probes_that_overlap", probes_that_overlap},
                                               {"one_of_a_circle_counts", one_of_a_circle_counts},
                                               {"closed_gaps_are_doubtful", closed_gaps_are_doubtful},
                                               {"coincident_vertices_do_not_cut", coincident_vertices_do_not_cut},
                                               {"overflow_tells_what_suffices", overflow_tells_what_suffices}};

}  // namespace cases
