#include "library_derivatives.hpp"

LibraryGradient gradient(const LibraryBoundary &boundary, const EnergyTerms &terms) {
  const uint32_t n = boundary.counts().balls;
  std::vector<double> centre(3 * size_t{n});
  std::vector<double> radius(n);
  LibraryGradient result;
  result.flags.resize(n);
  const double *const sigma = terms.sigma.empty() ? nullptr : terms.sigma.data();
  hsp_gradient_request request{};
  request.struct_size = sizeof request;
  request.tangency = terms.tangency;
  request.tension = terms.tension;
  request.pressure = terms.pressure;
  request.sigma = sigma;
  hsp_gradient_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = n;
  outputs.energy = &result.energy;
  outputs.d_centre = centre.data();
  outputs.d_radius = radius.data();
  outputs.flags = result.flags.data();
  expect_ok(hsp_boundary_get_gradient(boundary.handle(), &request, &outputs), "hsp_boundary_get_gradient");
  for (size_t i = 0; i < n; ++i)
    result.by_ball.push_back({centre[3 * i], centre[3 * i + 1], centre[3 * i + 2], radius[i]});
  return result;
}

std::vector<hsp_area_derivative> area_row(const LibraryBoundary &boundary, uint32_t ball, uint32_t tangency) {
  uint32_t needed = 0;
  const int32_t status = hsp_boundary_get_area_row(boundary.handle(), ball, tangency, nullptr, 0, &needed);
  if (status != HSP_E_CAPACITY) expect_ok(status, "hsp_boundary_get_area_row");
  std::vector<hsp_area_derivative> row(needed);
  expect_ok(hsp_boundary_get_area_row(boundary.handle(), ball, tangency, row.data(), needed, &needed),
            "hsp_boundary_get_area_row");
  return row;
}

LibraryFaceMeasures measure_faces(const LibraryBoundary &boundary) {
  const uint32_t faces = boundary.counts().faces;
  LibraryFaceMeasures measures = {std::vector<double>(faces), std::vector<double>(faces)};
  expect_ok(hsp_boundary_measure_faces(boundary.handle(), measures.area.data(), measures.volume.data(), faces, nullptr),
            "hsp_boundary_measure_faces");
  return measures;
}
