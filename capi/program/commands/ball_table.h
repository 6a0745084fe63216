/* Balls with their areas and derivatives, as a table, JSON or CSV. */
#ifndef HARDSPHERE_TOOL_BALL_TABLE_H
#define HARDSPHERE_TOOL_BALL_TABLE_H

#include "commands/measurement.h"
#include "commands/request.h"
#include "read/molecule.h"
#include "read/text_buffer.h"

void ball_table_print(const struct request *request, const struct molecule *molecule,
                      const struct measurement *measurement, struct text_buffer *out);
void ball_table_csv(const struct molecule *molecule, const struct measurement *measurement, struct text_buffer *out);

/* The list, in brackets, that stands under "balls". */
void ball_table_json(const struct molecule *molecule, const struct measurement *measurement, struct text_buffer *out);

#endif
