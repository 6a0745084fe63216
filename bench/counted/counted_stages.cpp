// counted_stages: runs each stage of the library once, and the z-buffer that frames are measured against, for valgrind
// to count their instructions. After each stage it prints a line: stage, molecule, surface, and the number of balls,
// moves or poses. instruction_budgets.sh runs it. `counted_stages --build` prints how it and the library were built.
// `--code` prints which code runs on this processor: `wide` if kernels for AVX2 do, else `scalar`. `--balls` prints
// crambin's balls for the programs of targets/: centre, radius and a point near some ball, as hexadecimal numbers.
//
// Each handle has computed before the stage that is counted, so memory and limits are those of a repeated call. The
// library's input comes from files and integers alone, so that every run does the same instructions.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <vector>

#include "branch_predictor.hpp"
#include "free_space.hpp"
#include "halved_set.hpp"
#include "lanes/target.hpp"
#include "moving_workload.hpp"
#include "pose_workload.hpp"
#include "query_workload.hpp"
#include "second_derivatives.hpp"
#include "sizes.hpp"
#include "smooth_surface.hpp"
#include "tiling.hpp"
#include "view_handle.hpp"
#include "z_buffer/analytic_z_buffer.hpp"
#include "z_buffer/placement.hpp"

// valgrind knows the stages by this function: callgrind begins to count when it is called, and dumps when it returns.
// The name is that of C, so that it can be given on the command line.
extern "C" __attribute__((noinline)) void counted_stage(const std::function<void()> &stage) {
  stage();
  __asm__ volatile("");  // the call above shall not become a jump: callgrind would see this function end before it
}

namespace {

using bench::Surface;

constexpr bench::Direction towards = {0.36, -0.48, 0.8};

// Runs a stage whose cost is divided by n, the number of its moves, poses or balls.
void count_each(const char *stage, const bench::Balls &balls, const Surface &surface, uint32_t n,
                const std::function<void()> &run) {
  bench::settle_branch_predictor();
  counted_stage(run);
  std::printf("%s %s %s %u\n", stage, balls.name.c_str(), surface.name, n);
}

void count(const char *stage, const bench::Balls &balls, const Surface &surface, const std::function<void()> &run) {
  count_each(stage, balls, surface, balls.size(), run);
}

void count_pockets(const bench::Balls &balls, const bench::Model &model) {
  const Surface &surface = bench::surfaces[0];
  bench::Pockets pockets(model);
  count("pockets", balls, surface, [&] { pockets.find(); });
  count("plugs", balls, surface, [&] { pockets.list_plugs(); });
  count("plugged_pores", balls, surface, [&] { pockets.compute_plugged(); });
  count("pocket_sizes", balls, surface, [&] { pockets.measure(); });
}

// There are as many query points as balls, so that the cost per ball is the cost per query.
void count_stages(const bench::Balls &balls, const Surface &surface) {
  bench::Model model(balls, surface.probe);
  count("model", balls, surface, [&] { model.set(); });
  bench::Boundary boundary(model);
  count("boundary", balls, surface, [&] { boundary.compute(); });
  count("measure", balls, surface, [&] { boundary.measure(); });
  count("gradient", balls, surface, [&] { boundary.gradient(); });
  bench::Contacts contacts(boundary);
  count("contacts", balls, surface, [&] { contacts.compute(); });
  count("curvature", balls, surface, [&] { boundary.curvature_gradient(); });
  bench::SecondDerivatives second(boundary);
  count("hessian_area", balls, surface, [&] { second.find_rows_of_area(); });
  count("hessian_volume", balls, surface, [&] { second.find_rows_of_volume(); });
  count("hessian_product", balls, surface, [&] { second.multiply(); });
  const bool is_small = balls.size() < 1000;  // meshes and pores of larger sets take minutes in a simulated processor
  if (is_small) {
    bench::Triangles triangles(boundary);
    count("mesh", balls, surface, [&] { triangles.compute(); });
  }
  if (surface.probe != 0) {
    bench::SmoothSurface smooth(boundary);
    count("surface", balls, surface, [&] { smooth.compute(); });
    count("surface_measure", balls, surface, [&] { smooth.measure(); });
    count("surface_gradient", balls, surface, [&] { smooth.gradient(); });
    count("surface_weighted", balls, surface, [&] { smooth.weighted_gradient(); });
  }
  bench::HalvedSet halves(balls, surface.probe);
  count_each("brick_summary", balls, surface, halves.owned(), [&] { halves.summarise_first(); });
  count_each("brick_merge", balls, surface, halves.owned(), [&] { halves.merge(); });
  bench::Topology topology(boundary);
  count("topology", balls, surface, [&] { topology.compute(); });
  const std::vector<double> outside = random_points_near_surface(model, model.size());
  count("locate", balls, surface, [&] { locate_points(topology, outside); });
  const std::vector<double> points = random_points_near_atoms(model, model.size());
  count("query_point", balls, surface, [&] { query_points(model, points); });
  count("query_ball", balls, surface, [&] { query_balls(model, points, model.largest_radius()); });
  count("query_neighbours", balls, surface, [&] { query_all_neighbours(model); });
  std::vector<uint32_t> first;
  std::vector<uint32_t> ids;
  query_all_pairs(model, first, ids);
  count("query_pairs", balls, surface, [&] { query_all_pairs(model, first, ids); });
  bench::FreeSpace space(model);
  count("cells", balls, surface, [&] { space.compute(); });
  const std::vector<double> box = random_points_in_box(model, model.size());
  count("cell_locate", balls, surface, [&] { space.locate(box); });
  bench::Periodic periodic(model, bench::tiling_period(balls));
  count("periodic", balls, surface, [&] { periodic.compute(); });
  bench::Periodic periodic_areas(model, bench::tiling_period(balls), true);
  count("periodic_areas", balls, surface, [&] {
    periodic_areas.compute();
    periodic_areas.differentiate();
  });
  if (surface.probe != 0) return;  // pictures are of van der Waals balls, and pores are for every probe at once
  if (is_small) {
    bench::Pores pores(model);
    count("pores", balls, surface, [&] { pores.compute(); });
    count_pockets(balls, model);
    count("pore_regions", balls, surface, [&] { pores.find_regions(boundary); });
  }
  bench::View farther(model, nullptr, HSP_PIECES_OUTSIDE_FARTHER, {towards});
  count("view_farther", balls, surface, [&] { farther.compute(towards); });
  bench::View all(model, &boundary, HSP_PIECES_OUTSIDE_ALL, {towards});
  count("view_all", balls, surface, [&] { all.compute(towards); });
  bench::VisibleMap map(model, {towards});
  count("map", balls, surface, [&] { map.compute(towards); });
  if (balls.name == "crambin") {  // in random sets sticks would run into balls
    bench::Sticks sticks(balls);
    for (const bool as_map : {true, false}) {
      sticks.compute(towards, as_map);
      count(as_map ? "sticks_map" : "sticks", balls, surface, [&] { sticks.compute(towards, as_map); });
      count(as_map ? "sticks_contours" : "sticks_picture", balls, surface,
            [&] { sticks.write_picture(as_map ? &sticks : nullptr); });
    }
  }
  // The base that frames and maps are measured against: both start with the centres and a direction.
  bench::Placement placement(balls.xyz, balls.radius);
  bench::AnalyticZBuffer z_buffer;
  count("z_buffer", balls, surface, [&] { z_buffer.draw(placement.place(bench::axes_towards(towards))); });
}

void count_pockets_of_ubiquitin() {
  const bench::Molecule molecule{"ubiquitin", support::read_atoms(support::own_molecule("ubiquitin.pdb"))};
  const bench::Balls balls = with_radii(molecule, bench::Radii::van_der_waals);
  count_pockets(balls, bench::Model(balls, 0));
}

// Pores where eight balls tie at every maximum, and four at every gate.
void count_tied_pores() {
  const bench::Balls balls = bench::tied_lattice(6);
  bench::Model model(balls, 0);
  bench::Pores pores(model);
  count("pores", balls, bench::surfaces[0], [&] { pores.compute(); });
}

// One atom moves at a time: there, and back by another move.
void count_moves(const bench::Balls &balls, const Surface &surface) {
  constexpr uint32_t atoms = 100;
  bench::MovingAtoms moving(balls, surface.probe, atoms, 1);
  count_each("move_atom", balls, surface, 2 * atoms, [&] { moving.move_all(); });
}

// Molecules against the stand-in for SOD, in poses that bring them a fifth of an Angstrom near.
void count_poses() {
  const bench::PreparedBody fixed(bench::resting_molecule());
  for (const bench::Balls &balls : bench::moving_molecules()) {
    const bench::PreparedBody moving(balls);
    constexpr uint32_t poses = 100;
    const std::vector<hsp_pose> at = slid_poses(fixed, moving, poses, 0.2);
    const auto count_pose = [&](const char *stage, const std::function<void()> &run) {
      count_each(stage, balls, bench::surfaces[0], poses, run);
    };
    count_pose("pose_hit", [&] { count_hits(fixed, moving, at); });
    count_pose("pose_gap", [&] { sum_gaps(fixed, moving, at); });
    count_pose("pose_pairs", [&] { count_pairs(fixed, moving, at); });
  }
}

void print_balls() {
  const bench::Balls balls = bench::moving_molecules()[1];
  bench::Model model(balls, 0);
  const std::vector<double> points = random_points_near_atoms(model, model.size());
  for (size_t i = 0; i < balls.size(); ++i) {
    const double *const centre = &balls.xyz[3 * i], *const point = &points[3 * i];
    std::printf("%a %a %a %a %a %a %a\n", centre[0], centre[1], centre[2], balls.radius[i], point[0], point[1],
                point[2]);
  }
}

}  // namespace

int main(int argc, char **argv) {
  if (argc == 2 && std::strcmp(argv[1], "--build") == 0) {
    std::puts(BENCH_BUILD);
    return 0;
  }
  if (argc == 2 && std::strcmp(argv[1], "--code") == 0) {
    std::puts(hsp::best_target() == hsp::Target::avx2 ? "wide" : "scalar");
    return 0;
  }
  try {
    if (argc == 2 && std::strcmp(argv[1], "--balls") == 0) {
      print_balls();
      return 0;
    }
    for (const bench::Molecule &molecule : bench::paper_molecules()) {
      const bench::Balls balls = with_radii(molecule, bench::Radii::van_der_waals);
      if (molecule.name != "crambin" && molecule.name != "sod_stand_in") continue;
      for (const Surface &surface : bench::surfaces) {
        count_stages(balls, surface);
        count_moves(balls, surface);
      }
    }
    count_pockets_of_ubiquitin();
    count_tied_pores();
    count_poses();
  } catch (const std::exception &error) {
    std::fprintf(stderr, "counted_stages: %s\n", error.what());
    return 1;
  }
  return 0;
}
