// Prints a hash of every kind of result for some sets of balls: what capi/abi/numerics.txt keeps.
//   numerics_record
// A row begins with the tier of its header, stable or provisional.
// The records are hashed as the bytes that they are, so that the numbers are those of machines that are little-endian.
#include <hardsphere.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "molecule_file.hpp"
#include "owned_handle.hpp"
#include "random_numbers.hpp"
#if HSP_HAS_SMOOTH && HSP_HAS_SIGHT  // the core as one file has neither
#include "owned_surfaces.hpp"
#include "owned_views.hpp"
#endif

namespace {

using support::all_records;
using support::expect_ok;

// FNV-1a with 64 bits, by G. Fowler, L. C. Noll and K.-P. Vo.
class Hash {
 public:
  void add(const void *bytes, size_t count) {
    const auto *byte = static_cast<const unsigned char *>(bytes);
    for (size_t i = 0; i < count; ++i) value_ = (value_ ^ byte[i]) * UINT64_C(0x100000001B3);
  }
  uint64_t value() const { return value_; }

 private:
  uint64_t value_ = UINT64_C(0xCBF29CE484222325);
};

template <class Record>
void print(const std::string &set, const char *what, const std::vector<Record> &records) {
  Hash hash;
  hash.add(records.data(), records.size() * sizeof(Record));
  std::printf("%s %s %zu %016llx\n", set.c_str(), what, records.size(), static_cast<unsigned long long>(hash.value()));
}

template <class Record>
void print_one(const std::string &set, const char *what, const Record &record) {
  print(set, what, std::vector<Record>{record});
}

// The same without the spare bytes at its end, which are no results.
template <class Record>
void print_used(const std::string &set, const char *what, const Record &record) {
  Hash hash;
  hash.add(&record, offsetof(Record, reserved));
  std::printf("%s %s 1 %016llx\n", set.c_str(), what, static_cast<unsigned long long>(hash.value()));
}

void print_model(const std::string &set, const hsp_model *model, uint32_t n) {
  hsp_model_info info;
  expect_ok(hsp_model_get_info(model, &info), "hsp_model_get_info");
  print_one(set, "model", info);
  std::vector<uint32_t> neighbours;
  for (uint32_t ball = 0; ball < n; ++ball) {
    const auto ids = all_records<uint32_t>(
        [&](uint32_t *out, uint32_t capacity, uint32_t *needed) {
          return hsp_query_neighbours(model, ball, out, capacity, needed);
        },
        "hsp_query_neighbours");
    neighbours.insert(neighbours.end(), ids.begin(), ids.end());
  }
  print(set, "neighbours", neighbours);
}

template <class Record, class Handle>
void print_all(const std::string &set, const char *what, Handle *handle,
               int32_t (*getter)(Handle *, Record *, uint32_t, uint32_t *)) {
  print(set, what,
        all_records<Record>(
            [&](Record *out, uint32_t capacity, uint32_t *needed) { return getter(handle, out, capacity, needed); },
            what));
}

// Shells as they are hashed: with Euler characteristics of 32 bits, and nothing that is spare.
struct ShellNumbers {
  double area, volume, point[3];
  int32_t euler;
  uint32_t genus, kind, component, region, faces, simple_faces, edges, vertices, start_face;
};

void print_shells(const std::string &set, const hsp_topology *topology) {
  const auto shells =
      all_records<hsp_shell>([&](hsp_shell *out, uint32_t capacity,
                                 uint32_t *needed) { return hsp_topology_get_shells(topology, out, capacity, needed); },
                             "hsp_topology_get_shells");
  std::vector<ShellNumbers> numbers;
  for (const hsp_shell &s : shells) {
    numbers.push_back({s.area,
                       s.volume,
                       {s.point[0], s.point[1], s.point[2]},
                       static_cast<int32_t>(s.euler),
                       s.genus,
                       s.kind,
                       s.component,
                       s.region,
                       s.faces,
                       s.simple_faces,
                       s.edges,
                       s.vertices,
                       s.start_face});
  }
  print(set, "shells", numbers);
}

void print_measures(const std::string &set, const hsp_boundary *boundary, uint32_t n) {
  hsp_totals totals;
  std::vector<double> area(n), volume(n);
  expect_ok(hsp_boundary_measure(boundary, nullptr, &totals, area.data(), volume.data(), n, nullptr),
            "hsp_boundary_measure");
  print_used(set, "totals", totals);
  print(set, "areas", area);
  print(set, "volumes", volume);

  hsp_boundary_counts counts;
  expect_ok(hsp_boundary_get_counts(boundary, &counts), "hsp_boundary_get_counts");
  std::vector<double> face_area(counts.faces), face_volume(counts.faces);
  expect_ok(hsp_boundary_measure_faces(boundary, face_area.data(), face_volume.data(), counts.faces, nullptr),
            "hsp_boundary_measure_faces");
  print(set, "face_areas", face_area);
  print(set, "face_volumes", face_volume);

  hsp_gradient_request request{};
  request.struct_size = sizeof request;
  request.tangency = HSP_TANGENT_OVERLAP;
  request.tension = 0.75;
  request.pressure = 0.25;
  hsp_energy energy;
  std::vector<double> centre(3 * size_t{n}), radius(n);
  hsp_gradient_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = n;
  outputs.energy = &energy;
  outputs.d_centre = centre.data();
  outputs.d_radius = radius.data();
  expect_ok(hsp_boundary_get_gradient(boundary, &request, &outputs), "hsp_boundary_get_gradient");
  print_used(set, "energy", energy);
  print(set, "gradient_centres", centre);
  print(set, "gradient_radii", radius);

  std::vector<hsp_area_derivative> rows;
  for (uint32_t ball = 0; ball < n; ++ball) {
    const auto row = all_records<hsp_area_derivative>(
        [&](hsp_area_derivative *out, uint32_t capacity, uint32_t *needed) {
          return hsp_boundary_get_area_row(boundary, ball, HSP_TANGENT_OVERLAP, out, capacity, needed);
        },
        "hsp_boundary_get_area_row");
    rows.insert(rows.end(), row.begin(), row.end());
  }
  print(set, "area_rows", rows);
}

#if HSP_HAS_SMOOTH && HSP_HAS_SIGHT
int32_t take_bytes(void *hash, const char *bytes, size_t count) {
  static_cast<Hash *>(hash)->add(bytes, count);
  return 0;
}

void print_views(const std::string &set, const hsp_model *model, const hsp_boundary *boundary, uint32_t n) {
  for (const uint32_t pieces : {HSP_PIECES_OUTSIDE_FARTHER, HSP_PIECES_OUTSIDE_ALL}) {
    const std::string kind = set + (pieces == HSP_PIECES_OUTSIDE_ALL ? " h" : " g");
    hsp_view_options options;
    expect_ok(hsp_view_options_init(&options, sizeof options), "hsp_view_options_init");
    expect_ok(hsp_view_options_turn(&options, 30.0, -20.0, 10.5), "hsp_view_options_turn");
    options.pieces = pieces;
    support::OwnedView view;
    view.take(support::default_view_limits(n));
    view.compute([&](hsp_view *handle, hsp_view_limits *limits) {
      return hsp_view_compute(handle, model, boundary, &options, limits);
    });
    hsp_view_info info;
    expect_ok(hsp_view_get_info(view.get(), &info), "hsp_view_get_info");
    print_one(kind, "view", info);
    print_all(kind, "view_pieces", static_cast<const hsp_view *>(view.get()), hsp_view_get_pieces);
    print_all(kind, "view_arcs", static_cast<const hsp_view *>(view.get()), hsp_view_get_arcs);
    for (const uint32_t format : {HSP_FORMAT_SVG, HSP_FORMAT_EPS, HSP_FORMAT_PDF}) {
      hsp_picture_options look;
      expect_ok(hsp_picture_options_init(&look, sizeof look), "hsp_picture_options_init");
      look.format = format;
      look.style = HSP_STYLE_SOFT;
      Hash hash;
      uint64_t bytes = 0;
      expect_ok(hsp_picture_write(view.get(), nullptr, &look, nullptr, nullptr, take_bytes, &hash, &bytes),
                "hsp_picture_write");
      std::printf("%s picture_%u %llu %016llx\n", kind.c_str(), format, static_cast<unsigned long long>(bytes),
                  static_cast<unsigned long long>(hash.value()));
    }
  }
}

// Records that are copied by their places.
template <class Record, class Handle>
void print_range(const std::string &set, const char *what, const Handle *handle, uint32_t count,
                 int32_t (*getter)(const Handle *, uint32_t, uint32_t, Record *)) {
  std::vector<Record> records(count);
  expect_ok(getter(handle, 0, count, records.data()), what);
  print(set, what, records);
}

void print_maps(const std::string &set, const hsp_model *model, uint32_t n) {
  hsp_view_options options;
  expect_ok(hsp_view_options_init(&options, sizeof options), "hsp_view_options_init");
  expect_ok(hsp_view_options_turn(&options, 30.0, -20.0, 10.5), "hsp_view_options_turn");
  support::OwnedMap map;
  map.take(support::default_map_limits(n));
  map.compute(
      [&](hsp_map *handle, hsp_map_limits *limits) { return hsp_map_compute(handle, model, &options, limits); });
  hsp_map_info info;
  expect_ok(hsp_map_get_info(map.get(), &info), "hsp_map_get_info");
  print_one(set, "map", info);
  print_range(set, "map_vertices", map.get(), info.vertices, hsp_map_get_vertices);
  print_range(set, "map_edges", map.get(), info.edges, hsp_map_get_edges);
  print_range(set, "map_faces", map.get(), info.faces, hsp_map_get_faces);
  std::vector<hsp_map_point> points(info.edges);
  for (uint32_t e = 0; e < info.edges; ++e) {
    hsp_map_edge edge;
    expect_ok(hsp_map_get_edges(map.get(), e, 1, &edge), "hsp_map_get_edges");
    expect_ok(hsp_map_get_point(map.get(), e, 0.5 * (edge.from + edge.to), &points[e]), "hsp_map_get_point");
  }
  print(set, "map_points", points);
  std::vector<hsp_map_pole> poles(info.faces - 1);
  for (uint32_t f = 1; f < info.faces; ++f) {
    expect_ok(hsp_map_get_pole(map.get(), f, &poles[f - 1]), "hsp_map_get_pole");
  }
  print(set, "map_poles", poles);
}

// Balls of a quarter of their radii, with sticks between neighbours in the file that are close but do not meet then.
void print_sticks(const std::string &set, const support::BallList &balls) {
  support::BallList small = balls;
  std::vector<hsp_stick> stick;
  const auto n = static_cast<uint32_t>(balls.size());
  for (double &radius : small.radius) radius *= 0.25;
  for (uint32_t i = 0; i + 1 < n; ++i) {
    const double *one = &balls.xyz[3 * size_t{i}];
    const double squared = (one[3] - one[0]) * (one[3] - one[0]) + (one[4] - one[1]) * (one[4] - one[1]) +
                           (one[5] - one[2]) * (one[5] - one[2]);
    if (squared > 1.0 && squared < 2.5) stick.push_back({{i, i + 1}, i % 5 == 0 ? HSP_STICK_WHOLE : 0, 0});
  }
  support::OwnedModel model(n);
  expect_ok(model.set(small, nullptr), "hsp_model_set");
  hsp_sticks_limits limits;
  expect_ok(hsp_sticks_limits_init(&limits, sizeof limits, n), "hsp_sticks_limits_init");
  support::OwnedHandle<support::SticksKind> sticks;
  sticks.take(limits);
  sticks.compute([&](hsp_sticks *handle, hsp_sticks_limits *more) {
    return hsp_sticks_compute_map(handle, model.get(), nullptr, stick.data(), static_cast<uint32_t>(stick.size()), 0.1,
                                  nullptr, more);
  });
  hsp_sticks_info info;
  expect_ok(hsp_sticks_get_info(sticks.get(), &info), "hsp_sticks_get_info");
  print_one(set, "sticks", info);
  hsp_map_info map;
  expect_ok(hsp_sticks_get_map_info(sticks.get(), &map), "hsp_sticks_get_map_info");
  print_one(set, "sticks_map", map);
  print_range(set, "sticks_vertices", sticks.get(), map.vertices, hsp_sticks_get_vertices);
  print_range(set, "sticks_edges", sticks.get(), map.edges, hsp_sticks_get_edges);
  print_range(set, "sticks_faces", sticks.get(), map.faces, hsp_sticks_get_faces);
}

void print_surface(const std::string &set, const hsp_boundary *boundary, uint32_t n) {
  support::OwnedSurface surface;
  surface.take(support::surface_limits_for(boundary));
  surface.compute(
      [&](hsp_surface *handle, hsp_surface_limits *limits) { return hsp_surface_compute(handle, boundary, limits); });
  hsp_surface_totals surface_totals;
  std::vector<hsp_surface_totals> shares(n);
  expect_ok(hsp_surface_measure(surface.get(), &surface_totals, shares.data(), n, nullptr), "hsp_surface_measure");
  print_one(set, "surface", surface_totals);
  print(set, "surface_shares", shares);
  hsp_gradient_request request{};
  request.struct_size = sizeof request;
  request.tangency = HSP_TANGENT_OVERLAP;
  request.tension = 0.75;
  request.pressure = 0.25;
  hsp_energy energy;
  std::vector<double> centre(3 * size_t{n}), radius(n);
  hsp_gradient_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = n;
  outputs.energy = &energy;
  outputs.d_centre = centre.data();
  outputs.d_radius = radius.data();
  expect_ok(hsp_surface_get_gradient(surface.get(), &request, &outputs), "hsp_surface_get_gradient");
  print_used(set, "surface_energy", energy);
  print(set, "surface_gradient_centres", centre);
  print(set, "surface_gradient_radii", radius);
}

#else
void print_surface(const std::string &, const hsp_boundary *, uint32_t) {}
void print_views(const std::string &, const hsp_model *, const hsp_boundary *, uint32_t) {}
void print_maps(const std::string &, const hsp_model *, uint32_t) {}
void print_sticks(const std::string &, const support::BallList &) {}
#endif

void print_set(const std::string &name, const support::BallList &balls, double probe) {
  const std::string set = "stable " + name + (probe > 0.0 ? " probe" : " bare");
  const std::string provisional_set = "provisional " + name + (probe > 0.0 ? " probe" : " bare");
  const auto n = static_cast<uint32_t>(balls.size());
  hsp_model_options options;
  expect_ok(hsp_model_options_init(&options, sizeof options), "hsp_model_options_init");
  options.probe = probe;
  support::OwnedModel model(n);
  expect_ok(model.set(balls, &options), "hsp_model_set");
  print_model(set, model.get(), n);

  support::OwnedBoundary owner;
  owner.take(support::default_boundary_limits(n));
  owner.compute([&](hsp_boundary *handle, hsp_boundary_limits *limits) {
    return hsp_boundary_compute(handle, model.get(), limits);
  });
  const hsp_boundary *boundary = owner.get();
  hsp_boundary_counts counts;
  expect_ok(hsp_boundary_get_counts(boundary, &counts), "hsp_boundary_get_counts");
  print_used(set, "counts", counts);
  print_all(set, "vertices", boundary, hsp_boundary_get_vertices);
  print_all(set, "arcs", boundary, hsp_boundary_get_arcs);
  print_all(set, "circles", boundary, hsp_boundary_get_circles);
  print_all(set, "faces", boundary, hsp_boundary_get_faces);
  print_all(set, "loop_arcs", boundary, hsp_boundary_get_loop_arcs);
  print_all(set, "balls", boundary, hsp_boundary_get_balls);
  print_measures(set, boundary, n);

  print_surface(provisional_set, boundary, n);

  support::OwnedTopology topology;
  topology.take(support::topology_limits_for(boundary));
  topology.compute([&](hsp_topology *handle, hsp_topology_limits *limits) {
    return hsp_topology_compute(handle, boundary, limits);
  });
  print_shells(set, topology.get());
  print_all(set, "cells", static_cast<const hsp_topology *>(topology.get()), hsp_topology_get_regions);
  print_views(provisional_set, model.get(), boundary, n);
  print_maps(provisional_set, model.get(), n);
}

// Balls on whole coordinates, so that many spheres go through one point and many touch: the perturbation decides.
support::BallList lattice_balls() {
  support::BallList balls;
  support::Random random(1);
  for (int i = 0; i < 120; ++i) {
    const double x = random.below(7);
    const double y = random.below(7);
    const double z = random.below(7);
    balls.add(x, y, z, 1.0 + random.below(3) / 2.0);
  }
  return balls;
}

}  // namespace

int main() {
  try {
    for (const double probe : {0.0, 1.4}) {
      for (const char *molecule : {"caffeine.pdb", "crambin.pdb", "sod_stand_in.pdb"}) {
        const auto atoms = support::read_atoms(support::own_molecule(molecule));
        const std::string name = std::string(molecule).substr(0, std::string(molecule).find('.'));
        const support::BallList balls = support::with_radii(atoms, support::Radii::metals_as_sulfur);
        print_set(name, balls, probe);
        if (probe == 0.0) print_sticks("provisional " + name, balls);
      }
      print_set("lattice", lattice_balls(), probe > 0.0 ? 0.5 : 0.0);
    }
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
