// Groups of an index file, and parts of a molecule that the rest blocks, against the table of all its balls.
#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "json_reader.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Lines = std::vector<std::string>;

Json json_of(const Lines &arguments) {
  Lines call = arguments;
  call.emplace_back("--json");
  const Outcome outcome = run_program(call);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return read_json(outcome.out).value_or(Json{});
}

class Parts : public testing::Test {
 protected:
  const std::string crambin = molecules_folder() + "/crambin.pdb";
  const TemporaryFile index{
      "parts.ndx",
      "; comment\n[ Begin ]\n   3 1 2\n2 1 ; again\n\n[Empty]\n[ A & B ]\n9 8 7\n[ Begin ]\n5\n[ A_&_CA ]\n2 9\n"};
  const std::vector<Json> whole = json_of({"measure", crambin, "--probe", "1.4", "--per-ball"})["balls"].items;
};

// Areas of a part are those of the whole molecule, bit for bit.
TEST_F(Parts, ArePartsOfTheWhole) {
  for (const char *part : {"residue:7-9", "element:S", "atom:CA&residue:1-20", "group:Begin", "group:2", "group:A_&_CA",
                           "group:A_&_CA&residue:1"}) {
    const Json found =
        json_of({"measure", crambin, "--probe", "1.4", "--per-ball", "--of", part, "--index", index.path()});
    double sum = 0;
    ASSERT_GT(found["balls"].items.size(), 0U) << part;
    EXPECT_EQ(found["measured"].number, static_cast<double>(found["balls"].items.size()));
    EXPECT_EQ(found["n"].number, 327);
    EXPECT_EQ(found["volume"].kind, Json::Kind::null);
    for (const Json &ball : found["balls"].items) {
      const Json &same = whole[static_cast<size_t>(ball["ball"].number)];
      EXPECT_EQ(ball["area"].number, same["area"].number) << part;
      sum += same["area"].number;
    }
    EXPECT_NEAR(found["area"].number, sum, 1e-10);
  }
}

// Two --of are a union; --only leaves out what then blocks nothing.
TEST_F(Parts, OfWhatIsRead) {
  const auto measured = [&](const Lines &more) {
    Lines all = {"measure", crambin, "--probe", "1.4"};
    all.insert(all.end(), more.begin(), more.end());
    return json_of(all);
  };
  const double both = measured({"--of", "residue:3", "--of", "residue:5"})["area"].number;
  EXPECT_NEAR(both, measured({"--of", "residue:3"})["area"].number + measured({"--of", "residue:5"})["area"].number,
              1e-10);
  EXPECT_GT(measured({"--only", "residue:3", "--of", "residue:3"})["area"].number,
            measured({"--of", "residue:3"})["area"].number);
  EXPECT_EQ(measured({"--only", "residue:3", "--of", "residue:3"})["area"].number,
            measured({"--only", "residue:3"})["area"].number);
  const Json polar = measured({"--of", "element:N", "--polar"});
  EXPECT_EQ(polar["apolar_area"].number, 0);
  EXPECT_NEAR(polar["polar_area"].number, polar["area"].number, 1e-10);
}

TEST_F(Parts, GroupsOfAnIndexFile) {
  const Json found =
      json_of({"measure", crambin, "--probe", "1.4", "--by", "group", "--index", index.path(), "--hide", "atom:CA"});
  const struct {
    const char *name;
    std::set<size_t> balls;
  } groups[] = {{"Begin", {0, 2}}, {"Empty", {}}, {"A & B", {6, 7}}, {"Begin", {4}}, {"A_&_CA", {}}};
  // Atoms by their place in the file: 1 is a CA, which is left out, as is another CA, 8.
  const std::vector<Json> balls =
      json_of({"measure", crambin, "--probe", "1.4", "--per-ball", "--hide", "atom:CA"})["balls"].items;
  ASSERT_EQ(found["groups"].items.size(), std::size(groups));
  for (size_t k = 0; k < std::size(groups); ++k) {
    const Json &group = found["groups"].items[k];
    EXPECT_EQ(group["name"].text, groups[k].name);
    double sum = 0;
    for (const size_t place : groups[k].balls) {
      // One CA stands before those up to 7, none before 0.
      sum += balls[place == 0 ? 0 : place - 1]["area"].number;
    }
    EXPECT_EQ(group["atoms"].number, static_cast<double>(groups[k].balls.size())) << k;
    EXPECT_NEAR(group["area"].number, sum, 1e-10) << k;
  }
  EXPECT_EQ(json_of({"measure", crambin, "--only", "group:Begin", "--index", index.path()})["n"].number, 3);
  const Json shifted = json_of(
      {"measure", crambin, "--hide", "atom:N", "--of", "group:2", "--per-ball", "--index", index.path()})["balls"];
  ASSERT_EQ(shifted.items.size(), 2U);
  EXPECT_EQ(shifted.items[0]["atom"].text, "CG2");
  EXPECT_EQ(json_of({"measure", crambin, "--hide", "group:2", "--index", index.path()})["n"].number, 324);
  EXPECT_EQ(json_of({"contacts", crambin, "--only", "group:2&atom:CG2", "--index", index.path()})["n"].number, 1);
}

TEST_F(Parts, Refused) {
  const TemporaryFile beyond("beyond.ndx", "[ far ]\n328\n"), zero("zero.ndx", "[ z ]\n0\n"),
      nameless("nameless.ndx", "[ ]\n1\n"), open("open.ndx", "[ open\n1\n"), before("before.ndx", "1 2\n"),
      word("word.ndx", "[ a ]\n1 two\n"), nothing("nothing.ndx", "; nothing\n");
  const struct {
    Lines options;
    int status;
    const char *reason;
  } cases[] = {{{"--of", "group:Begin"}, 2, "it needs --index"},
               {{"--by", "group"}, 2, "it needs --index"},
               {{"--only", "group:Tail", "--index", index.path()}, 2, "no group 'Tail'"},
               {{"--only", "group:5", "--index", index.path()}, 2, "no group '5'"},
               {{"--of", "group:Empty", "--index", index.path()}, 1, "--of names no atom"},
               {{"--of", "residue:3", "--surface", "ses"}, 2, "--surface ses is of all atoms"},
               {{"--of", "residue:3", "--gradient"}, 2, "--gradient is of all atoms"},
               {{"--of", "residue:3", "--curvature"}, 2, "--curvature is of all atoms"},
               {{"--of", "residue:3", "--interface", "A,B"}, 2, "--interface is of all atoms"},
               {{"--of", "residue:3", "--box", "60,60,60"}, 2, "--box is of all atoms"},
               {{"--of", "residue:3", "--pdb-out", "x.pdb"}, 2, "--pdb-out is of all atoms"},
               {{"--index", beyond.path()}, 1, "group far has atom 328, and the molecule has 327"},
               {{"--index", zero.path()}, 1, "'0' is not the number of an atom"},
               {{"--index", word.path()}, 1, "'two' is not the number of an atom"},
               {{"--index", nameless.path()}, 1, "a group without a name"},
               {{"--index", open.path()}, 1, "a heading without ']'"},
               {{"--index", before.path()}, 1, "atoms before the first [ group ]"},
               {{"--index", nothing.path()}, 1, "no [ group ] in the file"},
               {{"--index", "not_there.ndx"}, 1, "not_there.ndx"}};
  for (const auto &refused : cases) {
    Lines call = {"measure", crambin, "--probe", "1.4"};
    call.insert(call.end(), refused.options.begin(), refused.options.end());
    const Outcome outcome = run_program(call);
    EXPECT_EQ(outcome.status, refused.status) << refused.reason;
    EXPECT_NE(outcome.err.find(refused.reason), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

}  // namespace
