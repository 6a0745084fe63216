#include "bricks/summary_merge.hpp"

#include "core/disjoint_sets.hpp"

namespace hsp {
namespace {

constexpr uint32_t instructions_for_a_record = 500;

class Merge {
 public:
  Merge(const SummaryBlock &a, const SummaryBlock &b, Patience &patience, uint8_t *memory, uint64_t bytes)
      : a_(a), b_(b), patience_(patience), draft_(memory), memory_(memory), size_(bytes) {}

  MergeResult run();

 private:
  // The pieces, or components, of a and then of b: first disjoint sets, then numbers in the draft.
  struct Numbers {
    Span<uint32_t> of;
    uint32_t in_a;

    uint32_t operator()(uint32_t k, bool of_a) const { return of[k + (of_a ? 0 : in_a)]; }
  };

  template <class Put>
  MergeResult list_bricks(Put put) const;
  MergeResult check();
  // These return false if patience ends.
  template <class Record, class Both, class Alone>
  bool match(Both both, Alone alone);
  bool join();
  template <class Record, class Renumber>
  bool put_records(const Numbers &numbers, Renumber renumber);
  template <class Record>
  bool put_seams(const Numbers &labels);

  const SummaryBlock &a_, &b_;
  Patience &patience_;
  SummaryDraft draft_;
  uint8_t *const memory_;
  const uint64_t size_;
  Numbers piece_{{}, a_.header().pieces}, component_{{}, a_.header().components};
};

// Goes through the seams of both in the order of their names: calls both(i, j) with the labels of a name that both
// have, else alone(seam, from_a).
template <class Record, class Both, class Alone>
bool Merge::match(Both both, Alone alone) {
  const uint32_t in_a = a_.header().seams<Record>(), in_b = b_.header().seams<Record>();
  uint32_t i = 0, j = 0;
  Record first, second;
  if (in_a > 0) first = a_.get<Record>(0);
  if (in_b > 0) second = b_.get<Record>(0);
  while (i < in_a || j < in_b) {
    if (!patience_.allows(instructions_for_a_record)) return false;
    const bool from_a = j == in_b || (i < in_a && first < second);
    const bool from_b = !from_a && (i == in_a || second < first);
    if (from_a || from_b)
      alone(from_a ? first : second, from_a);
    else
      both(first.label, second.label);
    if (!from_b && ++i < in_a) first = a_.get<Record>(i);
    if (!from_a && ++j < in_b) second = b_.get<Record>(j);
  }
  return true;
}

template <class Put>
MergeResult Merge::list_bricks(Put put) const {
  uint32_t i = 0, j = 0, count = 0;
  while (i < a_.header().bricks || j < b_.header().bricks) {
    const uint32_t first = i < a_.header().bricks ? a_.brick(i) : no_id;
    const uint32_t second = j < b_.header().bricks ? b_.brick(j) : no_id;
    if (first == second) return {Status::id, first};
    put(count++, first < second ? first : second);
    if (first < second)
      ++i;
    else
      ++j;
  }
  return {Status::ok};
}

// Checks that both are parts of one set, and counts the seams that are left.
MergeResult Merge::check() {
  const SummaryHeader &a = a_.header(), &b = b_.header();
  if (a.lattice != b.lattice || a.all_bricks != b.all_bricks || a.flags != b.flags) {
    return {Status::argument, b_.brick(0)};
  }
  MergeResult result = list_bricks([](uint32_t, uint32_t) {});
  if (result.status != Status::ok) return result;
  draft_.header = a;
  draft_.header.totals.add(b.totals);
  draft_.header.bricks += b.bricks;
  draft_.header.shell_seams = draft_.header.component_seams = 0;
  const auto both = [](uint32_t, uint32_t) {};
  const auto alone_in = [&](uint32_t &count) {
    return [&](const Seam &seam, bool from_a) {
      ++count;
      const SummaryBlock &other = from_a ? b_ : a_;
      const bool lacks_a = other.has(seam.a);
      if (result.status == Status::ok && (lacks_a || other.has(seam.b))) {
        result = {Status::conflict, lacks_a ? seam.a : seam.b};
      }
    };
  };
  const bool done = match<ShellSeam>(both, alone_in(draft_.header.shell_seams)) &&
                    match<ComponentSeam>(both, alone_in(draft_.header.component_seams));
  return done ? result : MergeResult{Status::stopped};
}

// Numbers sets in the order of their first members; returns how many there are. Parents come before their children.
uint32_t number_sets(Span<uint32_t> set) {
  uint32_t count = 0;
  for (uint32_t k = 0; k < set.size(); ++k) set[k] = set[k] == k ? count++ : set[set[k]];
  return count;
}

bool Merge::join() {
  DisjointSets pieces(piece_.of), components(component_.of);
  pieces.reset();
  components.reset();
  const auto alone = [](const Seam &, bool) {};
  const auto join_in = [](DisjointSets &sets, const Numbers &numbers) {
    return [&](uint32_t in_a, uint32_t in_b) { sets.join(in_a, numbers.in_a + in_b); };
  };
  const bool done =
      match<ShellSeam>(join_in(pieces, piece_), alone) && match<ComponentSeam>(join_in(components, component_), alone);
  draft_.header.pieces = number_sets(piece_.of);
  draft_.header.components = number_sets(component_.of);
  return done;
}

// Puts the first record of each set, and adds the others to it. Numbers of the draft ascend with the first records.
template <class Record, class Renumber>
bool Merge::put_records(const Numbers &numbers, Renumber renumber) {
  uint32_t known = 0;
  for (uint32_t k = 0; k < numbers.of.size(); ++k) {
    if (!patience_.allows(instructions_for_a_record)) return false;
    const bool of_a = k < numbers.in_a;
    Record record = of_a ? a_.get<Record>(k) : b_.get<Record>(k - numbers.in_a);
    renumber(record, of_a);
    const uint32_t to = numbers.of[k];
    if (to < known) {
      Record sum = draft_.get<Record>(to);
      sum.add(record);
      draft_.put(to, sum);
    } else {
      draft_.put(to, record);
      ++known;
    }
  }
  return true;
}

template <class Record>
bool Merge::put_seams(const Numbers &labels) {
  uint32_t k = 0;
  return match<Record>([](uint32_t, uint32_t) {},
                       [&](Record seam, bool from_a) {
                         seam.label = labels(seam.label, from_a);
                         draft_.put(k++, seam);
                       });
}

MergeResult Merge::run() {
  const MergeResult result = check();
  if (result.status != Status::ok) return result;
  const uint64_t pieces = uint64_t{a_.header().pieces} + b_.header().pieces;
  const uint64_t components = uint64_t{a_.header().components} + b_.header().components;
  if (pieces >= no_id || components >= no_id) return {Status::range};
  draft_.header.pieces = static_cast<uint32_t>(pieces);
  draft_.header.components = static_cast<uint32_t>(components);
  const uint64_t enough = draft_.header.bytes() + DraftWords::bytes(pieces + components);
  if (size_ < enough) return {Status::capacity, no_id, enough};
  DraftWords words(memory_, size_);
  piece_.of = words.take(pieces);
  component_.of = words.take(components);
  if (!join()) return {Status::stopped};
  static_cast<void>(list_bricks([this](uint32_t k, uint32_t brick) { draft_.put_brick(k, brick); }));
  const auto in_draft = [this](ShellPiece &piece, bool of_a) { piece.component = component_(piece.component, of_a); };
  const auto part_in_draft = [this](ComponentPart &part, bool of_a) {
    if (part.top_piece != no_id) part.top_piece = piece_(part.top_piece, of_a);
  };
  if (!put_records<ShellPiece>(piece_, in_draft) || !put_records<ComponentPart>(component_, part_in_draft) ||
      !put_seams<ShellSeam>(piece_) || !put_seams<ComponentSeam>(component_))
    return {Status::stopped};
  if (!draft_.finish(piece_.of.part(0, draft_.header.pieces), component_.of.part(0, draft_.header.components))) {
    return {Status::conflict, b_.brick(0)};
  }
  return {Status::ok, no_id, draft_.header.bytes()};
}

}  // namespace

MergeResult merge_summaries(const SummaryBlock &a, const SummaryBlock &b, Patience patience, uint8_t *memory,
                            uint64_t bytes) {
  return Merge(a, b, patience, memory, bytes).run();
}

}  // namespace hsp
