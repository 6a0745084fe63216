#include "handle_kind.h"

#include <hardsphere.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void *test_zeros(size_t count, size_t size) {
  void *memory = calloc(count == 0 ? 1 : count, size);
  if (memory == NULL) {
    fprintf(stderr, "out of memory in a test\n");
    exit(2);
  }
  return memory;
}

int32_t grow_until_computed(const handle_kind *kind, const void *source, uint32_t balls, void **memory, void **handle,
                            void *needed, uint32_t *enlargements) {
  limit_numbers limits;
  memset(&limits, 0, sizeof limits);
  limits.number[0] = kind->struct_size;
  limits.number[1] = balls;
  for (*enlargements = 0;; ++*enlargements) {
    size_t bytes = 0;
    int32_t status = kind->bytes(&limits, &bytes);
    if (status != HSP_OK) return status;
    free(*memory);
    *memory = test_zeros(bytes, 1);
    status = kind->init(*memory, bytes, &limits, handle);
    if (status != HSP_OK) return status;
    status = kind->compute(*handle, source, &limits);
    if (status == HSP_OK) memcpy(needed, &limits, kind->struct_size);
    if (status != HSP_E_CAPACITY || *enlargements == MOST_ENLARGEMENTS + kind->more_enlargements) return status;
  }
}
