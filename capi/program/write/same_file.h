/* Whether two names stand for one file. */
#pragma once

#include <stdbool.h>
#include <sys/stat.h>

/* Whether both are one file or disc; pipes, and devices to which one can write without end, do not count as files. */
bool same_file(const struct stat *a, const struct stat *b);

/* Whether the name means standard output: "-" and "/dev/stdout". */
bool output_is_standard(const char *path);

/* Whether writing to `out` would overwrite the file that is read from `in` ("-": standard input): the same name, or the
 * same file under another name, links included. Devices and pipes do not count. */
bool output_is_input(const char *out, const char *in);

/* Whether two outputs would be written to the same place: standard output, or one file, whether it exists or not, also
 * if the names differ by links or by the names of its folder. */
bool outputs_are_one(const char *a, const char *b);

/* The part of a path up to its last slash, slash included, with the name behind it. NULL: memory is short. */
char *path_beside(const char *path, const char *name);

/* The path to which a link leads, whether or not there is a file; for any other path a copy. NULL, with errno: links
 * lead nowhere, or memory is short. */
char *path_without_links(const char *path);
