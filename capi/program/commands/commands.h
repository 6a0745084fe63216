/* The work of each command for a molecule: write its results into out, or say in failure why it cannot. */
#pragma once

#include <stdbool.h>

#include "commands/request.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"
#include "read/text_buffer.h"
#include "write/record.h"

typedef bool command_function(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                              struct text_buffer *out, struct failure *failure);

command_function command_model, command_boundary, command_measure, command_voids, command_contacts, command_complex;
command_function command_cells, command_path, command_gate, command_pores, command_query, command_mesh, command_map;
command_function command_pick, command_draw, command_hessian;

/* One of two molecules, with its request. */
struct molecule_request {
  const struct request *request;
  const struct molecule *molecule;
  double *largest_rounding; /* becomes the largest of its models, as in hsp_model_info */
};

/* The same for two molecules: the fixed one and the one that is moved. */
typedef bool command_of_two(const struct molecule_request *fixed, const struct molecule_request *moving,
                            struct text_buffer *out, struct failure *failure);

command_of_two command_clash;

/* The same for the frames of a trajectory; the molecule has all data that frames share. *largest_rounding becomes the
 * largest of all models. */
typedef bool command_of_run(const struct request *request, const struct molecule *molecule, struct text_buffer *out,
                            double *largest_rounding, struct failure *failure);

command_of_run voids_of_run, pores_of_run;

/* Whether options of the command may be combined with each other and with the file. Adds choices that follow from
 * others. */
typedef bool command_check(struct request *request, struct failure *failure);

command_check check_hessian, check_pores, check_mesh, check_draw;

/* Write the keys of JSON that the command has with these options, for help, into a record that takes only keys. */
typedef void command_describe(const struct request *request, struct record *record);

command_describe describe_model, describe_boundary, describe_measure, describe_voids, describe_contacts,
    describe_complex, describe_cells, describe_path, describe_gate, describe_pores, describe_clash, describe_query,
    describe_mesh, describe_map, describe_pick, describe_draw, describe_hessian;
