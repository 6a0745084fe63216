// Second derivatives of a weighted area and of the volume, in arrays of their own, for the benchmarks; see handles.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "handles.hpp"

namespace bench {

class SecondDerivatives {
 public:
  // Makes room for all rows of this computed boundary.
  explicit SecondDerivatives(const Boundary &boundary);

  // Rows of blocks, with the pattern of areas.
  void find_rows_of_area();
  void find_rows_of_volume();
  // The second derivatives of the weighted area times a direction.
  void multiply();
  uint32_t blocks() const { return static_cast<uint32_t>(ball_.size()); }

 private:
  void find_rows(double tension, double pressure);
  hsp_gradient_request asked(double tension, double pressure) const;

  const Boundary *boundary_;
  std::vector<double> weight_;
  std::vector<double> direction_;
  std::vector<double> product_;
  std::vector<uint32_t> first_;
  std::vector<uint32_t> ball_;
  std::vector<double> block_;
};

}  // namespace bench
