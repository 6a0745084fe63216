#include "commands/space_geometry.h"

bool geometry_compute_cells(struct geometry *geometry, struct failure *failure) {
  progress_show(&geometry->progress, "cutting free space");
  const int32_t status = hsp_workspace_cells(&geometry->work);
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_find_path(struct geometry *geometry, const double from[3], const double to[3], hsp_path *path,
                        struct failure *failure) {
  progress_show(&geometry->progress, "looking for a path");
  const int32_t status = hsp_workspace_path(&geometry->work, from, to, path);
  if (status == HSP_E_RANGE) return failure_in_input(failure, 0, "--from or --to: %s", geometry_reason(status));
  return status == HSP_OK || failure_in_library(failure, status);
}

typedef int32_t attempt(hsp_workspace *work, const void *of);

/* On the lattice of the model, then on coarser ones while what is looked for is too wide. */
static bool try_coarser(struct geometry *geometry, const struct molecule *molecule, double probe, attempt *find,
                        const void *of, int32_t *status, struct failure *failure) {
  enum { COARSER = 6 };
  hsp_model_info info;
  *status = find(&geometry->work, of);
  for (int time = 0; time < COARSER && *status == HSP_E_RANGE; ++time) {
    *status = hsp_model_get_info(geometry->work.model, &info);
    if (*status != HSP_OK) return failure_in_library(failure, *status);
    if (!geometry_set_model(geometry, molecule, probe, 10.0 * info.step, failure)) return false;
    *status = find(&geometry->work, of);
  }
  return true;
}

struct ends {
  const double *from, *to;
};

static int32_t find_gate(hsp_workspace *work, const void *of) {
  const struct ends *const ends = of;
  return hsp_workspace_gate(work, ends->from, ends->to);
}

bool geometry_find_gate(struct geometry *geometry, const struct molecule *molecule, const double from[3],
                        const double *to, struct failure *failure) {
  const struct ends ends = {from, to};
  int32_t status = HSP_OK;
  progress_show(&geometry->progress, "looking for the widest probe");
  if (!try_coarser(geometry, molecule, 0.0, find_gate, &ends, &status, failure)) return false;
  if (status == HSP_E_RANGE) return failure_in_input(failure, 0, "--from or --to: %s", geometry_reason(status));
  return status == HSP_OK || failure_in_library(failure, status);
}

static hsp_pores_options pores_of(double narrowest) {
  return (hsp_pores_options){.struct_size = (uint32_t)sizeof(hsp_pores_options), .reserved = 0, .floor = narrowest};
}

static int32_t find_pores(hsp_workspace *work, const void *of) {
  return hsp_workspace_pores(work, of);
}

/* Of the model, whose balls are grown by the probe. */
static bool find_pores_outside_boxes(struct geometry *geometry, const struct molecule *molecule, double probe,
                                     double narrowest, struct failure *failure) {
  const hsp_pores_options options = pores_of(narrowest);
  int32_t status = HSP_OK;
  progress_show(&geometry->progress, "looking for pores");
  return try_coarser(geometry, molecule, probe, find_pores, &options, &status, failure) &&
         (status == HSP_OK || failure_in_library(failure, status));
}

bool geometry_find_pores(struct geometry *geometry, const struct molecule *molecule, double narrowest,
                         struct failure *failure) {
  return find_pores_outside_boxes(geometry, molecule, 0.0, narrowest, failure);
}

/* In the model, or in the box. */
static int32_t compute_pores(const struct geometry *geometry, bool in_box, double narrowest, hsp_pores_limits *limits) {
  const hsp_pores_options options = pores_of(narrowest);
  hsp_pores *const pores = geometry->work.pores;
  return in_box ? hsp_pores_compute_periodic(pores, geometry->periodic, &options, limits)
                : hsp_pores_compute(pores, geometry->work.model, &options, limits);
}

static bool find_pores_of_box(struct geometry *geometry, const struct molecule *molecule, double probe,
                              const double *box, double narrowest, struct failure *failure) {
  if (!geometry_compute_periodic(geometry, molecule, probe, box, failure)) return false;
  hsp_workspace *const work = &geometry->work;
  progress_show(&geometry->progress, "looking for pores");
  int32_t status = hsp_workspace_ready_pores(work);
  hsp_pores_limits limits = work->pores_limits;
  while (status == HSP_OK) {
    status = compute_pores(geometry, true, narrowest, &limits);
    if (status != HSP_E_CAPACITY) break;
    status = hsp_workspace_grow_pores(work, &limits);
  }
  if (status == HSP_E_RANGE) {
    return failure_in_input(failure, 0, "the box is too long for its width, or a probe in it is too wide");
  }
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_find_pores_in_box(struct geometry *geometry, const struct molecule *molecule, const double *box,
                                double narrowest, struct failure *failure) {
  return find_pores_of_box(geometry, molecule, 0.0, box, narrowest, failure);
}

bool geometry_find_regions(struct geometry *geometry, const struct molecule *molecule, const double *box, double probe,
                           hsp_pore_access *access, uint32_t *regions, struct failure *failure) {
  if (box != NULL ? !find_pores_of_box(geometry, molecule, probe, box, 0.0, failure)
                  : !geometry_set_model(geometry, molecule, probe, 0.0, failure) ||
                        !find_pores_outside_boxes(geometry, molecule, probe, 0.0, failure) ||
                        !geometry_compute_boundary(geometry, failure)) {
    return false;
  }
  progress_show(&geometry->progress, "measuring regions");
  const int32_t status =
      hsp_pores_find_regions(geometry->work.pores, box != NULL ? NULL : geometry->work.boundary, access, regions);
  if (status == HSP_E_RANGE) return failure_in_input(failure, 0, "--regions: free space is too narrow somewhere");
  return status == HSP_OK || failure_in_library(failure, status);
}

bool geometry_find_tunnel(struct geometry *geometry, const struct tunnel_question *question, hsp_tunnel *tunnel,
                          struct failure *failure) {
  hsp_workspace *const work = &geometry->work;
  hsp_pores_limits limits = work->pores_limits;
  int32_t status = HSP_OK;
  progress_show(&geometry->progress, "looking for tunnels");
  while (status == HSP_OK) {
    status = (question->cheapest ? hsp_pores_find_cheapest_tunnel : hsp_pores_find_tunnel)(
        work->pores, question->from, question->to, question->avoided, question->count, tunnel, &limits);
    if (status != HSP_E_CAPACITY) break;
    status = hsp_workspace_grow_pores(work, &limits);
    if (status == HSP_OK) status = compute_pores(geometry, question->in_box, question->narrowest, NULL);
  }
  if (status == HSP_E_RANGE && question->in_box) {
    return failure_in_input(failure, 0, "the tunnel leads more than 2^17 boxes away");
  }
  return status == HSP_OK || failure_in_library(failure, status);
}
