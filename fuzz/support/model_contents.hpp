// The contents of models, named by numbers that are equal if and only if the balls were the same. Contents are the same
// if they were set from the same arrays and options, and different if they differ by more than rounding can hide; for
// anything in between it is unknown.
#pragma once

#include <hardsphere.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace fuzz {

struct ModelContents {
  std::vector<double> xyz, radius;
  double options[3];  // probe, step and largest radius as given
  hsp_model_info info;
};

class KnownContents {
 public:
  // The number of contents that a model has taken; 0 if it is unknown whether there is one.
  uint64_t number_of(const ModelContents &contents) {
    bool unknown = false;
    for (size_t k = 0; k < known_.size(); ++k) {
      if (are_same(known_[k], contents)) return first_ + k;
      unknown = unknown || !differ(known_[k], contents);
    }
    if (unknown) return 0;
    known_.push_back(contents);
    return first_ + known_.size() - 1;
  }
  // Forgets all contents but these, which get a number that has not been used.
  uint64_t start_with(const ModelContents &contents) {
    first_ += known_.size();
    known_.assign(1, contents);
    return first_;
  }
  bool any() const { return !known_.empty(); }
  const ModelContents &at(size_t k) const { return known_[k % known_.size()]; }

 private:
  static bool are_same(const ModelContents &a, const ModelContents &b) {
    return a.xyz == b.xyz && a.radius == b.radius && std::equal(a.options, a.options + 3, b.options);
  }
  // Whether some number differs by more than two steps, twice what rounding moves both.
  static bool differ(const ModelContents &a, const ModelContents &b) {
    if (a.radius.size() != b.radius.size() || a.info.step != b.info.step || a.info.probe != b.info.probe) return true;
    const double least = 2 * a.info.step;
    const auto apart = [least](double p, double q) { return std::abs(p - q) > least; };
    for (size_t k = 0; k < a.xyz.size(); ++k) {
      if (apart(a.xyz[k], b.xyz[k])) return true;
    }
    for (size_t i = 0; i < a.radius.size(); ++i) {
      if (apart(a.radius[i], b.radius[i])) return true;
    }
    const auto largest = [](const ModelContents &c) {
      return std::max(c.options[2] > 0 ? c.options[2] + c.info.probe : 0.0, c.info.largest_radius);
    };
    return apart(largest(a), largest(b));
  }

  uint64_t first_ = 1;
  std::vector<ModelContents> known_;
};

}  // namespace fuzz
