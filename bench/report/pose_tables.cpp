#include "pose_tables.hpp"

#include <string>
#include <utility>
#include <vector>

#include "growth.hpp"
#include "markdown.hpp"

namespace report {
namespace {

constexpr std::pair<const char *, const char *> places[] = {
    {"free", "free, 0.2 apart"}, {"overlap", "overlap, 0.5 deep"}, {"away", "5 apart"}};

// Microseconds a pose.
std::string time_of(const Run &run, const std::string &what, const char *place, const std::string &molecule) {
  const Measurement *m = run.find("poses/" + what + '_' + place + '/' + molecule);
  return m == nullptr ? "-" : three_digits(m->median() / m->counter("poses") * 1e6);
}

void write_times(std::ostream &out, const Run &run) {
  Table table({"moving", "n", "pose", "hit", "gap", "pairs", "hits", "pairs a pose"});
  for (const std::string &molecule : molecules_by_size(run, "poses/hit_free/")) {
    for (const auto &[place, heading] : places) {
      const auto answer = [&, place = place](const char *what) {
        const Measurement *m = run.find(std::string("poses/") + what + '_' + place + '/' + molecule);
        return m == nullptr ? std::string("-") : three_digits(m->counter("answer_per_pose"));
      };
      const Measurement *m = run.find(std::string("poses/hit_") + place + '/' + molecule);
      table.row({molecule, m == nullptr ? "-" : grouped(m->counter("atoms")), heading,
                 time_of(run, "hit", place, molecule), time_of(run, "gap", place, molecule),
                 time_of(run, "pairs", place, molecule), answer("hit"), answer("pairs")});
    }
  }
  table.write(out);
  Table preparation({"preparing", "n", "us", "ns per ball"});
  for (const std::string &molecule : molecules_by_size(run, "poses/set/")) {
    const Measurement *m = run.find("poses/set/" + molecule);
    if (m == nullptr) continue;
    preparation.row(
        {molecule, grouped(m->counter("atoms")), three_digits(m->median() * 1e6), three_digits(m->per_atom() * 1e9)});
  }
  preparation.write(out);
}

void write_peers_of_poses(std::ostream &out, const Run &run) {
  constexpr std::pair<const char *, const char *> peers[] = {{"fcl", "FCL"}, {"nanoflann", "nanoflann, by atoms"}};
  Table table({"moving", "n", "pose", "library", peers[0].second, peers[1].second});
  bool any = false;
  for (const std::string &molecule : molecules_by_size(run, "peers/poses/free/")) {
    for (const auto &[place, heading] : places) {
      const Measurement *m = run.find(std::string("peers/poses/") + place + '/' + molecule);
      if (m == nullptr) continue;
      any = true;
      const auto us = [&](const std::string &part) {
        return three_digits(m->counter(part + "_seconds") / m->counter("poses") * 1e6);
      };
      std::vector<std::string> cells{molecule, grouped(m->counter("atoms")), heading, us("library")};
      for (const auto &[peer, name] : peers) {
        static_cast<void>(name);
        const std::string key = peer;
        cells.push_back(m->counters.contains(key + "_ratio")
                            ? us(key) + " (" + three_digits(m->counter(key + "_ratio")) + ")"
                            : "-");
      }
      table.row(cells);
    }
  }
  if (!any) return;
  out << "hit, by turns with other programs, us a pose; in brackets: how many times as long as the library.\n\n";
  table.write(out);
}

}  // namespace

void write_poses(std::ostream &out, const Run &run) {
  out << R"(## Molecule against molecule

The stand-in for SOD at rest, another molecule moving: turned in any way and slid along any line until it touches, then
taken back by 0.2 Angstrom (free poses at contact), or 5, or pushed in by 0.5. us a pose, 400 poses each. hit: whether
any balls meet (hsp_body_hits); gap: the least gap with its pair (hsp_body_gaps); pairs: all pairs that meet
(hsp_body_pairs). The answers are exact for the balls of each pose. FCL has no rigid union of spheres: every pose moves
all objects of the moving molecule. nanoflann is asked for every atom.

)";
  write_times(out, run);
  write_peers_of_poses(out, run);
  out << "\"a molecule with 100 atoms intersects a molecule with 4000 atoms in 0.02 seconds\" (the paper, on a machine "
         "of "
         "1994):\n20,000 us; here 100 atoms of crambin take "
      << time_of(run, "hit", "free", "crambin_100") << " us where they nearly touch, "
      << time_of(run, "hit", "overlap", "crambin_100") << " where they overlap.\n\n";
}

}  // namespace report
