/* .nc, AMBER's trajectories: a NetCDF file in one of its classic formats, of frames in angstrom. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/byte_reader.h"
#include "read/line_reader.h"

enum netcdf_use { NETCDF_COORDINATES, NETCDF_TIME, NETCDF_LENGTHS, NETCDF_ANGLES, NETCDF_USES };

/* A variable that is read of each frame. */
struct netcdf_field {
  bool there;
  bool wide;             /* doubles, else floats */
  uint64_t begin, bytes; /* in a frame */
  double scale;          /* of its numbers */
};

/* The data of the file before its frames. Zeros at first. */
struct netcdf {
  bool wide_counts, wide_offsets; /* of 64 bits */
  uint64_t *dimension;            /* [dimensions], their lengths; 0: the number of frames */
  uint64_t dimensions;
  struct netcdf_field field[NETCDF_USES];
  uint64_t place;        /* in the file */
  bool counted;          /* else frames go on until the file ends */
  uint64_t frames;       /* that are left */
  uint64_t next, stride; /* where the next one begins, and how far that is from the one before */
};

void netcdf_free(struct netcdf *netcdf);
