#include "bricks/brick_summary.hpp"
#include "bricks/summary_merge.hpp"
#include "bricks/whole_set.hpp"
#include "caller_executor.hpp"
#include "core/sorting.hpp"
#include "hsp_boundary.hpp"

using namespace hsp::capi;

namespace {

static_assert(HSP_BRICK_KEEP_SHELLS == hsp::SummaryHeader::keeps_shells);

bool is_missing(const void *memory, const size_t *bytes) {
  return bytes == nullptr || (memory == nullptr && *bytes > 0);
}

// Names the first ball whose id or owner is refused.
int32_t check_balls(const hsp_brick_request &asked, uint32_t n, uint32_t *first_bad) {
  for (uint32_t i = 0; i < n; ++i) {
    if ((i == 0 || asked.id[i - 1] < asked.id[i]) && asked.owner[i] < asked.bricks) continue;
    if (first_bad != nullptr) *first_bad = i;
    return HSP_E_ID;
  }
  return HSP_OK;
}

// Hands back the bytes of a result, or those to try again with; at most as many as a size_t holds.
int32_t hand_back_bytes(hsp::Status status, uint64_t count, size_t *bytes) {
  if (status == hsp::Status::ok || status == hsp::Status::capacity) {
    *bytes = count < SIZE_MAX ? static_cast<size_t>(count) : SIZE_MAX;
  }
  return to_c(status);
}

int32_t to_c(hsp::SummaryFault fault) {
  if (fault == hsp::SummaryFault::none) return HSP_OK;
  return fault == hsp::SummaryFault::newer ? HSP_E_VERSION : HSP_E_DAMAGED;
}

void name(uint32_t brick, uint32_t *out) {
  if (out != nullptr) *out = brick;
}

// Checks that a summary has all bricks.
int32_t check_whole(const hsp::SummaryBlock &block, const hsp::WholeSet &whole, bool shells, uint32_t *brick) {
  const uint32_t missing = whole.first_missing();
  name(missing, brick);
  if (missing != hsp::no_id || (shells && !block.header().keeps())) return HSP_E_STATE;
  return whole.is_sound() ? HSP_OK : HSP_E_CONFLICT;
}

hsp_brick_shell to_c(const hsp::WholeShell &shell) {
  return {shell.component, shell.faces,  shell.euler,
          shell.area,      shell.volume, shell.is_void ? HSP_SHELL_VOID : HSP_SHELL_OUTER,
          {0, 0, 0}};
}

// An order of shells that does not depend on how summaries were merged: shells that tie are equal.
bool is_before(const hsp_brick_shell &a, const hsp_brick_shell &b) {
  if (a.component != b.component) return a.component < b.component;
  if (a.kind != b.kind) return a.kind < b.kind;
  if (a.faces != b.faces) return a.faces < b.faces;
  if (a.euler != b.euler) return a.euler < b.euler;
  return a.area != b.area ? a.area < b.area : a.volume < b.volume;
}

}  // namespace

int32_t hsp_brick_summarise(const hsp_boundary *boundary, const hsp_brick_request *request, void *summary,
                            size_t *bytes, uint32_t *first_bad) {
  LibraryArithmetic arithmetic;
  Executor executor(arithmetic);
  hsp_brick_request asked{};
  if (const int32_t status = check_handle(boundary); status != HSP_OK) return name_none(status, first_bad);
  name_none(HSP_OK, first_bad);
  int32_t status = request == nullptr ? HSP_E_ARGUMENT : read_struct(request, {}, asked);
  if (status == HSP_OK) status = executor.read(asked.executor);
  if (status != HSP_OK) return status;
  const uint32_t n = boundary->has_results() ? boundary->balls().n : 0;
  const bool lacks_balls = (n > 0 || !boundary->has_results()) && (asked.id == nullptr || asked.owner == nullptr);
  if ((asked.flags & ~HSP_BRICK_KEEP_SHELLS) != 0 || asked.brick >= asked.bricks || lacks_balls) return HSP_E_ARGUMENT;
  if (is_missing(summary, bytes)) return HSP_E_ARGUMENT;
  if (!boundary->has_results()) return HSP_E_STATE;
  status = check_balls(asked, n, first_bad);
  if (status != HSP_OK) return status;
  const hsp::BrickQuestion question{asked.brick, asked.bricks, (asked.flags & HSP_BRICK_KEEP_SHELLS) != 0, asked.id,
                                    asked.owner};
  const hsp::SummaryResult result =
      hsp::summarise_brick(boundary->model->grid, boundary->structure(), question, hsp::Patience(&executor),
                           static_cast<uint8_t *>(summary), *bytes);
  return hand_back_bytes(result.status, result.bytes, bytes);
}

int32_t hsp_brick_merge(const uint8_t *a, size_t a_bytes, const uint8_t *b, size_t b_bytes,
                        const hsp_executor *executor, void *summary, size_t *bytes, uint32_t *brick) {
  LibraryArithmetic arithmetic;
  Executor asked(arithmetic);
  name(HSP_NONE, brick);
  if (const int32_t status = asked.read(executor); status != HSP_OK) return status;
  if (a == nullptr || b == nullptr || is_missing(summary, bytes)) return HSP_E_ARGUMENT;
  hsp::SummaryBlock first, second;
  const int32_t status = versions_first(to_c(first.read(a, a_bytes)), to_c(second.read(b, b_bytes)));
  if (status != HSP_OK) return status;
  const hsp::MergeResult result =
      hsp::merge_summaries(first, second, hsp::Patience(&asked), static_cast<uint8_t *>(summary), *bytes);
  name(result.brick, brick);
  return hand_back_bytes(result.status, result.bytes, bytes);
}

int32_t hsp_brick_get_totals(const uint8_t *summary, size_t bytes, hsp_brick_totals *totals, uint32_t *brick) {
  LibraryArithmetic arithmetic;
  name(HSP_NONE, brick);
  if (summary == nullptr || totals == nullptr) return HSP_E_ARGUMENT;
  hsp::SummaryBlock block;
  if (const int32_t status = to_c(block.read(summary, bytes)); status != HSP_OK) return status;
  const hsp::WholeSet whole(block);
  if (const int32_t status = check_whole(block, whole, false, brick); status != HSP_OK) return status;
  const hsp::WholeTotals t = whole.totals();
  *totals = {t.balls,      t.exposed, t.contained,     t.vertices, t.arcs, t.circles, t.faces,       t.loops, t.shells,
             t.components, t.voids,   t.tied_vertices, t.euler,    t.area, t.volume,  t.void_volume, {0, 0}};
  return HSP_OK;
}

int32_t hsp_brick_get_shells(const uint8_t *summary, size_t bytes, hsp_brick_shell *out, uint32_t capacity,
                             uint32_t *needed, uint32_t *brick) {
  LibraryArithmetic arithmetic;
  name(HSP_NONE, brick);
  if (summary == nullptr || (out == nullptr && capacity > 0)) return HSP_E_ARGUMENT;
  hsp::SummaryBlock block;
  if (const int32_t status = to_c(block.read(summary, bytes)); status != HSP_OK) return status;
  const hsp::WholeSet whole(block);
  if (const int32_t status = check_whole(block, whole, true, brick); status != HSP_OK) return status;
  if (const int32_t status = check_output(capacity, whole.shells(), needed); status != HSP_OK) return status;
  for (uint32_t k = 0; k < whole.shells(); ++k) out[k] = to_c(whole.shell(k));
  hsp::sort_in_place(hsp::Span<hsp_brick_shell>(out, whole.shells()),
                     [](const hsp_brick_shell &a, const hsp_brick_shell &b) { return is_before(a, b); });
  return HSP_OK;
}
