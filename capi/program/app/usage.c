#include "app/usage.h"

#include "hardsphere.h"

static const char overview[] =
    "hardsphere: exact geometry of unions of balls (molecules)\n"
    "\n"
    "  hardsphere model    FILE [options]   how well the balls behave: k, rho, overlaps\n"
    "  hardsphere boundary FILE [options]   the boundary of the union: vertices, arcs, faces, voids\n"
    "  hardsphere measure  FILE [options]   area and volume, in total, by ball, residue or chain, and their gradients\n"
    "  hardsphere voids    FILE [options]   the cavities in the union and the balls around them\n"
    "  hardsphere contacts FILE [options]   which balls, residues or chains touch and by how much, each ball's cell\n"
    "  hardsphere complex  FILE [options]   the dual complex: simplices by kind, Betti numbers\n"
    "  hardsphere cells    FILE [options]   free space as simple cells: how many, neighbours, connected regions\n"
    "  hardsphere path     FILE [options]   how a probe gets from one point to another\n"
    "  hardsphere gate     FILE [options]   the widest probe that gets to a point or to the outside, and what stops "
    "it\n"
    "  hardsphere clash    FILE FILE        a molecule against another one, turned and moved: what meets, and the gap\n"
    "  hardsphere query    FILE [options]   which balls contain a point or meet a ball\n"
    "  hardsphere mesh     FILE -o OUT      the surface as triangles: .ply, .obj, .stl, .vert, or a picture: .svg\n"
    "  hardsphere map      FILE [options]   what is seen from a direction: faces, edges, the visible area of each "
    "ball\n"
    "  hardsphere pick     FILE --at X,Y    the ball that is seen at a point\n"
    "  hardsphere draw     FILE -o OUT      a picture with hidden parts removed: .svg, .eps or .pdf\n"
    "  hardsphere COMMAND --help            more about a command; hardsphere help COMMAND, too\n"
    "  hardsphere --version\n"
    "\n";

static const char files_and_radii[] =
    "FILE is .pdb, .ent, .pdb1 or the like, .cif (mmCIF), .gro, .pqr or .xyz, in angstrom once read, or .xyzr\n"
    "(x y z r on each line, in any unit); - is standard input: gunzip -c x.pdb.gz | hardsphere measure - --format "
    "pdb.\n"
    "One model and the first alternate location of each atom are read, ATOM and HETATM alike, water and hydrogens "
    "too;\n"
    "draw leaves out water. Tables and JSON say what was read and what was left out. A .cif file has Cartesian\n"
    "coordinates, fractions of its cell, or a chemical component, of which the ideal coordinates are read if they are\n"
    "whole, else those of a model, else x, y, z. .extxyz is .xyz. Beads of coarse-grained models need --radii FILE.\n"
    "\n"
    "Options, before or after FILE:\n"
    "  --format FORMAT        what FILE is, whatever its extension: xyzr, pdb, pqr, xyz, cif or gro\n"
    "  --radii bondi|chem3d   radii by element, for files without radii; bondi is the default. Elements that the set "
    "has\n"
    "                         no radius for get one of bondi, or 2, as do unknown atoms, X in .pdb and .cif, and the\n"
    "                         table says so; X in .xyz is a dummy and left out\n"
    "  --radii protor|naccess|FILE\n"
    "                         radii by residue and atom, else as bondi. A line of FILE, whose name has a dot or a\n"
    "                         slash, is RESIDUE ATOM RADIUS; FreeSASA's configuration files do too. A set without\n"
    "                         hydrogens leaves those out of the residues that it names: heavy atoms stand for them\n"
    "  --radii list           show the sets, and do nothing else\n"
    "  --radius EL=R,...      add or replace radii of single elements, whatever the residue\n"
    "  --probe P              add P to every radius: 1.4 angstrom for water; default 0\n"
    "  --json                 print JSON instead of a table; its last key, input, says what was read\n";

static const char choosing_atoms[] =
    "  --no-water, --no-hetatm, --no-hydrogens\n"
    "                         leave out such atoms\n"
    "  --only S, --hide S     read only the atoms that S names, or all but them. S is chain:A,B, element:H, atom:CA,\n"
    "                         residue:HOH,7,1-40,52A, water, hetatm or hydrogen, or several of these that must all\n"
    "                         hold: \"chain:A&residue:1-40\"; chain:. has no name. Several --only are a union,\n"
    "                         and so are several --hide. What is left out blocks nothing; let balls block that do not\n"
    "                         count by --weights\n"
    "  --model N              read model N of the file, counted from 1; default 1\n";

static const char statuses[] =
    "\n"
    "A file that is written replaces the old one at the end; if anything goes wrong, the old one stays as it is. What "
    "is\n"
    "read is never written over. Where the name of a file to write is -, standard output has the file and nothing "
    "else.\n"
    "\n"
    "Several files may be given, but not to mesh and draw: each gives its table or its line of JSON, and one table of\n"
    "--csv has "
    "the file as its first column. One that cannot be read has its line on stderr and stops no other.\n"
    "\n"
    "Exit status: 0 success, 1 bad input, 2 bad usage; then one line on stderr says why, and of that file stdout has\n"
    "nothing; of a --trajectory it has the frames before the one at fault. With status 0 a line on stderr tells of "
    "names\n"
    "in --only, --hide, --highlight and --radius that nothing has, and of water that is counted in --csv.\n";

/* So that the help of a command fits a screen. */
static const char for_all_commands[] =
    "FILE is .pdb, .cif, .gro, .pqr, .xyz or .xyzr, or - for standard input. --probe P, --radii SET, --only and "
    "--hide\n"
    "ATOMS, --no-water, --model N, --json and what else all commands have: hardsphere --help\n";

static const char model_text[] =
    "hardsphere model FILE [options]\n"
    "\n"
    "Prints the figures of Section 2 of Halperin and Overmars, \"Spheres, Molecules, and Hidden Surface Removal\":\n"
    "k, the largest radius over the smallest; rho, the least distance of two centres over the larger of their radii;\n"
    "the largest and the mean number of others that a ball overlaps. By Theorem 2.1 they bound the work.\n"
    "Example: hardsphere model 1crn.pdb --radii chem3d\n"
    "JSON: n, k, rho, max_overlaps, mean_overlaps; k and rho are null where they have no value.\n"
    "\n";

static const char boundary_text[] =
    "hardsphere boundary FILE [--shells] [options]\n"
    "\n"
    "Counts what the boundary of the union of the balls consists of, exactly, ties and all. The shells, the connected\n"
    "pieces of the boundary, are listed if there are several.\n"
    "  --shells               list them in any case, in JSON too\n"
    "  --csv                  print the counts, or with --shells the list, as comma-separated values and nothing else\n"
    "Example: hardsphere boundary 1crn.pdb --probe 1.4 --shells\n"
    "JSON: n, vertices, arcs, circles, faces, exposed_balls, shells, components, voids, euler, and with --shells\n"
    "shell_list: [{kind, component, cell, faces, euler, genus, area, volume}, ...]; kind is \"outer\" or \"void\", "
    "volume\n"
    "is that of the space enclosed, whatever lies in it.\n"
    "\n";

static const char measure_text[] =
    "hardsphere measure FILE [what to print] [options]\n"
    "\n"
    "Prints the area of the boundary, walls of voids included, and the volume of the union. Without --probe that is\n"
    "the van der Waals surface, with --probe the solvent-accessible surface. Coordinates and radii are rounded first:\n"
    "to 1e-8 where the largest radius, probe included, is from 1.1 to 10.7.\n"
    "  --surface ses          measure the solvent-excluded surface instead, the smooth one that the probe leaves "
    "where\n"
    "                         it rolls over the atoms. An atom's share of it are its convex patches, its side of "
    "saddles\n"
    "                         and a third of concave patches. Not with --relative, --interface; with --weights but\n"
    "                         not their gradient\n"
    "  --outer                of that surface what a probe reaches from outside: as if voids were filled\n"
    "  --per-ball             also the free area of every ball\n"
    "  --gradient             also the derivatives of area and volume by every centre and radius\n"
    "  --curvature            also the integrated mean and Gaussian curvature of the boundary\n"
    "  --weights FILE         also the sum of weight x free area; one number per ball, each on its own line, #\n"
    "                         comments\n"
    "  --polar                also the areas of nitrogen and oxygen, of carbon, sulfur and selenium, and of all "
    "others\n"
    "  --by residue|chain     also sums over residues or chains, except for .xyz and .xyzr. A residue is a run of "
    "atoms\n"
    "                         with the same chain, name, number and insertion code; a chain is all atoms with its "
    "name,\n"
    "                         or in .pdb files without chains with their segment\n"
    "  --relative             with --by residue and a probe: also the part of the largest area that a residue of that\n"
    "                         name can have in a chain\n"
    "  --interface A,B        also what chain A and chain B bury between them; groups of chains are A+B,C\n"
    "  --csv                  print the balls, or with --by the sums, as comma-separated values and nothing else\n"
    "  --pdb-out FILE         write the .pdb file again with the free area of each atom in columns 61-66. Decimals\n"
    "                         that do not fit are left off; atoms that are not read are left out\n"
    "  --trajectory RUN       go through the frames of a .xtc, .dcd, .pdb, .xyz or .gro file instead, each with the\n"
    "                         atoms that are read of FILE, which has their names and radii, in its order. A frame is\n"
    "                         a row of comma-separated values, or with --json a line, printed before the next is\n"
    "                         read. Boxes are not used without --box: the molecule is taken as it stands in the\n"
    "                         frame. A frame at fault ends the run with status 1; the rows before it stay\n"
    "  --frames A:B:S         only the frames A to B, counted from 1, in steps of S; or A alone, A:, :B, ::S\n"
    "Example: hardsphere measure 4hhb.pdb --no-water --probe 1.4 --by residue --relative\n"
    "JSON: n, area, volume; with --curvature mean_curvature, gauss_curvature; with --weights weighted_area; with\n"
    "--polar polar_area, apolar_area, other_area; with\n"
    "--surface ses surface: \"ses\", with --outer outer: true, convex_area, saddle_area, concave_area; with\n"
    "--interface interface: {groups: [{atoms, alone, together}, ...], together, buried}; with --per-ball or "
    "--gradient\n"
    "balls: [{ball, atom, element, chain, residue, number, insertion, xyz, radius, area, with --weights weight, and\n"
    "with --gradient area_gradient: [x, y, z], volume_gradient, area_dr, volume_dr, and with both weighted_gradient,\n"
    "weighted_dr}, ...] in the order of the file and as far as it names them; with --by residues: [{chain, name,\n"
    "number, insertion, atoms, area, relative}, ...] or chains: [{chain, atoms, area}, ...]; with --trajectory first\n"
    "frame, time (in ps, or as .xyz says) and step, null where the file does not tell, and no input.\n"
    "\n";

static const char voids_text[] =
    "hardsphere voids FILE [--min-volume V] [--balls] [options]\n"
    "\n"
    "Lists the cavities that the union encloses, largest volume first: volume, area, the point that is farthest from "
    "all\n"
    "balls and its clearance, how far that is, how many balls have a face on it, and how many pieces of the union lie\n"
    "inside. With --probe they are the places where the centre of a probe fits without a way out; clearance is what\n"
    "a probe may grow by there.\n"
    "  --min-volume V         only those of volume V or more\n"
    "  --balls                also the balls around each\n"
    "  --csv                  print the list as comma-separated values and nothing else\n"
    "Example: hardsphere voids 1crn.pdb --probe 1.4 --min-volume 0.1\n"
    "JSON: n, voids: [{cell, area, volume, components, balls: [...], middle: [x, y, z], point: [x, y, z], clearance,\n"
    "clearance_bound}, ...], smaller; cell is its number in the library, components how many pieces of the union lie "
    "in\n"
    "it, balls their indices in the order of the file, counted from 0, ascending, middle the mean of their centres,\n"
    "which may lie in a ball; point lies in the void, by integers, null if it is narrower than the lattice, and no "
    "point\n"
    "of the void has more clearance than clearance_bound, up to rounding; smaller is how many voids --min-volume "
    "leaves\n"
    "out.\n"
    "\n";

static const char contacts_text[] =
    "hardsphere contacts FILE [--by residue|chain] [--cells] [--least A] [--map OUT.svg] [options]\n"
    "\n"
    "Shares the union out among its balls: a point belongs to the cell of the ball from which it has the least power,\n"
    "distance^2 - radius^2. Two balls are in contact where their cells meet, in a plane piece; its edge is the length\n"
    "of its border on the surface. The cells sum to the volume of the union.\n"
    "  --by residue|chain     sums over the contacts between residues or chains, instead of those between balls\n"
    "  --cells                also volume, free area and contact area of every ball's cell\n"
    "  --least A              list only contacts, or sums, of area A or more\n"
    "  --csv                  print the list as comma-separated values and nothing else\n"
    "  --map OUT.svg          also a picture of the list: a square for each pair, darker the larger its area\n"
    "  --trajectory RUN, --frames A:B:S\n"
    "                         for every frame a row of numbers, or with --json a line with the list: see measure\n"
    "Example: hardsphere contacts 1crn.pdb --probe 1.4 --by residue --least 5\n"
    "JSON: n, contacts, area, pairs: [{balls: [i, j], area, edge, distance}, ...], with --by pairs: [{residues:\n"
    "[\"A:THR:1\", \"A:THR:2\"], area, edge, atom_pairs}, ...] or chains: [\"A\", \"B\"]; with --cells cells: "
    "[{volume, area,\n"
    "contact}, ...] in the order of the file; without --by or with --cells balls: [{ball, atom, element, chain,\n"
    "residue, number, insertion, xyz, radius}, ...] as far as the file says them.\n"
    "\n";

static const char complex_text[] =
    "hardsphere complex FILE [options]\n"
    "\n"
    "Counts the simplices of the dual complex (Edelsbrunner 1995), exactly, ties and all: one to four balls whose "
    "cells\n"
    "have a common point. It has the holes of the union. A simplex is interior if it shows nothing on the boundary;\n"
    "else it is singular if it is part of no larger one, triangles if both sides show, and regular if not.\n"
    "Example: hardsphere complex 1crn.pdb\n"
    "JSON: n, simplices: {singular: [balls, edges, triangles, tetrahedra], regular: [...], interior: [...]}, euler,\n"
    "betti: [components, tunnels, voids].\n"
    "\n";

static const char cells_text[] =
    "hardsphere cells FILE [options]\n"
    "\n"
    "Cuts what no ball covers into simple cells: in every cube of the grid that balls meet, whose side is twice the\n"
    "largest radius, the points at which one ball has the least power, outside that ball; and runs of other cubes.\n"
    "There are O(n) of them, with O(n) pairs of neighbours. With --probe they are the places where the centre of a\n"
    "probe may be, and a region is where it can go.\n"
    "Example: hardsphere cells 1crn.pdb --probe 1.4\n"
    "JSON: n, cubes, cells, free_cells, adjacencies, regions; cells counts those of all cubes, free or not.\n"
    "\n";

static const char path_text[] =
    "hardsphere path FILE --from X Y Z --to X Y Z [options]\n"
    "\n"
    "Finds a way through what no ball covers, with --probe one for the centre of a probe. Whether there is one is\n"
    "decided in integers, and so is whether any segment of the polyline meets a ball: then it is not certified. It "
    "is\n"
    "a short way, but need not be the shortest.\n"
    "Example: hardsphere path 1crn.pdb --from 0,0,0 --to 20,20,20 --probe 1.4\n"
    "JSON: n, connected, covered, certified, length, clearance, points: [[x, y, z], ...]; covered tells whether an "
    "end\n"
    "lies in a ball, clearance is the least distance of the way from the balls grown by the probe; length and "
    "clearance\n"
    "are null where there is no way, clearance also without balls.\n"
    "\n";

static const char gate_text[] =
    "hardsphere gate FILE --from X Y Z|void:K [--to X Y Z|void:K] [options]\n"
    "\n"
    "Finds the largest radius of a probe that gets from one point to another between the balls, or without --to to "
    "the\n"
    "outside. What stops a wider one are the three balls of the narrowest passage on the best way, or one ball if "
    "the\n"
    "probe has less room where it begins or ends.\n"
    "  --from void:K          begin where the void K of hardsphere voids has most room, with the same --probe P,\n"
    "                         which finds the voids and has no other use here; --to void:K likewise\n"
    "Example: hardsphere gate 1crn.pdb --probe 1.4 --from void:1\n"
    "JSON: n, passes, widest_probe, gate: [i, j, k], from: [x, y, z], to; passes is false where not even a point gets\n"
    "through, then widest_probe is null, as it is without balls; gate holds the indices of the balls in the order of "
    "the\n"
    "file, counted from 0, ascending; to is null where it is the outside.\n"
    "\n";

static const char query_text[] =
    "hardsphere query FILE --point X Y Z [options]\n"
    "hardsphere query FILE --ball X Y Z R [options]\n"
    "\n"
    "Lists the balls that contain the point, or that meet the ball. Balls are closed: touching counts. Here as in "
    "every\n"
    "option numbers may stand between blanks or commas: X Y Z or X,Y,Z.\n"
    "Example: hardsphere query 1crn.pdb --ball 10,10,10,1.4\n"
    "JSON: hits, the indices of the balls in the order of the file, counted from 0, ascending.\n"
    "\n";

static const char mesh_text[] =
    "hardsphere mesh FILE -o OUT [options]\n"
    "\n"
    "Makes triangles of the surface that the balls show: closed, each edge in two of them, counter-clockwise seen "
    "from\n"
    "outside. OUT is .ply, .obj, .stl, .vert, or a picture, .svg. With --probe it is the solvent-accessible surface, "
    "or\n"
    "the smooth one.\n"
    "  -o OUT, --output OUT   the file to write\n"
    "  --edge L               how long edges are, about: default 0.5. Half of it makes four times as many\n"
    "                         triangles\n"
    "  --surface vdw|sas|ses  van der Waals, which is without --probe; with it solvent-accessible, the default then,\n"
    "                         or solvent-excluded, the smooth surface\n"
    "  --triangles ply|obj|stl|vert|svg\n"
    "                         what OUT is; default by its extension, and ply if it is -\n"
    "  --view, --up, --rotate from where .svg shows them, as for draw\n"
    "  --cut                  in .svg leave out what lies before the middle of the largest void, or else of all: the\n"
    "                         inside is seen, and voids as red bodies\n"
    ".ply has normals, areas and atoms of vertices, a third of the triangles around each, and the kind of patch, the\n"
    "patch and the atom of triangles, atoms and patches counted from 0; .obj has normals; .stl is binary. NAME.vert "
    "comes\n"
    "with NAME.face, as MSMS writes them, counted from 1.\n"
    "Kinds are 0 convex, 1 saddle, 2 concave, 3 saddle all around; in .face 3 convex, 1 saddle, 2 concave.\n"
    "Example: hardsphere mesh 1crn.pdb --probe 1.4 --surface ses -o 1crn.ply\n"
    "JSON: n, vertices, triangles, edge, triangle_area, bytes; triangle_area approaches the area of measure.\n"
    "\n";

static const char clash_text[] =
    "hardsphere clash FILE FILE [options]\n"
    "\n"
    "Tells which balls of the first molecule meet balls of the second one, which is turned and then moved. Balls that\n"
    "touch meet. The gap is the least distance between two balls; it is negative where balls overlap.\n"
    "  --rotate X,Y,Z         turn the second one by X, then Y, then Z degrees about axes through the mean of its\n"
    "                         centres\n"
    "  --translate X,Y,Z      then move it\n"
    "Example: hardsphere clash 1crn.pdb caffeine.pdb --rotate 0,90,0 --translate 12,0,3.5\n"
    "JSON: hit, pairs: [[first, second], ...], gap, nearest: [first, second], overlap_volume, nearest_balls: [{ball, "
    "...},\n"
    "{ball, ...}] with what these are called, fixed: {n, input} and moving: {n, input}; balls by their indices in the\n"
    "order of their files, counted from 0.\n"
    "\n";

static const char map_text[] =
    "hardsphere map FILE [options]\n"
    "\n"
    "Counts what is seen from a direction: faces, each of which shows one ball or the background, the edges between\n"
    "them, and vertices, where edges end. Areas are those in the view plane. Where balls stand exactly behind each\n"
    "other all are moved a little, and the table says by how much.\n"
    "  --view X,Y,Z, --up X,Y,Z, --rotate X,Y,Z\n"
    "                         from where to look: as for draw, by principal axes if nothing is said\n"
    "  --per-ball             list the balls that are seen\n"
    "Example: hardsphere map 1crn.pdb --view 1,0,0 --per-ball\n"
    "JSON: n, vertices, edges, faces, visible_balls, visible_area, moved, balls: [{ball, visible_area}, ...], those\n"
    "that are seen, by their indices in the order of the file, counted from 0; faces counts the background.\n"
    "\n";

static const char pick_text[] =
    "hardsphere pick FILE --at X,Y [options]\n"
    "\n"
    "Names the ball that is seen at a point of the view plane, and how near its surface is there. X is to the right, "
    "Y\n"
    "upwards, and depth grows towards the viewer; origin and unit are those of the file.\n"
    "  --at X,Y               the point\n"
    "  --view X,Y,Z, --up X,Y,Z, --rotate X,Y,Z\n"
    "                         from where to look: as for draw, by principal axes if nothing is said\n"
    "Example: hardsphere pick 1crn.pdb --at 10,12 --view 0,0,1\n"
    "JSON: ball, its index in the order of the file, counted from 0, and depth; null where there is none.\n"
    "\n";

static const char draw_text[] =
    "hardsphere draw FILE -o OUT [options]\n"
    "\n"
    "Draws the balls with hidden parts removed, as true arcs: OUT is .svg, .eps or .pdf.\n"
    "  -o OUT, --output OUT   the file to write\n"
    "  --picture svg|eps|pdf  what OUT is; default by its extension, and svg if it is -\n"
    "  --view X,Y,Z           the direction towards the viewer. Default auto: by principal axes, with the longest one\n"
    "                         across and the shortest towards the viewer, whether water is drawn or not; 0,0,1 looks\n"
    "                         along the file's z axis\n"
    "  --up X,Y,Z             the direction that appears upwards; default that of auto, with --view X,Y,Z 0,1,0, or\n"
    "                         0,0,1 if the view is along that\n"
    "  --rotate X,Y,Z         then turn the balls by X, then Y, then Z degrees about the axes to the right, upwards\n"
    "                         and towards the viewer, counter-clockwise seen from their ends\n"
    "  --spin N               N pictures of a whole turn about the upright axis, in one frame and scale: OUT-000.svg,\n"
    "                         OUT-001.svg, ... for OUT.svg\n"
    "  --look paper|goodsell|slide|print\n"
    "                         several options by one name; what else is said wins. paper: contours, and buried balls\n"
    "                         darker; goodsell: the same in flat colours, by chain where there are two, without lines\n"
    "                         between bonded atoms; slide: before a dark background, 1600 x 900 px; print: flat, "
    "black\n"
    "                         contours, lines up to 1000 balls, nothing darkened or faded, for printers without "
    "colours\n"
    "  --style flat|headlight|soft\n"
    "                         one colour a ball, light from the viewer, or light from the upper left; default\n"
    "                         soft up to 2000 balls, flat above\n"
    "  --palette soft|jmol|chain\n"
    "                         muted colours or Jmol's by element, or a tint for each chain and ligands and ions by\n"
    "                         element; default chain above 2000 balls with two chains or more, else soft. .xyzr files\n"
    "                         name no elements: all balls count as carbon\n"
    "  --colour WHAT          what colours stand for: element, chain, residue (by its kind), area (that is free for a\n"
    "                         water molecule), bfactor (of .pdb and .cif files), charge (of .pqr files, from red to\n"
    "                         blue, white where there is none), or a file with a dot or slash in its\n"
    "                         name: a number for each ball that is drawn, each on its own line, # comments. Default "
    "as\n"
    "                         for --palette. Numbers go from blue to red, and darken nothing without --occlusion\n"
    "  --range LOW,HIGH       which numbers are blue and red; default the least and the greatest\n"
    "  --highlight S          mute the colours of all atoms but those that S names, as for --only; may be given "
    "several\n"
    "                         times\n"
    "  --occlusion S          darken buried balls, from 0, not at all, to 1. Default 0.5 with style soft, and above\n"
    "                         2000 balls with any style; 0 for balls far more crowded than atoms, and else. For\n"
    "                         molecules it takes less than 1 s up to 20000 balls, 15 us a ball beyond, several times\n"
    "                         that with a --probe; a coarser rule serves above 1000 and above 5000\n"
    "  --fog F                fade far balls to the background, from 0, not at all, to 1; default 0.3, 0 without a\n"
    "                         background\n"
    "  --outline W            the width of lines along silhouettes and intersections, 0: none; default by size\n"
    "  --outline-colour RRGGBB\n"
    "                         their colour; default 23202B\n"
    "  --ink                  contours as wide as what lies behind them is far: thickest around the molecule, thick\n"
    "                         around chains and ligands, from nothing up elsewhere; lines get thinner, or none\n";

/* The rest of it: longer strings are not for every compiler. */
static const char draw_looks_text[] =
    "  --ink-width W          contours with other widths, where they are widest: one, or three B,G,D before the\n"
    "                         background, before other chains and ligands, and elsewhere; 0: none; default by size\n"
    "  --ink-colour RRGGBB    contours in another colour, or in three, likewise; default 23202B\n"
    "  --classes              .svg: an id for each atom, and classes for its element, residue and chain, such as el-C\n"
    "                         res-CYS chain-A; a style sheet that sets their fill keeps the light, but not fog\n"
    "  --tooltips             .svg: names of atoms are shown beside the pointer\n"
    "  --width W, --height H  the size of the picture, one follows from the other; default width 1000 px, and 170 mm\n"
    "                         for .eps, .pdf and in mm\n"
    "  --unit px|mm           of width, height, outline and ink-width; default px, 1/96 inch\n"
    "  --margin M             around the balls, as a part of their larger side; default 0.03\n"
    "  --scale S              for pictures side by side and movies: S px or mm for a unit of length, instead of all\n"
    "                         that is seen fitted into the picture; what lies beyond its edges is cut off\n"
    "  --centre X,Y,Z         with --scale: the point in the middle of the picture; default the middle of the balls'\n"
    "                         centres, which is the same for all directions\n"
    "  --crop X,Y,W,H         only this part of the picture, W wide and H high, X from its left and Y from its upper "
    "edge,\n"
    "                         as if it were cut out; in its unit\n"
    "  --background RRGGBB|none\n"
    "                         default FFFFFF\n"
    "  --fog-colour RRGGBB    with --background none: the colour that far balls fade to, of what will lie behind\n"
    "  --label atom|residue|chain\n"
    "                         names, each where most room is in what is seen of it, or beside the molecule with a "
    "line\n"
    "                         to there; with --highlight only of the atoms that it names.\n"
    "  --scale-bar            a length to compare with\n"
    "  --legend               which colour stands for which element or chain, or number\n"
    "                         These three make the molecule smaller, so that they have room, but not in a picture\n"
    "                         with --scale or --crop\n"
    "  --title TEXT           the title in the file; default the name of FILE\n"
    "  --water                draw water too; it is left out unless there is nothing else\n"
    "  --pieces g|h|visible   cut balls by farther ones, or by all others, which leaves seams; default g. visible:\n"
    "                         exactly what is seen of each, nothing over anything else, every line once, for "
    "plotters,\n"
    "                         cutters and click maps\n"
    "  --all-balls            paint hidden balls too\n"
    "  --as ball-and-stick    small balls, and sticks for bonds, in halves of the balls' colours; default balls. "
    "Bonds\n"
    "                         are those of CONECT records in .pdb files; between atoms that these do not name, those\n"
    "                         shorter than the covalent radii and 0.4 A together, in A. Where a stick runs into a "
    "third\n"
    "                         ball or another stick nothing is drawn. Has no --pieces but visible\n"
    "  --ball-size S          radii of these balls, as a part of those of the atoms; default 0.25\n"
    "  --stick R              the radius of the sticks; default 0.12\n"
    "The same input gives the same bytes.\n"
    "Example: hardsphere draw 4hhb.pdb -o haemoglobin.svg\n"
    "JSON: n, pieces, arcs, bytes, with --spin pictures, style, palette, width, height, occlusion; pieces is how many\n"
    "balls are painted, arcs how many parts of circles and ellipses bound them (between visible ones each counts "
    "once),\n"
    "bytes the size of OUT, all three of all pictures together; width and height are in the given unit, occlusion is "
    "0\n"
    "where balls are not darkened. With --as ball-and-stick pieces are balls, sticks and halves of sticks, and sticks\n"
    "is how many bonds there are.\n"
    "\n";

void usage_of_program(struct text_buffer *out) {
  text_buffer_add(out, "%s%s%s%s", overview, files_and_radii, choosing_atoms, statuses);
}

/* Behind what boundary, measure and contacts say. */
static const char box_text[] =
    "In a periodic box, whose copies fill space, all images of the balls count:\n"
    "  --box AX,BY,CZ         the box, or AX,0,0,BX,BY,0,CX,CY,CZ if it is skew\n"
    "  --box file             that of FILE or of the frame: CRYST1 of .pdb, the cell of .cif, of .gro, .xtc and .dcd,\n"
    "                         Lattice of .xyz; 1 1 1 stands for none. That of FILE is filled by copies: those by the\n"
    "                         operators in REMARK 290 of .pdb or in .cif; without operators the table says that none "
    "are\n"
    "                         made. An image that falls on an atom, within the digits of the file, as on an axis or\n"
    "                         a mirror, is left out, whatever its occupancy is. Frames get no copies; one without a\n"
    "                         box is refused, but if no frame before it has one, that of FILE serves.\n"
    "                         A copy's balls are like others: --weights has numbers for them, too\n"
    "  --box p1               the same without copies: the atoms as they stand\n"
    "A box whose first vector is not along x is turned, and the atoms with it.\n"
    "Not with --shells, --surface ses, --interface and --pdb-out. JSON has box: [9], box_turned, with the box of FILE\n"
    "symmetry: {space_group, operators, filled, special_positions, matrices}, of images that are left out and of "
    "MTRIX\n"
    "records whose copies are not made, box_volume,\n"
    "free_volume, windings: [{balls, directions, copies, rows: [[i, j, k], ...]}, ...], in how many directions each\n"
    "component goes on for ever and by which multiples of the box's vectors, strain_area: [9] and strain_volume: [9],\n"
    "derivatives by eps_xx, eps_xy, ...; a contact has shift: [i, j, k], by which its second ball is to be moved; the\n"
    "boundary has no exposed_balls and voids.\n"
    "\n";

void usage_of_command(struct text_buffer *out, enum command command) {
  const char *text = model_text;
  switch (command) {
    case COMMAND_MODEL:
      text = model_text;
      break;
    case COMMAND_BOUNDARY:
      text = boundary_text;
      break;
    case COMMAND_MEASURE:
      text = measure_text;
      break;
    case COMMAND_QUERY:
      text = query_text;
      break;
    case COMMAND_VOIDS:
      text = voids_text;
      break;
    case COMMAND_CONTACTS:
      text = contacts_text;
      break;
    case COMMAND_COMPLEX:
      text = complex_text;
      break;
    case COMMAND_CELLS:
      text = cells_text;
      break;
    case COMMAND_PATH:
      text = path_text;
      break;
    case COMMAND_GATE:
      text = gate_text;
      break;
    case COMMAND_CLASH:
      text = clash_text;
      break;
    case COMMAND_MESH:
      text = mesh_text;
      break;
    case COMMAND_MAP:
      text = map_text;
      break;
    case COMMAND_PICK:
      text = pick_text;
      break;
    case COMMAND_DRAW:
      text = draw_text;
      break;
  }
  const bool boxes = command == COMMAND_BOUNDARY || command == COMMAND_MEASURE || command == COMMAND_CONTACTS;
  const char *more = boxes ? box_text : command == COMMAND_DRAW ? draw_looks_text : "";
  text_buffer_add(out, "%s%s%s", text, more, for_all_commands);
}

void usage_version(struct text_buffer *out) {
  const unsigned long version = hsp_version();
  text_buffer_add(out, "hardsphere %lu.%lu.%lu\n", version / 10000, version / 100 % 100, version % 100);
}
