#include <stddef.h>

#include "app/command_table.h"
#include "app/option.h"
#include "read/threads.h"

#define IN(member) offsetof(struct request, member)
#define OF(COMMAND) (1u << COMMAND_##COMMAND)
#define EVERY EVERY_COMMAND
#define OF_CAVITIES_AND_PAIRS (OF(CONTACTS) | OF(VOIDS) | OF(PORES) | OF(CLASH))

const struct option *option_at(size_t i) {
  static const struct option table[] = {

      {"--format", "FORMAT", take_format, EVERY, .help = "what FILE is, whatever its extension: {formats}"},
      {"--radii", "bondi|chem3d|uff", take_radii, EVERY, .words = "bondi|chem3d|uff|protor|naccess|list",
       .what = "a set, a file or 'list'",
       .help = "radii by element, for files without radii; bondi is the default, uff what porous crystals are\n"
               "measured with. Elements that the set has no radius for get one of bondi, or 2, as do unknown\n"
               "atoms, X in .pdb and .cif, and the table says so; X in .xyz, .sdf and .mol2 is a dummy and\n"
               "left out"},
      {"--radii", "protor|naccess|FILE", take_radii, EVERY,
       .help = "radii by residue and atom, else as bondi. A line of FILE, whose name has a dot or a\n"
               "slash, is RESIDUE ATOM RADIUS; FreeSASA's configuration files and NACCESS's vdw.radii\n"
               "do too. A set without hydrogens leaves those out of the residues that it names: heavy\n"
               "atoms stand for them"},
      {"--radii", "list", take_radii, EVERY, .help = "show the sets, and do nothing else"},
      {"--radius", "EL=R,...", take_radius, EVERY, .what = "EL=R, for instance ZN=1.39",
       .help = "add or replace radii of single elements, whatever the residue"},
      {"--probe", "P", take_probe, EVERY, .target = IN(probe), .what = "a length",
       .help = "add P to every radius: 1.4 angstrom for water; default 0"},
      {"--json", NULL, take_flag, EVERY, .target = IN(json),
       .help = "print JSON instead of a table; its last key, input, says what was read"},
      {"--no-water", NULL, take_atoms, EVERY, .target = IN(selection), .words = "water"},
      {"--no-hetatm", NULL, take_atoms, EVERY, .target = IN(selection), .words = "hetatm"},
      {"--no-hydrogens", NULL, take_atoms, EVERY, .target = IN(selection), .words = "hydrogen",
       .help = "leave out such atoms"},
      {"--only", "S", take_atoms, EVERY, .target = IN(selection),
       .what = "atoms, for instance chain:A,B or residue:HOH"},
      {"--hide", "S", take_atoms, EVERY, .target = IN(selection),
       .what = "atoms, for instance chain:A,B or residue:HOH",
       .help = "read only the atoms that S names, or all but them. S is chain:A,B, element:H, atom:CA,\n"
               "residue:HOH,7,1-40,52A-53, water, hetatm or hydrogen, or several of these that must all\n"
               "hold: \"chain:A&residue:1-40\"; chain:. has no name. Several --only are a union,\n"
               "and so are several --hide. What is left out blocks nothing; measure --of S lets it block"},
      {"--index", "FILE", take_path, EVERY, .target = IN(index_file),
       .help = "groups of atoms, as in GROMACS's index files (.ndx), numbered as in FILE: S may also be\n"
               "group:NAME, or group:N for the one that is N, counted from 0"},
      {"--model", "N", take_model, EVERY, .what = "the number of a model, from 1 on",
       .help = "read model N of the file, counted from 1; default 1"},
      {"--models", "all", take_choice, EVERY, .target = IN(models), .words = "merged|all", .first = 1,
       .help = "go through all models or molecules of a {molecules} file: a row\n"
               "of a table for each, with its title, or with --csv, where the command has it, one of\n"
               "comma-separated values, or with --json a line: model, title and the keys of the command.\n"
               "One that fails has a row that says why, under fault, and the exit status is 1"},
      {"--models", "merged", take_choice, EVERY, .target = IN(models), .words = "merged", .first = 1,
       .help = "read all models as one set of balls, as of files that have one for each copy of an\n"
               "assembly (.pdb1): chains of model 2 have -2 behind their names"},
      {"--rows", NULL, take_flag, EVERY, .target = IN(rows_given),
       .help = "of each file a row of one table, with --csv, where the command has it, of comma-separated\n"
               "values, and no lists"},
      {"--altloc", "first|occupancy|LETTER", take_location, EVERY, .words = "first|occupancy",
       .what = "first, occupancy or a letter",
       .help = "which location counts of atoms that .pdb and .cif files have at several: of each atom that\n"
               "which comes first, the default; or of a residue that with the largest mean occupancy, or\n"
               "with the letter, where it has it. Of disordered groups of crystals likewise. Such atoms\n"
               "count whole, whatever the occupancy; a line on stderr says how many of a crystal do"},
      {"--chains", "auth|label", take_chains, EVERY, .target = IN(chains), .words = "auth|label", .first = 1,
       .help = "of .cif files: chains by auth_asym_id, the default, or by label_asym_id, in which ligands and\n"
               "water have chains of their own; each where the other one is missing"},
      {"--assembly", "N", take_text, EVERY, .target = IN(choice.assembly), .what = "the name of an assembly",
       .help = "make the biological assembly N that a .pdb or .cif file states (REMARK 350,\n"
               "_pdbx_struct_assembly_gen): copies of its chains by its operators. The second copy of chain\n"
               "A is A-2, and --only and the like know it by that name. Not with --box"},

      {"--threads", "N", take_count, EVERY, .target = IN(threads), .what = "how many threads", .most = MOST_THREADS,
       .help = "let N threads work on files, on frames of a trajectory or on a large molecule; default one\n"
               "for each processor. The output is the same for any number"},
      {"--timeout", "SECONDS", take_number, EVERY, .target = IN(timeout), .most = 1e9, .positive = true,
       .help = "stop, with exit status 124, if the work takes longer; files are as they were then, as after\n"
               "Ctrl-C, which gives 130"},

      {"--shells", NULL, take_flag, OF(BOUNDARY), .target = IN(boundary.shells),
       .help = "list them in any case, in JSON too"},
      {"--csv", NULL, take_flag, OF(BOUNDARY), .target = IN(csv),
       .help = "print the counts, or with --shells the list, as comma-separated values and nothing else"},

      {"--surface", "ses", take_choice, OF(MEASURE), .target = IN(measure.surface), .words = "sas|ses",
       .part = "smooth",
       .help = "measure the solvent-excluded surface instead, the smooth one that the probe leaves where\n"
               "it rolls over the atoms. An atom's share of it are its convex patches, its side of saddles\n"
               "and a third of concave patches. Not with --relative, --interface; with --weights but\n"
               "not their gradient"},
      {"--outer", NULL, take_flag, OF(MEASURE), .target = IN(measure.outer),
       .help = "of that surface what a probe reaches from outside: as if voids were filled"},
      {"--per-ball", NULL, take_flag, OF(MEASURE), .target = IN(measure.per_ball),
       .help = "also the free area of every ball"},
      {"--gradient", NULL, take_flag, OF(MEASURE), .target = IN(measure.gradient),
       .help = "also the derivatives of area and volume by every centre and radius"},
      {"--curvature", NULL, take_flag, OF(MEASURE), .target = IN(measure.curvature),
       .help = "also the integrated mean and Gaussian curvature of the boundary"},
      {"--weights", "FILE", take_path, OF(MEASURE), .target = IN(weights),
       .help = "also the sum of weight x free area; one number per ball, each on its own line, #\n"
               "comments"},
      {"--window", "D", take_real, OF(MEASURE), .target = IN(window), .what = "a length", .positive = true,
       .help = "also the mean of the area over all radii within D of their own, which is smooth where\n"
               "balls touch: 0.1 angstrom does for minimisers. With --weights of the weighted area, over\n"
               "D x weight to either side, with --of over radii of these atoms, with --gradient its\n"
               "derivatives, too"},
      {"--polar", NULL, take_flag, OF(MEASURE), .target = IN(measure.polar),
       .help = "also the areas of nitrogen and oxygen, of carbon, sulfur and selenium, and of all others;\n"
               "hydrogens count with the atom that they are bound to, by the file's bonds or by distance"},
      {"--by", "residue|chain|group", take_choice, OF(MEASURE), .target = IN(by), .words = "residue|chain|group",
       .first = 1,
       .help = "also sums over residues or chains, except for .xyz and .xyzr, or over the groups of\n"
               "--index. A residue is a run of atoms with the same chain, name, number and insertion code,\n"
               "and without a number ends where an atom's name comes again; a chain is all atoms with its\n"
               "name, or in .pdb files without chains with their segment, or else up to a TER"},
      {"--of", "S", take_atoms, OF(MEASURE), .target = IN(measure.part),
       .what = "atoms, for instance chain:A,B or residue:HOH",
       .help = "measure only the atoms that S names, as for --only; all others that are read block. Of\n"
               "these the free area is found, and no volume; with --gradient its derivatives by all\n"
               "atoms, of which those that block have neither area nor weight. Several are a union"},
      {"--relative", NULL, take_flag, OF(MEASURE), .target = IN(measure.relative),
       .help = "with --by residue and a probe: also the part of the largest area that a residue of that\n"
               "name can have in a chain"},
      {"--interface", "A,B", take_groups, OF(MEASURE), .target = IN(measure.interface), .words = "chains",
       .what = "groups: A,B or A+B,C or residue:HEM,chain:A or chains",
       .help = "also what chain A and chain B bury between them: the area of each alone less that of both.\n"
               "A group is chains, A+B, or atoms as for --only, residue:HEM; rest is what no other group\n"
               "names, and an atom that several name is of the first of them: \"residue:HEM,chain:A\" is a\n"
               "ligand in its chain. Of more than two groups, or of all chains, each two"},
      {"--csv", NULL, take_flag, OF(MEASURE), .target = IN(csv),
       .help = "print the balls, or with --by the sums, as comma-separated values and nothing else"},
      {"--pdb-out", "FILE", take_path, OF(MEASURE), .target = IN(measure.pdb_out),
       .help = "write the .pdb file again with the free area of each atom in columns 61-66. Decimals\n"
               "that do not fit are left off; atoms that are not read are left out"},
      {"--trajectory", "RUN", take_path, OF(MEASURE), .target = IN(trajectory),
       .help = "go through the frames of a {frames} file instead, each with the\n"
               "atoms that are read of FILE, which has their names and radii, in its order. A frame is\n"
               "a row of comma-separated values, or with --json a line, printed as soon as those before\n"
               "it are. Boxes are not used without --box: the molecule is taken as it stands in the\n"
               "frame. A frame at fault ends the run with status 1; the rows before it stay"},
      {"--frames", "A:B:S", take_frames, OF(MEASURE), .what = "frames, A:B:S",
       .help = "only the frames A to B, counted from 1, in steps of S; or A alone, A:, :B, ::S"},
      {"--begin", "T", take_real, OF(MEASURE), .target = IN(frames.begin), .what = "a time"},
      {"--end", "T", take_real, OF(MEASURE), .target = IN(frames.end), .what = "a time",
       .help = "only the frames from time T, or up to it, as the trajectory has times"},
      {"--interval", "DT", take_real, OF(MEASURE), .target = IN(frames.interval), .what = "a time", .positive = true,
       .help = "of these the first one, and from its time on the first one in each interval of DT"},
      {"--mean", NULL, take_flag, OF(MEASURE), .target = IN(measure.mean),
       .help = "with --trajectory: in place of a row for each frame the mean of all, with the standard\n"
               "deviation, the least and the most; with --per-ball or --csv also of every ball, with --by\n"
               "of every residue, chain or group"},

      {"--tension", "T", take_real, OF(HESSIAN), .target = IN(hessian.tension), .what = "a number"},
      {"--pressure", "P", take_real, OF(HESSIAN), .target = IN(hessian.pressure), .what = "a number",
       .help = "the energy: T x area + P x volume; one of them may be left out"},
      {"--weights", "FILE", take_path, OF(HESSIAN), .target = IN(weights),
       .help = "of areas: one number per ball, each on its own line, # comments"},
      {"--window", "D", take_real, OF(HESSIAN), .target = IN(window), .what = "a length", .positive = true,
       .help = "in place of the area its mean over all radii within D of their own, or D x weight: its\n"
               "second derivatives are bounded, those of the area itself are not. 0.1 angstrom does for\n"
               "minimisers and frequencies"},

      {"--min-volume", "V", take_length, OF(VOIDS), .target = IN(voids.min_volume), .what = "a volume",
       .help = "only those of volume V or more"},
      {"--balls", NULL, take_flag, OF(VOIDS), .target = IN(voids.balls), .help = "also the balls around each"},
      {"--csv", NULL, take_flag, OF(VOIDS), .target = IN(csv),
       .help = "print the list as comma-separated values and nothing else; of a --trajectory that of each\n"
               "frame, in place of a row"},

      {"--by", "residue|chain", take_choice, OF(CONTACTS), .target = IN(by), .words = "residue|chain", .first = 1,
       .help = "sums over the contacts between residues or chains, instead of those between balls"},
      {"--between", "A,B", take_groups, OF(CONTACTS), .target = IN(contacts.between), .words = "chains",
       .what = "groups: A,B or A+B,C or residue:HEM,chain:A or chains",
       .help = "sums over the contacts between groups of atoms, and within each: chains A and B, A+B,C, what\n"
               "selections name, residue:HEM,rest, or chains, all of them. With --by those between residues\n"
               "or chains of different groups, too. More about groups: measure --interface"},
      {"--cells", NULL, take_flag, OF(CONTACTS), .target = IN(contacts.cells),
       .help = "also volume, free area and contact area of every ball's share"},
      {"--least", "A", take_length, OF(CONTACTS), .target = IN(contacts.least), .what = "an area",
       .help = "list only contacts, or sums, of area A or more"},
      {"--csv", NULL, take_flag, OF(CONTACTS), .target = IN(csv),
       .help = "print the list as comma-separated values and nothing else"},
      {"--map", "OUT.svg", take_path, OF(CONTACTS), .target = IN(contacts.map), .part = DRAWING,
       .help = "also a picture of the list: a square for each pair, darker the larger its area"},
      {"--dark", NULL, take_flag, OF(CONTACTS), .target = IN(contacts.dark),
       .help = "that picture before a dark page, with lighter squares for larger areas"},
      {"--from", "X Y Z", take_place, OF(PATH), .target = IN(path.from), .help = ""},
      {"--to", "X Y Z", take_place, OF(PATH), .target = IN(path.to), .help = ""},

      {"--from", "void:K", take_place, OF(GATE), .target = IN(gate.from),
       .help = "begin where the void K of hardsphere voids has most room, with the same --probe P,\n"
               "which finds the voids and has no other use here; --to void:K likewise"},
      {"--to", "X Y Z|void:K", take_place, OF(GATE), .target = IN(gate.to), .help = ""},

      {"--probe", "P", take_probe, OF(PORES), .target = IN(probe), .what = "a length",
       .help = "only what is wider than a probe of radius P; radii are not grown by it,\n"
               "but for --regions. Default 0"},
      {"--least", "D", take_length, OF(PORES), .target = IN(pores.persistence), .what = "a length",
       .help = "list only maxima whose class lives for D or more, radius less death, and pockets that\n"
               "are as much wider than their widest mouth; regions are all listed"},
      {"--gates", NULL, take_flag, OF(PORES), .target = IN(pores.gates), .help = "list gates instead"},
      {"--regions", NULL, take_flag, OF(PORES), .target = IN(pores.regions),
       .help = "area and volume of free space that a probe of radius P gets to from outside, or with --box\n"
               "for ever, of what is blocked, and of each region; the volume is that of its centre. With\n"
               "--box also by cm^3 and by gram, and the density, where elements are known: areas are ASA and\n"
               "NASA of Zeo++, volumes AV and NAV, with --probe 0 the geometric pore volume and void fraction"},
      {"--pockets", "W", take_number, OF(PORES), .target = IN(pores.pockets), .what = "a length", .most = 1e6,
       .help = "list pockets: where a probe of radius P fits, and one of radius W does not get to from\n"
               "outside, or with --box from where it goes on for ever. Volume and area are those of places\n"
               "of the centre of P, cut off by balls that fill the mouths; - where these do not close it.\n"
               "The largest volume is first; numbers are by width, but of a --trajectory each has one that\n"
               "stays"},
      {"--min-volume", "V", take_length, OF(PORES), .target = IN(pores.min_volume), .what = "a volume",
       .help = "only pockets of volume V or more, and those whose volume is not known"},
      {"--balls", NULL, take_flag, OF(PORES), .target = IN(pores.balls),
       .help = "also the balls around each pocket, and each bottleneck of a tunnel"},
      {"--tunnels-from", "X Y Z|atom:N|maximum:N", take_place, OF(PORES), .target = IN(pores.tunnels_from),
       .help = "list tunnels from a point to the outside, the widest first, with the radius along each.\n"
               "With --box to another copy of the point, which lies so many vectors away: for ever.\n"
               "maximum:N is one of those that are listed, atom:N the widest at the atom N of the file,\n"
               "counted from 0. X Y Z lie among the atoms as FILE has them. Of a --trajectory they are\n"
               "those of each frame, the first one the widest in it: unlike pockets, not followed"},
      {"--tunnels-to", "X Y Z|atom:N|maximum:N", take_place, OF(PORES), .target = IN(pores.tunnels_to),
       .help = "instead to this point, or with --box to that copy of it which is best"},
      {"--cheapest", NULL, take_flag, OF(PORES), .target = IN(pores.cheapest),
       .help = "tunnels of the least cost first, the integral of 1/radius^2 along straight lines through\n"
               "maxima and gates: short ones rather than wide ones"},
      {"--tunnels", "N", take_count, OF(PORES), .target = IN(pores.tunnels), .what = "how many tunnels", .most = 1000,
       .help = "so many, each without the bottlenecks of those before it; default 3"},
      {"--points", "OUT", take_path, OF(PORES), .target = IN(pores.points), .what = "a file",
       .help = "also a .pdb or .cif file for viewers with what is listed: a point each, with its radius in\n"
               "the column of temperature factors, of pockets their maxima and mouths, of tunnels the way"},
      {"--tunnels-out", "OUT.cif", take_path, OF(PORES), .target = IN(pores.tunnels_out), .what = "a file",
       .help = "also the tunnels as mmcif_tunnels.dic, of ChannelsDB, has them: radius along the length,\n"
               "layers and the residues that line them, with the atoms of the molecule, as in FILE"},
      {"--profile", "OUT.svg", take_path, OF(PORES), .target = IN(pores.profile), .part = DRAWING, .what = "a file",
       .help = "also a chart of the tunnels: the radius along the length, with a ring at the bottleneck"},
      {"--tree", "OUT.svg", take_path, OF(PORES), .target = IN(pores.tree), .part = DRAWING, .what = "a file",
       .help = "also a chart of the classes: a line from birth to death for each, down to that which it\n"
               "merges into; with --pockets in the colours of the six largest pockets. Of more than\n"
               "100 those that live longest"},
      {"--csv", NULL, take_flag, OF(PORES), .target = IN(csv),
       .help = "print maxima, gates, regions, pockets or points of tunnels as comma-separated values and\n"
               "nothing else; of a --trajectory those of each frame, in place of a row"},

      {"--rotate", "X,Y,Z", take_angles, OF(CLASH), .target = IN(clash.rotate), .part = DRAWING,
       .help = "turn the second one by X, then Y, then Z degrees about axes through the mean of its\n"
               "centres"},
      {"--translate", "X,Y,Z", take_vector, OF(CLASH), .target = IN(clash.translate), .help = "then move it"},

      {"--plot", "OUT.svg", take_path, OF(VOIDS) | OF(PORES), .target = IN(plot), .part = DRAWING, .what = "a file",
       .help = "with --trajectory: also a chart of the volume of each by frame, of the six that have most\n"
               "over the run"},
      {"--trajectory", "RUN", take_path, OF_CAVITIES_AND_PAIRS, .target = IN(trajectory)},
      {"--frames", "A:B:S", take_frames, OF_CAVITIES_AND_PAIRS, .what = "frames, A:B:S"},
      {"--begin", "T", take_real, OF_CAVITIES_AND_PAIRS, .target = IN(frames.begin), .what = "a time"},
      {"--end", "T", take_real, OF_CAVITIES_AND_PAIRS, .target = IN(frames.end), .what = "a time"},
      {"--interval", "DT", take_real, OF_CAVITIES_AND_PAIRS, .target = IN(frames.interval), .what = "a time",
       .positive = true,
       .help = "for every frame a row of numbers, or with --json a line with the list: see measure. Of clash\n"
               "the frames are of the second molecule"},

      {"--point", "X Y Z", take_query, OF(QUERY), .help = ""},
      {"--ball", "X Y Z R", take_query, OF(QUERY), .help = ""},

      {"-o", "OUT", take_text, OF(MESH), .target = IN(meshing.out), .what = "a file"},
      {"--output", "OUT", take_text, OF(MESH), .target = IN(meshing.out), .what = "a file",
       .help = "the file to write"},
      {"--edge", "L", take_edge, OF(MESH), .target = IN(meshing.edge), .what = "a length",
       .help = "how long edges are, about: default 0.5. Half of it makes four times as many\n"
               "triangles"},
      {"--surface", "vdw|sas|ses", take_choice, OF(MESH), .target = IN(meshing.surface), .words = "vdw|sas|ses",
       .help = "van der Waals, which is without --probe; with it solvent-accessible, the default then,\n"
               "or solvent-excluded, the smooth surface"},
      {"--triangles", "ply|obj|stl|vert|svg", take_choice, OF(MESH), .target = IN(meshing.format),
       .words = "ply|obj|stl|vert|svg", .help = "what OUT is; default by its extension, and ply if it is -"},
      {"--view", "X,Y,Z", take_view, OF(MESH), .target = IN(viewing)},
      {"--up", "X,Y,Z", take_direction, OF(MESH), .target = IN(viewing.up)},
      {"--rotate", "X,Y,Z", take_angles, OF(MESH), .target = IN(viewing.rotate),
       .help = "from where .svg shows them, as for draw"},
      {"--cut", NULL, take_flag, OF(MESH), .target = IN(meshing.cut),
       .help = "in .svg leave out what lies before the middle of the largest void, or else of all: the\n"
               "inside is seen, and voids as teal bodies"},

      {"--dark", NULL, take_flag, OF(MESH), .target = IN(meshing.dark), .help = "in .svg before a dark page"},

      {"--pockets", "W", take_number, OF(MESH), .target = IN(meshing.pockets), .what = "a length", .most = 1e6,
       .part = "space",
       .help = "in .svg show pockets instead, as pores has them: where the probe fits, and one of radius W\n"
               "does not get to from outside. The largest six have colours; --cut goes through the first"},
      {"--least", "D", take_length, OF(MESH), .target = IN(meshing.persistence), .what = "a length", .part = "space",
       .help = "only pockets that are wider than their widest mouth by D"},

      {"--at", "X,Y", take_at, OF(PICK), .help = "the point"},

      {"--view", "X,Y,Z", take_view, OF(MAP) | OF(PICK), .target = IN(viewing)},
      {"--up", "X,Y,Z", take_direction, OF(MAP) | OF(PICK), .target = IN(viewing.up)},
      {"--rotate", "X,Y,Z", take_angles, OF(MAP) | OF(PICK), .target = IN(viewing.rotate),
       .help = "from where to look: as for draw, by principal axes if nothing is said"},

      {"--per-ball", NULL, take_flag, OF(MAP), .target = IN(map.per_ball), .help = "list the balls that are seen"},

      {"-o", "OUT", take_text, OF(DRAW), .target = IN(drawing.out), .what = "a file"},
      {"--output", "OUT", take_text, OF(DRAW), .target = IN(drawing.out), .what = "a file",
       .help = "the file to write"},
      {"--picture", "svg|eps|pdf", take_choice, OF(DRAW), .target = IN(drawing.format), .words = "svg|eps|pdf",
       .help = "what OUT is; default by its extension, and svg if it is -"},
      {"--view", "X,Y,Z", take_view, OF(DRAW), .target = IN(drawing.viewing),
       .help = "the direction towards the viewer. Default auto: by principal axes, with the longest one\n"
               "across and the shortest towards the viewer, whether water is drawn or not; 0,0,1 looks\n"
               "along the file's z axis; highlight: from where most is seen of what --highlight\n"
               "names, or of all"},
      {"--up", "X,Y,Z", take_direction, OF(DRAW), .target = IN(drawing.viewing.up),
       .help = "the direction that appears upwards; default that of auto, with --view X,Y,Z 0,1,0, or\n"
               "0,0,1 if the view is along that"},
      {"--rotate", "X,Y,Z", take_angles, OF(DRAW), .target = IN(drawing.viewing.rotate),
       .help = "then turn the balls by X, then Y, then Z degrees about the axes to the right, upwards\n"
               "and towards the viewer, counter-clockwise seen from their ends"},
      {"--spin", "N", take_count, OF(DRAW), .target = IN(drawing.spin), .what = "how many pictures", .most = 10000,
       .help = "N pictures of a whole turn about the upright axis, in one frame and scale: OUT-000.svg,\n"
               "OUT-001.svg, ... for OUT.svg"},
      {"--look", "paper|goodsell|slide|print", take_choice, OF(DRAW), .target = IN(drawing.look),
       .words = "paper|goodsell|slide|print",
       .help = "several options by one name; what else is said wins. paper: contours, and buried balls\n"
               "darker; goodsell: the same in flat colours, a tint for each chain, without lines between\n"
               "bonded atoms; slide: before a dark background, 1600 x 900 px; print: flat, black\n"
               "contours, lines up to 1000 balls, nothing darkened or faded, for printers without colours.\n"
               "Balls and sticks have wider lines for contours"},
      {"--style", "flat|headlight|soft", take_choice, OF(DRAW), .target = IN(drawing.style),
       .words = "flat|headlight|soft",
       .help = "one colour a ball, light from the viewer, or light from the upper left; default\n"
               "soft up to 2000 balls, flat above"},
      {"--palette", "soft|jmol|chain", take_choice, OF(DRAW), .target = IN(drawing.palette), .words = "soft|jmol|chain",
       .help = "muted colours or Jmol's by element, or a tint for each chain and ligands and ions by\n"
               "element; default chain above 2000 balls with two chains or more, and with two of\n"
               "nucleotides, else soft. .xyzr files name no elements: all balls count as carbon"},
      {"--colour", "WHAT", take_colour_meaning, OF(DRAW), .words = "element|chain|residue|area|bfactor|charge|plddt",
       .what = "element, chain, residue, area, bfactor, charge, plddt or a file",
       .help = "what colours stand for: element, chain, residue (by its kind), area (that is free for a\n"
               "water molecule), bfactor (of .pdb and .cif files), charge (of .pqr, .mol2 and .pdbqt files,\n"
               "from red to blue, pale where there is none), plddt (the column of bfactor in AlphaFold's four\n"
               "bands: above 90, 70, 50, and below), or a file with a dot or slash in its\n"
               "name: a number for each ball that is drawn, each on its own line, # comments. Default as\n"
               "for --palette. Numbers go from blue to red, and darken nothing without --occlusion"},
      {"--range", "LOW,HIGH", take_range, OF(DRAW),
       .help = "which numbers are blue and red; default the least and the greatest"},
      {"--highlight", "S", take_atoms, OF(DRAW), .target = IN(drawing.highlight),
       .what = "atoms, for instance chain:A or residue:57,102",
       .help = "mute the colours of all atoms but those that S names, as for --only; may be given several\n"
               "times"},
      {"--occlusion", "S", take_number, OF(DRAW), .target = IN(drawing.occlusion), .most = 1,
       .help = "darken buried balls, from 0, not at all, to 1. Default 0.5 with style soft, and above\n"
               "2000 balls with any style; 0 for balls far more crowded than atoms, and else. For\n"
               "molecules it takes less than 1 s up to 20000 balls, 15 us a ball beyond, several times\n"
               "that with a --probe; a coarser rule serves above 1000 and above 5000"},
      {"--fog", "F", take_number, OF(DRAW), .target = IN(drawing.fog), .most = 1,
       .help = "fade far balls to the background, from 0, not at all, to 1; default 0.3; for balls and\n"
               "sticks 0.5 above 60 atoms, 0.7 above 200; 0 without a background"},
      {"--outline", "W", take_number, OF(DRAW), .target = IN(drawing.outline), .most = 1e6,
       .help = "the width of lines along silhouettes and intersections, 0: none; default by size"},
      {"--outline-colour", "RRGGBB", take_colour, OF(DRAW), .target = IN(drawing.outline_colour), .what = "RRGGBB",
       .help = "their colour; default 23202B. Colours have names, too, as in style sheets: white, navy"},
      {"--ink", NULL, take_flag, OF(DRAW), .target = IN(drawing.ink),
       .help = "contours as wide as what lies behind them is far: thickest around the molecule, thick\n"
               "around chains and ligands, from nothing up elsewhere; lines get thinner, or none"},
      {"--ink-width", "W", take_ink_width, OF(DRAW), .what = "a number or three",
       .help = "contours with other widths, where they are widest: one, or three B,G,D before the\n"
               "background, before other chains and ligands, and elsewhere; 0: none; default by size"},
      {"--ink-colour", "RRGGBB", take_ink_colour, OF(DRAW), .what = "RRGGBB or three of them",
       .help = "contours in another colour, or in three, likewise; default 23202B"},
      {"--classes", NULL, take_flag, OF(DRAW), .target = IN(drawing.classes),
       .help = "in .svg an id for each atom, and classes for its element, residue and chain, such as el-C\n"
               "res-CYS chain-A; a style sheet that sets their fill keeps the light, but not fog"},
      {"--tooltips", NULL, take_flag, OF(DRAW), .target = IN(drawing.tooltips),
       .help = "in .svg show names of atoms beside the pointer"},
      {"--width", "W", take_number, OF(DRAW), .target = IN(drawing.width), .most = 1e6, .positive = true},
      {"--height", "H", take_number, OF(DRAW), .target = IN(drawing.height), .most = 1e6, .positive = true,
       .help = "the size of the picture, one follows from the other; default width 1000 px, and 170 mm\n"
               "for .eps, .pdf and in mm"},
      {"--unit", "px|mm", take_choice, OF(DRAW), .target = IN(drawing.unit), .words = "px|mm",
       .help = "of width, height, outline and ink-width; default px, 1/96 inch"},
      {"--margin", "M", take_number, OF(DRAW), .target = IN(drawing.margin), .most = 10,
       .help = "around the balls, as a part of their larger side; default 0.03"},
      {"--scale", "S", take_number, OF(DRAW), .target = IN(drawing.scale), .most = 1e9, .positive = true,
       .help = "for pictures side by side and movies: S px or mm for a unit of length, instead of all\n"
               "that is seen fitted into the picture; what lies beyond its edges is cut off"},
      {"--centre", "X,Y,Z", take_vector, OF(DRAW), .target = IN(drawing.centre),
       .help = "with --scale: the point in the middle of the picture; default the middle of the balls'\n"
               "centres, which is the same for all directions"},
      {"--crop", "X,Y,W,H", take_crop, OF(DRAW),
       .help = "only this part of the picture, W wide and H high, X from its left and Y from its upper edge,\n"
               "as if it were cut out; in its unit"},
      {"--background", "RRGGBB|none", take_colour, OF(DRAW), .target = IN(drawing.background), .words = "none",
       .what = "RRGGBB or none", .help = "default FFFFFF"},
      {"--fog-colour", "RRGGBB", take_colour, OF(DRAW), .target = IN(drawing.fog_colour), .what = "RRGGBB",
       .help = "with --background none: the colour that far balls fade to, of what will lie behind"},
      {"--label", "atom|residue|chain", take_choice, OF(DRAW), .target = IN(drawing.label),
       .words = "atom|residue|chain",
       .help = "names, each where most room is in what is seen of it, or beside the molecule with a line\n"
               "to there; with --highlight only of the atoms that it names. Those without room are left out."},
      {"--scale-bar", NULL, take_flag, OF(DRAW), .target = IN(drawing.scale_bar), .help = "a length to compare with"},
      {"--legend", NULL, take_flag, OF(DRAW), .target = IN(drawing.legend),
       .help = "which colour stands for which element, chain, kind of residue or number\n"
               "These three make the molecule smaller, so that they have room, but not in a picture\n"
               "with --scale or --crop"},
      {"--title", "TEXT", take_text, OF(DRAW), .target = IN(drawing.title), .what = "a text",
       .help = "the title in the file; default the name of FILE"},
      {"--water", NULL, take_flag, OF(DRAW), .target = IN(drawing.water),
       .help = "draw water too; it is left out unless there is nothing else"},
      {"--pieces", "g|h|visible", take_choice, OF(DRAW), .target = IN(drawing.pieces), .words = "g|h|visible",
       .help = "cut balls by farther ones, or by all others, which leaves seams; default g. visible:\n"
               "exactly what is seen of each, nothing over anything else, every line once, for plotters,\n"
               "cutters and click maps"},
      {"--all-balls", NULL, take_flag, OF(DRAW), .target = IN(drawing.all_balls), .help = "paint hidden balls too"},
      {"--as", "ball-and-stick", take_choice, OF(DRAW), .target = IN(drawing.as), .words = "balls|ball-and-stick",
       .help = "small balls, and sticks for bonds, in halves of the balls' colours; default balls. Bonds\n"
               "are those of CONECT records in .pdb files and of _chem_comp_bond in .cif files of components;\n"
               "between atoms that these do not name, those shorter than the covalent radii and 0.4 A\n"
               "together, in A. Double and triple bonds are two and three sticks side by side, aromatic ones\n"
               "a whole and a dashed one: by value_order, or where a CONECT record names an atom twice or\n"
               "three times. Where a stick runs into a third ball or another stick nothing is drawn. Has no\n"
               "--pieces but visible, which has one stick for each bond"},
      {"--ball-size", "S", take_number, OF(DRAW), .target = IN(drawing.ball_size), .most = 1, .positive = true,
       .help = "radii of these balls, as a part of those of the atoms; default 0.25"},
      {"--stick", "R", take_number, OF(DRAW), .target = IN(drawing.stick), .most = 1e6, .positive = true,
       .help = "the radius of the sticks; default 0.12. A multiple bond has one and a half in all, or one\n"
               "where there is no room for it"},

      {"--box", "AX,BY,CZ", take_box, OF(BOUNDARY) | OF(MEASURE) | OF(CONTACTS) | OF(PORES), .words = "file|p1",
       .what = "AX,BY,CZ, nine numbers, 'file' or 'p1'", .help = "the box, or its vectors AX,AY,AZ,BX,BY,BZ,CX,CY,CZ"},
      {"--box", "file", take_box, OF(BOUNDARY) | OF(MEASURE) | OF(CONTACTS) | OF(PORES),
       .help = "that of FILE or of the frame: CRYST1 of .pdb, the cell of .cif, of .gro, .xtc, .trr, .dcd, .nc,\n"
               "Lattice of .xyz; 1 1 1 stands for none. That of FILE is filled by copies: those by the\n"
               "operators in REMARK 290 of .pdb or in .cif; without operators the table says that none are\n"
               "made. An image that falls on an atom, within the digits of the file, as on an axis or\n"
               "a mirror, is left out, whatever its occupancy is. Frames get no copies; one without a\n"
               "box is refused, but if no frame before it has one, that of FILE serves.\n"
               "A copy's balls are like others: --weights has numbers for them, too"},
      {"--box", "p1", take_box, OF(BOUNDARY) | OF(MEASURE) | OF(CONTACTS) | OF(PORES),
       .help = "the same without copies: the atoms as they stand"},
  };
  return i < sizeof table / sizeof table[0] ? &table[i] : NULL;
}
