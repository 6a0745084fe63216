/* hardsphere measure --trajectory RUN --mean: what the frames have in common. */
#pragma once

#include <stdbool.h>

#include "commands/request.h"
#include "read/failure.h"
#include "read/molecule.h"
#include "read/text_buffer.h"
#include "write/record.h"

/* The mean over the frames of all that `measure` finds of each, with its standard deviation, the least and the most;
 * of balls, residues, chains and groups the mean area and its deviation. The same bytes for any number of threads.
 * *largest_rounding as command_frames has it. */
bool measure_mean(const struct request *request, const struct molecule *molecule, struct text_buffer *out,
                  double *largest_rounding, struct failure *failure);

/* As describe_measure (commands.h), of means. */
void measure_mean_describe(const struct request *request, struct record *record);
