// Balls as the C interface takes them.
#pragma once

#include <cstdint>
#include <vector>

namespace support {

struct BallList {
  std::vector<double> xyz;     // [n][3]
  std::vector<double> radius;  // [n]

  uint32_t size() const { return static_cast<uint32_t>(radius.size()); }

  void add(double x, double y, double z, double r) {
    xyz.insert(xyz.end(), {x, y, z});
    radius.push_back(r);
  }
};

}  // namespace support
