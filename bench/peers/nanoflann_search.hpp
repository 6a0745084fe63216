// The balls that meet a query ball, by nanoflann (Debian's package libnanoflann-dev): a k-d tree of the centres is
// asked for all centres within the query radius plus r_max, and each is then tested with its own radius.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "ball_list.hpp"
#include "section_3/grouped_balls.hpp"

namespace bench {

class NanoflannSearch {
 public:
  NanoflannSearch();
  ~NanoflannSearch();

  void build(const support::BallList &balls);
  // In no particular order.
  void meeting(const double *centre, double radius, Hits &hits) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

// Its version.
std::string nanoflann_release();

}  // namespace bench
