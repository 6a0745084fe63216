#include "bricks/brick_summary.hpp"

#include <bit>

#include "boundary/point_location.hpp"
#include "core/disjoint_sets.hpp"
#include "measure/areas.hpp"

namespace hsp {
namespace {

class BrickSummary {
 public:
  BrickSummary(const CubeGrid &grid, const Boundary &boundary, const BrickQuestion &question, Patience &patience,
               uint8_t *memory, uint64_t bytes)
      : model_{grid, boundary, question.brick, question.id, {}},
        question_(question),
        patience_(patience),
        quantum_(grid.side() / 2),
        draft_(memory),
        memory_(memory),
        size_(bytes) {}

  SummaryResult run();

 private:
  static constexpr uint64_t instructions_for_a_ball = 300, instructions_for_an_arc = 500;

  uint32_t n() const { return model_.balls().n; }
  uint64_t words() const;
  void take_words();
  void join_pieces();
  void number();
  bool measure();
  void add_face(uint32_t ball, uint32_t face, bool is_only_one);
  void select(uint32_t piece);
  void put_components();
  void look_at_top(uint32_t ball, uint32_t label);

  BrickModel model_;
  const BrickQuestion &question_;
  Patience &patience_;
  const AreaQuantum quantum_;
  SummaryDraft draft_;
  uint8_t *const memory_;
  const uint64_t size_;

  Span<uint32_t> owner_;                    // [n]
  Span<uint32_t> piece_, component_;        // [faces], [components of the boundary]: labels, no_id without owned balls
  Span<uint32_t> top_;                      // [components] by label: the ball that reaches highest
  Span<uint32_t> joined_, contact_, near_;  // [n] for seams
  Span<uint32_t> passed_;
  // The piece that faces are added to.
  ShellPiece sum_;
  uint32_t selected_ = no_id, put_ = 0;
};

uint64_t BrickSummary::words() const {
  const Boundary &boundary = model_.boundary;
  return 4 * uint64_t{n()} + boundary.face_count() + 2 * uint64_t{boundary.component_count()} +
         words_of_bits(boundary.half_edge_count());
}

void BrickSummary::take_words() {
  const Boundary &boundary = model_.boundary;
  DraftWords words(memory_, size_);
  owner_ = words.take(n());
  joined_ = words.take(n());
  contact_ = words.take(n());
  near_ = words.take(n());
  piece_ = words.take(boundary.face_count());
  component_ = words.take(boundary.component_count());
  top_ = words.take(boundary.component_count());
  passed_ = words.take(words_of_bits(boundary.half_edge_count()));
  for (uint32_t ball = 0; ball < n(); ++ball) owner_[ball] = question_.owner[model_.balls().caller[ball]];
  model_.owner = owner_;
}

// Joins faces of owned balls that meet, and counts half circles, corners and the like on the way.
void BrickSummary::join_pieces() {
  const Boundary &boundary = model_.boundary;
  DisjointSets pieces(piece_);
  pieces.reset();
  SummaryTotals &totals = draft_.header.totals;
  for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
    const VertexRecord &vertex = boundary.vertex(v);
    uint32_t first = no_id;
    for (uint32_t t = 0; t < 3; ++t) {
      if (!model_.owns(vertex.ball[t])) continue;
      const uint32_t face = boundary.face_of(boundary.half_edge_at(v, t));
      totals.tied_corners += vertex.tied();
      if (first == no_id)
        first = face;
      else
        pieces.join(first, face);
    }
  }
  for (uint32_t c = 0; c < boundary.circle_count(); ++c) {
    const CircleRecord &circle = boundary.circle(c);
    const bool first = model_.owns(circle.ball[0]), second = model_.owns(circle.ball[1]);
    totals.half_circles += uint32_t{first} + uint32_t{second};
    if (first && second) pieces.join(boundary.face_of_loop(circle.loop[0]), boundary.face_of_loop(circle.loop[1]));
  }
}

// Numbers pieces and components of owned balls, in the order of their first balls.
void BrickSummary::number() {
  const Boundary &boundary = model_.boundary;
  SummaryHeader &header = draft_.header;
  for (uint32_t &label : component_) label = no_id;
  for (uint32_t ball = 0; ball < n(); ++ball) {
    const bool owned = model_.owns(ball);
    if (uint32_t &label = component_[boundary.component(ball)]; owned && label == no_id) label = header.components++;
    for (const uint32_t face : boundary.faces(ball)) {
      // Parents come before their children, and have their numbers.
      if (!owned)
        piece_[face] = no_id;
      else
        piece_[face] = piece_[face] == face ? header.pieces++ : piece_[piece_[face]];
    }
  }
}

void BrickSummary::select(uint32_t piece) {
  if (piece == selected_) return;
  if (selected_ != no_id) draft_.put(selected_, sum_);
  if (piece != no_id) {
    sum_ = piece < put_ ? draft_.piece(piece) : ShellPiece{};
    if (piece == put_) ++put_;
  }
  selected_ = piece;
}

void BrickSummary::add_face(uint32_t ball, uint32_t face, bool is_only_one) {
  const Boundary &boundary = model_.boundary;
  const exact::LatticeBall own = model_.balls().ball(ball);
  const double radius = model_.balls().r[ball];
  FreeSurface surface(boundary, radius);
  ArcBatches arcs(model_.balls(), boundary, ball, is_only_one ? no_id : face);
  while (arcs.next()) surface.add(arcs.batch());
  const uint32_t loops = boundary.loops_of_face(face).size();
  const AreaSum area = quantum_.round(radius * radius * surface.steradians(1, loops));
  const Vec3 vector_area = surface.vector_area();
  const double normal[3] = {vector_area.x, vector_area.y, vector_area.z};
  const int64_t centre[3] = {own.centre.x, own.centre.y, own.centre.z};
  int64_t low[3], high[3];

  select(piece_[face]);
  sum_.component = component_[boundary.component(ball)];
  ++sum_.faces;
  sum_.loops += loops;
  sum_.area = sum_.area + area;
  draft_.header.totals.area = draft_.header.totals.area + area;
  sum_.radial = sum_.radial + times(area, own.radius);
  for (uint32_t k = 0; k < 3; ++k) {
    const AreaSum rounded = quantum_.round(normal[k]);
    sum_.normal[k] = sum_.normal[k] + rounded;
    sum_.moment = sum_.moment + times(rounded, centre[k]);
    low[k] = centre[k] - own.radius;
    high[k] = centre[k] + own.radius;
  }
  sum_.widen(low, high);
}

bool BrickSummary::measure() {
  const Boundary &boundary = model_.boundary;
  SummaryTotals &totals = draft_.header.totals;
  for (uint32_t ball = 0; ball < n(); ++ball) {
    if (!model_.owns(ball)) continue;
    const IdRange faces = boundary.faces(ball), half_edges = boundary.half_edges(ball);
    if (!patience_.allows(instructions_for_a_ball + instructions_for_an_arc * half_edges.size())) return false;
    ++totals.balls;
    totals.exposed += !faces.empty();
    totals.contained += boundary.is_contained(ball);
    totals.faces += faces.size();
    totals.loops += boundary.loops(ball).size();
    totals.corners += half_edges.size();
    for (const uint32_t face : faces) add_face(ball, face, faces.size() == 1);
    for (const uint32_t e : half_edges) {
      select(piece_[boundary.face_of(e)]);
      ++sum_.corners;
    }
  }
  select(no_id);
  return true;
}

// Updates the highest ball of a component with one of all balls that the brick knows, also balls of others: if the
// highest is an owned one, its highest point is free.
void BrickSummary::look_at_top(uint32_t ball, uint32_t label) {
  const BallSet &balls = model_.balls();
  uint32_t &top = top_[label];
  if (top != no_id) {
    const double height = balls.z[ball] + balls.r[ball], highest = balls.z[top] + balls.r[top];
    if (height < highest || (height == highest && !balls.ranks_before(ball, top))) return;
  }
  top = ball;
}

void BrickSummary::put_components() {
  const Boundary &boundary = model_.boundary;
  const BallSet &balls = model_.balls();
  const uint32_t count = draft_.header.components;
  for (uint32_t k = 0; k < count; ++k) {
    top_[k] = no_id;
    draft_.put(k, ComponentPart{});
  }
  for (uint32_t ball = 0; ball < n(); ++ball) {
    const uint32_t label = component_[boundary.component(ball)];
    if (label == no_id) continue;
    look_at_top(ball, label);
    if (!model_.owns(ball)) continue;
    ComponentPart part = draft_.component(label);
    ++part.balls;
    if (model_.id_of(ball) < part.lowest_id) part.lowest_id = model_.id_of(ball);
    draft_.put(label, part);
  }
  for (uint32_t k = 0; k < count; ++k) {
    const uint32_t top = top_[k];
    if (!model_.owns(top)) continue;
    const exact::LatticeBall ball = balls.ball(top);
    ComponentPart part = draft_.component(k);
    part.top_piece = piece_[face_of_top(balls, boundary, top)];
    part.height = ball.centre.z + ball.radius;
    part.top = {ball.centre.x, ball.centre.y, ball.centre.z, ball.radius, model_.id_of(top)};
    draft_.put(k, part);
  }
}

SummaryResult BrickSummary::run() {
  SummaryHeader &header = draft_.header;
  const BallSet &balls = model_.balls();
  header.flags = question_.keeps_shells ? SummaryHeader::keeps_shells : 0;
  header.lattice = {std::bit_cast<uint64_t>(balls.lattice.step()), balls.probe_steps, model_.grid.side() / 2};
  header.all_bricks = question_.bricks;
  header.bricks = 1;
  // Before anything is counted, the records are guessed, at a number that most bricks do not exceed.
  constexpr uint64_t guess_for_a_ball = 32, guess_beyond = 4096;
  const uint64_t scratch = DraftWords::bytes(words());
  if (size_ < scratch + header.bytes()) {
    return {Status::capacity, scratch + header.bytes() + guess_for_a_ball * n() + guess_beyond};
  }
  take_words();
  const uint64_t room = size_ - scratch;
  join_pieces();
  number();
  const auto room_from = [room](uint64_t first) { return first < room ? room - first : 0; };
  const uint64_t shell_seams_at = header.shell_seams_at();
  SeamList<ShellSeam> shells(memory_ + shell_seams_at, room_from(shell_seams_at));
  if (!find_shell_seams(model_, patience_, passed_, piece_, shells)) return {Status::stopped};
  header.shell_seams = shells.count();
  const uint64_t component_seams_at = header.component_seams_at();
  SeamList<ComponentSeam> components(memory_ + component_seams_at, room_from(component_seams_at));
  if (!find_component_seams(model_, patience_, component_, joined_, contact_, near_, components)) {
    return {Status::stopped};
  }
  header.component_seams = components.count();
  if (room < header.bytes()) return {Status::capacity, scratch + header.bytes()};

  draft_.put_brick(0, question_.brick);
  if (!measure()) return {Status::stopped};
  put_components();
  draft_.sort_seams();
  static_cast<void>(draft_.finish(piece_.part(0, header.pieces), component_.part(0, header.components)));
  return {Status::ok, header.bytes()};
}

}  // namespace

SummaryResult summarise_brick(const CubeGrid &grid, const Boundary &boundary, const BrickQuestion &question,
                              Patience patience, uint8_t *memory, uint64_t bytes) {
  return BrickSummary(grid, boundary, question, patience, memory, bytes).run();
}

}  // namespace hsp
