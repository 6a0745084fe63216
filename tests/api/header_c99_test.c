/* The header on its own in C99: included first, twice, and with nothing before it. Static arrays of the size macros
 * serve as memory. */
#include <hardsphere.h>
/* A second time: the guard holds. */
#include <hardsphere.h>

#include "check.h"

static unsigned char model_memory[HSP_MODEL_BYTES(4)];
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(4, 4, 8, 8)];
#if HSP_HAS_SIGHT
static unsigned char view_memory[HSP_VIEW_BYTES(4, 4, 32)];
#endif

int main(void) {
  static const hsp_boundary_limits limits = {sizeof(hsp_boundary_limits), 4, 4, 8, 8, 0};
#if HSP_HAS_SIGHT
  static const hsp_view_limits view_limits = {sizeof(hsp_view_limits), 4, 4, 32};
  hsp_view *view = NULL;
#endif
  hsp_model *model = NULL;
  hsp_boundary *boundary = NULL;
  CHECK_EQUAL(hsp_version(), HSP_VERSION_NUMBER);
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, 4, &model), HSP_OK);
  CHECK(model != NULL);
  CHECK_EQUAL(hsp_boundary_init(boundary_memory, sizeof boundary_memory, &limits, &boundary), HSP_OK);
  CHECK(boundary != NULL);
#if HSP_HAS_SIGHT
  CHECK_EQUAL(hsp_view_init(view_memory, sizeof view_memory, &view_limits, &view), HSP_OK);
  CHECK(view != NULL);
#endif
  return check_report();
}
