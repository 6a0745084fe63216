/* The place of the bytes of an output file until the run keeps it: beside the old file, by new_file.c; or, where there
 * are no signals and owners of files, as on Windows and in WebAssembly with WASI, in its place, by new_file_in_place.c,
 * and a machine that stops in between leaves a part of it. */
#pragma once

#include "write/output_file.h"

/* Open the stream of a file whose path is no standard output. False: errno or the file's own reason says why not. */
bool new_file_open(struct output_file *file);

/* Take away what was begun, whose stream is closed. */
void new_file_drop(struct output_file *file);
