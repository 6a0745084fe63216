/* The request of a user. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "commands/drawing_request.h"
#include "commands/frame_range.h"
#include "commands/meshing.h"
#include "commands/periodic_box.h"
#include "commands/viewing.h"
#include "read/file_choice.h"
#include "read/file_format.h"
#include "read/radii.h"
#include "read/radii_table.h"
#include "read/residues.h"
#include "read/selection.h"
#include "read/text_buffer.h"

/* In the order of the help. */
enum command {
  COMMAND_MODEL,
  COMMAND_BOUNDARY,
  COMMAND_MEASURE,
  COMMAND_VOIDS,
  COMMAND_CONTACTS,
  COMMAND_COMPLEX,
  COMMAND_CELLS,
  COMMAND_PATH,
  COMMAND_GATE,
  COMMAND_PORES,
  COMMAND_CLASH,
  COMMAND_QUERY,
  COMMAND_MESH,
  COMMAND_MAP,
  COMMAND_PICK,
  COMMAND_DRAW,
  COMMANDS
};

/* A point, or where a void or an atom has most room. */
struct place {
  struct given_vector point; /* given in all cases */
  uint64_t of_void;          /* its rank among those that `voids` lists, from 1 on; 0: it is none */
  uint64_t of_atom;          /* its index among the balls plus 1; 0: it is none */
  uint64_t of_maximum;       /* the same of a maximum of `pores` */
};

enum query_kind { QUERY_NONE, QUERY_POINT, QUERY_BALL };

/* The request of a user. */
struct request {
  enum command command;
  int files;          /* how many are named */
  const char **names; /* [files] */
  const char *file;   /* the one that this request is about; "-": standard input */
  const struct file_format *format;
  bool format_given; /* by --format */
  bool json;
  bool csv;
  bool per_ball; /* of `measure` and `map` */
  bool gradient;
  bool curvature;
  bool polar;
  bool relative;
  int surface;           /* 0: solvent-accessible, 1: solvent-excluded; negative: not said */
  bool excluded_surface; /* measure the solvent-excluded surface instead of the boundary */
  bool outer;            /* of the outer cell alone */
  const char *interface; /* two groups of chains, or NULL */
  bool shells;
  bool void_balls;   /* of `voids` and of pockets */
  double min_volume; /* of `voids` */
  bool cells;        /* of `contacts` */
  double least;      /* area of a contact that is listed */
  bool dark;         /* the page of a picture of `contacts` or `mesh` */
  const char *map;   /* a file for a picture of contacts, or NULL */
  enum grouping by;
  const char *weights;   /* a file, or NULL */
  const char *pdb_out;   /* a file, or NULL */
  double probe;          /* 0 if none was given */
  struct box_choice box; /* of `boundary`, `measure`, `contacts` and `pores` */
  struct file_choice choice;
  bool model_given;
  bool location_given;
  int models;             /* 1: all as one; 0: not said */
  int chains;             /* of .cif, 1: by the authors' names, 2: by the labels'; 0: not said */
  const char *trajectory; /* a file with frames of the molecule, or NULL; of `measure` and `contacts` */
  bool frames_given;
  struct frame_range frames;
  bool mean;               /* over the frames, in place of a row of each; of `measure` */
  const char *index_file;  /* with groups of atoms, or NULL */
  struct index_file index; /* of that file; empty if there is none */
  struct selection part;   /* the atoms that are measured, while all others only block; of `measure` */
  struct selection selection;
  enum query_kind query;
  double position[3];
  double query_radius;
  struct meshing meshing;        /* of `mesh` */
  struct viewing viewing;        /* of `map`, `pick` and `mesh`; of `clash` its rotation */
  struct given_vector translate; /* of `clash` */
  struct given_vector at;        /* of `pick`: x and y */
  struct place from, to;         /* of `path` and `gate` */
  bool gates;                    /* of `pores` */
  bool regions;                  /* likewise: which regions the probe finds, and how large they are */
  double persistence;            /* likewise, of what is listed, at least */
  double pockets;                /* likewise, radius of a probe that does not get there; negative: none are asked for */
  struct place tunnels_from;     /* likewise */
  struct place tunnels_to;       /* likewise; else the outside, in a box a copy of the start */
  uint32_t tunnels;              /* how many from there; 0: it is not said */
  bool cheapest;                 /* those, by cost rather than by width */
  const char *points;            /* a file of their points for viewers, or NULL */
  const char *tunnels_out;       /* a file with the tunnels as programs exchange them, or NULL */
  const char *profile;           /* files for charts of the tunnels and of the classes, or NULL */
  const char *tree;
  struct drawing drawing;     /* of `draw` */
  struct selection highlight; /* likewise */
  const struct radii_set *set;
  const char *radii_file;   /* with radii by residue and atom, or NULL */
  struct radii_table table; /* of that file, or of the set; empty if there is none */
  bool list_radii;          /* show what sets there are, and do nothing else */
  struct radii radii;
  uint32_t threads;             /* 0: as many as the machine has processors */
  struct text_buffer overrides; /* "C=1.7, ZN=1.4": what --radius changed, as the user wrote it */
};

/* Whether a list of the balls is asked for. */
bool request_wants_balls(const struct request *request);

/* Whether the area of each ball is asked for, in whatever form. */
bool request_wants_areas(const struct request *request);

/* Whether places or radii of the balls are asked for once the library has them. */
bool request_wants_places(const struct request *request);

/* Whether there is such a part of the molecule. */
bool request_wants_part(const struct request *request);

/* A file that is written, and the option that says so. */
struct output_choice {
  const char *option;
  const char *path;
  const char *kind; /* of file, as its name says: "an .svg"; NULL: others check it */
};

enum { MOST_OUTPUTS = 8 };

/* The files that are written; how many. */
int request_outputs(const struct request *request, struct output_choice outputs[MOST_OUTPUTS]);

/* Whether writing to a file of this name would write over one that the request names to be read. */
bool request_reads(const struct request *request, const char *path);

/* Whether one of them goes to standard output, where nothing else does then. */
bool request_prints_file(const struct request *request);

/* How many threads may be at work. */
uint32_t request_threads(const struct request *request);

void request_free(struct request *request);
