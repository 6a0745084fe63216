/* Summaries of bricks (hardsphere/bricks.h) in memory that grows as they ask for it, and their way down a tree of
 * ranks: for codes with a decomposition of their own (capi/guide/ghosts.md). C99 and C++. The part for ranks is there
 * where the header of MPI was included before. */
#ifndef BRICK_SUMMARIES_H
#define BRICK_SUMMARIES_H

#include <hardsphere.h>
#include <stdio.h>
#include <stdlib.h>

/** NULL and 0 at first; byte is the caller's to free. */
typedef struct brick_summary {
  uint8_t *byte;
  size_t bytes;
} brick_summary;

/** The summary of a brick, in no more memory than it takes. */
static inline int32_t brick_summary_make(const hsp_boundary *boundary, const hsp_brick_request *request,
                                         brick_summary *summary) {
  int32_t status = HSP_OK;
  uint8_t *shorter;
  while (status == HSP_OK) {
    status = hsp_brick_summarise(boundary, request, summary->byte, &summary->bytes, NULL);
    if (status != HSP_E_CAPACITY) break;
    free(summary->byte);
    summary->byte = (uint8_t *)malloc(summary->bytes);
    status = summary->byte != NULL ? HSP_OK : HSP_E_MEMORY;
  }
  if (summary->byte == NULL) summary->bytes = 0;
  shorter = status == HSP_OK ? (uint8_t *)realloc(summary->byte, summary->bytes) : NULL;
  if (shorter != NULL) summary->byte = shorter;
  return status;
}

/** Merges other into summary, and frees other. After a failure both stay, and *brick is at fault, or HSP_NONE. */
static inline int32_t brick_summary_merge(brick_summary *summary, brick_summary *other, const hsp_executor *executor,
                                          uint32_t *brick) {
  brick_summary merged = {NULL, 0};
  uint8_t *shorter;
  int32_t status =
      hsp_brick_merge(summary->byte, summary->bytes, other->byte, other->bytes, executor, NULL, &merged.bytes, brick);
  if (status == HSP_E_CAPACITY) {
    merged.byte = (uint8_t *)malloc(merged.bytes);
    if (merged.byte == NULL) return HSP_E_MEMORY;
    status = hsp_brick_merge(summary->byte, summary->bytes, other->byte, other->bytes, executor, merged.byte,
                             &merged.bytes, brick);
  }
  if (status != HSP_OK) {
    free(merged.byte);
    return status;
  }
  shorter = (uint8_t *)realloc(merged.byte, merged.bytes);
  if (shorter != NULL) merged.byte = shorter;
  free(summary->byte);
  free(other->byte);
  *summary = merged;
  other->byte = NULL;
  return HSP_OK;
}

#ifdef MPI_VERSION
/** All ranks: their summaries go down a binary tree to rank 0, the very bytes, and merge. A rank that has failed sends
 *  nothing, which is damaged, and so is what is merged with it. Returns how many bytes this rank has sent. */
static inline uint64_t brick_summary_reduce(brick_summary *summary, MPI_Comm communicator) {
  int rank, ranks, step;
  MPI_Comm_rank(communicator, &rank);
  MPI_Comm_size(communicator, &ranks);
  for (step = 1; step < ranks; step *= 2) {
    brick_summary other = {NULL, 0};
    MPI_Status sent;
    uint32_t brick = HSP_NONE;
    int32_t status;
    int bytes = 0;
    if ((rank & step) != 0) {
      MPI_Send(summary->byte, (int)summary->bytes, MPI_BYTE, rank - step, 0, communicator);
      return summary->bytes;
    }
    if (rank + step >= ranks) continue;
    MPI_Probe(rank + step, 0, communicator, &sent);
    MPI_Get_count(&sent, MPI_BYTE, &bytes);
    other.byte = (uint8_t *)malloc((size_t)bytes + 1);
    if (other.byte == NULL) MPI_Abort(communicator, 1);
    other.bytes = (size_t)bytes;
    MPI_Recv(other.byte, bytes, MPI_BYTE, rank + step, 0, communicator, MPI_STATUS_IGNORE);
    status = brick_summary_merge(summary, &other, NULL, &brick);
    free(other.byte);
    if (status == HSP_OK) continue;
    fprintf(stderr, "summaries of ranks %d and %d, brick %ld: %s\n", rank, rank + step,
            brick == HSP_NONE ? -1L : (long)brick, hsp_status_text(status));
    summary->bytes = 0;
  }
  return 0;
}
#endif

#endif
