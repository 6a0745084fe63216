// The old file stays as it was if anything goes wrong while a new one is written, and nothing else is left. All
// commands that write files are tried.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

namespace fs = std::filesystem;

// A command that writes a file: its arguments up to the name of that file.
struct Writer {
  const char *name;
  std::vector<std::string> before;  // behind it stands the molecule
  std::vector<std::string> option;
  const char *option_name;  // as the program calls it
};

std::vector<std::string> call(const Writer &writer, const std::string &molecule, const std::string &out) {
  std::vector<std::string> arguments = writer.before;
  arguments.push_back(molecule);
  arguments.insert(arguments.end(), writer.option.begin(), writer.option.end());
  arguments.push_back(out);
  return arguments;
}

class OutputFiles : public testing::TestWithParam<Writer> {
 protected:
  OutputFiles()
      : folder("output_files"), water(folder.write("water.pdb", read_file(inputs_folder() + "/good/water.pdb"))) {}

  Outcome write(const std::string &out) const { return run_program(call(GetParam(), water, out)); }

  // The output where nothing is in the way.
  std::string right() const {
    const TemporaryFile out("right");
    EXPECT_EQ(run_program(call(GetParam(), water, out.path())).status, 0);
    return read_file(out.path());
  }

  void expect_refusal(const Outcome &outcome, int status, const std::string &line) const {
    EXPECT_EQ(outcome.status, status);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "hardsphere: " + line + "\n");
  }

  void expect_input_untouched(const std::string &out) const {
    const std::vector<std::string> names = folder.names();
    const std::string before = read_file(water);
    expect_refusal(write(out), 2, std::string(GetParam().option_name) + " would write over the file that is read");
    EXPECT_EQ(read_file(water), before) << out;
    EXPECT_EQ(folder.names(), names) << out;
  }

  TemporaryFolder folder;
  std::string water;
};

TEST_P(OutputFiles, NeverTheInputUnderAnySpellingOfItsName) {
  fs::create_directory(folder.path("inner"));
  fs::create_symlink("water.pdb", folder.path("link"));
  fs::create_symlink(folder.path("link"), folder.path("link_to_link"));
  fs::create_hard_link(water, folder.path("hard"));
  fs::create_directory_symlink(folder.path(), folder.path("inner/up"));
  for (const char *name :
       {"water.pdb", "./water.pdb", "inner/../water.pdb", "inner/up//water.pdb", "link", "link_to_link", "hard"}) {
    expect_input_untouched(folder.path(name));
  }
  fs::remove(folder.path("inner/up"));
}

// The input may be the link as well.
TEST_P(OutputFiles, NeverWhatALinkedInputLeadsTo) {
  fs::create_symlink("water.pdb", folder.path("link.pdb"));
  const std::string before = read_file(water);
  expect_refusal(run_program(call(GetParam(), folder.path("link.pdb"), water)), 2,
                 std::string(GetParam().option_name) + " would write over the file that is read");
  EXPECT_EQ(read_file(water), before);
}

TEST_P(OutputFiles, NewFilesHaveTheUsualPermissions) {
  const mode_t mask = umask(027);
  EXPECT_EQ(write(folder.path("new")).status, 0);
  umask(mask);
  struct stat found;
  ASSERT_EQ(stat(folder.path("new").c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 07777u, 0640u);
  EXPECT_EQ(read_file(folder.path("new")), right());
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"new", "water.pdb"}));
}

TEST_P(OutputFiles, AnOldFileIsReplacedAndKeepsItsPermissions) {
  const std::string old = folder.write("old", std::string(100000, 'x'));
  ASSERT_EQ(chmod(old.c_str(), 0604), 0);
  EXPECT_EQ(write(old).status, 0);
  struct stat found;
  ASSERT_EQ(stat(old.c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 07777u, 0604u);
  EXPECT_EQ(read_file(old), right());
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"old", "water.pdb"}));
}

// Somebody else's file stays theirs where the user may give it away, and its group's where not.
TEST_P(OutputFiles, AnOldFileKeepsItsOwnerOrItsGroup) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can make files of others";
  const std::string old = folder.write("old", "old");
  ASSERT_EQ(chmod(folder.path().c_str(), 0777), 0);
  const auto check = [&](uid_t owner, gid_t group, mode_t mode) {
    struct stat found;
    ASSERT_EQ(stat(old.c_str(), &found), 0);
    EXPECT_EQ(found.st_uid, owner);
    EXPECT_EQ(found.st_gid, group);
    EXPECT_EQ(found.st_mode & 07777u, mode);
  };
  if (chown(old.c_str(), 1234, 1235) != 0) GTEST_SKIP() << "not even root can, here";
  ASSERT_EQ(chmod(old.c_str(), 0660), 0);
  EXPECT_EQ(write(old).status, 0);
  check(1234, 1235, 0660);
  Surroundings nobody;
  nobody.as_nobody = true;
  if (run_program_in(nobody, {"--version"}).status == 127) GTEST_SKIP() << "the program is out of other users' reach";
  const uid_t other = 65534;
  ASSERT_EQ(chown(old.c_str(), 1234, other), 0);
  ASSERT_EQ(chmod(old.c_str(), 0664), 0);
  EXPECT_EQ(run_program_in(nobody, call(GetParam(), "good/water.pdb", old)).status, 0);
  check(other, other, 0664);
  ASSERT_EQ(chown(old.c_str(), 1234, 1235), 0);
  ASSERT_EQ(chmod(old.c_str(), 0666), 0);
  EXPECT_EQ(run_program_in(nobody, call(GetParam(), "good/water.pdb", old)).status, 0);
  check(other, other, 0606);
}

// The link stays, and what it leads to is replaced, wherever that lies.
TEST_P(OutputFiles, LinksAreFollowed) {
  fs::create_directory(folder.path("inner"));
  folder.write("inner/old", "old");
  fs::create_symlink("old", folder.path("inner/link"));
  fs::create_symlink("inner/link", folder.path("link"));
  fs::create_symlink(folder.path("inner/absolute"), folder.path("inner/to_absolute"));
  fs::create_symlink("inner/none", folder.path("dangling"));
  EXPECT_EQ(write(folder.path("link")).status, 0);
  EXPECT_EQ(write(folder.path("dangling")).status, 0);
  EXPECT_EQ(write(folder.path("inner/to_absolute")).status, 0);
  for (const char *link : {"link", "inner/link", "dangling"}) EXPECT_TRUE(fs::is_symlink(folder.path(link))) << link;
  EXPECT_EQ(read_file(folder.path("inner/old")), right());
  EXPECT_EQ(read_file(folder.path("inner/none")), right());
  EXPECT_EQ(read_file(folder.path("inner/absolute")), right());
  fs::create_symlink("circle", folder.path("circle"));
  expect_refusal(write(folder.path("circle")), 1, folder.path("circle") + ": Too many levels of symbolic links");
}

// The other name of a file keeps what it had.
TEST_P(OutputFiles, OtherNamesOfTheOldFileKeepIt) {
  folder.write("old", "old");
  fs::create_hard_link(folder.path("old"), folder.path("other"));
  EXPECT_EQ(write(folder.path("old")).status, 0);
  EXPECT_EQ(read_file(folder.path("old")), right());
  EXPECT_EQ(read_file(folder.path("other")), "old");
}

// A limit on the size of files stands in for a full disk: the signal is no surprise.
TEST_P(OutputFiles, FullDiskLeavesTheOldFile) {
  Surroundings full;
  full.most_file_bytes = 100;
  const std::string old = folder.write("old", "old");
  expect_refusal(run_program_in(full, call(GetParam(), water, old)), 1, old + ": File too large");
  EXPECT_EQ(read_file(old), "old");
  const std::string fresh = folder.path("fresh");
  expect_refusal(run_program_in(full, call(GetParam(), water, fresh)), 1, fresh + ": File too large");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"old", "water.pdb"}));
}

TEST_P(OutputFiles, ReadOnlyFoldersAndFiles) {
  Surroundings nobody;
  nobody.as_nobody = true;
  const std::string old = folder.write("old", "old");
  ASSERT_EQ(chmod(old.c_str(), 0666), 0);
  ASSERT_EQ(chmod(folder.path().c_str(), 0555), 0);
  if (run_program_in(nobody, {"--version"}).status == 127) GTEST_SKIP() << "the program is out of other users' reach";
  expect_refusal(run_program_in(nobody, call(GetParam(), "good/water.pdb", old)), 1,
                 old + ": no new file can be made in its folder: Permission denied");
  const std::string fresh = folder.path("fresh");
  expect_refusal(run_program_in(nobody, call(GetParam(), "good/water.pdb", fresh)), 1,
                 fresh + ": no new file can be made in its folder: Permission denied");
  // The file decides as well: what is read-only is not replaced.
  ASSERT_EQ(chmod(folder.path().c_str(), 0777), 0);
  ASSERT_EQ(chmod(old.c_str(), 0444), 0);
  expect_refusal(run_program_in(nobody, call(GetParam(), "good/water.pdb", old)), 1, old + ": Permission denied");
  EXPECT_EQ(read_file(old), "old");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"old", "water.pdb"}));
}

TEST_P(OutputFiles, FoldersAreNoFiles) {
  fs::create_directory(folder.path("inner"));
  expect_refusal(write(folder.path("inner")), 1, folder.path("inner") + ": Is a directory");
  expect_refusal(write(folder.path("water.pdb/out")), 1, folder.path("water.pdb/out") + ": Not a directory");
  expect_refusal(write(folder.path("none/out")), 1, folder.path("none/out") + ": No such file or directory");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"inner", "water.pdb"}));
}

// Devices and pipes are written to as they are, never replaced.
TEST_P(OutputFiles, DevicesAndPipes) {
  EXPECT_EQ(write("/dev/null").status, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  if (fs::exists("/dev/full")) expect_refusal(write("/dev/full"), 1, "/dev/full: No space left on device");
  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = read_file(pipe); });
  EXPECT_EQ(write(pipe).status, 0);
  reader.join();
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(got, right());
}

TEST_P(OutputFiles, NotWhereStandardOutputGoesAlready) {
  const std::string out = folder.write("out", "");
  Surroundings redirected;
  redirected.out_path = out;
  const Outcome outcome = run_program_in(redirected, call(GetParam(), water, out));
  expect_refusal(outcome, 1, out + ": this is where standard output goes already");
  EXPECT_EQ(read_file(out), "");
}

std::string writer_name(const testing::TestParamInfo<Writer> &parameter) {
  return parameter.param.name;
}

INSTANTIATE_TEST_SUITE_P(Program, OutputFiles,
                         testing::Values(Writer{"Measure", {"measure"}, {"--pdb-out"}, "--pdb-out"},
                                         Writer{"Mesh", {"mesh", "--triangles", "ply"}, {"-o"}, "-o"},
                                         Writer{"Draw", {"draw", "--picture", "svg"}, {"-o"}, "-o"}),
                         writer_name);

// A file that somebody else left under the name of the new one stays too.
TEST(OutputFilesOfOneCommand, NamesThatAreTaken) {
  const TemporaryFolder folder("taken");
  Surroundings surroundings;
  surroundings.before = [&] { folder.write(".hardsphere-" + std::to_string(getpid()) + "-0", "taken"); };
  EXPECT_EQ(run_program_in(surroundings, {"draw", "good/water.pdb", "-o", folder.path("out.svg")}).status, 0);
  const std::vector<std::string> names = folder.names();
  ASSERT_EQ(names.size(), 2u);
  EXPECT_EQ(read_file(folder.path(names[0])), "taken");
  EXPECT_EQ(names[1], "out.svg");
}

// Devices are nobody's file, even if they are read and written.
TEST(OutputFilesOfOneCommand, OneDeviceForInputAndOutput) {
  EXPECT_NE(run_program({"measure", "/dev/null", "--format", "pdb", "--pdb-out", "/dev/null"}).status, 2);
}

// Of several files the one that was written first waits for the others.
TEST(OutputFilesOfOneCommand, AllOrNone) {
  const TemporaryFolder folder("all_or_none");
  folder.write("out.face", "old");
  fs::create_directory(folder.path("out.vert"));
  EXPECT_EQ(run_program({"mesh", "good/water.pdb", "-o", folder.path("out.vert")}).status, 1);
  EXPECT_EQ(read_file(folder.path("out.face")), "old");
  folder.write("tree.svg", "old");
  folder.write("points.pdb", "old");
  for (const auto &[points, tree] :
       {std::pair("points.pdb", "none/tree.svg"), std::pair("none/points.pdb", "tree.svg")}) {
    EXPECT_EQ(
        run_program({"pores", "good/water.pdb", "--points", folder.path(points), "--tree", folder.path(tree)}).status,
        1);
    EXPECT_EQ(read_file(folder.path("points.pdb")), "old");
    EXPECT_EQ(read_file(folder.path("tree.svg")), "old");
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"out.face", "out.vert", "points.pdb", "tree.svg"}));
}

// A series has as many files as a user wants, and names that strangers left are passed over.
TEST(OutputFilesOfOneCommand, Series) {
  const TemporaryFolder folder("series");
  const Outcome outcome = run_program({"draw", "good/water.pdb", "--spin", "150", "-o", folder.path("out.svg")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> names = folder.names();
  ASSERT_EQ(names.size(), 150u);
  EXPECT_EQ(names[149], "out-149.svg");
  EXPECT_FALSE(read_file(folder.path(names[149])).empty());
  fs::remove(folder.path("out-149.svg"));
  fs::create_directory(folder.path("out-149.svg"));
  const std::string first = folder.write("out-000.svg", "old");
  EXPECT_EQ(run_program({"draw", "good/water.pdb", "--spin", "150", "-o", folder.path("out.svg")}).err,
            "hardsphere: " + folder.path("out-149.svg") + ": Is a directory\n");
  EXPECT_EQ(read_file(first), "old");
  EXPECT_EQ(folder.names(), names);
}

// Links may lead two outputs to one file, there or not.
TEST(OutputFilesOfOneCommand, LinksToOneFile) {
  const TemporaryFolder folder("one_file");
  fs::create_directory_symlink(".", folder.path("here"));
  fs::create_symlink("here/chart.svg", folder.path("link.svg"));
  fs::create_symlink("./out.vert", folder.path("out.face"));
  fs::create_symlink("spin-000.svg", folder.path("spin-001.svg"));
  const std::vector<std::string> names = folder.names();
  for (const auto &[profile, tree] : {std::pair("chart.svg", "link.svg"), std::pair("link.svg", "here/chart.svg")}) {
    const Outcome outcome = run_program({"pores", "good/cage.xyzr", "--tunnels-from", "0,0,0", "--profile",
                                         folder.path(profile), "--tree", folder.path(tree)});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "hardsphere: --profile and --tree would write the same file\n");
  }
  const std::string refusal = ": another output of this run would write the same file\n";
  const Outcome mesh = run_program({"mesh", "good/water.pdb", "-o", folder.path("out.vert")});
  EXPECT_EQ(mesh.status, 1);
  EXPECT_EQ(mesh.err, "hardsphere: " + folder.path("out.vert") + refusal);
  const Outcome spin = run_program({"draw", "good/water.pdb", "--spin", "3", "-o", folder.path("spin.svg")});
  EXPECT_EQ(spin.status, 1);
  EXPECT_EQ(spin.err, "hardsphere: " + folder.path("spin-001.svg") + refusal);
  EXPECT_EQ(folder.names(), names);
}

// The message names the file that cannot be written, even if the user did not.
TEST(OutputFilesOfOneCommand, TheSecondFileOfAMeshIsNamed) {
  const TemporaryFolder folder("second");
  fs::create_directory(folder.path("out.face"));
  EXPECT_EQ(run_program({"mesh", "good/water.pdb", "-o", folder.path("out.vert")}).err,
            "hardsphere: " + folder.path("out.face") + ": Is a directory\n");
}

// Nothing is replaced if standard output fails, which comes first.
TEST(OutputFilesOfOneCommand, StandardOutputComesFirst) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const TemporaryFolder folder("full");
  const std::string out = folder.write("out.svg", "old");
  EXPECT_EQ(run_program({"draw", "good/water.pdb", "-o", out}, "/dev/full").status, 1);
  EXPECT_EQ(read_file(out), "old");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"out.svg"});
}

// The weights are an input too.
TEST(OutputFilesOfOneCommand, NeverTheWeights) {
  const TemporaryFile weights("weights", "1\n2\n3\n");
  const Outcome outcome =
      run_program({"measure", "good/water.pdb", "--weights", weights.path(), "--pdb-out",
                   testing::TempDir() + "/." + weights.path().substr(testing::TempDir().size() - 1)});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "hardsphere: --pdb-out would write over the file that is read\n");
  EXPECT_EQ(read_file(weights.path()), "1\n2\n3\n");
}

// A picture that takes long enough to be caught in the middle.
std::string many_balls() {
  std::string text;
  for (int i = 0; i < 100000; ++i) {
    text += std::to_string(i % 50) + " " + std::to_string(i / 50 % 50) + " " + std::to_string(i / 2500) + " 0.3\n";
  }
  return text;
}

bool half_written(const TemporaryFolder &folder) {
  for (const std::string &name : folder.names()) {
    if (name.rfind(".hardsphere-", 0) == 0) return true;
  }
  return false;
}

// A signal that ends the program in the middle of writing takes the new file away and leaves the old one.
TEST(OutputFilesOfOneCommand, SignalsLeaveTheOldFile) {
  const TemporaryFile balls("many.xyzr", many_balls());
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    bool caught = false;
    for (int attempt = 0; attempt < 10 && !caught; ++attempt) {  // it may have been too quick for us
      const TemporaryFolder folder("signals");
      const std::string out = folder.write("out.svg", "old");
      const pid_t child = start_program({"draw", balls.path(), "-o", out});
      ASSERT_GT(child, 0);
      int state = 0;
      pid_t ended = 0;
      while (ended == 0 && !half_written(folder)) {
        std::this_thread::sleep_for(std::chrono::microseconds(200));
        ended = waitpid(child, &state, WNOHANG);
      }
      if (ended == 0) {
        kill(child, number);
        ASSERT_EQ(waitpid(child, &state, 0), child);
      }
      EXPECT_EQ(folder.names(), std::vector<std::string>{"out.svg"}) << number;
      // The first SIGINT stops the run, which ends as shells have it.
      caught = number == SIGINT ? WIFEXITED(state) && WEXITSTATUS(state) == 130 : WIFSIGNALED(state);
      if (!caught) continue;
      if (number != SIGINT) {
        EXPECT_EQ(WTERMSIG(state), number);
      }
      EXPECT_EQ(read_file(out), "old") << number;
    }
    EXPECT_TRUE(caught) << number;
  }
}

}  // namespace
