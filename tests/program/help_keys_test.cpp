// The keys of JSON in the help of a command: each key that the command prints is a word of its help.
#include <gtest/gtest.h>

#include <cctype>
#include <set>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"

namespace {

// Letters, digits and underscores that stand together.
std::set<std::string> words_of(const std::string &text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
    } else {
      words.insert(word);
      word.clear();
    }
  }
  return words;
}

void gather_keys(const Json &value, std::set<std::string> &keys) {
  for (size_t k = 0; k < value.items.size(); ++k) {
    if (value.kind == Json::Kind::object) {
      if (value.keys[k] == "input") continue;  // the same of all commands
      keys.insert(value.keys[k]);
    }
    gather_keys(value.items[k], keys);
  }
}

TEST(HelpKeys, AreAllThatAreWritten) {
  const std::string water = "good/water.pdb", cage = "good/cage.xyzr", box = "--box=30,30,30";
  const std::vector<std::vector<std::string>> runs = {
      {"model", water},
      {"boundary", cage, "--shells"},
      {"boundary", water, box},
      {"measure", water, "--per-ball", "--gradient", "--curvature", "--polar"},
      {"measure", water, "--probe=1.4", "--by=residue", "--relative"},
      {"measure", water, "--by=chain"},
      {"measure", water, "--probe=1.4", "--surface=ses", "--outer"},
      {"measure", water, "--of=element:O", "--per-ball"},
      {"measure", water, "--window=0.1", "--gradient"},
      {"measure", water, box},
      {"hessian", water, "--tension=1"},
      {"voids", cage},
      {"contacts", water, "--cells"},
      {"contacts", water, "--by=residue"},
      {"contacts", water, box},
      {"complex", water},
      {"cells", water},
      {"path", water, "--from=-9,0,0", "--to=9,0,0"},
      {"gate", water, "--from=-9,0,0"},
      {"pores", cage, "--pockets=9", "--regions", "--tunnels-from=0,0,0"},
      {"pores", cage, box, "--gates"},
      {"clash", water, "good/water.xyz"},
      {"query", water, "--point=0,0,0"},
      {"map", water},
      {"pick", water, "--at=0,0"},
      {"mesh", water, "-o", "/dev/null", "--triangles=ply"},
      {"draw", water, "-o", "/dev/null", "--picture=svg", "--colour=bfactor", "--spin=1"}};
  for (const std::vector<std::string> &run : runs) {
    const Outcome help = run_program({run[0], "--help"});
    EXPECT_EQ(help.status, 0);
    // Nothing of its templates is left.
    EXPECT_EQ(help.out.find("<.."), std::string::npos) << run[0];
    EXPECT_EQ(help.out.find("<>"), std::string::npos) << run[0];
    // With an option come only those that are not there without it; means of a trajectory are another object.
    EXPECT_LE(count_of(help.out, " n,"), run[0] == "measure" ? 2U : 1U) << run[0];
    const std::set<std::string> words = words_of(help.out);
    std::vector<std::string> arguments = run;
    arguments.emplace_back("--json");
    const Outcome outcome = run_program(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = read_json(outcome.out);
    ASSERT_TRUE(json.has_value()) << run[0];
    std::set<std::string> keys;
    gather_keys(*json, keys);
    EXPECT_FALSE(keys.empty());
    for (const std::string &key : keys) EXPECT_EQ(words.count(key), 1U) << run[0] << " writes " << key;
  }
}

// Those of what was read, which all commands write, for each kind of file.
TEST(HelpKeys, OfWhatWasReadAreInTheHelpOfAll) {
  const std::set<std::string> words = words_of(run_program({"--help"}).out);
  const std::vector<std::vector<std::string>> runs = {
      {"model", "good/water.pdb"}, {"model", "good/water.cif"},    {"model", "good/atomic_number.xyz"},
      {"model", "good/cage.xyzr"}, {"model", "good/elements.pdb"}, {"model", "good/assembly.cif", "--assembly=1"}};
  for (std::vector<std::string> run : runs) {
    run.emplace_back("--json");
    const Outcome outcome = run_program(run);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = read_json(outcome.out);
    ASSERT_TRUE(json.has_value()) << run[1];
    std::set<std::string> keys;
    gather_keys((*json)["input"], keys);
    EXPECT_GT(keys.size(), 20U);
    for (const std::string &key : keys) EXPECT_EQ(words.count(key), 1U) << run[1] << ": " << key;
  }
}

}  // namespace
