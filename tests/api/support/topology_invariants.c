#include "topology_invariants.h"

const char *broken_topology(const topology_result *t) {
  const char *broken = broken_topology_quad_edges(t);
  if (broken == NULL) broken = broken_topology_cuts(t);
  if (broken == NULL) broken = broken_topology_shells(t);
  if (broken == NULL) broken = broken_topology_positions(t);
  if (broken == NULL) broken = broken_topology_face_areas(t);
  if (broken == NULL) broken = broken_topology_start_faces(t);
  return broken;
}
