#include "read/relative_areas.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

const char relative_areas_source[] =
    "largest area of the residue in Gly-X-Gly, theoretical values of Tien et al., PLoS ONE 8 (2013) e80635";

struct largest_area {
  char name[4];
  double area;
};

static const struct largest_area largest_areas[] = {
    {"ALA", 129}, {"ARG", 274}, {"ASN", 195}, {"ASP", 193}, {"CYS", 167}, {"GLN", 225}, {"GLU", 223},
    {"GLY", 104}, {"HIS", 224}, {"ILE", 197}, {"LEU", 201}, {"LYS", 236}, {"MET", 224}, {"PHE", 240},
    {"PRO", 159}, {"SER", 155}, {"THR", 172}, {"TRP", 285}, {"TYR", 263}, {"VAL", 174}};

double largest_residue_area(const char *name) {
  if (strcmp(name, "MSE") == 0) name = "MET"; /* with selenium for its sulfur */
  for (size_t i = 0; i < sizeof largest_areas / sizeof largest_areas[0]; ++i) {
    if (strcmp(name, largest_areas[i].name) == 0) return largest_areas[i].area;
  }
  return (double)NAN;
}
