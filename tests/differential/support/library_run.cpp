#include "library_run.hpp"

#include <stdexcept>
#include <string>

#include "lattice_lengths.hpp"

namespace {

void require(bool condition, const char *what) {
  if (!condition) throw std::runtime_error(std::string("the library contradicts itself: ") + what);
}

}  // namespace

LibraryModel::LibraryModel(const oracle::Balls &balls, double step, double probe)
    : balls_(static_cast<uint32_t>(balls.size())), model_(balls_) {
  hsp_model_options options;
  expect_ok(hsp_model_options_init(&options, sizeof options), "hsp_model_options_init");
  options.step = step;
  options.probe = probe;
  expect_ok(model_.set(oracle::in_lengths(balls, step), &options), "hsp_model_set");
}

LibraryBoundary::LibraryBoundary(const oracle::Balls &balls, double step, double probe) : model_(balls, step, probe) {
  boundary_.take(support::default_boundary_limits(model_.balls()));
  boundary_.compute([&](hsp_boundary *boundary, hsp_boundary_limits *limits) {
    return hsp_boundary_compute(boundary, model_.handle(), limits);
  });
}

hsp_boundary_counts LibraryBoundary::counts() const {
  hsp_boundary_counts counts;
  expect_ok(hsp_boundary_get_counts(boundary_.get(), &counts), "hsp_boundary_get_counts");
  return counts;
}

template <class Record, class Getter>
std::vector<Record> LibraryBoundary::records(Getter getter, const char *call) const {
  return support::all_records<Record>([&](auto... out) { return getter(boundary_.get(), out...); }, call);
}

std::vector<hsp_vertex> LibraryBoundary::vertices() const {
  return records<hsp_vertex>(hsp_boundary_get_vertices, "hsp_boundary_get_vertices");
}
std::vector<hsp_arc> LibraryBoundary::arcs() const {
  return records<hsp_arc>(hsp_boundary_get_arcs, "hsp_boundary_get_arcs");
}
std::vector<hsp_circle> LibraryBoundary::circles() const {
  return records<hsp_circle>(hsp_boundary_get_circles, "hsp_boundary_get_circles");
}
std::vector<hsp_face> LibraryBoundary::faces() const {
  return records<hsp_face>(hsp_boundary_get_faces, "hsp_boundary_get_faces");
}
std::vector<hsp_ball> LibraryBoundary::balls() const {
  return records<hsp_ball>(hsp_boundary_get_balls, "hsp_boundary_get_balls");
}

oracle::BoundaryRecord LibraryBoundary::record() const {
  oracle::BoundaryRecord record;
  for (const hsp_vertex &v : vertices())
    record.vertices.push_back({{v.ball[0], v.ball[1], v.ball[2]}, v.sign, (v.flags & HSP_VERTEX_TIED) != 0});
  for (const hsp_arc &a : arcs())
    record.arcs.push_back({{a.ball[0], a.ball[1]}, {a.vertex[0], a.vertex[1]}, {a.face[0], a.face[1]}});
  for (const hsp_circle &c : circles()) record.circles.push_back({{c.ball[0], c.ball[1]}, {c.face[0], c.face[1]}});
  uint32_t tied = 0;
  for (const auto &vertex : record.vertices) tied += vertex.tied ? 1U : 0U;
  uint32_t loops = 0;
  for (const hsp_face &f : faces()) {
    record.faces.push_back({f.ball, f.loops, f.shell});
    loops += f.loops;
  }
  uint32_t exposed = 0;
  uint32_t contained = 0;
  for (const hsp_ball &b : balls()) {
    const auto i = static_cast<uint32_t>(record.balls.size());
    for (uint32_t f = 0; f < b.faces; ++f)
      require(record.faces.at(b.first_face + f).ball == i, "a ball's faces are other balls'");
    require((b.faces == 0) == (b.first_face == HSP_NONE), "first_face");
    exposed += b.faces > 0 ? 1U : 0U;
    contained += (b.flags & HSP_BALL_CONTAINED) != 0 ? 1U : 0U;
    record.balls.push_back({(b.flags & HSP_BALL_CONTAINED) != 0, b.component});
  }
  const hsp_boundary_counts c = counts();
  require(c.balls == record.balls.size(), "number of balls");
  require(c.vertices == record.vertices.size(), "number of vertices");
  require(c.arcs == record.arcs.size(), "number of arcs");
  require(c.circles == record.circles.size(), "number of circles");
  require(c.faces == record.faces.size(), "number of faces");
  require(c.loops == loops, "number of loops");
  require(c.exposed_balls == exposed, "number of exposed balls");
  require(c.contained_balls == contained, "number of contained balls");
  require(c.tied_vertices == tied, "number of tied vertices");
  record.counts = {c.exposed_balls, c.contained_balls, c.loops,         c.shells,
                   c.components,    c.voids,           c.tied_vertices, c.euler};
  return record;
}

LibraryBoundary::Measures LibraryBoundary::measure() const {
  Measures measures;
  measures.area.resize(model_.balls());
  measures.volume.resize(model_.balls());
  expect_ok(hsp_boundary_measure(boundary_.get(), nullptr, &measures.totals, measures.area.data(),
                                 measures.volume.data(), model_.balls(), nullptr),
            "hsp_boundary_measure");
  return measures;
}
