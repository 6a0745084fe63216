// Molecule against molecule (hsp_body_*), as docking asks: 100, 327 and 4392 atoms in many poses against the stand-in
// for SOD. "free": a fifth of an Angstrom apart, where all balls near the contact have to be looked at; "overlap": half
// an Angstrom deep; "away": 5 Angstrom apart.
#include "pose_workload.hpp"
#include "suite.hpp"

namespace bench {
namespace {

using Poses = std::vector<hsp_pose>;

constexpr size_t poses = 400;

struct Place {
  const char *name;
  double gap;
};
constexpr Place places[] = {{"free", 0.2}, {"overlap", -0.5}, {"away", 5}};

// The data that all cases of one moving molecule share, one at a time.
struct Meeting {
  PreparedBody fixed{resting_molecule()};
  PreparedBody moving;
  Poses at[std::size(places)];

  explicit Meeting(const Balls &balls) : moving(balls) {
    for (size_t k = 0; k < std::size(places); ++k) at[k] = slid_poses(fixed, moving, poses, places[k].gap);
  }
};

std::unique_ptr<Meeting> alive;

const Meeting &meeting_of(const Balls &balls) {
  if (alive == nullptr || alive->moving.balls().name != balls.name) {
    alive.reset();
    alive = std::make_unique<Meeting>(balls);
  }
  return *alive;
}

using Question = double (*)(const Meeting &, const Poses &);

// The time is that of all poses. A counter has the sum of the answers, per pose.
void measure(benchmark::State &state, const Balls &balls, const Question &ask, size_t place) {
  try {
    const Meeting &meeting = meeting_of(balls);
    double answer = 0;
    iterate(state, [&] { answer = ask(meeting, meeting.at[place]); });
    state.counters["atoms"] = balls.size();
    state.counters["poses"] = poses;
    state.counters["answer_per_pose"] = answer / poses;
  } catch (const std::exception &error) {
    state.SkipWithError(error.what());
  }
}

void prepare(benchmark::State &state, const Balls &balls) {
  PreparedBody body(balls);
  iterate(state, [&] { body.set(); });
  state.counters["atoms"] = balls.size();
}

void add(const std::string &name, const std::function<void(benchmark::State &)> &run) {
  benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMicrosecond);
}

double hits(const Meeting &meeting, const Poses &at) {
  return static_cast<double>(count_hits(meeting.fixed, meeting.moving, at));
}

double gaps(const Meeting &meeting, const Poses &at) {
  return sum_gaps(meeting.fixed, meeting.moving, at);
}

double pairs(const Meeting &meeting, const Poses &at) {
  return static_cast<double>(count_pairs(meeting.fixed, meeting.moving, at));
}

}  // namespace

void register_suite() {
  const std::pair<const char *, Question> questions[] = {{"hit", hits}, {"gap", gaps}, {"pairs", pairs}};
  for (const Balls &balls : moving_molecules()) {
    for (const auto &[what, ask] : questions) {
      for (size_t k = 0; k < std::size(places); ++k) {
        const Question question = ask;
        add(std::string("poses/") + what + '_' + places[k].name + '/' + balls.name,
            [balls, question, k](benchmark::State &state) { measure(state, balls, question, k); });
      }
    }
    add("poses/set/" + balls.name, [balls](benchmark::State &state) { prepare(state, balls); });
  }
}

}  // namespace bench
