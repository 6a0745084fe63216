// Derivatives of areas and volume by centres and radii (Connolly 1983, Richmond 1984), gathered ball by ball. As ball k
// moves or grows, the free arcs on its own sphere move, and each of them bounds the areas of two balls.
//
// With R, c radii and centres, for every free arc of angle phi on the circle of k and j, from p to q counter-clockwise
// about the unit vector u from c_k to c_j, d the distance of the centres and h that of the circle's plane from c_k:
//   dA_k/dc_j = R_k [ phi (1 - h/d) u - X/d ],   X = (q - p) x u,        dA_k/dR_j = -R_k R_j phi / d
//   dA_j/dc_k = R_j [ -phi (h/d) u - X/d ],                              dA_k/dc_k = - sum over j of dA_k/dc_j
//   dA_k/dR_k = 2 A_k/R_k + sum over arcs of phi (R_k^2 + R_j^2 - d^2)/(2 d)
// and dV/dc_k is the vector area of ball k's faces, dV/dR_k = A_k.
//
// As an example two balls of radius 5 whose centres are 8 apart: h = 4, their circle has radius 3, and phi is a whole
// turn with X = 0. The areas are 2 pi R (R + h) = 90 pi each.
//   dA_k/dc_j = 5 * 2 pi (1 - 4/8) u = 5 pi u        as h = d/2 here, and 2 pi R h grows by pi R with each unit of d
//   dA_k/dR_k = 2 * 90 pi / 5 + 2 pi (25 + 25 - 64) / 16 = 36 pi - 1.75 pi = 34.25 pi
//   dV/dc_k   = -9 pi u, the flat disc that a ball opens as it moves away
//   dV/dR_k   = 90 pi
#pragma once

#include "core/first_index.hpp"
#include "core/sorting.hpp"
#include "measure/areas.hpp"

namespace hsp {

enum class TouchingBalls : uint8_t { meet, apart };

// Whether the free arcs of a circle are counted in derivatives. The circle of touching spheres, of radius 0, is counted
// if the caller wants it.
constexpr bool counts(Touching touching, TouchingBalls touching_balls) {
  return touching == Touching::no || touching_balls == TouchingBalls::meet;
}

// The sum that is differentiated: S = sum over the balls of weight * area.
struct AreaWeights {
  const double *weight = nullptr;  // in the caller's order; null for all ones
  TouchingBalls touching_balls = TouchingBalls::meet;
  const uint32_t *owner = nullptr;  // null, or for each ball in the caller's order the index of its weight

  bool are_ones() const { return weight == nullptr; }
  double of(const BallSet &balls, uint32_t i) const {
    if (are_ones()) return 1.0;
    const uint32_t caller = balls.caller[i];
    return weight[owner == nullptr ? caller : owner[caller]];
  }
};

// Measure of ball k and derivatives by it, in lattice steps.
struct BallGradient {
  BallMeasure measure;
  Vec3 centre{0.0, 0.0, 0.0};       // dS/dc_k
  double radius = 0.0;              // dS/dR_k
  Vec3 vector_area{0.0, 0.0, 0.0};  // dV/dc_k; dV/dR_k is the area
  bool one_sided = false;           // a sphere touches this one at a free point
};
BallGradient gradient_of_ball(const BallSet &balls, const Boundary &boundary, const AreaWeights &weights, uint32_t k);

// The arcs of ball k in the weighted sum of areas (arc_kernel.hpp).
class WeightedAreas {
 public:
  WeightedAreas(const BallSet &balls, const Boundary &boundary, const AreaWeights &weights, uint32_t k)
      : balls_(balls), boundary_(boundary), weights_(weights), R_(balls.r[k]), weight_(weights.of(balls, k)) {}

  // Called between ArcBatches::gather() and evaluate().
  void put_weights(ArcBatch &batch) const {
    batch.has_weights = !weights_.are_ones();
    if (batch.has_weights) put_given_weights(batch);
  }
  // Adds an evaluated batch to `surface`, calls on_arcs(batch), takes the arcs that are not counted out of the batch,
  // and adds the rest to its own sums.
  template <class OnArcs>
  void add(ArcBatch &batch, FreeSurface &surface, OnArcs &on_arcs) {
    if (batch.any_touching) [[unlikely]] {
      surface.add(batch);
      on_arcs(batch);
      take_out_uncounted(batch);
      add(sums_of(batch).weighted);
    } else {
      const GradientSums sums = sums_of(batch);
      surface.add(batch, sums.areas);
      on_arcs(batch);
      add(sums.weighted);
    }
  }

  const Vec3 &by_centre() const { return centre_; }
  double by_radius(double steradians) const { return 2 * weight_ * R_ * steradians + radius_; }

 private:
  void add(const WeightedSums &sums) {
    centre_ = centre_ + Vec3{sums.centre[0], sums.centre[1], sums.centre[2]};
    radius_ += sums.radius;
  }
  GradientSums sums_of(const ArcBatch &batch) const { return sum_gradient(boundary_.target(), batch, R_, weight_); }
  void put_given_weights(ArcBatch &batch) const;
  void take_out_uncounted(ArcBatch &batch) const;

  const BallSet &balls_;
  const Boundary &boundary_;
  const AreaWeights &weights_;
  const double R_, weight_;
  Vec3 centre_{0.0, 0.0, 0.0};
  double radius_ = 0.0;
};

// The same as gradient_of_ball() for a ball with faces, for callers that sum more over its arcs: calls on_arcs(batch)
// for every batch, before arcs that are not counted are taken out of it. Returns the solid angle of the faces.
template <class OnArcs>
HSP_INLINE_UNLESS_SMALL inline double gather_gradient(const BallSet &balls, const Boundary &boundary,
                                                      const AreaWeights &weights, uint32_t k, BallGradient &result,
                                                      OnArcs on_arcs) {
  WeightedAreas areas(balls, boundary, weights, k);
  FreeSurface surface(boundary, balls.r[k]);
  ArcBatches arcs(balls, boundary, k);
  while (arcs.gather()) {
    ArcBatch &batch = arcs.batch();
    areas.put_weights(batch);
    arcs.evaluate();
    areas.add(batch, surface, on_arcs);
    if (batch.any_touching) result.one_sided = true;
  }
  const double R = balls.r[k];
  const double steradians = surface.steradians(boundary.faces(k).size(), boundary.loops(k).size());
  result.centre = areas.by_centre();
  result.radius = areas.by_radius(steradians);
  result.vector_area = surface.vector_area();
  result.measure.area = R * R * steradians;
  result.measure.volume =
      volume_term(R, result.measure.area, offset_from_origin(balls, boundary, k), result.vector_area);
  return steradians;
}

// Derivatives of the area of one ball by another one, or by itself, in lattice steps.
struct AreaDerivative {
  Vec3 centre{0.0, 0.0, 0.0};
  double radius = 0.0;
  double angle = 0.0;  // of the free arcs that are counted
  bool one_sided = false;
};
// The length of ball i's row of derivatives of its area: entries for ball i itself and for the balls whose circles on
// it have a free arc or are free; 0 if it has no face.
uint32_t area_row_length(const Boundary &boundary, uint32_t i);
// The first entry of each row, if rows follow each other in the caller's order: first [n + 1], from 0 to the number of
// all entries.
void find_area_row_starts(const CubeGrid &grid, const Boundary &boundary, uint32_t *first);

// Calls on_part(j, derivative) for every free arc and circle on ball i, with its part of the derivatives by ball j, and
// returns those by i itself.
template <class OnPart>
AreaDerivative visit_area_row(const BallSet &balls, const Boundary &boundary, uint32_t i, TouchingBalls touching_balls,
                              OnPart on_part) {
  const double R = balls.r[i];
  FreeSurface surface(boundary, R);
  ArcBatches arcs(balls, boundary, i);
  AreaDerivative own;
  while (arcs.next()) {
    const ArcBatch &batch = arcs.batch();
    surface.add(batch);
    for (uint32_t c = 0; c < batch.count; ++c) {
      if (!batch.has_piece(c)) continue;
      const Touching touching = batch.any_touching ? batch.touching[c] : Touching::no;
      AreaDerivative part;
      part.one_sided = touching != Touching::no;
      if (counts(touching, touching_balls)) {
        const double ratio = R * batch.inverse_distance[c];
        const double height = 0.5 * batch.twice_height[c];
        const double angle = batch.angle[c];
        part.angle = angle;
        part.centre = combine((R - height * ratio) * angle, {batch.ux[c], batch.uy[c], batch.uz[c]}, -0.5 * ratio,
                              {batch.Xx[c], batch.Xy[c], batch.Xz[c]});
        part.radius = -ratio * balls.r[batch.other[c]] * angle;
        own.radius += (R * ratio - height) * angle;
      }
      own.one_sided = own.one_sided || part.one_sided;
      own.centre = combine(1.0, own.centre, -1.0, part.centre);
      on_part(batch.other[c], part);
    }
  }
  const uint32_t faces = boundary.faces(i).size();
  own.radius += 2 * R * surface.steradians(faces, boundary.loops(i).size());
  return own;
}

// Calls sink(k, j) for the entries k = 0, 1, .. of ball i's row; j is the ball of entry k, in no particular order.
template <class Sink>
void visit_balls_of_area_row(const Boundary &boundary, uint32_t i, Sink sink) {
  if (!boundary.is_exposed(i)) return;
  uint32_t k = 0;
  sink(k++, i);
  for (const ClosedHalfEdge e : boundary.circles(i)) sink(k++, boundary.neighbour(e));
  const IdRange half_edges = boundary.half_edges(i);
  for (const uint32_t u : half_edges) {
    // Half-edges are sorted by the circle that they leave along.
    const uint32_t circle = boundary.half_edge(u).circle;
    if (u == half_edges.first || circle != boundary.half_edge(u - 1).circle) sink(k++, circle);
  }
}

// Fills ball i's row, one entry for each ball, sorted by the caller's indices, with lengths in the caller's unit.
// length: area_row_length(). row.ball(k) is a reference to the ball of entry k, row.clear(k) makes entry k 0,
// row.sort() sorts the entries by ball, and row.add(k, derivative) adds to entry k.
template <class Row>
void gather_area_row(const BallSet &balls, const Boundary &boundary, uint32_t i, TouchingBalls touching_balls,
                     uint32_t length, Row row) {
  if (length == 0) return;
  visit_balls_of_area_row(boundary, i, [&](uint32_t k, uint32_t j) {
    row.clear(k);
    row.ball(k) = balls.caller[j];
  });
  row.sort();
  const auto add = [&](uint32_t j, AreaDerivative part) {
    const uint32_t ball = balls.caller[j];
    const exact::Lattice &lattice = balls.lattice;
    part.centre = {lattice.length(part.centre.x), lattice.length(part.centre.y), lattice.length(part.centre.z)};
    part.radius = lattice.length(part.radius);
    row.add(first_index(0, length, [&](uint32_t k) { return row.ball(k) >= ball; }), part);
  };
  add(i, visit_area_row(balls, boundary, i, touching_balls, add));
}

// The flag of an entry whose balls touch, so that its derivatives hold on one side only.
inline constexpr uint32_t one_sided_flag = 1;

// The same as records. row [area_row_length]. Entry has centre[3], radius, angle, ball and flags.
template <class Entry>
void gather_area_row(const BallSet &balls, const Boundary &boundary, uint32_t i, TouchingBalls touching_balls,
                     Span<Entry> row) {
  struct Records {
    Span<Entry> row;
    uint32_t &ball(uint32_t k) const { return row[k].ball; }
    void clear(uint32_t k) const { row[k] = {}; }
    void sort() const {
      sort_in_place(row, [](const Entry &a, const Entry &b) { return a.ball < b.ball; });
    }
    void add(uint32_t k, const AreaDerivative &part) const {
      Entry &entry = row[k];
      entry.centre[0] += part.centre.x;
      entry.centre[1] += part.centre.y;
      entry.centre[2] += part.centre.z;
      entry.radius += part.radius;
      entry.angle += part.angle;
      entry.flags |= part.one_sided ? one_sided_flag : 0;
    }
  };
  gather_area_row(balls, boundary, i, touching_balls, row.size(), Records{row});
}

}  // namespace hsp
