#include "speed_goals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "growth.hpp"
#include "markdown.hpp"
#include "periodic_tables.hpp"
#include "smooth_surface_tables.hpp"
#include "surfaces.hpp"

namespace report {
namespace {

const std::string set = "/sod_stand_in";

// What is judged, of one run; nothing if it was not measured.
using Figure = std::function<std::optional<double>(const Run &)>;

// Nanoseconds per ball or query, the least of the repetitions.
Figure least_time(const std::string &benchmark, const char *divisor = "atoms") {
  return [=](const Run &run) -> std::optional<double> {
    const Measurement *m = run.find(benchmark);
    if (m == nullptr) return std::nullopt;
    return m->least() / m->counter(divisor) * 1e9;
  };
}

// The least of a counter that is in seconds, as nanoseconds.
Figure least_seconds(const std::string &benchmark, const char *counter) {
  return [=](const Run &run) -> std::optional<double> {
    const Measurement *m = run.find(benchmark);
    if (m == nullptr || !m->counters.contains(counter)) return std::nullopt;
    return m->least(counter) * 1e9;
  };
}

// The same for each atom.
Figure least_part(const std::string &benchmark, const char *part) {
  return [whole = least_seconds(benchmark, part), benchmark](const Run &run) -> std::optional<double> {
    const auto nanoseconds = whole(run);
    if (!nanoseconds) return std::nullopt;
    return *nanoseconds / run.find(benchmark)->counter("atoms");
  };
}

Figure sum(const Figure &first, const Figure &second) {
  return [=](const Run &run) -> std::optional<double> {
    const auto a = first(run);
    const auto b = second(run);
    if (!a || !b) return std::nullopt;
    return *a + *b;
  };
}

// The first that is measured.
Figure either(const Figure &first, const Figure &second) {
  return [=](const Run &run) {
    const auto a = first(run);
    return a ? a : second(run);
  };
}

Figure per_atom(const std::string &benchmark, const char *counter) {
  return [=](const Run &run) -> std::optional<double> {
    const Measurement *m = run.find(benchmark);
    if (m == nullptr) return std::nullopt;
    return m->counter(counter) / m->counter("atoms");
  };
}

// The least of some counters over some benchmarks, all of which must be there.
Figure least_counter(const std::vector<std::string> &benchmarks, const std::vector<std::string> &counters) {
  return [=](const Run &run) -> std::optional<double> {
    double least = INFINITY;
    for (const std::string &benchmark : benchmarks) {
      const Measurement *m = run.find(benchmark);
      for (const std::string &counter : counters) {
        if (m == nullptr || !m->counters.contains(counter)) return std::nullopt;
        least = std::min(least, m->counter(counter));
      }
    }
    return least;
  };
}

struct Stage {
  const char *name;
  std::string prefix_of_v, prefix_of_s;  // empty: not measured for that surface
  Amount amount;
};

// Amounts of time: the least of the repetitions.
double least_time_of(const Measurement &m) {
  return m.least();
}
Amount least_seconds_of(const char *part) {
  return [name = std::string(part) + "_seconds"](const Measurement &m) { return m.least(name); };
}
double least_seconds_beyond_boundary(const Measurement &m) {
  return m.least("surface_seconds") + m.least("measure_seconds");
}

Stage on_both_surfaces(const char *name, const std::string &suite, const std::string &part, const Amount &amount) {
  return {name, suite + '/' + surfaces[0].name + '/' + part + '/', suite + '/' + surfaces[1].name + '/' + part + '/',
          amount};
}

std::vector<Stage> stages_of_contacts() {
  return {
      on_both_surfaces("contacts with cells", "contacts", "compute", least_seconds_of("contacts")),
      on_both_surfaces("mean curvature with gradient", "contacts", "compute", least_seconds_of("curvature_gradient"))};
}

Stage stage_of_cells() {
  return {"cells of free space", std::string("section_2/free_space/") + surfaces[0].name + '/',
          std::string("section_2/free_space/") + surfaces[1].name + '/', least_seconds_of("cells")};
}

std::vector<Stage> timed_stages() {
  std::vector<Stage> stages;
  const std::pair<const char *, const char *> scaled[] = {{"model", "build"},
                                                          {"neighbour lists", "pairs"},
                                                          {"Steps 1 + 2", "boundary"},
                                                          {"areas and volumes", "measure"},
                                                          {"all of these but lists", "everything"}};
  for (const auto &[name, part] : scaled) stages.push_back(on_both_surfaces(name, "scaling", part, least_time_of));
  stages.push_back(on_both_surfaces("gradient", "gradients", "compute", least_seconds_of("gradient")));
  for (const Stage &stage : stages_of_contacts()) stages.push_back(stage);
  stages.push_back(on_both_surfaces("Step 3", "topology", "compute", least_seconds_of("topology")));
  stages.push_back({"smooth surface, its areas and volume", "", "surface/compute/", least_seconds_beyond_boundary});
  stages.push_back({"gradient of the smooth surface", "", "surface/compute/", least_seconds_of("gradient")});
  stages.push_back(stage_of_cells());
  stages.push_back({"frame G", "frames/", "", least_seconds_of("g")});
  return stages;
}

std::vector<Stage> stages_with_memory() {
  const Amount boundary_bytes = [](const Measurement &m) { return m.counter("bytes_per_atom") * m.counter("atoms"); };
  return {on_both_surfaces("boundary", "scaling", "boundary", boundary_bytes),
          on_both_surfaces("topology", "topology", "compute", counter_of("bytes")),
          on_both_surfaces("contacts", "contacts", "compute", counter_of("bytes")),
          {"smooth surface", "", "surface/compute/", counter_of("bytes")}};
}

// The largest exponent of some stages.
Figure largest_exponent(const std::vector<Stage> &stages) {
  return [=](const Run &run) -> std::optional<double> {
    double largest = -INFINITY;
    for (const Stage &stage : stages) {
      for (const std::string &prefix : {stage.prefix_of_v, stage.prefix_of_s}) {
        if (prefix.empty()) continue;
        const double fitted = growth_exponent(run, prefix, large_set, stage.amount);
        if (std::isnan(fitted)) return std::nullopt;
        largest = std::max(largest, fitted);
      }
    }
    return largest;
  };
}

enum class Kind {
  time,      // at most; scales with version 0.1.0
  new_time,  // the same of what that version cannot do: scales with its model and Steps 1 + 2
  share,     // of Steps 1 + 2 of version 0.1.0, of what that version cannot do
  at_most,   // a figure that is the same on every machine
  at_least,  // likewise
};

struct Goal {
  const char *what;
  Kind kind;
  double old_elsewhere;  // version 0.1.0 on the machine where the goals were set; 0: not measured there
  double must, goal;
  Figure figure;
  Figure whole = {};  // that a share is of, and that a new time scales with; solvent-accessible without it
};

// Model and Steps 1 + 2.
Figure steps_1_and_2(const std::string &surface) {
  return sum(least_time("scaling/" + surface + "/build" + set), least_time("scaling/" + surface + "/boundary" + set));
}

std::vector<Goal> speed_goals() {
  const std::array<std::string, 2> scaling = {"scaling/van_der_waals/", "scaling/solvent_accessible/"};
  const std::array<std::string, 2> topology = {"topology/van_der_waals/compute" + set,
                                               "topology/solvent_accessible/compute" + set};
  const std::array<std::string, 2> gradients = {"gradients/van_der_waals/compute" + set,
                                                "gradients/solvent_accessible/compute" + set};
  const std::array<std::string, 2> peers = {"peers/surfaces/van_der_waals" + set,
                                            "peers/surfaces/solvent_accessible" + set};
  const auto steps = [](size_t s) { return steps_1_and_2(surfaces[s].name); };
  const auto everything = [&](size_t s) { return least_time(scaling[s] + "everything" + set); };
  const auto with_step_3 = [&](size_t s) { return sum(everything(s), least_part(topology[s], "topology_seconds")); };
  const auto lists = [&](size_t s) {  // version 0.1.0 can only be asked ball by ball
    return either(least_time(scaling[s] + "pairs" + set), least_time(scaling[s] + "lists" + set));
  };
  const auto gradient = [&](size_t s) { return least_part(gradients[s], "gradient_seconds"); };
  const Figure frame = [](const Run &run) -> std::optional<double> {
    const double largest = largest_amount(run, "frames/", 1000, counter_of("g_ratio"));
    return std::isnan(largest) ? std::nullopt : std::optional(largest);
  };
  const auto speed_up = [](size_t s) -> Figure {
    return [prefix = std::string("split_work/") + surfaces[s].name + '/'](const Run &run) -> std::optional<double> {
      const double largest = largest_amount(run, prefix, 50000, [](const Measurement &m) {
        return m.least("by_two_seconds") / m.least("alone_seconds");
      });
      return std::isnan(largest) ? std::nullopt : std::optional(1 / largest);
    };
  };
  const auto in_box = [](size_t s, const Amount &amount) -> Figure {
    return [prefix = std::string("periodic/") + surfaces[s].name + '/', amount](const Run &run) {
      const double largest = largest_amount(run, prefix, large_set, amount);
      return std::isnan(largest) ? std::nullopt : std::optional(largest);
    };
  };
  const Amount in_time = counter_of("box_ratio");
  const auto move_of_one = [](size_t s) {
    return least_time(std::string("updates/") + surfaces[s].name + "/move_1" + set, "moves");
  };
  const auto over_boundary = [](size_t s, const char *ratio) {
    return least_counter({std::string("contacts/") + surfaces[s].name + "/compute" + set}, {ratio});
  };
  const auto part_of_contacts = [](size_t s, const char *part) {
    return least_part(std::string("contacts/") + surfaces[s].name + "/compute" + set, part);
  };
  const auto boundary = [&](size_t s) { return least_time(scaling[s] + "boundary" + set); };
  const auto free_space = [](size_t s) { return std::string("section_2/free_space/") + surfaces[s].name; };
  const auto cells = [&](size_t s) { return least_part(free_space(s) + set, "cells_seconds"); };
  const auto of_cells = [&](size_t s, const char *what) { return least_seconds(free_space(s) + set, what); };
  const Figure cuts = [free_space](const Run &run) -> std::optional<double> {
    double most = std::nan("");
    for (size_t s = 0; s < std::size(surfaces); ++s) {
      for (const char *counter : {"gate_builds", "void_builds"}) {
        const double largest = largest_amount(run, free_space(s) + '/', 1, counter_of(counter));
        if (!(largest <= most)) most = largest;
      }
    }
    return most > 0 ? std::optional(most) : std::nullopt;
  };
  const std::string surface = "surface/compute" + set;
  const Figure for_gradient = [surface](const Run &run) -> std::optional<double> {
    const Measurement *m = run.find(surface);
    return m != nullptr ? std::optional(per_cent_for_gradient(*m)) : std::nullopt;
  };
  return {
      {"model and Steps 1 + 2, v", Kind::time, 1770, 720, 450, steps(0)},
      {"model and Steps 1 + 2, s", Kind::time, 6320, 1200, 800, steps(1)},
      {"with areas and volumes, v", Kind::time, 2160, 1000, 600, everything(0)},
      {"with areas and volumes, s", Kind::time, 6530, 1380, 950, everything(1)},
      {"and with Step 3, v", Kind::time, 3000, 1550, 900, with_step_3(0)},
      {"and with Step 3, s", Kind::time, 6700, 1520, 1050, with_step_3(1)},
      {"CGAL's alpha complex over areas and volumes, v", Kind::at_least, 6.4, 11, 20,
       least_counter({peers[0]}, {"cgal_alpha_ratio"})},
      {"CGAL's alpha complex over areas and volumes, s", Kind::at_least, 2.4, 8, 12,
       least_counter({peers[1]}, {"cgal_alpha_ratio"})},
      {"FreeSASA L&R 20 over areas and volumes, v", Kind::at_least, 3.5, 6, 10,
       least_counter({peers[0]}, {"freesasa_lr20_ratio"})},
      {"FreeSASA L&R 20 over areas and volumes, s", Kind::at_least, 5.5, 20, 30,
       least_counter({peers[1]}, {"freesasa_lr20_ratio"})},
      {"gradient of everything, v", Kind::time, 430, 250, 120, gradient(0)},
      {"gradient of everything, s", Kind::time, 210, 120, 60, gradient(1)},
      {"point query near atoms", Kind::time, 163, 70, 40, least_time("queries/point_atom" + set, "queries")},
      {"ball query near atoms", Kind::time, 386, 150, 90, least_time("queries/ball_atom" + set, "queries")},
      {"neighbour lists, v", Kind::time, 295, 120, 60, lists(0)},
      {"neighbour lists, s", Kind::time, 1430, 300, 150, lists(1)},
      {"nanoflann or gemmi over a query near atoms, least", Kind::at_least, 0, 2, 5,
       least_counter({"peers/queries/point_atom" + set, "peers/queries/ball_atom" + set},
                     {"nanoflann_ratio", "gemmi_ratio"})},
      {"frame G / analytic z-buffer, from 1,000 balls, largest", Kind::at_most, 4.9, 3, 1.5, frame},
      {"exponent of time from 4,000 balls, largest of all stages", Kind::at_most, 1.13, 1.05, 1.02,
       largest_exponent(timed_stages())},
      {"exponent of memory from 4,000 balls, largest", Kind::at_most, 0, 1.05, 1.02,
       largest_exponent(stages_with_memory())},
      {"bytes per ball of the topology, v", Kind::at_most, 925, 600, 370, per_atom(topology[0], "bytes")},
      {"bytes per ball of the topology, s", Kind::at_most, 334, 300, 230, per_atom(topology[1], "bytes")},
      {"smooth surface with areas and volume, beyond the boundary", Kind::new_time, 6320, 1500, 800,
       sum(least_part(surface, "surface_seconds"), least_part(surface, "measure_seconds"))},
      {"gradient of the smooth surface, per cent more", Kind::at_most, 0, 20, 20, for_gradient},
      {"bytes per ball of the smooth surface", Kind::at_most, 0, 150, 150, per_atom(surface, "bytes")},
      {"a move of one atom with areas and gradient, v", Kind::new_time, 6320, 12000, 7000, move_of_one(0)},
      {"a move of one atom with areas and gradient, s", Kind::new_time, 6320, 80000, 55000, move_of_one(1)},
      {"cells of free space, v", Kind::new_time, 1770, 8000, 8000, cells(0), steps(0)},
      {"cells of free space, s", Kind::new_time, 6320, 15000, 15000, cells(1), steps(1)},
      {"in which of them a point lies, v", Kind::new_time, 1770, 150, 150, of_cells(0, "locate_each"), steps(0)},
      {"in which of them a point lies, s", Kind::new_time, 6320, 150, 150, of_cells(1, "locate_each"), steps(1)},
      {"a path through them, v", Kind::new_time, 1770, 5e6, 5e6, of_cells(0, "path_each"), steps(0)},
      {"a path through them, s", Kind::new_time, 6320, 5e6, 5e6, of_cells(1, "path_each"), steps(1)},
      {"exponent of these cells from 4,000 balls, largest", Kind::at_most, 0, 1.05, 1.02,
       largest_exponent({stage_of_cells()})},
      {"cuts for a widest probe, up to 1,000 balls, most", Kind::at_most, 0, 40, 10, cuts},
      {"contacts with cells over Steps 1 + 2, v", Kind::at_most, 0, 0.5, 0.1, over_boundary(0, "contacts_ratio")},
      {"contacts with cells over Steps 1 + 2, s", Kind::at_most, 0, 1.2, 0.5, over_boundary(1, "contacts_ratio")},
      {"contacts with cells over Steps 1 + 2 of 0.1.0, v", Kind::share, 0, 0.5, 0.1,
       part_of_contacts(0, "contacts_seconds"), boundary(0)},
      {"contacts with cells over Steps 1 + 2 of 0.1.0, s", Kind::share, 0, 1.2, 0.5,
       part_of_contacts(1, "contacts_seconds"), boundary(1)},
      {"mean curvature with gradient over Steps 1 + 2, v", Kind::at_most, 0, 0.3, 0.3,
       over_boundary(0, "curvature_gradient_ratio")},
      {"mean curvature with gradient over Steps 1 + 2, s", Kind::at_most, 0, 0.1, 0.1,
       over_boundary(1, "curvature_gradient_ratio")},
      {"mean curvature with gradient over Steps 1 + 2 of 0.1.0, v", Kind::share, 0, 0.3, 0.3,
       part_of_contacts(0, "curvature_gradient_seconds"), boundary(0)},
      {"mean curvature with gradient over Steps 1 + 2 of 0.1.0, s", Kind::share, 0, 0.1, 0.1,
       part_of_contacts(1, "curvature_gradient_seconds"), boundary(1)},
      {"exponent of contacts and curvature from 4,000 balls, largest", Kind::at_most, 0, 1.05, 1.02,
       largest_exponent(stages_of_contacts())},
      {"alone over two threads, from 50,000 balls, v", Kind::at_least, 0, 1.6, 1.85, speed_up(0)},
      {"alone over two threads, from 50,000 balls, s", Kind::at_least, 0, 1.6, 1.85, speed_up(1)},
      {"periodic box / free space, from 4,000 balls, largest, v", Kind::at_most, 0, 1.15, 1.15, in_box(0, in_time)},
      {"periodic box / free space, from 4,000 balls, largest, s", Kind::at_most, 0, 1.15, 1.15, in_box(1, in_time)},
      {"periodic box / free space per contact, largest, v", Kind::at_most, 0, 1.15, 1.15,
       in_box(0, box_ratio_per_contact)},
      {"periodic box / free space per contact, largest, s", Kind::at_most, 0, 1.15, 1.15,
       in_box(1, box_ratio_per_contact)},
      {"lattice, four spheres through every vertex", Kind::time, 10500, 9500, 5000,
       least_time("degenerate/everything/cubic_lattice")},
  };
}

std::string shown(const std::optional<double> &value) {
  return value ? three_digits(*value) : "-";
}

std::string verdict(const Goal &goal, double value, double must, double best) {
  const auto kept = [&](double limit) { return goal.kind == Kind::at_least ? value >= limit : value <= limit; };
  return kept(best) ? "goal" : kept(must) ? "must" : "**missed**";
}

}  // namespace

void write_speed_goals(std::ostream &out, const Run &run, const Turns *turns) {
  out << "## Goals\n\nThe stand-in for SOD, 4392 balls, one thread; nanoseconds per ball, query or move, the least of "
         "the repetitions, or\nratios; v: van der Waals, s: solvent-accessible. ";
  if (turns != nullptr) {
    out << "Version 0.1.0 took turns with this one. The limits were set on another machine; those that are\ntimes are "
           "scaled here by what that version takes on the two machines.\n\n";
  } else {
    out << "The limits were set on another machine, and version 0.1.0 did not run: those\nthat are times stand as they "
           "were set there, and are not judged.\n\n";
  }
  Table table({"what", "0.1.0 there", "0.1.0 here", "now", "must", "goal", "verdict"});
  for (const Goal &goal : speed_goals()) {
    const bool is_new = goal.kind == Kind::new_time;
    const bool scales = goal.kind == Kind::time || is_new;
    const bool is_share = goal.kind == Kind::share;
    const Figure of_old = goal.whole ? goal.whole : is_new ? steps_1_and_2(surfaces[1].name) : goal.figure;
    const auto before = turns != nullptr ? of_old(turns->old) : std::nullopt;
    auto now = goal.figure(scales && turns != nullptr ? turns->now : run);
    if (is_share) now = now && before ? std::optional(*now / *before) : std::nullopt;
    const double scale = scales && before ? *before / goal.old_elsewhere : 1;
    const double must = goal.must * scale;
    const double best = goal.goal * scale;
    table.row({goal.what, goal.old_elsewhere > 0 && !is_new ? three_digits(goal.old_elsewhere) : "-",
               is_new || is_share ? "-" : shown(before), shown(now), three_digits(must), three_digits(best),
               !now                ? "not measured"
               : scales && !before ? "-"
                                   : verdict(goal, *now, must, best)});
  }
  table.write(out);
  out << R"(Contacts and curvature have limits as fractions of Steps 1 + 2, set when these were version 0.1.0's. These
steps have become faster since, so both fractions are shown. In a box nothing lies bare, so that there is more to find
than in free space: both ratios are shown, that of the times and that by the contacts.

)";
  out << "Calls of the exact stage on molecules are counted by the test unit_exact_stage_counters. Threads are the "
         "caller's.\n\n";
}

void write_exponents(std::ostream &out, const Run &run) {
  out << "### Exponents\n\nThe exponent e of n^e, by least squares over logarithms, of the sets of 4,000 to a million "
         "balls. 1 is linear.\nTimes are the least of the repetitions, as in the goals; the tables further down have "
         "medians, and their exponents.\n\n";
  Table table({"what", "van der Waals", "solvent-accessible"});
  const auto add = [&](const std::string &kind, const std::vector<Stage> &stages) {
    for (const Stage &stage : stages) {
      std::vector<std::string> cells{kind + stage.name};
      for (const std::string &prefix : {stage.prefix_of_v, stage.prefix_of_s}) {
        const double fitted = growth_exponent(run, prefix, large_set, stage.amount);
        cells.push_back(prefix.empty() || std::isnan(fitted) ? "-" : fixed(fitted, 3));
      }
      table.row(cells);
    }
  };
  add("time: ", timed_stages());
  add("memory: ", stages_with_memory());
  table.write(out);
}

}  // namespace report
