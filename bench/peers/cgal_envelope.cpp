#include "peers/cgal_envelope.hpp"

#include <CGAL/Arr_conic_traits_2.h>
#include <CGAL/CORE_algebraic_number_traits.h>
#include <CGAL/Cartesian.h>
#include <CGAL/Env_sphere_traits_3.h>
#include <CGAL/envelope_3.h>
#include <CGAL/version.h>

#include <cmath>
#include <vector>

namespace bench {
namespace {

using Numbers = CGAL::CORE_algebraic_number_traits;
using RationalKernel = CGAL::Cartesian<Numbers::Rational>;
using AlgebraicKernel = CGAL::Cartesian<Numbers::Algebraic>;
using Conics = CGAL::Arr_conic_traits_2<RationalKernel, AlgebraicKernel, Numbers>;
using Spheres = CGAL::Env_sphere_traits_3<Conics>;
using Envelope = CGAL::Envelope_diagram_2<Spheres>;

Numbers::Rational thousandths(double length) {
  return {static_cast<int>(std::lround(length * 1000)), 1000};
}

}  // namespace

size_t cgal_envelope_faces(const support::BallList &balls) {
  std::vector<Spheres::Surface_3> spheres;
  for (size_t i = 0; i < balls.size(); ++i) {
    const Numbers::Rational radius = thousandths(balls.radius[i]);
    // z is negated and the lower envelope taken: CGAL's upper envelope of spheres has too many faces, its lower one has
    // not.
    const RationalKernel::Point_3 centre(thousandths(balls.xyz[3 * i]), thousandths(balls.xyz[3 * i + 1]),
                                         thousandths(-balls.xyz[3 * i + 2]));
    spheres.emplace_back(centre, radius * radius);
  }
  Envelope envelope;
  CGAL::lower_envelope_3(spheres.begin(), spheres.end(), envelope);
  return envelope.number_of_faces();
}

std::string cgal_envelope_release() {
  return CGAL_VERSION_STR;
}

}  // namespace bench
