/* Biological assemblies, as files of the Protein Data Bank state them: chains, and the operators that copy them. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "read/failure.h"
#include "read/fields.h"
#include "read/line_reader.h"
#include "read/symmetry.h"
#include "read/text_buffer.h"

struct molecule;

/* An operator; its points are in angstrom. */
struct assembly_operator {
  char name[24];
  struct symmetry_operator to;
};

/* Chains, and the operators that make copies of them. */
struct assembly_part {
  char name[24];                 /* of the assembly, which may have several parts */
  struct text_buffer chains;     /* with commas between them */
  struct text_buffer expression; /* of .cif: "(1-60)(61,62)"; else empty: its operators are */
  size_t first, count;
  size_t looked_at; /* among the chains */
};

/* Zeros at first. */
struct assemblies {
  struct assembly_part *part;
  size_t parts, part_room;
  struct assembly_operator *operators;
  size_t count, room;
  char name[24]; /* in REMARK 350: the assembly of the present line */
  size_t rows;   /* in REMARK 350: rows read of the last operator */
  bool unreadable;
  size_t made; /* by how many operators the chosen assembly is made */
};

/* Take a line of REMARK 350, if it is one. False: memory is short. */
bool assemblies_take_pdb_record(struct assemblies *assemblies, const struct line_reader *reader,
                                struct failure *failure);

/* Take a row of _pdbx_struct_assembly_gen, or one of _pdbx_struct_oper_list: its matrix row by row, and its vector.
 * False: memory is short. */
bool assemblies_add_part(struct assemblies *assemblies, struct field name, struct field expression, struct field chains,
                         struct failure *failure);
bool assemblies_add_operator(struct assemblies *assemblies, struct field name, const struct field number[12],
                             struct failure *failure);

/* Replace the atoms of the molecule by those of the assembly that its choice names: for each operator a copy of the
 * atoms of its chains, in the order of the file. The chains of the second copy have "-2" behind their names, and so on.
 * In .cif files chains are those of label_asym_id. Atoms of other chains are left out. False: there is no such
 * assembly, it cannot be read, or memory is short. */
bool assembly_make(struct molecule *molecule, struct failure *failure);

/* Add "1, 2": the assemblies that differ from what was read, which is all chains as they are in the file. False: memory
 * is short. */
bool assemblies_list_others(struct molecule *molecule, struct text_buffer *out);

void assemblies_free(struct assemblies *assemblies);
