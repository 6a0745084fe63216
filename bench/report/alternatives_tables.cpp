#include "alternatives_tables.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "growth.hpp"
#include "markdown.hpp"

namespace report {
namespace {

struct Structure {
  const char *name;  // in the benchmarks
  const char *heading;
};

constexpr Structure structures[] = {
    {"library", "library"},   {"hashed", "double hashing"}, {"perfect", "perfect hashing"}, {"sorted", "sorted cubes"},
    {"dense", "dense cubes"}, {"paper", "paper's grid"},    {"tree", "range tree"}};

// What is timed, and the counter that says how many balls or queries a time is for.
struct Timed {
  const char *what;
  const char *heading;
  const char *divisor;
};

constexpr Timed timed[] = {{"build", "Building, ns per ball", "atoms"},
                           {"point_box", "Point queries in the box, ns", "queries"},
                           {"ball_box", "Ball queries in the box, ns", "queries"},
                           {"point_atom", "Point queries near atoms, ns", "queries"},
                           {"ball_atom", "Ball queries near atoms, ns", "queries"},
                           {"pairs", "All pairs of balls that meet, ns per ball", "atoms"}};

const std::string suite = "alternatives/";
const std::string large = "sod_stand_in";
const std::string largest = "sod_stand_in_x216";

const Measurement *find(const Run &run, const std::string &what, const std::string &molecule) {
  return run.find(suite + what + '/' + molecule);
}

double nanoseconds(const Measurement &m, const std::string &structure, const char *divisor) {
  return m.counter(structure + "_seconds") / m.counter(divisor) * 1e9;
}

// A cell per structure; a dash for what it does not do.
template <class Value>
std::vector<std::string> row(const std::string &molecule, const Measurement &m, Value value) {
  std::vector<std::string> cells{molecule, grouped(m.counter("atoms"))};
  for (const Structure &structure : structures) {
    const double v = value(structure.name);
    cells.push_back(v > 0 ? three_digits(v) : "-");
  }
  return cells;
}

std::vector<std::string> heads() {
  std::vector<std::string> heads{"molecule", "n"};
  for (const Structure &structure : structures) heads.emplace_back(structure.heading);
  return heads;
}

void write_times(std::ostream &out, const Run &run, const Timed &what) {
  Table table(heads());
  for (const std::string &molecule : molecules_by_size(run, suite + what.what + '/')) {
    const Measurement *m = find(run, what.what, molecule);
    if (m == nullptr) continue;
    table.row(row(molecule, *m, [&](const std::string &name) { return nanoseconds(*m, name, what.divisor); }));
  }
  out << what.heading << ":\n\n";
  table.write(out);
}

void write_memory(std::ostream &out, const Run &run) {
  Table table(heads());
  const std::string prefix = suite + "build/";
  for (const std::string &molecule : molecules_by_size(run, prefix)) {
    const Measurement *m = run.find(prefix + molecule);
    if (m == nullptr) continue;
    table.row(
        row(molecule, *m, [&](const std::string &name) { return m->counter(name + "_bytes") / m->counter("atoms"); }));
  }
  std::vector<std::string> exponents{"fitted exponent of n", "all"};
  for (const Structure &structure : structures) {
    const double fitted = growth_exponent(run, prefix, 0, counter_of(std::string(structure.name) + "_bytes"));
    exponents.push_back(std::isnan(fitted) ? "-" : fixed(fitted, 3));
  }
  table.row(exponents);
  out << "Memory, bytes per ball:\n\n";
  table.write(out);
}

// How many times longer one structure takes than another; in turns, so that it holds on a busy machine.
std::string ratio(const Run &run, const std::string &what, const std::string &molecule, const std::string &structure,
                  const std::string &other) {
  const Measurement *m = find(run, what, molecule);
  if (m == nullptr) return "-";
  const auto to_library = [&](const std::string &name) { return name == "library" ? 1 : m->counter(name + "_ratio"); };
  return fixed(to_library(structure) / to_library(other), 2);
}

std::string counter(const Run &run, const std::string &what, const std::string &molecule, const std::string &name,
                    int decimals) {
  const Measurement *m = find(run, what, molecule);
  return m == nullptr ? "-" : fixed(m->counter(name), decimals);
}

std::string time(const Run &run, const std::string &what, const std::string &molecule, const std::string &structure) {
  const Measurement *m = find(run, what, molecule);
  return m == nullptr ? "-" : three_digits(nanoseconds(*m, structure, "queries"));
}

std::string bytes(const Run &run, const std::string &molecule, const std::string &structure) {
  const Measurement *m = find(run, "build", molecule);
  return m == nullptr ? "-" : three_digits(m->counter(structure + "_bytes") / m->counter("atoms"));
}

// Two figures, for the stand-in of SOD and for a million balls.
template <class Figure>
std::string both(Figure figure) {
  return figure(large) + " and " + figure(largest);
}

std::string percent(const Run &run, const std::string &molecule) {
  const Measurement *m = find(run, "ball_box", molecule);
  return m == nullptr ? "-" : fixed(100 * m->counter("empty_share"), 0) + " %";
}

void write_remarks(std::ostream &out, const Run &run) {
  const auto of = [&](const char *what, const char *structure, const char *other) {
    return both([&](const std::string &molecule) { return ratio(run, what, molecule, structure, other); });
  };
  out << "The paper's remarks, and what is measured. Two figures are those of the stand-in for SOD and of a million "
         "balls.\n\n"
      << "- \"range trees do not perform well in practice [..] the best performing method is a grid-like method\": a "
         "ball\n  query near atoms takes the range tree "
      << of("ball_atom", "tree", "library") << " times as long as the library, building "
      << of("build", "tree", "library") << " times; its " << bytes(run, large, "tree") << " and "
      << bytes(run, largest, "tree") << " bytes per ball grow with log^2 n.\n"
      << "- O(n) space of the grid (Theorems 3.1, 3.2): " << bytes(run, large, "sorted") << " and "
      << bytes(run, largest, "sorted") << " bytes per ball with sorted cubes, " << bytes(run, large, "perfect")
      << " and " << bytes(run, largest, "perfect")
      << " with perfect hashing.\n  The dense cubes keep to that only because these sets fill their box.\n"
      << "- O(log n) with a search tree (3.1), O(1) with hashing (3.2): a point query near atoms with binary search "
         "takes\n  "
      << ratio(run, "point_atom", "crambin", "sorted", "hashed") << " (crambin), "
      << of("point_atom", "sorted", "hashed")
      << " times as long as with double hashing: either way one search\n  finds a row, "
         "and its cubes lie side by side.\n"
      << "- \"double hashing rather than perfect hashing\": perfect hashing takes "
      << of("ball_atom", "perfect", "hashed") << " times as long per ball query and\n  "
      << of("build", "perfect", "hashed") << " times to build, with "
      << counter(run, "build", largest, "hash_trials", 2)
      << " hash functions tried for each that was needed (a million balls); its worst case\n  is one look at a bucket "
         "and one at a slot, which at a load of at most 1/2 double hashing hardly exceeds on average.\n"
      << "- \"the at most 8 grid cubes it intersects\", each ball in all of its cubes: "
      << both([&](const std::string &m) { return counter(run, "build", m, "paper_cubes_per_ball", 1); })
      << " cubes per ball, and " << both([&](const std::string &m) { return bytes(run, m, "paper"); })
      << "\n  bytes. Against the same hashing with each ball in the cube of its centre alone, a point query near atoms "
         "takes\n  "
      << of("point_atom", "paper", "hashed") << " times as long, a ball query " << of("ball_atom", "paper", "hashed")
      << " times: points gain by it;\n  balls lose by what is found twice, as long as caches hold the set.\n"
      << "- \"the query time seems independent of the size of the molecule\": a ball query in the box takes the "
         "library\n  "
      << time(run, "ball_box", "caffeine", "library") << " ns (caffeine), "
      << time(run, "ball_box", "crambin", "library") << " (crambin), " << time(run, "ball_box", large, "library")
      << " (SOD), " << time(run, "ball_box", largest, "library") << " (a million balls, which no cache holds).\n"
      << "- \"acetyl is very long and thin. As a result, most queries [..] will be empty\": empty are "
      << percent(run, "caffeine") << " of the ball queries in\n  the box of caffeine, " << percent(run, "acetyl")
      << " of acetyl, " << percent(run, "crambin") << " of crambin, " << percent(run, large)
      << " of SOD. Points and balls near atoms have\n  columns of their own for that reason.\n"
      << "- \"point queries can be answered faster (that is, with smaller constants)\": a ball query near atoms of SOD "
         "takes\n  the library "
      << time(run, "ball_atom", large, "library") << " ns, a point query " << time(run, "point_atom", large, "library")
      << " ns.\n"
      << "- \"a molecule with 100 atoms intersects a molecule with 4000 atoms in 0.02 seconds\": 100 ball queries near "
         "atoms of\n  SOD take the library 100 times "
      << time(run, "ball_atom", large, "library") << " ns.\n\n"
      << "Hashed cubes over dense cubes, all else equal, where the rows around a cube are looked up once for all its "
         "balls\n(pairs counted): "
      << of("pairs", "hashed", "dense")
      << "; looked up for every query (balls near atoms): " << of("ball_atom", "hashed", "dense")
      << ". The library, which lists\nthe pairs, over dense cubes: " << of("pairs", "library", "dense") << ".\n\n";
}

}  // namespace

void write_alternatives(std::ostream &out, const Run &run) {
  out << R"(## Section 3: the alternatives

The structures that Section 3 names, written for these benchmarks (suites/section_3), beside the library. They take
turns in one process, with the paper's radii. Double hashing, perfect hashing (two levels, Fredman, Komlos and
Szemeredi), sorted cubes (binary search) and dense cubes (a counting sort over all cubes of the box) differ in nothing
but how they find a cube: each ball is stored once, by its centre, and 27 cubes are looked at. Paper's grid: double
hashing with each ball in all cubes that it meets. Range tree: layered, on the centres. Library: hsp_model_set and
hsp_query_*, which also round to the lattice, decide ties exactly and sort their hits; the others work in plain
doubles and leave hits as they come (the paper's grid sorts, to drop duplicates). All find the same balls. Pairs: the
library lists them (hsp_query_pairs), the others only count. box: centres uniform in the surrounding box; atom: within
1 Angstrom of an atom; 20,000 distinct centres; query balls have radius r_max.

)";
  for (const Timed &what : timed) write_times(out, run, what);
  write_memory(out, run);
  write_remarks(out, run);
}

}  // namespace report
