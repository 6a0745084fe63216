/* The picture of a mesh that `mesh` writes, as it is asked for. */
#pragma once

#include "commands/pictures.h"

bool mesh_draw(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
               struct triangle_mesh *mesh, struct mesh_drawn *drawn, struct failure *failure);
