// Normals at a vertex, and how it moves with each of its balls.
#pragma once

#include "core/elementary.hpp"
#include "measure/boundary_positions.hpp"
#include "small_surface.hpp"
#include "surface/vertex_contacts.hpp"

namespace cases {

// Seen from each of its three balls the vertex is where it is, moves by 1 along the own normal, and stays on the two
// other spheres.
inline uint32_t a_vertex_stays_on_its_spheres() {
  const SurfaceScene *const scenes[] = {&three_throat, &void_in_tetrahedron};
  return first_failing(scenes, [](const SurfaceScene *scene) {
    if (!small_surface().build(*scene)) return false;
    const hsp::BallSet &balls = small_union().balls();
    const hsp::Boundary &boundary = small_union().boundary();
    for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
      const hsp::Position position = hsp::position_of_vertex(balls, boundary, v);
      for (const uint32_t own : boundary.vertex(v).ball) {
        const hsp::Vec3 offset = balls.difference(own, position.ball) + position.offset;
        const hsp::VertexContacts contacts(balls, boundary, v, own, offset);
        if (contacts.ball[0] != own) return false;
        for (uint32_t k = 0; k < 3; ++k) {
          const hsp::Vec3 &n = contacts.normal[k];
          if (!near(dot(n, n), 1.0, 1e-12) || !near(dot(n, contacts.share), k == 0 ? 1.0 : 0.0, 1e-12)) return false;
        }
        const hsp::Vec3 across = cross(contacts.normal[1], contacts.normal[2]);
        if (dot(contacts.normal[0], across) * contacts.sign <= 0.0) return false;
      }
    }
    return boundary.vertex_count() > 0;
  });
}

inline constexpr Check surface_vertex_contacts[] = {{"a_vertex_stays_on_its_spheres", a_vertex_stays_on_its_spheres}};

}  // namespace cases
