#include "periodic/surface_volume.hpp"

#include <initializer_list>

#include "core/decimal.hpp"

namespace hsp {

SurfaceVolume::SurfaceVolume(const PeriodicUnion &periodic)
    : periodic_(periodic), box_volume_(periodic.images().box().volume()) {
  const PeriodicBox &box = periodic.images().box();
  const Vec3 a = to_double(box.translation({{1, 0, 0}})), b = to_double(box.translation({{0, 1, 0}})),
             c = to_double(box.translation({{0, 0, 1}}));
  u_ = (1.0 / box_volume_) * cross(b, c);
  v_ = (1.0 / box_volume_) * cross(c, a);
  w_ = (1.0 / box_volume_) * cross(a, b);
  vw_ = (1.0 / box_volume_) * a;
}

BallMeasure SurfaceVolume::measure(uint32_t face, uint32_t origin) const {
  const Boundary &boundary = periodic_.boundary();
  const BallSet &balls = periodic_.balls();
  const uint32_t own = boundary.face(face).ball;
  const double r = balls.r[own];
  Vec3 centre = balls.difference(origin, own);
  const BoxShift away = periodic_.images().box().centre(centre);
  FreeSurface surface(boundary, r);
  Seam seam;
  ArcBatches arcs(balls, boundary, own, face);
  while (arcs.next()) {
    const ArcBatch &batch = arcs.batch();
    surface.add(batch);
    for (uint32_t s = 0; s < batch.count; ++s) {
      if (batch.has_piece(s)) add_piece(batch, s, own, origin, centre, away, seam);
    }
  }
  BallMeasure result;
  result.area = r * r * surface.steradians(1, boundary.loops_of_face(face).size());
  const double whole =
      dot(u_, centre) * dot(vw_, surface.vector_area()) + (dot(u_, vw_) * r * result.area - seam.moment) / 3;
  result.volume = -box_volume_ * (whole + seam.sum);
  return result;
}

double SurfaceVolume::reduced(double sum, double most) const {
  // Whole boxes are subtracted so that the volume is nearest to the middle of its range.
  const double volume = sum - static_cast<double>(nearest((sum - 0.5 * most) / box_volume_)) * box_volume_;
  return volume > 0.0 ? volume : 0.0;
}

// The difference of coordinates across an arc: those of a face on a ball that is `away` from its place, less those of
// the copy of the face on the other ball.
BoxShift SurfaceVolume::shift_across(uint32_t other, uint32_t origin, const BoxShift &away) const {
  const PeriodicImages &images = periodic_.images();
  const uint32_t k = periodic_.balls().caller[other];
  Vec3 difference = periodic_.balls().difference(origin, periodic_.grid().grid_index(images.ball_of(k)));
  return images.shift_of(k) + images.box().centre(difference) - away;
}

// Let w = -u be the axis about which the arc runs counter-clockwise, with the face on its left; C the centre of its
// circle, m the radius vector from there, t = w x m and H = -C.u. Then for two vectors p and q
//   3 integral over the face of (n.p)(n.q) = p.q area - sum over arcs of integral of (n.p)(q.nu) ds
// (divergence of (n.p)(q - (n.q) n) on the sphere; nu points out of the face), where times r^3
//   (n.p)(q.nu) ds = [H^2 (w.p)(m.q) - H R^2 (w.p)(w.q) + H (m.p)(m.q) - R^2 (w.q)(m.p)] dphi,
//   m dphi = -dt,   m m^T dphi = R^2/2 (1 - w w^T) dphi - d(m t^T + t m^T)/4,
//   m t^T dphi = d(m m^T)/2 + an antisymmetric matrix, with m x t = R^2 w
void SurfaceVolume::add_piece(const ArcBatch &batch, uint32_t s, uint32_t own, uint32_t origin, const Vec3 &centre,
                              const BoxShift &away, Seam &seam) const {
  const Vec3 axis{-batch.ux[s], -batch.uy[s], -batch.uz[s]};
  const double H = -0.5 * batch.twice_height[s], r = periodic_.balls().r[own], angle = batch.angle[s];
  const double R2 = r * r - H * H > 0.0 ? r * r - H * H : 0.0;
  const bool is_arc = batch.arc[s] != 0;
  Vec3 m[2]{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  for (const uint32_t end : {0U, 1U}) {
    const uint32_t at = end == 0 ? s : batch.next[s];
    if (is_arc) m[end] = 0.5 * Vec3{batch.px[at], batch.py[at], batch.pz[at]} - H * axis;
  }
  const Vec3 t[2]{cross(axis, m[0]), cross(axis, m[1])}, turned = t[0] - t[1];
  const double wp = dot(axis, u_), wq = dot(axis, vw_);
  const auto symmetric = [&](int end) {
    return dot(u_, m[end]) * dot(vw_, t[end]) + dot(u_, t[end]) * dot(vw_, m[end]);
  };
  seam.moment += H * H * wp * dot(vw_, turned) - H * R2 * wp * wq * angle +
                 H * (0.5 * R2 * angle * (dot(u_, vw_) - wp * wq) - 0.25 * (symmetric(1) - symmetric(0))) -
                 R2 * wq * dot(u_, turned);

  const Span<const uint32_t> caller = periodic_.balls().caller;
  const uint32_t other = batch.other[s];
  if (!periodic_.comes_first(caller[own], caller[other])) return;
  const BoxShift across = shift_across(other, origin, away);
  const double n_u = across.k[0], n_v = across.k[1];
  if (across.k[0] == 0) return;
  const Vec3 middle = centre + H * axis;
  const auto square = [&](int end) { return dot(v_, m[end]) * dot(w_, m[end]); };
  seam.sum -= n_u * ((dot(v_, middle) - n_v) * dot(w_, m[1] - m[0]) + 0.5 * (square(1) - square(0)) +
                     0.5 * R2 * angle * dot(vw_, axis));
  for (const int end : {0, 1}) {
    const uint32_t third = batch.other[end == 0 ? batch.previous[s] : batch.next[s]];
    if (!is_arc || !periodic_.comes_first(caller[other], caller[third])) continue;
    const double further = shift_across(third, origin, away).k[1] - n_v;
    seam.sum += (end == 0 ? -n_u : n_u) * further * dot(w_, middle + m[end]);
  }
}

}  // namespace hsp
