// Unions in a periodic box (hsp_periodic_compute_with) by turns with the same balls in free space: model, boundary,
// contacts and shares of both; in the box also the gradient and second derivatives. The sets are a molecule in the box
// of its tiling, and waters that fill a box.
#include <cmath>
#include <cstdint>

#include "alternation.hpp"
#include "sizes.hpp"
#include "suite.hpp"
#include "tiling.hpp"

namespace bench {
namespace {

using Box = std::array<double, 3>;

void free_and_periodic(benchmark::State &state, Subject &subject, const Box &side) {
  Model &model = *subject.model;
  Boundary &boundary = *subject.boundary;
  boundary.compute();
  Contacts contacts(boundary);
  Periodic periodic(model, side);
  alternate(state, model.size(),
            {{"free",
              [&] {
                model.set();
                boundary.compute();
                contacts.compute();
              }},
             {"box", [&] { periodic.compute(); }},
             {"box_gradient", [&] { periodic.differentiate(); }},
             {"box_hessian", [&] { periodic.differentiate_twice(); }}});

  const hsp_periodic_counts counts = periodic.counts();
  state.counters["images_per_atom"] = static_cast<double>(counts.images) / model.size();
  state.counters["contacts_ratio"] = static_cast<double>(counts.contacts) / contacts.count();
}

void add_case(const Surface &surface, const Size &size, const std::function<Box(const Balls &)> &box) {
  const std::string name = std::string("periodic/") + surface.name + '/' + size.name;
  register_case(
      name, {name, size.balls, surface.probe, Stage::boundary},
      [box](benchmark::State &state, Subject &subject) { free_and_periodic(state, subject, box(subject.balls)); })
      ->Unit(benchmark::kMicrosecond);
}

constexpr double apart = 3.1;  // Angstrom: as many waters as there are in water

// Waters near the points of a grid, copies x copies x copies of them.
Balls waters(int copies) {
  Balls balls;
  balls.name = "water_" + std::to_string(copies * copies * copies);
  uint64_t random = 1;
  const auto jitter = [&random] {  // by half an Angstrom: the generator of Knuth, TAOCP 2, section 3.3.4, line 26
    random = random * UINT64_C(6364136223846793005) + 1;
    return static_cast<double>(random >> 11) * 0x1p-53 - 0.5;
  };
  for (int k = 0; k < copies * copies * copies; ++k) {
    for (const int at : {k % copies, k / copies % copies, k / copies / copies}) {
      balls.xyz.push_back(apart * (at + 0.5) + jitter());
    }
    balls.radius.push_back(1.52);
  }
  return balls;
}

}  // namespace

void register_suite() {
  for (const Surface &surface : surfaces) {
    const std::vector<Size> sizes = molecule_sizes();
    for (const Size &size : sizes) add_case(surface, size, tiling_period);
    const Size largest = sizes.back();
    for (const int copies : {2, 3}) {
      const auto box = [largest, copies](const Balls &) {
        Box period = tiling_period(largest.balls());
        for (double &length : period) length *= copies;
        return period;
      };
      const std::string many = "_x" + std::to_string(copies * copies * copies);
      add_case(surface, {largest.name + many, [largest, copies] { return tiled(largest.balls(), copies); }}, box);
    }
    for (const int copies : {16, 32}) {
      const std::string many = "water_" + std::to_string(copies * copies * copies);
      add_case(surface, {many, [copies] { return waters(copies); }}, [copies](const Balls &) {
        return Box{apart * copies, apart * copies, apart * copies};
      });
    }
  }
}

}  // namespace bench
