#include "bricks/brick_seams.hpp"

#include "core/disjoint_sets.hpp"
#include "core/sorting.hpp"
#include "model/queries.hpp"

namespace hsp {
namespace {

// Finds the curves: chains of arcs between an owned ball and one of another brick, each as the half-edge on the owned
// one.
class SeamCurves {
 public:
  SeamCurves(const BrickModel &model, Patience &patience, Span<uint32_t> passed, Span<const uint32_t> piece,
             SeamList<ShellSeam> &seams)
      : model_(model), boundary_(model.boundary), patience_(patience), passed_(passed), piece_(piece), seams_(seams) {}

  bool run() {
    for (uint32_t &word : passed_) word = 0;
    // First the curves with ends, from their ends; the arcs left over are of closed curves.
    return take_curves(false) && take_curves(true);
  }

 private:
  static constexpr uint64_t instructions_for_a_half_edge = 40;

  bool take_curves(bool closed) {
    for (uint32_t ball = 0; ball < boundary_.ball_count(); ++ball) {
      if (!model_.owns(ball)) continue;
      if (!patience_.allows(instructions_for_a_half_edge * (1 + boundary_.half_edges(ball).size()))) return false;
      if (closed) take_circles(ball);
      for (const uint32_t e : boundary_.half_edges(ball)) {
        if (model_.owns(boundary_.half_edge(e).circle) || has_passed(e)) continue;
        if (closed || begins(ball, e)) walk(ball, e);
      }
    }
    return true;
  }

  // The ids of a vertex ascend with the caller's indices of its balls.
  struct Name {
    uint32_t ball[3];
    int sign;

    auto operator<=>(const Name &) const = default;
  };
  Name name_of(uint32_t v) const {
    const BallSet &balls = model_.balls();
    const OrderedVertex vertex =
        in_order(boundary_.vertex(v), [&balls](uint32_t i, uint32_t j) { return balls.given_before(i, j); });
    return {{balls.caller[vertex.ball[0]], balls.caller[vertex.ball[1]], balls.caller[vertex.ball[2]]}, vertex.sign};
  }

  bool has_passed(uint32_t e) const { return (passed_[e / 32] >> e % 32 & 1) != 0; }
  void pass(uint32_t e) { passed_[e / 32] |= UINT32_C(1) << e % 32; }
  // Whether a curve between this brick and another goes on at a vertex, beyond the two balls of one of its arcs.
  bool goes_on(uint32_t third, uint32_t other) const { return model_.owns(third) || model_.owner[third] == other; }
  uint32_t third_ball(uint32_t v, uint32_t p, uint32_t q) const {
    const VertexRecord &vertex = boundary_.vertex(v);
    return vertex.ball[0] ^ vertex.ball[1] ^ vertex.ball[2] ^ p ^ q;
  }
  bool begins(uint32_t ball, uint32_t e) const {
    const HalfEdge &half_edge = boundary_.half_edge(e);
    return !goes_on(third_ball(half_edge.vertex, ball, half_edge.circle), model_.owner[half_edge.circle]);
  }

  // Walks along a curve, in the direction of its half-edges on owned balls, to its end or to an arc already passed.
  void walk(uint32_t ball, uint32_t first) {
    const uint32_t other = model_.owner[boundary_.half_edge(first).circle];
    Name lowest = name_of(boundary_.half_edge(first).vertex);
    for (uint32_t e = first; e != no_id && !has_passed(e);) {
      pass(e);
      const uint32_t end = boundary_.end_vertex(e), third = third_ball(end, ball, boundary_.half_edge(e).circle);
      if (const Name name = name_of(end); name < lowest) lowest = name;
      // The next arc lies on the third ball, along the same circle, or on the same ball.
      if (model_.owns(third)) {
        e = boundary_.half_edge_at(end, boundary_.vertex(end).slot_of(third));
        ball = third;
      } else {
        e = goes_on(third, other) ? boundary_.half_edge(e).next : no_id;
      }
    }
    auto seam = model_.seam_to<ShellSeam>(other);
    for (uint32_t k = 0; k < 3; ++k) seam.id[k] = model_.id[lowest.ball[k]];
    seam.sign = lowest.sign;
    seam.label = piece_[boundary_.face_of(first)];
    seams_.push(seam);
  }

  void take_circles(uint32_t ball) {
    for (const ClosedHalfEdge e : boundary_.circles(ball)) {
      const uint32_t neighbour = boundary_.neighbour(e);
      if (model_.owns(neighbour)) continue;
      auto seam = model_.seam_to<ShellSeam>(model_.owner[neighbour]);
      const uint64_t own = model_.id_of(ball), foreign = model_.id_of(neighbour);
      seam.id[0] = own < foreign ? own : foreign;
      seam.id[1] = own < foreign ? foreign : own;
      seam.label = piece_[boundary_.face_of_loop(boundary_.loop_of(e))];
      seams_.push(seam);
    }
  }

  const BrickModel &model_;
  const Boundary &boundary_;
  Patience &patience_;
  Span<uint32_t> passed_;
  Span<const uint32_t> piece_;
  SeamList<ShellSeam> &seams_;
};

// Finds the seams of components: foreign balls that meet the same owned ball, and belong to the same brick, are joined.
class SeamContacts {
 public:
  SeamContacts(const BrickModel &model, Span<const uint32_t> component, Span<uint32_t> joined,
               Span<uint32_t> first_contact, Span<uint32_t> neighbours)
      : model_(model),
        component_(component),
        joined_(joined),
        first_contact_(first_contact),
        neighbours_(neighbours),
        lowest_(first_contact) {}

  bool run(Patience &patience, SeamList<ComponentSeam> &seams) {
    joined_.reset();
    for (uint32_t &each : first_contact_) each = no_id;
    const uint32_t n = model_.balls().n;
    for (uint32_t ball = 0; ball < n; ++ball) {
      if (model_.owns(ball) || component_of(ball) == no_id) continue;
      const Span<const uint32_t> near = neighbours_of(ball);
      if (!patience.allows(instructions_for_a_ball + instructions_for_a_neighbour * near.size())) return false;
      take_foreign(ball, near);
    }
    for (uint32_t ball = 0; ball < n; ++ball) {
      if (!model_.owns(ball) || first_contact_[ball] == no_id || (first_contact_[ball] & of_several) == 0) continue;
      const Span<uint32_t> near = neighbours_of(ball);
      if (!patience.allows(instructions_for_a_ball + instructions_for_a_neighbour * near.size())) return false;
      join_by_owner(near);
    }
    emit(seams);
    return true;
  }

 private:
  static constexpr uint64_t instructions_for_a_ball = 4000, instructions_for_a_neighbour = 100;
  static constexpr uint32_t of_several = UINT32_C(1) << 31;  // a ball that meets some of several other bricks

  uint32_t component_of(uint32_t ball) const { return component_[model_.boundary.component(ball)]; }
  // The balls that meet a ball, as numbers of the grid, not sorted.
  Span<uint32_t> neighbours_of(uint32_t ball) {
    QueryResult result{neighbours_.data(), neighbours_.size(), 0};
    find_neighbours(model_.grid, ball, result);
    const Span<uint32_t> near = neighbours_.part(0, result.hits);
    for (uint32_t &each : near) each = model_.grid.grid_index(each);
    return near;
  }
  // Takes the contacts of a ball of another brick. Each owned ball remembers the first foreign ball that it meets.
  void take_foreign(uint32_t ball, Span<const uint32_t> near) {
    uint32_t lowest = no_id;
    for (const uint32_t own : near) {
      if (!model_.owns(own)) continue;
      if (model_.balls().caller[own] < lowest) lowest = model_.balls().caller[own];
      uint32_t &first = first_contact_[own];
      if (first == no_id)
        first = ball;
      else if (model_.owner[first & ~of_several] == model_.owner[ball])
        joined_.join(first & ~of_several, ball);
      else
        first |= of_several;
    }
    if (lowest != no_id && model_.balls().caller[ball] < lowest) lowest = model_.balls().caller[ball];
    lowest_[ball] = lowest;
  }
  void join_by_owner(Span<uint32_t> near) {
    uint32_t foreign = 0;
    for (const uint32_t each : near) {
      if (!model_.owns(each)) near[foreign++] = each;
    }
    const Span<uint32_t> others = near.part(0, foreign);
    sort_in_place(others, [this](uint32_t i, uint32_t j) { return model_.owner[i] < model_.owner[j]; });
    for (uint32_t k = 1; k < foreign; ++k) {
      if (model_.owner[others[k - 1]] == model_.owner[others[k]]) joined_.join(others[k - 1], others[k]);
    }
  }
  // Pushes one seam for each set of foreign balls, named by the lowest of these and of the owned balls that they meet.
  void emit(SeamList<ComponentSeam> &seams) {
    const uint32_t n = model_.balls().n;
    for (uint32_t ball = 0; ball < n; ++ball) {
      if (model_.owns(ball) || lowest_[ball] == no_id) continue;
      uint32_t &lowest = lowest_[joined_.find(ball)];
      if (lowest_[ball] < lowest) lowest = lowest_[ball];
    }
    for (uint32_t ball = 0; ball < n; ++ball) {
      if (model_.owns(ball) || lowest_[ball] == no_id || joined_.find(ball) != ball) continue;
      auto seam = model_.seam_to<ComponentSeam>(model_.owner[ball]);
      seam.id[0] = model_.id[lowest_[ball]];
      seam.label = component_of(ball);
      seams.push(seam);
    }
  }

  const BrickModel &model_;
  Span<const uint32_t> component_;
  DisjointSets joined_;
  // first_contact_ of an owned ball: the first foreign ball that it meets. lowest_ of a foreign ball: the lowest index
  // of a contact.
  Span<uint32_t> first_contact_, neighbours_, lowest_;
};

}  // namespace

bool find_shell_seams(const BrickModel &model, Patience &patience, Span<uint32_t> passed, Span<const uint32_t> piece,
                      SeamList<ShellSeam> &seams) {
  return SeamCurves(model, patience, passed, piece, seams).run();
}

bool find_component_seams(const BrickModel &model, Patience &patience, Span<const uint32_t> component,
                          Span<uint32_t> joined, Span<uint32_t> first_contact, Span<uint32_t> neighbours,
                          SeamList<ComponentSeam> &seams) {
  return SeamContacts(model, component, joined, first_contact, neighbours).run(patience, seams);
}

}  // namespace hsp
