// The table of the paper's Section 5.1: times of frames, each from a new direction.
//
// The boundary is computed before the clock starts, as in the paper. A frame is hsp_view_compute: with H-pieces, with
// G-pieces, and with G-pieces from the model alone. It is timed by turns with two z-buffers of 1000 x 1000 pixels, from
// the same directions, turning and scaling of the centres included: a fast one without triangles, and the paper's with
// 100 triangles a ball. The picture is the flat SVG of the G-pieces, written to a sink that counts.
#include "alternation.hpp"
#include "sizes.hpp"
#include "suite.hpp"
#include "view_handle.hpp"
#include "z_buffer/analytic_z_buffer.hpp"
#include "z_buffer/placement.hpp"
#include "z_buffer/triangle_z_buffer.hpp"

namespace bench {
namespace {

constexpr size_t many_directions = 16;
constexpr size_t few_directions = 4;  // for sets so large that a frame takes long
constexpr int meridians = 10;
constexpr int bands = 6;

// Hands out the directions one after the other to one of the parts that take turns: all parts have the same ones in the
// same order.
class Turns {
 public:
  explicit Turns(const std::vector<Direction> &directions) : directions_(&directions) {}

  const Direction &next() {
    const Direction &direction = (*directions_)[turn_];
    turn_ = (turn_ + 1) % directions_->size();
    return direction;
  }

 private:
  const std::vector<Direction> *directions_;
  size_t turn_ = 0;
};

// Sets counters to means over all directions.
void count(benchmark::State &state, View &view, const std::vector<Direction> &directions, const char *pieces,
           bool picture) {
  double arcs = 0;
  double balls = 0;
  double bytes = 0;
  for (const Direction &direction : directions) {
    view.compute(direction);
    arcs += view.info().arcs;
    balls += view.info().pieces;
    if (picture) bytes += static_cast<double>(view.write_picture());
  }
  const double number = static_cast<double>(directions.size());
  state.counters[std::string(pieces) + "_arcs"] = arcs / number;
  state.counters[std::string(pieces) + "_pieces"] = balls / number;
  if (picture) state.counters["picture_bytes"] = bytes / number;
}

// with_drawing: the z-buffer of triangles and the picture as well.
void frames(benchmark::State &state, const Subject &subject, size_t number, bool with_drawing) {
  const std::vector<Direction> directions = spread_directions(number);
  View h(*subject.model, subject.boundary.get(), HSP_PIECES_OUTSIDE_ALL, directions);
  View g(*subject.model, subject.boundary.get(), HSP_PIECES_OUTSIDE_FARTHER, directions);
  View g_alone(*subject.model, nullptr, HSP_PIECES_OUTSIDE_FARTHER, directions);
  count(state, h, directions, "h", false);
  count(state, g, directions, "g", true);
  count(state, g_alone, directions, "g_alone", false);

  Placement placement(subject.balls.xyz, subject.balls.radius);
  AnalyticZBuffer analytic;
  TriangleZBuffer triangles(meridians, bands);
  Turns analytic_turns(directions), triangle_turns(directions);
  Turns h_turns(directions), g_turns(directions), g_alone_turns(directions);
  std::vector<Part> parts{
      {"analytic", [&] { analytic.draw(placement.place(axes_towards(analytic_turns.next()))); }},
      {"h", [&] { h.compute(h_turns.next()); }},
      {"g", [&] { g.compute(g_turns.next()); }},
      {"g_alone", [&] { g_alone.compute(g_alone_turns.next()); }},
  };
  if (with_drawing) {
    parts.push_back({"picture", [&] { benchmark::DoNotOptimize(g.write_picture()); }});
    parts.push_back({"triangle", [&] {
                       const Axes axes = axes_towards(triangle_turns.next());
                       triangles.draw(placement.place(axes), axes);
                     }});
  }
  alternate(state, subject.model->size(), parts);
  benchmark::DoNotOptimize(analytic.owner(image_side / 2, image_side / 2));
  benchmark::DoNotOptimize(triangles.owner(image_side / 2, image_side / 2));
}

void register_frames(const std::string &name, const SubjectRecipe &recipe, size_t directions, bool with_drawing) {
  register_case(
      name, recipe,
      [=](benchmark::State &state, const Subject &subject) { frames(state, subject, directions, with_drawing); })
      ->Unit(benchmark::kMicrosecond)
      ->Iterations(static_cast<benchmark::IterationCount>(directions));
}

}  // namespace

void register_suite() {
  for (const Molecule &molecule : paper_molecules()) {
    const SubjectRecipe recipe{"section_5_1/" + molecule.name,
                               [molecule] { return with_radii(molecule, Radii::paper); }, 0, Stage::boundary};
    register_frames("section_5_1/" + molecule.name, recipe, many_directions, true);
  }
  const size_t molecules = molecule_sizes().size();
  size_t done = 0;
  for (const Size &size : all_sizes()) {
    const SubjectRecipe recipe{"frames/" + size.name, size.balls, 0, Stage::boundary};
    register_frames("frames/" + size.name, recipe, done <= molecules ? many_directions : few_directions, false);
    ++done;
  }
}

}  // namespace bench
