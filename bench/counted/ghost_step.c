/* One step of a parallel code that has ghosts, copies of atoms of neighbouring parts (capi/guide/ghosts.md): model,
 * boundary, areas with their gradient. The step is done twice, for valgrind to count the second one; ghost_step.sh runs
 * the program. There are 3200 atoms of radius 2 in a box of 52 angstrom, in two layers: on the sites of a lattice,
 * moved at random. Ghosts are images of the atoms within REACH of the box. ghost_step REACH own|all    own: only own
 * atoms are selected, all: all balls; prints the number of ghosts */
#include <hardsphere_workspace.h>
#include <stdio.h>
#include <string.h>

enum { OWN = 3200, MOST = 8 * OWN, SITES = 17 };
static const double side = 52.0;

static double x[3 * MOST], r[MOST], area[MOST], gradient[3 * MOST];
static uint8_t selected[MOST];

/* A random shift from -1.2 to 1.2. */
static double moved(void) {
  static uint64_t state = 1;
  state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return 1.2 * ((double)(state >> 40) / 0x1p23 - 1.0);
}

static void place_own_atoms(void) {
  uint32_t own = 0;
  for (int k = 0; k < SITES; ++k) {
    const int is_in_a_layer = k < 2 || k > 12 || (k > 4 && k < 11);
    for (int site = 0; is_in_a_layer && site < SITES * SITES && own < OWN; ++site, ++own) {
      const double at[3] = {site % SITES + 0.5, site / SITES + 0.5, k + 0.23};
      for (uint32_t axis = 0; axis < 3; ++axis) x[3 * own + axis] = at[axis] * side / SITES + moved();
    }
  }
}

/* Adds the ghosts behind the atoms. Returns the number of atoms and ghosts. */
static uint32_t add_ghosts(double reach) {
  uint32_t all = OWN;
  for (int image = 0; image < 27; ++image) {
    const int shift[3] = {image / 9 - 1, image / 3 % 3 - 1, image % 3 - 1};
    for (uint32_t i = 0; image != 13 && i < OWN && all < MOST; ++i) {
      uint32_t is_near = 1;
      for (uint32_t axis = 0; axis < 3; ++axis) {
        const double at = x[3 * all + axis] = x[3 * i + axis] + side * shift[axis];
        is_near = is_near && at > -reach && at < side + reach;
      }
      all += is_near;
    }
  }
  return all;
}

static int32_t set_model(hsp_workspace *work, uint32_t all) {
  hsp_model_options options;
  hsp_model_options_init(&options, sizeof options);
  options.probe = 1.4;
  options.largest_radius = 2;
  return hsp_workspace_set(work, all, x, r, &options, NULL);
}

static int32_t compute_boundary(hsp_workspace *work, uint32_t all) {
  hsp_boundary_request of_own = {.struct_size = sizeof of_own, .selected = selected};
  (void)all;
  return hsp_workspace_boundary_with(work, &of_own);
}

static int32_t find_gradient(hsp_workspace *work, uint32_t all) {
  hsp_gradient_request asked;
  hsp_energy energy;
  hsp_gradient_outputs outputs = {
      .struct_size = sizeof outputs, .capacity = all, .energy = &energy, .d_centre = gradient, .area = area};
  hsp_gradient_request_init(&asked, sizeof asked);
  asked.tension = 0.0072;
  return hsp_boundary_get_gradient(work->boundary, &asked, &outputs);
}

typedef int32_t stage(hsp_workspace *, uint32_t);

/* valgrind knows the stages by this function. */
__attribute__((noinline)) int32_t counted_stage(stage *run, hsp_workspace *work, uint32_t all) {
  const int32_t status = run(work, all);
  __asm__ volatile(""); /* the call above shall not become a jump */
  return status;
}

int main(int argc, char **argv) {
  stage *const stages[3] = {set_model, compute_boundary, find_gradient};
  hsp_workspace work = {0};
  uint32_t all;
  int32_t status = HSP_OK;
  if (argc != 3) return 2;
  place_own_atoms();
  all = add_ghosts(strtod(argv[1], NULL));
  for (uint32_t i = 0; i < all; ++i) {
    r[i] = 2;
    selected[i] = i < OWN || strcmp(argv[2], "all") == 0;
  }
  for (int k = 0; k < 6 && status == HSP_OK; ++k) status = counted_stage(stages[k % 3], &work, all);
  printf("%u\n", all - OWN);
  hsp_workspace_free(&work);
  return status != HSP_OK;
}
