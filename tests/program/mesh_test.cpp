// hardsphere mesh: the files of each format hold one closed surface, and the same one.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

const std::string molecule = "good/water.pdb";

struct Triangles {
  std::vector<std::array<double, 3>> places;
  std::vector<std::array<size_t, 3>> corners;
  std::set<int> kinds;  // of patches, in .ply
};

std::vector<std::string> lines_of(const std::string &text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<double> numbers_of(std::string line) {
  for (char &c : line) {
    if (c == '/' || c == 'v' || c == 'n' || c == 'f') c = ' ';
  }
  std::vector<double> numbers;
  std::istringstream stream(line);
  for (double x = 0; stream >> x;) numbers.push_back(x);
  return numbers;
}

void expect_closed(const Triangles &mesh, const std::string &what) {
  std::map<std::pair<size_t, size_t>, int> edges;
  for (const auto &c : mesh.corners) {
    for (size_t k = 0; k < 3; ++k) {
      ASSERT_LT(c[k], mesh.places.size()) << what;
      ++edges[{c[k], c[(k + 1) % 3]}];
    }
  }
  for (const auto &[edge, times] : edges) {
    EXPECT_EQ(times, 1) << what;
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u) << what;
  }
  EXPECT_GT(mesh.corners.size(), 100u) << what;
}

double volume_of(const Triangles &mesh) {
  double sum = 0;
  for (const auto &c : mesh.corners) {
    const auto &p = mesh.places[c[0]], &q = mesh.places[c[1]], &r = mesh.places[c[2]];
    for (size_t k = 0; k < 3; ++k) {
      const size_t l = (k + 1) % 3, m = (k + 2) % 3;
      sum += p[k] * (q[l] * r[m] - q[m] * r[l]) / 6;
    }
  }
  return sum;
}

Triangles read_ply(const std::string &text) {
  Triangles mesh;
  size_t vertices = 0, triangles = 0, at = 0;
  const std::vector<std::string> lines = lines_of(text);
  EXPECT_EQ(lines.at(0), "ply");
  while (lines.at(at) != "end_header") {
    std::sscanf(lines[at].c_str(), "element vertex %zu", &vertices);
    std::sscanf(lines[at].c_str(), "element face %zu", &triangles);
    ++at;
  }
  EXPECT_EQ(lines.size(), at + 1 + vertices + triangles);
  for (size_t v = 0; v < vertices; ++v) {
    const std::vector<double> x = numbers_of(lines.at(++at));
    EXPECT_EQ(x.size(), 8u);
    EXPECT_NEAR(x[3] * x[3] + x[4] * x[4] + x[5] * x[5], 1.0, 1e-4);
    mesh.places.push_back({x[0], x[1], x[2]});
  }
  for (size_t t = 0; t < triangles; ++t) {
    const std::vector<double> x = numbers_of(lines.at(++at));
    EXPECT_EQ(x.size(), 7u);
    EXPECT_EQ(x[0], 3);
    mesh.kinds.insert(static_cast<int>(x[4]));
    mesh.corners.push_back({static_cast<size_t>(x[1]), static_cast<size_t>(x[2]), static_cast<size_t>(x[3])});
  }
  return mesh;
}

Triangles read_obj(const std::string &text) {
  Triangles mesh;
  size_t normals = 0;
  for (const std::string &line : lines_of(text)) {
    const std::vector<double> x = numbers_of(line);
    if (line.rfind("v ", 0) == 0) mesh.places.push_back({x.at(0), x.at(1), x.at(2)});
    if (line.rfind("vn ", 0) == 0) ++normals;
    if (line.rfind("f ", 0) != 0) continue;
    EXPECT_EQ(x.size(), 6u);
    mesh.corners.push_back(
        {static_cast<size_t>(x[0]) - 1, static_cast<size_t>(x[2]) - 1, static_cast<size_t>(x[4]) - 1});
  }
  EXPECT_EQ(normals, mesh.places.size());
  return mesh;
}

// Its corners are places: equal ones are one vertex.
Triangles read_stl(const std::string &bytes) {
  Triangles mesh;
  std::map<std::array<float, 3>, size_t> known;
  uint32_t count = 0;
  EXPECT_GE(bytes.size(), 84u);
  std::memcpy(&count, bytes.data() + 80, 4);
  EXPECT_EQ(bytes.size(), 84u + 50u * count);
  for (size_t t = 0; t < count; ++t) {
    std::array<size_t, 3> corners{};
    for (size_t k = 0; k < 3; ++k) {
      std::array<float, 3> place{};
      std::memcpy(place.data(), bytes.data() + 84 + 50 * t + 12 * (k + 1), 12);
      const auto [at, fresh] = known.insert({place, mesh.places.size()});
      if (fresh) mesh.places.push_back({place[0], place[1], place[2]});
      corners[k] = at->second;
    }
    mesh.corners.push_back(corners);
  }
  return mesh;
}

Triangles read_msms(const std::string &vertices, const std::string &faces) {
  Triangles mesh;
  const std::vector<std::string> v = lines_of(vertices), f = lines_of(faces);
  for (size_t k = 3; k < v.size(); ++k) {
    const std::vector<double> x = numbers_of(v[k]);
    EXPECT_EQ(x.size(), 9u);
    EXPECT_GE(x[7], 1);
    EXPECT_EQ(x[8], 3);
    mesh.places.push_back({x[0], x[1], x[2]});
  }
  EXPECT_EQ(numbers_of(v.at(2)).at(0), static_cast<double>(mesh.places.size()));
  for (size_t k = 3; k < f.size(); ++k) {
    const std::vector<double> x = numbers_of(f[k]);
    EXPECT_EQ(x.size(), 5u);
    mesh.corners.push_back(
        {static_cast<size_t>(x[0]) - 1, static_cast<size_t>(x[1]) - 1, static_cast<size_t>(x[2]) - 1});
  }
  EXPECT_EQ(numbers_of(f.at(2)).at(0), static_cast<double>(mesh.corners.size()));
  return mesh;
}

TEST(Mesh, AllFormatsHoldTheSameClosedSurface) {
  const TemporaryFolder folder("mesh");
  std::map<std::string, Triangles> meshes;
  for (const std::string format : {"ply", "obj", "stl", "vert"}) {
    const std::string out = folder.path("out." + format);
    ASSERT_EQ(run_program({"mesh", molecule, "--edge", "0.3", "-o", out}).status, 0) << format;
    const std::string text = read_file(out);
    if (format == "ply") meshes[format] = read_ply(text);
    if (format == "obj") meshes[format] = read_obj(text);
    if (format == "stl") meshes[format] = read_stl(text);
    if (format == "vert") meshes[format] = read_msms(text, read_file(folder.path("out.face")));
    expect_closed(meshes[format], format);
  }
  EXPECT_EQ(meshes["ply"].kinds, (std::set<int>{0}));
  const double volume = run_json({"measure", molecule})["volume"].number;
  for (const auto &[format, mesh] : meshes) {
    EXPECT_EQ(mesh.corners.size(), meshes["ply"].corners.size()) << format;
    EXPECT_EQ(mesh.places.size(), meshes["ply"].places.size()) << format;
    EXPECT_NEAR(volume_of(mesh), volume, 0.05 * volume) << format;
    EXPECT_NEAR(volume_of(mesh), volume_of(meshes["ply"]), 1e-4 * volume) << format;
  }
}

TEST(Mesh, JsonSaysWhatIsInTheFile) {
  const TemporaryFile out("mesh.ply");
  const Json json = run_json({"mesh", molecule, "--probe", "1.4", "--triangles", "ply", "-o", out.path()});
  const std::string text = read_file(out.path());
  const Triangles mesh = read_ply(text);
  EXPECT_EQ(json["vertices"].number, static_cast<double>(mesh.places.size()));
  EXPECT_EQ(json["triangles"].number, static_cast<double>(mesh.corners.size()));
  EXPECT_EQ(json["bytes"].number, static_cast<double>(text.size()));
  EXPECT_EQ(json["edge"].number, 0.5);
  const double area = run_json({"measure", molecule, "--probe", "1.4"})["area"].number;
  EXPECT_NEAR(json["triangle_area"].number, area, 0.03 * area);
}

TEST(Mesh, ShorterEdgesComeCloserToTheSurface) {
  const double area = run_json({"measure", molecule})["area"].number;
  double last = 0;
  for (const char *edge : {"0.4", "0.2", "0.1"}) {
    const TemporaryFile out("mesh.ply");
    const Json json = run_json({"mesh", molecule, "--edge", edge, "--triangles", "ply", "-o", out.path()});
    const double error = area - json["triangle_area"].number;
    if (last > 0) {
      EXPECT_LT(error, last / 3);
    }
    EXPECT_GT(error, 0);
    last = error;
  }
}

// All three kinds of patches, and the volume that measure says.
TEST(Mesh, OfTheSmoothSurface) {
  const TemporaryFile out("mesh.ply");
  const Json json = run_json({"mesh", molecule, "--probe", "1.4", "--surface", "ses", "--edge", "0.3", "--triangles",
                              "ply", "-o", out.path()});
  const Triangles mesh = read_ply(read_file(out.path()));
  expect_closed(mesh, "smooth surface");
  EXPECT_EQ(mesh.kinds, (std::set<int>{0, 1, 2}));
  const Json exact = run_json({"measure", molecule, "--probe", "1.4", "--surface", "ses"});
  EXPECT_NEAR(json["triangle_area"].number, exact["area"].number, 0.02 * exact["area"].number);
  EXPECT_NEAR(volume_of(mesh), exact["volume"].number, 0.02 * exact["volume"].number);
  const Outcome without = run_program({"mesh", molecule, "--surface", "ses", "-o", "-"});
  EXPECT_EQ(without.status, 2);
  EXPECT_EQ(without.err, "hardsphere: --surface ses needs a probe, --probe 1.4\n");
}

TEST(Mesh, GoesToStandardOutputAlone) {
  const Outcome outcome = run_program({"mesh", molecule, "-o", "-"});
  EXPECT_EQ(outcome.status, 0);
  expect_closed(read_ply(outcome.out), "standard output");
}

// name.vert comes with name.face, which must not be what is read.
TEST(Mesh, NeverWritesOverTheInput) {
  const TemporaryFolder folder("mesh_input");
  const std::string input = folder.write("in.face", "0 0 0 1\n");
  const Outcome outcome = run_program({"mesh", input, "--format", "xyzr", "-o", folder.path("in.vert")});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "hardsphere: -o would write over the file that is read\n");
  EXPECT_EQ(read_file(input), "0 0 0 1\n");
}

}  // namespace
