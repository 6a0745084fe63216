#include "commands/meshing.h"

#include <string.h>

#include "read/fields.h"
#include "write/output_file.h"

static const char *const format_names[] = {"ply", "obj", "stl", "vert", "svg"};
static const char *const extensions[] = {"PLY", "OBJ", "STL", "VERT", "SVG"};
enum { FORMATS = sizeof format_names / sizeof format_names[0] };
static const char *const surface_names[] = {"vdw", "sas", "ses"};
enum { SURFACES = sizeof surface_names / sizeof surface_names[0] };

static bool take_file(struct meshing *meshing, struct option_reader *reader, const char *option, const char *value) {
  if (!option_value(reader, option, &value, "a file")) return false;
  if (meshing->out != NULL) return failure_in_usage(reader->failure, "%s is given twice", option);
  meshing->out = value;
  return true;
}

static bool take_choice(struct option_reader *reader, const char *option, const char *value, const char *what,
                        const char *const *names, int count, int *choice) {
  if (!option_value(reader, option, &value, what)) return false;
  if (*choice >= 0) return failure_in_usage(reader->failure, "%s is given twice", option);
  *choice = option_choice(reader, option, value, names, count);
  return *choice >= 0;
}

bool meshing_take_option(struct meshing *meshing, struct option_reader *reader, const char *argument, bool *known) {
  const char *value = NULL;
  *known = true;
  if (option_is(argument, "--output", &value)) return take_file(meshing, reader, "--output", value);
  if (strncmp(argument, "-o", 2) == 0 && argument[2] != '=') { /* -o OUT and -oOUT */
    return take_file(meshing, reader, "-o", argument[2] == '\0' ? NULL : argument + 2);
  }
  if (option_is(argument, "--triangles", &value)) {
    return take_choice(reader, "--triangles", value, "ply, obj, stl, vert or svg", format_names, FORMATS,
                       &meshing->format);
  }
  if (option_is(argument, "--surface", &value)) {
    return take_choice(reader, "--surface", value, "vdw, sas or ses", surface_names, SURFACES, &meshing->surface);
  }
  if (option_is(argument, "--edge", &value)) {
    if (!option_value(reader, "--edge", &value, "a length")) return false;
    if (meshing->edge >= 0.0) return failure_in_usage(reader->failure, "--edge is given twice");
    if (!option_length(reader, "--edge", value, &meshing->edge)) return false;
    return meshing->edge > 0.0 || failure_in_usage(reader->failure, "--edge must be above 0");
  }
  if (strcmp(argument, "--cut") == 0) {
    meshing->cut = true;
    return true;
  }
  *known = false;
  return true;
}

/* The format that --triangles asks for, or the name; PLY for what goes to standard output. */
static bool find_format(struct meshing *meshing) {
  if (meshing->format >= 0) return true;
  const char *slash = strrchr(meshing->out, '/');
  const char *dot = strrchr(slash == NULL ? meshing->out : slash + 1, '.');
  const char *end = dot == NULL ? "" : dot + 1;
  const struct field extension = {end, strlen(end)};
  for (int i = 0; i < FORMATS; ++i) {
    if (!field_is(extension, extensions[i])) continue;
    meshing->format = i;
    return true;
  }
  if (!output_is_standard(meshing->out)) return false;
  meshing->format = MESH_PLY;
  return true;
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
