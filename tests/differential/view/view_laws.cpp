#include "view_laws.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <sstream>

#include "exact_depth.hpp"
#include "random_balls.hpp"

namespace {

using oracle::Balls;
using oracle::PlainBall;

std::string number(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

double product(const Direction &a, const Direction &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Direction cross(const Direction &a, const Direction &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Direction unit(const Direction &v) {
  const double length = std::sqrt(product(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

double distance(const Direction &a, const Direction &b) {
  const Direction v = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  return std::sqrt(product(v, v));
}

bool is_zero(const Direction &v) {
  return v == Direction{};
}

/// The largest view coordinate of any point of a ball: what rounding is measured by.
double extent_of(const std::vector<PlainBall> &seen) {
  double extent = 0;
  for (const PlainBall &ball : seen)
    for (const double coordinate : ball.centre) extent = std::max(extent, std::abs(coordinate) + ball.radius);
  return extent;
}

/// +1 if a ball lies inside a larger one without touching its sphere, 0 if it touches it from inside, else -1.
int depth_inside(const oracle::LatticeBall &inner, const oracle::LatticeBall &outer) {
  const oracle::Vector v = oracle::centre_difference(inner, outer);
  const oracle::Int128 gap = oracle::Int128{outer.radius} - inner.radius;
  return gap > 0 ? oracle::sign_of(gap * gap - oracle::dot(v, v)) : -1;
}

}  // namespace

std::string axes_disagree(const ViewRecords &view, const ViewChoice &choice) {
  const oracle::ViewAxes axes = view.axes();
  if (std::abs(product(axes.up, axes.up) - 1) > 1e-14 || std::abs(product(axes.towards, axes.towards) - 1) > 1e-14 ||
      std::abs(product(axes.up, axes.towards)) > 1e-14 || distance(cross(axes.up, axes.towards), axes.right) > 1e-14)
    return "the axes are not orthonormal and right-handed";
  const Direction towards = is_zero(choice.towards) ? Direction{0, 0, 1} : unit(choice.towards);
  if (distance(towards, axes.towards) > 1e-8) return "the view is not from where the options say";
  // The first of these that is not parallel to the direction.
  for (const Direction &up : {choice.up, Direction{0, 1, 0}, Direction{0, 0, 1}}) {
    if (is_zero(up) || std::abs(product(cross(unit(up), towards), cross(unit(up), towards))) < 1e-10) continue;
    return distance(unit(cross(up, towards)), axes.right) > 1e-5 ? "up is not up" : "";
  }
  return "no direction was left for up";
}

std::string records_disagree(const ViewRecords &view, const LibraryScene &scene, const ViewChoice &choice) {
  const hsp_view_info &info = view.info;
  if (info.pieces != view.pieces.size() || info.loops != view.loops.size() || info.arcs != view.arcs.size() ||
      info.kind != choice.pieces)
    return "the numbers of hsp_view_info";
  const std::vector<PlainBall> seen = oracle::seen_along(scene.balls(), view.axes());
  const double tolerance = 1e-12 * extent_of(seen);
  std::array<double, 2> low{};
  std::array<double, 2> high{};
  std::vector<bool> met(seen.size());
  std::uint32_t loop = 0;
  std::uint32_t arc = 0;
  for (std::uint32_t p = 0; p < view.pieces.size(); ++p) {
    const hsp_view_piece &piece = view.pieces[p];
    const std::string name = "piece " + std::to_string(p) + ": ";
    if (piece.ball >= seen.size() || met[piece.ball]) return name + "no such ball, or twice";
    met[piece.ball] = true;
    const PlainBall &ball = seen[piece.ball];
    if (!(piece.radius > 0) || piece.radius != scene.balls()[piece.ball].radius) return name + "its radius";
    if (distance({piece.centre[0], piece.centre[1], piece.depth}, ball.centre) > tolerance) return name + "its centre";
    if (piece.first_loop != loop || piece.loops == 0 || piece.first_arc != arc || piece.arcs == 0 ||
        piece.reserved != 0)
      return name + "its loops or arcs do not follow those before";
    for (std::uint32_t k = 0; k < piece.loops; ++k, ++loop) {
      if (loop >= view.loops.size()) return name + "loops are missing";
      const hsp_view_loop &record = view.loops[loop];
      if (record.piece != p || record.first_arc != arc || record.arcs == 0 || record.reserved != 0)
        return "loop " + std::to_string(loop) + " does not follow those before";
      arc += record.arcs;
    }
    if (arc != piece.first_arc + piece.arcs || arc > view.arcs.size()) return name + "its arcs are not its loops'";
    for (std::uint32_t k = piece.first_arc; k < arc; ++k)
      if (view.arcs[k].piece != p) return "arc " + std::to_string(k) + " belongs elsewhere";
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = p == 0 ? piece.centre[k] - piece.radius : std::min(low[k], piece.centre[k] - piece.radius);
      high[k] = p == 0 ? piece.centre[k] + piece.radius : std::max(high[k], piece.centre[k] + piece.radius);
    }
  }
  if (loop != view.loops.size() || arc != view.arcs.size()) return "loops or arcs without piece";
  for (std::size_t k = 0; k < 2; ++k)
    if (std::abs(low[k] - info.low[k]) > tolerance || std::abs(high[k] - info.high[k]) > tolerance)
      return "the box of hsp_view_info";
  const double depth_low = view.pieces.empty() ? 0 : view.pieces.front().depth;
  const double depth_high = view.pieces.empty() ? 0 : view.pieces.back().depth;
  if (std::abs(info.depth_low - depth_low) > tolerance || std::abs(info.depth_high - depth_high) > tolerance)
    return "the depths of hsp_view_info";
  return "";
}

std::string arcs_disagree(const ViewRecords &view, const LibraryScene &scene) {
  const std::vector<PlainBall> seen = oracle::seen_along(scene.balls(), view.axes());
  const std::vector<oracle::Path> paths = view.paths();
  constexpr double pi = std::numbers::pi;
  for (std::size_t l = 0; l < view.loops.size(); ++l) {
    const hsp_view_loop &loop = view.loops[l];
    for (std::uint32_t k = 0; k < loop.arcs; ++k) {
      const hsp_view_arc &next = view.arcs[loop.first_arc + (k + 1) % loop.arcs];
      const hsp_view_arc &arc = view.arcs[loop.first_arc + k];
      if (std::memcmp(arc.end, next.start, sizeof arc.end) != 0) return "loop " + std::to_string(l) + " is not closed";
      if (loop.arcs == 1 && std::abs(arc.to - arc.from) != 2 * pi)
        return "loop " + std::to_string(l) + " of one arc is not whole: " + number(arc.to - arc.from);
    }
  }
  for (std::size_t a = 0; a < view.arcs.size(); ++a) {
    const hsp_view_arc &arc = view.arcs[a];
    const hsp_view_piece &piece = view.pieces[arc.piece];
    const PlainBall &ball = seen[piece.ball];
    const std::string name = "arc " + std::to_string(a) + " of ball " + std::to_string(piece.ball) + ": ";
    const double r = piece.radius;
    if (!(arc.semi_axis[0] >= arc.semi_axis[1] && arc.semi_axis[1] >= 0 && arc.semi_axis[0] <= r * (1 + 1e-12)))
      return name + "its semi-axes " + number(arc.semi_axis[0]) + " " + number(arc.semi_axis[1]);
    if (!(arc.rotation > -pi && arc.rotation <= pi)) return name + "its rotation " + number(arc.rotation);
    if (!(std::abs(arc.from) <= 2 * pi && std::abs(arc.to - arc.from) <= 2 * pi))
      return name + "its parameters " + number(arc.from) + " " + number(arc.to);
    const oracle::PathArc &path = paths[arc.piece][a - piece.first_arc];
    const auto off = [](const std::array<double, 2> &p, const std::array<double, 2> &q) {
      return std::hypot(p[0] - q[0], p[1] - q[1]);
    };
    if (off(path.at(arc.from), path.start) > 1e-9 * r || off(path.at(arc.to), path.end) > 1e-9 * r)
      return name + "its ends are off by " +
             number(std::max(off(path.at(arc.from), path.start), off(path.at(arc.to), path.end)));
    if (arc.across == HSP_NONE) {
      if (off(path.centre, {piece.centre[0], piece.centre[1]}) > 1e-12 * r || path.semi_axis[0] != r ||
          path.semi_axis[1] != r)
        return name + "not the silhouette";
      continue;
    }
    if (arc.across >= seen.size() || arc.across == piece.ball) return name + "no such ball across";
    const PlainBall &other = seen[arc.across];
    for (const double part : {0.1, 0.5, 0.8}) {
      const std::array<double, 2> p = path.at(arc.from + part * (arc.to - arc.from));
      const double square = r * r - std::pow(off(p, {ball.centre[0], ball.centre[1]}), 2);
      if (square < -1e-9 * r * r) return name + "outside the disc";
      const double z = ball.centre[2] + std::sqrt(std::max(square, 0.0));
      const double error = distance({p[0], p[1], z}, other.centre) - other.radius;
      if (std::abs(error) > 1e-6 * r)
        return name + "off the front or the sphere of ball " + std::to_string(arc.across) + " by " + number(error);
    }
  }
  return "";
}

std::string areas_disagree(const ViewRecords &view) {
  const std::vector<oracle::Path> paths = view.paths();
  for (std::size_t p = 0; p < paths.size(); ++p) {
    const double area = area_of(paths[p]);
    const double square = view.pieces[p].radius * view.pieces[p].radius;
    // What is thinner than rounding may have any sign.
    if (!(area > -1e-12 * square && area <= square * std::numbers::pi * (1 + 1e-12)))
      return "the piece of ball " + std::to_string(view.pieces[p].ball) + " has the area " + number(area);
  }
  return "";
}

std::string depths_disagree(const ViewRecords &view, const Balls &balls, const ViewChoice &choice) {
  const std::array<std::int64_t, 3> direction = integer_direction(choice.towards);
  for (std::size_t p = 1; p < view.pieces.size(); ++p) {
    const std::uint32_t a = view.pieces[p - 1].ball;
    const std::uint32_t b = view.pieces[p].ball;
    if (!is_farther(balls[a], balls[b], direction))
      return "ball " + std::to_string(a) + " is painted before ball " + std::to_string(b);
  }
  for (const hsp_view_piece &piece : view.pieces)
    for (std::size_t k = 0; k < balls.size(); ++k)
      if (depth_inside(balls[piece.ball], balls[k]) > 0)
        return "ball " + std::to_string(piece.ball) + " has a piece and is inside ball " + std::to_string(k);
  if (choice.pieces != HSP_PIECES_G) return "";
  for (const hsp_view_arc &arc : view.arcs)
    if (arc.across != HSP_NONE && !is_farther(balls[arc.across], balls[view.pieces[arc.piece].ball], direction))
      return "a G-piece of ball " + std::to_string(view.pieces[arc.piece].ball) + " is cut by the nearer ball " +
             std::to_string(arc.across);
  return "";
}

std::string members_disagree(const Balls &balls, std::size_t points, const Direction &towards, const Direction &up) {
  const LibraryScene scene(balls);
  std::vector<bool> contained(balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i)
    contained[i] = std::any_of(balls.begin(), balls.end(),
                               [&](const oracle::LatticeBall &other) { return depth_inside(balls[i], other) >= 0; });
  const std::array<std::int64_t, 3> direction = integer_direction(towards);
  std::vector<std::vector<bool>> farther(balls.size(), std::vector<bool>(balls.size()));  // [i][j]: j than i
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = 0; j < balls.size(); ++j) farther[i][j] = is_farther(balls[j], balls[i], direction);
  for (const ViewChoice &choice : {ViewChoice{HSP_PIECES_G, HSP_VIEW_ALL_BALLS, false, towards, up},
                                   ViewChoice{HSP_PIECES_H, HSP_VIEW_ALL_BALLS, true, towards, up}}) {
    const ViewRecords view = view_of(scene, choice);
    const std::vector<PlainBall> seen = oracle::seen_along(scene.balls(), view.axes());
    const double extent = extent_of(seen);
    std::vector<oracle::Path> path(balls.size());
    const std::vector<oracle::Path> paths = view.paths();
    for (std::size_t p = 0; p < paths.size(); ++p) path[view.pieces[p].ball] = paths[p];
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const double r = seen[i].radius;
      // Of balls that are there more than once, one stands for all.
      if (r == 0 || contained[i] || (path[i].empty() && std::count(balls.begin(), balls.end(), balls[i]) > 1)) continue;
      const double tolerance = 1e-6 * r + 1e-14 * extent;
      const auto along = [&](std::size_t step, double shift) {
        return r * (2 * (static_cast<double>(step) + shift) / static_cast<double>(points) - 1);
      };
      for (std::size_t row = 0; row < points; ++row) {
        const double y = seen[i].centre[1] + along(row, 0.3819660113);
        const std::vector<oracle::Crossing> crossings = oracle::crossings(path[i], y);
        for (std::size_t column = 0; column < points; ++column) {
          const double x = seen[i].centre[0] + along(column, 0.5698402910);
          const double z = oracle::front_of(seen[i], x, y);
          if (!std::isfinite(z)) continue;
          bool covered = false;
          bool unknown = false;
          for (std::size_t j = 0; j < balls.size(); ++j) {
            if (j == i || balls[j] == balls[i] || (choice.pieces == HSP_PIECES_G && !farther[i][j])) continue;
            const double beyond = distance({x, y, z}, seen[j].centre) - seen[j].radius;
            if (std::abs(beyond) < tolerance || (beyond < 0 && contained[j]))
              unknown = true;
            else if (beyond < 0)
              covered = true;
          }
          int times = 0;
          for (const oracle::Crossing &crossing : crossings) times -= crossing.x < x ? crossing.up : 0;
          const bool right = covered ? times == 0 : times == 1 || (unknown && times == 0);
          if (right || oracle::passes_near(path[i], x, y, tolerance)) continue;
          return choice.text() + ": the piece of ball " + std::to_string(i) + " runs " + std::to_string(times) +
                 " times around (" + number(x) + ", " + number(y) + "), which is " + (covered ? "covered" : "free");
        }
      }
    }
  }
  return "";
}

std::string view_laws_broken(const Balls &balls, const Direction &towards, const Direction &up) {
  const LibraryScene scene(balls);
  for (const ViewChoice &choice : all_choices(towards, up)) {
    const ViewRecords view = view_of(scene, choice);
    // Each relies on those before.
    std::string text = records_disagree(view, scene, choice);
    if (text.empty()) text = axes_disagree(view, choice);
    if (text.empty()) text = arcs_disagree(view, scene);
    if (text.empty()) text = areas_disagree(view);
    if (text.empty()) text = depths_disagree(view, balls, choice);
    if (!text.empty()) return choice.text() + ": " + text;
  }
  return "";
}

std::string view_orders_disagree(const Balls &balls, const Direction &towards, const Direction &up) {
  const LibraryScene scene(balls);
  oracle::RandomSource random(balls.size());
  for (int attempt = 0; attempt < 2; ++attempt) {
    std::vector<std::uint32_t> order = random.permutation(balls.size());
    const Balls permuted = oracle::permuted(balls, order);
    const LibraryScene other_scene(permuted);
    for (const ViewChoice &choice : all_choices(towards, up)) {
      const ViewRecords one = view_of(scene, choice);
      ViewRecords other = view_of(other_scene, choice);
      const auto differ = [&](const char *what) { return choice.text() + ": " + what + " depend on the order"; };
      if (one.pieces.size() != other.pieces.size()) return differ("the balls that have a piece");
      if (std::memcmp(&one.info, &other.info, sizeof one.info) != 0) return differ("the numbers of hsp_view_info");
      // An id may become that of the same ball in its other place.
      const auto translate = [&](std::uint32_t &id, std::uint32_t own) {
        if (id < permuted.size() && own < balls.size() && permuted[id] == balls[own]) id = own;
      };
      for (std::size_t p = 0; p < one.pieces.size(); ++p) {
        translate(other.pieces[p].ball, one.pieces[p].ball);
        if (std::memcmp(&one.pieces[p], &other.pieces[p], sizeof one.pieces[p]) != 0) return differ("pieces");
      }
      for (std::size_t l = 0; l < one.loops.size(); ++l)
        if (std::memcmp(&one.loops[l], &other.loops[l], sizeof one.loops[l]) != 0) return differ("loops");
      for (std::size_t a = 0; a < one.arcs.size(); ++a) {
        translate(other.arcs[a].across, one.arcs[a].across);
        if (std::memcmp(&one.arcs[a], &other.arcs[a], sizeof one.arcs[a]) != 0) return differ("arcs");
      }
    }
  }
  return "";
}

std::string opposite_areas_disagree(const Balls &balls, const Direction &towards) {
  const LibraryScene scene(balls);
  const auto area_from = [&](const Direction &direction) {
    const ViewRecords view = view_of(scene, {HSP_PIECES_H, HSP_VIEW_ALL_BALLS, true, direction, {}});
    double area = 0;
    for (const oracle::Path &path : view.paths()) area += area_of(path);
    return area;
  };
  const double front = area_from(towards);
  const double back = area_from({-towards[0], -towards[1], -towards[2]});
  if (std::abs(front - back) <= 1e-10 * (front + back)) return "";
  return "the front has the area " + number(front) + ", the back " + number(back);
}
