#include "usage.h"

#include "hardsphere.h"

static const char overview[] =
    "hardsphere: exact geometry of unions of balls (molecules)\n"
    "\n"
    "  hardsphere model    FILE [options]   how well the balls behave: k, rho, overlaps\n"
    "  hardsphere boundary FILE [options]   the boundary of the union: vertices, arcs, faces, voids\n"
    "  hardsphere measure  FILE [options]   area and volume\n"
    "  hardsphere query    FILE [options]   which balls contain a point or meet a ball\n"
    "  hardsphere COMMAND --help            more about a command\n"
    "  hardsphere --version\n"
    "\n";

static const char files_and_radii[] =
    "FILE is .xyzr (x y z r on each line, in any unit), .pdb, .pqr or .xyz (in angstrom).\n"
    "The first model and the first alternate location of each atom are read, ATOM and HETATM alike.\n"
    "\n"
    "Options, before or after FILE:\n"
    "  --radii bondi|chem3d   radii by element, for .pdb and .xyz; bondi is the default\n"
    "  --radius EL=R,...      add or replace radii of single elements\n"
    "  --probe P              add P to every radius: 1.4 angstrom for water; default 0\n"
    "  --json                 print JSON instead of a table\n";

static const char statuses[] =
    "\n"
    "Exit status: 0 success, 1 bad input, 2 bad usage; then one line on stderr says why, and stdout stays empty.\n";

static const char model_text[] =
    "hardsphere model FILE [options]\n"
    "\n"
    "Prints the figures of Section 2 of Halperin and Overmars, \"Spheres, Molecules, and Hidden Surface Removal\":\n"
    "k, the largest radius over the smallest; rho, the least distance of two centres over the larger of their radii;\n"
    "the largest and the mean number of others that a ball overlaps. By Theorem 2.1 they bound the work.\n"
    "JSON: n, k, rho, max_overlaps, mean_overlaps; k and rho are null where they have no value.\n"
    "\n";

static const char boundary_text[] =
    "hardsphere boundary FILE [options]\n"
    "\n"
    "Counts what the boundary of the union of the balls consists of, exactly, ties and all.\n"
    "JSON: n, vertices, arcs, circles, faces, exposed_balls, shells, components, voids, euler.\n"
    "\n";

static const char measure_text[] =
    "hardsphere measure FILE [--per-ball] [options]\n"
    "\n"
    "Prints the area of the boundary, walls of voids included, and the volume of the union. Without --probe that is\n"
    "the van der Waals surface, with --probe the solvent-accessible surface.\n"
    "  --per-ball             also the free area of every ball\n"
    "JSON: n, area, volume, and with --per-ball balls: [{area}, ...] in the order of the file.\n"
    "\n";

static const char query_text[] =
    "hardsphere query FILE --point X Y Z [options]\n"
    "hardsphere query FILE --ball X Y Z R [options]\n"
    "\n"
    "Lists the balls that contain the point, or that meet the ball. Balls are closed: touching counts.\n"
    "JSON: hits, the indices of the balls in the order of the file, counted from 0, ascending.\n"
    "\n";

void usage_of_program(struct text_buffer *out) {
  text_buffer_add(out, "%s%s%s", overview, files_and_radii, statuses);
}

void usage_of_command(struct text_buffer *out, enum command command) {
  const char *text = model_text;
  switch (command) {
    case COMMAND_MODEL:
      text = model_text;
      break;
    case COMMAND_BOUNDARY:
      text = boundary_text;
      break;
    case COMMAND_MEASURE:
      text = measure_text;
      break;
    case COMMAND_QUERY:
      text = query_text;
      break;
  }
  text_buffer_add(out, "%s%s%s", text, files_and_radii, statuses);
}

void usage_version(struct text_buffer *out) {
  const unsigned long version = hsp_version();
  text_buffer_add(out, "hardsphere %lu.%lu.%lu\n", version / 10000, version / 100 % 100, version % 100);
}
