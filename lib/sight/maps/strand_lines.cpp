#include "maps/strand_lines.hpp"

#include <initializer_list>

namespace hsp {
namespace {

// One side of a strand in the view plane: the points from + u e for u from low to high.
struct StrandSide {
  double from[2], e[2];
  double low, high;

  double along(double x, double y) const { return (x - from[0]) * e[0] + (y - from[1]) * e[1]; }
  double left_of(double x, double y) const { return (y - from[1]) * e[0] - (x - from[0]) * e[1]; }
  void at(double u, double point[2]) const {
    for (int k = 0; k < 2; ++k) point[k] = from[k] + u * e[k];
  }
};

// A point where the line of a side meets an edge around a path. Several at one place are ordered by their names.
struct Crossing {
  double u;
  uint32_t half_edge, piece;

  bool operator<(const Crossing &other) const {
    if (u != other.u) return u < other.u;
    return half_edge != other.half_edge ? half_edge < other.half_edge : piece < other.piece;
  }
};

bool is_left(double beside) {
  return beside >= 0.0;
}

// The u at which a curve crosses the line of a side between its parameters `from` and `to`, found by bisection.
// from_left: whether the curve is on the left at `from`.
double place_between(const StrandSide &side, const EdgeCurve &curve, double from, double to, bool from_left) {
  constexpr int halvings = 60;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (from + to);
    const SinCos at = sin_cos(middle);
    (is_left(side.left_of(curve.ellipse.x(at), curve.ellipse.y(at))) == from_left ? from : to) = middle;
  }
  const SinCos at = sin_cos(0.5 * (from + to));
  return side.along(curve.ellipse.x(at), curve.ellipse.y(at));
}

// Calls visit(crossing) for the crossings of an edge with the line. The edge is cut where it is farthest from the line:
// then a piece meets the line once if its ends are on different sides, and else never. At an end of the edge the vertex
// decides on which side it is, for all edges there: so a loop crosses as often to the right as to the left.
template <class Visit>
void visit_crossings(const StickMap &map, const StrandSide &side, uint32_t half_edge, Visit visit) {
  const MapEdge &edge = map.edges[half_edge / 2];
  const MapVertex &v = map.vertices[edge.vertex[0]];
  const MapVertex &w = map.vertices[edge.vertex[1]];
  const EdgeCurve curve = curve_of(map, half_edge / 2);
  const double c = side.e[0] * curve.ellipse.first[1] - side.e[1] * curve.ellipse.first[0];
  const double s = side.e[0] * curve.ellipse.second[1] - side.e[1] * curve.ellipse.second[0];
  double farthest = arc_tangent(s, c);
  while (farthest > curve.from) farthest -= pi;
  while (farthest <= curve.from) farthest += pi;
  double from = curve.from;
  bool from_left = is_left(side.left_of(v.x, v.y));
  for (uint32_t piece = 0; from < curve.to; ++piece, farthest += pi) {
    const bool last = !(farthest < curve.to);
    const double to = last ? curve.to : farthest;
    const SinCos at = sin_cos(to);
    const bool to_left =
        is_left(last ? side.left_of(w.x, w.y) : side.left_of(curve.ellipse.x(at), curve.ellipse.y(at)));
    if (from_left != to_left) visit(Crossing{place_between(side, curve, from, to, from_left), half_edge, piece});
    from = to;
    from_left = to_left;
  }
}

// Finds the first crossing behind another one; false if there is none.
bool find_next(const StickMap &map, uint32_t path, const StrandSide &side, const Crossing &before, Crossing &next) {
  bool found = false;
  map.visit_path(path, [&](uint32_t loop) {
    map.visit_loop(loop, [&](uint32_t half_edge) {
      visit_crossings(map, side, half_edge, [&](const Crossing &crossing) {
        if (!(before < crossing) || (found && !(crossing < next))) return;
        next = crossing;
        found = true;
      });
    });
  });
  return found;
}

void put_piece(const StrandSide &side, double from, double to, uint32_t ball, const ArcVisitor &visitor) {
  from = from < side.low ? side.low : from;
  to = to > side.high ? side.high : to;
  if (!(from < to)) return;
  double ends[2][2];
  side.at(from, ends[0]);
  side.at(to, ends[1]);
  visitor(line_between(ends[0], ends[1], ball), true, false);
}

// Visits the pieces of a line within the path: from every other crossing to the next.
void visit_side(const StickMap &map, uint32_t path, const StrandSide &side, uint32_t ball, const ArcVisitor &visitor) {
  Crossing in{-std::numeric_limits<double>::infinity(), 0, 0}, out{};
  while (find_next(map, path, side, in, out)) {
    Crossing end{};
    if (!find_next(map, path, side, out, end)) return;
    put_piece(side, out.u, end.u, ball, visitor);
    in = end;
  }
}

}  // namespace

void visit_strand_lines(const StickMap &map, uint32_t path, const ArcVisitor &visitor) {
  const uint32_t body = map.owner_of(path);
  if (map.scene.is_ball(body)) return;
  const Stick &stick = map.scene.stick_at(body);
  const uint32_t part = map.scene.part_of(body);
  const uint32_t ball = map.scene.ball_of(body);
  const StrandList list = stick.strand_list();
  const double begin = stick.begin_of(part), end = stick.end_of(part);
  for (uint32_t k = 0; k < list.count; ++k) {
    const Strand &strand = list.strand[k];
    const uint32_t pieces = strand.dashed ? dashes / stick.parts : 1;
    const double step = (end - begin) / pieces;
    for (const double left : {strand.left, strand.right}) {
      if (!(std::fabs(left) < 1.0)) continue;
      const double back = std::sqrt((1.0 - left) * (1.0 + left)) * stick.radius * stick.axis.z;
      StrandSide side{
          {stick.foot.x - left * stick.radius * stick.e[1], stick.foot.y + left * stick.radius * stick.e[0]},
          {stick.e[0], stick.e[1]},
          0.0,
          0.0};
      for (uint32_t piece = 0; piece < pieces; ++piece) {
        const double from = begin + (piece + (strand.dashed ? 0.25 : 0.0)) * step;
        side.low = from * stick.seen - back;
        side.high = (from + (strand.dashed ? 0.5 : 1.0) * step) * stick.seen - back;
        visit_side(map, path, side, ball, visitor);
      }
    }
  }
}

namespace {

void visit_map_lines(const void *source, const BallSet &balls, uint32_t path, const ArcVisitor &visitor) {
  MapPathFunctions<StickMap>::visit_lines(source, balls, path, visitor);
  visit_strand_lines(*static_cast<const StickMap *>(source), path, visitor);
}

using OfMap = MapPathFunctions<StickMap>;
constexpr PaintedPaths::Functions of_stick_map{OfMap::ball_of, OfMap::visit_outline, visit_map_lines,
                                               StickMap::is_plain, OfMap::body_of};

}  // namespace

PaintedPaths paths_of(const StickMap &map) {
  return {map.frame, map.owners, &map, of_stick_map};
}

}  // namespace hsp
