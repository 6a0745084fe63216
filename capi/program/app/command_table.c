#include "app/command_table.h"

#include <string.h>

#include "commands/pictures.h"
#include "draw/contact_map.h"
#include "draw/mesh_drawing.h"
#include "draw/pores_charts.h"
#include "draw/volumes_chart.h"

/* Functions that need a component of the library or the part of the program that draws, and nothing if the build leaves
 * that out. */
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
#if !HSP_TOOL_DRAW
#define DRAW(function) NULL
#else
#define DRAW(function) function
#endif

const struct pictures pictures = {
    .contacts = DRAW(contact_map_write),
    .mesh = DRAW(SMOOTH(mesh_draw)),
    .tunnels = DRAW(SPACE(pores_write_profile)),
    .classes = DRAW(SPACE(pores_write_tree)),
    .volumes = DRAW(volumes_write),
};

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
         .closing = "Example: hardsphere model 1crn.pdb --radii chem3d\n",
         .json = "JSON: <>; k and rho are null where they have no value.",
         .describe = describe_model},
    [COMMAND_BOUNDARY] = {.name = "boundary",
                          .arguments = "FILE [options]",
                          .summary = "the boundary of the union: vertices, arcs, faces, voids",
                          .run = command_boundary,
                          .text = "hardsphere boundary FILE [--shells] [options]\n"
                                  "\n"
                                  "Counts what the boundary of the union of the balls consists of, exactly, ties and "
                                  "all. The shells, the connected\n"
                                  "pieces of the boundary, are listed if there are several.\n",
                          .closing = "Example: hardsphere boundary 1crn.pdb --probe 1.4 --shells\n",
                          .json = "JSON: <>, and with --shells <--shells>; kind is \"outer\" or \"void\", volume is "
                                  "that of the space enclosed, whatever lies in it.",
                          .describe = describe_boundary},
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
         .closing = "Example: hardsphere measure 4hhb.pdb --no-water --probe 1.4 --by residue --relative\n",
         .json =
             "JSON: <>; with --curvature <--curvature>; with --weights <--weights w>; with --window <--window 1>; with "
             "--polar <--polar>; with "
             "--surface ses <--surface ses>, where surface is \"ses\", and with --outer outer: true; with --interface "
             "<--interface A,B>: {groups: [{atoms, alone, together}, ...], together, buried}, or of more groups than "
             "two "
             "<--interface A,B,C>: {groups: [{group, atoms, alone}, ...], pairs: [{first, second, first_together, "
             "second_together, together, buried}, ...]}; with --per-ball or "
             "--gradient <--gradient --weights w --window 1=balls> in the order of the file and as far as it names "
             "them, weight "
             "with --weights, derivatives with --gradient, those of weighted areas with both, of means with --window; "
             "with --box mass, density, total_area_m2_per_cm3, total_area_m2_per_g, total_volume_fraction and "
             "total_volume_cm3_per_g, as pores --regions has them; with --by <--by residue "
             "--relative>, <--by chain> or <--by group>; with --of <--of water>, how many atoms, and no volume; with "
             "--trajectory first frame, time (in ps, or as .xyz says) and step, null where the file does not tell, and "
             "no input; with --mean n, <--mean..means>, and in lists area is the mean, with deviation behind it.",
         .describe = describe_measure},
    [COMMAND_HESSIAN] =
        {.name = "hessian",
         .arguments = "FILE [options]",
         .summary = "second derivatives of area and volume by all coordinates, as a matrix",
         .run = command_hessian,
         .check = check_hessian,
         .text = "hardsphere hessian FILE --tension T|--pressure P [options]\n"
                 "\n"
                 "Writes the second derivatives of T x area + P x volume by x, y and z of one ball after the other, as "
                 "a sparse\n"
                 "symmetric matrix of Matrix Market, which scipy.io.mmread and others read. Two balls have numbers if "
                 "their\n"
                 "spheres share a free piece of a circle. Comments tell how many balls touch, where derivatives are "
                 "one-sided, and\n"
                 "how many have a vertex in the plane of its three centres, where areas have no second derivatives.\n",
         .closing = "Example: hardsphere hessian 1crn.pdb --probe 1.4 --tension 0.0072 --window 0.1 > 1crn.mtx\n",
         .json = "JSON: <>; window is 0 where there is none; one_sided and singular are the balls of these comments, "
                 "by their indices in the order of the file, counted from 0; the row of ball i has the entries "
                 "first[i] to first[i + 1] - 1, for each the other ball and its block: nine numbers, [xx, xy, xz, yx, "
                 "...], the first letter of ball i.",
         .describe = describe_hessian},
    [COMMAND_VOIDS] = {.name = "voids",
                       .arguments = "FILE [options]",
                       .summary = "the cavities in the union and the balls around them",
                       .run = command_voids,
                       .of_run = voids_of_run,
                       .text = "hardsphere voids FILE [--min-volume V] [--balls] [options]\n"
                               "\n"
                               "Lists the cavities that the union encloses, largest volume first: volume, area, the "
                               "point that is farthest from all\n"
                               "balls and its clearance, how far that is, how many balls have a face on it, and how "
                               "many pieces of the union lie\n"
                               "inside. With --probe they are the places where the centre of a probe fits without a "
                               "way out; clearance is what\n"
                               "a probe may grow by there.\n",
                       .closing = "Example: hardsphere voids 1crn.pdb --probe 1.4 --min-volume 0.1\n",
                       .json =
                           "JSON: <>; cell is its number in the library, components how many pieces of the union lie "
                           "in it, balls their indices in the order of the file, counted from 0, ascending, middle the "
                           "mean of their centres, which may lie in a ball; point lies in the void, by integers, null "
                           "if it is narrower than the lattice, and no point of the void has more clearance; "
                           "clearance_bound is clearance once more; smaller is how many voids --min-volume leaves "
                           "out. With --trajectory first frame, time and step, and no input; void is a number that "
                           "stays, from the one that a void was part of in the frame before, or \"none\", merged "
                           "those that have ended in it.",
                       .describe = describe_voids},
    [COMMAND_CONTACTS] =
        {.name = "contacts",
         .arguments = "FILE [options]",
         .summary = "which balls, residues or chains touch and by how much, each ball's share",
         .run = command_contacts,
         .text = "hardsphere contacts FILE [--by residue|chain] [--between A,B] [--cells] [--least A] [--map OUT.svg] "
                 "[options]\n"
                 "\n"
                 "Shares the union out among its balls: a point belongs to the share of the ball from which it has "
                 "the least\n"
                 "power, distance^2 - radius^2. Two balls are in contact where their shares meet, in a plane piece; "
                 "its rim is the\n"
                 "length of its border on the surface. The shares sum to the volume of the union.\n",
         .closing = "Example: hardsphere contacts 1crn.pdb --probe 1.4 --by residue --least 5\n",
         .json = "JSON: <..pairs>, with --by <--by residue=pairs> or chains: [\"A\", \"B\"], with --between <--between "
                 "A,B=pairs>, "
                 "and with both <--between A,B --by residue=between>, too; edge is rim once more; "
                 "with --cells <--cells=cells> "
                 "in the order of the file; without --by or with --cells <> as far as the file says them.",
         .describe = describe_contacts},
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
         .closing = "Example: hardsphere complex 1crn.pdb\n",
         .json = "JSON: <..simplices>: {singular: [balls, edges, triangles, tetrahedra], regular: [...], interior: "
                 "[...]}, <..betti>: [components, tunnels, voids].",
         .describe = describe_complex},
    [COMMAND_CELLS] =
        {.name = "cells",
         .arguments = "FILE [options]",
         .summary = "free space as simple cells: how many, neighbours, connected regions",
         .part = "space",
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
         .closing = "Example: hardsphere cells 1crn.pdb --probe 1.4\n",
         .json = "JSON: <>; cells counts those of all cubes, free or not.",
         .describe = SPACE(describe_cells)},
    [COMMAND_PATH] = {.name = "path",
                      .arguments = "FILE [options]",
                      .summary = "how a probe gets from one point to another",
                      .part = "space",
                      .run = SPACE(command_path),
                      .text = "hardsphere path FILE --from X Y Z --to X Y Z [options]\n"
                              "\n"
                              "Finds a way through what no ball covers, with --probe one for the centre of a probe. "
                              "Whether there is one is\n"
                              "decided in integers, and so is whether any segment of the polyline meets a ball: then "
                              "it is not certified. It is\n"
                              "a short way, but need not be the shortest.\n",
                      .closing = "Example: hardsphere path 1crn.pdb --from 0,0,0 --to 20,20,20 --probe 1.4\n",
                      .json = "JSON: <>: [[x, y, z], ...]; covered tells whether an end lies in a ball, clearance is "
                              "the least distance of the way from the balls grown by the probe; length and clearance "
                              "are null where there is no way, clearance also without balls.",
                      .describe = SPACE(describe_path)},
    [COMMAND_GATE] =
        {.name = "gate",
         .arguments = "FILE [options]",
         .summary = "the widest probe that gets to a point or to the outside, and what stops it",
         .part = "space",
         .run = SPACE(command_gate),
         .text = "hardsphere gate FILE --from X Y Z|void:K [--to X Y Z|void:K] [options]\n"
                 "\n"
                 "Finds the largest radius of a probe that gets from one point to another between the "
                 "balls, or without --to to the\n"
                 "outside. What stops a wider one are the three balls of the narrowest passage on the "
                 "best way, or one ball if the\n"
                 "probe has less room where it begins or ends.\n",
         .closing = "Example: hardsphere gate 1crn.pdb --probe 1.4 --from void:1\n",
         .json = "JSON: <..gate>: [i, j, k], <..from>: [x, y, z], <>; passes is false where not even a point gets "
                 "through, then widest_probe is null, as it is without balls; gate holds the indices of the balls in "
                 "the order of the file, counted from 0, ascending; to is null where it is the outside.",
         .describe = SPACE(describe_gate)},
    [COMMAND_PORES] =
        {.name = "pores",
         .arguments = "FILE [options]",
         .summary = "pores for every probe at once: cavities, gates, pockets, tunnels",
         .part = "space",
         .run = SPACE(command_pores),
         .of_run = SPACE(pores_of_run),
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
         .closing = "Example: hardsphere pores 1crn.pdb --probe 1.4 --pockets 3\n",
         .json =
             "JSON: <..largest_cavity_diameter>, null where nothing is enclosed, <>, with --pockets <--pockets 9>, "
             "where volume and area are null if closed is 0, with --tunnels-from <--tunnels-from 0,0,0>; maxima "
             "and gates by their numbers, counted from 0, or \"outside\" or \"none\"; mouths are gates; balls are "
             "indices in the order of the file, counted from 0, of all balls that are nearest, of points of "
             "tunnels up to four, or that line a pocket.\nWith --box box, symmetry, <--box "
             "9,9,9=pore_limiting_diameter>: [a, b, c] for one, two and three directions, null where no probe gets "
             "through, <--box 9,9,9=included_cavity_diameter>: [a, b, c] of the channels that do, <--box "
             "9,9,9=pore_limiting_diameter_along>: [a, b, c] the three vectors, <--box 9,9,9=channel_list>: "
             "[{radius, maximum, maxima, directions, copies, rows}, ...] for --probe; gates have end_shift and "
             "other_end_shift, by which the maxima are to be moved, and directions, in which their class goes on; "
             "tunnels have shift, the vectors from the point that was named to the copy of it where they "
             "end.\nWith --regions <--regions..accessible_volume>, null without a box, <--regions>; with --box also "
             "<--box 9,9,9 --regions=total_area>, <--box 9,9,9 --regions..total_volume_cm3_per_g>, of elements as "
             "IUPAC weighs them, null where one is not known; xyz, radius and volume are null outside.\nWith "
             "--trajectory first frame, time and step, and no input; pocket is "
             "a number that stays, from the one that a pocket was part of in the frame before, or \"none\", merged "
             "those that have ended in it.",
         .describe = SPACE(describe_pores)},
    [COMMAND_CLASH] =
        {.name = "clash",
         .arguments = "FILE FILE",
         .summary = "a molecule against another one, turned and moved: what meets, and the gap",
         .run_two = command_clash,
         .text = "hardsphere clash FILE FILE [options]\n"
                 "\n"
                 "Tells which balls of the first molecule meet balls of the second one, which is turned and then "
                 "moved. Balls that\n"
                 "touch meet. The gap is the least distance between two balls; it is negative where balls overlap.\n",
         .closing = "Example: hardsphere clash 1crn.pdb caffeine.pdb --rotate 0,90,0 --translate 12,0,3.5\n",
         .json = "JSON: <..pairs>: [[first, second], ...], <..nearest>: [first, second], <..nearest_balls>: of each "
                 "{ball, atom, element, chain, residue, number, insertion, xyz, radius}, as far as files have it, "
                 "<..fixed>: {n, input} and <>: {n, input}; balls by their indices in the order of their files, "
                 "counted from 0. With --trajectory first frame, time and step, and neither fixed nor moving.",
         .describe = describe_clash},
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
                       .closing = "Example: hardsphere query 1crn.pdb --ball 10,10,10,1.4\n",
                       .json =
                           "JSON: <>, the indices of the balls in the order of the file, counted from 0, ascending.",
                       .describe = describe_query},
    [COMMAND_MESH] =
        {.name = "mesh",
         .arguments = "FILE -o OUT",
         .summary = "the surface as triangles: .ply, .obj, .stl, .vert, or a picture: .svg",
         .part = "smooth",
         .run = SMOOTH(command_mesh),
         .check = SMOOTH(check_mesh),
         .text = "hardsphere mesh FILE -o OUT [options]\n"
                 "\n"
                 "Makes triangles of the surface that the balls show: closed, each edge in two of them, "
                 "counter-clockwise seen from\n"
                 "outside. OUT is .ply, .obj, .stl, .vert, or a picture, .svg. With --probe it is the "
                 "solvent-accessible surface, or\n"
                 "the smooth one.\n",
         .closing = ".ply has normals, areas and atoms of vertices, a third of the triangles around each, and the kind "
                    "of patch, the\npatch and the atom of triangles, atoms and patches counted from 0; .obj has "
                    "normals; .stl is binary. NAME.vert comes\nwith NAME.face, as MSMS writes them, counted from "
                    "1.\nKinds are 0 convex, 1 saddle, 2 concave, 3 saddle all around; in .face 3 convex, 1 saddle, 2 "
                    "concave.\nExample: hardsphere mesh 1crn.pdb --probe 1.4 --surface ses -o 1crn.ply\n",
         .json = "JSON: <>, and with --pockets <--pockets 9>; triangle_area approaches the area of measure.",
         .describe = SMOOTH(describe_mesh)},
    [COMMAND_MAP] =
        {.name = "map",
         .arguments = "FILE [options]",
         .summary = "what is seen from a direction: faces, edges, the visible area of each ball",
         .part = DRAWING,
         .run = DRAW(command_map),
         .text = "hardsphere map FILE [options]\n"
                 "\n"
                 "Counts what is seen from a direction: faces, each of which shows one ball or the background, the "
                 "edges between\n"
                 "them, and vertices, where edges end. Areas are those in the view plane. Where balls stand exactly "
                 "behind each\n"
                 "other all are moved a little, and the table says by how much.\n",
         .closing = "Example: hardsphere map 1crn.pdb --view 1,0,0 --per-ball\n",
         .json = "JSON: <>, those that are seen, by their indices in the order of the file, counted from 0; faces "
                 "counts the background.",
         .describe = DRAW(describe_map)},
    [COMMAND_PICK] =
        {.name = "pick",
         .arguments = "FILE --at X,Y",
         .summary = "the ball that is seen at a point",
         .part = DRAWING,
         .run = DRAW(command_pick),
         .text = "hardsphere pick FILE --at X,Y [options]\n"
                 "\n"
                 "Names the ball that is seen at a point of the view plane, and how near its surface is there. X is to "
                 "the right, Y\n"
                 "upwards, and depth grows towards the viewer; origin and unit are those of the file.\n",
         .closing = "Example: hardsphere pick 1crn.pdb --at 10,12 --view 0,0,1\n",
         .json =
             "JSON: <..ball>, its index in the order of the file, counted from 0, and <>; null where there is none.",
         .describe = DRAW(describe_pick)},
    [COMMAND_DRAW] =
        {.name = "draw",
         .arguments = "FILE -o OUT",
         .summary = "a picture with hidden parts removed: .svg, .eps or .pdf",
         .part = DRAWING,
         .run = DRAW(command_draw),
         .check = DRAW(check_draw),
         .text = "hardsphere draw FILE -o OUT [options]\n"
                 "\n"
                 "Draws the balls with hidden parts removed, as true arcs: OUT is .svg, .eps or .pdf.\n",
         .closing = "The same input gives the same bytes.\nExample: hardsphere draw 4hhb.pdb -o haemoglobin.svg\n",
         .json = "JSON: <..bytes>, with --spin <--spin 2>, <>; pieces is how many balls are painted, arcs how many "
                 "parts of circles and ellipses bound them (between visible ones each counts once), bytes the size of "
                 "OUT, all three of all pictures together; width and height are in the given unit, occlusion is 0 "
                 "where balls are not darkened. With --as ball-and-stick pieces are balls, sticks and halves of "
                 "sticks, and <--as ball-and-stick> is how many bonds there are. With colours that stand for numbers "
                 "<--colour bfactor> has the least and the greatest.",
         .describe = DRAW(describe_draw)},
};

bool command_find(const char *name, enum command *command) {
  for (int each = 0; each < COMMANDS; ++each) {
    if (strcmp(name, command_table[each].name) != 0) continue;
    *command = (enum command)each;
    return true;
  }
  return false;
}

static bool is_built(const char *part) {
#if !HSP_HAS_SMOOTH
  if (strcmp(part, "smooth") == 0) return false;
#endif
#if !HSP_HAS_SPACE
  if (strcmp(part, "space") == 0) return false;
#endif
#if !HSP_TOOL_DRAW
  if (strcmp(part, DRAWING) == 0) return false;
#endif
  return part[0] != '\0';
}

bool part_is_there(const char *part, enum command command, const char *option, struct failure *failure) {
  if (part == NULL || is_built(part)) return true;
  return failure_in_usage(failure, "%s%s%s needs the %s%s, which this build leaves out", command_table[command].name,
                          option == NULL ? "" : " ", option == NULL ? "" : option,
                          strcmp(part, DRAWING) == 0 ? "" : "component ", part);
}
