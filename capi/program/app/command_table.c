#include "app/command_table.h"

#include <string.h>

/* Commands that need a component of the library, and nothing if the build leaves that out. */
#if !HSP_HAS_SMOOTH
#define SMOOTH(function) NULL
#else
#define SMOOTH(function) function
#endif
#if !HSP_HAS_SPACE
#define SPACE(function) NULL
#else
#define SPACE(function) function
#endif
#if !HSP_HAS_SIGHT
#define SIGHT(function) NULL
#else
#define SIGHT(function) function
#endif

const struct command_row command_table[COMMANDS] = {
    [COMMAND_MODEL] =
        {.name = "model",
         .arguments = "FILE [options]",
         .summary = "how well the balls behave: k, rho, overlaps",
         .run = command_model,
         .text =
             "hardsphere model FILE [options]\n"
             "\n"
             "Prints the figures of Section 2 of Halperin and Overmars, \"Spheres, Molecules, and Hidden Surface "
             "Removal\":\n"
             "k, the largest radius over the smallest; rho, the least distance of two centres over the larger of their "
             "radii;\n"
             "the largest and the mean number of others that a ball overlaps. By Theorem 2.1 they bound the work.\n",
         .closing = "Example: hardsphere model 1crn.pdb --radii chem3d\n"
                    "JSON: n, k, rho, max_overlaps, mean_overlaps; k and rho are null where they have no value.\n"
                    "\n"},
    [COMMAND_BOUNDARY] = {.name = "boundary",
                          .arguments = "FILE [options]",
                          .summary = "the boundary of the union: vertices, arcs, faces, voids",
                          .run = command_boundary,
                          .text = "hardsphere boundary FILE [--shells] [options]\n"
                                  "\n"
                                  "Counts what the boundary of the union of the balls consists of, exactly, ties and "
                                  "all. The shells, the connected\n"
                                  "pieces of the boundary, are listed if there are several.\n",
                          .closing = "Example: hardsphere boundary 1crn.pdb --probe 1.4 --shells\n"
                                     "JSON: n, vertices, arcs, circles, faces, exposed_balls, shells, components, "
                                     "voids, euler, and with --shells\n"
                                     "shell_list: [{kind, component, cell, faces, euler, genus, area, volume}, ...]; "
                                     "kind is \"outer\" or \"void\", volume\n"
                                     "is that of the space enclosed, whatever lies in it.\n"
                                     "\n"},
    [COMMAND_MEASURE] =
        {.name = "measure",
         .arguments = "FILE [options]",
         .summary = "area and volume, in total, by ball, residue or chain, and their gradients",
         .run = command_measure,
         .text = "hardsphere measure FILE [what to print] [options]\n"
                 "\n"
                 "Prints the area of the boundary, walls of voids included, and the volume of the union. Without "
                 "--probe that is\n"
                 "the van der Waals surface, with --probe the solvent-accessible surface. Coordinates and radii are "
                 "rounded first:\n"
                 "to 1e-8 where the largest radius, probe included, is from 1.1 to 10.7.\n",
         .closing =
             "Example: hardsphere measure 4hhb.pdb --no-water --probe 1.4 --by residue --relative\n"
             "JSON: n, area, volume; with --curvature mean_curvature, gauss_curvature; with --weights weighted_area; "
             "with\n"
             "--polar polar_area, apolar_area, other_area; with\n"
             "--surface ses surface: \"ses\", with --outer outer: true, convex_area, saddle_area, concave_area; with\n"
             "--interface interface: {groups: [{atoms, alone, together}, ...], together, buried}; with --per-ball or "
             "--gradient\n"
             "balls: [{ball, atom, element, chain, residue, number, insertion, xyz, radius, area, with --weights "
             "weight, and\n"
             "with --gradient area_gradient: [x, y, z], volume_gradient, area_dr, volume_dr, and with both "
             "weighted_gradient,\n"
             "weighted_dr}, ...] in the order of the file and as far as it names them; with --by residues: [{chain, "
             "name,\n"
             "number, insertion, atoms, area, relative}, ...], chains: [{chain, atoms, area}, ...] or groups: [{name, "
             "atoms, area},\n"
             "...]; with --of measured, how many atoms, and no volume; with --trajectory first frame, time (in ps, or "
             "as .xyz\n"
             "says) and step, null where the file does not tell, and no input; with --mean n, frames, means: "
             "[{quantity, mean,\n"
             "deviation, least, most}, ...], and in lists area is the mean, with deviation behind it.\n"
             "\n"},
    [COMMAND_VOIDS] = {.name = "voids",
                       .arguments = "FILE [options]",
                       .summary = "the cavities in the union and the balls around them",
                       .run = command_voids,
                       .text = "hardsphere voids FILE [--min-volume V] [--balls] [options]\n"
                               "\n"
                               "Lists the cavities that the union encloses, largest volume first: volume, area, the "
                               "point that is farthest from all\n"
                               "balls and its clearance, how far that is, how many balls have a face on it, and how "
                               "many pieces of the union lie\n"
                               "inside. With --probe they are the places where the centre of a probe fits without a "
                               "way out; clearance is what\n"
                               "a probe may grow by there.\n",
                       .closing = "Example: hardsphere voids 1crn.pdb --probe 1.4 --min-volume 0.1\n"
                                  "JSON: n, voids: [{cell, area, volume, components, balls: [...], middle: [x, y, z], "
                                  "point: [x, y, z], clearance,\n"
                                  "clearance_bound}, ...], smaller; cell is its number in the library, components how "
                                  "many pieces of the union lie in\n"
                                  "it, balls their indices in the order of the file, counted from 0, ascending, middle "
                                  "the mean of their centres,\n"
                                  "which may lie in a ball; point lies in the void, by integers, null if it is "
                                  "narrower than the lattice, and no point\n"
                                  "of the void has more clearance; clearance_bound is clearance once more; smaller is "
                                  "how many voids --min-volume\n"
                                  "leaves out.\n"
                                  "\n"},
    [COMMAND_CONTACTS] =
        {.name = "contacts",
         .arguments = "FILE [options]",
         .summary = "which balls, residues or chains touch and by how much, each ball's share",
         .run = command_contacts,
         .text = "hardsphere contacts FILE [--by residue|chain] [--cells] [--least A] [--map OUT.svg] [options]\n"
                 "\n"
                 "Shares the union out among its balls: a point belongs to the share of the ball from which it has "
                 "the least\n"
                 "power, distance^2 - radius^2. Two balls are in contact where their shares meet, in a plane piece; "
                 "its edge is the\n"
                 "length of its border on the surface. The shares sum to the volume of the union.\n",
         .closing = "Example: hardsphere contacts 1crn.pdb --probe 1.4 --by residue --least 5\n"
                    "JSON: n, contacts, area, pairs: [{balls: [i, j], area, edge, distance}, ...], with --by pairs: "
                    "[{residues:\n"
                    "[\"A:THR:1\", \"A:THR:2\"], area, edge, atom_pairs}, ...] or chains: [\"A\", \"B\"]; with --cells "
                    "cells: [{volume, area,\n"
                    "contact}, ...] in the order of the file; without --by or with --cells balls: [{ball, atom, "
                    "element, chain,\n"
                    "residue, number, insertion, xyz, radius}, ...] as far as the file says them.\n"
                    "\n"},
    [COMMAND_COMPLEX] =
        {.name = "complex",
         .arguments = "FILE [options]",
         .summary = "the dual complex: simplices by kind, Betti numbers",
         .run = command_complex,
         .text =
             "hardsphere complex FILE [options]\n"
             "\n"
             "Counts the simplices of the dual complex (Edelsbrunner 1995), exactly, ties and all: one to four balls "
             "whose shares\n"
             "have a common point. It has the holes of the union. A simplex is interior if it shows nothing on the "
             "boundary;\n"
             "else it is singular if it is part of no larger one, triangles if both sides show, and regular if not.\n",
         .closing = "Example: hardsphere complex 1crn.pdb\n"
                    "JSON: n, simplices: {singular: [balls, edges, triangles, tetrahedra], regular: [...], interior: "
                    "[...]}, euler,\n"
                    "betti: [components, tunnels, voids].\n"
                    "\n"},
    [COMMAND_CELLS] =
        {.name = "cells",
         .arguments = "FILE [options]",
         .summary = "free space as simple cells: how many, neighbours, connected regions",
         .component = "space",
         .run = SPACE(command_cells),
         .text = "hardsphere cells FILE [options]\n"
                 "\n"
                 "Cuts what no ball covers into simple cells: in every cube of the grid that balls meet, whose side is "
                 "twice the\n"
                 "largest radius, the points at which one ball has the least power, outside that ball; and runs of "
                 "other cubes.\n"
                 "There are O(n) of them, with O(n) pairs of neighbours. With --probe they are the places where the "
                 "centre of a\n"
                 "probe may be, and a region is where it can go.\n",
         .closing =
             "Example: hardsphere cells 1crn.pdb --probe 1.4\n"
             "JSON: n, cubes, cells, free_cells, adjacencies, regions; cells counts those of all cubes, free or not.\n"
             "\n"},
    [COMMAND_PATH] = {.name = "path",
                      .arguments = "FILE [options]",
                      .summary = "how a probe gets from one point to another",
                      .component = "space",
                      .run = SPACE(command_path),
                      .text = "hardsphere path FILE --from X Y Z --to X Y Z [options]\n"
                              "\n"
                              "Finds a way through what no ball covers, with --probe one for the centre of a probe. "
                              "Whether there is one is\n"
                              "decided in integers, and so is whether any segment of the polyline meets a ball: then "
                              "it is not certified. It is\n"
                              "a short way, but need not be the shortest.\n",
                      .closing = "Example: hardsphere path 1crn.pdb --from 0,0,0 --to 20,20,20 --probe 1.4\n"
                                 "JSON: n, connected, covered, certified, length, clearance, points: [[x, y, z], ...]; "
                                 "covered tells whether an end\n"
                                 "lies in a ball, clearance is the least distance of the way from the balls grown by "
                                 "the probe; length and clearance\n"
                                 "are null where there is no way, clearance also without balls.\n"
                                 "\n"},
    [COMMAND_GATE] = {.name = "gate",
                      .arguments = "FILE [options]",
                      .summary = "the widest probe that gets to a point or to the outside, and what stops it",
                      .component = "space",
                      .run = SPACE(command_gate),
                      .text = "hardsphere gate FILE --from X Y Z|void:K [--to X Y Z|void:K] [options]\n"
                              "\n"
                              "Finds the largest radius of a probe that gets from one point to another between the "
                              "balls, or without --to to the\n"
                              "outside. What stops a wider one are the three balls of the narrowest passage on the "
                              "best way, or one ball if the\n"
                              "probe has less room where it begins or ends.\n",
                      .closing = "Example: hardsphere gate 1crn.pdb --probe 1.4 --from void:1\n"
                                 "JSON: n, passes, widest_probe, gate: [i, j, k], from: [x, y, z], to; passes is false "
                                 "where not even a point gets\n"
                                 "through, then widest_probe is null, as it is without balls; gate holds the indices "
                                 "of the balls in the order of the\n"
                                 "file, counted from 0, ascending; to is null where it is the outside.\n"
                                 "\n"},
    [COMMAND_PORES] =
        {.name = "pores",
         .arguments = "FILE [options]",
         .summary = "pores for every probe at once: cavities, gates, pockets, tunnels",
         .component = "space",
         .run = SPACE(command_pores),
         .check = SPACE(check_pores),
         .text = "hardsphere pores FILE [--gates] [--regions] [--pockets W] [--tunnels-from X Y Z|atom:N] [options]\n"
                 "\n"
                 "Finds all maxima, where a probe between the balls is largest nearby, and all gates, where the parts "
                 "of free space\n"
                 "around them meet as the probe gets narrower. At a gate one class of free space merges into an older "
                 "one, of a\n"
                 "wider maximum: its parent. A probe as wide as a gate does not pass it. Pockets and tunnels are read "
                 "from these.\n"
                 "It is of the molecule alone or, with --box, of a crystal.\n",
         .closing =
             "Example: hardsphere pores 1crn.pdb --probe 1.4 --pockets 3\n"
             "JSON: n, largest_cavity_diameter, null where nothing is enclosed, maxima, gates, merges, cavities, "
             "maximum_list:\n"
             "[{maximum, xyz, radius, death, gate, parent, balls}, ...], gate_list: [{gate, xyz, radius, end, "
             "other_end, merges,\n"
             "balls}, ...], with --pockets pockets, pocket_list: [{pocket, xyz, radius, mouth_radius, maximum, gate, "
             "maxima, volume,\n"
             "area, closed, mouths, balls}, ...], where volume and area are null if closed is 0, with --tunnels-from "
             "from, to,\n"
             "from_radius, tunnels, tunnel_list: [{tunnel, radius, length, cost, gate, gates, points}, ...], "
             "tunnel_points: [{tunnel,\n"
             "length, xyz, radius, gate, maximum, balls}, ...]; maxima and gates by their numbers, counted from 0, or "
             "\"outside\" or\n"
             "\"none\"; mouths are gates; balls are indices in the order of the file, counted from 0, of all balls "
             "that are nearest, of\n"
             "points of tunnels up to four, or that line a pocket.\n"
             "With --box box, box_turned, symmetry, pore_limiting_diameter: [a, b, c] for one, two and three "
             "directions, null where\n"
             "no probe gets through, included_cavity_diameter: [a, b, c] of the channels that do, "
             "pore_limiting_diameter_along: [a,\n"
             "b, c] the three vectors, channel_list: [{radius, maximum, maxima, directions, copies, rows}, ...] for "
             "--probe; gates\n"
             "have end_shift and other_end_shift, by which the maxima are to be moved, and directions, in which their "
             "class goes on;\n"
             "tunnels have shift, the vectors from the point that was named to the copy of it where they end.\n"
             "With --regions accessible_area, accessible_volume, null without a box, blocked_area, blocked_volume, "
             "accessible_regions,\n"
             "blocked_regions, region_list: [{region, xyz, radius, access, area, volume, directions, maxima, "
             "shells, along}, ...];\n"
             "xyz, radius and volume are null outside.\n"
             "\n"},
    [COMMAND_CLASH] =
        {.name = "clash",
         .arguments = "FILE FILE",
         .summary = "a molecule against another one, turned and moved: what meets, and the gap",
         .component = "sight",
         .run_two = SIGHT(command_clash),
         .text = "hardsphere clash FILE FILE [options]\n"
                 "\n"
                 "Tells which balls of the first molecule meet balls of the second one, which is turned and then "
                 "moved. Balls that\n"
                 "touch meet. The gap is the least distance between two balls; it is negative where balls overlap.\n",
         .closing = "Example: hardsphere clash 1crn.pdb caffeine.pdb --rotate 0,90,0 --translate 12,0,3.5\n"
                    "JSON: hit, pairs: [[first, second], ...], gap, nearest: [first, second], overlap_volume, "
                    "nearest_balls: [{ball, ...},\n"
                    "{ball, ...}] with what these are called, fixed: {n, input} and moving: {n, input}; balls by their "
                    "indices in the\n"
                    "order of their files, counted from 0.\n"
                    "\n"},
    [COMMAND_QUERY] = {.name = "query",
                       .arguments = "FILE [options]",
                       .summary = "which balls contain a point or meet a ball",
                       .run = command_query,
                       .text = "hardsphere query FILE --point X Y Z [options]\n"
                               "hardsphere query FILE --ball X Y Z R [options]\n"
                               "\n"
                               "Lists the balls that contain the point, or that meet the ball. Balls are closed: "
                               "touching counts. Here as in every\n"
                               "option numbers may stand between blanks or commas: X Y Z or X,Y,Z.\n",
                       .closing =
                           "Example: hardsphere query 1crn.pdb --ball 10,10,10,1.4\n"
                           "JSON: hits, the indices of the balls in the order of the file, counted from 0, ascending.\n"
                           "\n"},
    [COMMAND_MESH] =
        {.name = "mesh",
         .arguments = "FILE -o OUT",
         .summary = "the surface as triangles: .ply, .obj, .stl, .vert, or a picture: .svg",
         .component = "smooth",
         .run = SMOOTH(command_mesh),
         .check = SMOOTH(check_mesh),
         .text = "hardsphere mesh FILE -o OUT [options]\n"
                 "\n"
                 "Makes triangles of the surface that the balls show: closed, each edge in two of them, "
                 "counter-clockwise seen from\n"
                 "outside. OUT is .ply, .obj, .stl, .vert, or a picture, .svg. With --probe it is the "
                 "solvent-accessible surface, or\n"
                 "the smooth one.\n",
         .closing =
             ".ply has normals, areas and atoms of vertices, a third of the triangles around each, and the kind of "
             "patch, the\n"
             "patch and the atom of triangles, atoms and patches counted from 0; .obj has normals; .stl is binary. "
             "NAME.vert comes\n"
             "with NAME.face, as MSMS writes them, counted from 1.\n"
             "Kinds are 0 convex, 1 saddle, 2 concave, 3 saddle all around; in .face 3 convex, 1 saddle, 2 concave.\n"
             "Example: hardsphere mesh 1crn.pdb --probe 1.4 --surface ses -o 1crn.ply\n"
             "JSON: n, vertices, triangles, edge, triangle_area, bytes, and with --pockets pockets and "
             "coloured_pockets;\n"
             "triangle_area approaches the area of measure.\n"
             "\n"},
    [COMMAND_MAP] =
        {.name = "map",
         .arguments = "FILE [options]",
         .summary = "what is seen from a direction: faces, edges, the visible area of each ball",
         .component = "sight",
         .run = SIGHT(command_map),
         .text = "hardsphere map FILE [options]\n"
                 "\n"
                 "Counts what is seen from a direction: faces, each of which shows one ball or the background, the "
                 "edges between\n"
                 "them, and vertices, where edges end. Areas are those in the view plane. Where balls stand exactly "
                 "behind each\n"
                 "other all are moved a little, and the table says by how much.\n",
         .closing =
             "Example: hardsphere map 1crn.pdb --view 1,0,0 --per-ball\n"
             "JSON: n, vertices, edges, faces, visible_balls, visible_area, moved, balls: [{ball, visible_area}, ...], "
             "those\n"
             "that are seen, by their indices in the order of the file, counted from 0; faces counts the background.\n"
             "\n"},
    [COMMAND_PICK] =
        {.name = "pick",
         .arguments = "FILE --at X,Y",
         .summary = "the ball that is seen at a point",
         .component = "sight",
         .run = SIGHT(command_pick),
         .text = "hardsphere pick FILE --at X,Y [options]\n"
                 "\n"
                 "Names the ball that is seen at a point of the view plane, and how near its surface is there. X is to "
                 "the right, Y\n"
                 "upwards, and depth grows towards the viewer; origin and unit are those of the file.\n",
         .closing =
             "Example: hardsphere pick 1crn.pdb --at 10,12 --view 0,0,1\n"
             "JSON: ball, its index in the order of the file, counted from 0, and depth; null where there is none.\n"
             "\n"},
    [COMMAND_DRAW] = {.name = "draw",
                      .arguments = "FILE -o OUT",
                      .summary = "a picture with hidden parts removed: .svg, .eps or .pdf",
                      .component = "sight",
                      .run = SIGHT(command_draw),
                      .check = SIGHT(check_draw),
                      .text = "hardsphere draw FILE -o OUT [options]\n"
                              "\n"
                              "Draws the balls with hidden parts removed, as true arcs: OUT is .svg, .eps or .pdf.\n",
                      .closing = "The same input gives the same bytes.\n"
                                 "Example: hardsphere draw 4hhb.pdb -o haemoglobin.svg\n"
                                 "JSON: n, pieces, arcs, bytes, with --spin pictures, style, palette, width, height, "
                                 "occlusion; pieces is how many\n"
                                 "balls are painted, arcs how many parts of circles and ellipses bound them (between "
                                 "visible ones each counts once),\n"
                                 "bytes the size of OUT, all three of all pictures together; width and height are in "
                                 "the given unit, occlusion is 0\n"
                                 "where balls are not darkened. With --as ball-and-stick pieces are balls, sticks and "
                                 "halves of sticks, and sticks\n"
                                 "is how many bonds there are.\n"
                                 "\n"},
};

bool command_find(const char *name, enum command *command) {
  for (int each = 0; each < COMMANDS; ++each) {
    if (strcmp(name, command_table[each].name) != 0) continue;
    *command = (enum command)each;
    return true;
  }
  return false;
}

bool component_is_built(const char *component) {
#if !HSP_HAS_SMOOTH
  if (strcmp(component, "smooth") == 0) return false;
#endif
#if !HSP_HAS_SPACE
  if (strcmp(component, "space") == 0) return false;
#endif
#if !HSP_HAS_SIGHT
  if (strcmp(component, "sight") == 0) return false;
#endif
  return component[0] != '\0';
}
