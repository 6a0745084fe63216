#include "json_outcome.hpp"

#include <regex>

#include <gtest/gtest.h>

#include "program_runner.hpp"

Json run_json(std::vector<std::string> arguments, const std::string &note) {
  arguments.push_back("--json");
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(note.empty() ? outcome.err.empty() : outcome.err.ends_with(note + "\n")) << outcome.err;
  const std::optional<Json> json = read_json(outcome.out);
  EXPECT_TRUE(json.has_value()) << outcome.out;
  EXPECT_TRUE(outcome.out.ends_with("}\n")) << outcome.out;
  return json.value_or(Json());
}

std::string without_input(const std::string &json) {
  const size_t at = json.find(", \"input\": {");
  EXPECT_NE(at, std::string::npos) << json;
  return json.substr(0, at);
}

std::string geometry_alone(const std::string &json) {
  static const std::regex name("\"(atom|element|chain|residue|number|insertion)\": (\"[^\"]*\"|-?[0-9]+), ");
  return std::regex_replace(without_input(json), name, "");
}
