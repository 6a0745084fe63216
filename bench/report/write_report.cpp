// write_report TEXT FOLDER > report.md: writes the report that the files of the folder TEXT describe, one after the
// other (document.hpp). Its input are the benchmark results (*.json) in FOLDER and, as far as they are there, the
// results that this version and version 0.1.0 measured by turns, in FOLDER/turns/now and FOLDER/turns/0.1.0, and the
// pictures in FOLDER/plots. `write_report --plots TEXT FOLDER` puts the tables for the pictures into FOLDER/plots, see
// plots.gp.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "document.hpp"

namespace {

std::vector<std::string> read_text(const std::filesystem::path &folder) {
  std::vector<std::string> lines;
  for (const std::filesystem::path &file : report::files_of(folder, ".txt")) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
      if (!line.starts_with("% ")) lines.push_back(line);  // a remark
    }
  }
  return lines;
}

// Measurements of this version and version 0.1.0 by turns, if there are any.
std::optional<report::Turns> read_turns(const std::filesystem::path &folder) {
  if (!std::filesystem::is_directory(folder)) return std::nullopt;
  return report::Turns{report::read_run(folder / "now"), report::read_run(folder / "0.1.0")};
}

}  // namespace

int main(int argc, char **argv) {
  const bool plots = argc == 4 && std::string(argv[1]) == "--plots";
  if (argc != 3 && !plots) {
    std::fprintf(stderr, "usage: write_report TEXT FOLDER > report.md\n       write_report --plots TEXT FOLDER\n");
    return 2;
  }
  try {
    const std::filesystem::path folder(argv[argc - 1]);
    const std::optional<report::Turns> turns = read_turns(folder / "turns");
    const report::Results results{report::read_run(folder), turns ? &*turns : nullptr, folder};
    const std::vector<std::string> source = read_text(argv[argc - 2]);
    if (plots) {
      report::write_plot_data(source, results);
    } else {
      report::write_document(std::cout, source, results);
    }
  } catch (const std::exception &error) {
    std::fprintf(stderr, "write_report: %s\n", error.what());
    return 1;
  }
  return std::cout.flush() ? 0 : 1;
}
