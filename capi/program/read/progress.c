#define _POSIX_C_SOURCE 200112L /* isatty, fileno */

#include "read/progress.h"

#include <stdio.h>
#include <unistd.h>

/* The width of the widest text: each text covers the one before. */
enum { WIDTH = 60 };

static bool quiet;

void progress_be_quiet(void) {
  quiet = true;
}

struct progress progress_begin(uint64_t amount, uint64_t least) {
  return (struct progress){!quiet && amount >= least && isatty(fileno(stderr)) == 1};
}

void progress_show(const struct progress *progress, const char *text) {
  if (progress->watched) fprintf(stderr, "\r%-*.*s", (int)WIDTH, (int)WIDTH, text);
}

void progress_show_bytes(const struct progress *progress, const char *text, uint64_t bytes) {
  char shown[WIDTH + 1];
  snprintf(shown, sizeof shown, "%s: %.1f MB", text, (double)bytes / 1e6);
  progress_show(progress, shown);
}

void progress_end(const struct progress *progress) {
  if (progress->watched) fprintf(stderr, "\r%-*s\r", (int)WIDTH, "");
}
