#include "peers/freesasa_areas.hpp"

#include <freesasa.h>

#include <stdexcept>

// Defined in FreeSASA's archive, but missing in its header.
extern "C" const char *freesasa_version;

namespace bench {

std::vector<double> freesasa_areas(const support::BallList &balls, double probe, FreesasaMethod method) {
  freesasa_parameters parameters = freesasa_default_parameters;
  parameters.alg = method == FreesasaMethod::lee_richards_20 ? FREESASA_LEE_RICHARDS : FREESASA_SHRAKE_RUPLEY;
  parameters.lee_richards_n_slices = 20;
  parameters.shrake_rupley_n_points = 100;
  parameters.probe_radius = probe;
  parameters.n_threads = 1;
  freesasa_result *result =
      freesasa_calc_coord(balls.xyz.data(), balls.radius.data(), static_cast<int>(balls.size()), &parameters);
  if (result == nullptr) throw std::runtime_error("FreeSASA failed");
  std::vector<double> areas(result->sasa, result->sasa + result->n_atoms);
  freesasa_result_free(result);
  return areas;
}

std::string freesasa_release() {
  return freesasa_version;
}

}  // namespace bench
