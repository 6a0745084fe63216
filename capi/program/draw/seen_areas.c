#include "draw/seen_areas.h"

#include <stdlib.h>

#include "read/geometry.h"

static const double cells_per_letter = 8.0;

bool seen_areas_find_painted(const hsp_view *view, uint32_t atoms, bool **painted, struct failure *failure) {
  uint32_t count = 0;
  int32_t status = hsp_view_get_pieces(view, NULL, 0, &count);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
  hsp_view_piece *const piece = malloc(((size_t)count + 1) * sizeof *piece);
  *painted = calloc((size_t)atoms + 1, sizeof **painted);
  status = piece == NULL || *painted == NULL ? HSP_E_MEMORY : hsp_view_get_pieces(view, piece, count, &count);
  for (uint32_t i = 0; status == HSP_OK && i < count; ++i) (*painted)[piece[i].ball] = true;
  free(piece);
  if (status == HSP_OK) return true;
  free(*painted);
  *painted = NULL;
  return failure_in_library(failure, status);
}

bool seen_areas_find(const struct shown_bodies *bodies, const struct picture_frame *frame, const hsp_view_info *view,
                     double **area, struct failure *failure) {
  const double low[2] = {0.0, 0.0}, high[2] = {frame->width, frame->height};
  const struct page_axes axes = picture_frame_axes(frame, view);
  struct front_grid front;
  *area = calloc((size_t)bodies->molecule->atoms + 1, sizeof **area);
  const bool enough = front_grid_make(&front, low, high, frame->letter / cells_per_letter) && *area != NULL;
  if (enough) {
    const size_t cells = (size_t)front.columns * (size_t)front.rows;
    front_grid_show(&front, bodies, &axes, frame->scale);
    for (size_t i = 0; i < cells; ++i) {
      if (front.owner[i] == FRONT_GRID_NOTHING) continue;
      (*area)[front.owner[i] & ~FRONT_GRID_STICK] += front.cell * front.cell;
    }
  }
  front_grid_free(&front);
  if (enough) return true;
  free(*area);
  *area = NULL;
  return failure_of_memory(failure);
}
