/* Memory of any alignment serves, for a handle if it has as many bytes as hsp_X_bytes says, and for a single call. For
 * a handle one byte less is refused with HSP_E_MEMORY, and nothing is written. */
#include "fenced_memory.h"
#include "law.h"

enum { ALIGNMENTS = 16 };

static void memory(const function *f, uint32_t capacity) {
  const int place = place_of_kind(f, KIND_memory);
  size_t slack, bytes;
  call c;
  if (place < 0) return;
  call_prepare(&c, f, capacity);
  bytes = fence_size(place);
  if (!is_memory_of_call(f, place)) {
    call_put(&c, place, --c.v[place + 1].z);
    law_refused(&c, "one byte less", "", HSP_E_MEMORY, "");
  }
  for (slack = 0; slack < ALIGNMENTS; ++slack) {
    call_prepare(&c, f, capacity);
    c.v[place].p = fence_take(place, bytes, slack);
    law_succeeds(&c, "any alignment", "");
  }
}

int main(void) {
  return check_law(memory);
}
