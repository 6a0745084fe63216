/* The formats of files with molecules and frames: the name, the contents, the unit of length and the readers of each. A
 * format is a file read_<name>.c with a struct file_format, and a line in the table of file_format.c. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "read/failure.h"
#include "read/fields.h"
#include "read/line_reader.h"

struct molecule;
struct trajectory;

/* The contents of the files of a format. */
enum file_feature {
  FILE_RADII = 1,
  FILE_ELEMENTS = 2,
  FILE_RESIDUES = 4,             /* to which residue and chain an atom belongs */
  FILE_HETATM = 8,               /* which atoms are of ligands, ions and water */
  FILE_TEMPERATURE_FACTORS = 16, /* of atoms */
  FILE_CHARGES = 32,             /* of atoms */
  FILE_BONDS = 64,
  FILE_ATOMIC_NUMBERS = 128,   /* in some files, in place of elements */
  FILE_COORDINATE_ITEMS = 256, /* coordinates of several kinds, of which one is read, and perhaps none for some atoms */
  FILE_AREA_COLUMNS = 512,     /* columns to which areas of atoms can be written: --pdb-out */
  FILE_ONE_BOX = 1024,         /* a record of the box for all models behind it */
  FILE_FRAMES = 2048,          /* models that are read one after the other, as frames of a trajectory */
  FILE_ATOMS = 4096,           /* molecules; without it coordinates alone */
  FILE_ORDERS = 8192,          /* bonds with their kinds, of all atoms */
  FILE_LOCATIONS = 1 << 20,    /* atoms at several locations, and biological assemblies */
  FILE_LABEL_CHAINS = 1 << 21, /* two names of a chain, the authors' and the label's */
  FILE_MOLECULES = 1 << 22     /* molecules one after the other, which can be read one by one */
};

/* The state of a search for the molecules of a file, line by line; zeros before the first one. */
struct molecule_lines {
  uint64_t count; /* how many molecules have begun */
  bool open;      /* the last one has not ended */
  bool behind;    /* the line belongs to the next molecule, if there is one */
  bool first;     /* the line belongs to the next molecule, and before the first one to all of them */
  char mark;      /* lines up to one that begins with it are only counted, in `line`; 0: each has to be looked at */
  uint64_t line;  /* the number of a line in the molecule, or how many lines are still to come */
};

struct file_format {
  const char *name;       /* for --format */
  const char *extensions; /* in capitals, without dots, between blanks; digits may follow one that ends in '#' */
  const char *unit;       /* of length: "angstrom", or "unit" if files have any unit */
  const char *sign;       /* of the unit, UTF-8; "" if it has none */
  unsigned features;      /* file_feature */
  const char *nameless;   /* what an atom of unknown element lacks: "no element" */
  /* With FILE_ATOMS: read the model of the file that the molecule asks for, from the first line on. */
  bool (*read)(struct line_reader *reader, struct molecule *molecule, struct failure *failure);
  /* With FILE_ATOMS and FILE_FRAMES: read the next model of a file, or step over it. *begun, false before the first
   * model, is for the reader's use. LINE_END: there is none left. */
  enum line_status (*next)(struct line_reader *reader, bool *begun, bool wanted, struct molecule *molecule,
                           struct failure *failure);
  /* With FILE_MOLECULES: step over a line. True: a new molecule begins with it. */
  bool (*begins)(struct molecule_lines *lines, const struct line_reader *reader);
  /* With FILE_MOLECULES: the title of a molecule, in its text. */
  struct field (*title)(const char *text, size_t length);
  /* Without FILE_ATOMS: read the data before the frames, NULL: there are none; read the next frame, or step over it. */
  bool (*begin)(struct trajectory *trajectory, struct failure *failure);
  enum line_status (*next_frame)(struct trajectory *trajectory, bool wanted, struct failure *failure);
};

#define ANGSTROM .unit = "angstrom", .sign = "\xC3\x85"

enum { MOST_FORMATS = 16 }; /* more than there are */

/* All formats, from 0 on; NULL beyond the last. */
const struct file_format *file_format_at(size_t i);

bool file_format_has(const struct file_format *format, enum file_feature feature);

/* A list of the formats whose files have all of these features, or of those of molecules that lack them: "a, b or c",
 * with `word` before the last one, and the prefix before each. */
#define FORMAT_LIST_BYTES 120
const char *file_format_list(char out[FORMAT_LIST_BYTES], const char *prefix, const char *word, unsigned features,
                             bool has);

/* The format with these features of that name or extension, in any case of its letters; NULL if there is none. */
const struct file_format *file_format_named(const char *name, unsigned features);

/* The part of a file's name after the last dot; "" if there is none. */
const char *file_extension(const char *path);

/* The place of a file name's extension among some names, in any case of its letters; -1: it is none of them. */
int file_extension_among(const char *path, const char *const *names, int count);

/* The format of molecules for a file name's extension; NULL if there is none. */
const struct file_format *file_format_of(const char *path, struct failure *failure);
