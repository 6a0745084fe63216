// write_report FOLDER > report.md: a Markdown report of the benchmark results (*.json) in the folder.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "alternatives_tables.hpp"
#include "frame_tables.hpp"
#include "goals_tables.hpp"
#include "gradient_tables.hpp"
#include "markdown.hpp"
#include "measurements.hpp"
#include "paper_tables.hpp"
#include "peers_tables.hpp"
#include "topology_tables.hpp"

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
      << " processors; one thread is used\n"
      << "- load average: " << describe_load(run) << '\n'
      << "- compiler: " << context(run, "compiler") << '\n'
      << "- flags: `" << context(run, "flags") << "`\n"
      << "- hardsphere: version number " << context(run, "hardsphere_version") << '\n'
      << "- radii of the paper's tables, in Angstrom: " << context(run, "radii_paper") << '\n'
      << "- radii of the other tables: " << context(run, "radii_van_der_waals")
      << "; solvent-accessible: plus a probe of 1.4\n"
      << "- times: CPU time, median of the repetitions; memory is taken before the clock starts and used again\n"
      << "- molecules: bench/molecules/README.md; felix is a model, SOD a generated stand-in of the same figures\n\n";
}

}  // namespace

int main(int argc, char **argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: write_report FOLDER > report.md\n");
    return 2;
  }
  try {
    const std::filesystem::path folder(argv[1]);
    const report::Run run = report::read_run(folder);
    write_head(std::cout, run);
    report::write_section_2(std::cout, run);
    report::write_section_3(std::cout, run);
    report::write_alternatives(std::cout, run);
    report::write_section_4_2(std::cout, run);
    report::write_topology(std::cout, run);
    report::write_frames(std::cout, run);
    report::write_gradients(std::cout, run);
    report::write_goals(std::cout, run);
    report::write_scaling(std::cout, run);
    report::write_queries(std::cout, run);
    report::write_peers(std::cout, run);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "write_report: %s\n", error.what());
    return 1;
  }
  return std::cout.flush() ? 0 : 1;
}
