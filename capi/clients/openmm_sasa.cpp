// OpenMM 7.7: a surface energy as a force of one's own, without a plugin of kernels; nm and kJ/mol. On the Reference
// platform forces are added to the platform's array. OpenMM 8 has CustomCPPForceImpl for this, on all platforms.
// Prints the worst difference of forces from quotients, the largest force, and how far the total energy goes in NVE.
//   g++ -O2 -std=c++17 openmm_sasa.cpp $(pkg-config --cflags --libs hardsphere) -lOpenMM -o openmm_sasa
//   ./openmm_sasa TENSION STEP-IN-PS STEPS [box]         box: periodic, with vectors that are not at right angles
#include <OpenMM.h>
#include <openmm/internal/ContextImpl.h>
#include <openmm/internal/ForceImpl.h>
#include <openmm/reference/ReferencePlatform.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "surface_forces.h"

class SurfaceForce : public OpenMM::Force {
 public:
  SurfaceForce(double tension, double probe, bool periodic) : tension(tension), probe(probe), periodic(periodic) {}
  void add(double r) { radius.push_back(r); }
  bool usesPeriodicBoundaryConditions() const override { return periodic; }

  double tension, probe;
  bool periodic;
  std::vector<double> radius;

 protected:
  OpenMM::ForceImpl *createImpl() const override;
};

class SurfaceForceImpl : public OpenMM::ForceImpl {
 public:
  explicit SurfaceForceImpl(const SurfaceForce &owner) : owner_(owner) {
    surface_.probe = owner.probe;
    surface_.tension = owner.tension;
    surface_.largest_radius = *std::max_element(owner.radius.begin(), owner.radius.end());
  }
  ~SurfaceForceImpl() override { surface_forces_free(&surface_); }
  void initialize(OpenMM::ContextImpl &) override {}
  const OpenMM::Force &getOwner() const override { return owner_; }
  std::map<std::string, double> getDefaultParameters() override { return {}; }
  std::vector<std::string> getKernelNames() override { return {}; }
  void updateContextState(OpenMM::ContextImpl &, bool &) override {}

  double calcForcesAndEnergy(OpenMM::ContextImpl &context, bool forces, bool, int groups) override {
    if ((groups & (1 << owner_.getForceGroup())) == 0) return 0;
    context.getPositions(x_);
    const auto n = static_cast<uint32_t>(x_.size());
    double energy = 0;
    OpenMM::Vec3 box[3];
    if (owner_.periodic) context.getPeriodicBoxVectors(box[0], box[1], box[2]);
    const int32_t status =
        owner_.periodic
            ? surface_forces_compute_in_box(&surface_, n, &x_[0][0], owner_.radius.data(), &box[0][0], &energy)
            : surface_forces_compute(&surface_, n, n, &x_[0][0], owner_.radius.data(), &energy);
    if (status != HSP_OK) throw OpenMM::OpenMMException(hsp_status_text(status));
    if (forces) {
      auto *data = reinterpret_cast<OpenMM::ReferencePlatform::PlatformData *>(context.getPlatformData());
      auto &all = *reinterpret_cast<std::vector<OpenMM::Vec3> *>(data->forces);
      for (size_t i = 0; i < all.size(); ++i) {
        for (size_t k = 0; k < 3; ++k) all[i][static_cast<int>(k)] -= surface_.gradient[3 * i + k];
      }
    }
    return energy;
  }

 private:
  const SurfaceForce &owner_;
  surface_forces surface_{};
  std::vector<OpenMM::Vec3> x_;
};

OpenMM::ForceImpl *SurfaceForce::createImpl() const {
  return new SurfaceForceImpl(*this);
}

int main(int count, char **arguments) {
  if (count != 4 && count != 5) {
    std::fprintf(stderr, "usage: openmm_sasa TENSION DT STEPS [box]\n");
    return 2;
  }
  const bool periodic = count == 5;
  const double tension = std::atof(arguments[1]), dt = std::atof(arguments[2]);
  OpenMM::System system;
  auto *pairs = new OpenMM::NonbondedForce;
  auto *surface = new SurfaceForce(tension, 0.14, periodic);
  std::vector<OpenMM::Vec3> x;
  for (int i = 0; i < 216; ++i) {
    system.addParticle(39.95);
    pairs->addParticle(0, 0.34, 0.997);
    surface->add(0.19);
    x.push_back(OpenMM::Vec3(i % 6, i / 6 % 6, i / 36) * 0.375 +
                OpenMM::Vec3(std::sin(i), std::cos(3 * i), std::sin(7 * i)) * 0.01);
  }
  if (periodic) {
    system.setDefaultPeriodicBoxVectors({2.25, 0, 0}, {0.6, 2.25, 0}, {-0.5, 0.7, 2.25});
    pairs->setNonbondedMethod(OpenMM::NonbondedForce::CutoffPeriodic);
    pairs->setUseSwitchingFunction(true);
    pairs->setSwitchingDistance(0.8);
  }
  system.addForce(pairs);
  system.addForce(surface);
  OpenMM::CustomIntegrator integrator(dt);  // energies of one time
  integrator.addUpdateContextState();
  integrator.addComputePerDof("v", "v+0.5*dt*f/m");
  integrator.addComputePerDof("x", "x+dt*v");
  integrator.addComputePerDof("v", "v+0.5*dt*f/m");
  OpenMM::Context context(system, integrator, OpenMM::Platform::getPlatformByName("Reference"));
  const auto potential = [&context](const std::vector<OpenMM::Vec3> &at) {
    context.setPositions(at);
    return context.getState(OpenMM::State::Energy).getPotentialEnergy();
  };
  context.setPositions(x);
  const std::vector<OpenMM::Vec3> force = context.getState(OpenMM::State::Forces).getForces();
  double worst = 0, largest = 0;
  for (size_t i = 0; i < x.size(); i += 31) {
    const int k = static_cast<int>(i % 3);
    std::vector<OpenMM::Vec3> forward = x, back = x;
    forward[i][k] += 1e-5;
    back[i][k] -= 1e-5;
    worst = std::max(worst, std::fabs((potential(back) - potential(forward)) / 2e-5 - force[i][k]));
    largest = std::max(largest, std::fabs(force[i][k]));
  }
  context.setPositions(x);
  context.setVelocitiesToTemperature(40, 5);
  const auto total = [&context] {
    const OpenMM::State state = context.getState(OpenMM::State::Energy);
    return state.getPotentialEnergy() + state.getKineticEnergy();
  };
  const double first = total();
  double away = 0;
  for (int k = 0; k < 20; ++k) {
    integrator.step(std::atoi(arguments[3]) / 20);
    away = std::max(away, std::fabs(total() - first));
  }
  std::printf("%.3e %.6f %.6f\n", worst, largest, away);
  return 0;
}
