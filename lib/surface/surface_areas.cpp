#include "surface/surface_areas.hpp"

#include "measure/areas.hpp"
#include "sphere/arc_geometry.hpp"
#include "surface/saddle.hpp"

namespace hsp {

// With R the radius with probe and r without, the face and its vector area shrink by (r / R)^2.
SurfaceMeasure measure_surface_of_ball(const BallSet &balls, const Boundary &boundary, const Surface &surface,
                                       uint32_t i) {
  SurfaceMeasure result;
  const uint32_t faces = boundary.faces(i).size();
  if (faces == 0) return result;
  const double p = static_cast<double>(balls.probe_steps);
  const double R = balls.r[i];
  const exact::LatticeBall own = balls.ball(i);
  const exact::Sphere sphere = exact::sphere_of(own);
  const Vec3 origin_to_centre = offset_from_origin(balls, boundary, i);
  double triple_volume = 0.0;

  FreeSurface face(boundary, R);
  ArcBatches arcs(balls, boundary, i);
  while (arcs.next()) {
    const ArcBatch &batch = arcs.batch();
    face.add(batch);
    if (balls.probe_steps == 0) continue;
    for (uint32_t c = 0; c < batch.count; ++c) {
      if (!batch.has_piece(c)) continue;
      const uint32_t other = batch.other[c];
      const exact::LatticeBall neighbour = balls.ball(other);
      const CircleGeometry circle(sphere, exact::plane_of(own, neighbour));
      const double other_height =
          static_cast<double>(exact::plane_of(neighbour, own).h) * 0.5 * batch.inverse_distance[c];
      const SaddleSide side{p,
                            R,
                            balls.r[other],
                            circle.height,
                            other_height,
                            circle.radius,
                            batch.angle[c],
                            circle.axis,
                            {batch.Xx[c], batch.Xy[c], batch.Xz[c]}};
      const SaddleMeasure saddle = measure_saddle(side, origin_to_centre + circle.centre);
      result.saddle += saddle.area;
      triple_volume += saddle.triple_volume;
    }
  }
  const double steradians = face.steradians(faces, boundary.loops(i).size());
  const double r = R - p;
  const double shrinkage = R > 0.0 ? r / R * (r / R) : 0.0;
  result.convex = r * r * steradians;
  triple_volume += r * result.convex + shrinkage * dot(origin_to_centre, face.vector_area());

  double concave = 0.0;
  double concave_volume = 0.0;
  for (const uint32_t e : boundary.half_edges(i)) {
    const ConcavePatch &patch = surface.patch(boundary.half_edge(e).vertex);
    concave += patch.area;
    concave_volume += patch.volume;
  }
  result.concave = concave / 3;
  result.volume = (triple_volume + concave_volume) / 3;
  return result;
}

}  // namespace hsp
