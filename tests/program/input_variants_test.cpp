// One molecule, written in many ways: line ends, byte-order marks, tabs, spellings of numbers, alternate locations ...
// inputs/good/NAME_VARIANT.EXT must give the same results, to the last byte, as inputs/good/NAME.EXT.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"

namespace {

struct Variant {
  std::string base;
  std::string file;
};

std::vector<Variant> all_variants() {
  std::vector<Variant> variants;
  for (const auto &entry : std::filesystem::directory_iterator(inputs_folder() + "/good")) {
    const std::string stem = entry.path().stem().string();
    const std::string extension = entry.path().extension().string();
    const size_t underscore = stem.find('_');
    if (underscore == std::string::npos || entry.path().filename().string().front() == '.') continue;
    const std::string base = "good/" + stem.substr(0, underscore) + extension;
    if (std::filesystem::exists(inputs_folder() + "/" + base)) {
      variants.push_back({base, "good/" + entry.path().filename().string()});
    }
  }
  std::sort(variants.begin(), variants.end(), [](const Variant &a, const Variant &b) { return a.file < b.file; });
  return variants;
}

class InputVariant : public testing::TestWithParam<Variant> {};

TEST_P(InputVariant, GivesWhatTheBaseGives) {
  for (const std::vector<std::string> &command :
       {std::vector<std::string>{"model"}, std::vector<std::string>{"boundary"},
        std::vector<std::string>{"measure", "--per-ball", "--probe", "0.4"},
        std::vector<std::string>{"query", "--ball", "0", "0", "0", "0.2"}}) {
    std::vector<std::string> arguments = command;
    arguments.push_back("--json");
    arguments.push_back(GetParam().base);
    const Outcome base = run_program(arguments);
    arguments.back() = GetParam().file;
    const Outcome variant = run_program(arguments);
    EXPECT_EQ(base.status, 0) << GetParam().base;
    EXPECT_EQ(variant.status, 0) << variant.err;
    EXPECT_EQ(geometry_alone(variant.out), geometry_alone(base.out)) << command.front() << " " << GetParam().file;
    const bool site = GetParam().file.find("virtual_site") != std::string::npos;
    const std::string line = ": 1 dummy or virtual site is left out: it is no atom\n";
    EXPECT_EQ(variant.err, site ? "hardsphere: " + GetParam().file + line : "");
  }
}

std::string test_name(const testing::TestParamInfo<Variant> &info) {
  std::string name = info.param.file.substr(info.param.file.find('/') + 1);
  for (char &c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Program, InputVariant, testing::ValuesIn(all_variants()), test_name);

// The formats of one molecule with one set of radii agree as well.
TEST(InputFormats, AgreeOnTheSameMolecule) {
  std::set<std::string> results;
  for (const char *file :
       {"good/three.xyzr", "good/water.pdb", "good/water.pqr", "good/water.xyz", "good/water.cif", "good/water.gro"}) {
    const Outcome outcome = run_program({"measure", file, "--per-ball", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    results.insert(geometry_alone(outcome.out));
  }
  EXPECT_EQ(results.size(), 1u);
}

// Were the list empty, the tests above would say nothing.
TEST(InputFormats, HaveVariants) {
  EXPECT_GE(all_variants().size(), 65u);
}

}  // namespace
