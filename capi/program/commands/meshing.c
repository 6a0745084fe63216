#include "commands/meshing.h"

#include <string.h>

#include "read/file_format.h"
#include "write/output_file.h"

static const char *const extensions[] = {"PLY", "OBJ", "STL", "VERT", "SVG"};
enum { FORMATS = sizeof extensions / sizeof extensions[0] };
static const char *const surface_names[] = {"vdw", "sas", "ses"};

/* The format that --triangles asks for, or the name; PLY for what goes to standard output. */
static bool find_format(struct meshing *meshing) {
  if (meshing->format >= 0) return true;
  meshing->format = file_extension_among(meshing->out, extensions, FORMATS);
  if (meshing->format < 0 && output_is_standard(meshing->out)) meshing->format = MESH_PLY;
  return meshing->format >= 0;
}

const char *meshing_surface_name(const struct meshing *meshing) {
  return surface_names[meshing->surface];
}

bool meshing_check(struct meshing *meshing, double probe, bool viewed, struct failure *failure) {
  if (meshing->out == NULL)
    return failure_in_usage(failure, "mesh needs -o OUT, a file .ply, .obj, .stl, .vert or .svg");
  if (!find_format(meshing)) {
    char shown[EXCERPT_BYTES];
    return failure_in_usage(failure, "-o: '%s' is no .ply, .obj, .stl, .vert or .svg file",
                            excerpt(shown, meshing->out, strlen(meshing->out)));
  }
  if (meshing->format == MESH_MSMS && output_is_standard(meshing->out)) {
    return failure_in_usage(failure, "vert makes two files, .vert and .face: they have no place on standard output");
  }
  if (meshing->format != MESH_SVG && (viewed || meshing->cut)) {
    return failure_in_usage(failure, "--view, --up, --rotate and --cut are for a picture, -o OUT.svg");
  }
  if (meshing->surface > MESH_VAN_DER_WAALS && probe == 0.0) {
    return failure_in_usage(failure, "--surface %s needs a probe, --probe 1.4", meshing_surface_name(meshing));
  }
  if (meshing->surface == MESH_VAN_DER_WAALS && probe > 0.0) {
    return failure_in_usage(failure, "--surface vdw is that of the balls alone: it has no use for --probe");
  }
  if (meshing->surface < 0) meshing->surface = probe > 0.0 ? MESH_SOLVENT_ACCESSIBLE : MESH_VAN_DER_WAALS;
  return true;
}
