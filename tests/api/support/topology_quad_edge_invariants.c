/* The quad-edge structure as a structure alone: Guibas and Stolfi, "Primitives for the manipulation of general
 * subdivisions", ACM Transactions on Graphics 4 (1985), Section 2, with the header's property numbers. */
#include <stdlib.h>

#include "topology_invariants.h"

static uint32_t rot(uint32_t q) {
  return q - q % 4 + (q + 1) % 4;
}
static uint32_t inverse_rot(uint32_t q) {
  return q - q % 4 + (q + 3) % 4;
}
static uint32_t sym(uint32_t q) {
  return q - q % 4 + (q + 2) % 4;
}

static const char *broken_ranges(const topology_result *t) {
  uint32_t q;
  for (q = 0; q < 4 * t->counts.edges; ++q) {
    if (t->onext[q] >= 4 * t->counts.edges) return "onext of a quarter-edge: no such quarter-edge";
    if (t->origin[q] >= (q % 2 == 0 ? t->counts.vertices : t->counts.simple_faces)) {
      return "origin of a quarter-edge: no such vertex or simple face";
    }
  }
  return NULL;
}

static const char *broken_algebra(const topology_result *t, uint32_t q) {
  const hsp_topology *s = t->topology;
  const uint32_t onext = hsp_topology_onext(s, q), lnext = hsp_topology_lnext(s, q);
  if (HSP_QUAD_ROT(q) != rot(q) || HSP_QUAD_INVERSE_ROT(q) != inverse_rot(q) || HSP_QUAD_SYM(q) != sym(q)) {
    return "rot, inverse_rot and sym are not q = 4 edge + k turned";
  }
  if (onext != t->onext[q] || hsp_topology_origin(s, q) != t->origin[q]) {
    return "hsp_topology_get_quad_edges differs from onext and origin";
  }
  if (onext % 2 != q % 2) return "onext leads from an edge to a dual edge";
  if (rot(t->onext[rot(onext)]) != q) {
    return "onext, property 1: rot(onext(rot(onext(q)))) = q";
  }
  if (HSP_TOPOLOGY_OPREV(s, onext) != q || HSP_TOPOLOGY_LPREV(s, lnext) != q) {
    return "oprev and lprev do not lead back from onext and lnext";
  }
  if (HSP_TOPOLOGY_OPREV(s, q) != rot(t->onext[rot(q)])) return "oprev(q) is not rot(onext(rot(q)))";
  if (HSP_TOPOLOGY_LPREV(s, q) != sym(onext)) return "lprev(q) is not sym(onext(q))";
  if (lnext != rot(t->onext[inverse_rot(q)])) {
    return "lnext, property 1: lnext(q) = rot(onext(inverse_rot(q)))";
  }
  if (t->origin[onext] != t->origin[q]) return "onext, property 2: onext keeps the origin";
  if (hsp_topology_left(s, lnext) != hsp_topology_left(s, q) || t->origin[lnext] != t->origin[sym(q)]) {
    return "lnext, property 2: lnext keeps the left face and goes on at the destination";
  }
  if (hsp_topology_left(s, q) != t->origin[inverse_rot(q)]) {
    return "left, property 1: left(q) is the origin of inverse_rot(q)";
  }
  return NULL;
}

/* Every ring of onext is one vertex (even) or one simple face (odd), and every vertex and simple face is one ring. */
static const char *broken_rings(const topology_result *t) {
  const uint32_t quarters = 4 * t->counts.edges;
  const char *broken = NULL;
  uint32_t q, parity;
  uint8_t *seen = test_zeros(quarters, 1);
  uint32_t *rings[2];
  rings[0] = test_zeros(t->counts.vertices, sizeof **rings);
  rings[1] = test_zeros(t->counts.simple_faces, sizeof **rings);
  for (q = 0; q < quarters && broken == NULL; ++q) {
    uint32_t at = q, length = 0;
    if (seen[q]) continue;
    ++rings[q % 2][t->origin[q]];
    do {
      seen[at] = 1;
      ++length;
      at = t->onext[at];
    } while (at != q && !seen[at]);
    if (at != q) broken = "onext is no permutation: two rings run into each other";
    if (length < 2)
      broken = q % 2 == 0 ? "a vertex with fewer than two edges" : "a simple face with fewer than two edges";
    if (q % 2 == 1 && broken == NULL && t->faces[t->origin[q]].edges != length) {
      broken = "hsp_simple_face: edges is not the length of its loop";
    }
  }
  for (parity = 0; parity < 2 && broken == NULL; ++parity) {
    const uint32_t count = parity == 0 ? t->counts.vertices : t->counts.simple_faces;
    uint32_t i;
    for (i = 0; i < count && broken == NULL; ++i) {
      if (rings[parity][i] != 1) broken = parity == 0 ? "a vertex is not one ring" : "a simple face is not one loop";
    }
  }
  free(seen);
  free(rings[0]);
  free(rings[1]);
  return broken;
}

/* A number that is no quarter-edge leads to HSP_NONE. */
static const char *broken_ends(const topology_result *t) {
  const uint32_t beyond[5] = {4 * t->counts.edges, 4 * t->counts.edges + 1, UINT32_C(0x7FFFFFFE), HSP_NONE - 1,
                              HSP_NONE};
  const hsp_topology *s = t->topology;
  int i;
  for (i = 0; i < 5; ++i) {
    const uint32_t q = beyond[i];
    if (hsp_topology_onext(s, q) != HSP_NONE || HSP_TOPOLOGY_OPREV(s, q) != HSP_NONE ||
        hsp_topology_lnext(s, q) != HSP_NONE || HSP_TOPOLOGY_LPREV(s, q) != HSP_NONE ||
        hsp_topology_origin(s, q) != HSP_NONE || hsp_topology_left(s, q) != HSP_NONE) {
      return "a step from a quarter-edge that there is not";
    }
  }
  return NULL;
}

const char *broken_topology_quad_edges(const topology_result *t) {
  const char *broken = broken_ends(t);
  uint32_t q;
  if (broken == NULL) broken = broken_ranges(t);
  for (q = 0; q < 4 * t->counts.edges && broken == NULL; ++q) broken = broken_algebra(t, q);
  if (broken == NULL) broken = broken_rings(t);
  return broken;
}
