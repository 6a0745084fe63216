/* The place of an output file's bytes until the run keeps the file. new_file.c writes them to a new file beside the old
 * one. On systems without signals and owners of files, as Windows and WebAssembly with WASI, new_file_in_place.c writes
 * them to the file itself, which stays incomplete if the machine stops in between. */
#pragma once

#include "write/output_file.h"

/* Open the stream of a file whose path is not standard output. False: errno or the file's `reason` says why not. */
bool new_file_open(struct output_file *file);

/* Remove the file that was begun; its stream is closed. */
void new_file_drop(struct output_file *file);
