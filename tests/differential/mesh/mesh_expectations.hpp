// Rules for every mesh: closed, oriented, with the Euler characteristic of what it is a mesh of, and on it.
#pragma once

#include <gtest/gtest.h>
#include <mesh_invariants.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lattice_lengths.hpp"
#include "mesh_defects.hpp"
#include "meshed_balls.hpp"
#include "molecule_file.hpp"
#include "random_balls.hpp"
#include "surface_vertices.hpp"

inline support::BallList molecule_balls(const std::filesystem::path &file,
                                        support::Records records = support::Records::all) {
  return with_radii(support::read_atoms(file, records), support::Radii::van_der_waals);
}

// Of all edges, as a part of the length that they should have about.
inline double longest_edge(const mesh_result &mesh) {
  double most = 0.0;
  for (uint32_t t = 0; t < mesh.counts.triangles; ++t) {
    for (int k = 0; k < 3; ++k) {
      const double(&a)[3] = mesh.xyz[mesh.corners[t][k]];
      const double(&b)[3] = mesh.xyz[mesh.corners[t][(k + 1) % 3]];
      most = std::max(most, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  }
  return most / mesh.edge;
}

inline void expect_sound(const MadeMesh &mesh, int64_t euler) {
  ASSERT_EQ(mesh.status(), HSP_OK) << hsp_status_text(mesh.status());
  const char *const fault = mesh_fault(&mesh.get());
  EXPECT_EQ(fault, nullptr) << (fault == nullptr ? "" : fault);
  EXPECT_EQ(mesh.euler(), euler);
  EXPECT_LT(longest_edge(mesh.get()), 2.5);
  if (mesh.get().surface != nullptr) return;
  const char *const broken = broken_mesh_vertices(&mesh.get());
  EXPECT_EQ(broken, nullptr) << (broken == nullptr ? "" : broken);
}

// Of sets without ties and of the smooth surface: what an oracle in doubles is good for.
inline void expect_on_surface(const MadeMesh &mesh, double probe) {
  const VertexErrors errors = surface_vertex_errors(mesh.get(), probe);
  EXPECT_LT(errors.off, 1e-7);
  EXPECT_LT(errors.normal, 1e-4);
}

// Shares by which area and volume are too small. With edges half as long they fall as the square; those of parts that
// bulge and of hollow ones may cancel in the volume of a smooth surface, which then is but bounded by such a square.
struct MeshErrors {
  double area, volume;
};
inline MeshErrors errors_of(const MadeMesh &mesh, double area, double volume) {
  const double origin[3] = {0.0, 0.0, 0.0};
  return {1.0 - mesh_area(&mesh.get()) / area, 1.0 - mesh_volume(&mesh.get(), origin) / volume};
}
inline void expect_quarter(double coarse, double fine) {
  EXPECT_LT(std::fabs(fine), 0.33 * std::fabs(coarse));
}

// Boundary and smooth surface of a molecule, with edges of this length and half of it.
inline void expect_meshes(const support::BallList &atoms, double probe, double edge) {
  const MeshedBalls balls(atoms, probe);
  MeshErrors boundary[2], surface[2];
  for (int k = 0; k < 2; ++k) {
    const MadeMesh of_boundary(balls.boundary(), edge / (1 << k));
    expect_sound(of_boundary, balls.boundary().counts.euler);
    boundary[k] = errors_of(of_boundary, balls.boundary().totals.area, balls.boundary().totals.volume);
    if (probe == 0.0) continue;
    ASSERT_TRUE(balls.has_closed_surface());
    const MadeMesh of_surface(balls.surface(), edge / (1 << k));
    expect_sound(of_surface, balls.surface_euler());
    if (k == 0) expect_on_surface(of_surface, probe);
    surface[k] = errors_of(of_surface, balls.surface().totals.area, balls.surface().totals.volume);
  }
  expect_quarter(boundary[0].area, boundary[1].area);
  expect_quarter(boundary[0].volume, boundary[1].volume);
  if (probe == 0.0) return;
  expect_quarter(surface[0].area, surface[1].area);
  const double bound = 0.005 * edge * edge;
  EXPECT_LT(std::fabs(surface[1].volume), std::max(0.33 * std::fabs(surface[0].volume), bound));
}

// Of a random set of any kind, most of them full of ties.
inline void expect_meshes_of_set(uint64_t seed) {
  SCOPED_TRACE(seed);
  oracle::RandomSource random(seed);
  const support::BallList lengths = oracle::in_lengths(oracle::any_balls(random, 3 + seed % 12), 1);
  double largest = 1.0;
  for (const double r : lengths.radius) largest = std::max(largest, r);
  const double probe = std::floor(0.3 * largest * static_cast<double>(seed % 5));
  const MeshedBalls balls(lengths, probe, 1.0);
  const double edge = 0.5 * (largest + probe);
  expect_sound(MadeMesh(balls.boundary(), edge), balls.boundary().counts.euler);
  if (probe == 0.0) return;
  EXPECT_TRUE(balls.has_closed_surface());
  expect_sound(MadeMesh(balls.surface(), edge), balls.surface_euler());
}
