// Trajectories: coordinates as they were written, lines as of single files, and what is refused with the frame's
// number.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "json_reader.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"
#include "trajectory_writers.hpp"

extern "C" {
#include "read/trajectory.h"
}

namespace {

using trajectories::Bytes;
using trajectories::DcdOptions;
using trajectories::Floats;
using trajectories::Place;
using trajectories::XtcOptions;
using Lines = std::vector<std::string>;

struct Frame {
  uint64_t number = 0;
  std::vector<double> xyz;
  frame_stamp stamp{};
};

struct Reading {
  std::vector<Frame> frames;
  std::string reason;  // empty: read to the end
};

// All frames by the program's reader, or every `every`th with the others stepped over.
Reading read_all(const std::string &path, uint32_t atoms, uint64_t every = 1) {
  Reading reading;
  trajectory frames;
  failure why;
  std::memset(&why, 0, sizeof why);
  bool good = trajectory_format_of(path.c_str(), file_format_named("xyz", FILE_ATOMS), &frames, &why) &&
              trajectory_open(&frames, path.c_str(), atoms, &why);
  while (good) {
    const bool wanted = (frames.frames + 1) % every == 0;
    const line_status status = trajectory_next(&frames, wanted, &why);
    if (status != LINE_READ) break;
    if (wanted) {
      reading.frames.push_back({frames.frames, {frames.xyz, frames.xyz + 3 * size_t{atoms}}, frames.stamp});
    }
  }
  trajectory_close(&frames);
  reading.reason = why.reason;
  return reading;
}

std::vector<Place> chain_of(size_t atoms, int64_t apart, int64_t step, std::mt19937 &random) {
  std::vector<Place> places(atoms);
  std::uniform_int_distribution<int64_t> anywhere(-apart, apart), near(-step, step);
  for (size_t i = 0; i < atoms; ++i) {
    for (size_t axis = 0; axis < 3; ++axis) {
      places[i][axis] = i % 20 == 0 ? anywhere(random) : places[i - 1][axis] + near(random);
    }
  }
  return places;
}

// Numbers of atoms about the one from which on they are packed; spans of packed numbers of up to 72 bits and of three
// numbers; all sizes of small differences.
TEST(Trajectory, PackedFramesAreReadAsTheyWereWritten) {
  std::mt19937 random(20);
  struct Kind {
    size_t atoms;
    int64_t apart, step;
    int index;
    float precision;
  };
  for (const Kind &kind : std::vector<Kind>{{1, 900, 10, 20, 1000},
                                            {9, 900, 10, 20, 1000},
                                            {10, 900, 10, 20, 1000},
                                            {11, 0, 0, 9, 1000},
                                            {300, 3000, 4, 9, 1000},
                                            {300, 30000, 60, 24, 100},
                                            {300, 7000000, 900, 37, 1000},
                                            {300, 8000000, 2000000, 66, 1000},
                                            {300, 8388606, 8000000, 72, 1000},
                                            {300, 9000000, 2000, 45, 1000},
                                            {300, 2000000000, 200000, 57, 10000}}) {
    Bytes file;
    std::vector<std::vector<Place>> written;
    for (int32_t k = 0; k < 6; ++k) {
      written.push_back(chain_of(kind.atoms, kind.apart, kind.step, random));
      XtcOptions options;
      options.step = 10 * k;
      options.time = 0.1F * static_cast<float>(k);
      options.first_index = kind.index;
      options.precision = kind.precision;
      options.large = k % 2 == 1;
      file += trajectories::xtc_frame(written.back(), options, random);
    }
    const TemporaryFile stored("run.xtc", file);
    for (const uint64_t every : {uint64_t{1}, uint64_t{2}}) {
      const Reading reading = read_all(stored.path(), static_cast<uint32_t>(kind.atoms), every);
      ASSERT_EQ(reading.reason, "");
      ASSERT_EQ(reading.frames.size(), 6 / every);
      for (const Frame &frame : reading.frames) {
        const size_t k = frame.number - 1;
        EXPECT_EQ(frame.stamp.step, static_cast<int64_t>(10 * k));
        EXPECT_NEAR(frame.stamp.time, 0.1 * static_cast<double>(k), 1e-8);
        for (size_t i = 0; i < 3 * kind.atoms; ++i) {
          const int64_t coordinate = written[k][i / 3][i % 3];
          const double expected = kind.atoms > 9
                                      ? static_cast<double>(10 * coordinate) / static_cast<double>(kind.precision)
                                      : 10.0 * static_cast<double>(static_cast<float>(coordinate) / kind.precision);
          ASSERT_EQ(frame.xyz[i], expected) << kind.atoms << " atoms, frame " << k << ", number " << i;
        }
      }
    }
  }
}

TEST(Trajectory, RecordsOfFloats) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> anywhere(-90.0F, 90.0F);
  for (int kind = 0; kind < 32; ++kind) {
    DcdOptions options;
    options.highest_first = (kind & 1) != 0;
    options.charmm = (kind & 2) != 0;
    options.cell = options.charmm && (kind & 4) != 0;
    options.fourth = options.charmm && (kind & 8) != 0;
    if ((kind & 16) != 0) options.free_atoms = {2, 3, 7};
    Floats atoms(8);
    std::vector<Floats> written;
    Bytes file = trajectories::dcd_header(8, options);
    for (int k = 0; k < 4; ++k) {
      for (size_t i = 0; i < 8; ++i) {
        const bool fixed = k > 0 && !options.free_atoms.empty() && i != 1 && i != 2 && i != 6;
        for (float &coordinate : atoms[i]) coordinate = fixed ? coordinate : anywhere(random);
      }
      written.push_back(atoms);
      file += trajectories::dcd_frame(atoms, k == 0, options);
    }
    const TemporaryFile stored("run.dcd", file);
    for (const uint64_t every : {uint64_t{1}, uint64_t{2}}) {
      const Reading reading = read_all(stored.path(), 8, every);
      ASSERT_EQ(reading.reason, "") << kind;
      ASSERT_EQ(reading.frames.size(), 4 / every);
      for (const Frame &frame : reading.frames) {
        const double step = 1000 + 100 * static_cast<double>(frame.number - 1);
        EXPECT_EQ(static_cast<double>(frame.stamp.step), step);
        EXPECT_NEAR(frame.stamp.time, step * 0.5 * 0.0488882, 1e-4);
        for (size_t i = 0; i < 24; ++i) {
          ASSERT_EQ(frame.xyz[i], static_cast<double>(written[frame.number - 1][i / 3][i % 3])) << kind;
        }
      }
    }
  }
}

// Floats and doubles, with and without other blocks beside the coordinates; frames without coordinates are none.
TEST(Trajectory, FramesInFullPrecision) {
  std::mt19937 random(9);
  std::uniform_real_distribution<float> anywhere(-9.0F, 9.0F);
  for (int kind = 0; kind < 32; ++kind) {
    trajectories::TrrOptions options;
    options.wide = (kind & 1) != 0;
    options.box = (kind & 2) != 0;
    options.virial = (kind & 4) != 0;
    options.velocities = (kind & 8) != 0;
    options.forces = (kind & 16) != 0;
    std::vector<Floats> written;
    Bytes file;
    for (int k = 0; k < 4; ++k) {
      Floats atoms(700);
      for (auto &atom : atoms) {
        for (float &coordinate : atom) coordinate = anywhere(random);
      }
      options.step = 7 * k;
      options.time = 0.1F * static_cast<float>(k);
      written.push_back(atoms);
      file += trajectories::trr_frame(atoms, options);
      trajectories::TrrOptions others = options;
      others.coordinates = false;
      others.velocities = true;
      if (k == 1) file += trajectories::trr_frame(atoms, others);
    }
    const TemporaryFile stored("run.trr", file);
    for (const uint64_t every : {uint64_t{1}, uint64_t{2}}) {
      const Reading reading = read_all(stored.path(), 700, every);
      ASSERT_EQ(reading.reason, "") << kind;
      ASSERT_EQ(reading.frames.size(), 4 / every);
      for (const Frame &frame : reading.frames) {
        const size_t k = frame.number - 1;
        EXPECT_EQ(frame.stamp.step, static_cast<int64_t>(7 * k));
        EXPECT_NEAR(frame.stamp.time, 0.1 * static_cast<double>(k), 1e-7);
        EXPECT_EQ(frame.stamp.box.given, options.box);
        if (options.box) {
          EXPECT_EQ(frame.stamp.box.vector[0], 30);
          EXPECT_EQ(frame.stamp.box.vector[8], 110);
        }
        for (size_t i = 0; i < 2100; ++i) {
          ASSERT_EQ(frame.xyz[i], 10.0 * static_cast<double>(written[k][i / 3][i % 3])) << kind;
        }
      }
    }
  }
}

TEST(Trajectory, DamagedFramesInFullPrecision) {
  const Floats atoms(5, {1, 2, 3});
  const Bytes good = trajectories::trr_frame(atoms, {});
  const auto reason = [&](const Bytes &file) {
    const TemporaryFile stored("run.trr", file);
    return read_all(stored.path(), 5).reason;
  };
  EXPECT_EQ(reason(good + good), "");
  for (size_t length = 1; length < good.size(); ++length) {
    EXPECT_NE(reason(good + good.substr(0, length)).find("frame 2: "), std::string::npos) << length;
  }
  // Magic number, name, one size, another number of atoms, a time that is none.
  const struct {
    size_t at;
    Bytes bytes;
    const char *reason;
  } damages[] = {{3, "x", "no frame of a .trr file"},
                 {14, "Y", "no frame of a .trr file"},
                 {24 + 4 * 2 + 3, "\x25", "sizes of its blocks"},
                 {24 + 4 * 7 + 3, "\x3d", "sizes of its blocks"},
                 {24 + 3, "\x08", "sizes of its blocks"},
                 {24 + 4 * 10 + 3, "\x06", "6 in place of 5 atoms"},
                 {76, "\x7f\xc0", "its time is not finite"},
                 {84, "\x7f\xc0", "its box is not finite"},
                 {120, "\x7f\xc0", "is not finite"}};
  for (const auto &damage : damages) {
    Bytes file = good;
    file.replace(damage.at, damage.bytes.size(), damage.bytes);
    EXPECT_NE(reason(file).find(damage.reason), std::string::npos) << damage.at << " " << reason(file);
  }
}

std::vector<Floats> some_floats(size_t atoms, size_t frames) {
  std::mt19937 random(9);
  std::uniform_real_distribution<float> anywhere(-9.0F, 9.0F);
  std::vector<Floats> all(frames, Floats(atoms));
  for (Floats &frame : all) {
    for (auto &atom : frame) {
      for (float &coordinate : atom) coordinate = anywhere(random);
    }
  }
  return all;
}

// All versions, floats and doubles, counted or not, with and without other variables beside the coordinates.
TEST(Trajectory, VariablesOfFrames) {
  const std::vector<Floats> written = some_floats(700, 4);
  for (int kind = 0; kind < 3 * 64; ++kind) {
    trajectories::NcOptions options;
    options.version = std::array<char, 3>{1, 2, 5}[static_cast<size_t>(kind) % 3];
    const int bits = kind / 3;
    options.wide = (bits & 1) != 0;
    options.streamed = (bits & 2) != 0;
    options.time = (bits & 4) != 0;
    options.cell = (bits & 8) != 0;
    options.velocities = (bits & 16) != 0;
    options.labels = options.flags = (bits & 32) != 0;
    options.scale = options.labels ? 0.5 : 1;
    const TemporaryFile stored("run.nc", trajectories::nc_file(written, options));
    for (const uint64_t every : {uint64_t{1}, uint64_t{2}}) {
      const Reading reading = read_all(stored.path(), 700, every);
      ASSERT_EQ(reading.reason, "") << kind;
      ASSERT_EQ(reading.frames.size(), 4 / every);
      for (const Frame &frame : reading.frames) {
        const size_t k = frame.number - 1;
        EXPECT_FALSE(frame.stamp.stepped);
        EXPECT_EQ(frame.stamp.timed, options.time);
        EXPECT_EQ(frame.stamp.time, options.time ? 0.5 * static_cast<double>(k) : 0);
        EXPECT_EQ(frame.stamp.box.given, options.cell);
        if (options.cell) {
          EXPECT_EQ(frame.stamp.box.vector[0], 30 + static_cast<double>(k));
          EXPECT_NEAR(frame.stamp.box.vector[3], 20, 1e-12);
          EXPECT_EQ(frame.stamp.box.vector[8], 50);
        }
        for (size_t i = 0; i < 2100; ++i) {
          ASSERT_EQ(frame.xyz[i], static_cast<double>(written[k][i / 3][i % 3])) << kind;
        }
      }
    }
  }
}

// Every shorter file keeps the frames that are whole; damages that a number tells are said with it.
TEST(Trajectory, DamagedVariables) {
  trajectories::NcOptions options;
  options.cell = options.velocities = true;
  const std::vector<Floats> frames = some_floats(5, 3);
  const Bytes good = trajectories::nc_file(frames, options);
  const auto read = [&](const Bytes &file) {
    const TemporaryFile stored("run.nc", file);
    return read_all(stored.path(), 5);
  };
  const size_t frame = 4 + 60 + 60 + 48, header = good.size() - 3 * frame;
  for (size_t length = 0; length < good.size(); ++length) {
    const Reading reading = read(good.substr(0, length));
    const size_t whole = length < header ? 0 : (length - header) / frame;
    EXPECT_EQ(reading.frames.size(), whole) << length;
    EXPECT_EQ(reading.reason,
              (length < header ? "" : "frame " + std::to_string(whole + 1) + ": ") + "cut off: the file ends here");
  }
  // Offsets of 64 bits whose ends are beyond all numbers.
  trajectories::NcOptions wide = options;
  wide.version = 2;
  Bytes beyond = trajectories::nc_file(frames, wide);
  beyond.replace(beyond.find("cell_lengths") + 40, 8, "\xff\xff\xff\xff\xff\xff\xff\xf8");
  EXPECT_EQ(read(beyond).reason, "its header is damaged");
  options.streamed = true;
  EXPECT_EQ(read(trajectories::nc_file(frames, options) + "x").reason, "frame 4: cut off: the file ends here");
  const auto found = [&](const std::string &text) { return good.find(text); };
  const struct {
    size_t at;
    Bytes bytes;
    const char *reason;
  } damages[] = {
      {0, "\x89HDF", "NetCDF-4 files are not read"},
      {0, "CDX", "this is no .nc file"},
      {3, "\x03", "this is no .nc file"},
      {11, "\x0b", "its header is damaged"},                    // the tag of dimensions
      {12, Bytes("\0\0\x04\x01", 4), "its header is damaged"},  // 1025 of them
      {found("atom") + 7, "\x06", "6 in place of 5 atoms"},
      {found("spatial") + 11, "\x02", "its variable coordinates is not by frame, atom and axis"},
      {found("cell_spatial") + 15, "\x04", "its variable cell_lengths is not by frame, three numbers each"},
      {found("coordinates"), "x", "it has no coordinates"},
      {found("coordinates") + 12 + 11, Bytes("\0", 1), "its header is damaged"},  // by frame, frame and axis
      {found("angstrom"), "nanometr", "its variable coordinates is not in angstrom"},
      {found("cell_lengths") + 12 + 12 + 8 + 3, "\x04", "its variable cell_lengths has neither floats nor doubles"},
      {found("cell_lengths") + 12 + 12 + 8 + 3, "\x0c", "its header is damaged"},
      {found("cell_lengths") + 12 + 12 + 8 + 8, "\x7f", "its header is damaged"},  // it begins elsewhere
      {header, "\x7f\xc0", "frame 1: its time is not finite"},
      {header + 4 + 60, "\x7f\xc0", "frame 1: x of atom 1, counted from 1, is not finite"},
      {header + frame + 4 + 60 + 60, "\x7f\xf0", "frame 2: its cell is not finite"},
  };
  for (const auto &damage : damages) {
    Bytes file = good;
    ASSERT_NE(damage.at, Bytes::npos);
    file.replace(damage.at, damage.bytes.size(), damage.bytes);
    EXPECT_NE(read(file).reason.find(damage.reason), std::string::npos) << damage.at << " " << read(file).reason;
  }
}

// Three frames of six atoms on a lattice of 0.01 angstrom.
std::vector<std::vector<Place>> some_frames() {
  std::vector<std::vector<Place>> frames;
  for (int64_t k = 0; k < 3; ++k) {
    std::vector<Place> atoms;
    for (int64_t i = 0; i < 12; ++i) atoms.push_back({120 * i + 7 * k * i, 31 * (i % 3) * k, 77 * (i % 2) - 5 * k});
    frames.push_back(atoms);
  }
  return frames;
}

const char *const element[] = {"C", "N", "O", "C"};

std::string hundredths(int64_t value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", static_cast<double>(value) / 100.0);
  return text;
}

std::string xyz_of(const std::vector<Place> &atoms, const std::string &title) {
  std::string text = std::to_string(atoms.size()) + "\n" + title + "\n";
  for (size_t i = 0; i < atoms.size(); ++i) {
    text += element[i % 4];
    for (const int64_t coordinate : atoms[i]) text.append(" ").append(hundredths(coordinate));
    text += "\n";
  }
  return text;
}

std::string gro_of(const std::vector<Place> &atoms, const std::string &title) {
  std::string text = title + "\n" + std::to_string(atoms.size()) + "\n";
  for (size_t i = 0; i < atoms.size(); ++i) {
    char line[80];
    std::snprintf(line, sizeof line, "%5d%-5s%5s%5d%8.3f%8.3f%8.3f\n", 1, "LIG", element[i % 4], 1,
                  static_cast<double>(atoms[i][0]) / 1000, static_cast<double>(atoms[i][1]) / 1000,
                  static_cast<double>(atoms[i][2]) / 1000);
    text += line;
  }
  return text + "   5.0 5.0 5.0\n";
}

std::string pdb_of(const std::vector<Place> &atoms, const std::string &before, const std::string &behind) {
  std::string text = before;
  for (size_t i = 0; i < atoms.size(); ++i) {
    char line[100];
    std::snprintf(line, sizeof line, "ATOM  %5d  %s   LIG A%4d    %8.3f%8.3f%8.3f  1.00  0.00           %s\n",
                  static_cast<int>(i + 1), element[i % 4], 1, static_cast<double>(atoms[i][0]) / 100,
                  static_cast<double>(atoms[i][1]) / 100, static_cast<double>(atoms[i][2]) / 100, element[i % 4]);
    text += line;
  }
  return text + behind;
}

Lines lines_of(const std::string &text) {
  Lines lines;
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

// From the first quotation mark of `key` to the end of what a single file gives, which has its input behind.
std::string part_of(const std::string &json, const std::string &key) {
  const size_t begin = json.find("\"" + key + "\"");
  return json.substr(begin, json.find(", \"input\"") - begin) + "}";
}

// A frame gives what its atoms give as a file of their own, whatever the format and the command.
TEST(Trajectory, FramesGiveWhatFilesGive) {
  const std::vector<std::vector<Place>> frames = some_frames();
  std::mt19937 random(3);
  Bytes xtc, xyz, gro, pdb, bare;
  DcdOptions dcd_options;
  dcd_options.cell = true;
  for (size_t k = 0; k < frames.size(); ++k) {
    XtcOptions options;
    options.time = 2.5F * static_cast<float>(k);
    options.step = static_cast<int32_t>(5 * k);
    const std::string time = "t= " + std::to_string(2.5 * static_cast<double>(k)), step = std::to_string(5 * k);
    xtc += trajectories::xtc_frame(frames[k], options, random);
    xyz += xyz_of(frames[k], " i = " + step + ", time" + time.substr(1) + ", E = -1.5");
    gro += gro_of(frames[k], "Ligand in nothing " + time + " step= " + step);
    pdb += pdb_of(frames[k], "TITLE     Ligand " + time + " step= " + step + "\nMODEL  1\n", "TER\nENDMDL\n");
    bare += pdb_of(frames[k], k > 0 ? "MODEL 2\n" : "", k == 1 ? "" : "END\n");
  }
  const TemporaryFile file("ligand.xyz", xyz_of(frames[2], "")), xtc_file("run.xtc", xtc), xyz_file("run.xyz", xyz),
      gro_file("run.gro", gro), pdb_file("run.pdb", pdb), bare_file("bare.ent", bare);
  for (const Lines &command : std::vector<Lines>{{"measure", "--probe", "1.4", "--curvature"},
                                                 {"measure", "--hide", "element:N", "--per-ball", "--polar"},
                                                 {"contacts", "--cells"}}) {
    Lines expected;
    for (size_t k = 0; k < frames.size(); ++k) {
      const TemporaryFile alone("alone.xyz", xyz_of(frames[k], ""));
      Lines call = command;
      call.insert(call.end(), {"--json", alone.path()});
      expected.push_back(part_of(run_program(call).out, "n"));
    }
    for (const TemporaryFile *run : {&xtc_file, &xyz_file, &gro_file, &pdb_file, &bare_file}) {
      Lines call = command;
      call.insert(call.end(), {"--json", file.path(), "--trajectory", run->path()});
      const Outcome outcome = run_program(call);
      EXPECT_EQ(outcome.status, 0);
      EXPECT_EQ(outcome.err, "");
      const Lines found = lines_of(outcome.out);
      ASSERT_EQ(found.size(), frames.size()) << outcome.out << run->path();
      for (size_t k = 0; k < frames.size(); ++k) {
        EXPECT_EQ(part_of(found[k], "n").substr(0, found[k].find(", \"input\"")), expected[k] + "}") << run->path();
        std::string stamp = "{\"frame\": ";
        stamp.append(std::to_string(k + 1)).append(", \"time\": ");
        if (run == &bare_file) {
          stamp.append("null, \"step\": null");
        } else {
          stamp.append(k == 1 ? "2.5" : k == 2 ? "5" : "0").append(", \"step\": ").append(std::to_string(5 * k));
        }
        EXPECT_EQ(found[k].substr(0, found[k].find(", \"n\"")), stamp);
      }
    }
  }
}

// Of an atom at several locations in a frame the one counts that the user chose; atoms are counted behind the choice.
TEST(Trajectory, LocationsOfFrames) {
  const auto record = [](const char *site, double x, double occupancy) {
    char line[96];
    std::snprintf(line, sizeof line, "ATOM      1  %-4s%-10s   %8.3f%8.3f%8.3f%6.2f%6.2f           C\n", site,
                  "ALA A   1", x, 0.0, 0.0, occupancy, 0.0);
    return std::string(line);
  };
  const auto model = [&](double shift, double occupancy) {
    return "MODEL        1\n" + record("N", shift, 1) + record("CA A", shift + 1, occupancy) +
           record("CA B", shift + 9, 1 - occupancy) + "ENDMDL\n";
  };
  const TemporaryFile run("run.pdb", model(0, 0.4) + model(20, 0.7));
  const auto read = [](const TemporaryFile &file, char location, uint32_t atoms, std::string *reason) {
    std::vector<double> x;
    trajectory frames;
    failure why;
    std::memset(&why, 0, sizeof why);
    EXPECT_TRUE(trajectory_format_of(file.path().c_str(), nullptr, &frames, &why));
    frames.location = location;
    EXPECT_TRUE(trajectory_open(&frames, file.path().c_str(), atoms, &why));
    while (trajectory_next(&frames, true, &why) == LINE_READ) {
      for (uint32_t i = 0; i < atoms; ++i) x.push_back(frames.xyz[size_t{3} * i]);
    }
    trajectory_close(&frames);
    *reason = why.reason;
    return x;
  };
  using X = std::vector<double>;
  std::string reason;
  EXPECT_EQ(read(run, LOCATION_FIRST, 2, &reason), X({0, 1, 20, 21}));
  EXPECT_EQ(read(run, LOCATION_BY_OCCUPANCY, 2, &reason), X({0, 9, 20, 21}));
  EXPECT_EQ(read(run, 'A', 2, &reason), X({0, 1, 20, 21}));
  EXPECT_EQ(read(run, 'B', 2, &reason), X({0, 9, 20, 29}));
  EXPECT_EQ(reason, "");
  EXPECT_EQ(read(run, 'B', 1, &reason), X());
  EXPECT_EQ(reason, "frame 1: 2 in place of 1 atoms");
  EXPECT_EQ(read(run, 'B', 3, &reason), X());
  EXPECT_EQ(reason, "frame 1: 2 in place of 3 atoms");
}

// Quarters of an angstrom, which floats and decimals have alike: a NetCDF file gives the bytes that .xyz and .gro give.
TEST(Trajectory, VariablesGiveWhatTextsGive) {
  std::vector<Floats> floats;
  Bytes xyz, gro;
  for (std::vector<Place> frame : some_frames()) {
    floats.emplace_back();
    for (Place &place : frame) {
      floats.back().emplace_back();
      for (size_t axis = 0; axis < 3; ++axis) {
        place[axis] = place[axis] / 25 * 25;
        floats.back().back()[axis] = static_cast<float>(place[axis]) / 100;
      }
    }
    xyz += xyz_of(frame, "");
    gro += gro_of(frame, "");
  }
  trajectories::NcOptions options;
  options.velocities = true;
  const TemporaryFile xyz_file("run.xyz", xyz), gro_file("run.gro", gro),
      nc_file("run.nc", trajectories::nc_file(floats, options));
  const auto rows = [&](const TemporaryFile &run) {
    std::vector<std::string> cut;
    for (const std::string &line :
         lines_of(run_program({"measure", xyz_file.path(), "--trajectory", run.path(), "--curvature", "--threads", "2"})
                      .out)) {
      size_t at = 0;
      for (int comma = 0; comma < 3; ++comma) at = line.find(',', at) + 1;  // without time and step
      cut.push_back(line.substr(0, line.find(',')) + line.substr(at));
    }
    return cut;
  };
  EXPECT_EQ(rows(nc_file).size(), 4U);
  EXPECT_EQ(rows(nc_file), rows(xyz_file));
  EXPECT_EQ(rows(nc_file), rows(gro_file));
}

// tests/program/inputs/crambin.xtc: crambin as its .pdb file has it, to the last digit, and shaken twice.
TEST(Trajectory, PackedCoordinatesAreThoseOfTheFile) {
  const std::string crambin = molecules_folder() + "/crambin.pdb";
  const Lines packed = lines_of(run_program({"measure", crambin, "--trajectory", "crambin.xtc", "--json"}).out);
  ASSERT_EQ(packed.size(), 3U);
  const std::string alone = run_program({"measure", crambin, "--json"}).out;
  EXPECT_EQ(part_of(packed[0], "n"), part_of(alone, "n") + "}");
  EXPECT_NE(part_of(packed[1], "n"), part_of(packed[0], "n"));
}

// The same as a table, of the frames that are asked for.
// The box of every frame where the file has one each, of .gro, .xyz, .xtc and .dcd, whatever other frames have; and
// what wraps in it.
TEST(Trajectory, FramesHaveTheirOwnBoxes) {
  const TemporaryFile molecule("one.xyz", "1\n\nC 0 0 0\n");
  std::mt19937 random(23);
  XtcOptions large, small;
  large.box = 4;
  small.box = 0.25F;
  DcdOptions cell;
  cell.cell = true;
  cell.frames = 2;
  const Bytes dcd = dcd_header(1, cell) + dcd_frame({{0, 0, 0}}, true, cell) + dcd_frame({{1, 0, 0}}, false, cell);
  const std::string gro = "frame\n    1\n    1UNK      C    1   0.000   0.000   0.000\n   1.00000   1.20000   ";
  const struct {
    const char *name;
    Bytes frames;
    std::vector<double> volumes;
  } files[] = {
      {"boxes.xtc", xtc_frame({{0, 0, 0}}, large, random) + xtc_frame({{0, 0, 0}}, small, random), {64000, 15.625}},
      {"boxes.dcd", dcd, {210000, 210000}},
      {"boxes.gro", gro + "0.30000\n" + gro + "0.50000\n", {360, 600}},
      {"boxes.xyz",
       "1\nLattice=\"9 0 0 1 8 0 2 1 7\"\nC 0 0 0\n1\nLattice=\"3 0 0 0 9 0 0 0 9\"\nC 1 1 1\n",
       {504, 243}}};
  for (const auto &file : files) {
    const TemporaryFile run(file.name, file.frames);
    const Outcome outcome =
        run_program({"measure", molecule.path(), "--trajectory", run.path(), "--box", "file", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Lines lines = lines_of(outcome.out);
    ASSERT_EQ(lines.size(), file.volumes.size()) << outcome.out;
    for (size_t k = 0; k < lines.size(); ++k) {
      const std::optional<Json> read = read_json(lines[k]);
      ASSERT_TRUE(read.has_value()) << lines[k];
      const Json &frame = *read;
      EXPECT_NEAR(frame["box_volume"].number, file.volumes[k], 1e-4) << file.name;
      EXPECT_NEAR(frame["free_volume"].number, frame["box_volume"].number - frame["volume"].number, 1e-4) << file.name;
      // A carbon of radius 1.7 meets its images where the box is less wide.
      bool thin = false;
      for (const size_t side : {0U, 4U, 8U}) thin = thin || frame["box"].items.at(side).number < 3.4;
      EXPECT_EQ(frame["windings"].items.at(0)["directions"].number > 0, thin) << file.name;
    }
  }
  const TemporaryFile never("never.xyz", "1\n\nC 0 0 0\n");
  const Outcome none = run_program({"measure", molecule.path(), "--trajectory", never.path(), "--box", "file"});
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.err.find("frame 1"), std::string::npos) << none.err;
  EXPECT_NE(none.err.find("the frame has no box"), std::string::npos) << none.err;
  const TemporaryFile refused("refused.xyz",
                              "1\nLattice=\"9 0 0 0 8 0 0 0 7\"\nC 0 0 0\n"
                              "1\nLattice=\"9 0 0 0 8 0 0 0 0.001\"\nC 0 0 0\n");
  const Outcome thin = run_program({"measure", molecule.path(), "--trajectory", refused.path(), "--box", "file"});
  EXPECT_EQ(thin.status, 1);
  EXPECT_EQ(lines_of(thin.out).size(), 2U) << "the frame before is there";
  EXPECT_NE(thin.err.find("frame 2"), std::string::npos) << thin.err;
}

TEST(Trajectory, TableOfFrames) {
  const std::vector<std::vector<Place>> frames = some_frames();
  std::string xyz;
  for (int k = 0; k < 9; ++k) xyz += xyz_of(frames[static_cast<size_t>(k % 3)], "");
  const TemporaryFile run("run.xyz", xyz);
  const auto call = [&run](const Lines &options) {
    Lines arguments = {"measure", run.path(), "--trajectory", run.path()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(arguments);
  };
  const Lines all = lines_of(call({}).out);
  ASSERT_EQ(all.size(), 10U);
  EXPECT_EQ(all[0], "frame,time,step,atoms,area,volume");
  EXPECT_EQ(all[4].substr(1), all[1].substr(1));
  EXPECT_NE(all[2].substr(1), all[1].substr(1));
  EXPECT_EQ(all[3].substr(0, 7), "3,,,12,");
  EXPECT_EQ(lines_of(call({"--frames", "2:8:3", "--csv"}).out), (Lines{all[0], all[2], all[5], all[8]}));
  EXPECT_EQ(lines_of(call({"--frames", "::4"}).out), (Lines{all[0], all[1], all[5], all[9]}));
  EXPECT_EQ(lines_of(call({"--frames=8:"}).out), (Lines{all[0], all[8], all[9]}));
  EXPECT_EQ(lines_of(call({"--frames", "3"}).out), (Lines{all[0], all[3]}));
  EXPECT_EQ(lines_of(call({"--curvature", "--polar", "--frames", "1"}).out)[0],
            "frame,time,step,atoms,area,volume,mean_curvature,gauss_curvature,polar_area,apolar_area,other_area");
  EXPECT_EQ(call({"--frames", "10"}).err, "hardsphere: " + run.path() + ": no frame 10: the file has 9\n");
  EXPECT_EQ(call({"--frames", "10"}).status, 1);
  Surroundings piped;
  piped.in_path = run.path();
  piped.in_is_pipe = true;
  EXPECT_EQ(lines_of(run_program_in(piped, {"measure", run.path(), "--trajectory", "-"}).out), all);
}

// Lists of pores of each frame are those of a file of the frame alone.
TEST(Trajectory, ListsOfPores) {
  const auto cage = [](const std::string &side) {
    std::string text = "6\n\n";
    for (const std::string &at : {side, "-" + side}) {
      text.append("C ").append(at).append(" 0 0\nC 0 ").append(at).append(" 0\nC 0 0 ").append(at).append("\n");
    }
    return text;
  };
  const std::vector<std::string> frames = {cage("2.4"), cage("2.5")};
  const TemporaryFile run("run.xyz", frames[0] + frames[1]);
  for (const Lines &list : {Lines{}, Lines{"--gates"}, Lines{"--regions"}}) {
    const auto call = [&list](const Lines &files) {
      Lines arguments = {"pores", "--csv", "--probe", "0.1"};
      arguments.insert(arguments.end(), list.begin(), list.end());
      arguments.insert(arguments.end(), files.begin(), files.end());
      const Outcome outcome = run_program(arguments);
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      return lines_of(outcome.out);
    };
    Lines expected;
    for (size_t k = 0; k < 2; ++k) {
      const TemporaryFile alone("alone.xyz", frames[k]);
      for (const std::string &row : call({alone.path()})) {
        const bool titles = !(row[0] >= '0' && row[0] <= '9');
        if (!titles || k == 0) expected.push_back((titles ? "frame,time,step," : std::to_string(k + 1) + ",,,") + row);
      }
    }
    EXPECT_EQ(call({run.path(), "--trajectory", run.path()}), expected);
    EXPECT_GT(expected.size(), 2U);
  }
  // Without --csv a frame has one row, which no gate has a place in.
  EXPECT_EQ(run_program({"pores", run.path(), "--trajectory", run.path(), "--gates"}).status, 2);
}

TEST(Trajectory, UsageThatIsRefused) {
  for (const Lines &options : std::vector<Lines>{{"--frames", "1:2"},
                                                 {"--trajectory", "run.xtc", "--frames", "0"},
                                                 {"--trajectory", "run.xtc", "--frames", "3:2"},
                                                 {"--trajectory", "run.xtc", "--frames", "1:2:0"},
                                                 {"--trajectory", "run.xtc", "--frames", "1:2:3:4"},
                                                 {"--trajectory", "run.xtc", "--frames", "a"},
                                                 {"--trajectory", "run.xtc", "--frames", ""},
                                                 {"--trajectory", "run.xtc", "--per-ball"},
                                                 {"--trajectory", "run.xtc", "--csv", "--by", "residue"},
                                                 {"--trajectory", "run.xtc", "--json", "--csv"},
                                                 {"--trajectory", "run.xtc", "--pdb-out", "x.pdb"},
                                                 {"--trajectory", "run.xtc", "good/one.cif"},
                                                 {"--trajectory", "a.xtc", "--trajectory", "b.xtc"}}) {
    Lines arguments = {"measure", "good/water.pdb"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.status, 2) << testing::PrintToString(options);
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  }
  EXPECT_EQ(run_program({"model", "good/water.pdb", "--trajectory", "run.xtc"}).status, 2);
  EXPECT_EQ(
      run_program({"measure", "good/water.pdb", "--trajectory", "run.mdcrd"}).err,
      "hardsphere: run.mdcrd: no trajectory by its extension; expected .xtc, .trr, .dcd, .nc, .pdb, .xyz or .gro\n");
}

struct Broken {
  std::string name;
  Bytes file;
  std::string reason;
  size_t frames;  // that come before
};

std::string replaced(Bytes bytes, size_t at, const Bytes &by) {
  bytes.replace(at, by.size(), by);
  return bytes;
}

// Faults are said with the frame's number, and the lines before are there.
TEST(Trajectory, BrokenFilesKeepTheLinesBefore) {
  const std::vector<std::vector<Place>> frames = some_frames();
  std::mt19937 random(5);
  const auto word = [](uint32_t value) { return trajectories::bytes_of(value, 4, true); };
  const uint32_t nan = trajectories::bits_of(std::numeric_limits<float>::quiet_NaN());
  const Bytes packed = trajectories::xtc_frame(frames[0], {}, random);
  const std::vector<Place> few(frames[0].begin(), frames[0].begin() + 11);
  DcdOptions options;
  const Floats floats(12, {1.0F, 2.0F, 3.0F});
  const Bytes header = trajectories::dcd_header(12, options), frame = trajectories::dcd_frame(floats, true, options);
  const std::string xyz = xyz_of(frames[0], ""), gro = gro_of(frames[0], ""), pdb = pdb_of(frames[0], "", "END\n");
  const std::string damaged = "the packed coordinates are damaged", cut = "cut off: the file ends here",
                    before = "what stands before the packed coordinates is damaged";
  const std::vector<Broken> files = {
      {"a.xtc", packed + packed.substr(0, 1), cut, 1},
      {"b.xtc", packed + packed.substr(0, 50), cut, 1},
      {"c.xtc", packed + packed + packed.substr(0, packed.size() - 1), cut, 2},
      {"d.xtc", packed + "abcdefgh", "no frame of an .xtc file begins here", 1},
      {"e.xtc", packed + trajectories::xtc_frame(few, {}, random), "11 in place of 12 atoms", 1},
      {"f.xtc", packed + replaced(packed, 4, word(0xFFFFFFFF)), "4294967295 in place of 12 atoms", 1},
      {"g.xtc", packed + replaced(packed, 52, word(13)), "13 in place of 12 atoms", 1},
      {"h.xtc", packed + replaced(packed, 12, word(nan)), "its time is not finite", 1},
      {"i.xtc", packed + replaced(packed, 20, word(nan)), "its box is not finite", 1},
      {"j.xtc", packed + replaced(packed, 56, word(nan)), before, 1},
      {"k.xtc", packed + replaced(packed, 56, word(0)), before, 1},
      {"l.xtc", packed + replaced(packed, 60, word(0x7FFFFFFF)), before, 1},
      {"m.xtc", packed + replaced(packed, 84, word(73)), before, 1},
      {"n.xtc", packed + replaced(packed, 84, word(8)), before, 1},
      {"o.xtc", packed + replaced(packed, 88, word(0xFFFFFFFF)), before, 1},
      {"p.xtc", packed + replaced(packed, 88, word(4)) + Bytes(400, '\0'), damaged, 1},
      {"q.xtc", packed + replaced(packed, 92, Bytes(packed.size() - 92, '\xFF')), damaged, 1},
      {"a.dcd", header + frame + frame.substr(0, 3), cut, 1},
      {"b.dcd", header + frame + frame.substr(0, 60), cut, 1},
      {"c.dcd", header + frame + replaced(frame, 0, Bytes(1, '\x2C')), "coordinates of 11 atoms where 12 belong", 1},
      {"d.dcd", header + frame + replaced(frame, 52, Bytes(1, '\x2C')), "the two lengths of a record differ", 1},
      {"e.dcd", header + frame + replaced(frame, 4 + 3, "\xFF\xFF\xFF"), "x of atom 1, counted from 1, is not finite",
       1},
      {"a.xyz", xyz + "13\n", "13 atoms announced, the file ends after 0", 1},
      {"b.xyz", xyz + xyz.substr(0, xyz.size() - 20), "", 1},
      {"c.xyz", xyz + xyz_of(few, ""), "11 in place of 12 atoms", 1},
      {"d.xyz", xyz + xyz + "C 1 2 3\n", "expected the number of atoms alone on this line", 2},
      {"e.xyz", xyz + "99999999999999999\n\n" + xyz, "", 1},
      {"a.gro", gro + gro + "title\n", "expected the number of atoms alone on the line after the title", 2},
      {"b.gro", gro + gro_of(few, ""), "11 in place of 12 atoms", 1},
      {"a.pdb", pdb + pdb.substr(0, 81), "1 in place of 12 atoms", 1},
      {"b.pdb", pdb + pdb.substr(0, pdb.size() - 4) + pdb, "more than 12 atoms, which the molecule has", 1},
      {"c.pdb", pdb + "MODEL 2\nENDMDL\n", "0 in place of 12 atoms", 1},
  };
  const TemporaryFile molecule("ligand.xyz", xyz);
  for (const Broken &broken : files) {
    const TemporaryFile run(broken.name, broken.file);
    const Outcome outcome = run_program({"measure", molecule.path(), "--trajectory", run.path()});
    EXPECT_EQ(outcome.status, 1) << broken.name;
    EXPECT_EQ(lines_of(outcome.out).size(), broken.frames + 1) << broken.name << outcome.out << outcome.err;
    std::string text = ": frame ";
    text.append(std::to_string(broken.frames + 1)).append(": ").append(broken.reason);
    EXPECT_NE(outcome.err.find(text), std::string::npos) << broken.name << ": " << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U);
  }
  for (const auto &[name, file, reason] : std::vector<std::array<std::string, 3>>{
           {"a.dcd", header.substr(0, 50), cut},
           {"b.dcd", trajectories::bytes_of(84, 8, false) + header, "lengths of records in 64 bits are not read"},
           {"c.dcd", replaced(header, 4, "VELD"), "this .dcd file holds no coordinates"},
           {"d.dcd", "", cut},
           {"e.dcd", "MODEL 1\nATOM", "this is no .dcd file: it does not begin with a record of 84 bytes"},
           {"f.dcd", trajectories::dcd_header(11, options), "11 in place of 12 atoms"},
           {"g.dcd", header, "no frames in the file"},
           {"h.xtc", "", "no frames in the file"},
           {"i.xyz", "\n", "no frames in the file"},
           {"j.pdb", "END\n", "no frames in the file"}}) {
    const TemporaryFile run(name, file);
    const Outcome outcome = run_program({"measure", molecule.path(), "--trajectory", run.path()});
    EXPECT_EQ(outcome.status, 1) << name;
    EXPECT_EQ(outcome.out, "") << name;
    EXPECT_EQ(outcome.err, "hardsphere: " + run.path() + ": " + reason + "\n");
  }
}

// A ball that the library refuses, and an output that is full.
TEST(Trajectory, FramesThatCannotBeMeasuredOrPrinted) {
  const std::vector<std::vector<Place>> frames = some_frames();
  std::string far = xyz_of(frames[0], "") + "12\n\n";
  for (int i = 0; i < 12; ++i) far += "C 1e300 0 " + std::to_string(i) + "\n";
  const TemporaryFile molecule("ligand.xyz", xyz_of(frames[0], "")), run("run.xyz", far);
  const Outcome outcome = run_program({"measure", molecule.path(), "--trajectory", run.path()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(lines_of(outcome.out).size(), 2U);
  EXPECT_EQ(outcome.err.find("hardsphere: " + run.path() + ":17: frame 2: ball 0: "), 0U) << outcome.err;
  if (std::FILE *full = std::fopen("/dev/full", "w"); full != nullptr) {
    std::fclose(full);
    EXPECT_EQ(run_program({"measure", molecule.path(), "--trajectory", run.path()}, "/dev/full").err,
              "hardsphere: standard output: No space left on device\n");
  }
}

}  // namespace
