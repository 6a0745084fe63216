// Whether two molecules meet, by FCL (Debian's package libfcl-dev): a sphere for each ball and a dynamic AABB tree over
// the spheres of each molecule; the first contact ends the search. FCL has no rigid union of spheres, so every pose
// moves all objects of the moving molecule and updates its tree.
#pragma once

#include <hardsphere.h>

#include <memory>
#include <string>

#include "ball_list.hpp"

namespace bench {

class FclCollision {
 public:
  FclCollision(const support::BallList &fixed, const support::BallList &moving);
  ~FclCollision();
  FclCollision(const FclCollision &) = delete;
  FclCollision &operator=(const FclCollision &) = delete;

  bool hits(const hsp_pose &pose);

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

// Its version.
std::string fcl_release();

}  // namespace bench
