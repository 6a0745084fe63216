// The JSON of every command is strict JSON with exactly the keys that the contract lists, in that order.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "json_reader.hpp"
#include "program_runner.hpp"

namespace {

using Keys = std::vector<std::string>;

Json run_json(std::vector<std::string> arguments) {
  arguments.push_back("--json");
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const std::optional<Json> json = read_json(outcome.out);
  EXPECT_TRUE(json.has_value()) << outcome.out;
  EXPECT_TRUE(outcome.out.ends_with("}\n")) << outcome.out;
  return json.value_or(Json());
}

const std::vector<std::string> files = {"good/none.xyzr", "good/one.xyzr",  "good/point.xyzr", "good/points.xyzr",
                                        "good/same.xyzr", "good/two.xyzr",  "good/cage.xyzr",  "good/water.pdb",
                                        "good/water.pqr", "good/water.xyz", "good/none.pdb",   "good/none.xyz"};

TEST(JsonReader, IsStrict) {
  for (const char *good : {"{}", " [1, -2.5e-3, 0, 0.0] ", "{\"a\": null, \"b\": [true, false]}", "\"text\"", "1E+2"}) {
    EXPECT_TRUE(read_json(good).has_value()) << good;
  }
  for (const char *bad : {"",          "{",           "{,}",        "[1,]",   "[1 2]",
                          "{\"a\" 1}", "{\"a\": 1,}", "{a: 1}",     "nan",    "NaN",
                          "Infinity",  "-inf",        "01",         "1.",     ".5",
                          "+1",        "1e",          "0x1",        "1e999",  "{\"a\": 1, \"a\": 2}",
                          "1 2",       "'a'",         "{\"a\": -}", "[-nan]", "\"a",
                          "nul"}) {
    EXPECT_FALSE(read_json(bad).has_value()) << bad;
  }
}

TEST(JsonOutput, ModelHasItsKeys) {
  for (const std::string &file : files) {
    EXPECT_EQ(run_json({"model", file}).keys, (Keys{"n", "k", "rho", "max_overlaps", "mean_overlaps"})) << file;
  }
}

TEST(JsonOutput, BoundaryHasItsKeys) {
  for (const std::string &file : files) {
    EXPECT_EQ(run_json({"boundary", file}).keys, (Keys{"n", "vertices", "arcs", "circles", "faces", "exposed_balls",
                                                       "shells", "components", "voids", "euler"}))
        << file;
  }
}

TEST(JsonOutput, MeasureHasItsKeys) {
  for (const std::string &file : files) {
    EXPECT_EQ(run_json({"measure", file}).keys, (Keys{"n", "area", "volume"})) << file;
    const Json json = run_json({"measure", file, "--per-ball"});
    EXPECT_EQ(json.keys, (Keys{"n", "area", "volume", "balls"})) << file;
    EXPECT_EQ(json["balls"].kind, Json::Kind::array) << file;
    EXPECT_EQ(static_cast<double>(json["balls"].items.size()), json["n"].number) << file;
    for (const Json &ball : json["balls"].items) {
      EXPECT_EQ(ball.keys, Keys{"area"}) << file;
      EXPECT_EQ(ball["area"].kind, Json::Kind::number) << file;
    }
  }
}

TEST(JsonOutput, QueryHasItsKeys) {
  for (const std::string &file : files) {
    for (const std::vector<std::string> &query :
         {std::vector<std::string>{"--point", "0", "0", "0"}, std::vector<std::string>{"--ball", "0", "0", "0", "9"}}) {
      std::vector<std::string> arguments = {"query", file};
      arguments.insert(arguments.end(), query.begin(), query.end());
      const Json json = run_json(arguments);
      EXPECT_EQ(json.keys, Keys{"hits"}) << file;
      EXPECT_EQ(json["hits"].kind, Json::Kind::array) << file;
    }
  }
}

// What has no value is null, never a number that stands for it.
TEST(JsonOutput, MissingValuesAreNull) {
  EXPECT_EQ(run_json({"model", "good/none.xyzr"})["k"].kind, Json::Kind::null);
  EXPECT_EQ(run_json({"model", "good/none.xyzr"})["rho"].kind, Json::Kind::null);
  EXPECT_EQ(run_json({"model", "good/one.xyzr"})["k"].number, 1.0);
  EXPECT_EQ(run_json({"model", "good/one.xyzr"})["rho"].kind, Json::Kind::null);
  EXPECT_EQ(run_json({"model", "good/point.xyzr"})["k"].kind, Json::Kind::null);
  EXPECT_EQ(run_json({"model", "good/points.xyzr"})["k"].kind, Json::Kind::null);
  EXPECT_EQ(run_json({"model", "good/points.xyzr"})["rho"].kind, Json::Kind::null);
  EXPECT_EQ(run_json({"model", "good/points.xyzr", "--probe", "1"})["k"].number, 1.0);
  EXPECT_EQ(run_json({"model", "good/points.xyzr", "--probe", "1"})["rho"].number, 1.0);
  const Json same = run_json({"model", "good/same.xyzr"});
  EXPECT_EQ(same["rho"].kind, Json::Kind::number);
  EXPECT_EQ(same["rho"].number, 0.0);
}

// The digits tell each double from its neighbours: reading and writing again changes nothing.
TEST(JsonOutput, NumbersHaveSeventeenDigits) {
  const Json json = run_json({"measure", "good/water.pdb", "--probe", "1.4"});
  for (const char *key : {"area", "volume"}) {
    char again[40];
    std::snprintf(again, sizeof again, "%.17g", json[key].number);
    EXPECT_EQ(json[key].text, again) << key;
  }
}

}  // namespace
