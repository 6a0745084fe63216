#include "hsp_mesh.hpp"

#include "compute_from.hpp"

using namespace hsp::capi;

namespace {

int32_t check_edge(double edge_length) {
  if (!hsp::is_finite(edge_length)) return HSP_E_NOT_FINITE;
  return edge_length > 0.0 ? HSP_OK : HSP_E_ARGUMENT;
}

const hsp_boundary &boundary_of(const hsp_boundary &boundary) {
  return boundary;
}
const hsp_boundary &boundary_of(const hsp_surface &surface) {
  return *surface.boundary;
}
hsp::MeshedSurface meshed(const hsp_boundary &boundary) {
  return {boundary.balls(), boundary.structure()};
}
hsp::MeshedSurface meshed(const hsp_surface &surface) {
  return {surface.boundary->balls(), surface.boundary->structure(), &surface.structure()};
}

// Limits that suffice for the mesh of a boundary or a surface.
template <class Source>
int32_t init_limits(hsp_mesh_limits *limits, uint32_t struct_size, const Source *source, double edge_length) {
  LibraryArithmetic arithmetic(edge_length);
  if (const int32_t status = first_failure(check_handle(source), check_struct(limits, struct_size)); status != HSP_OK)
    return status;
  const int32_t edge_status = check_edge(edge_length);
  if (edge_status == HSP_E_ARGUMENT) return edge_status;
  if (!source->has_results()) return HSP_E_STATE;
  if (edge_status != HSP_OK) return edge_status;
  hsp::MeshLimits enough;
  const hsp::MeshedSurface from = meshed(*source);
  const hsp::Status status = hsp::expected_mesh_limits(from, from.balls.lattice.steps(edge_length), enough);
  if (status == hsp::Status::ok) hsp_mesh::Limits::write(enough, limits, struct_size);
  return hsp::capi::to_c(status);
}

template <class Source>
int32_t compute(hsp_mesh *mesh, const Source *source, double edge_length, const hsp_mesh_request *request,
                hsp_mesh_limits *limits) {
  LibraryArithmetic arithmetic(edge_length);
  const int32_t edge = check_edge(edge_length);
  const auto check = [edge](const hsp_mesh_request &) { return edge == HSP_E_ARGUMENT ? edge : HSP_OK; };
  return compute_from(
      arithmetic, mesh, source, request, limits, check, [&](const hsp_mesh_request &, Executor &executor) {
        if (edge != HSP_OK) return hsp::Status::not_finite;
        const hsp::MeshedSurface from = meshed(*source);
        mesh->boundary.set(&boundary_of(*source));
        return mesh->builder.build(from, from.balls.lattice.steps(edge_length), hsp::Patience(&executor));
      });
}

hsp::Vec3 corner_of(const hsp::Mesh &mesh, const hsp::MeshTriangle &triangle, uint32_t k) {
  const double *const xyz = mesh.vertex(triangle.vertex[k]).position;
  return {xyz[0], xyz[1], xyz[2]};
}

// Areas of lengths below 1e-70 or above 1e70 may have squares that are no normal doubles: they are scaled by a power of
// two first, which changes no bits of others.
double third_of_area(const hsp::Mesh &mesh, const hsp::MeshTriangle &triangle) {
  const hsp::Vec3 first = corner_of(mesh, triangle, 0);
  const hsp::Vec3 twice = cross(corner_of(mesh, triangle, 1) - first, corner_of(mesh, triangle, 2) - first);
  const double square = dot(twice, twice);
  const double scale = square < 0x1p-900 ? 0x1p400 : square > 0x1p900 ? 0x1p-400 : 1.0;
  const hsp::Vec3 scaled = scale * twice;
  return std::sqrt(dot(scaled, scaled)) / scale / 6;
}

// Gives each vertex share(t) of each triangle t around it.
template <class Share>
void share_out(const hsp::Mesh &mesh, double *shares, Share share) {
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v) shares[v] = 0.0;
  for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    const double of_each = share(t);
    for (const uint32_t v : mesh.triangle(t).vertex) shares[v] += of_each;
  }
}

void share_areas(const hsp::Mesh &mesh, double *areas) {
  share_out(mesh, areas, [&](uint32_t t) { return third_of_area(mesh, mesh.triangle(t)); });
}

// The same, but the triangles of a patch share the patch's given area in proportion to their own areas; equally, if
// they have none.
void share_areas_of_patches(const hsp::Mesh &mesh, const double *area, double *weights) {
  hsp::IdRange own{0, 0};
  double factor = 0.0;
  bool flat = false;
  share_out(mesh, weights, [&](uint32_t t) {
    if (t == own.last) {
      const uint32_t patch = mesh.triangle(t).patch;
      own = mesh.triangles_of(patch);
      double thirds = 0.0;
      for (uint32_t k = own.first; k < own.last; ++k) thirds += third_of_area(mesh, mesh.triangle(k));
      flat = thirds == 0.0;
      factor = area[patch] / 3 / (flat ? own.size() : thirds);
    }
    return flat ? factor : factor * third_of_area(mesh, mesh.triangle(t));
  });
}

}  // namespace

int32_t hsp_mesh_limits_init(hsp_mesh_limits *limits, uint32_t struct_size, const hsp_boundary *boundary,
                             double edge_length) {
  return init_limits(limits, struct_size, boundary, edge_length);
}

int32_t hsp_mesh_limits_init_surface(hsp_mesh_limits *limits, uint32_t struct_size, const hsp_surface *surface,
                                     double edge_length) {
  return init_limits(limits, struct_size, surface, edge_length);
}

HSP_HANDLE_MEMORY(hsp_mesh);

int32_t hsp_mesh_compute(hsp_mesh *mesh, const hsp_boundary *boundary, double edge_length, hsp_mesh_limits *limits) {
  return compute(mesh, boundary, edge_length, nullptr, limits);
}

int32_t hsp_mesh_compute_with(hsp_mesh *mesh, const hsp_boundary *boundary, double edge_length,
                              const hsp_mesh_request *request, hsp_mesh_limits *limits) {
  return compute(mesh, boundary, edge_length, request, limits);
}

int32_t hsp_mesh_compute_surface(hsp_mesh *mesh, const hsp_surface *surface, double edge_length,
                                 hsp_mesh_limits *limits) {
  return compute(mesh, surface, edge_length, nullptr, limits);
}

int32_t hsp_mesh_compute_surface_with(hsp_mesh *mesh, const hsp_surface *surface, double edge_length,
                                      const hsp_mesh_request *request, hsp_mesh_limits *limits) {
  return compute(mesh, surface, edge_length, request, limits);
}

int32_t hsp_mesh_get_counts(const hsp_mesh *mesh, hsp_mesh_counts *counts) {
  if (const int32_t status = check_results(mesh, counts == nullptr); status != HSP_OK) return status;
  const hsp::Mesh &found = mesh->builder.mesh();
  *counts = {found.vertex_count(), found.triangle_count(), found.curve_count(), found.refined_count()};
  return HSP_OK;
}

int32_t hsp_mesh_get_vertices(const hsp_mesh *mesh, double *xyz, double *normals, double *areas, uint32_t *balls,
                              uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(mesh); status != HSP_OK) return status;
  const hsp::Mesh &found = mesh->builder.mesh();
  const bool wanted = xyz != nullptr || normals != nullptr || areas != nullptr || balls != nullptr;
  if (!fits(wanted, capacity, found.vertex_count(), needed)) return HSP_E_CAPACITY;
  const hsp::Span<const uint32_t> caller = mesh->boundary->balls().caller;
  for (uint32_t v = 0; wanted && v < found.vertex_count(); ++v) {
    const hsp::MeshVertex &vertex = found.vertex(v);
    for (uint32_t axis = 0; axis < 3; ++axis) {
      if (xyz != nullptr) xyz[3 * size_t{v} + axis] = vertex.position[axis];
      if (normals != nullptr) normals[3 * size_t{v} + axis] = vertex.normal[axis];
    }
    if (balls != nullptr) balls[v] = caller[vertex.ball];
  }
  if (areas != nullptr) share_areas(found, areas);
  return HSP_OK;
}

int32_t hsp_mesh_get_weights(const hsp_mesh *mesh, const double *area, uint32_t patches, double *weights,
                             uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const bool bad = area == nullptr || (weights == nullptr && capacity > 0);
  if (const int32_t status = check_results(mesh, bad); status != HSP_OK) return status;
  const hsp::Mesh &found = mesh->builder.mesh();
  if (found.triangle_count() > 0 && found.triangle(found.triangle_count() - 1).patch >= patches) return HSP_E_ID;
  for (uint32_t p = 0; p < patches; ++p) {
    if (!hsp::is_finite(area[p])) return HSP_E_NOT_FINITE;
  }
  const int32_t status = check_output(capacity, found.vertex_count(), needed);
  if (status == HSP_OK) share_areas_of_patches(found, area, weights);
  return status;
}

int32_t hsp_mesh_get_triangles(const hsp_mesh *mesh, uint32_t *corners, uint32_t *kinds, uint32_t *patches,
                               uint32_t *balls, uint32_t capacity, uint32_t *needed) {
  if (const int32_t status = check_results(mesh); status != HSP_OK) return status;
  const hsp::Mesh &found = mesh->builder.mesh();
  const bool wanted = corners != nullptr || kinds != nullptr || patches != nullptr || balls != nullptr;
  if (!fits(wanted, capacity, found.triangle_count(), needed)) return HSP_E_CAPACITY;
  const hsp::Span<const uint32_t> caller = mesh->boundary->balls().caller;
  for (uint32_t t = 0; wanted && t < found.triangle_count(); ++t) {
    const hsp::MeshTriangle &triangle = found.triangle(t);
    for (uint32_t k = 0; corners != nullptr && k < 3; ++k) corners[3 * size_t{t} + k] = triangle.vertex[k];
    if (kinds != nullptr) kinds[t] = static_cast<uint32_t>(triangle.kind);
    if (patches != nullptr) patches[t] = triangle.patch;
    if (balls != nullptr) balls[t] = caller[triangle.ball];
  }
  return HSP_OK;
}

int32_t hsp_mesh_get_patch(const hsp_mesh *mesh, uint32_t patch, uint32_t *first, uint32_t *count) {
  if (const int32_t status = check_results(mesh, first == nullptr || count == nullptr); status != HSP_OK) return status;
  const hsp::IdRange triangles = mesh->builder.mesh().triangles_of(patch);
  *first = triangles.first;
  *count = triangles.size();
  return HSP_OK;
}
