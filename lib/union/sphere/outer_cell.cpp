// The polyhedron around what caps leave, cut by one plane after the other.
//
// As an example the cube at first: 6 planes and 8 vertices, each with three planes. A plane that cuts off one vertex
// brings three new ones, on the three edges of that vertex: 7 planes, 10 vertices. With f faces there are 2 f - 4
// vertices, by Euler's relation, as each vertex has three edges.
#include "sphere/outer_cell.hpp"

#include "lanes/floating_point.hpp"

namespace hsp {
namespace {

// Three planes meet in a point that is known well enough if the determinant of their unit normals is larger than this.
constexpr double least_determinant = 0x1p-24;
// A polyhedron whose vertices have a smaller squared distance from the centre lies inside the sphere.
constexpr double certainly_inside = 1.0 - 0x1p-16;

double minor(double a, double d, double c, double e) {
  return a * d - c * e;
}

double squared_length(double x, double y, double z) {
  return x * x + y * y + z * z;
}

}  // namespace

// The point of three planes becomes vertex v. False if it is not certain enough.
bool OuterCell::place_vertex(uint32_t v, uint32_t p, uint32_t q, uint32_t r) {
  const double qr_x = minor(uy[q], uz[r], uz[q], uy[r]);
  const double qr_y = minor(uz[q], ux[r], ux[q], uz[r]);
  const double qr_z = minor(ux[q], uy[r], uy[q], ux[r]);
  const double determinant = ux[p] * qr_x + uy[p] * qr_y + uz[p] * qr_z;
  if (!(determinant > least_determinant)) return false;
  const double inverse = 1.0 / determinant;
  const double rp_x = minor(uy[r], uz[p], uz[r], uy[p]);
  const double rp_y = minor(uz[r], ux[p], ux[r], uz[p]);
  const double rp_z = minor(ux[r], uy[p], uy[r], ux[p]);
  const double pq_x = minor(uy[p], uz[q], uz[p], uy[q]);
  const double pq_y = minor(uz[p], ux[q], ux[p], uz[q]);
  const double pq_z = minor(ux[p], uy[q], uy[p], ux[q]);
  x[v] = (b[p] * qr_x + b[q] * rp_x + b[r] * pq_x) * inverse;
  y[v] = (b[p] * qr_y + b[q] * rp_y + b[r] * pq_y) * inverse;
  z[v] = (b[p] * qr_z + b[q] * rp_z + b[r] * pq_z) * inverse;
  error[v] = unit_roundoff * (256.0 * inverse + 64.0);
  face[v][0] = static_cast<uint8_t>(p);
  face[v][1] = static_cast<uint8_t>(q);
  face[v][2] = static_cast<uint8_t>(r);
  return squared_length(x[v], y[v], z[v]) < 4.0;
}

void OuterCell::start(const CellBox &box) {
  constexpr uint32_t sides = 6;
  const double centre[3] = {box.x, box.y, box.z};
  for (uint32_t f = 0; f < sides; ++f) {
    const double sign = f < 3 ? 1.0 : -1.0;
    ux[f] = f % 3 == 0 ? sign : 0.0;
    uy[f] = f % 3 == 1 ? sign : 0.0;
    uz[f] = f % 3 == 2 ? sign : 0.0;
    b[f] = box.half + sign * centre[f % 3];
    cap[f] = no_id;
  }
  faces = (1U << sides) - 1;
  for (vertices = 0; vertices < 8; ++vertices) {
    const uint32_t p = (vertices & 1U) != 0 ? 3 : 0, q = (vertices & 2U) != 0 ? 4 : 1, r = (vertices & 4U) != 0 ? 5 : 2;
    const bool mirrored = ((vertices ^ vertices >> 1 ^ vertices >> 2) & 1U) != 0;
    place_vertex(vertices, p, mirrored ? r : q, mirrored ? q : r);
  }
}

OuterCell::Cut OuterCell::cut(Target target, const Plane &plane) {
  const VertexSides sides = sides_of_vertices(target, *this, plane);
  return (sides.unsure[0] | sides.unsure[1]) != 0 ? Cut::unsure : cut(plane, sides.outside);
}

OuterCell::Cut OuterCell::cut(const Plane &plane, const uint64_t (&outside)[2]) {
  const uint32_t old = vertices;
  const uint32_t off = static_cast<uint32_t>(__builtin_popcountll(outside[0]) + __builtin_popcountll(outside[1]));
  if (off == 0) return Cut::misses;
  if (off == old) return Cut::buries;
  if (faces == ~uint64_t{0}) return Cut::full;
  const uint32_t face_of_cap = static_cast<uint32_t>(__builtin_ctzll(~faces));
  ux[face_of_cap] = plane.ux;
  uy[face_of_cap] = plane.uy;
  uz[face_of_cap] = plane.uz;
  b[face_of_cap] = plane.b;
  cap[face_of_cap] = plane.cap;

  // The directed edges of the vertices that are cut off. An edge whose opposite is not among them is cut by the plane,
  // which gives a new vertex.
  uint64_t edges[most_faces];
  for (uint64_t left = faces; left != 0; left &= left - 1) edges[__builtin_ctzll(left)] = 0;
  const auto visit_edges = [&](auto visit) {
    for (uint32_t word = 0; word < 2; ++word) {
      for (uint64_t left = outside[word]; left != 0; left &= left - 1) {
        const uint8_t *const of = face[64 * word + static_cast<uint32_t>(__builtin_ctzll(left))];
        if (!visit(of[0], of[1]) || !visit(of[1], of[2]) || !visit(of[2], of[0])) return false;
      }
    }
    return true;
  };
  visit_edges([&](uint32_t p, uint32_t q) {
    edges[p] |= uint64_t{1} << q;
    return true;
  });
  // New vertices stand behind the old ones until all are certain.
  uint32_t end = old;
  bool has_room = true;
  const bool certain = visit_edges([&](uint32_t p, uint32_t q) {
    if ((edges[q] >> p & 1U) != 0) return true;
    has_room = end < most_vertices;
    return has_room && place_vertex(end++, p, q, face_of_cap);
  });
  if (!has_room) return Cut::full;
  if (!certain) return Cut::refused;

  vertices = 0;
  faces = 0;
  for (uint32_t v = 0; v < end; ++v) {
    if (v < old && (outside[v / 64] >> v % 64 & 1U) != 0) continue;
    const uint32_t to = vertices++;
    x[to] = x[v];
    y[to] = y[v];
    z[to] = z[v];
    error[to] = error[v];
    for (uint32_t k = 0; k < 3; ++k) {
      face[to][k] = face[v][k];
      faces |= uint64_t{1} << face[to][k];
    }
  }
  return Cut::cuts;
}

bool OuterCell::lies_inside_sphere() const {
  double most = 0.0;
  for (uint32_t v = 0; v < vertices; ++v) {
    const double squared = squared_length(x[v], y[v], z[v]);
    most = squared > most ? squared : most;
  }
  return most < certainly_inside;
}

// exact/PROOFS.md, section 7, has these numbers and the proof.
OuterCell::Taken OuterCell::part_taken(const Plane &plane) const {
  constexpr double missed = -0x1p-16, touched = 0x1p-32, near_squared = 0x1p-24, off_the_sphere = 0x1p-8;
  double px = 2.0, py = 0.0, pz = 0.0;
  bool is_first = true;
  for (uint32_t v = 0; v < vertices; ++v) {
    const double depth = plane.ux * x[v] + plane.uy * y[v] + plane.uz * z[v] - plane.b + error[v];
    if (depth < missed) continue;
    if (!(depth < touched)) return Taken::more;
    if (is_first) {
      px = x[v];
      py = y[v];
      pz = z[v];
      is_first = false;
    }
    if (squared_length(x[v] - px, y[v] - py, z[v] - pz) > near_squared) return Taken::more;
  }
  const double squared = squared_length(px, py, pz);
  return squared < 1.0 - off_the_sphere   ? Taken::point_inside_sphere
         : squared > 1.0 + off_the_sphere ? Taken::point_outside_sphere
                                          : Taken::more;
}

}  // namespace hsp
