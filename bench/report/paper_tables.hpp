// The paper's tables with ours beside them.
#pragma once

#include <ostream>

#include "measurements.hpp"

namespace report {

void write_section_2(std::ostream &out, const Run &run);
void write_figure_4(std::ostream &out, const Run &run);
void write_free_space(std::ostream &out, const Run &run);
void write_section_3(std::ostream &out, const Run &run);
void write_section_4_2(std::ostream &out, const Run &run);

}  // namespace report
