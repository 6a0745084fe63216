/* hardsphere measure --trajectory RUN --mean: means over the frames. */
#pragma once

#include <stdbool.h>

#include "commands/request.h"
#include "read/failure.h"
#include "read/molecule.h"
#include "read/text_buffer.h"
#include "write/record.h"

/* For each number that `measure` finds in a frame: its mean over the frames, standard deviation, least and largest
 * value; for balls, residues, chains and groups the mean area and its deviation. The output is the same for any number
 * of threads. *largest_rounding: as command_frames. */
bool measure_mean(const struct request *request, const struct molecule *molecule, struct text_buffer *out,
                  double *largest_rounding, struct failure *failure);

/* As describe_measure (commands.h), for means. */
void measure_mean_describe(const struct request *request, struct record *record);
