#include "built_sticks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <utility>

#include "lattice_lengths.hpp"
#include "maps/edge_geometry.hpp"
#include "maps/map_check.hpp"
#include "maps/map_queries.hpp"
#include "maps/stick_outlines.hpp"
#include "maps/strand_lines.hpp"
#include "path_painter.hpp"

BuiltSticks::BuiltSticks(const oracle::Balls &balls, std::vector<Ends> ends, double radius,
                         const std::array<double, 3> &towards, bool whole, bool as_map,
                         std::vector<hsp::StickStrands> strands)
    : grid_(oracle::in_lengths(balls, 1)),
      ends_(std::move(ends)),
      radius_(radius),
      whole_(whole),
      as_map_(as_map),
      strands_(std::move(strands)) {
  status_ = grid_.status();
  if (status_ != hsp::Status::ok) return;
  take({static_cast<uint32_t>(balls.size()), 0, 16});
  look(towards);
}

hsp::Status BuiltSticks::build(const std::array<double, 3> &towards) {
  return builder_.build(balls(), {{towards[0], towards[1], towards[2]}, {0, 1, 0}}, static_cast<uint32_t>(ends_.size()),
                        radius_, as_map_, [this](uint32_t k) {
                          return hsp::StickEnds{ends_[k][0], ends_[k][1], whole_, strands_of(k)};
                        });
}

void BuiltSticks::look(const std::array<double, 3> &towards) {
  for (int left = 12;; --left) {
    status_ = build(towards);
    if (status_ != hsp::Status::capacity || left == 0) return;
    take(builder_.retry_limits());
  }
}

StickModel sticks_between_close(oracle::Balls atoms, double part) {
  StickModel model{std::move(atoms), {}};
  for (uint32_t i = 0; i < model.balls.size(); ++i)
    for (uint32_t j = 0; j < i; ++j) {
      const oracle::LatticeBall &a = model.balls[i], &b = model.balls[j];
      const double distance =
          std::hypot(static_cast<double>(a.x - b.x), static_cast<double>(a.y - b.y), static_cast<double>(a.z - b.z));
      if (distance < 0.6 * static_cast<double>(a.radius + b.radius)) model.ends.push_back({i, j});
    }
  for (oracle::LatticeBall &ball : model.balls) ball.radius = std::llround(part * static_cast<double>(ball.radius));
  return model;
}

std::string BuiltSticks::violation() const {
  const hsp::StickViolation &violation = builder_.violation();
  return std::to_string(static_cast<int>(violation.conflict)) + " " + std::to_string(violation.first) + " " +
         std::to_string(violation.second);
}

uint32_t plain_name(const BuiltSticks &built, uint32_t ball, uint32_t stick) {
  const hsp::BallSet &balls = built.balls();
  if (stick == hsp::no_id) return balls.caller[ball];
  const uint32_t k = built.view().sticks[stick].caller;
  return balls.n + 2 * k + (balls.caller[ball] == built.ends()[k][0] ? 0 : 1);
}

namespace {

// Adds the strands of a stick, whose places and widths are documented as shares of the stick's radius. Each strand
// begins where its own cylinder, aside of the stick's axis, leaves the farther ball.
void add_strands(hsp::StickStrands kind, const oracle::PlainBall &foot, const oracle::PlainBall &top, bool turned,
                 double out, double in, oracle::PlainCylinder &cylinder) {
  const double length = std::hypot(cylinder.to[0] - cylinder.from[0], cylinder.to[1] - cylinder.from[1],
                                   cylinder.to[2] - cylinder.from[2]);
  const auto add = [&](double left, double right, bool dashed) {
    const double aside = (left + right) / 2 * cylinder.radius, own = (left - right) / 2 * cylinder.radius;
    if (dashed) {
      for (int dash = 0; dash < 4; ++dash) {
        const double step = (length - in - out) / 4;
        const double begin = out + (dash + 0.25) * step;
        cylinder.strands.push_back(
            {aside, own, begin / length, (begin + step / 2) / length, {top.centre[0], top.centre[1], top.radius}});
      }
      return;
    }
    const double leaves = std::sqrt(foot.radius * foot.radius - aside * aside - own * own) / length;
    cylinder.strands.push_back({aside, own, turned ? 0 : leaves, turned ? 1 - leaves : 1});
  };
  switch (kind) {
    case hsp::StickStrands::one:
      return;
    case hsp::StickStrands::three:
      add(0.21, -0.21, false), add(1, 0.58, false), add(-0.58, -1, false);
      return;
    default:
      add(1, 0.28, false), add(-0.28, -1, kind == hsp::StickStrands::dashed);
  }
}

}  // namespace

PlainSticks::PlainSticks(const BuiltSticks &built) : balls(built.balls().n) {
  const hsp::BallSet &given = built.balls();
  for (uint32_t i = 0; i < given.n; ++i) {
    const hsp::Vec3 centre = built.view().frame.centre_of(given, i);
    balls[given.caller[i]] = {{centre.x, centre.y, centre.z}, given.r[i]};
    largest = std::max(largest, given.r[i]);
  }
  for (const BuiltSticks::Ends &ends : built.ends()) {
    const oracle::PlainBall &one = balls[ends[0]], &two = balls[ends[1]];
    const double length =
        std::hypot(two.centre[0] - one.centre[0], two.centre[1] - one.centre[1], two.centre[2] - one.centre[2]);
    const hsp::StickStrands kind = built.strands_of(cylinders.size());
    const double radius = (kind == hsp::StickStrands::one ? 1 : 1.5) * built.radius();
    // The name changes in the middle between the planes in which the cylinder leaves the two balls.
    const double out = std::sqrt(one.radius * one.radius - radius * radius);
    const double in = std::sqrt(two.radius * two.radius - radius * radius);
    cylinders.push_back({one.centre, two.centre, radius, built.whole() ? 2 : (out + length - in) / (2 * length)});
    // Of two balls that are equally far away either one may be the foot.
    const bool level = std::abs(one.centre[2] - two.centre[2]) < 1e-9 * length;
    const bool turned = level ? built.view().sticks[static_cast<uint32_t>(cylinders.size() - 1)].turned != 0
                              : one.centre[2] > two.centre[2];
    if (!built.builder().map().exist) {
      add_strands(kind, turned ? two : one, turned ? one : two, turned, out, in, cylinders.back());
    }
  }
}

std::vector<oracle::SeenPixel> PlainSticks::image(const oracle::PixelGrid &grid) const {
  std::vector<oracle::SeenPixel> image = oracle::z_buffer(balls, grid);
  oracle::add_cylinders(cylinders, static_cast<uint32_t>(balls.size()), grid, image);
  return image;
}

namespace {

uint32_t name_of(const BuiltSticks &built, const hsp::StickPath &path) {
  return plain_name(built, path.ball, path.stick);
}

struct DrawnPath {
  oracle::Path arcs;
  std::vector<std::array<bool, 2>> ends;  // whether an arc is the first, or the last of a loop
  bool turned = false;                    // a minor axis is not a quarter turn ahead of the major one
};

DrawnPath path_of(const BuiltSticks &built, uint32_t path, hsp::PathPart part) {
  DrawnPath result;
  built.builder().paths().visit(built.balls(), path, part, [&](const hsp::ProjectedArc &arc, bool first, bool closes) {
    const hsp::ProjectedEllipse &e = arc.ellipse;
    result.arcs.push_back({{e.centre[0], e.centre[1]},
                           {std::hypot(e.major[0], e.major[1]), std::hypot(e.minor[0], e.minor[1])},
                           std::atan2(e.major[1], e.major[0]),
                           arc.from,
                           arc.to,
                           {arc.start[0], arc.start[1]},
                           {arc.end[0], arc.end[1]}});
    result.ends.push_back({first, closes});
    if (e.major[0] * e.minor[1] < e.major[1] * e.minor[0]) result.turned = true;
  });
  return result;
}

// The first fault of the arcs of one path: empty if it is closed and its arcs are sound.
std::string broken(const DrawnPath &path, double tolerance) {
  size_t first = 0;
  if (path.turned) return "a minor axis on the wrong side";
  for (size_t k = 0; k < path.arcs.size(); ++k) {
    const oracle::PathArc &arc = path.arcs[k];
    if (path.ends[k][0]) first = k;
    if (!path.ends[k][1] && k + 1 == path.arcs.size()) return "a loop without an end";
    if (arc.end != path.arcs[path.ends[k][1] ? first : k + 1].start) return "a path that is not closed";
    for (size_t axis = 0; axis < 2; ++axis) {
      if (std::abs(arc.at(arc.from)[axis] - arc.start[axis]) > tolerance) return "an arc that starts elsewhere";
      if (std::abs(arc.at(arc.to)[axis] - arc.end[axis]) > tolerance) return "an arc that ends elsewhere";
    }
    if (std::abs(arc.from) > 9.4248 || std::abs(arc.to) > 9.4248) return "parameters far beyond a turn";
  }
  return "";
}

size_t lines_between_strands(const hsp::StickMap &map, uint32_t path) {
  size_t count = 0;
  hsp::visit_strand_lines(map, path, {&count, [](void *context, const hsp::ProjectedArc &, bool, bool) {
                                        ++*static_cast<size_t *>(context);
                                      }});
  return count;
}

// Whether a line of a path runs along an edge of the map: between its vertices, bit for bit, and through its middle, as
// two edges may have the same ends.
bool runs_along(const oracle::PathArc &line, const hsp::StickMap &map, const hsp::MapEdge &edge) {
  const hsp::MapVertex &v = map.vertices[edge.vertex[0]], &w = map.vertices[edge.vertex[1]];
  if (line.start != std::array<double, 2>{v.x, v.y} || line.end != std::array<double, 2>{w.x, w.y}) return false;
  const hsp::Vec3 middle = map.scene.at(edge.body, edge.nearer, (edge.from + edge.to) / 2);
  const std::array<double, 2> at = line.at((line.from + line.to) / 2);
  return std::hypot(at[0] - middle.x, at[1] - middle.y) <= hsp::position_tolerance(map);
}

// Without the lines between strands, each edge of regions must be one line of a path, and there must be one or two
// outline arcs for each. And the areas of loops must sum to the areas within outlines.
std::string broken_lines(const BuiltSticks &built) {
  const hsp::StickMap &map = built.builder().map();
  if (!map.exist) return "";
  oracle::Path lines;
  size_t outlines = 0;
  double area = 0, swept = 0;
  for (uint32_t p = 0; p < map.owners; ++p) {
    // Those between strands come last.
    const oracle::Path arcs = path_of(built, p, hsp::PathPart::lines).arcs;
    const auto between = static_cast<std::ptrdiff_t>(lines_between_strands(map, p));
    lines.insert(lines.end(), arcs.begin(), arcs.end() - between);
    const DrawnPath outline = path_of(built, p, hsp::PathPart::outline);
    outlines += outline.arcs.size();
    for (const oracle::PathArc &arc : outline.arcs) swept += arc.swept_area();
  }
  for (const hsp::MapLoop &loop : map.loops.items()) area += loop.owner == hsp::no_id ? 0 : loop.area;
  if (std::abs(area - swept) > 1e-7 * area) return "areas of loops are not those of paths";
  if (lines.size() != map.edges.size()) return "lines that are missing, or drawn twice";
  if (outlines < lines.size() || outlines > 2 * lines.size()) return "outlines that are missing";
  for (const hsp::MapEdge &edge : map.edges.items()) {
    const auto line = std::find_if(lines.begin(), lines.end(),
                                   [&](const oracle::PathArc &arc) { return runs_along(arc, map, edge); });
    if (line == lines.end()) return "an edge without a line of its own";
    *line = lines.back();
    lines.pop_back();
  }
  return "";
}

double length_of(const oracle::Path &path) {
  double length = 0;
  for (const oracle::PathArc &arc : path)
    for (int k = 0; k < 16; ++k) {
      const auto from = arc.at(arc.from + (arc.to - arc.from) * k / 16);
      const auto to = arc.at(arc.from + (arc.to - arc.from) * (k + 1) / 16);
      length += std::hypot(to[0] - from[0], to[1] - from[1]);
    }
  return length;
}

// The fault of the records of a map: its invariants, and the areas of the faces of each body against pixels.
std::string broken_records(const BuiltSticks &built, const std::vector<oracle::Path> &paths,
                           const std::vector<uint32_t> &name, const oracle::PixelGrid &grid,
                           const std::vector<oracle::SeenPixel> &image) {
  const hsp::StickMap &map = built.builder().map();
  std::vector<uint32_t> scratch(2 * map.edges.size() + 1);
  const hsp::MapViolation violation = hsp::check_map(map, {scratch.data(), static_cast<uint32_t>(scratch.size())});
  if (violation.invariant != hsp::MapInvariant::none)
    return "invariant " + std::to_string(static_cast<int>(violation.invariant)) + " at " + std::to_string(violation.id);
  std::vector<double> area(map.scene.balls.size() + 2 * map.scene.sticks.size(), 0);
  for (const hsp::MapFace &face : map.faces.items())
    if (face.owner != hsp::no_id) area[face.owner] += face.area;
  std::vector<double> counted(area.size(), 0);
  for (const oracle::SeenPixel &pixel : image)
    if (pixel.ball != oracle::no_ball) counted[pixel.ball] += grid.side * grid.side;
  for (uint32_t p = 0; p < map.owners; ++p) {
    const double error = grid.side * length_of(paths[p]) + 8 * grid.side * grid.side;
    if (std::abs(area[map.owner_of(p)] - counted[name[p]]) > error)
      return "path " + std::to_string(p) + " has another area than its pixels";
  }
  return "";
}

// The library's answer at a point must be the body that the z-buffer has there, and a face that shows this body.
std::string broken_sight(const BuiltSticks &built, double x, double y, const oracle::SeenPixel &pixel,
                         double tolerance) {
  const hsp::StickMap &map = built.builder().map();
  const hsp::MapSight seen = hsp::sight_at(map, built.builder().sight(), x, y);
  const uint32_t face = hsp::face_at(map, seen.ball, x, y);
  if (face == hsp::no_id || map.faces[face].owner != seen.ball) return "no face, or another one's";
  if ((seen.ball == hsp::no_id) != (pixel.ball == oracle::no_ball)) return "something, or nothing";
  if (seen.ball == hsp::no_id) return "";
  for (uint32_t p = 0; p < map.owners; ++p)
    if (map.owner_of(p) == seen.ball && name_of(built, built.view().paths[p]) != pixel.ball) return "another body";
  return std::abs(seen.depth - pixel.depth) > tolerance ? "another depth" : "";
}

}  // namespace

std::string sticks_disagree(const BuiltSticks &built, size_t pixels) {
  std::ostringstream text;
  if (built.status() != hsp::Status::ok) {
    text << "status " << static_cast<int>(built.status()) << ", " << built.violation();
    return text.str();
  }
  const hsp::StickView &view = built.view();
  const hsp::BallSet &balls = built.balls();
  const PlainSticks plain(built);
  const double largest = plain.largest;
  const oracle::PixelGrid grid = oracle::grid_around(plain.balls, pixels);
  const std::vector<oracle::SeenPixel> image = plain.image(grid);

  const double moved = built.builder().map().perturbation;
  const double tolerance = built.builder().map().exist ? 1e-6 * largest : 1e-9 * largest + 1e-7;
  std::vector<oracle::Path> paths;
  std::vector<uint32_t> name;
  for (uint32_t p = 0; p < view.paths.size(); ++p) {
    const DrawnPath path = path_of(built, p, hsp::PathPart::outline);
    paths.push_back(path.arcs);
    name.push_back(name_of(built, view.paths[p]));
    const std::string fault = broken(path, tolerance);
    if (!fault.empty()) return fault + ", path " + std::to_string(p);
  }
  if (const std::string fault = broken_lines(built); !fault.empty()) return fault;
  const oracle::PaintedImage painted = oracle::painted(paths, grid);
  const auto near_edge = [&](uint32_t path, size_t pixel) {
    return path != oracle::no_ball && oracle::passes_near(paths[path], grid.x(pixel % grid.columns),
                                                          grid.y(pixel / grid.columns), 1e-6 * grid.side + 3 * moved);
  };
  size_t excluded = 0;
  for (const oracle::PaintedImage::Winding &winding : painted.windings) {
    if (near_edge(winding.path, winding.pixel)) continue;
    text << "path " << winding.path << " runs " << winding.times << " times around pixel " << winding.pixel;
    return text.str();
  }
  for (size_t k = 0; k < image.size(); ++k) {
    const uint32_t path = painted.non_zero[k];
    const uint32_t shown = path == oracle::no_ball ? oracle::no_ball : name[path];
    if (shown == image[k].ball) continue;
    bool close = std::abs(image[k].depth - image[k].runner_up) < 1e-8 * largest + 3 * moved;
    for (uint32_t p = 0; p < paths.size() && !close; ++p) close = near_edge(p, k);
    if (!close) {
      text << "pixel " << k << " (" << grid.x(k % grid.columns) << ", " << grid.y(k / grid.columns) << ") shows "
           << shown << " instead of " << image[k].ball << ", " << balls.n << " balls, depth " << image[k].depth
           << " over " << image[k].runner_up;
      return text.str();
    }
    ++excluded;
  }
  if (excluded > image.size() / 1000) return std::to_string(excluded) + " pixels excluded";
  if (!built.builder().map().exist) return "";
  if (const std::string fault = broken_records(built, paths, name, grid, image); !fault.empty()) return fault;
  for (size_t k = 0; k < image.size(); k += 97) {
    const double x = grid.x(k % grid.columns), y = grid.y(k / grid.columns);
    const std::string fault = broken_sight(built, x, y, image[k], 1e-3 * largest);
    bool close = std::abs(image[k].depth - image[k].runner_up) < 1e-8 * largest + 3 * moved;
    for (uint32_t p = 0; p < paths.size() && !close && !fault.empty(); ++p) close = near_edge(p, k);
    if (!fault.empty() && !close) return "pixel " + std::to_string(k) + " is found to show " + fault;
  }
  return "";
}
