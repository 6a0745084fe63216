// Meshes of random sets, with edges of one length and of half of it: errors of areas and volumes fall as the square.
// The sets are like a few atoms in a box, with probes of any size, so that many smooth surfaces meet themselves.
#pragma once

#include <vector>

#include "mesh_expectations.hpp"
#include "random_numbers.hpp"

// The counts of what was seen, over all sets.
struct ConvergenceTally {
  uint32_t sets = 0, cut = 0, cusped = 0, several_shells = 0;
  double area_ratio = 0.0, volume_ratio = 0.0;  // largest, of errors with half the edge and with the whole one
  double bend = 0.0;                            // largest angle between neighbours of the finer meshes

  void print(const char *of) const {
    std::printf(
        "%s of %u sets, %u patches cut, %u cusped, %u sets with several shells: errors fall to %.3f (area) and "
        "%.3f (volume) at worst, neighbours bend by %.1f degrees at most\n",
        of, sets, cut, cusped, several_shells, area_ratio, volume_ratio, bend);
  }
};

// By which areas and volumes are too small, in units that do not depend on how much of both there is: of the surface's
// area, and of that times the edge.
class SquareErrors {
 public:
  explicit SquareErrors(double area) : area_(area) {}

  // With the whole edge and half of it.
  void expect(const double (&area_error)[2], const double (&volume_error)[2], ConvergenceTally &tally) const {
    const double of_area = fell_to(area_error), of_volume = fell_to(volume_error);
    EXPECT_LT(of_area, 0.3) << area_error[0] / area_ << " " << area_error[1] / area_;
    EXPECT_LT(of_volume, 0.3) << volume_error[0] / area_ << " " << volume_error[1] / area_;
    tally.area_ratio = std::max(tally.area_ratio, of_area);
    tally.volume_ratio = std::max(tally.volume_ratio, of_volume);
  }

 private:
  // Errors of parts that bulge and of hollow ones may cancel: how such a sum falls is not asked.
  double fell_to(const double (&error)[2]) const {
    const double least = 1e-3 * area_;
    return std::fabs(error[1]) / std::max(std::fabs(error[0]), least);
  }

  double area_;
};

class RandomAtoms {
 public:
  explicit RandomAtoms(uint64_t seed) {
    support::Random random(seed);
    const uint32_t n = 3 + random.below(6);
    probe_ = 0.5 + 0.25 * random.below(8);
    const double side = 3.0 * std::cbrt(static_cast<double>(n));
    for (uint32_t k = 0; k < n; ++k) {
      const double x = side * random.fraction(), y = side * random.fraction(), z = side * random.fraction();
      balls_.add(x, y, z, 0.8 + random.fraction());
    }
  }
  const support::BallList &balls() const { return balls_; }
  double probe() const { return probe_; }

 private:
  support::BallList balls_;
  double probe_ = 0;
};

// With edges of 0.05 to 1 of the largest radius that there may be, boundaries with and without the probe and the smooth
// surface.
inline void expect_vertices_of_atoms(uint64_t seed) {
  const RandomAtoms atoms(seed);
  support::Random random(~seed);
  const double edge = 1.8 * std::pow(0.05, random.fraction());
  for (const double probe : {0.0, atoms.probe()}) {
    const MeshedBalls balls(atoms.balls(), probe);
    expect_sound(MadeMesh(balls.boundary(), edge), balls.boundary().counts.euler);
    if (probe == 0.0) continue;
    ASSERT_TRUE(balls.has_closed_surface());
    const MadeMesh mesh(balls.surface(), edge);
    expect_sound(mesh, balls.surface_euler());
    expect_on_surface(mesh, probe);
  }
}

inline void expect_converging_boundary(uint64_t seed, double edge, ConvergenceTally &tally) {
  SCOPED_TRACE(seed);
  const RandomAtoms atoms(seed);
  const MeshedBalls balls(atoms.balls(), 0.0);
  const hsp_totals &exact = balls.boundary().totals;
  const double origin[3] = {0.0, 0.0, 0.0};
  double area[2], volume[2];
  for (int k = 0; k < 2; ++k) {
    const MadeMesh mesh(balls.boundary(), edge / (1 << k));
    expect_sound(mesh, balls.boundary().counts.euler);
    area[k] = exact.area - mesh_area(&mesh.get());
    volume[k] = exact.volume - mesh_volume(&mesh.get(), origin);
    if (k == 1) tally.bend = std::max(tally.bend, mesh_defects(mesh.get(), nullptr, 90.0).bend);
  }
  SquareErrors(exact.area).expect(area, volume, tally);
  ++tally.sets;
}

// Shell by shell: each has its own area and volume, which the triangles of its patches know nothing of.
inline void expect_converging_surface(uint64_t seed, double edge, ConvergenceTally &tally) {
  SCOPED_TRACE(seed);
  const RandomAtoms atoms(seed);
  const MeshedBalls balls(atoms.balls(), atoms.probe());
  ASSERT_TRUE(balls.has_closed_surface());
  const std::vector<hsp_surface_shell> shells = balls.surface_shells();
  const std::vector<uint32_t> shell_of_patch = balls.shells_of_patches();
  std::vector<double> area[2], volume[2];
  for (int k = 0; k < 2; ++k) {
    const MadeMesh mesh(balls.surface(), edge / (1 << k));
    expect_sound(mesh, balls.surface_euler());
    area[k].resize(shells.size());
    volume[k].resize(shells.size());
    for (size_t s = 0; s < shells.size(); ++s) {
      area[k][s] = shells[s].area;
      volume[k][s] = shells[s].volume;
    }
    for (uint32_t t = 0; t < mesh.get().counts.triangles; ++t) {
      const uint32_t s = shell_of_patch[mesh.get().patches[t]];
      ASSERT_LT(s, shells.size());
      area[k][s] -= mesh.triangle_area(t);
      volume[k][s] -= mesh.triangle_volume(t);
    }
    if (k == 1) tally.bend = std::max(tally.bend, mesh_defects(mesh.get(), balls.surface().surface, 90.0).bend);
  }
  for (size_t s = 0; s < shells.size(); ++s) {
    const double areas[2] = {area[0][s], area[1][s]}, volumes[2] = {volume[0][s], volume[1][s]};
    SquareErrors(shells[s].area).expect(areas, volumes, tally);
  }
  ++tally.sets;
  tally.cut += balls.surface().counts.cut_patches;
  tally.cusped += balls.surface().counts.cusped_patches;
  tally.several_shells += shells.size() > 1 ? 1 : 0;
}
