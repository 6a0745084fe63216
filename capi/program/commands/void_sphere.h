/* The point of a void with most room: the farthest from all balls, which is the centre of the largest empty sphere. */
#pragma once

#include "commands/void_list.h"

/* The columns in a table of voids. */
extern const char void_columns[];

/* Find that sphere in each void of the list, for a computed topology and the model's probe. A library without pores
 * finds none. False: memory is short, or the library refuses. */
bool void_spheres_find(const struct geometry *geometry, const struct molecule *molecule, double probe,
                       struct void_list *list, struct failure *failure);
