/* Frames of a trajectory, one after the other: only one is in memory at a time. */
#pragma once

#include "read/byte_reader.h"
#include "read/file_format.h"
#include "read/line_reader.h"
#include "read/molecule.h"
#include "read/read_dcd.h"
#include "read/read_nc.h"
#include "read/read_xtc.h"

struct trajectory {
  const struct file_format *format;
  const char *path;
  uint32_t atoms;  /* of every frame */
  uint64_t frames; /* read or stepped over */
  double *xyz;     /* [atoms][3], angstrom: the frame read last */
  uint32_t *line;  /* [atoms], the lines of its atoms in the file; NULL in binary files */
  struct frame_stamp stamp;
  bool boxed;    /* one of the frames so far states a box, valid or not */
  char location; /* which one counts of an atom's, as in struct file_choice; set it before the file is opened */
  /* Only readers use the rest. */
  struct line_reader *lines;
  bool begun; /* the next model's first line was read with the last one */
  struct molecule model;
  struct box_record last_box; /* of a .pdb file, in which one record is for all models behind it */
  struct byte_reader bytes;
  struct xtc xtc;
  struct dcd dcd;
  struct netcdf netcdf;
};

/* Take the file's format from its extension; standard input has the molecule's format. False: it is no format of
 * trajectories, and the failure names those. */
bool trajectory_format_of(const char *path, const struct file_format *molecule, struct trajectory *trajectory,
                          struct failure *failure);

/* Open the file, whose format is known, for a molecule of that many atoms. Close it on true and on false. */
bool trajectory_open(struct trajectory *trajectory, const char *path, uint32_t atoms, struct failure *failure);

/* Read the next frame, or step over it: then only the number of its atoms may be checked. LINE_END: there is none.
 * LINE_FAILED: the failure has its number. */
enum line_status trajectory_next(struct trajectory *trajectory, bool wanted, struct failure *failure);

/* Put "frame N: " before the reason of a failure that concerns the frame of this number. Always false. */
bool failure_in_frame(struct failure *failure, uint64_t number);

void trajectory_close(struct trajectory *trajectory);
