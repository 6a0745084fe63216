// Tables of numbers for gnuplot, which plots.gp draws.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measurements.hpp"
#include "names.hpp"

namespace report {

// A column for n and one for each line, TITLE | PREFIX* | FIGURE; a line without positive values is left out. Sets of
// nearly the same size are averaged. Throws std::runtime_error if the file cannot be written.
void write_plot_table(const std::filesystem::path &file, const std::vector<std::string> &lines, const Run &run,
                      const Lists &lists);

}  // namespace report
