// The balls that meet a query ball, by gemmi (Debian's package gemmi-dev): cell lists of the centres in single
// precision are asked for all centres within the query radius plus r_max, and each is then tested in double precision
// with its own radius.
#pragma once

#include <memory>
#include <string>

#include "ball_list.hpp"
#include "section_3/grouped_balls.hpp"

namespace bench {

class GemmiSearch {
 public:
  GemmiSearch();
  ~GemmiSearch();

  // `largest_query`: the largest radius that will be asked for, which the size of the cells depends on. The time to
  // make gemmi's model of chains, residues and atoms is part of preparing, not of building.
  void prepare(const support::BallList &balls);
  void build(double largest_query);
  // In no particular order. Centres farther from all atoms than gemmi's box is wide would see its periodic images.
  void meeting(const double *centre, double radius, Hits &hits) const;

 private:
  struct Cells;
  std::unique_ptr<Cells> cells_;
};

// Its version.
std::string gemmi_release();

}  // namespace bench
