/* Whether two names stand for one file. */
#ifndef HARDSPHERE_TOOL_SAME_FILE_H
#define HARDSPHERE_TOOL_SAME_FILE_H

#include <stdbool.h>
#include <sys/stat.h>

/* Whether both are one file or disc; devices that are written to without end, and pipes, are nobody's file. */
bool same_file(const struct stat *a, const struct stat *b);

#endif
