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
  uint64_t begin, bytes; /* where it is in a frame, and its length */
  double scale;          /* factor of its numbers */
};

/* The data of the file before its frames. Zeros at first. */
struct netcdf {
  bool wide_counts, wide_offsets; /* they have 64 bits */
  uint64_t *dimension;            /* [dimensions], their lengths; 0: the number of frames */
  uint64_t dimensions;
  struct netcdf_field field[NETCDF_USES];
  uint64_t place;        /* in the file */
  bool counted;          /* the file states their number; else frames go on until it ends */
  uint64_t frames;       /* how many are left */
  uint64_t next, stride; /* where the next one begins, and the distance of two beginnings */
};

void netcdf_free(struct netcdf *netcdf);
