#include <hardsphere.h>

size_t host_bytes(uint32_t balls);

size_t host_bytes(uint32_t balls) {
  size_t bytes = 0;
  return hsp_areas_bytes(balls, &bytes) == HSP_OK ? bytes : 0;
}
