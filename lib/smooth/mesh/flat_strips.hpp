// Triangles for patches without area (surface/flat_patches.hpp): strips between two borders in one plane, one above the
// other, which no points on a sphere tell apart. Both borders lead from one end of the strip to the other; a ladder of
// triangles leads from points of one to points of the other, in the order of their directions in the plane. Every rung
// has a point of its own in its middle, so that no edge is there twice.
#pragma once

#include "core/elementary.hpp"
#include "mesh/spherical_patch.hpp"

namespace hsp {

class FlatStrips {
 public:
  // The normal of the plane; loops of the patch run around it as their samples' directions do.
  FlatStrips(const SphericalPatch &patch, const Vec3 &normal);

  // Whether all faces are such strips, or rings with a loop on either side.
  bool are_strips() const;

  // Calls new_vertex(direction), which returns its number in the mesh, and triangle(face, corners).
  template <class NewVertex, class NewTriangle>
  void emit(NewVertex new_vertex, NewTriangle triangle) const {
    for (uint32_t loop = 0; loop < patch_.loop_count();) {
      const bool ring = has_second_loop(loop);
      Border forwards = forwards_of(loop);
      Border backwards = ring ? ring_behind(loop, forwards) : backwards_of(loop);
      const uint32_t face = patch_.face_of_loop(loop);
      // A strip begins and ends where both borders meet; a ring with the same rung.
      uint32_t rung = ring ? new_vertex(middle(forwards, backwards)) : no_id;
      const uint32_t first_rung = rung;
      while (forwards.left > 0 || backwards.left > 0) {
        const bool advance =
            backwards.left == 0 || (forwards.left > 0 && next_angle(forwards) <= next_angle(backwards));
        const uint32_t a = forwards.sample;
        const uint32_t b = backwards.sample;
        step(advance ? forwards : backwards);
        const uint32_t c = advance ? forwards.sample : backwards.sample;
        const bool last = forwards.left == 0 && backwards.left == 0;
        const uint32_t next_rung = last ? first_rung : new_vertex(middle(forwards, backwards));
        // Around it: a, what comes next on its border or the rung to that, then b.
        uint32_t corner[5];
        uint32_t corners = 0;
        const auto add = [&](uint32_t v) {
          if (v != no_id && (corners == 0 || corner[corners - 1] != v)) corner[corners++] = v;
        };
        if (rung != no_id) add(rung);
        add(vertex_of(a));
        if (advance) add(vertex_of(c));
        if (next_rung != no_id && !(last && !ring)) add(next_rung);
        if (!advance) add(vertex_of(c));
        if (corners > 0 && vertex_of(b) != corner[0]) add(vertex_of(b));
        for (uint32_t k = 2; k < corners; ++k) {
          const uint32_t three[3] = {corner[0], corner[k - 1], corner[k]};
          triangle(face, three);
        }
        rung = next_rung;
      }
      loop += ring ? 2 : 1;
    }
  }

 private:
  // A way along a loop.
  struct Border {
    uint32_t loop;
    uint32_t sample;  // where it is
    uint32_t left;    // steps to go
    double angle;     // of the direction there, counted on
    bool backwards;
  };
  bool has_second_loop(uint32_t loop) const {
    return loop + 1 < patch_.loop_count() && patch_.face_of_loop(loop + 1) == patch_.face_of_loop(loop);
  }
  uint32_t vertex_of(uint32_t sample) const { return patch_.sample(sample).vertex; }
  uint32_t beside(const Border &border) const;
  double turn(uint32_t from, uint32_t to) const;
  double next_angle(const Border &border) const { return border.angle + turn(border.sample, beside(border)); }
  void step(Border &border) const;
  Border forwards_of(uint32_t loop) const;
  Border backwards_of(uint32_t loop) const;
  Border ring_behind(uint32_t loop, const Border &forwards) const;
  bool is_monotone(Border border) const;
  void find_ends(uint32_t loop, uint32_t &first, uint32_t &last) const;
  Vec3 middle(const Border &one, const Border &other) const;
  Vec3 direction(uint32_t sample) const;

  const SphericalPatch &patch_;
  Vec3 normal_;
};

}  // namespace hsp
