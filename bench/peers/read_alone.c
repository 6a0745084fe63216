/* read_alone FILE: reads a molecule as the program does, without radii, and prints how many atoms it has. */
#include <inttypes.h>
#include <stdio.h>

#include "read/file_format.h"
#include "read/read_molecule.h"

int main(int argc, char **argv) {
  struct molecule molecule;
  struct failure failure = {0};
  const struct file_choice choice = FILE_CHOICE_FIRST;
  const struct file_format *format = argc == 2 ? file_format_of(argv[1], &failure) : NULL;
  if (format == NULL) {
    fprintf(stderr, "usage: read_alone FILE\n");
    return 2;
  }
  const bool done = read_molecule(argv[1], format, &choice, KEEP_NO_MORE, &molecule, &failure);
  if (done) {
    printf("%" PRIu32 "\n", molecule.atoms);
  } else {
    failure_print(&failure);
  }
  molecule_free(&molecule);
  return done ? 0 : 1;
}
