#include "view_run.hpp"

#include <algorithm>
#include <sstream>

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
  text << (pieces == HSP_PIECES_OUTSIDE_FARTHER ? "G" : "H") << "-pieces" << (boundary ? " with boundary" : "")
       << ((flags & HSP_VIEW_ALL_BALLS) != 0 ? " of all balls" : "") << " from (" << towards[0] << ", " << towards[1]
       << ", " << towards[2] << "), up (" << up[0] << ", " << up[1] << ", " << up[2] << ")";
  return text.str();
}

std::vector<ViewChoice> all_choices(const Direction &towards, const Direction &up) {
  std::vector<ViewChoice> choices;
  for (const uint32_t flags : {UINT32_C(0), HSP_VIEW_ALL_BALLS}) {
    choices.push_back({HSP_PIECES_OUTSIDE_FARTHER, flags, false, towards, up});
    choices.push_back({HSP_PIECES_OUTSIDE_FARTHER, flags, true, towards, up});
    choices.push_back({HSP_PIECES_OUTSIDE_ALL, flags, true, towards, up});
  }
  return choices;
}

LibraryScene::LibraryScene(const oracle::Balls &balls, double step, double probe)
    : boundary_(balls, step, probe), balls_(oracle::plain_balls(balls, step)) {
  for (oracle::PlainBall &ball : balls_) ball.radius += probe;
}

oracle::ViewAxes ViewRecords::axes() const {
  return {std::to_array(info.origin), std::to_array(info.right), std::to_array(info.up), std::to_array(info.towards)};
}

std::vector<oracle::Path> ViewRecords::paths() const {
  std::vector<oracle::Path> result;
  for (const hsp_view_piece &piece : pieces) {
    result.emplace_back();
    for (uint32_t k = 0; k < piece.arcs; ++k) {
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

LibraryView::LibraryView(const LibraryScene &scene, const ViewChoice &choice) {
  const hsp_view_options options = choice.options();
  const hsp_boundary *boundary = choice.boundary ? scene.boundary() : nullptr;
  view_.take(support::default_view_limits(static_cast<uint32_t>(scene.balls().size())));
  view_.compute([&](hsp_view *view, hsp_view_limits *limits) {
    return hsp_view_compute(view, scene.model(), boundary, &options, limits);
  });
}

ViewRecords LibraryView::records() const {
  const auto of_view = [this](auto getter) { return [=, this](auto... out) { return getter(handle(), out...); }; };
  ViewRecords records;
  expect_ok(hsp_view_get_info(handle(), &records.info), "hsp_view_get_info");
  records.pieces = support::all_records<hsp_view_piece>(of_view(hsp_view_get_pieces), "hsp_view_get_pieces");
  records.loops = support::all_records<hsp_view_loop>(of_view(hsp_view_get_loops), "hsp_view_get_loops");
  records.arcs = support::all_records<hsp_view_arc>(of_view(hsp_view_get_arcs), "hsp_view_get_arcs");
  return records;
}

ViewRecords view_of(const LibraryScene &scene, const ViewChoice &choice) {
  return LibraryView(scene, choice).records();
}
