/* A picture of contacts. */
#pragma once

#include "commands/pictures.h"

/* Write it as .svg, symmetric about its diagonal, with an axis and a scale of areas. */
bool contact_map_write(const struct contact_map *map, const char *path, struct failure *failure);
