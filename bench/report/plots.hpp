// Plots: tables of numbers for gnuplot (plots.gp draws them), and the pictures in the report.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>

#include "measurements.hpp"

namespace report {

// Writes one .dat file for each half of a picture into the folder, which must be there.
void write_plot_data(const std::filesystem::path &folder, const Run &run);

// Links to plots/NAME.svg if the run's folder has it.
void show_plot(std::ostream &out, const std::filesystem::path &run_folder, const std::string &name,
               const std::string &caption);

}  // namespace report
