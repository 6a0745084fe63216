/* Groups of atoms by selections, as --interface and --between name them. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/molecule.h"
#include "read/selection.h"

/* Groups are written
 *   groups = "chains" | group "," group {"," group}     each chain is a group; or two groups and more
 *   group  = "rest" | part {"+" part}                   atoms that no other group names; or all that the parts name
 *   part   = chain | selection                          the name of a chain alone, "." for chains without one
 * A comma may also stand in the list of a selection: "residue:HEM,HOH,chain:A" are two groups. So a comma or '+'
 * separates groups or parts only if a selection or "rest" follows, or, unless it is behind such a list, a chain's name.
 * An atom that several groups name belongs to the first of them. */
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
  char *parts;                   /* the texts of their selections */
};

/* Take the text behind an option; text and option must stay where they are. The failure names the possible forms. */
bool selection_groups_parse(struct selection_groups *groups, const char *option, const char *text,
                            struct failure *failure);

/* selection_suits for all groups. */
bool selection_groups_suit(const struct selection_groups *groups, const char *option, const struct file_format *format,
                           const struct index_file *index, struct failure *failure);

/* selection_list_unmatched for all groups. */
void selection_groups_list_unmatched(const struct selection_groups *groups, const struct molecule *molecule,
                                     struct text_buffer *out);

void selection_groups_free(struct selection_groups *groups);

/* The groups of a molecule. */
struct found_group {
  const char *name; /* of a chain: the name in its label, "." if that is empty */
  uint32_t atoms;
  uint32_t others; /* atoms that it names, but that belong to a group before it */
};

struct found_groups {
  uint32_t count;
  struct found_group *group; /* [count] */
  uint32_t *of;              /* [atoms], the number of an atom's group; HSP_NONE: none */
};

/* Find the group of each atom. A group without atoms is refused, and so are "chains" if there is only one. Free the
 * groups on true and on false. */
bool selection_groups_find(const struct selection_groups *groups, const char *option, const struct molecule *molecule,
                           struct found_groups *found, struct failure *failure);

void found_groups_free(struct found_groups *found);
