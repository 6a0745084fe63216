/* Pictures of results. Another part of the program draws them, which a build may leave out (HSP_TOOL_DRAW); this header
 * is all that commands use of it. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "commands/request.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"
#include "read/residues.h"
#include "write/mesh_file.h"

/* Contacts: a square for every pair of balls, residues or chains, darker the more area they have in contact. */
struct contact_square {
  uint32_t first, second; /* below rows; each pair once */
  double area;            /* above 0 */
};

struct contact_map {
  const struct molecule *molecule;
  const struct atom_groups *groups; /* with the grouping GROUPING_NONE rows are balls */
  uint32_t rows;
  const struct contact_square *squares; /* [count] */
  uint32_t count;
  bool dark; /* the page */
};

/* The size of the picture of a mesh, how many pockets were found, and how many have colours; UINT32_MAX without
 * --pockets. */
struct mesh_drawn {
  uint64_t bytes;
  uint32_t pockets, coloured;
};

struct pores_found;
struct followed;

/* Each function writes a file. In a program without this part it is NULL, and options that ask for it are refused. */
struct pictures {
  bool (*contacts)(const struct contact_map *map, const char *path, struct failure *failure);
  /* Also splits triangles of the mesh where colours change. */
  bool (*mesh)(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
               struct triangle_mesh *mesh, struct mesh_drawn *drawn, struct failure *failure);
  bool (*tunnels)(const struct pores_found *found, const struct molecule *molecule, const char *path,
                  struct failure *failure);
  bool (*classes)(const struct pores_found *found, const struct molecule *molecule, const char *path,
                  struct failure *failure);
  bool (*volumes)(const struct followed *followed, const struct molecule *molecule, const char *noun, const char *path,
                  struct failure *failure);
};

extern const struct pictures pictures;
