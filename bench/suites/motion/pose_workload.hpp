// Molecules in poses: the stand-in for SOD at rest, another one near it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "handles.hpp"

namespace bench {

// hsp_body of some balls, about their mean, with the model that it was made of.
class PreparedBody {
 public:
  explicit PreparedBody(Balls balls);

  // hsp_body_set with the model once more.
  void set() { expect_ok(hsp_body_set(get(), model_->get()), "hsp_body_set"); }

  hsp_body *get() const { return body_; }
  const Balls &balls() const { return *balls_; }
  uint32_t size() const { return balls_->size(); }
  // How far balls reach from their mean.
  double reach() const;

 private:
  std::unique_ptr<Balls> balls_;
  std::unique_ptr<Model> model_;
  std::vector<unsigned char> memory_;
  hsp_body *body_ = nullptr;
};

// The moving molecules: the first 100 atoms of crambin, crambin, and the stand-in itself.
std::vector<Balls> moving_molecules();
// The molecule at rest.
Balls resting_molecule();

// Poses as docking has them: the moving molecule is turned at random and slid along a random line through both means
// until it touches, then taken back by `gap`: 0.2 Angstrom make a free pose at contact, -0.5 an overlap.
std::vector<hsp_pose> slid_poses(const PreparedBody &fixed, const PreparedBody &moving, size_t count, double gap);

// count_hits: the number of poses in which balls meet. sum_gaps: the sum of the gaps of all poses. count_pairs: the
// number of pairs that meet, over all poses.
size_t count_hits(const PreparedBody &fixed, const PreparedBody &moving, const std::vector<hsp_pose> &poses);
double sum_gaps(const PreparedBody &fixed, const PreparedBody &moving, const std::vector<hsp_pose> &poses);
size_t count_pairs(const PreparedBody &fixed, const PreparedBody &moving, const std::vector<hsp_pose> &poses);

}  // namespace bench
