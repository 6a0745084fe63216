#include "peers/fcl_collision.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/config.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

#include <vector>

namespace bench {
namespace {

using Manager = fcl::DynamicAABBTreeCollisionManagerd;

fcl::Vector3d centre_of(const support::BallList &balls, size_t i) {
  return {balls.xyz[3 * i], balls.xyz[3 * i + 1], balls.xyz[3 * i + 2]};
}

struct Molecule {
  explicit Molecule(const support::BallList &balls) {
    for (size_t i = 0; i < balls.size(); ++i) {
      fcl::Transform3d at = fcl::Transform3d::Identity();
      at.translation() = centre_of(balls, i);
      objects.push_back(std::make_unique<fcl::CollisionObjectd>(std::make_shared<fcl::Sphered>(balls.radius[i]), at));
      manager.registerObject(objects.back().get());
    }
    manager.setup();
  }
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
  Manager manager;
};

bool ends_at_first_contact(fcl::CollisionObjectd *a, fcl::CollisionObjectd *b, void *found) {
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  fcl::collide(a, b, request, result);
  if (result.isCollision()) *static_cast<bool *>(found) = true;
  return result.isCollision();
}

}  // namespace

struct FclCollision::Scene {
  Molecule fixed, moving;
  const support::BallList *balls;
};

FclCollision::FclCollision(const support::BallList &fixed, const support::BallList &moving)
    : scene_(new Scene{Molecule(fixed), Molecule(moving), &moving}) {}

FclCollision::~FclCollision() = default;

bool FclCollision::hits(const hsp_pose &pose) {
  const double *const q = pose.quaternion, *const t = pose.translation;
  const Eigen::Matrix3d turn = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
  const fcl::Vector3d shift(t[0], t[1], t[2]);
  for (size_t i = 0; i < scene_->moving.objects.size(); ++i) {
    fcl::CollisionObjectd &object = *scene_->moving.objects[i];
    object.setTranslation(turn * centre_of(*scene_->balls, i) + shift);
    object.computeAABB();
  }
  scene_->moving.manager.update();
  bool found = false;
  scene_->fixed.manager.collide(&scene_->moving.manager, &found, ends_at_first_contact);
  return found;
}

std::string fcl_release() {
  return FCL_VERSION;
}

}  // namespace bench
