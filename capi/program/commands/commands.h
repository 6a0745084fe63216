/* What each command does with a molecule: write its results into out, or say in failure why it cannot. */
#ifndef HARDSPHERE_TOOL_COMMANDS_H
#define HARDSPHERE_TOOL_COMMANDS_H

#include <stdbool.h>

#include "app/arguments.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"
#include "read/text_buffer.h"

bool command_model(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure);
bool command_boundary(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct text_buffer *out, struct failure *failure);
bool command_measure(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                     struct text_buffer *out, struct failure *failure);
bool command_voids(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure);
bool command_contacts(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct text_buffer *out, struct failure *failure);
bool command_complex(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                     struct text_buffer *out, struct failure *failure);
bool command_cells(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure);
bool command_path(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure);
bool command_gate(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure);
bool command_query(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure);
bool command_mesh(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure);
bool command_map(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                 struct text_buffer *out, struct failure *failure);
bool command_pick(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure);
bool command_draw(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure);

#endif
