// All records of the boundary of a periodic box, and the same records without ids and shifts: balls and images are
// named by their positions, so that two boundaries of one set can be compared.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ball_list.hpp"
#include "owned_boxes.hpp"

namespace support {

using Steps = std::array<int64_t, 3>;

inline Steps operator+(const Steps &p, const Steps &q) {
  return {p[0] + q[0], p[1] + q[1], p[2] + q[2]};
}
inline Steps operator-(const Steps &p, const Steps &q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

// Balls and box in whole steps; radii with the probe.
struct BoxedBalls {
  BallList balls;
  std::array<double, 9> box{};

  // The translation shift[0] a + shift[1] b + shift[2] c by vectors of the box.
  [[nodiscard]] Steps moved(const int32_t (&shift)[3]) const {
    Steps sum{};
    for (size_t row = 0; row < 3; ++row) {
      for (size_t axis = 0; axis < 3; ++axis) sum[axis] += shift[row] * static_cast<int64_t>(box[3 * row + axis]);
    }
    return sum;
  }
  [[nodiscard]] Steps given(uint32_t i) const {
    const double *const at = &balls.xyz[3 * size_t{i}];
    return {static_cast<int64_t>(at[0]), static_cast<int64_t>(at[1]), static_cast<int64_t>(at[2])};
  }
  // The image in 0 <= x < a_x, 0 <= y < b_y, 0 <= z < c_z.
  [[nodiscard]] Steps place(uint32_t i) const {
    Steps at = given(i);
    for (size_t row = 3; row-- > 0;) {
      const double times = std::floor(static_cast<double>(at[row]) / box[4 * row]);
      for (size_t axis = 0; axis <= row; ++axis) at[axis] -= static_cast<int64_t>(times * box[3 * row + axis]);
    }
    return at;
  }
};

// A ball, or an image of it.
struct PlacedBall {
  uint32_t ball = 0;
  Steps centre{};
  auto operator<=>(const PlacedBall &) const = default;
};

inline PlacedBall operator+(const PlacedBall &ball, const Steps &by) {
  return {ball.ball, ball.centre + by};
}

// A vertex by its balls, ascending, and its side for that order.
struct PlacedVertex {
  std::array<PlacedBall, 3> ball;
  int sign = 0;
  auto operator<=>(const PlacedVertex &) const = default;
};

inline PlacedVertex placed_vertex(std::array<PlacedBall, 3> ball, int sign) {
  const auto exchange = [&](size_t i, size_t k) {
    if (ball[i] < ball[k]) return;
    std::swap(ball[i], ball[k]);
    sign = -sign;
  };
  exchange(0, 1);
  exchange(1, 2);
  exchange(0, 1);
  return {ball, sign};
}

inline PlacedVertex operator+(const PlacedVertex &vertex, const Steps &by) {
  return placed_vertex({vertex.ball[0] + by, vertex.ball[1] + by, vertex.ball[2] + by}, vertex.sign);
}

// An arc as one of its two balls sees it: the other ball, and the arc's ends in the sense about the axis towards the
// other ball. A whole circle has two ends without balls.
struct PlacedEdge {
  PlacedBall other;
  PlacedVertex from, to;
  auto operator<=>(const PlacedEdge &) const = default;
};

struct PlacedFace {
  uint32_t ball = 0;
  uint32_t loops = 0;
  std::vector<PlacedEdge> edges;  // ascending
  auto operator<=>(const PlacedFace &) const = default;
};

// The compared records: vertices with their flags and faces, of the balls in their cells, ascending.
struct PlacedBoundary {
  std::vector<std::pair<PlacedVertex, bool>> vertices;
  std::vector<PlacedFace> faces;
  bool operator==(const PlacedBoundary &) const = default;
};

// The records of the interface.
struct BoxRecords {
  hsp_periodic_counts counts{};
  std::vector<hsp_periodic_vertex> vertices;
  std::vector<hsp_periodic_arc> arcs;
  std::vector<hsp_periodic_circle> circles;
  std::vector<hsp_periodic_face> faces;
  std::vector<hsp_periodic_loop> loops;
  std::vector<hsp_periodic_loop_arc> loop_arcs;
  std::vector<hsp_ball> balls;

  explicit BoxRecords(const hsp_periodic *p) {
    expect_ok(hsp_periodic_get_counts(p, &counts), "hsp_periodic_get_counts");
    vertices = all_records<hsp_periodic_vertex>([p](auto... out) { return hsp_periodic_get_vertices(p, out...); },
                                                "hsp_periodic_get_vertices");
    arcs = all_records<hsp_periodic_arc>([p](auto... out) { return hsp_periodic_get_arcs(p, out...); },
                                         "hsp_periodic_get_arcs");
    circles = all_records<hsp_periodic_circle>([p](auto... out) { return hsp_periodic_get_circles(p, out...); },
                                               "hsp_periodic_get_circles");
    faces = all_records<hsp_periodic_face>([p](auto... out) { return hsp_periodic_get_faces(p, out...); },
                                           "hsp_periodic_get_faces");
    loops = all_records<hsp_periodic_loop>([p](auto... out) { return hsp_periodic_get_loops(p, out...); },
                                           "hsp_periodic_get_loops");
    loop_arcs = all_records<hsp_periodic_loop_arc>([p](auto... out) { return hsp_periodic_get_loop_arcs(p, out...); },
                                                   "hsp_periodic_get_loop_arcs");
    balls =
        all_records<hsp_ball>([p](auto... out) { return hsp_periodic_get_balls(p, out...); }, "hsp_periodic_get_balls");
  }
};

// Reads the records against the balls that they were made from. problem() names the first law that does not hold.
class BoxReader {
 public:
  BoxReader(const BoxedBalls &set, const BoxRecords &records) : set_(set), r_(records) { read(); }

  [[nodiscard]] const std::string &problem() const { return problem_; }
  [[nodiscard]] const PlacedBoundary &placed() const { return placed_; }

 private:
  void require(bool holds, const char *law) {
    if (!holds && problem_.empty()) problem_ = law;
  }
  [[nodiscard]] PlacedBall at(const hsp_image &image) const {
    return {image.ball, set_.given(image.ball) + set_.moved(image.shift)};
  }
  [[nodiscard]] bool is_at_place(const hsp_image &image) const { return at(image).centre == set_.place(image.ball); }
  // Whether image p comes before image q: by the caller's order of the balls, then by z, y and x.
  [[nodiscard]] bool comes_first(const hsp_image &p, const hsp_image &q) const {
    const Steps a = at(p).centre, b = at(q).centre;
    return std::array<int64_t, 4>{p.ball, a[2], a[1], a[0]} < std::array<int64_t, 4>{q.ball, b[2], b[1], b[0]};
  }
  [[nodiscard]] PlacedVertex vertex(const hsp_periodic_id &id) const {
    const hsp_periodic_vertex &v = r_.vertices.at(id.id);
    return placed_vertex({at(v.image[0]), at(v.image[1]), at(v.image[2])}, v.sign) + set_.moved(id.shift);
  }
  // How far a point is from the sphere of an image, in parts of the sphere's size.
  [[nodiscard]] double off(const double (&xyz)[3], const hsp_image &image, double radius) const {
    const Steps c = at(image).centre;
    const double square = std::pow(xyz[0] - static_cast<double>(c[0]), 2) +
                          std::pow(xyz[1] - static_cast<double>(c[1]), 2) +
                          std::pow(xyz[2] - static_cast<double>(c[2]), 2);
    return std::fabs(std::sqrt(square) - radius) / (1.0 + radius);
  }
  [[nodiscard]] double radius_of(const hsp_image &image) const { return set_.balls.radius[image.ball]; }
  static double square(const double (&v)[3]) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

  template <class Circle>
  void read_circle(const Circle &circle) {
    require(is_at_place(circle.image[0]), "the first ball of a circle is at its place");
    require(comes_first(circle.image[0], circle.image[1]), "the order of the balls of a circle");
    for (const hsp_image &image : circle.image) {
      const double r = radius_of(image);
      const double apart = std::sqrt(std::max(0.0, r * r - circle.radius * circle.radius));
      // The distance loses digits where the circle is nearly as large as the ball.
      require(off(circle.centre, image, apart) <= 1e-6, "the centre of a circle");
    }
    const Steps a = at(circle.image[0]).centre, b = at(circle.image[1]).centre;
    double v[3], length = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
      v[axis] = static_cast<double>(b[axis] - a[axis]);
      length += v[axis] * v[axis];
    }
    for (size_t axis = 0; axis < 3; ++axis) {
      require(std::fabs(circle.axis[axis] - v[axis] / std::sqrt(length)) <= 1e-12, "the axis of a circle");
    }
    for (size_t side = 0; side < 2; ++side) {
      const hsp_periodic_face &face = r_.faces.at(circle.face[side].id);
      require(at(face.image) + set_.moved(circle.face[side].shift) == at(circle.image[side]), "a face beside a circle");
      join(circle.face[0].id, circle.face[1].id);
    }
  }

  void read_vertices() {
    std::vector<PlacedVertex> once;
    for (const hsp_periodic_vertex &v : r_.vertices) {
      require(is_at_place(v.image[0]), "the first ball of a vertex is at its place");
      require(comes_first(v.image[0], v.image[1]) && comes_first(v.image[1], v.image[2]), "the balls of a vertex");
      require((v.sign == 1 || v.sign == -1) && v.flags <= HSP_VERTEX_TIED, "sign and flags of a vertex");
      for (const hsp_image &image : v.image) {
        require(off(v.xyz, image, radius_of(image)) <= 1e-9, "a vertex lies on its spheres");
      }
      once.push_back(placed_vertex({at(v.image[0]), at(v.image[1]), at(v.image[2])}, v.sign));
      // The vertex as seen from each of its balls, with that ball at its own place in the cell.
      for (const hsp_image &image : v.image) {
        placed_.vertices.emplace_back(once.back() + (set_.place(image.ball) - at(image).centre), v.flags != 0);
      }
    }
    std::sort(once.begin(), once.end());
    require(std::adjacent_find(once.begin(), once.end()) == once.end(), "a vertex is listed once");
    // A vertex of two images of one ball is listed twice.
    std::sort(placed_.vertices.begin(), placed_.vertices.end());
    placed_.vertices.erase(std::unique(placed_.vertices.begin(), placed_.vertices.end()), placed_.vertices.end());
  }

  void read_arcs() {
    std::vector<uint32_t> ends(r_.vertices.size());
    for (const hsp_periodic_arc &arc : r_.arcs) {
      read_circle(arc);
      require(arc.angle >= 0.0 && arc.angle <= 6.2831853071795865, "the angle of an arc");
      double direction[2][3];
      for (size_t k = 0; k < 2; ++k) {
        ++ends.at(arc.vertex[k].id);
        const PlacedVertex end = vertex(arc.vertex[k]);
        for (const hsp_image &image : arc.image) {
          require(std::count(end.ball.begin(), end.ball.end(), at(image)) == 1, "an arc ends on its balls");
        }
        const Steps by = set_.moved(arc.vertex[k].shift);
        for (size_t axis = 0; axis < 3; ++axis) {
          direction[k][axis] =
              r_.vertices.at(arc.vertex[k].id).xyz[axis] + static_cast<double>(by[axis]) - arc.centre[axis];
        }
        require(std::fabs(std::sqrt(square(direction[k])) - arc.radius) <= 1e-6 * (1.0 + radius_of(arc.image[0])),
                "an arc ends on its circle");
      }
      turn(arc, direction[0], direction[1]);
    }
    for (const uint32_t count : ends) require(count == 3, "a vertex ends three arcs");
  }
  // Requires that the start of an arc, turned about the axis by the arc's angle, is its end.
  void turn(const hsp_periodic_arc &arc, const double (&from)[3], const double (&to)[3]) {
    const double *const n = arc.axis;
    const double across[3] = {n[1] * from[2] - n[2] * from[1], n[2] * from[0] - n[0] * from[2],
                              n[0] * from[1] - n[1] * from[0]};
    for (size_t axis = 0; axis < 3; ++axis) {
      const double x = std::cos(arc.angle) * from[axis] + std::sin(arc.angle) * across[axis];
      require(std::fabs(x - to[axis]) <= 1e-5 * (1.0 + radius_of(arc.image[0])), "the sense of an arc");
    }
  }

  void read_faces() {
    std::vector<uint32_t> sides(2 * r_.arcs.size()), circle_sides(2 * r_.circles.size());
    uint32_t next_loop = 0, next_arc = 0, shells = 0;
    std::vector<uint32_t> root_of_shell;
    for (uint32_t f = 0; f < r_.faces.size(); ++f) {
      const hsp_periodic_face &face = r_.faces[f];
      require(is_at_place(face.image) && face.first_loop == next_loop && face.reserved == 0, "a face");
      PlacedFace result{face.image.ball, face.loops, {}};
      for (uint32_t l = 0; l < face.loops; ++l) {
        const hsp_periodic_loop &loop = r_.loops.at(next_loop++);
        require(loop.face == f && loop.first_arc == next_arc, "a loop of a face");
        if (loop.circle.id != HSP_NONE) {
          require(loop.arcs == 0, "a circle has no arcs");
          read_side(r_.circles.at(loop.circle.id), loop.circle, loop.side, f, result, {}, {});
          ++circle_sides.at(2 * loop.circle.id + loop.side);
        } else {
          require(loop.arcs >= 2 && loop.side == 0, "a loop of arcs");
        }
        for (uint32_t k = 0; k < loop.arcs; ++k) read_loop_arc(loop, k, f, sides, result);
        next_arc += loop.arcs;
      }
      std::sort(result.edges.begin(), result.edges.end());
      placed_.faces.push_back(std::move(result));
      // Shells come in the order of their first faces.
      if (face.shell == shells) {
        ++shells;
        root_of_shell.push_back(root(f));
      }
      require(face.shell < shells && root_of_shell.at(face.shell) == root(f), "the shell of a face");
      for (uint32_t other = 0; other < shells; ++other) {
        require(other == face.shell || root_of_shell[other] != root(f), "shells that are one");
      }
      const hsp_ball &ball = r_.balls.at(face.image.ball);
      require(f >= ball.first_face && f - ball.first_face < ball.faces, "the faces of a ball");
    }
    require(next_loop == r_.loops.size() && next_arc == r_.loop_arcs.size(), "all loops belong to faces");
    require(shells == r_.counts.shells, "how many shells");
    for (const uint32_t count : sides) require(count == 1, "each side of an arc is in one loop");
    for (const uint32_t count : circle_sides) require(count == 1, "each side of a circle is one loop");
    std::sort(placed_.faces.begin(), placed_.faces.end());
  }

  void read_loop_arc(const hsp_periodic_loop &loop, uint32_t k, uint32_t f, std::vector<uint32_t> &sides,
                     PlacedFace &result) {
    const hsp_periodic_loop_arc &here = r_.loop_arcs.at(loop.first_arc + k);
    const hsp_periodic_loop_arc &next = r_.loop_arcs.at(loop.first_arc + (k + 1) % loop.arcs);
    const hsp_periodic_arc &arc = r_.arcs.at(here.arc.id);
    require(here.side <= 1 && here.reserved == 0, "the side of an arc");
    const Steps by = set_.moved(here.arc.shift);
    const PlacedVertex from = vertex(arc.vertex[1 - here.side]) + by, to = vertex(arc.vertex[here.side]) + by;
    require(vertex(here.vertex) == from && vertex(next.vertex) == to, "a loop is closed");
    ++sides.at(2 * size_t{here.arc.id} + here.side);
    // With the face on the left the loop runs clockwise about the axis away from its ball.
    read_side(arc, here.arc, here.side, f, result, to, from);
  }

  template <class Circle>
  void read_side(const Circle &circle, const hsp_periodic_id &id, uint32_t side, uint32_t f, PlacedFace &result,
                 const PlacedVertex &from, const PlacedVertex &to) {
    const Steps by = set_.moved(id.shift);
    require(at(circle.image[side]) + by == at(r_.faces[f].image), "an arc or circle about the ball of its face");
    require(circle.face[side].id == f, "the face of an arc or circle");
    result.edges.push_back({at(circle.image[1 - side]) + by, from, to});
  }

  [[nodiscard]] uint32_t root(uint32_t face) const {
    while (parent_[face] != face) face = parent_[face];
    return face;
  }
  void join(uint32_t f, uint32_t g) { parent_.at(root(f)) = root(g); }

  void read() {
    for (uint32_t f = 0; f < r_.faces.size(); ++f) parent_.push_back(f);
    require(r_.vertices.size() == r_.counts.vertices && r_.arcs.size() == r_.counts.arcs &&
                r_.circles.size() == r_.counts.circles && r_.faces.size() == r_.counts.faces &&
                r_.loops.size() == r_.counts.loops && r_.loop_arcs.size() == 2 * size_t{r_.counts.arcs} &&
                r_.balls.size() == set_.balls.size(),
            "how many records");
    read_vertices();
    read_arcs();
    for (const hsp_periodic_circle &circle : r_.circles) read_circle(circle);
    read_faces();
    size_t faces = 0;
    for (const hsp_ball &ball : r_.balls) {
      faces += ball.faces;
      require(ball.faces > 0 || ball.first_face == HSP_NONE, "a buried ball");
      require((ball.flags & HSP_BALL_CONTAINED) == 0 || ball.faces == 0, "a ball inside another one");
    }
    require(faces == r_.faces.size(), "faces of all balls");
  }

  const BoxedBalls &set_;
  const BoxRecords &r_;
  std::string problem_;
  PlacedBoundary placed_;
  std::vector<uint32_t> parent_;
};

// The first list of records in which two boxes are not the same bit for bit; empty if there is none. Shifts count as
// equal if the places that they lead to are, so the balls may have been given in other cells and the box by other
// vectors.
inline std::string difference_of_records(const BoxedBalls &set, const BoxRecords &p, const BoxedBalls &other,
                                         const BoxRecords &q) {
  const auto same_number = [](double x, double y) { return x == y && std::signbit(x) == std::signbit(y); };
  const auto same_image = [&](const hsp_image &x, const hsp_image &y) {
    return x.ball == y.ball && set.given(x.ball) + set.moved(x.shift) == other.given(y.ball) + other.moved(y.shift);
  };
  const auto same_id = [&](const hsp_periodic_id &x, const hsp_periodic_id &y) {
    return x.id == y.id && set.moved(x.shift) == other.moved(y.shift);
  };
  const auto same_list = [](const auto &x, const auto &y, auto same) {
    return x.size() == y.size() && std::equal(x.begin(), x.end(), y.begin(), same);
  };
  const auto same_circle = [&](const auto &x, const auto &y) {
    bool same = same_number(x.radius, y.radius);
    for (size_t k = 0; k < 3; ++k) {
      same = same && same_number(x.centre[k], y.centre[k]) && same_number(x.axis[k], y.axis[k]);
    }
    for (size_t k = 0; k < 2; ++k) same = same && same_image(x.image[k], y.image[k]) && same_id(x.face[k], y.face[k]);
    return same;
  };
  if (!same_list(p.vertices, q.vertices, [&](const hsp_periodic_vertex &x, const hsp_periodic_vertex &y) {
        bool same = x.sign == y.sign && x.flags == y.flags;
        for (size_t k = 0; k < 3; ++k) {
          same = same && same_number(x.xyz[k], y.xyz[k]) && same_image(x.image[k], y.image[k]);
        }
        return same;
      })) {
    return "vertices";
  }
  if (!same_list(p.arcs, q.arcs, [&](const hsp_periodic_arc &x, const hsp_periodic_arc &y) {
        return same_circle(x, y) && same_number(x.angle, y.angle) && same_id(x.vertex[0], y.vertex[0]) &&
               same_id(x.vertex[1], y.vertex[1]);
      })) {
    return "arcs";
  }
  if (!same_list(p.circles, q.circles, same_circle)) return "circles";
  if (!same_list(p.faces, q.faces, [&](const hsp_periodic_face &x, const hsp_periodic_face &y) {
        return same_image(x.image, y.image) && x.loops == y.loops && x.shell == y.shell && x.first_loop == y.first_loop;
      })) {
    return "faces";
  }
  if (!same_list(p.loops, q.loops, [&](const hsp_periodic_loop &x, const hsp_periodic_loop &y) {
        return same_id(x.circle, y.circle) && x.face == y.face && x.side == y.side && x.first_arc == y.first_arc &&
               x.arcs == y.arcs;
      })) {
    return "loops";
  }
  if (!same_list(p.loop_arcs, q.loop_arcs, [&](const hsp_periodic_loop_arc &x, const hsp_periodic_loop_arc &y) {
        return same_id(x.arc, y.arc) && same_id(x.vertex, y.vertex) && x.side == y.side;
      })) {
    return "arcs of loops";
  }
  return "";
}

}  // namespace support
