/* hardsphere with memory that grows: for C and C++ programs that may call malloc. Nothing of this is in the library.
 *
 *   hsp_workspace work = {0};                                   (in C++: hsp_workspace work = {};)
 *   int32_t status = hsp_workspace_set(&work, n, xyz, radius, NULL, NULL);
 *   if (status == HSP_OK) status = hsp_workspace_boundary(&work);
 *   if (status == HSP_OK) status = hsp_boundary_measure(work.boundary, NULL, &totals, area, NULL, n, NULL);
 *   ...
 *   hsp_workspace_free(&work);
 *
 * A workspace owns a handle of each kind, which are made when they are first needed and made larger when a set of balls
 * needs more. It may be used for any number of sets, one after the other, and keeps the memory of the largest. Read
 * results through its handles by the functions of hardsphere.h; take the handles anew from the workspace after each
 * call, as they move when they grow. A workspace may be copied; use only one of the copies. Distinct workspaces may be
 * used by distinct threads.
 *
 * A row with a name, such as `---- model.h`, begins what is for that header. Where a component was left out of the
 * library, what is for its headers is left out, too.
 *
 * STATUS: that of the function of hardsphere.h that fails, and HSP_E_MEMORY if malloc fails. A call that fails leaves
 * the workspace such that every function may be called again; what it was to compute holds no results.
 */
#ifndef HARDSPHERE_WORKSPACE_H
#define HARDSPHERE_WORKSPACE_H

#include <hardsphere.h>
#include <stdlib.h>
#include <string.h>

/** All zeros at first. The handles may be read; the rest is this file's. */
typedef struct hsp_workspace {
  hsp_model *model;                    /**< NULL before hsp_workspace_set */
  hsp_boundary *boundary;              /**< NULL before hsp_workspace_boundary */
  hsp_topology *topology;              /**< NULL before hsp_workspace_topology */
  hsp_view *view;                      /**< NULL before hsp_workspace_view (hardsphere/view.h) */
  hsp_surface *surface;                /**< NULL before hsp_workspace_surface (hardsphere/surface.h) */
  hsp_mesh *mesh;                      /**< NULL before hsp_workspace_mesh (hardsphere/mesh.h) */
  hsp_map *map;                        /**< NULL before hsp_workspace_map (hardsphere/map.h) */
  hsp_contacts *contacts;              /**< NULL before hsp_workspace_contacts */
  hsp_cells *cells;                    /**< NULL before hsp_workspace_cells (hardsphere/cells.h) */
  hsp_paths *paths;                    /**< NULL before hsp_workspace_path (hardsphere/paths.h) */
  hsp_gate *gate;                      /**< NULL before hsp_workspace_gate (hardsphere/paths.h) */
  hsp_moving *moving;                  /**< NULL before hsp_workspace_moving */
  void *memory[12];                    /**< of the twelve handles */
  uint32_t most_balls;                 /**< what the model has room for */
  uint32_t reserved;                   /**< 0 */
  hsp_boundary_limits boundary_limits; /**< what the boundary has room for */
  hsp_topology_limits topology_limits; /**< what the topology has room for */
  hsp_view_limits view_limits;         /**< what the view has room for (hardsphere/view.h) */
  hsp_surface_limits surface_limits;   /**< what the surface has room for (hardsphere/surface.h) */
  hsp_mesh_limits mesh_limits;         /**< what the mesh has room for (hardsphere/mesh.h) */
  hsp_map_limits map_limits;           /**< what the map has room for (hardsphere/map.h) */
  hsp_contacts_limits contacts_limits; /**< what the contacts have room for */
  hsp_cells_limits cells_limits;       /**< what the cells have room for (hardsphere/cells.h) */
  hsp_paths_limits paths_limits;       /**< what the paths have room for (hardsphere/paths.h) */
  hsp_gate_limits gate_limits;         /**< what the gate has room for (hardsphere/paths.h) */
  hsp_moving_limits moving_limits;     /**< what the balls that move have room for */
} hsp_workspace;

/* Memory of another size, without its contents. */
static inline int32_t hsp_workspace_allocate(void **memory, size_t bytes) {
  free(*memory);
  *memory = malloc(bytes);
  return *memory != NULL ? HSP_OK : HSP_E_MEMORY;
}

/* Handles of the current limits, without results. */
static inline int32_t hsp_workspace_make_boundary(hsp_workspace *work) {
  size_t bytes = 0;
  int32_t status = hsp_boundary_bytes(&work->boundary_limits, &bytes);
  work->boundary = NULL;
  if (status == HSP_OK) status = hsp_workspace_allocate(&work->memory[1], bytes);
  if (status == HSP_OK) {
    status = hsp_boundary_init(work->memory[1], bytes, &work->boundary_limits, &work->boundary);
  }
  return status;
}

static inline int32_t hsp_workspace_make_topology(hsp_workspace *work) {
  size_t bytes = 0;
  int32_t status = hsp_topology_bytes(&work->topology_limits, &bytes);
  work->topology = NULL;
  if (status == HSP_OK) status = hsp_workspace_allocate(&work->memory[2], bytes);
  if (status == HSP_OK) {
    status = hsp_topology_init(work->memory[2], bytes, &work->topology_limits, &work->topology);
  }
  return status;
}

/* ---- view.h ---- */

static inline int32_t hsp_workspace_make_view(hsp_workspace *work) {
  size_t bytes = 0;
  int32_t status = hsp_view_bytes(&work->view_limits, &bytes);
  work->view = NULL;
  if (status == HSP_OK) status = hsp_workspace_allocate(&work->memory[3], bytes);
  if (status == HSP_OK) status = hsp_view_init(work->memory[3], bytes, &work->view_limits, &work->view);
  return status;
}

/* ---- surface.h ---- */

static inline int32_t hsp_workspace_make_surface(hsp_workspace *work) {
  size_t bytes = 0;
  int32_t status = hsp_surface_bytes(&work->surface_limits, &bytes);
  work->surface = NULL;
  if (status == HSP_OK) status = hsp_workspace_allocate(&work->memory[4], bytes);
  if (status == HSP_OK) status = hsp_surface_init(work->memory[4], bytes, &work->surface_limits, &work->surface);
  return status;
}

/* ---- mesh.h ---- */

static inline int32_t hsp_workspace_make_mesh(hsp_workspace *work) {
  size_t bytes = 0;
  int32_t status = hsp_mesh_bytes(&work->mesh_limits, &bytes);
  work->mesh = NULL;
  if (status == HSP_OK) status = hsp_workspace_allocate(&work->memory[5], bytes);
  if (status == HSP_OK) status = hsp_mesh_init(work->memory[5], bytes, &work->mesh_limits, &work->mesh);
  return status;
}

/* ---- map.h ---- */

static inline int32_t hsp_workspace_make_map(hsp_workspace *work) {
  size_t bytes = 0;
  int32_t status = hsp_map_bytes(&work->map_limits, &bytes);
  work->map = NULL;
  if (status == HSP_OK) status = hsp_workspace_allocate(&work->memory[6], bytes);
  if (status == HSP_OK) status = hsp_map_init(work->memory[6], bytes, &work->map_limits, &work->map);
  return status;
}

/* ---- contacts.h ---- */

static inline int32_t hsp_workspace_make_contacts(hsp_workspace *work) {
  size_t bytes = 0;
  int32_t status = hsp_contacts_bytes(&work->contacts_limits, &bytes);
  work->contacts = NULL;
  if (status == HSP_OK) status = hsp_workspace_allocate(&work->memory[7], bytes);
  if (status == HSP_OK) {
    status = hsp_contacts_init(work->memory[7], bytes, &work->contacts_limits, &work->contacts);
  }
  return status;
}

/* ---- cells.h ---- */

static inline int32_t hsp_workspace_make_cells(hsp_workspace *work) {
  size_t bytes = 0;
  int32_t status = hsp_cells_bytes(&work->cells_limits, &bytes);
  work->cells = NULL;
  if (status == HSP_OK) status = hsp_workspace_allocate(&work->memory[8], bytes);
  if (status == HSP_OK) status = hsp_cells_init(work->memory[8], bytes, &work->cells_limits, &work->cells);
  return status;
}

/* ---- paths.h ---- */

static inline int32_t hsp_workspace_make_paths(hsp_workspace *work) {
  size_t bytes = 0;
  int32_t status = hsp_paths_bytes(&work->paths_limits, &bytes);
  work->paths = NULL;
  if (status == HSP_OK) status = hsp_workspace_allocate(&work->memory[9], bytes);
  if (status == HSP_OK) status = hsp_paths_init(work->memory[9], bytes, &work->paths_limits, &work->paths);
  return status;
}

static inline int32_t hsp_workspace_make_gate(hsp_workspace *work) {
  size_t bytes = 0;
  int32_t status = hsp_gate_bytes(&work->gate_limits, &bytes);
  work->gate = NULL;
  if (status == HSP_OK) status = hsp_workspace_allocate(&work->memory[10], bytes);
  if (status == HSP_OK) status = hsp_gate_init(work->memory[10], bytes, &work->gate_limits, &work->gate);
  return status;
}

/* ---- moving.h ---- */

static inline int32_t hsp_workspace_make_moving(hsp_workspace *work) {
  size_t bytes = 0;
  int32_t status = hsp_moving_bytes(&work->moving_limits, &bytes);
  work->moving = NULL;
  if (status == HSP_OK) status = hsp_workspace_allocate(&work->memory[11], bytes);
  if (status == HSP_OK) status = hsp_moving_init(work->memory[11], bytes, &work->moving_limits, &work->moving);
  return status;
}

/* ---- model.h ---- */

/** Take n balls into the model; arguments and statuses as hsp_model_set. Boundary, topology, view, surface, mesh, map,
 *  contacts, cells, paths and gate hold no results of other balls then; balls that move stay as they are. */
static inline int32_t hsp_workspace_set(hsp_workspace *work, uint32_t n, const double *xyz, const double *radius,
                                        const hsp_model_options *options, uint32_t *first_bad) {
  if (work->model == NULL || n > work->most_balls) {
    size_t bytes = 0;
    int32_t status = hsp_model_bytes(n, &bytes);
    if (status != HSP_OK) return status;
    /* Memory is given back, of the model and then of the boundary: what was computed from them must not look there. */
    work->model = NULL;
    work->most_balls = 0;
    if (work->boundary != NULL) status = hsp_workspace_make_boundary(work);
    if (status == HSP_OK && work->topology != NULL) status = hsp_workspace_make_topology(work);
    if (status == HSP_OK && work->view != NULL) status = hsp_workspace_make_view(work);       /* hardsphere/view.h */
    if (status == HSP_OK && work->surface != NULL) status = hsp_workspace_make_surface(work); /* hardsphere/surface.h */
    if (status == HSP_OK && work->mesh != NULL) status = hsp_workspace_make_mesh(work);       /* hardsphere/mesh.h */
    if (status == HSP_OK && work->map != NULL) status = hsp_workspace_make_map(work);         /* hardsphere/map.h */
    if (status == HSP_OK && work->contacts != NULL) status = hsp_workspace_make_contacts(work);
    if (status == HSP_OK && work->cells != NULL) status = hsp_workspace_make_cells(work); /* hardsphere/cells.h */
    if (status == HSP_OK && work->paths != NULL) status = hsp_workspace_make_paths(work); /* hardsphere/paths.h */
    if (status == HSP_OK && work->gate != NULL) status = hsp_workspace_make_gate(work);   /* hardsphere/paths.h */
    if (status == HSP_OK) status = hsp_workspace_allocate(&work->memory[0], bytes);
    if (status == HSP_OK) status = hsp_model_init(work->memory[0], bytes, n, &work->model);
    if (status != HSP_OK) return status;
    work->most_balls = n;
  }
  return hsp_model_set(work->model, n, xyz, radius, options, first_bad);
}

/** Compute the boundary of the union of the balls. HSP_E_ARGUMENT: no hsp_workspace_set before. */
static inline int32_t hsp_workspace_boundary(hsp_workspace *work) {
  int32_t status = HSP_OK;
  if (work->boundary == NULL) {
    if (work->boundary_limits.struct_size == 0) {
      status = hsp_boundary_limits_init(&work->boundary_limits, sizeof work->boundary_limits, work->most_balls);
    }
    if (status == HSP_OK) status = hsp_workspace_make_boundary(work);
    if (status != HSP_OK) return status;
  }
  /* After success the limits are what was needed; the memory stays as it is. */
  hsp_boundary_limits limits = work->boundary_limits;
  while ((status = hsp_boundary_compute(work->boundary, work->model, &limits)) == HSP_E_CAPACITY) {
    work->boundary_limits = limits;
    /* The same where the boundary's memory is given back. */
    status = work->topology != NULL ? hsp_workspace_make_topology(work) : HSP_OK;
    if (status == HSP_OK && work->surface != NULL) status = hsp_workspace_make_surface(work); /* hardsphere/surface.h */
    if (status == HSP_OK && work->mesh != NULL) status = hsp_workspace_make_mesh(work);       /* hardsphere/mesh.h */
    if (status == HSP_OK && work->contacts != NULL) status = hsp_workspace_make_contacts(work);
    if (status == HSP_OK) status = hsp_workspace_make_boundary(work);
    if (status != HSP_OK) return status;
  }
  return status;
}

/** Compute the topology of the boundary that hsp_workspace_boundary has computed. */
static inline int32_t hsp_workspace_topology(hsp_workspace *work) {
  int32_t status = HSP_OK;
  if (work->topology == NULL) {
    if (work->topology_limits.struct_size == 0) {
      status = hsp_topology_limits_init(&work->topology_limits, sizeof work->topology_limits, work->boundary);
    }
    if (status == HSP_OK) status = hsp_workspace_make_topology(work);
    if (status != HSP_OK) return status;
  }
  hsp_topology_limits limits = work->topology_limits;
  while ((status = hsp_topology_compute(work->topology, work->boundary, &limits)) == HSP_E_CAPACITY) {
    work->topology_limits = limits;
    status = hsp_workspace_make_topology(work);
    if (status != HSP_OK) return status;
  }
  return status;
}

/* ---- view.h ---- */

/** Compute a view, of the model alone or, with use_boundary not 0, of the boundary that hsp_workspace_boundary has
 *  computed. options as for hsp_view_compute. HSP_E_ARGUMENT: no hsp_workspace_set before, or no hsp_workspace_boundary
 *  whose result is asked for. */
static inline int32_t hsp_workspace_view(hsp_workspace *work, int use_boundary, const hsp_view_options *options) {
  int32_t status = HSP_OK;
  if (work->view == NULL) {
    if (work->view_limits.struct_size == 0) {
      status = hsp_view_limits_init(&work->view_limits, sizeof work->view_limits, work->most_balls);
    }
    if (status == HSP_OK) status = hsp_workspace_make_view(work);
    if (status != HSP_OK) return status;
  }
  const hsp_boundary *boundary = use_boundary != 0 ? work->boundary : NULL;
  if (use_boundary != 0 && boundary == NULL) return hsp_view_compute(work->view, NULL, NULL, options, NULL);
  hsp_view_limits limits = work->view_limits;
  while ((status = hsp_view_compute(work->view, work->model, boundary, options, &limits)) == HSP_E_CAPACITY) {
    work->view_limits = limits;
    status = hsp_workspace_make_view(work);
    if (status != HSP_OK) return status;
  }
  return status;
}

/* ---- map.h ---- */

/** Compute the visibility map of the model. options as for hsp_map_compute. */
static inline int32_t hsp_workspace_map(hsp_workspace *work, const hsp_view_options *options) {
  int32_t status = HSP_OK;
  if (work->map == NULL) {
    if (work->map_limits.struct_size == 0) {
      status = hsp_map_limits_init(&work->map_limits, sizeof work->map_limits, work->most_balls);
    }
    if (status == HSP_OK) status = hsp_workspace_make_map(work);
    if (status != HSP_OK) return status;
  }
  hsp_map_limits limits = work->map_limits;
  while ((status = hsp_map_compute(work->map, work->model, options, &limits)) == HSP_E_CAPACITY) {
    work->map_limits = limits;
    status = hsp_workspace_make_map(work);
    if (status != HSP_OK) return status;
  }
  return status;
}

/* ---- contacts.h ---- */

/** Compute the contacts of the balls of the boundary that hsp_workspace_boundary has computed. */
static inline int32_t hsp_workspace_contacts(hsp_workspace *work) {
  int32_t status = HSP_OK;
  if (work->contacts == NULL) {
    if (work->contacts_limits.struct_size == 0) {
      status = hsp_contacts_limits_init(&work->contacts_limits, sizeof work->contacts_limits, work->boundary);
    }
    if (status == HSP_OK) status = hsp_workspace_make_contacts(work);
    if (status != HSP_OK) return status;
  }
  hsp_contacts_limits limits = work->contacts_limits;
  while ((status = hsp_contacts_compute(work->contacts, work->boundary, &limits)) == HSP_E_CAPACITY) {
    work->contacts_limits = limits;
    status = hsp_workspace_make_contacts(work);
    if (status != HSP_OK) return status;
  }
  return status;
}

/* ---- cells.h ---- */

/** Cut the free space of the model into cells. */
static inline int32_t hsp_workspace_cells(hsp_workspace *work) {
  int32_t status = HSP_OK;
  if (work->cells == NULL) {
    if (work->cells_limits.struct_size == 0) {
      status = hsp_cells_limits_init(&work->cells_limits, sizeof work->cells_limits, work->most_balls);
    }
    if (status == HSP_OK) status = hsp_workspace_make_cells(work);
    if (status != HSP_OK) return status;
  }
  hsp_cells_limits limits = work->cells_limits;
  while ((status = hsp_cells_compute(work->cells, work->model, &limits)) == HSP_E_CAPACITY) {
    work->cells_limits = limits;
    status = hsp_workspace_make_cells(work);
    if (status != HSP_OK) return status;
  }
  return status;
}

/* ---- paths.h ---- */

/** Find a path from one point to another, both [3], through the free space of the model; arguments and statuses as
 *  hsp_paths_find. What only depends on the model is computed the first time. */
static inline int32_t hsp_workspace_path(hsp_workspace *work, const double *from, const double *to, hsp_path *path) {
  int32_t status = HSP_OK;
  if (work->paths == NULL) {
    if (work->paths_limits.struct_size == 0) {
      status = hsp_paths_limits_init(&work->paths_limits, sizeof work->paths_limits, work->most_balls);
    }
    if (status == HSP_OK) status = hsp_workspace_make_paths(work);
    if (status != HSP_OK) return status;
  }
  hsp_paths_limits limits = work->paths_limits;
  for (;;) {
    status = hsp_paths_find(work->paths, from, to, path, &limits);
    if (status == HSP_E_STATE) {
      status = hsp_paths_compute(work->paths, work->model, &limits);
      if (status == HSP_OK) continue;
    }
    if (status != HSP_E_CAPACITY) return status;
    work->paths_limits = limits;
    status = hsp_workspace_make_paths(work);
    if (status != HSP_OK) return status;
  }
}

/** Find the widest probe from one point to another, both [3], or to the outside if `to` is NULL; arguments and statuses
 *  as hsp_gate_compute. */
static inline int32_t hsp_workspace_gate(hsp_workspace *work, const double *from, const double *to) {
  int32_t status = HSP_OK;
  if (work->gate == NULL) {
    if (work->gate_limits.struct_size == 0) {
      status = hsp_gate_limits_init(&work->gate_limits, sizeof work->gate_limits, work->most_balls);
    }
    if (status == HSP_OK) status = hsp_workspace_make_gate(work);
    if (status != HSP_OK) return status;
  }
  hsp_gate_limits limits = work->gate_limits;
  while ((status = hsp_gate_compute(work->gate, work->model, from, to, &limits)) == HSP_E_CAPACITY) {
    work->gate_limits = limits;
    status = hsp_workspace_make_gate(work);
    if (status != HSP_OK) return status;
  }
  return status;
}

/* ---- moving.h ---- */

/** Take the balls of the model as balls that move; arguments and statuses as hsp_moving_set. There is room for 256
 *  neighbours of each at least, or for all balls. */
static inline int32_t hsp_workspace_moving(hsp_workspace *work, const double *sigma, double tension, double pressure,
                                           uint32_t tangency, uint32_t *first_bad) {
  int32_t status = HSP_OK;
  if (work->moving == NULL) {
    if (work->moving_limits.struct_size == 0) {
      status = hsp_moving_limits_init(&work->moving_limits, sizeof work->moving_limits, work->most_balls);
    }
    if (status == HSP_OK) status = hsp_workspace_make_moving(work);
    if (status != HSP_OK) return status;
  }
  hsp_moving_limits limits = work->moving_limits;
  while ((status = hsp_moving_set(work->moving, work->model, sigma, tension, pressure, tangency, &limits, first_bad)) ==
         HSP_E_CAPACITY) {
    /* Moves need room as well. */
    if (limits.neighbours < 256) limits.neighbours = limits.balls < 256 ? limits.balls : 256;
    work->moving_limits = limits;
    status = hsp_workspace_make_moving(work);
    if (status != HSP_OK) return status;
  }
  return status;
}

/* ---- surface.h ---- */

/** Compute the solvent-excluded surface of shells [count] of the boundary that hsp_workspace_boundary has computed; of
 *  all of it if shells is NULL. */
static inline int32_t hsp_workspace_surface_of(hsp_workspace *work, const uint32_t *shells, uint32_t count) {
  int32_t status = HSP_OK;
  if (work->surface == NULL) {
    if (work->surface_limits.struct_size == 0) {
      status = hsp_surface_limits_init(&work->surface_limits, sizeof work->surface_limits, work->boundary);
    }
    if (status == HSP_OK) status = hsp_workspace_make_surface(work);
    if (status != HSP_OK) return status;
  }
  hsp_surface_limits limits = work->surface_limits;
  for (;;) {
    status = shells == NULL ? hsp_surface_compute(work->surface, work->boundary, &limits)
                            : hsp_surface_compute_shells(work->surface, work->boundary, shells, count, &limits);
    if (status != HSP_E_CAPACITY) return status;
    work->surface_limits = limits;
    status = hsp_workspace_make_surface(work);
    if (status != HSP_OK) return status;
  }
}

/** Compute the solvent-excluded surface over the boundary that hsp_workspace_boundary has computed. */
static inline int32_t hsp_workspace_surface(hsp_workspace *work) {
  return hsp_workspace_surface_of(work, NULL, 0);
}

/* ---- mesh.h ---- */

/* Limits of the mesh that suffice for edges of this length, too. */
static inline int32_t hsp_workspace_raise_mesh_limits(hsp_workspace *work, int use_surface, double edge) {
  hsp_mesh_limits *limits = &work->mesh_limits;
  hsp_mesh_limits wanted;
  const int32_t status = use_surface != 0 ? hsp_mesh_limits_init_surface(&wanted, sizeof wanted, work->surface, edge)
                                          : hsp_mesh_limits_init(&wanted, sizeof wanted, work->boundary, edge);
  if (status != HSP_OK) return status;
  limits->struct_size = wanted.struct_size;
  if (limits->balls < wanted.balls) limits->balls = wanted.balls;
  if (limits->curves < wanted.curves) limits->curves = wanted.curves;
  if (limits->vertices < wanted.vertices) limits->vertices = wanted.vertices;
  if (limits->triangles < wanted.triangles) limits->triangles = wanted.triangles;
  if (limits->points < wanted.points) limits->points = wanted.points;
  return HSP_OK;
}

/** Compute triangles with edges of about the given length, for the boundary that hsp_workspace_boundary has computed
 *  or, with use_surface not 0, for the smooth surface over it that hsp_workspace_surface has computed. */
static inline int32_t hsp_workspace_mesh(hsp_workspace *work, int use_surface, double edge) {
  int32_t status = HSP_OK;
  if (work->mesh == NULL) {
    status = hsp_workspace_raise_mesh_limits(work, use_surface, edge);
    if (status == HSP_OK) status = hsp_workspace_make_mesh(work);
    if (status != HSP_OK) return status;
  }
  for (;;) {
    hsp_mesh_limits limits = work->mesh_limits;
    status = use_surface != 0 ? hsp_mesh_compute_surface(work->mesh, work->surface, edge, &limits)
                              : hsp_mesh_compute(work->mesh, work->boundary, edge, &limits);
    if (status != HSP_E_CAPACITY) return status;
    work->mesh_limits = limits;
    status = hsp_workspace_raise_mesh_limits(work, use_surface, edge);
    if (status == HSP_OK) status = hsp_workspace_make_mesh(work);
    if (status != HSP_OK) return status;
  }
}

/* ---- model.h ---- */

/** Give all memory back; the workspace is as at first. */
static inline void hsp_workspace_free(hsp_workspace *work) {
  for (int i = 0; i < 12; ++i) free(work->memory[i]);
  memset(work, 0, sizeof *work);
}

#endif
