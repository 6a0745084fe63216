#include "measure/curvature.hpp"

#include "sphere/arc_geometry.hpp"

namespace hsp {
namespace {

// The edge of two balls, from integers rounded once.
struct Edge {
  double product;  // rho d, which is r_k r_j sin(beta)
  double cosine;   // r_k r_j cos(beta), the product of the outward normals y_k.y_j at any point of it
  double beta;
  double distance;  // d

  Edge(const exact::LatticeBall &own, const exact::LatticeBall &other) {
    const exact::Plane P = exact::plane_of(own, other);
    const double Delta = exact::Exact::circle_discriminant(exact::sphere_of(own), P);
    product = Delta > 0.0 ? 0.5 * std::sqrt(Delta) : 0.0;
    // h = |v|^2 + w - w_j, so that y_k.y_j = w - h/2, of which twice is an integer below 2^62.
    cosine = 0.5 * static_cast<double>(2 * own.radius * own.radius - P.h);
    beta = product > 0.0 ? arc_tangent(product, cosine) : 0.0;
    distance = std::sqrt(static_cast<double>(dot(P.v, P.v)));
  }
  double radius() const { return product / distance; }
};

int32_t gauss_of_ball(const Boundary &boundary, uint32_t i) {
  const auto count = [](uint32_t n) { return static_cast<int32_t>(n); };
  return 6 * (2 * count(boundary.faces(i).size()) - count(boundary.loops(i).size())) -
         count(boundary.half_edges(i).size());
}

// What the arcs and vertices of ball k say of a weighted M.
class MeanCurvature {
 public:
  MeanCurvature(const BallSet &balls, const Boundary &boundary, const AreaWeights &weights, uint32_t k)
      : balls_(balls),
        boundary_(boundary),
        weights_(weights),
        k_(k),
        own_(balls.ball(k)),
        weight_(weights.of(balls, k)) {}

  void add_edges(const ArcBatches &arcs) {
    const ArcBatch &batch = arcs.batch();
    for (uint32_t s = 0; s < batch.count; ++s) {
      if (!batch.has_piece(s)) continue;
      const uint32_t j = batch.other[s];
      const Edge edge(own_, balls_.ball(j));
      if (!(edge.product > 0.0)) {
        result.one_sided = true;
        continue;
      }
      add_edge(batch, s, j, edge);
      if (batch.arc[s] != 0) add_vertex(batch, s, arcs.half_edge(s));
    }
  }
  void add_area(double steradians) {
    result.mean += weight_ * balls_.r[k_] * steradians;
    // d(A/r) = 2 A/r^2 - A/r^2 and what the arcs say.
    result.radius += weight_ * steradians;
  }

  MeanCurvatureGradient result;

 private:
  double weight_of(uint32_t i) const { return weights_.of(balls_, i); }

  // All but the motion of the ends: areas of the two balls, each over its radius, and rho beta.
  void add_edge(const ArcBatch &batch, uint32_t slot, uint32_t j, const Edge &edge) {
    const double r = balls_.r[k_];
    const double other_weight = weight_of(j);
    const double phi = batch.angle[slot];
    const double d = edge.distance;
    const double h = 0.5 * batch.twice_height[slot];
    const double other_h = d - h;
    const double s = 0.5 * (weight_ + other_weight);
    const Vec3 u{batch.ux[slot], batch.uy[slot], batch.uz[slot]};
    const Vec3 X = 0.5 * Vec3{batch.Xx[slot], batch.Xy[slot], batch.Xz[slot]};
    result.mean -= 0.25 * s * edge.radius() * phi * edge.beta;
    // dA_k/dc_k = -R_k [phi (1 - h/d) u - X/d], dA_j/dc_k = R_j [-phi (h/d) u - X/d]; both over their radii.
    result.centre = combine(1.0, result.centre, -weight_ / d, combine(phi * other_h, u, -1.0, X));
    result.centre = combine(1.0, result.centre, -other_weight / d, combine(phi * h, u, 1.0, X));
    result.radius += phi * (weight_ * edge.cosine / (r * d) - other_weight * r / d);
    const double share = edge.beta / edge.product;
    result.centre = combine(1.0, result.centre, 0.5 * s * phi * (1.0 - share * h * other_h), u);
    result.radius -= 0.5 * s * phi * (share * r * other_h - h / r);
  }

  // The vertex where the slot's arc starts on this ball: its motion, and what this ball's centre moves of the ends of
  // its two edges there.
  void add_vertex(const ArcBatch &batch, uint32_t slot, uint32_t half_edge) {
    const uint32_t v = boundary_.half_edge(half_edge).vertex;
    const VertexRecord &vertex = boundary_.vertex(v);
    const double root = boundary_.root_discriminant(v);
    result.one_sided = result.one_sided || vertex.tied();
    if (!(root > 0.0)) return;
    const uint32_t own = vertex.slot_of(k_);
    const uint32_t a = own == 2 ? 0 : own + 1;
    const uint32_t b = 3 - own - a;
    // Edge number l is that of the two balls other than l. Its c_l is y_(l+1) x y_(l+2).
    const exact::LatticeBall ball[3] = {balls_.ball(vertex.ball[0]), balls_.ball(vertex.ball[1]),
                                        balls_.ball(vertex.ball[2])};
    const Edge edge[3] = {Edge(ball[1], ball[2]), Edge(ball[2], ball[0]), Edge(ball[0], ball[1])};
    double weight[3], square[3];
    for (uint32_t l = 0; l < 3; ++l) {
      weight[l] = weight_of(vertex.ball[l]);
      square[l] = static_cast<double>(ball[l].radius * ball[l].radius);
    }
    const auto strength = [&](uint32_t l) {
      const double s = 0.5 * (weight[0] + weight[1] + weight[2] - weight[l]);
      return s * edge[l].beta;
    };
    // c_own.c_own = |c_own|^2; c_a.c_own = g_ab g_(own b) - g_(own a) w_b, as c_a and c_own share y_b.
    const double along_own = edge[own].product;
    const double along_a = (edge[own].cosine * edge[a].cosine - edge[b].cosine * square[b]) / edge[a].product;
    const double along_b = (edge[own].cosine * edge[b].cosine - edge[a].cosine * square[a]) / edge[b].product;
    const double lambda = (strength(own) * along_own + strength(a) * along_a + strength(b) * along_b) / root;
    const Vec3 y = 0.5 * Vec3{batch.px[slot], batch.py[slot], batch.pz[slot]};
    result.centre = combine(1.0, result.centre, lambda, y);
    result.radius += lambda * balls_.r[k_];

    // T_l leads into ball l. Seen from this ball, of the edge that it shares with ball j, c_l is +-(y x y_j).
    const double orientation = vertex.positive() ? 1.0 : -1.0;
    const auto pull = [&](uint32_t l, uint32_t j, double sign) {
      const Vec3 to_other = balls_.difference(k_, vertex.ball[j]);
      // y x y_j = -(y x v)
      const Vec3 c = -sign * cross(y, to_other);
      const double d = edge[l].distance;
      const double other_h = 0.5 * (dot(to_other, to_other) + square[j] - square[own]) / d;
      const double factor = -orientation * 0.5 * strength(l) * (other_h / d) / edge[l].product;
      result.centre = combine(1.0, result.centre, factor, c);
    };
    // c_b is y_own x y_a, as b, own, a follow each other; c_a is y_b x y_own.
    pull(b, a, 1.0);
    pull(a, b, -1.0);
  }

  const BallSet &balls_;
  const Boundary &boundary_;
  const AreaWeights &weights_;
  const uint32_t k_;
  const exact::LatticeBall own_;
  const double weight_;
};

}  // namespace

BallCurvature curvature_of_ball(const BallSet &balls, const Boundary &boundary, uint32_t i) {
  BallCurvature result;
  const uint32_t faces = boundary.faces(i).size();
  if (faces == 0) return result;
  const exact::LatticeBall own = balls.ball(i);
  FreeSurface surface(boundary, balls.r[i]);
  ArcBatches arcs(balls, boundary, i);
  double edges = 0.0;
  while (arcs.next()) {
    const ArcBatch &batch = arcs.batch();
    surface.add(batch);
    for (uint32_t s = 0; s < batch.count; ++s) {
      if (!batch.has_piece(s)) continue;
      const Edge edge(own, balls.ball(batch.other[s]));
      edges += edge.radius() * batch.angle[s] * edge.beta;
    }
  }
  result.mean = balls.r[i] * surface.steradians(faces, boundary.loops(i).size()) - 0.25 * edges;
  result.gauss = gauss_of_ball(boundary, i);
  return result;
}

MeanCurvatureGradient mean_curvature_gradient(const BallSet &balls, const Boundary &boundary,
                                              const AreaWeights &weights, uint32_t k) {
  const uint32_t faces = boundary.faces(k).size();
  if (faces == 0) return {};
  FreeSurface surface(boundary, balls.r[k]);
  MeanCurvature sums(balls, boundary, weights, k);
  ArcBatches arcs(balls, boundary, k);
  while (arcs.next()) {
    surface.add(arcs.batch());
    sums.add_edges(arcs);
  }
  sums.add_area(surface.steradians(faces, boundary.loops(k).size()));
  return sums.result;
}

}  // namespace hsp
