// write_report FOLDER > report.md: a Markdown report of the benchmark results (*.json) in the folder, of what this
// version and version 0.1.0 measured by turns in FOLDER/turns/now and FOLDER/turns/0.1.0, and of the pictures in
// FOLDER/plots, as far as these are there. `write_report --plots FOLDER` puts the tables for the pictures into
// FOLDER/plots, see plots.gp.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

#include "alternatives_tables.hpp"
#include "contact_tables.hpp"
#include "frame_tables.hpp"
#include "gradient_tables.hpp"
#include "markdown.hpp"
#include "measurements.hpp"
#include "paper_tables.hpp"
#include "peers_tables.hpp"
#include "periodic_tables.hpp"
#include "plots.hpp"
#include "pose_tables.hpp"
#include "scaling_tables.hpp"
#include "smooth_surface_tables.hpp"
#include "speed_goals.hpp"
#include "topology_tables.hpp"
#include "update_tables.hpp"
#include "visibility_tables.hpp"

namespace {

std::string context(const report::Run &run, const std::string &key) {
  const auto found = run.context.find(key);
  return found == run.context.end() ? "unknown" : found->second;
}

constexpr double busy = 1.5;  // a benchmark itself is a load of 1

// Whether anything else was running, as far as the load average tells.
std::string describe_load(const report::Run &run) {
  if (run.loads.empty()) return "unknown";
  const auto [least, most] = std::minmax_element(run.loads.begin(), run.loads.end());
  std::string text = report::fixed(*least, 2) + " to " + report::fixed(*most, 2) +
                     " when the programs began, of which up to 1 is the benchmarks' own";
  if (*most > busy) text += ". **The machine was busy: do not quote these times**";
  return text;
}

void write_head(std::ostream &out, const report::Run &run) {
  out << "# Benchmark report\n\n"
      << "- date: " << context(run, "date") << '\n'
      << "- machine: " << context(run, "cpu_model") << ", " << context(run, "num_cpus")
      << " processors; one thread is used but where work is split\n"
      << "- load average: " << describe_load(run) << '\n'
      << "- compiler: " << context(run, "compiler") << '\n'
      << "- flags: `" << context(run, "flags") << "`\n"
      << "- code for wider registers: " << context(run, "wide_code") << '\n'
      << "- hardsphere: version number " << context(run, "hardsphere_version") << '\n'
      << "- radii of the paper's tables, in Angstrom: " << context(run, "radii_paper") << '\n'
      << "- radii of the other tables: " << context(run, "radii_van_der_waals")
      << "; solvent-accessible: plus a probe of 1.4\n"
      << "- times: CPU time, median of the repetitions; memory is taken before the clock starts and used again\n"
      << "- molecules: bench/molecules/README.md; felix is a model, SOD a generated stand-in of the same figures\n\n";
}

// What this version and version 0.1.0 measured by turns, if they did.
std::optional<report::Turns> read_turns(const std::filesystem::path &folder) {
  if (!std::filesystem::is_directory(folder)) return std::nullopt;
  return report::Turns{report::read_run(folder / "now"), report::read_run(folder / "0.1.0")};
}

void write_report(std::ostream &out, const std::filesystem::path &folder) {
  const report::Run run = report::read_run(folder);
  const std::optional<report::Turns> turns = read_turns(folder / "turns");
  const auto plot = [&](const char *name, const char *caption) { report::show_plot(out, folder, name, caption); };
  write_head(out, run);
  report::write_speed_goals(out, run, turns ? &*turns : nullptr);
  report::write_exponents(out, run);
  plot("scaling", "Nanoseconds per ball of each stage against the number of balls");
  report::write_peers(out, run);
  plot("peers", "Other programs: how many times as long as the library, against the number of balls");
  plot("searches", "Searches by the library, nanoflann and gemmi against the number of balls");
  report::write_section_2(out, run);
  report::write_figure_4(out, run);
  plot("figure_4", "Cells of decompositions in space and in cubes against the number of balls");
  report::write_free_space(out, run);
  report::write_section_3(out, run);
  report::write_alternatives(out, run);
  plot("alternatives", "Section 3's alternatives: ball queries and memory against the number of balls");
  report::write_poses(out, run);
  report::write_updates(out, run);
  report::write_section_4_2(out, run);
  report::write_topology(out, run);
  report::write_frames(out, run);
  report::write_visibility(out, run);
  report::write_gradients(out, run);
  report::write_contacts(out, run);
  report::write_smooth_surface(out, run);
  report::write_periodic(out, run);
  report::write_scaling(out, run);
  report::write_queries(out, run);
  report::write_split_work(out, run);
}

}  // namespace

int main(int argc, char **argv) {
  const bool plots = argc == 3 && std::string(argv[1]) == "--plots";
  if (argc != 2 && !plots) {
    std::fprintf(stderr, "usage: write_report FOLDER > report.md\n       write_report --plots FOLDER\n");
    return 2;
  }
  try {
    const std::filesystem::path folder(argv[argc - 1]);
    if (plots) {
      report::write_plot_data(folder / "plots", report::read_run(folder));
    } else {
      write_report(std::cout, folder);
    }
  } catch (const std::exception &error) {
    std::fprintf(stderr, "write_report: %s\n", error.what());
    return 1;
  }
  return std::cout.flush() ? 0 : 1;
}
