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
#include "read/selection_groups.h"
#include "read/text_buffer.h"

/* The commands, in the order of the help. */
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

/* All models as one molecule, or one after the other. */
enum { MODELS_MERGED = 1, MODELS_EACH = 2 };

enum rows { ROWS_NONE, ROWS_OF_CSV, ROWS_FOR_PERSONS };

/* A point, given by its coordinates, or as the point of a void, an atom or a maximum with most room. */
struct place {
  struct given_vector point; /* given in all cases */
  uint64_t of_void;          /* the void's rank in the list of `voids`, from 1 on; 0: no void */
  uint64_t of_atom;          /* the atom's index among the balls plus 1; 0: no atom */
  uint64_t of_maximum;       /* the index of a maximum of `pores` plus 1; 0: no maximum */
};

/* ---- one struct for each command: the choices that only it has ---- */

struct boundary_request {
  bool shells; /* list them in any case */
};

struct measure_request {
  bool per_ball;
  bool gradient;
  bool curvature;
  bool polar;
  bool relative;
  int surface;           /* 0: solvent-accessible, 1: solvent-excluded; negative: not given */
  bool outer;            /* measure only the outer cell */
  bool mean;             /* means over the frames in place of a row for each */
  const char *pdb_out;   /* a file, or NULL */
  struct selection part; /* the atoms that are measured; all others only block */
  struct selection_groups interface;
};

/* A number that is not given is not finite. */
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
  struct selection_groups between;
  double least;    /* the least area of a contact that is listed */
  const char *map; /* a file for a picture of contacts, or NULL */
  bool dark;       /* the picture has a dark page */
};

/* The choices of `path` and `gate`. */
struct way_request {
  struct place from, to;
};

struct pores_request {
  bool balls; /* list those of pockets and bottlenecks */
  bool gates;
  bool regions;              /* list the regions that the probe finds, with their sizes */
  double persistence;        /* the least persistence of what is listed */
  double pockets;            /* list pockets that a probe of this radius does not reach; negative: none */
  double min_volume;         /* the least volume of pockets that are listed */
  struct place tunnels_from; /* the start of tunnels */
  struct place tunnels_to;   /* their end; if it is not given, the outside, or in a box a copy of the start */
  uint32_t tunnels;          /* how many; 0: not given */
  bool cheapest;             /* the cheapest tunnels rather than the widest */
  const char *points;        /* a file of points for viewers, or NULL */
  const char *tunnels_out;   /* a file with the tunnels as programs exchange them, or NULL */
  const char *profile;       /* files for charts of the tunnels and of the classes, or NULL */
  const char *tree;
};

struct clash_request {
  struct given_vector rotate, translate; /* how the second molecule is moved */
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

/* The request of a user: choices for all commands, for several commands, and for the command that is named. The choices
 * of all other commands are as if nothing were given. */
struct request {
  enum command command;
  int files;          /* how many are named */
  const char **names; /* [files] */
  const char *file;   /* the file of this request; "-": standard input */
  const struct file_format *format;
  bool format_given; /* by --format */
  bool json;
  double probe; /* 0 if none was given */
  struct file_choice choice;
  bool model_given;
  bool location_given;
  int models; /* MODELS_MERGED, MODELS_EACH; 0: not given */
  bool rows_given;
  enum rows rows;          /* a row for each file or molecule in place of a full report */
  int chains;              /* in .cif files 1: the authors' names, 2: those of labels; 0: not given */
  const char *index_file;  /* a file with groups of atoms, or NULL */
  struct index_file index; /* of that file; empty if there is none */
  struct selection selection;
  const struct radii_set *set;
  const char *radii_file;   /* a file with radii by residue and atom, or NULL */
  struct radii_table table; /* of that file, or of the set; empty if there is none */
  bool list_radii;          /* list the sets of radii, and do nothing else */
  struct radii radii;
  struct text_buffer overrides; /* "C=1.7, ZN=1.4": what --radius changed, as the user wrote it */
  uint32_t threads;             /* 0: as many as the machine has processors */
  double timeout;               /* in seconds; below 0 if there is none */

  const char *weights;    /* for `measure` and `hessian`: a file of weights of areas, or NULL */
  double window;          /* for these two: the window of radii over which areas are averaged; 0: none */
  bool csv;               /* for commands that list something */
  enum grouping by;       /* for `measure` and `contacts` */
  struct box_choice box;  /* for these two, `boundary` and `pores` */
  const char *trajectory; /* a file with frames of the molecule, or NULL */
  bool frames_given;
  struct frame_range frames;
  const char *plot;       /* for `voids` and `pores`: a file for a chart of volumes by frame, or NULL */
  bool excluded_surface;  /* for `measure` and `mesh`: the solvent-excluded surface in place of the boundary */
  struct viewing viewing; /* for `map`, `pick` and `mesh` */

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

/* Whether a list of the balls is wanted. */
bool request_wants_balls(const struct request *request);

/* Whether the area of each ball is wanted, in any form. */
bool request_wants_areas(const struct request *request);

/* Whether centres or radii of the balls are still needed once the library has copied them. */
bool request_wants_places(const struct request *request);

/* Whether only a part of the molecule is to be measured. */
bool request_wants_part(const struct request *request);

/* A file that is written, and the option that asks for it. */
struct output_choice {
  const char *option;
  const char *path;
  const char *kind; /* the kind of file that its name must state: "an .svg"; NULL: others check it */
};

enum { MOST_OUTPUTS = 8 };

/* List the files that are written. Returns their number. */
int request_outputs(const struct request *request, struct output_choice outputs[MOST_OUTPUTS]);

/* Whether writing to a file of this name would overwrite one that the request reads. */
bool request_reads(const struct request *request, const char *path);

/* Whether one of the files goes to standard output, to which nothing else goes then. */
bool request_prints_file(const struct request *request);

/* The length by which a model's radii are grown: 0 for pores, which are found for every probe. */
double request_grown(const struct request *request);

/* How many threads may be at work. */
uint32_t request_threads(const struct request *request);

void request_free(struct request *request);
