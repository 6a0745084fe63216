/* Groups of atoms by selections, as --interface and --between name them. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/molecule.h"
#include "read/selection.h"

/* Groups are written
 *   groups = "chains" | group "," group {"," group}     each chain is one; or two groups and more
 *   group  = "rest" | part {"+" part}                   what no other group names; or all that the parts name
 *   part   = chain | selection                          the name of a chain alone, "." for those without one
 * A comma or a '+' stands between groups or parts where a selection, "rest" or, behind anything but a list of a
 * selection, a chain's name follows: "residue:HEM,HOH,chain:A" are two groups. An atom that several name is of the
 * first of them. */
struct selection_group {
  const char *name; /* as it is written */
  struct selection selection;
  bool rest;
};

struct selection_groups {
  const char *text; /* NULL: none are asked for */
  bool chains;
  uint32_t count;                /* 0 for "chains" */
  struct selection_group *group; /* [count] */
  char *parts;                   /* the texts that they are made of */
};

/* Take the text that stands behind an option, both of which stay where they are. The failure says which forms there
 * are. */
bool selection_groups_parse(struct selection_groups *groups, const char *option, const char *text,
                            struct failure *failure);

/* As selection_suits. */
bool selection_groups_suit(const struct selection_groups *groups, const char *option, const struct file_format *format,
                           const struct index_file *index, struct failure *failure);

/* As selection_list_unmatched. */
void selection_groups_list_unmatched(const struct selection_groups *groups, const struct molecule *molecule,
                                     struct text_buffer *out);

void selection_groups_free(struct selection_groups *groups);

/* The groups of a molecule. */
struct found_group {
  const char *name; /* of a chain its label's, "." if that has none */
  uint32_t atoms;
  uint32_t others; /* that it names, too, and that are of a group before it */
};

struct found_groups {
  uint32_t count;
  struct found_group *group; /* [count] */
  uint32_t *of;              /* [atoms], the number of its group; HSP_NONE: of none */
};

/* Find the group of each atom. A group of no atom is refused, and so is a single chain. Free the groups on true and on
 * false. */
bool selection_groups_find(const struct selection_groups *groups, const char *option, const struct molecule *molecule,
                           struct found_groups *found, struct failure *failure);

void found_groups_free(struct found_groups *found);
