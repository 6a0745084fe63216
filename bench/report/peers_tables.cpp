#include "peers_tables.hpp"

#include <string>
#include <vector>

#include "growth.hpp"
#include "markdown.hpp"
#include "surfaces.hpp"

namespace report {
namespace {

struct Peer {
  const char *name;  // in the benchmarks
  const char *heading;
};

constexpr Peer surface_peers[] = {{"freesasa_lr20", "FreeSASA L&R 20"},
                                  {"freesasa_sr100", "FreeSASA S&R 100"},
                                  {"cgal_regular", "CGAL triangulation"},
                                  {"cgal_alpha", "CGAL alpha complex"}};
constexpr Peer search_peers[] = {{"nanoflann", "nanoflann"}, {"gemmi", "gemmi"}};

bool any_with_prefix(const Run &run, const std::string &prefix) {
  return !molecules_by_size(run, prefix).empty();
}

// "12.3 (4.56)": nanoseconds each, and how many times as long as the library.
std::string time_and_ratio(const Measurement &m, const std::string &peer, const char *divisor) {
  const double seconds = m.counter(peer + "_seconds");
  if (!(seconds > 0)) return "-";
  return three_digits(seconds / m.counter(divisor) * 1e9) + " (" + three_digits(m.counter(peer + "_ratio")) + ")";
}

std::string error(const Measurement &m, const std::string &counter) {
  return m.counters.contains(counter) ? scientific(m.counter(counter)) : "-";
}

void write_surface(std::ostream &out, const Run &run, const Surface &surface) {
  const std::string prefix = std::string("peers/surfaces/") + surface.name + '/';
  std::vector<std::string> heads{"molecule", "n", "library"};
  for (const Peer &peer : surface_peers) heads.emplace_back(peer.heading);
  Table times(heads);
  Table errors({"molecule", "library: area", "volume", "L&R 20: area", "per ball", "S&R 100: area", "per ball",
                "vertices, library = CGAL"});
  for (const std::string &molecule : molecules_by_size(run, prefix)) {
    const Measurement *m = run.find(prefix + molecule);
    if (m == nullptr) {
      out << "- " << molecule << ": " << run.benchmarks.at(prefix + molecule).error << '\n';
      continue;
    }
    std::vector<std::string> cells{molecule, grouped(m->counter("atoms")),
                                   three_digits(m->counter("library_seconds") / m->counter("atoms") * 1e9)};
    for (const Peer &peer : surface_peers) cells.push_back(time_and_ratio(*m, peer.name, "atoms"));
    times.row(cells);
    errors.row({molecule, error(*m, "library_area_error"), error(*m, "library_volume_error"),
                error(*m, "freesasa_lr20_area_error"), error(*m, "freesasa_lr20_ball_error"),
                error(*m, "freesasa_sr100_area_error"), error(*m, "freesasa_sr100_ball_error"),
                m->counter("vertices") > 0 ? grouped(m->counter("vertices")) : "-"});
  }
  out << surface.heading << ", ns per ball:\n\n";
  times.write(out);
  out << "Relative errors:\n\n";
  errors.write(out);
}

void write_searches(std::ostream &out, const Run &run) {
  const std::pair<const char *, const char *> kinds[] = {
      {"build", "building, per ball"}, {"point_box", "point in the box"},  {"point_atom", "point near an atom"},
      {"ball_box", "ball in the box"}, {"ball_atom", "ball near an atom"}, {"lists", "neighbour lists, per ball"}};
  std::vector<std::string> heads{"what", "molecule", "n", "library"};
  for (const Peer &peer : search_peers) heads.emplace_back(peer.heading);
  Table table(heads);
  for (const auto &[kind, heading] : kinds) {
    const std::string prefix = std::string("peers/queries/") + kind + '/';
    for (const std::string &molecule : molecules_by_size(run, prefix)) {
      const Measurement *m = run.find(prefix + molecule);
      if (m == nullptr || m->counter("atoms") < 300) continue;
      const char *divisor = std::string(kind) == "build" ? "atoms" : "queries";
      std::vector<std::string> cells{heading, molecule, grouped(m->counter("atoms")),
                                     three_digits(m->counter("library_seconds") / m->counter(divisor) * 1e9)};
      for (const Peer &peer : search_peers) cells.push_back(time_and_ratio(*m, peer.name, divisor));
      table.row(cells);
    }
  }
  table.write(out);
}

}  // namespace

void write_peers(std::ostream &out, const Run &run) {
  out << "## Other programs\n\n";
  const bool surfaces_measured = any_with_prefix(run, "peers/surfaces/");
  const bool searches_measured = any_with_prefix(run, "peers/queries/");
  if (!surfaces_measured && !searches_measured) {
    out << "Skipped: `bash bench/run.sh --peers` installs and times them.\n\n";
    return;
  }
  out << "In the same process, by turns with the library, on the same balls with the same radii and probe, one thread, "
         "nothing\nread or written meanwhile. In brackets: how many times as long as the library, the median over the "
         "turns.\n\n";
  for (const auto &[key, value] : run.context) {
    if (key.starts_with("peer_")) out << "- " << key.substr(5) << ' ' << value << '\n';
  }
  for (const std::string &name : run.order) {
    if (name.starts_with("peers/skipped/")) {
      out << "- " << name.substr(14) << ": " << run.benchmarks.at(name).error << '\n';
    }
  }
  if (surfaces_measured) {
    out << R"(
### Areas and volumes

Library: model, Steps 1 and 2, areas and volumes of every ball, exact. FreeSASA (freesasa_calc_coord): areas alone, by
Lee and Richards with 20 slices a ball or by Shrake and Rupley with 100 points, its defaults; a dash by points is a set
with a ball that meets no other, on which it crashes. CGAL (inexact constructions, exact predicates): the regular
triangulation alone, then with the alpha complex at alpha 0 (Fixed_alpha_shape_3), which is the combinatorics of the
union without any area; the vertices of the boundary that follow from it are counted and equal the library's. Errors of
total areas and volumes are against an integration over slices that shares nothing with any of these programs (crambin,
sod_model), those of FreeSASA on other sets against the library. Per ball: the mean error of a ball's area, in units of
the mean area; in totals errors cancel.

)";
    for (const Surface &surface : surfaces) write_surface(out, run, surface);
  }
  if (searches_measured) {
    out << R"(
### Searches

Van der Waals balls, nanoseconds. nanoflann: a k-d tree of the centres, leaves of 10; gemmi: NeighborSearch, cell lists
in single precision, with cells for the largest query asked for. Neither knows radii of balls: the search is for centres
within the query's radius and r_max, then each ball's own radius is tested as its hits come in. Their hits are not
sorted, the library's are; all find the same balls. 20,000 distinct centres; query balls have radius r_max. Neighbour
lists: hsp_query_pairs against a query for every ball.

)";
    write_searches(out, run);
  }
}

}  // namespace report
