// The report's source, the files of text/, and how it is read. The source is Markdown that goes into the report as it
// is, but for:
//
//   {FIGURE}               a figure (figure.hpp), or a dash
//   {= KEY}                what the benchmarks say of the machine and the build
//   {load}                 the machine's load while they ran
//   % ...                  a remark
//   %set NAME TEXT         $NAME stands for this text from here on
//   %list NAME ... %end    a list: names in the first line, then rows of what these stand for, with | between
//   %each LIST ... %end    what is between, once for each row
//   %if FIGURE ... %else ... %end   what is between if the figure was measured; `turns`: if version 0.1.0 took turns
//   %table ROWS ... %end   a table: a line for each column, with its head, a cell and, for some, `fitted`
//   %goals ... %end        see goals.hpp
//   %facts PREFIX          the benchmarks' remarks of that prefix
//   %failed PREFIX*        why these did not run
//   %plot NAME CAPTION     a picture, if it was drawn
//   %data NAME ... %end    the table of half a picture, for plots.gp: lines TITLE | PREFIX* | FIGURE,
//                        or TITLE | PREFIX* | FIGURE | COUNTER if not the number of balls is what it is drawn against
//
// ROWS are lists and PREFIX*, one within the other: a row for each row of a list, and for each benchmark with the
// prefix by number of balls, where $molecule is the rest of its name. The first cell of what failed is followed by why.
// `, from N` leaves smaller sets out. `, fitted N M` adds rows with the exponent of the fitted columns over the rows of
// at least N, M balls; a cell in which a figure is missing is a dash.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "goals.hpp"
#include "measurements.hpp"

namespace report {

struct Results {
  Run run;
  const Turns *turns;            // or null
  std::filesystem::path folder;  // of the run, with plots/NAME.svg
};

// Throws std::runtime_error, with the line, for what is not as above.
void write_document(std::ostream &out, const std::vector<std::string> &source, const Results &results);
// The tables for the plots alone, into folder/plots.
void write_plot_data(const std::vector<std::string> &source, const Results &results);

}  // namespace report
