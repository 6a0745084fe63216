#include "bricks/summary_merge.hpp"

#include "core/disjoint_sets.hpp"

namespace hsp {
namespace {

constexpr uint32_t instructions_for_a_record = 500;

// Goes through the seams of two lists in the order of their names: calls both(i, j) for a name that is in both lists,
// else alone(seam, from_a). False if patience ends.
template <class Record, class SeamAt, class Both, class Alone>
bool match(const SummaryBlock &a, uint32_t in_a, const SummaryBlock &b, uint32_t in_b, Patience &patience,
           SeamAt seam_at, Both both, Alone alone) {
  uint32_t i = 0, j = 0;
  Record first, second;
  if (in_a > 0) first = seam_at(a, 0);
  if (in_b > 0) second = seam_at(b, 0);
  while (i < in_a || j < in_b) {
    if (!patience.allows(instructions_for_a_record)) return false;
    const bool from_a = j == in_b || (i < in_a && first.is_before(second));
    const bool from_b = !from_a && (i == in_a || second.is_before(first));
    if (from_a || from_b)
      alone(from_a ? first : second, from_a);
    else
      both(first.label, second.label);
    if (!from_b && ++i < in_a) first = seam_at(a, i);
    if (!from_a && ++j < in_b) second = seam_at(b, j);
  }
  return true;
}

class Merge {
 public:
  Merge(const SummaryBlock &a, const SummaryBlock &b, Patience &patience, uint8_t *memory, uint64_t bytes)
      : a_(a), b_(b), patience_(patience), draft_(memory), memory_(memory), size_(bytes) {}

  MergeResult run();

 private:
  template <class Both, class Alone>
  bool match_shells(Both both, Alone alone) {
    return match<ShellSeam>(
        a_, a_.header().shell_seams, b_, b_.header().shell_seams, patience_,
        [](const SummaryBlock &block, uint32_t k) { return block.shell_seam(k); }, both, alone);
  }
  template <class Both, class Alone>
  bool match_components(Both both, Alone alone) {
    return match<ComponentSeam>(
        a_, a_.header().component_seams, b_, b_.header().component_seams, patience_,
        [](const SummaryBlock &block, uint32_t k) { return block.component_seam(k); }, both, alone);
  }
  template <class Put>
  MergeResult list_bricks(Put put) const;
  MergeResult check();
  // These return false if patience ends.
  bool join();
  bool put_pieces();
  bool put_components();
  bool put_seams();

  const SummaryBlock &a_, &b_;
  Patience &patience_;
  SummaryDraft draft_;
  uint8_t *const memory_;
  const uint64_t size_;
  // For the pieces, or components, of a and then of b: first disjoint sets, then numbers in the draft.
  Span<uint32_t> piece_, component_;
};

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
  const bool done = match_shells(both, alone_in(draft_.header.shell_seams)) &&
                    match_components(both, alone_in(draft_.header.component_seams));
  return done ? result : MergeResult{Status::stopped};
}

// Numbers sets in the order of their first members; returns how many there are. Parents come before their children.
uint32_t number_sets(Span<uint32_t> set) {
  uint32_t count = 0;
  for (uint32_t k = 0; k < set.size(); ++k) set[k] = set[k] == k ? count++ : set[set[k]];
  return count;
}

bool Merge::join() {
  DisjointSets pieces(piece_), components(component_);
  pieces.reset();
  components.reset();
  const auto alone = [](const Seam &, bool) {};
  const bool done =
      match_shells([&](uint32_t in_a, uint32_t in_b) { pieces.join(in_a, a_.header().pieces + in_b); }, alone) &&
      match_components([&](uint32_t in_a, uint32_t in_b) { components.join(in_a, a_.header().components + in_b); },
                       alone);
  draft_.header.pieces = number_sets(piece_);
  draft_.header.components = number_sets(component_);
  return done;
}

// Puts a record, or adds it to the record of its set: the first record of a set is put, the others are added. Numbers
// of the draft ascend with the first records.
template <class Record, class RecordAt>
void add_record(SummaryDraft &draft, uint32_t k, const Record &record, RecordAt record_at, uint32_t &known) {
  if (k < known) {
    Record sum = record_at(k);
    sum.add(record);
    draft.put(k, sum);
  } else {
    draft.put(k, record);
    ++known;
  }
}

bool Merge::put_pieces() {
  uint32_t known = 0;
  for (uint32_t k = 0; k < piece_.size(); ++k) {
    if (!patience_.allows(instructions_for_a_record)) return false;
    const bool of_a = k < a_.header().pieces;
    ShellPiece piece = of_a ? a_.piece(k) : b_.piece(k - a_.header().pieces);
    piece.component = component_[piece.component + (of_a ? 0 : a_.header().components)];
    add_record(
        draft_, piece_[k], piece, [this](uint32_t at) { return draft_.piece(at); }, known);
  }
  return true;
}

bool Merge::put_components() {
  uint32_t known = 0;
  for (uint32_t k = 0; k < component_.size(); ++k) {
    if (!patience_.allows(instructions_for_a_record)) return false;
    const bool of_a = k < a_.header().components;
    ComponentPart part = of_a ? a_.component(k) : b_.component(k - a_.header().components);
    if (part.top_piece != no_id) part.top_piece = piece_[part.top_piece + (of_a ? 0 : a_.header().pieces)];
    add_record(
        draft_, component_[k], part, [this](uint32_t at) { return draft_.component(at); }, known);
  }
  return true;
}

bool Merge::put_seams() {
  const auto both = [](uint32_t, uint32_t) {};
  uint32_t k = 0;
  const bool done = match_shells(both, [&](ShellSeam seam, bool from_a) {
    seam.label = piece_[seam.label + (from_a ? 0 : a_.header().pieces)];
    draft_.put(k++, seam);
  });
  k = 0;
  return done && match_components(both, [&](ComponentSeam seam, bool from_a) {
           seam.label = component_[seam.label + (from_a ? 0 : a_.header().components)];
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
  piece_ = words.take(pieces);
  component_ = words.take(components);
  if (!join()) return {Status::stopped};
  static_cast<void>(list_bricks([this](uint32_t k, uint32_t brick) { draft_.put_brick(k, brick); }));
  if (!put_pieces() || !put_components() || !put_seams()) return {Status::stopped};
  if (!draft_.finish(piece_.part(0, draft_.header.pieces), component_.part(0, draft_.header.components))) {
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
