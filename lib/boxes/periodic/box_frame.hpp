// The axes of a periodic box in the frame of the caller: a along x, b in the plane of x and y.
//
//          b            x = a/|a|, y along the part of b across x, z = x x y; of length 1 up to a few roundings.
//          |    /       A vector is turned in by its products with the axes, and turned back by their sum. Nothing is
//      y   |  / c       mirrored. The axes depend on the three vectors alone and not on the lattice, bit for bit; turns
//      |   |/           that exchange axes of the caller are exact. Vectors that lie so already are not turned:
//      '-- '--- a  x    everything keeps its bits.
#pragma once

#include "core/vec3.hpp"
#include "curvature/strain.hpp"

namespace hsp {

class BoxFrame {
 public:
  // vector: a, b, c as rows, finite. False if they are too small, or if a and b span no plane.
  bool set(const double vector[9]);

  // Whether the axes differ from those of the caller.
  bool turns() const { return turns_; }
  const Vec3 &axis(int k) const { return axis_[k]; }
  bool operator==(const BoxFrame &other) const;

  // Turns a vector from the caller's frame to that of the box.
  Vec3 turned_in(const double v[3]) const {
    const Vec3 given{v[0], v[1], v[2]};
    return turns_ ? Vec3{dot(axis_[0], given), dot(axis_[1], given), dot(axis_[2], given)} : given;
  }
  // Turns a vector from the frame of the box to the caller's.
  Vec3 turned_back(const Vec3 &v) const {
    return turns_ ? combine(1.0, combine(v.x, axis_[0], v.y, axis_[1]), v.z, axis_[2]) : v;
  }
  void turn_back(double v[3]) const {
    const Vec3 own = turned_back({v[0], v[1], v[2]});
    v[0] = own.x;
    v[1] = own.y;
    v[2] = own.z;
  }
  // Turns back each row, as of derivatives by vectors.
  Strain rows_turned_back(const Strain &rows) const;
  // Turns back rows and columns, as of derivatives by a strain or by two centres.
  Strain strain_turned_back(const Strain &strain) const;

 private:
  bool turns_ = false;
  Vec3 axis_[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
};

}  // namespace hsp
