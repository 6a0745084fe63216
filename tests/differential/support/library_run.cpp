#include "library_run.hpp"

#include <stdexcept>
#include <string>

namespace {

template <class Record, class Getter>
std::vector<Record> all_records(const hsp_boundary *boundary, Getter getter, const char *call) {
  uint32_t needed = 0;
  const int32_t status = getter(boundary, nullptr, 0, &needed);
  if (status != (needed == 0 ? HSP_OK : HSP_E_CAPACITY)) expect_ok(status, call);
  std::vector<Record> records(needed);
  expect_ok(getter(boundary, records.data(), needed, &needed), call);
  return records;
}

void require(bool condition, const char *what) {
  if (!condition) throw std::runtime_error(std::string("the library contradicts itself: ") + what);
}

}  // namespace

void expect_ok(int32_t status, const char *call) {
  if (status != HSP_OK) throw std::runtime_error(std::string(call) + ": " + hsp_status_text(status));
}

LibraryModel::LibraryModel(const oracle::Balls &balls, double step, double probe)
    : balls_(static_cast<uint32_t>(balls.size())) {
  size_t bytes = 0;
  expect_ok(hsp_model_bytes(balls_, &bytes), "hsp_model_bytes");
  memory_.resize(bytes);
  expect_ok(hsp_model_init(memory_.data(), bytes, balls_, &model_), "hsp_model_init");
  std::vector<double> xyz;
  std::vector<double> radius;
  for (const oracle::LatticeBall &ball : balls) {
    for (const int64_t coordinate : {ball.x, ball.y, ball.z}) xyz.push_back(static_cast<double>(coordinate) * step);
    radius.push_back(static_cast<double>(ball.radius) * step);
  }
  hsp_model_options options;
  expect_ok(hsp_model_options_init(&options, sizeof options), "hsp_model_options_init");
  options.step = step;
  options.probe = probe;
  expect_ok(hsp_model_set(model_, balls_, xyz.data(), radius.data(), &options, nullptr), "hsp_model_set");
}

LibraryBoundary::LibraryBoundary(const oracle::Balls &balls, double step, double probe) : model_(balls, step, probe) {
  hsp_boundary_limits limits;
  expect_ok(hsp_boundary_limits_init(&limits, sizeof limits, model_.balls()), "hsp_boundary_limits_init");
  // Two enlargements must do.
  for (int attempt = 0; attempt < 3; ++attempt) {
    size_t bytes = 0;
    expect_ok(hsp_boundary_bytes(&limits, &bytes), "hsp_boundary_bytes");
    memory_.assign(bytes, 0);
    expect_ok(hsp_boundary_init(memory_.data(), bytes, &limits, &boundary_), "hsp_boundary_init");
    const int32_t status = hsp_boundary_compute(boundary_, model_.handle());
    if (status != HSP_E_CAPACITY || attempt == 2) {
      expect_ok(status, "hsp_boundary_compute");
      return;
    }
    hsp_boundary_limits needed;
    expect_ok(hsp_boundary_get_needed(boundary_, &needed), "hsp_boundary_get_needed");
    if (needed.balls > limits.balls) limits.balls = needed.balls;
    if (needed.neighbours > limits.neighbours) limits.neighbours = needed.neighbours;
    if (needed.vertices > limits.vertices) limits.vertices = needed.vertices;
    if (needed.circles > limits.circles) limits.circles = needed.circles;
  }
}

hsp_boundary_counts LibraryBoundary::counts() const {
  hsp_boundary_counts counts;
  expect_ok(hsp_boundary_get_counts(boundary_, &counts), "hsp_boundary_get_counts");
  return counts;
}

std::vector<hsp_vertex> LibraryBoundary::vertices() const {
  return all_records<hsp_vertex>(boundary_, hsp_boundary_get_vertices, "hsp_boundary_get_vertices");
}
std::vector<hsp_arc> LibraryBoundary::arcs() const {
  return all_records<hsp_arc>(boundary_, hsp_boundary_get_arcs, "hsp_boundary_get_arcs");
}
std::vector<hsp_circle> LibraryBoundary::circles() const {
  return all_records<hsp_circle>(boundary_, hsp_boundary_get_circles, "hsp_boundary_get_circles");
}
std::vector<hsp_face> LibraryBoundary::faces() const {
  return all_records<hsp_face>(boundary_, hsp_boundary_get_faces, "hsp_boundary_get_faces");
}
std::vector<hsp_ball> LibraryBoundary::balls() const {
  return all_records<hsp_ball>(boundary_, hsp_boundary_get_balls, "hsp_boundary_get_balls");
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
  expect_ok(
      hsp_boundary_measure(boundary_, &measures.totals, measures.area.data(), measures.volume.data(), model_.balls()),
      "hsp_boundary_measure");
  return measures;
}
