// Visibility maps of any set: every promise of the header about records and steps, and the owners seen at points
// against all balls, by the invariants of tests/api/support; the same bytes twice; no effect of the order of the balls;
// short arrays and limits that are too small; pictures. HSP_E_DEGENERATE is allowed where roundings cannot be overcome.
#include <map_invariants.h>

#include <cmath>
#include <vector>

#include "computed_set.hpp"
#include "guarded_output.hpp"
#include "owned_views.hpp"
#include "picture_calls.hpp"
#include "required_limits.hpp"
#include "topology_input.hpp"
#include "view_input.hpp"

namespace {

using fuzz::same;

class Result {
 public:
  Result(const fuzz::ScaledBalls &set, const hsp_view_options &options) : set_(set) {
    status_ = map_result_make(&set_.get(), &options, &map_);
    FUZZ_REQUIRE(status_ == HSP_OK || status_ == HSP_E_DEGENERATE, hsp_status_text(status_));
  }
  ~Result() { map_result_release(&map_); }
  Result(const Result &) = delete;
  Result &operator=(const Result &) = delete;

  int32_t status() const { return status_; }
  const map_result &get() const { return map_; }

 private:
  fuzz::ComputedSet set_;
  map_result map_{};
  int32_t status_;
};

void require_sound(const map_result &m, fuzz::Bytes &bytes) {
  const char *broken = broken_map(&m);
  FUZZ_REQUIRE(broken == nullptr, broken);
  broken = broken_map_regions(&m, 4, bytes.below(65536));
  FUZZ_REQUIRE(broken == nullptr, broken);
}

void require_same_bytes(const map_result &a, const map_result &b) {
  FUZZ_REQUIRE(std::memcmp(&a.info, &b.info, sizeof a.info) == 0, "info differs the second time");
  FUZZ_REQUIRE(same(a.vertices, b.vertices, a.info.vertices), "vertices differ the second time");
  FUZZ_REQUIRE(same(a.edges, b.edges, a.info.edges), "edges differ the second time");
  FUZZ_REQUIRE(same(a.faces, b.faces, a.info.faces), "faces differ the second time");
}

// Records of a range that may go beyond what is there.
template <class Record, class Get>
void require_short_range(const hsp_map *map, uint32_t number, const Get &get, fuzz::Bytes &bytes) {
  const uint32_t first = bytes.below(number + 3), count = bytes.below(8);
  fuzz::Output<Record> out(count, false);
  const bool there = first <= number && count <= number - first;
  FUZZ_REQUIRE(get(map, first, count, out.data()) == (there ? HSP_OK : HSP_E_ID), "status of a range");
  FUZZ_REQUIRE(out.untouched_from(there ? count : 0), "written where nothing belongs");
}

// Arrays that are too short, and ranges that are not there.
void require_short_arrays(const map_result &m, fuzz::Bytes &bytes) {
  const uint32_t n = m.base->n, capacity = bytes.below(n + 2);
  fuzz::Output<double> area(capacity, false);
  uint32_t needed = 12345;
  const int32_t status = hsp_map_get_areas(m.map, area.data(), capacity, &needed);
  FUZZ_REQUIRE(status == (capacity < n ? HSP_E_CAPACITY : HSP_OK) && needed == n, "status of areas");
  FUZZ_REQUIRE(area.untouched_from(status == HSP_OK ? n : 0), "written where nothing belongs");
  require_short_range<hsp_map_vertex>(m.map, m.info.vertices, hsp_map_get_vertices, bytes);
  require_short_range<hsp_map_edge>(m.map, m.info.edges, hsp_map_get_edges, bytes);
  require_short_range<hsp_map_face>(m.map, m.info.faces, hsp_map_get_faces, bytes);
  if (n > 0) {
    const uint32_t ball = bytes.below(n), room = bytes.below(4);
    fuzz::Output<uint32_t> outline(room, false);
    const int32_t found = hsp_map_get_outline(m.map, ball, outline.data(), room, &needed);
    FUZZ_REQUIRE(found == (room < needed ? HSP_E_CAPACITY : HSP_OK), "status of an outline");
  }
}

// Asks for steps from any number, and for points anywhere.
void require_answers(const map_result &m, fuzz::Bytes &bytes) {
  const uint32_t h = bytes.one_in(8) ? HSP_NONE - bytes.below(3) : bytes.below(2 * m.info.edges + 3);
  const bool there = h < 2 * m.info.edges;
  FUZZ_REQUIRE((hsp_map_next(m.map, h) < 2 * m.info.edges) == there, "next of any number");
  FUZZ_REQUIRE((hsp_map_previous(m.map, h) < 2 * m.info.edges) == there, "previous of any number");
  FUZZ_REQUIRE((hsp_map_next_loop(m.map, h) < 2 * m.info.edges) == there, "next loop of any number");
  FUZZ_REQUIRE((hsp_map_origin(m.map, h) < m.info.vertices) == there, "origin of any number");
  FUZZ_REQUIRE((hsp_map_left(m.map, h) < m.info.faces) == there, "left of any number");
  const double size =
      std::ldexp(bytes.below(512) - 255.5, static_cast<int>(bytes.below(1024)) - (bytes.one_in(2) ? 8 : 512));
  hsp_map_point point{};
  const int32_t status = hsp_map_get_point(m.map, h / 2, size, &point);
  FUZZ_REQUIRE(there ? status == HSP_OK || status == HSP_E_RANGE : status == HSP_E_ID, "a point of any edge");
  hsp_map_sight sight{};
  FUZZ_REQUIRE(hsp_map_pick(m.map, size, -size / 3, &sight) == HSP_OK, "a sight anywhere");
  FUZZ_REQUIRE(sight.face == HSP_NONE || m.faces[sight.face].ball == sight.ball, "the face of a sight");
}

// The pole of any face, which is the middle of a circle inside it: the ball and the face there must be those of the
// face.
void require_pole(const map_result &m, fuzz::Bytes &bytes) {
  const uint32_t face = bytes.below(m.info.faces + 2);
  hsp_map_pole pole{};
  const int32_t status = hsp_map_get_pole(m.map, face, &pole);
  FUZZ_REQUIRE(status == (face == 0 || face >= m.info.faces ? HSP_E_ID : HSP_OK), "the status of a pole");
  if (status != HSP_OK) return;
  FUZZ_REQUIRE(std::isfinite(pole.centre[0]) && std::isfinite(pole.centre[1]), "a pole that is nowhere");
  FUZZ_REQUIRE(pole.radius >= 0 && pole.bound >= pole.radius && std::isfinite(pole.bound), "the radius of a pole");
  FUZZ_REQUIRE(3.1415 * pole.radius * pole.radius <= m.faces[face].area * (1 + 1e-6), "a circle larger than its face");
  hsp_map_sight sight{};
  FUZZ_REQUIRE(hsp_map_pick(m.map, pole.centre[0], pole.centre[1], &sight) == HSP_OK, "what is seen at a pole");
  double largest = 0;
  for (uint32_t i = 0; i < m.base->n; ++i) largest = std::fmax(largest, m.base->radius[i]);
  // Where faces are wide enough there is no doubt.
  if (pole.radius > 1e-4 * largest) FUZZ_REQUIRE(sight.face == face, "a pole in another face");
}

// Results that have been read can be read again, also after a check, which uses scratch memory.
void require_unchanged(const map_result &m) {
  uint32_t invariant = 0, id = 0;
  FUZZ_REQUIRE(hsp_map_check(m.map, &invariant, &id) == HSP_OK, "hsp_map_check a second time");
  map_result again = m;
  std::vector<hsp_map_vertex> vertices(m.info.vertices + 1);
  std::vector<hsp_map_edge> edges(m.info.edges + 1);
  std::vector<hsp_map_face> faces(m.info.faces + 1);
  FUZZ_REQUIRE(hsp_map_get_info(m.map, &again.info) == HSP_OK, "info again");
  FUZZ_REQUIRE(hsp_map_get_vertices(m.map, 0, m.info.vertices, vertices.data()) == HSP_OK, "vertices again");
  FUZZ_REQUIRE(hsp_map_get_edges(m.map, 0, m.info.edges, edges.data()) == HSP_OK, "edges again");
  FUZZ_REQUIRE(hsp_map_get_faces(m.map, 0, m.info.faces, faces.data()) == HSP_OK, "faces again");
  again.vertices = vertices.data();
  again.edges = edges.data();
  again.faces = faces.data();
  require_same_bytes(m, again);
}

void require_capacities(const map_result &reference, fuzz::Bytes &bytes) {
  const auto compute = [&](hsp_map *map, hsp_map_limits *limits) {
    return hsp_map_compute(map, reference.base->model, &reference.options, limits);
  };
  const auto read = [&](const hsp_map *map) {
    hsp_map_info info{};
    const int32_t status = hsp_map_get_info(map, &info);
    if (status == HSP_OK)
      FUZZ_REQUIRE(std::memcmp(&info, &reference.info, sizeof info) == 0, "info differs with more room");
    return status;
  };
  hsp_map_limits limits;
  FUZZ_REQUIRE(hsp_map_limits_init(&limits, sizeof limits, reference.base->n) == HSP_OK, "hsp_map_limits_init");
  fuzz::require_limits<support::MapKind>(reference.needed, bytes, compute, read);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const hsp_view_options options = fuzz::view_options(bytes);
  const fuzz::ScaledBalls set = fuzz::topology_set(bytes);
  const Result reference(set, options);
  if (reference.status() != HSP_OK) return 0;
  require_sound(reference.get(), bytes);
  const Result again(set, options);
  FUZZ_REQUIRE(again.status() == HSP_OK, "another status the second time");
  require_same_bytes(reference.get(), again.get());
  // hsp_map_compute, property 1
  const Result other(fuzz::permuted(set, fuzz::shuffled(set.n(), bytes)), options);
  FUZZ_REQUIRE(other.status() == HSP_OK, "the status depends on the order of the balls");
  const char *what = map_difference_after_permutation(&reference.get(), &other.get());
  FUZZ_REQUIRE(what == nullptr, what);
  require_short_arrays(reference.get(), bytes);
  require_answers(reference.get(), bytes);
  const auto writes = [](const map_result &m) {
    // Some with ink, which is the map's own.
    return [&m](const uint32_t *colour, const hsp_picture_options *asked, auto... arguments) {
      hsp_picture_options chosen = *asked;
      if (asked->width == 1000) chosen.ink = m.map;
      return hsp_picture_write_map(m.map, colour, &chosen, arguments...);
    };
  };
  require_unchanged(reference.get());
  require_capacities(reference.get(), bytes);
  fuzz::require_pictures(*reference.get().base, writes(reference.get()), *other.get().base, writes(other.get()), bytes);
  require_unchanged(reference.get());
  require_pole(reference.get(), bytes);
  return 0;
}
