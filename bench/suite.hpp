// What the benchmark programs share: their main function, how a case is registered, random query centres.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "handles.hpp"
#include "paper_molecules.hpp"

namespace bench {

// Every program defines this; main calls it once.
void register_suite();

// What is computed of a set of balls, one thing after the other.
enum class Stage { model, boundary, topology };

// A model and, as far as it was asked for, boundary and topology of one set of balls.
struct Subject {
  Balls balls;
  std::unique_ptr<Model> model;
  std::unique_ptr<Boundary> boundary;
  std::unique_ptr<Topology> topology;
};

// Makes a subject. It is called when the first benchmark that needs it runs, not when benchmarks are registered.
struct SubjectRecipe {
  std::string key;  // tells recipes apart
  std::function<Balls()> balls;
  double probe = 0;
  Stage last = Stage::model;
};

using Body = std::function<void(benchmark::State &, Subject &)>;

// Register a benchmark over a subject. Benchmarks of the same recipe key that are registered one after the other share
// the subject, with all repetitions; only one subject is alive at a time. Exceptions become the benchmark's error.
benchmark::internal::Benchmark *register_case(const std::string &name, const SubjectRecipe &recipe, Body body);

// Register a benchmark that only says why it was skipped.
void register_skipped(const std::string &name, const std::string &reason);

// `count` points [count][3], uniform in the box around all balls (centres and radii).
std::vector<double> random_points_in_box(const Model &model, size_t count);

// `count` points [count][3], each uniform in the ball of radius 1 Angstrom around a random centre.
std::vector<double> random_points_near_atoms(const Model &model, size_t count);

// `count` points [count][3] within 1 Angstrom of the surface, outside all balls: a random direction from a random
// centre, uniform between the sphere and 1 Angstrom above it, those inside other balls left out.
std::vector<double> random_points_near_surface(const Model &model, size_t count);

// Ask for the balls that contain each of the points [count][3], or that meet the ball of this radius around it.
// Returns the number of hits.
size_t query_points(const Model &model, const std::vector<double> &points);
size_t query_balls(const Model &model, const std::vector<double> &points, double radius);

// Ask for the neighbours of every ball of the model (Step 1). Returns the number of neighbours listed.
size_t query_all_neighbours(const Model &model);

// The same in one call, into arrays that grow as needed.
size_t query_all_pairs(const Model &model, std::vector<uint32_t> &first, std::vector<uint32_t> &ids);

}  // namespace bench
