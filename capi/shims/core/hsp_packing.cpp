// The packing statistics of a model.
#include "hsp_model.hpp"
#include "model/packing_statistics.hpp"

using namespace hsp::capi;

int32_t hsp_model_get_packing(hsp_model *model, hsp_packing *figures) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(model, figures == nullptr); status != HSP_OK) return status;
  const hsp::PackingStatistics found = hsp::packing_statistics(model->grid);
  *figures = {};
  figures->k = found.k;
  figures->rho = found.rho;
  figures->mean_overlaps = found.mean_overlaps;
  figures->max_overlaps = found.max_overlaps;
  figures->flags = (found.zero_radius ? HSP_PACKING_ZERO_RADIUS : 0) | (found.coincident ? HSP_PACKING_COINCIDENT : 0) |
                   (found.no_pair ? HSP_PACKING_NO_PAIR : 0);
  figures->neighbour_bound = found.neighbour_bound();
  return HSP_OK;
}
