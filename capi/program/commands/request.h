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
  COMMAND_HESSIAN,
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

/* ---- one struct a command: the choices that it has beside those of all ---- */

struct boundary_request {
  bool shells; /* are listed in any case */
};

struct measure_request {
  bool per_ball;
  bool gradient;
  bool curvature;
  bool polar;
  bool relative;
  int surface;           /* 0: solvent-accessible, 1: solvent-excluded; negative: not said */
  bool outer;            /* of the outer cell alone */
  bool mean;             /* over the frames, in place of a row of each */
  const char *interface; /* two groups of chains, or NULL */
  const char *pdb_out;   /* a file, or NULL */
  struct selection part; /* the atoms that are measured, while all others only block */
};

/* Neither is finite where it is not given. */
struct hessian_request {
  double tension;  /* of the area */
  double pressure; /* of the volume */
};

struct voids_request {
  bool balls; /* are listed */
  double min_volume;
};

struct contacts_request {
  bool cells;
  double least;    /* area of a contact that is listed */
  const char *map; /* a file for a picture of contacts, or NULL */
  bool dark;       /* its page */
};

/* Of `path` and `gate`. */
struct way_request {
  struct place from, to;
};

struct pores_request {
  bool balls; /* of pockets and bottlenecks */
  bool gates;
  bool regions;              /* which the probe finds, and how large they are */
  double persistence;        /* of what is listed, at least */
  double pockets;            /* radius of a probe that does not get there; negative: none are asked for */
  double min_volume;         /* of those that are listed */
  struct place tunnels_from; /* a way out from there */
  struct place tunnels_to;   /* else the outside, in a box a copy of the start */
  uint32_t tunnels;          /* how many; 0: it is not said */
  bool cheapest;             /* those, by cost rather than by width */
  const char *points;        /* a file of their points for viewers, or NULL */
  const char *tunnels_out;   /* a file with the tunnels as programs exchange them, or NULL */
  const char *profile;       /* files for charts of the tunnels and of the classes, or NULL */
  const char *tree;
};

struct clash_request {
  struct given_vector rotate, translate; /* the second molecule */
};

enum query_kind { QUERY_NONE, QUERY_POINT, QUERY_BALL };

struct query_request {
  enum query_kind kind;
  double position[3];
  double radius;
};

struct map_request {
  bool per_ball;
};

struct pick_request {
  struct given_vector at; /* x and y */
};

/* The request of a user: what is said of all commands, of several, and of the one that is named. The others' are as if
 * nothing were said. */
struct request {
  enum command command;
  int files;          /* how many are named */
  const char **names; /* [files] */
  const char *file;   /* the one that this request is about; "-": standard input */
  const struct file_format *format;
  bool format_given; /* by --format */
  bool json;
  double probe; /* 0 if none was given */
  struct file_choice choice;
  bool model_given;
  bool location_given;
  int models;              /* 1: all as one; 0: not said */
  int chains;              /* of .cif, 1: by the authors' names, 2: by the labels'; 0: not said */
  const char *index_file;  /* with groups of atoms, or NULL */
  struct index_file index; /* of that file; empty if there is none */
  struct selection selection;
  const struct radii_set *set;
  const char *radii_file;   /* with radii by residue and atom, or NULL */
  struct radii_table table; /* of that file, or of the set; empty if there is none */
  bool list_radii;          /* show what sets there are, and do nothing else */
  struct radii radii;
  struct text_buffer overrides; /* "C=1.7, ZN=1.4": what --radius changed, as the user wrote it */
  uint32_t threads;             /* 0: as many as the machine has processors */
  double timeout;               /* in seconds; below 0 if there is none */

  const char *weights;    /* of areas: a file, or NULL; of `measure` and `hessian` */
  double window;          /* of radii, over which areas are averaged; 0: none; likewise */
  bool csv;               /* of those that list something */
  enum grouping by;       /* of `measure` and `contacts` */
  struct box_choice box;  /* likewise, and of `boundary` and `pores` */
  const char *trajectory; /* a file with frames of the molecule, or NULL */
  bool frames_given;
  struct frame_range frames;
  const char *plot;       /* a file for a chart of volumes by frame, or NULL; of `voids` and `pores` */
  bool excluded_surface;  /* it is asked for in place of the boundary; of `measure` and `mesh` */
  struct viewing viewing; /* of `map`, `pick` and `mesh` */

  struct boundary_request boundary;
  struct measure_request measure;
  struct hessian_request hessian;
  struct voids_request voids;
  struct contacts_request contacts;
  struct way_request path, gate;
  struct pores_request pores;
  struct clash_request clash;
  struct query_request query;
  struct meshing meshing;
  struct map_request map;
  struct pick_request pick;
  struct drawing drawing;
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

/* By how much the radii of a model are grown: pores are those of every probe. */
double request_grown(const struct request *request);

/* How many threads may be at work. */
uint32_t request_threads(const struct request *request);

void request_free(struct request *request);
