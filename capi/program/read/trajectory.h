/* Frames of a trajectory, one after the other, in memory for one of them. */
#ifndef HARDSPHERE_TOOL_TRAJECTORY_H
#define HARDSPHERE_TOOL_TRAJECTORY_H

#include "read/byte_reader.h"
#include "read/line_reader.h"
#include "read/molecule.h"
#include "read/read_dcd.h"
#include "read/read_xtc.h"

struct trajectory;

/* A format of frames alone, in binary: a reader and a row of the table in trajectory.c. */
struct binary_frames {
  const char *name;      /* its extension */
  const char *extension; /* the same in capitals */
  /* Read what stands before the frames; NULL: nothing does. */
  bool (*begin)(struct trajectory *trajectory, struct failure *failure);
  enum line_status (*next)(struct trajectory *trajectory, bool wanted, struct failure *failure);
};

struct trajectory {
  const struct binary_frames *binary; /* NULL: a file of models */
  const struct file_format *models;   /* of such a file */
  const char *path;
  uint32_t atoms;  /* of every frame */
  uint64_t frames; /* read or stepped over */
  double *xyz;     /* [atoms][3], angstrom: the frame read last */
  uint32_t *line;  /* [atoms], where its atoms stand; NULL in binary files */
  struct frame_stamp stamp;
  bool boxed; /* one of the frames so far has a box, or what is none where one belongs */
  /* The rest is this file's. */
  struct line_reader *lines;
  bool begun; /* the next model's first line was read with the last one */
  struct molecule model;
  struct box_record last_box; /* of a .pdb file, where one record is for all models behind it */
  struct byte_reader bytes;
  struct xtc xtc;
  struct dcd dcd;
};

/* The format of the file, by its extension; of standard input that of the molecule. False: no trajectory, and the
 * failure says what would be one. */
bool trajectory_format_of(const char *path, const struct file_format *molecule, struct trajectory *trajectory,
                          struct failure *failure);

/* The extensions of all formats that hold frames, as a person lists them: ".xtc, .trr or .dcd". */
const char *trajectory_format_list(char out[FORMAT_LIST_BYTES]);

/* Open the file, whose format is known, for a molecule of so many atoms. Close it on true and on false. */
bool trajectory_open(struct trajectory *trajectory, const char *path, uint32_t atoms, struct failure *failure);

/* Read the next frame, or step over it: then only the number of its atoms may be checked. LINE_END: there is none.
 * LINE_FAILED: the failure has its number. */
enum line_status trajectory_next(struct trajectory *trajectory, bool wanted, struct failure *failure);

/* Put "frame N: " before the reason of a failure that concerns the frame of this number. Always false. */
bool failure_in_frame(struct failure *failure, uint64_t number);

void trajectory_close(struct trajectory *trajectory);

#endif
