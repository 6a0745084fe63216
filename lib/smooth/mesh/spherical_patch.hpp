// Triangles for the free part of a sphere, from points on what bounds it. The free part may have any number of faces,
// and they any number of loops, or none.
//
// The sphere is triangulated as a whole (sphere_triangulation.hpp): the points on the borders, and points all over it
// that keep away from them. Between the chord of a border and its arc the sphere is to the left of the chord, but not
// free: no point stays there. The borders become edges, and what lies to their left is taken. Which loops belong to one
// face is known beforehand; that the triangles agree is checked, with the number of triangles that Euler's formula
// demands, so that a border sampled too coarsely is noticed and never yields a wrong mesh.
//
// Where borders touch, or run along each other, there are triangles without area between them (pinched_patch.cpp). If
// no number of points tells borders apart, `pinched` lets them make detours through each other's points.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/id_range.hpp"
#include "mesh/mesh_curve.hpp"
#include "mesh/sphere_triangulation.hpp"

namespace hsp {

// A point on the border. The patch lies to the left of the way to the next one.
struct BorderSample {
  Vec3 direction;           // from the sphere's centre, of any length
  uint32_t vertex;          // its number in the mesh
  uint32_t curve;           // that leads to the next one
  uint32_t other_patch[2];  // other patches that have this point too and may join it with any of their points; no_id if
                            // there are fewer, any_patch for a point that many patches may have

  static constexpr uint32_t any_patch = no_id - 1;

  // Whether another patch might have an edge between the two samples, too.
  bool may_be_joined_elsewhere(const BorderSample &other) const {
    for (const uint32_t p : other_patch) {
      if (p == no_id) continue;
      for (const uint32_t q : other.other_patch) {
        if (q != no_id && (p == q || p == any_patch || q == any_patch)) return true;
      }
    }
    return false;
  }
};

enum class PatchState : uint8_t {
  complete,
  too_coarse,  // the curves in question are named
  capacity,
};

class SphericalPatch {
 public:
  void carve(Workspace &workspace, uint32_t points);

  // `spacing`: the distance of points as an angle.
  void begin(double spacing);
  // The patch lies outside the cap: no points inside and none near it.
  void keep_off(const Vec3 &axis, double cosine);
  // Faces are numbered from 0 on; the loops of one follow each other.
  void begin_loop(uint32_t face);
  void add(const BorderSample &sample);
  // Without loops the whole sphere is face 0. pinched: a border that runs along another one may take the same edges of
  // the triangulation.
  PatchState triangulate(bool pinched = false);
  // For a patch without area: triangles from the order of the points alone (patch_from_loops.cpp).
  PatchState triangulate_from_loops();

  // The number of points that were needed, or after PatchState::capacity an upper bound of it.
  uint64_t needed_points() const { return needed_points_; }
  // After PatchState::too_coarse: calls sink(curve) for the curves that want more points.
  template <class Sink>
  void for_each_coarse_curve(Sink sink) const {
    for (uint32_t k = 0; k < samples_.size(); ++k) {
      if (all_coarse_ || links_[k].coarse) sink(samples_[k].curve);
    }
  }

  // New points first: calls new_vertex(direction), which returns its number in the mesh, then triangle(face, corners)
  // for the triangles.
  template <class NewVertex, class NewTriangle>
  void emit(NewVertex new_vertex, NewTriangle triangle);

 private:
  struct Loop {
    uint32_t first;  // sample
    uint32_t face;
  };
  struct Cap {
    Vec3 axis;
    double cosine;
    double inside, near;  // the cosines of what lies well inside and of what lies near
  };
  // Links of a sample.
  struct Link {
    uint32_t next, previous;  // samples; no_id beside borders
    uint32_t point;
    bool coarse;
    bool closed;  // a wedge ends here
    uint32_t face;
    uint32_t closing;  // the sample at the same point at which the border ends that is next, counter-clockwise from the
                       // way to the next sample on; no_id if there is no such way
    uint32_t middle;   // a sample between this one and that, if there has to be one, else no_id
  };
  // A triangle of the patch that is none of the sphere's triangles.
  struct Ear {
    uint32_t face;
    uint32_t sample[3];
  };
  // Data of a triangle of the sphere.
  struct Part {
    uint32_t face = no_id;                       // no_id: not of the patch
    uint32_t corner[3] = {no_id, no_id, no_id};  // samples, and for points inside vertices of the mesh
    uint32_t middle[3] = {no_id, no_id, no_id};  // of edges, where they are divided, else no_id
    // For an edge that a loop runs along with the triangle on its left: the sample where this part of the loop starts;
    // else no_id.
    uint32_t strand[3] = {no_id, no_id, no_id};
  };

  uint32_t end_of_loop(uint32_t loop) const {
    return loop + 1 < loops_.size() ? loops_[loop + 1].first : border_samples_;
  }
  bool is_near_cap(const Vec3 &direction);
  bool is_circle_near_caps(double sine, double cosine) const;
  bool is_covered(const Vec3 &direction) const;
  Vec3 direction_of(uint32_t sample) const { return unit(samples_[sample].direction, upwards); }
  Vec3 direction_between(uint32_t a, uint32_t b) const;
  uint32_t choose_octahedron() const;
  void add_inner_points();
  void insert_points();
  void link_samples();
  void mark_coarse(uint32_t point);
  void mark_longest_borders();
  bool has_coarse_borders() const;
  bool name_triangles();
  // Gives triangle t, which had none, a face to hand on. False if it has another one.
  bool take(uint32_t t, uint32_t none, uint32_t face) {
    if (parts_[t].face != none) return parts_[t].face == face;
    parts_[t].face = face;
    queue_[waiting_++] = t;
    return true;
  }
  bool has_right_numbers();

  // Borders and what lies between them: pinched_patch.cpp, pinched_cells.cpp.
  bool route_strands(bool with_detours);
  bool add_detour(uint32_t sample, uint32_t obstacle);
  bool lay_strands();
  bool find_covered();
  bool has_covered_point() const;
  bool name_faces();
  bool close_wedges();
  bool close_wedge(uint32_t sample, const TriangleEdge &way);
  void add_corridors();
  bool add_necks();
  bool add_faces_without_extent();
  void add_detours();
  bool has_length(uint32_t sample) const { return links_[sample].point != links_[links_[sample].next].point; }
  uint32_t strand_back(const TriangleEdge &way) const;
  bool is_extra(uint32_t sample) const { return sample >= border_samples_; }
  uint32_t add_extra(uint32_t face, const Vec3 &direction);
  uint32_t middle_of(uint32_t a, uint32_t b);
  uint32_t middle_of_wedge(uint32_t sample);
  void add_cell(uint32_t face, const uint32_t *all, uint32_t most);
  template <class Visit>
  void for_each_of_neck(uint32_t sample, Visit visit) const;

  uint32_t ring_beside(uint32_t first_loop, uint32_t last_loop);
  uint32_t nearest_of_loop(uint32_t loop, uint32_t sample) const;
  double square_between(uint32_t a, uint32_t b) const;
  void cut_off_corners(uint32_t ring);

  double spacing_ = 1.0;
  bool all_coarse_ = false;
  bool has_corridors_ = false;
  uint32_t border_samples_ = 0;  // samples behind these belong to no border
  uint32_t linked_samples_ = 0;  // samples behind these are linked to nothing
  uint64_t needed_points_ = 0;
  uint32_t waiting_ = 0;      // in the queue
  uint32_t border_caps_ = 0;  // caps behind these are about corners of the octahedron
  uint32_t latest_cap_ = 0;
  SphereTriangulation sphere_;
  FixedVector<BorderSample> samples_;
  FixedVector<Loop> loops_;
  FixedVector<Cap> caps_;
  FixedVector<Ear> ears_;
  Span<Link> links_;                      // [samples]
  FixedVector<RoundedDirection> inputs_;  // the samples, then points inside
  Span<uint32_t> sample_at_;              // [points] a sample that lies there, or no_id
  Span<Part> parts_;                      // [triangles]
  Span<uint32_t> queue_;                  // [triangles] that wait to hand their face on
  Span<int64_t> balance_;                 // [points] for each face, of Euler's formula
};

template <class NewVertex, class NewTriangle>
void SphericalPatch::emit(NewVertex new_vertex, NewTriangle triangle) {
  for (uint32_t k = border_samples_; k < samples_.size(); ++k) samples_[k].vertex = new_vertex(samples_[k].direction);
  for (uint32_t t = 0; border_samples_ < samples_.size() && t < sphere_.triangle_count(); ++t) {
    for (uint32_t &middle : parts_[t].middle) {
      if (middle != no_id) middle = samples_[middle].vertex;
    }
  }
  // Points inside: a point has one number, whichever triangle names it first.
  Span<uint32_t> vertex_at = queue_;
  for (uint32_t p = 0; p < sphere_.point_count(); ++p) vertex_at[p] = no_id;
  for (uint32_t t = 0; t < sphere_.triangle_count(); ++t) {
    Part &part = parts_[t];
    if (part.face == no_id) continue;
    for (uint32_t c = 0; c < 3; ++c) {
      const uint32_t p = sphere_.triangle(t).point[c];
      if (sample_at_[p] != no_id) continue;
      if (vertex_at[p] == no_id) vertex_at[p] = new_vertex(to_double(sphere_.point(p)));
      part.corner[c] = vertex_at[p];
    }
  }
  // Edges across the patch between points that another patch may join, too, are divided.
  for (uint32_t t = 0; t < sphere_.triangle_count(); ++t) {
    const SphereTriangle &own = sphere_.triangle(t);
    if (parts_[t].face == no_id) continue;
    for (uint32_t e = 0; e < 3; ++e) {
      const uint32_t u = own.neighbour[e];
      if (own.fixed[e] || u < t) continue;
      const uint32_t p = own.point[next_corner(e)];
      const uint32_t q = own.point[previous_corner(e)];
      if (sample_at_[p] == no_id || sample_at_[q] == no_id) continue;
      const uint32_t one = parts_[t].corner[next_corner(e)];
      const uint32_t other = parts_[t].corner[previous_corner(e)];
      if (!samples_[one].may_be_joined_elsewhere(samples_[other])) continue;
      const uint32_t middle = new_vertex(direction_between(one, other));
      parts_[t].middle[e] = middle;
      parts_[u].middle[sphere_.triangle(u).edge_towards(t)] = middle;
    }
  }
  for (uint32_t k = 0; k < ears_.size(); ++k) {
    const Ear &ear = ears_[k];
    const uint32_t corners[3] = {samples_[ear.sample[0]].vertex, samples_[ear.sample[1]].vertex,
                                 samples_[ear.sample[2]].vertex};
    triangle(ear.face, corners);
  }
  for (uint32_t t = 0; t < sphere_.triangle_count(); ++t) {
    const Part &part = parts_[t];
    if (part.face == no_id) continue;
    // The corners that are left after every divided edge has cut one off.
    uint32_t rest[3];
    for (uint32_t c = 0; c < 3; ++c) {
      const bool on_border = sample_at_[sphere_.triangle(t).point[c]] != no_id;
      rest[c] = on_border ? samples_[part.corner[c]].vertex : part.corner[c];
    }
    const bool all = part.middle[0] != no_id && part.middle[1] != no_id && part.middle[2] != no_id;
    if (all) {
      for (uint32_t c = 0; c < 3; ++c) {
        const uint32_t corner[3] = {rest[c], part.middle[previous_corner(c)], part.middle[next_corner(c)]};
        triangle(part.face, corner);
      }
      triangle(part.face, part.middle);
      continue;
    }
    // With one or two of them: the divided edge cuts off its first end, beside the corner opposite, in a turn that
    // comes to the undivided edge last.
    uint32_t first = 0;
    while (first < 3 && !(part.middle[first] != no_id && part.middle[previous_corner(first)] == no_id)) ++first;
    for (uint32_t turn = 0; first < 3 && turn < 2; ++turn) {
      const uint32_t e = turn == 0 ? first : next_corner(first);
      if (part.middle[e] == no_id) break;
      const uint32_t cut[3] = {rest[e], rest[next_corner(e)], part.middle[e]};
      triangle(part.face, cut);
      rest[next_corner(e)] = part.middle[e];
    }
    triangle(part.face, rest);
  }
}

}  // namespace hsp
