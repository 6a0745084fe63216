// How often each stage of each predicate answers on molecules, on a set without any rule, and on lattices where ties
// abound. The tested library counts (HSP_COUNT_STAGES). vertex_pair is the question whether and
// where two caps' circles have free points, asked once for each pair of caps that is not surely apart: the filter is
// then the arithmetic in doubles of sphere/cap_pair.hpp, and exact means that it was passed on to crossing and
// point_status, which have stages of their own. Where the processor has wide registers, they answer first (lanes).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include "exact/predicates.hpp"
#include "four_balls.hpp"
#include "hardsphere.h"
#include "molecule_file.hpp"

#if !defined(HSP_COUNT_STAGES)
#error "this test is about the counters"
#endif

namespace {

using namespace hsp::exact;

constexpr Question questions[] = {Question::vertex_pair, Question::crossing, Question::side, Question::point_status};
constexpr const char *names[] = {"vertex_pair", "crossing", "side", "point_status"};
constexpr Stage stages[] = {Stage::lanes, Stage::filter, Stage::exact, Stage::perturbation};

uint64_t total(const StageCounters &counters, Question question) {
  uint64_t sum = 0;
  for (const Stage stage : stages) sum += counters.of(question, stage);
  return sum;
}

uint64_t without_integers(const StageCounters &counters, Question question) {
  return counters.of(question, Stage::lanes) + counters.of(question, Stage::filter);
}

uint64_t grand_total(const StageCounters &counters) {
  uint64_t sum = 0;
  for (const Question question : questions) sum += total(counters, question);
  return sum;
}

using Balls = support::BallList;

Balls read_molecule(const std::string &file) {
  return with_radii(support::read_atoms(support::own_molecule(file)), support::Radii::van_der_waals);
}

struct Answers {
  StageCounters counters;
  hsp_boundary_counts counts;
};

// The boundary through the C interface by all workers that the limits allow, with counters from 0.
Answers compute(const hsp_model *model, const hsp_boundary_limits &limits, hsp_boundary_limits *needed = nullptr) {
  Answers result{};
  size_t bytes = 0;
  EXPECT_EQ(hsp_boundary_bytes(&limits, &bytes), HSP_OK);
  std::vector<std::byte> memory(bytes);
  hsp_boundary *boundary = nullptr;
  EXPECT_EQ(hsp_boundary_init(memory.data(), bytes, &limits, &boundary), HSP_OK);
  stage_counters = {};
  const auto run = [](void *, uint32_t tasks, hsp_task *task, void *data) {
    for (uint32_t k = 0; k < tasks; ++k) task(data, k);
    return 0;
  };
  const hsp_executor executor{sizeof executor, limits.workers, nullptr, run, nullptr};
  hsp_boundary_request request{};
  request.struct_size = sizeof request;
  request.executor = &executor;
  EXPECT_EQ(hsp_boundary_compute_with(boundary, model, &request, needed), HSP_OK);
  result.counters = stage_counters;
  EXPECT_EQ(hsp_boundary_get_counts(boundary, &result.counts), HSP_OK);
  return result;
}

// With limits that are ample, or such as are just needed by so many workers.
Answers run(const Balls &balls, double probe, uint32_t workers = 0) {
  size_t bytes = 0;
  EXPECT_EQ(hsp_model_bytes(balls.size(), &bytes), HSP_OK);
  std::vector<std::byte> model_memory(bytes);
  hsp_model *model = nullptr;
  EXPECT_EQ(hsp_model_init(model_memory.data(), bytes, balls.size(), &model), HSP_OK);
  hsp_model_options options;
  EXPECT_EQ(hsp_model_options_init(&options, sizeof options), HSP_OK);
  options.probe = probe;
  EXPECT_EQ(hsp_model_set(model, balls.size(), balls.xyz.data(), balls.radius.data(), &options, nullptr), HSP_OK);

  hsp_boundary_limits limits;
  EXPECT_EQ(hsp_boundary_limits_init(&limits, sizeof limits, balls.size()), HSP_OK);
  limits.vertices += 64 * balls.size();
  limits.neighbours = balls.size();
  hsp_boundary_limits needed;
  EXPECT_EQ(hsp_boundary_limits_init(&needed, sizeof needed, balls.size()), HSP_OK);
  const Answers ample = compute(model, limits, &needed);
  if (workers == 0) return ample;
  needed.workers = workers;
  return compute(model, needed);
}

void print(const char *name, const Answers &run) {
  std::cout << "  " << name << ": " << run.counts.balls << " balls, " << run.counts.vertices << " vertices, "
            << run.counts.tied_vertices << " of them tied\n";
  for (size_t q = 0; q < 4; ++q) {
    std::cout << "    " << std::left << std::setw(13) << names[q] << std::right;
    for (const Stage stage : stages) {
      std::cout << std::setw(10) << run.counters.of(questions[q], stage);
      testing::Test::RecordProperty(
          std::string(name) + "_" + names[q] + "_" + std::to_string(static_cast<uint32_t>(stage)),
          std::to_string(run.counters.of(questions[q], stage)));
    }
    std::cout << '\n';
  }
}

void shift_and_append(Balls &balls, double shift) {
  const uint32_t n = balls.size();
  for (uint32_t k = 0; k < n; ++k) {
    balls.add(balls.xyz[3 * k] + shift, balls.xyz[3 * k + 1] + shift, balls.xyz[3 * k + 2] + shift, balls.radius[k]);
  }
}

// Rules that hold for every set.
void expect_consistent(const Balls &balls, double probe, const Answers &first) {
  const StageCounters &counters = first.counters;
  // A pair that is passed on asks once whether it crosses, and has no symbolic perturbation of its own.
  EXPECT_GE(total(counters, Question::crossing), counters.of(Question::vertex_pair, Stage::exact));
  EXPECT_EQ(counters.of(Question::vertex_pair, Stage::perturbation), 0U);
  // A vertex is found by one pair, a pair finds at most two; a tied one needs the exact stage.
  EXPECT_LE(first.counts.vertices, 2 * total(counters, Question::vertex_pair));
  EXPECT_LE(first.counts.tied_vertices, 2 * counters.of(Question::vertex_pair, Stage::exact));
  // The same set beside itself, a whole number of cubes away, asks everything twice.
  double largest = 0.0;
  for (const double r : balls.radius) largest = std::max(largest, r);
  Balls twice = balls;
  shift_and_append(twice, 64.0 * 2.0 * (largest + probe));
  const Answers second = run(twice, probe);
  EXPECT_EQ(second.counts.vertices, 2 * first.counts.vertices);
  for (const Question question : questions) {
    for (const Stage stage : stages) EXPECT_EQ(second.counters.of(question, stage), 2 * counters.of(question, stage));
  }
}

Answers run_and_print(const char *name, const Balls &balls, double probe) {
  const Answers result = run(balls, probe);
  print(name, result);
  expect_consistent(balls, probe, result);
  return result;
}

// One call of each predicate raises one counter by one: that of its question, and of the stage that really answered.
TEST(StageCounters, EachQuestionIsAnsweredOnce) {
  oracle::RandomSource random(402);
  uint64_t answered[3] = {};
  for (int k = 0; k < 30000; ++k) {
    const FourBalls four = random_four_balls(random);
    const Sphere sphere = four.sphere();
    const Plane P = four.plane(1), Q = four.plane(2), R = four.plane(3);
    const Predicates predicates(sphere, four.length_squared());
    const FilterBounds bounds = FilterBounds::for_length_squared(four.length_squared());
    const auto expect_one = [&answered](Question question, Stage stage) {
      ASSERT_EQ(grand_total(stage_counters), 1U);
      ASSERT_EQ(stage_counters.of(question, stage), 1U);
      ++answered[static_cast<size_t>(stage)];
      stage_counters = {};
    };
    const auto rung_of = [](bool sure, bool tied) {
      return sure ? Stage::filter : tied ? Stage::perturbation : Stage::exact;
    };

    stage_counters = {};
    const Sign crossing = predicates.crossing(P, Q);
    expect_one(Question::crossing, rung_of(filter_crossing(bounds, sphere, P, Q) != 0, crossing.tied));
    const Sign exact_crossing = Exact::crossing(sphere, P, Q);
    ASSERT_TRUE(crossing.sign == exact_crossing.sign && crossing.tied == exact_crossing.tied);
    if (crossing.sign < 0) {
      const Sign side = predicates.side(P, R);
      expect_one(Question::side, rung_of(filter_side(bounds, P, R) != 0, side.tied));
      const Sign exact_side = Exact::side(sphere, P, R);
      ASSERT_TRUE(side.sign == exact_side.sign && side.tied == exact_side.tied);
      continue;
    }
    PointStatus filtered{};
    const bool sure = filter_point_status(bounds, sphere, P, Q, R, filtered);
    const PointStatus status = predicates.point_status(P, Q, R);
    expect_one(Question::point_status, rung_of(sure, status.tied[0] || status.tied[1]));
    const PointStatus exact_status = Exact::point_status(sphere, P, Q, R);
    for (int point = 0; point < 2; ++point) {
      ASSERT_EQ(status.side[point], exact_status.side[point]);
      ASSERT_EQ(status.tied[point], exact_status.tied[point]);
      ASSERT_EQ(predicates.inside(P, Q, point == 1 ? 1 : -1, R), exact_status.side[point]);
      expect_one(Question::point_status, rung_of(sure, status.tied[0] || status.tied[1]));
    }
  }
  for (const uint64_t count : answered) EXPECT_GT(count, 1000U);
}

// Without ties doubles decide all vertices, circles and clusters. Only questions about poles, which are asked on balls
// with several loops, may go to the exact stage: a plane through the poles has a short normal, and the filter's bounds
// are made for the longest vector in use.
void expect_doubles_decide(const Answers &run) {
  const StageCounters &counters = run.counters;
  EXPECT_GT(without_integers(counters, Question::vertex_pair), 0U);
  for (const Question question : questions) {
    EXPECT_EQ(counters.of(question, Stage::perturbation), 0U);
    if (question != Question::point_status) {
      EXPECT_EQ(counters.of(question, Stage::exact), 0U);
    }
  }
  EXPECT_LE(4 * counters.of(Question::point_status, Stage::exact), total(counters, Question::point_status));
  EXPECT_LE(50 * counters.of(Question::point_status, Stage::exact), grand_total(counters));
  EXPECT_EQ(run.counts.tied_vertices, 0U);
}

TEST(StageCounters, Molecules) {
  const Balls crambin = read_molecule("crambin.pdb");
  const Balls caffeine = read_molecule("caffeine.pdb");
  ASSERT_EQ(crambin.size(), 327U);
  ASSERT_EQ(caffeine.size(), 24U);
  expect_doubles_decide(run_and_print("crambin_vdw", crambin, 0.0));
  expect_doubles_decide(run_and_print("crambin_sas", crambin, 1.4));
  expect_doubles_decide(run_and_print("caffeine_vdw", caffeine, 0.0));
  expect_doubles_decide(run_and_print("caffeine_sas", caffeine, 1.4));
}

// The wide code asks as often whatever the limits and however many share the work.
TEST(StageCounters, MoleculesWithTheLeastMemory) {
  for (const char *file : {"caffeine.pdb", "crambin.pdb"}) {
    const Balls balls = read_molecule(file);
    for (const double probe : {0.0, 1.4, 3.0}) {
      const Answers ample = run(balls, probe);
      for (const uint32_t workers : {1U, 16U}) {
        const Answers least = run(balls, probe, workers);
        for (const Question question : questions) {
          EXPECT_EQ(least.counters.of(question, Stage::lanes), ample.counters.of(question, Stage::lanes))
              << file << ", probe " << probe << ", workers " << workers;
        }
      }
    }
  }
}

TEST(StageCounters, ASetWithoutRule) {
  oracle::RandomSource random(401);
  Balls balls;
  for (int k = 0; k < 2000; ++k) {
    const double x = 20 * random.fraction(), y = 20 * random.fraction(), z = 20 * random.fraction();
    balls.add(x, y, z, 0.8 + random.fraction());
  }
  const Answers result = run_and_print("random", balls, 0.0);
  const StageCounters &counters = result.counters;
  for (const Question question : questions) {
    EXPECT_GT(without_integers(counters, question), 400U);
    EXPECT_EQ(counters.of(question, Stage::perturbation), 0U);
  }
  EXPECT_EQ(counters.of(Question::vertex_pair, Stage::exact), 0U);
  EXPECT_EQ(counters.of(Question::crossing, Stage::exact), 0U);
  EXPECT_EQ(counters.of(Question::side, Stage::exact), 0U);
  EXPECT_LE(4 * counters.of(Question::point_status, Stage::exact), total(counters, Question::point_status));
}

// On the cubic lattice with these radii the four spheres of every square pass through two points; nothing else ties. On
// the face-centred lattice six spheres meet in one point and each touches its second neighbours.
TEST(StageCounters, Lattices) {
  Balls cubic, fcc;
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 8; ++y) {
      for (int z = 0; z < 8; ++z) {
        cubic.add(x, y, z, 0.75);
        if ((x + y + z) % 2 == 0) fcc.add(x, y, z, 1.0);
      }
    }
  }
  const Answers on_cubic = run_and_print("cubic", cubic, 0.0);
  EXPECT_GT(on_cubic.counts.vertices, 1000U);
  EXPECT_EQ(on_cubic.counts.tied_vertices, on_cubic.counts.vertices);
  EXPECT_EQ(without_integers(on_cubic.counters, Question::vertex_pair), 0U);
  EXPECT_GT(on_cubic.counters.of(Question::point_status, Stage::perturbation), 1000U);

  const Answers on_fcc = run_and_print("fcc", fcc, 0.0);
  EXPECT_GT(on_fcc.counts.tied_vertices, 100U);
  EXPECT_GT(on_fcc.counters.of(Question::crossing, Stage::perturbation), 1000U);
  EXPECT_GT(on_fcc.counters.of(Question::point_status, Stage::perturbation), 1000U);
}

// Of equal balls one is asked about: not the planes of all that stand for one, each with each.
TEST(StageCounters, CopiesAreNotAskedAbout) {
  oracle::RandomSource random(403);
  Balls once;
  while (once.size() < 20) {
    const auto coordinate = [&random] { return static_cast<double>(random.in(-2000, 2000)) / 1000; };
    const double x = coordinate(), y = coordinate(), z = coordinate();
    once.add(x, y, z, static_cast<double>(random.in(1000, 1500)) / 1000);
  }
  for (const int copies : {3, 40}) {  // few caps a ball, or many
    Balls copied;
    for (int copy = 0; copy < copies; ++copy) {
      for (uint32_t k = 0; k < once.size(); ++k) {
        copied.add(once.xyz[3 * k], once.xyz[3 * k + 1], once.xyz[3 * k + 2], once.radius[k]);
      }
    }
    const Answers of_one = run(once, 0.0), of_all = run_and_print("copies", copied, 0.0);
    EXPECT_EQ(of_all.counts.vertices, of_one.counts.vertices);
    EXPECT_GT(of_one.counts.vertices, 20U);
    const auto exactly = [](const Answers &answers) {
      return answers.counters.of(Question::vertex_pair, Stage::exact);
    };
    EXPECT_LE(exactly(of_all), exactly(of_one) + 5);
    EXPECT_LE(total(of_all.counters, Question::vertex_pair), 2 * total(of_one.counters, Question::vertex_pair));
  }
}

}  // namespace
