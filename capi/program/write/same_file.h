/* Whether two names stand for one file. */
#pragma once

#include <stdbool.h>
#include <sys/stat.h>

/* Whether both are one file or disc; devices that are written to without end, and pipes, are nobody's file. */
bool same_file(const struct stat *a, const struct stat *b);

/* Whether the name stands for standard output: "-" and "/dev/stdout". */
bool output_is_standard(const char *path);

/* Whether writing to `out` would write over the file that is read from `in` ("-": standard input): the same name, or
 * the same file under another name, links included. Devices and pipes are nobody's file. */
bool output_is_input(const char *out, const char *in);

/* Whether two outputs would be written to the same place: one file, by links or the names of its folder, too, whether
 * or not it is there yet, or standard output. */
bool outputs_are_one(const char *a, const char *b);

/* The part of a path up to its last slash, slash included, and a name behind it. NULL: memory is short. */
char *path_beside(const char *path, const char *name);

/* The path that a link leads to, whether or not there is a file; a copy of any other path. NULL, with errno: links
 * that lead nowhere, or short memory. */
char *path_without_links(const char *path);
