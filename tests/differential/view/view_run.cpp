#include "view_run.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace {

template <class Record, class Getter>
std::vector<Record> all_records(const hsp_view *view, Getter getter, const char *call) {
  std::uint32_t needed = 0;
  const std::int32_t status = getter(view, nullptr, 0, &needed);
  if (status != (needed == 0 ? HSP_OK : HSP_E_CAPACITY)) {
    expect_ok(status, call);
    throw std::runtime_error(std::string(call) + ": a capacity of 0 was accepted");
  }
  std::vector<Record> records(needed);
  expect_ok(getter(view, records.data(), needed, &needed), call);
  return records;
}

}  // namespace

hsp_view_options ViewChoice::options() const {
  hsp_view_options options;
  expect_ok(hsp_view_options_init(&options, sizeof options), "hsp_view_options_init");
  options.pieces = pieces;
  options.flags = flags;
  std::copy(towards.begin(), towards.end(), options.towards);
  std::copy(up.begin(), up.end(), options.up);
  return options;
}

std::string ViewChoice::text() const {
  std::ostringstream text;
  text.precision(17);
  text << (pieces == HSP_PIECES_G ? "G" : "H") << "-pieces" << (boundary ? " with boundary" : "")
       << ((flags & HSP_VIEW_ALL_BALLS) != 0 ? " of all balls" : "") << " from (" << towards[0] << ", " << towards[1]
       << ", " << towards[2] << "), up (" << up[0] << ", " << up[1] << ", " << up[2] << ")";
  return text.str();
}

std::vector<ViewChoice> all_choices(const Direction &towards, const Direction &up) {
  std::vector<ViewChoice> choices;
  for (const std::uint32_t flags : {UINT32_C(0), HSP_VIEW_ALL_BALLS}) {
    choices.push_back({HSP_PIECES_G, flags, false, towards, up});
    choices.push_back({HSP_PIECES_G, flags, true, towards, up});
    choices.push_back({HSP_PIECES_H, flags, true, towards, up});
  }
  return choices;
}

LibraryScene::LibraryScene(const oracle::Balls &balls, double step, double probe)
    : model_(balls, step, probe), balls_(oracle::plain_balls(balls, step)) {
  for (oracle::PlainBall &ball : balls_) ball.radius += probe;
  hsp_boundary_limits limits;
  expect_ok(hsp_boundary_limits_init(&limits, sizeof limits, model_.balls()), "hsp_boundary_limits_init");
  for (int attempt = 0;; ++attempt) {
    std::size_t bytes = 0;
    expect_ok(hsp_boundary_bytes(&limits, &bytes), "hsp_boundary_bytes");
    memory_.assign(bytes, 0);
    expect_ok(hsp_boundary_init(memory_.data(), bytes, &limits, &boundary_), "hsp_boundary_init");
    const std::int32_t status = hsp_boundary_compute(boundary_, model_.handle());
    if (status != HSP_E_CAPACITY || attempt == 2) {
      expect_ok(status, "hsp_boundary_compute");
      return;
    }
    hsp_boundary_limits needed;
    expect_ok(hsp_boundary_get_needed(boundary_, &needed), "hsp_boundary_get_needed");
    limits.neighbours = std::max(limits.neighbours, needed.neighbours);
    limits.vertices = std::max(limits.vertices, needed.vertices);
    limits.circles = std::max(limits.circles, needed.circles);
  }
}

oracle::ViewAxes ViewRecords::axes() const {
  return {std::to_array(info.origin), std::to_array(info.right), std::to_array(info.up), std::to_array(info.towards)};
}

std::vector<oracle::Path> ViewRecords::paths() const {
  std::vector<oracle::Path> result;
  for (const hsp_view_piece &piece : pieces) {
    result.emplace_back();
    for (std::uint32_t k = 0; k < piece.arcs; ++k) {
      const hsp_view_arc &arc = arcs.at(piece.first_arc + k);
      result.back().push_back({std::to_array(arc.centre), std::to_array(arc.semi_axis), arc.rotation, arc.from, arc.to,
                               std::to_array(arc.start), std::to_array(arc.end)});
    }
  }
  return result;
}

double area_of(const oracle::Path &path) {
  double area = 0;
  for (const oracle::PathArc &arc : path) area += arc.swept_area();
  return area;
}

ViewRecords view_of(const LibraryScene &scene, const ViewChoice &choice) {
  const hsp_view_options options = choice.options();
  hsp_view_limits limits;
  const auto n = static_cast<std::uint32_t>(scene.balls().size());
  expect_ok(hsp_view_limits_init(&limits, sizeof limits, n), "hsp_view_limits_init");
  std::vector<unsigned char> memory;
  hsp_view *view = nullptr;
  for (int attempt = 0;; ++attempt) {
    std::size_t bytes = 0;
    expect_ok(hsp_view_bytes(&limits, &bytes), "hsp_view_bytes");
    memory.assign(bytes, 0);
    expect_ok(hsp_view_init(memory.data(), bytes, &limits, &view), "hsp_view_init");
    const std::int32_t status =
        hsp_view_compute(view, scene.model(), choice.boundary ? scene.boundary() : nullptr, &options);
    hsp_view_limits needed;
    if (status != HSP_E_CAPACITY || attempt == 3) {
      expect_ok(status, "hsp_view_compute");
      expect_ok(hsp_view_get_needed(view, &needed), "hsp_view_get_needed");
      break;
    }
    expect_ok(hsp_view_get_needed(view, &needed), "hsp_view_get_needed");
    limits.balls = std::max(limits.balls, needed.balls);
    limits.neighbours = std::max(limits.neighbours, needed.neighbours);
    limits.arcs = std::max(limits.arcs, needed.arcs);
  }
  ViewRecords records;
  expect_ok(hsp_view_get_info(view, &records.info), "hsp_view_get_info");
  records.pieces = all_records<hsp_view_piece>(view, hsp_view_get_pieces, "hsp_view_get_pieces");
  records.loops = all_records<hsp_view_loop>(view, hsp_view_get_loops, "hsp_view_get_loops");
  records.arcs = all_records<hsp_view_arc>(view, hsp_view_get_arcs, "hsp_view_get_arcs");
  return records;
}
