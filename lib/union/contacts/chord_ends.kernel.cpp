#include "contacts/chord_ends.hpp"
#include "measure/lane_sums.hpp"

namespace hsp::HSP_TARGET {
namespace {

constexpr double least_square = 0x1p-10;
constexpr double most_ratio = 8.0;

template <uint32_t n>
struct EndKernel {
  using L = Wide<double, n>;
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  using Vector = VectorOf<Real>;

  struct Ball {
    Vector centre;
    Real r;

    Ball(const BallArrays &balls, const uint32_t *ids)
        : centre{L::gather(balls.x, ids), L::gather(balls.y, ids), L::gather(balls.z, ids)},
          r(L::gather(balls.r, ids)) {}
  };

  // plane_of of exact/plane.hpp, and the square of its vector.
  struct Plane {
    Vector v;
    Real U, h;

    Plane(const Ball &own, const Ball &other)
        : v(other.centre - own.centre), U(dot(v, v)), h(U - (other.r - own.r) * (other.r + own.r)) {}
  };

  // The line of two planes, as chord_line.hpp has it: from squares and heights of both, their product, and the square
  // of the normal.
  struct LineNumbers {
    Real N, alpha, beta;

    LineNumbers(const Real &U, const Real &h, const Real &V, const Real &k, const Real &uv, const Real &square)
        : N(square), alpha(h * V - k * uv), beta(k * U - h * uv) {}
    Real third() const { return ((N + N) - alpha) - beta; }
    Real scale(const Real &t) const { return t / (8.0 * N); }
  };
  struct Line : LineNumbers {
    Vector normal;

    Line(const Plane &P, const Plane &Q) : Line(P, Q, cross(P.v, Q.v)) {}

   private:
    Line(const Plane &P, const Plane &Q, const Vector &across)
        : LineNumbers(P.U, P.h, Q.U, Q.h, dot(P.v, Q.v), dot(across, across)), normal(across) {}
  };

  // n vertices. Returns the mask of those that are served.
  [[gnu::always_inline]] static Mask measure(const BallArrays &balls, PowerVertexBatch &batch, uint32_t s) {
    PowerVertexBatch &b = by_one_register(batch);
    const Ball first(balls, b.ball[0] + s), second(balls, b.ball[1] + s), third(balls, b.ball[2] + s),
        fourth(balls, b.ball[3] + s);
    const Plane P(first, second), Q(first, third), R(first, fourth);
    const Line PQ(P, Q), QR(Q, R), RP(R, P);
    const Real B = dot(PQ.normal, R.v);
    const Real inverse = 1.0 / L::absolute(B);
    // On the side of larger t, as all that follows.
    const Vector y = inverse * (R.h * PQ.normal + P.h * QR.normal + Q.h * RP.normal);
    const Real a = L::load(b.kept[0] + s) * PQ.scale(dot(PQ.normal, y));
    const Real c = L::load(b.kept[1] + s) * QR.scale(dot(QR.normal, y));
    const Real d = L::load(b.kept[2] + s) * RP.scale(dot(RP.normal, y));
    L::store(b.part[0] + s, a * PQ.beta + d * RP.alpha);
    L::store(b.part[1] + s, a * PQ.alpha + c * QR.beta);
    L::store(b.part[2] + s, c * QR.alpha + d * RP.beta);

    const Plane S(second, third), T(second, fourth);
    const Line ST(S, T);
    const Mask below = B < 0.0;
    const Vector of_second{y.x - L::negate_if(below, P.v.x + P.v.x), y.y - L::negate_if(below, P.v.y + P.v.y),
                           y.z - L::negate_if(below, P.v.z + P.v.z)};
    const Real e = L::load(b.kept[3] + s) * ST.scale(-dot(ST.normal, of_second));
    L::store(b.part[3] + s, a * PQ.third() + e * ST.beta);
    L::store(b.part[4] + s, d * RP.third() + e * ST.alpha);
    L::store(b.part[5] + s, c * QR.third() + e * ST.third());
    const Real square = B * B;
    return L::both(are_alike(L::smaller(L::smaller(first.r, second.r), L::smaller(third.r, fourth.r)),
                             L::larger(L::larger(first.r, second.r), L::larger(third.r, fourth.r))),
                   L::both(square >= least_square * (P.U * Q.U * R.U), square >= least_square * (P.U * S.U * T.U)));
  }

  static Mask are_alike(const Real &smallest, const Real &largest) { return largest <= most_ratio * smallest; }

  static uint32_t measure_all(const BallArrays &balls, PowerVertexBatch &batch, uint32_t count) {
    uint32_t served = 0;
    for (uint32_t s = 0; s < count; s += n)
      served |= static_cast<uint32_t>(L::set_lanes(measure(balls, batch, s))) << s;
    return ~served & ((1U << count) - 1U);
  }

  // An arc begins at the vertex of its slot, on the circles of this slot and the previous one, and ends at the vertex
  // of the next slot.
  static bool measure_arcs(const ArcBatch &batch, double radius, double (&parts)[ArcBatch::room], double &cosines) {
    double before[ArcBatch::room];  // the term at a slot's vertex for the circle of the previous slot
    before[batch.count] = 0.0;
    const Real own = L::all(radius);
    const ArcProducts &products = *batch.products;
    for (uint32_t s = 0; s < batch.count; s += n) {
      const ArcBatch &b = by_one_register(batch);
      const uint32_t *const previous = b.previous + s;
      const Real U = L::gather(products.square, previous), V = L::load(products.square + s);
      const LineNumbers line(U, L::gather(b.scaled_height, previous), V, L::load(b.scaled_height + s),
                             L::load(b.product_with_previous + s), L::load(products.square_of_normal + s));
      const Real r = L::gather(b.other_radius, previous), next_r = L::load(b.other_radius + s);
      const Mask alike = are_alike(L::smaller(own, L::smaller(r, next_r)), L::larger(own, L::larger(r, next_r)));
      const Real scale =
          L::valid(L::both(alike, line.N >= least_square * (U * V)), line.scale(L::load(b.root_discriminant + s)));
      L::store(before + s, scale * line.beta);
      L::store(parts + s, scale * line.alpha);
    }
    Mask unserved{};
    double sums[sum_lanes];
    for (uint32_t lane = 0; lane < sum_lanes; lane += n) {
      Real sum = L::all(0.0);
      for (uint32_t s = lane; s < batch.count; s += sum_lanes) {
        const ArcBatch &b = by_one_register(batch);
        const Real both = L::kept(L::load_mask(b.arc + s), L::load(parts + s) + L::gather(before, b.next + s));
        L::store(parts + s, both);
        unserved |= both != both;
        sum += L::load(b.twice_height + s) * L::load(b.angle + s);
      }
      L::store(sums + lane, sum);
    }
    cosines = sum_of_lanes(sums);
    return !L::any(unserved);
  }
};

}  // namespace

uint32_t measure_power_vertices(const BallArrays &balls, PowerVertexBatch &batch, uint32_t count) {
  return EndKernel<register_lanes>::measure_all(balls, batch, count);
}
bool measure_free_ends(const ArcBatch &batch, double radius, double (&parts)[ArcBatch::room], double &cosines) {
  return EndKernel<register_lanes>::measure_arcs(batch, radius, parts, cosines);
}

}  // namespace hsp::HSP_TARGET
