// Finds the faces of one ball from its loops.
//
// As an example a ball with loops 4, 5 and 6, of which 4 and 6 bound one free part, as the two loops of a band around
// the ball do:
//   numbered in the order of first loops     face 0: loops 4 and 6      face 1: loop 5
//   loops sorted by face                     4 6 5, with new numbers 4 5 6: the loops of a face are consecutive
#include "boundary/faces.hpp"

#include "boundary/point_location.hpp"
#include "core/small_code.hpp"
#include "sphere/lane_search.hpp"

namespace hsp {
namespace {

// With few caps, as on van der Waals surfaces, most balls have several loops and counting the clusters at once is
// cheaper than gathering the caps again; with many caps few balls have several loops.
constexpr uint32_t most_counted_caps = 16;

// Numbers the faces of one ball, the sets of its loops, in the order of their first loops. The numbers begin at
// face_count, which becomes the number after the last one. Returns whether the loops of every face are consecutive.
bool number_faces(DisjointSets &sets, uint32_t ball, IdRange loops, uint32_t &face_count, BoundaryArrays &arrays) {
  bool consecutive = true;
  for (const uint32_t loop : loops) {
    const uint32_t representative = sets.find(loop - loops.first);
    if (representative == loop - loops.first) {
      arrays.loop_face[loop] = face_count;
      arrays.faces[face_count++] = {ball, loop, no_id};
    } else {
      arrays.loop_face[loop] = arrays.loop_face[loops.first + representative];
      consecutive = consecutive && arrays.loop_face[loop] == face_count - 1;
    }
  }
  return consecutive;
}

// Renumbers the loops of one ball so that those of a face are consecutive and otherwise keep their order.
// number [loops] is scratch memory.
void sort_loops_by_face(const Boundary &boundary, uint32_t ball, IdRange loops, IdRange faces, Span<uint32_t> number,
                        BoundaryArrays &arrays) {
  for (const uint32_t f : faces) arrays.faces[f].first_loop = 0;
  for (const uint32_t loop : loops) ++arrays.faces[arrays.loop_face[loop]].first_loop;
  uint32_t next = loops.first;
  for (const uint32_t f : faces) {
    const uint32_t count = arrays.faces[f].first_loop;
    arrays.faces[f].first_loop = next;
    next += count;
  }
  for (const uint32_t loop : loops) number[loop - loops.first] = arrays.faces[arrays.loop_face[loop]].first_loop++;
  // Here the first_loop of every face is the first loop of the next face.
  next = loops.first;
  for (const uint32_t f : faces) {
    const uint32_t last = arrays.faces[f].first_loop;
    arrays.faces[f].first_loop = next;
    for (; next < last; ++next) arrays.loop_face[next] = f;
  }
  const IdRange half_edges = boundary.half_edges(ball);
  for (uint32_t e = half_edges.last; e-- > half_edges.first;) {
    uint32_t &loop = arrays.half_edges[e].loop;
    loop = number[loop - loops.first];
    arrays.loop_start[loop] = LoopElement::arc(e);  // at last the half-edge with the smallest number
  }
  for (const ClosedHalfEdge e : boundary.circles(ball)) {
    uint32_t &loop = arrays.circles[e.circle()].loop[e.side()];
    loop = number[loop - loops.first];
    arrays.loop_start[loop] = LoopElement::circle(e);
  }
}

// Writes the balls whose circles bound the free part of a ball, each once. Returns how many.
uint32_t balls_of_loops(const Boundary &boundary, uint32_t ball, Span<uint32_t> others) {
  uint32_t count = 0;
  // Half-edges of one circle follow each other.
  for (const uint32_t e : boundary.half_edges(ball)) {
    const uint32_t other = boundary.half_edge(e).circle;
    if (count == 0 || others[count - 1] != other) others[count++] = other;
  }
  for (const ClosedHalfEdge e : boundary.circles(ball)) others[count++] = boundary.neighbour(e);
  return count;
}

// A step for visiting all numbers below `count`, modulo `count`, such that any few consecutive ones are spread over
// all: it has no common factor with `count` and is near the golden section of it.
uint32_t spreading_step(uint32_t count) {
  for (uint32_t step = static_cast<uint32_t>(UINT64_C(0x9E3779B9) * count >> 32);; ++step) {
    uint32_t factor = step, rest = count;
    while (rest != 0) {
      const uint32_t next = factor % rest;
      factor = rest;
      rest = next;
    }
    if (factor == 1) return step;
  }
}

}  // namespace

void FaceFinder::carve(Workspace &workspace, uint32_t neighbours) {
  clusters_.carve(workspace, neighbours);
  intervals_.carve(workspace, neighbours);
}

uint32_t FaceFinder::count_clusters(const Caps &caps, uint32_t known) {
  return known == not_counted && caps.count <= most_counted_caps ? clusters_.find(caps) : known;
}
static_assert((most_counted_caps + 1) * BoundaryArrays::one_cluster <= 256);

// If a sphere has a free point, its free faces and its clusters are the nodes of a tree whose edges are the loops, as
// disjoint closed curves divide the sphere. Hence #faces = #loops - #clusters + 1.
void FaceFinder::join_loops(const BallSet &balls, BlockSweep &sweep, const Boundary &boundary, uint32_t ball,
                            uint32_t first_loop, uint32_t counted_clusters, Caps &caps, const VertexFinder &finder,
                            DisjointSets &loops) {
  uint32_t clusters = counted_clusters;
  const auto gather_again = [&]() {
    caps.gather(balls, sweep.block_around_ball(ball), ball, nullptr);
    finder.keep_exposed(caps);
    clusters = find_clusters(caps);
  };
  if (clusters == not_counted && !small_code) {
    // Every cluster has a loop around it, so that each cluster has caps whose circles are in loops. If these caps are
    // one cluster, there is no other.
    const uint32_t n = balls_of_loops(boundary, ball, caps.ball);
    if (caps.lanes) clusters = LaneSearch::count_few_clusters(boundary.target(), balls, ball, caps.ball.data(), n);
    if (clusters == not_counted) {
      caps.gather_given(balls, ball, n);
      clusters = find_clusters(caps);
    }
    if (clusters > 1) gather_again();
  }
  if (clusters == not_counted) gather_again();
  if (loops.size() == clusters) {  // one face
    for (uint32_t loop = 1; loop < loops.size(); ++loop) loops.join(0, loop);
  } else if (clusters > 1) {
    if (counted_clusters != not_counted) gather_again();
    join_loops_by_meridians(caps, boundary, first_loop, clusters - 1, loops);
  }
}

uint32_t FaceFinder::find(const BallSet &balls, BlockSweep &sweep, const Boundary &boundary, BallRange range,
                          IdRange loops, uint32_t first, Caps &caps, const VertexFinder &finder, Span<uint32_t> scratch,
                          Patience &patience, BoundaryArrays &arrays) {
  uint32_t faces = first;
  const Span<FirstParts> parts = arrays.first;
  const Span<const uint8_t> state = arrays.ball_state;
  for (uint32_t i = range.first;; ++i) {
    for (; i < range.last && state[i] == BoundaryArrays::left_out; ++i) parts[i].face = faces;
    if (i == range.last) return faces;
    const uint32_t first_face = parts[i].face = faces;
    const IdRange own{arrays.first[i].loop, i + 1 < range.last ? arrays.first[i + 1].loop : loops.last};
    if (own.empty()) {
      if (arrays.ball_state[i] == BoundaryArrays::without_caps) arrays.faces[faces++] = {i, own.first, no_id};
      continue;
    }
    if (!patience.allows(own.size() > 1 ? 2000 + 500 * uint64_t{caps.met} : 500)) return faces;
    // Smaller numbers stay representatives.
    DisjointSets sets(scratch.part(0, own.size()));
    sets.reset();
    if (own.size() > 1) {
      join_loops(balls, sweep, boundary, i, own.first, arrays.ball_state[i] / BoundaryArrays::one_cluster, caps, finder,
                 sets);
    }
    if (!number_faces(sets, i, own, faces, arrays)) {
      sort_loops_by_face(boundary, i, own, {first_face, faces}, scratch, arrays);
    }
  }
}

// The general case: several clusters of caps and several faces on one sphere. For one cap of every cluster take the
// great circle through the cap's axis and the poles. Both ends of each of its free intervals lie on loops of one face:
// these loops are joined. The loops of all free intervals that contain the upper pole are joined as well.
//
// This joins all loops l_1 .. l_r of a face f: the sphere without f is r discs. The meridian from a cluster in disc a
// to the pole leaves the disc through l_a. It leaves each further disc that it enters through that disc's loop. So the
// chain of joins links l_a to the loop of the pole's disc, or to the pole if that is free. One join less than there are
// clusters leaves as many sets as there are faces: then no further meridian is looked at. If there are many clusters,
// those come first whose loop is not yet in one set with a loop of the first meridian.
void FaceFinder::join_loops_by_meridians(Caps &caps, const Boundary &boundary, uint32_t first_loop, uint32_t joins,
                                         DisjointSets &loops) {
  const exact::Predicates predicates = caps.predicates();
  intervals_.start(caps, joins);
  if (!small_code) find_first_elements(caps, boundary, intervals_.of_caps());
  uint32_t pole_loop = no_id;
  const auto join = [&](uint32_t p, uint32_t q) { joins -= static_cast<uint32_t>(loops.join(p, q)); };
  // In grid order the caps of one side come first, whose meridians are all much the same. So they are visited in steps.
  const bool many = !small_code && !intervals_.of_caps().empty();
  const uint32_t step = many ? spreading_step(caps.count) : 1;
  uint32_t hub = no_id;
  const auto is_joined = [&](uint32_t cap) {
    const Span<const uint32_t> elements = intervals_.of_caps();
    return hub != no_id && elements[cap] != no_id &&
           loops.find(boundary.loop_of(LoopElement::from_code(elements[cap])) - first_loop) == loops.find(hub);
  };
  uint32_t representative = 0;
  for (uint32_t left = many ? 2 * caps.count : caps.count; left > 0 && joins > 0;
       --left, representative += small_code || representative < caps.count - step ? step : step - caps.count) {
    if (!clusters_.is_representative(representative)) continue;
    if (!small_code && left > caps.count && is_joined(representative)) continue;
    const exact::Plane meridian = meridian_through(caps.direction(representative));
    intervals_.find(caps, predicates, meridian);
    const Span<const uint32_t> elements = intervals_.of_caps();
    intervals_.visit([&](const FreeInterval &interval) {
      const auto loop_at = [&](uint32_t cap, int sign) {
        return boundary.loop_of(locate_on_boundary(caps, predicates, boundary, cap, meridian, sign, elements)) -
               first_loop;
      };
      const uint32_t exit_loop = loop_at(interval.exit_cap, +1);
      const uint32_t entry_loop = loop_at(interval.entry_cap, -1);
      if (hub == no_id) hub = exit_loop;
      join(exit_loop, entry_loop);
      if (contains_pole(caps, predicates, meridian, interval, +1)) {
        if (pole_loop == no_id) pole_loop = exit_loop;
        join(pole_loop, exit_loop);
      }
    });
  }
}

}  // namespace hsp
