// Derivatives and face-wise measures of the C interface as owned arrays.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "library_run.hpp"

// E = tension * sum sigma_i A_i + pressure * V.
struct EnergyTerms {
  double tension = 1;
  double pressure = 0;
  std::vector<double> sigma;  // empty for all ones
  uint32_t tangency = HSP_TANGENT_OVERLAP;
};

// The derivatives by the three coordinates of one ball's centre and by its radius.
using FourDerivatives = std::array<double, 4>;

struct LibraryGradient {
  hsp_energy energy{};
  std::vector<FourDerivatives> by_ball;
  std::vector<uint32_t> flags;
};

LibraryGradient gradient(const LibraryBoundary &boundary, const EnergyTerms &terms);

std::vector<hsp_area_derivative> area_row(const LibraryBoundary &boundary, uint32_t ball,
                                          uint32_t tangency = HSP_TANGENT_OVERLAP);

struct LibraryFaceMeasures {
  std::vector<double> area;
  std::vector<double> volume;
};

LibraryFaceMeasures measure_faces(const LibraryBoundary &boundary);
