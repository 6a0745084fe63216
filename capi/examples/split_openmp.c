/* One boundary computed, measured and differentiated by the threads of OpenMP.
 *   split_openmp FILE.xyzr [WORKERS]       x y z r on each line */
#include "split_work.h"

static int32_t compute(struct molecule *m, uint32_t workers, hsp_totals *totals, hsp_energy *energy) {
  uint32_t stages = 0;
  int32_t status = hsp_boundary_begin(m->boundary, m->model, workers, &stages);
  if (status != HSP_OK) return status;
  for (uint32_t stage = 0; stage < stages; ++stage) {
    /* At the end of the loop all threads wait for each other. */
#pragma omp parallel for schedule(dynamic)
    for (int worker = 0; worker < (int)workers; ++worker) hsp_boundary_work(m->boundary, stage, (uint32_t)worker);
  }
  status = hsp_boundary_end(m->boundary, &m->limits);
  if (status != HSP_OK) return status;
#pragma omp parallel for schedule(dynamic)
  for (int part = 0; part < (int)workers; ++part) measure_part(m, (uint32_t)part, workers);
  return end_measuring(m, totals, energy);
}

int main(int count, char **arguments) {
  static struct molecule molecule;
  hsp_totals totals;
  hsp_energy energy;
  const unsigned long workers = count == 3 ? strtoul(arguments[2], NULL, 10) : 16;
  if (count < 2 || count > 3 || workers < 1 || workers > HSP_MAX_WORKERS) {
    fprintf(stderr, "usage: split_openmp FILE.xyzr [WORKERS]\n");
    return 2;
  }
  int done = read_balls(arguments[1], &molecule.balls);
  if (done) {
    int32_t status = make_molecule(&molecule, (uint32_t)workers);
    if (status == HSP_OK) {
      while ((status = compute(&molecule, (uint32_t)workers, &totals, &energy)) == HSP_E_CAPACITY) {
        if ((status = make_boundary(&molecule)) != HSP_OK) break;
      }
    }
    if (status == HSP_OK) status = compare_with_one(&molecule, &totals, &energy);
    if (status != HSP_OK) fprintf(stderr, "split_openmp: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  free_molecule(&molecule);
  return done ? 0 : 1;
}
