// Whether molecules meet in a pose (hsp_body_hits) by turns with other programs: FCL, and nanoflann asked for every
// atom of the moving molecule. All have the same poses and must find the same answers. Programs that are not installed
// are skipped.
#include <stdexcept>

#include "alternation.hpp"
#include "pose_workload.hpp"
#include "suite.hpp"
#ifdef BENCH_FCL
#include "peers/fcl_collision.hpp"
#endif
#ifdef BENCH_NANOFLANN
#include "peers/nanoflann_search.hpp"
#endif

namespace bench {
namespace {

constexpr int turns = 7;
constexpr size_t poses = 100;

#ifdef BENCH_NANOFLANN
// Rows of the matrix of the quaternion.
struct Placement {
  explicit Placement(const hsp_pose &pose) : t(pose.translation) {
    const double *const q = pose.quaternion;
    const double w = q[0], x = q[1], y = q[2], z = q[3], s = 2 / (w * w + x * x + y * y + z * z);
    const double rows[9] = {1 - s * (y * y + z * z), s * (x * y - w * z),     s * (x * z + w * y),
                            s * (x * y + w * z),     1 - s * (x * x + z * z), s * (y * z - w * x),
                            s * (x * z - w * y),     s * (y * z + w * x),     1 - s * (x * x + y * y)};
    std::copy(rows, rows + 9, m);
  }
  void place(const double *from, double *to) const {
    for (size_t k = 0; k < 3; ++k) {
      to[k] = m[3 * k] * from[0] + m[3 * k + 1] * from[1] + m[3 * k + 2] * from[2] + t[k];
    }
  }
  double m[9];
  const double *t;
};

bool hits_by_atoms(const NanoflannSearch &search, const Balls &moving, const hsp_pose &pose) {
  const Placement placement(pose);
  uint32_t ids[64];
  for (size_t i = 0; i < moving.size(); ++i) {
    double at[3];
    placement.place(&moving.xyz[3 * i], at);
    Hits hits{ids, 64};
    search.meeting(at, moving.radius[i], hits);
    if (hits.count > 0) return true;
  }
  return false;
}
#endif

using Ask = std::function<bool(const hsp_pose &)>;

[[maybe_unused]] void add_peer(std::vector<Part> &parts, const char *name, const std::vector<hsp_pose> &at,
                               size_t expected, const Ask &ask) {
  const auto count = [&at, ask] { return static_cast<size_t>(std::count_if(at.begin(), at.end(), ask)); };
  if (count() != expected) throw std::runtime_error(std::string(name) + " finds other hits");
  parts.push_back({name, [count] { benchmark::DoNotOptimize(count()); }});
}

void hit(benchmark::State &state, const Balls &balls, double gap) {
  const PreparedBody fixed(resting_molecule()), moving(balls);
  const std::vector<hsp_pose> at = slid_poses(fixed, moving, poses, gap);
  [[maybe_unused]] const size_t expected = count_hits(fixed, moving, at);
  std::vector<Part> parts{{"library", [&] { count_hits(fixed, moving, at); }}};
#ifdef BENCH_FCL
  FclCollision fcl(fixed.balls(), moving.balls());
  add_peer(parts, "fcl", at, expected, [&](const hsp_pose &pose) { return fcl.hits(pose); });
#endif
#ifdef BENCH_NANOFLANN
  NanoflannSearch nanoflann;
  nanoflann.build(fixed.balls());
  add_peer(parts, "nanoflann", at, expected,
           [&](const hsp_pose &pose) { return hits_by_atoms(nanoflann, moving.balls(), pose); });
#endif
  state.counters["atoms"] = moving.size();
  state.counters["poses"] = poses;
  alternate(state, moving.size(), parts);
}

}  // namespace

void register_suite() {
  const std::pair<const char *, double> places[] = {{"free", 0.2}, {"overlap", -0.5}, {"away", 5}};
  for (const Balls &balls : moving_molecules()) {
    for (const auto &[name, gap] : places) {
      benchmark::RegisterBenchmark((std::string("peers/poses/") + name + '/' + balls.name).c_str(),
                                   [balls, gap = gap](benchmark::State &state) {
                                     try {
                                       hit(state, balls, gap);
                                     } catch (const std::exception &error) {
                                       state.SkipWithError(error.what());
                                     }
                                   })
          ->Unit(benchmark::kMicrosecond)
          ->Iterations(turns);
    }
  }
#ifdef BENCH_FCL
  benchmark::AddCustomContext("peer_fcl", fcl_release());
#else
  register_skipped("peers/skipped/fcl", "libfcl-dev is not installed");
#endif
}

}  // namespace bench
