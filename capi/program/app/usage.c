#include "app/usage.h"

#include <stdio.h>
#include <string.h>

#include "app/command_table.h"
#include "app/help_keys.h"
#include "app/option.h"
#include "hardsphere.h"

static const char files[] =
    "FILE is .pdb, .ent, .pdb1 or the like, .cif (mmCIF), .gro, .sdf, .mol, .mol2, .pqr, .pdbqt or .xyz, in\n"
    "angstrom once read, or .xyzr (x y z r on each line, in any unit); - is standard input:\n"
    "gunzip -c x.pdb.gz | hardsphere measure - --format pdb.\n"
    "One model and the first alternate location of each atom are read, ATOM and HETATM alike, water and hydrogens "
    "too;\n"
    "draw leaves out water. Tables and JSON say what was read and what was left out. A .cif file has Cartesian\n"
    "coordinates, fractions of its cell, or a chemical component, of which the ideal coordinates are read if they are\n"
    "whole, else those of a model, else x, y, z. .extxyz is .xyz. Beads of coarse-grained models need --radii FILE.\n"
    "\n"
    "Options, before or after FILE:\n";

static const char statuses[] =
    "\n"
    "A file that is written replaces the old one at the end; if anything goes wrong, the old one stays as it is. What "
    "is\n"
    "read is never written over. Where the name of a file to write is -, standard output has the file and nothing "
    "else.\n"
    "\n"
    "Several files may be given, but not to mesh and draw: each gives its table or its line of JSON, and one table of\n"
    "--csv has the file as its first column. One that cannot be read has its line on stderr and stops no other.\n"
    "\n"
    "Numbers of --csv and JSON are in the unit of FILE, angstrom, or of .xyzr its own: lengths, areas in its square,\n"
    "volumes in its cube; times in ps, or as .xyz says. Balls, shells, maxima and gates count from 0; voids, regions,\n"
    "pockets, tunnels, models and frames from 1.\n"
    "\n"
    "The input of JSON: {file, format, unit, radii, radius_overrides as --radius has them, substitutes: [{element,\n"
    "radius, atoms}, ...] of elements without a radius in the set, probe, balls, among these waters, water_atoms, "
    "other\n"
    "hetatm, hydrogens, radius_zero, and radius_by_element, whose radius is that of their element; of .xyz\n"
    "atomic_numbers, in place of symbols; of .cif coordinates, the first tag of those that are read; model, null for\n"
    "all, and models, null where not known; with --assembly assembly, assembly_operators; left_out, how many atoms "
    "are\n"
    "not read: {other_models, alternate_locations, virtual_sites, of .cif unplaced, without coordinates,\n"
    "hydrogens_of_set, which heavy atoms stand for, by options water, other hetatm, hydrogen and others}}.\n"
    "\n"
    "Exit status: 0 success, 1 bad input, 2 bad usage, 124 after --timeout, 130 after Ctrl-C; if not 0 one line on\n"
    "stderr says why, and of that file stdout has nothing; of a --trajectory it has the frames before the one at\n"
    "fault. With status 0 a line on stderr tells of names in --only, --hide, --highlight and --radius that nothing\n"
    "has, of dummies that are left out, of atoms' names that say another element than the file, of water that is\n"
    "counted in --csv, of labels of a picture that have no room, and of a lattice that is coarse beside the smallest\n"
    "radius.\n";

/* So that the help of a command fits a screen. */
#define FOR_ALL_COMMANDS                                                             \
  "FILE is %s, or - for standard input. --probe P, --radii SET, --only and --hide\n" \
  "ATOMS, --no-water, --model N, --json and what else all commands have: hardsphere --help\n"

/* Around the options of a periodic box. */
static const char box_text[] = "In a periodic box, whose copies fill space, all images of the balls count:\n";

static const char box_closing[] =
    "The three vectors may be any. Coordinates and directions are printed in the frame of the atoms.\n"
    "Not with --shells, --surface ses, --interface, --window and --pdb-out.\n";

/* The keys of JSON for a boundary in a box. */
static const char box_json[] =
    "JSON has <--box 9,9,9..box>: [9], with the box of FILE <--box 9,9,9..symmetry>: "
    "{space_group, operators, filled, special_positions, matrices}, of images that are left out and of MTRIX records "
    "whose copies are not made, <--box 9,9,9..windings>: [{balls, directions, copies, rows: [[i, j, k], ...]}, ...], "
    "in how many directions each component goes on for ever and by which multiples of the box's vectors, "
    "<--box 9,9,9..strain_area>: [9] and <--box 9,9,9..strain_volume>: [9], derivatives by eps_xx, eps_xy, ...; a "
    "contact has shift: [i, j, k], by which its second ball is to be moved; the boundary has no exposed_balls and "
    "voids.";

/* The options of a command, those that all commands have, or those of a periodic box. */
enum section { OF_COMMAND, OF_ALL, OF_BOX };

static bool is_in(const struct option *option, enum section section, enum command command) {
  const bool of_box = strcmp(option->name, "--box") == 0;
  if (section == OF_ALL) return option->commands == EVERY_COMMAND;
  return option->commands != EVERY_COMMAND && option_is_of(option, command) && of_box == (section == OF_BOX);
}

/* Add lines of help, each behind the column of names; {formats}, {frames} and {molecules} are replaced by lists of
 * formats. */
static void add_help(struct text_buffer *out, const char *help) {
  char list[FORMAT_LIST_BYTES];
  while (help[0] != '\0') {
    const size_t length = strcspn(help, "{\n");
    text_buffer_append(out, help, length);
    help += length;
    if (help[0] == '\n') {
      text_buffer_add(out, "\n%25s", "");
      ++help;
    } else if (help[0] == '{') {
      const bool frames = strncmp(help, "{frames}", strlen("{frames}")) == 0;
      const bool molecules = strncmp(help, "{molecules}", strlen("{molecules}")) == 0;
      text_buffer_add(out, "%s",
                      file_format_list(list, frames || molecules ? "." : "", "or",
                                       frames      ? FILE_FRAMES
                                       : molecules ? FILE_MOLECULES
                                                   : FILE_ATOMS,
                                       true));
      help = strchr(help, '}') + 1;
    }
  }
  text_buffer_add(out, "\n");
}

static void add_options(struct text_buffer *out, enum section section, enum command command) {
  struct text_buffer names = TEXT_BUFFER_EMPTY;
  const struct option *option;
  for (size_t i = 0; (option = option_at(i)) != NULL; ++i) {
    if (!is_in(option, section, command)) continue;
    if (option->help != NULL && option->help[0] == '\0') continue;
    text_buffer_add(&names, "%s%s%s%s", names.length == 0 ? "" : ", ", option->name,
                    option->argument == NULL ? "" : " ", option->argument == NULL ? "" : option->argument);
    if (option->help == NULL) continue;
    const char *shown = names.out_of_memory ? "" : names.text;
    if (strlen(shown) > 22) {
      text_buffer_add(out, "  %s\n%25s", shown, "");
    } else {
      text_buffer_add(out, "  %-23s", shown);
    }
    add_help(out, option->help);
    names.length = 0;
  }
  out->out_of_memory = out->out_of_memory || names.out_of_memory;
  text_buffer_free(&names);
}

void usage_of_program(struct text_buffer *out) {
  text_buffer_add(out, "hardsphere: exact geometry of unions of balls (molecules)\n\n");
  for (int command = 0; command < COMMANDS; ++command) {
    const struct command_row *row = &command_table[command];
    text_buffer_add(out, "  hardsphere %-8s %-17s%s\n", row->name, row->arguments, row->summary);
  }
  text_buffer_add(out,
                  "  hardsphere COMMAND --help            more about a command; hardsphere help COMMAND, too\n"
                  "  hardsphere completion bash|zsh       what makes a shell complete commands and options\n"
                  "  hardsphere --version\n\n%s",
                  files);
  add_options(out, OF_ALL, COMMAND_MODEL);
  text_buffer_add(out, "%s", statuses);
}

void usage_of_command(struct text_buffer *out, enum command command) {
  const struct command_row *row = &command_table[command];
  const char *value;
  char list[FORMAT_LIST_BYTES];
  text_buffer_add(out, "%s", row->text);
  add_options(out, OF_COMMAND, command);
  text_buffer_add_text(out, row->closing);
  if (row->describe != NULL) help_keys_fill(out, command, row->json);
  text_buffer_add_text(out, "\n");
  if (option_find(command, "--box", &value) != NULL) {
    text_buffer_add(out, "%s", box_text);
    add_options(out, OF_BOX, command);
    text_buffer_add_text(out, box_closing);
    help_keys_fill(out, COMMAND_BOUNDARY, box_json);
    text_buffer_add_text(out, "\n");
  }
  text_buffer_add(out, FOR_ALL_COMMANDS, file_format_list(list, ".", "or", FILE_ATOMS, true));
}

void usage_version(struct text_buffer *out) {
  const unsigned long version = hsp_version();
  text_buffer_add(out, "hardsphere %lu.%lu.%lu\n", version / 10000, version / 100 % 100, version % 100);
}
