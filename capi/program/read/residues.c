#include "read/residues.h"

#include <stdlib.h>
#include <string.h>

bool residue_label_says(const struct residue_label *label) {
  return label->name[0] != '\0' || label->number[0] != '\0' || label->chain[0] != '\0' || label->insertion[0] != '\0';
}

const char *residue_text(char out[RESIDUE_TEXT_BYTES], const struct residue_label *label) {
  const char *const parts[] = {label->name,     " ", label->chain, label->chain[0] == '\0' ? "" : " ", label->number,
                               label->insertion};
  char *at = out;
  for (size_t k = 0; k < sizeof parts / sizeof parts[0] && residue_label_says(label); ++k) {
    const size_t length = strlen(parts[k]);
    memcpy(at, parts[k], length);
    at += length;
  }
  *at = '\0';
  return out;
}

bool residue_label_same(const struct residue_label *a, const struct residue_label *b) {
  if (a == b) return true;
  return a->repeat == b->repeat && a->asym == b->asym && strcmp(a->number, b->number) == 0 &&
         strcmp(a->insertion, b->insertion) == 0 && strcmp(a->name, b->name) == 0 && strcmp(a->chain, b->chain) == 0;
}

static void begin_group(struct atom_groups *groups, uint32_t first) {
  groups->group[groups->count++] = (struct atom_group){first, 0, groups->members, 0.0, NULL};
}

/* Adds the atom to the last group, if it counts; without memory for members they are only counted. */
static void add_atom(struct atom_groups *groups, const uint8_t *part, uint32_t atom) {
  if (part != NULL && part[atom] == 0) return;
  ++groups->group[groups->count - 1].atoms;
  if (groups->member != NULL) groups->member[groups->members] = atom;
  ++groups->members;
}

static void group_residues(const struct molecule *molecule, const uint8_t *part, struct atom_groups *groups) {
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const bool begins = i == 0 || !residue_label_same(molecule->label[i - 1].residue, molecule->label[i].residue);
    if (begins) begin_group(groups, i);
    add_atom(groups, part, i);
  }
}

/* An atom and its chain, for sorting: chains together, each in the order of the file. */
struct chain_member {
  const char *chain;
  uint32_t atom;
};

static int order_of_numbers(uint32_t a, uint32_t b) {
  return (a > b) - (a < b);
}

static int order_of_members(const void *left, const void *right) {
  const struct chain_member *a = left;
  const struct chain_member *b = right;
  const int by_chain = strcmp(a->chain, b->chain);
  return by_chain != 0 ? by_chain : order_of_numbers(a->atom, b->atom);
}

static int order_of_groups(const void *left, const void *right) {
  return order_of_numbers(((const struct atom_group *)left)->first, ((const struct atom_group *)right)->first);
}

/* The atoms sorted by chain; to be freed, NULL: memory is short. */
static struct chain_member *sorted_members(const struct molecule *molecule) {
  struct chain_member *members = malloc(((size_t)molecule->atoms + 1) * sizeof *members);
  if (members == NULL) return NULL;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    members[i] = (struct chain_member){molecule->label[i].residue->chain, i};
  }
  qsort(members, molecule->atoms, sizeof *members, order_of_members);
  return members;
}

static bool begins_chain(const struct chain_member *members, uint32_t i) {
  return i == 0 || strcmp(members[i - 1].chain, members[i].chain) != 0;
}

static bool group_chains(const struct molecule *molecule, const uint8_t *part, struct atom_groups *groups) {
  struct chain_member *members = sorted_members(molecule);
  if (members == NULL) return false;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    if (begins_chain(members, i)) begin_group(groups, members[i].atom);
    add_atom(groups, part, members[i].atom);
  }
  qsort(groups->group, groups->count, sizeof *groups->group, order_of_groups);
  free(members);
  return true;
}

bool chain_numbers_make(const struct molecule *molecule, uint32_t **number, struct failure *failure) {
  struct chain_member *members = sorted_members(molecule);
  *number = malloc(((size_t)molecule->atoms + 1) * sizeof **number);
  if (members == NULL || *number == NULL) {
    free(members);
    free(*number);
    return failure_of_memory(failure);
  }
  uint32_t first = 0;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    if (begins_chain(members, i)) first = members[i].atom;
    (*number)[members[i].atom] = first;
  }
  /* From the first atom of its chain to the number of the chain: earlier atoms have theirs already. */
  uint32_t chains = 0;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    (*number)[i] = (*number)[i] == i ? chains++ : (*number)[(*number)[i]];
  }
  free(members);
  return true;
}

/* The groups of the file, empty ones too; atoms that became no balls are in none. */
static void group_by_index(const struct molecule *molecule, const struct index_file *index, const uint8_t *part,
                           struct atom_groups *groups) {
  for (size_t k = 0; k < index->count; ++k) {
    begin_group(groups, UINT32_MAX);
    struct atom_group *const group = &groups->group[k];
    group->name = index->group[k].name;
    for (uint32_t i = 0; i < molecule->atoms; ++i) {
      if (!index_group_has(&index->group[k], molecule->place[i])) continue;
      if (group->first == UINT32_MAX) group->first = i;
      add_atom(groups, part, i);
    }
  }
}

static void leave_out_empty(struct atom_groups *groups) {
  uint32_t kept = 0;
  for (uint32_t k = 0; k < groups->count; ++k) {
    if (groups->group[k].atoms > 0) groups->group[kept++] = groups->group[k];
  }
  groups->count = kept;
}

bool atom_groups_make(const struct molecule *molecule, enum grouping grouping, const struct index_file *index,
                      const uint8_t *part, struct atom_groups *groups, struct failure *failure) {
  const bool indexed = grouping == GROUPING_GROUP;
  bool done = true;
  *groups = (struct atom_groups)ATOM_GROUPS_NONE;
  groups->grouping = grouping;
  groups->group = malloc(((indexed ? index->count : (size_t)molecule->atoms) + 1) * sizeof *groups->group);
  if (groups->group == NULL) return failure_of_memory(failure);
  if (indexed) group_by_index(molecule, index, part, groups);
  groups->member = malloc(((indexed ? groups->members : (size_t)molecule->atoms) + 1) * sizeof *groups->member);
  if (groups->member == NULL) return failure_of_memory(failure);
  groups->count = 0;
  groups->members = 0;
  if (indexed) {
    group_by_index(molecule, index, part, groups);
  } else if (grouping == GROUPING_CHAIN) {
    done = group_chains(molecule, part, groups);
  } else {
    group_residues(molecule, part, groups);
  }
  if (part != NULL && !indexed) leave_out_empty(groups);
  return done || failure_of_memory(failure);
}

double atom_group_sum(const struct atom_groups *groups, const struct atom_group *group, const double *area) {
  double sum = 0.0;
  for (uint32_t k = 0; k < group->atoms; ++k) sum += area[groups->member[group->member + k]];
  return sum;
}

void atom_groups_sum(struct atom_groups *groups, const double *area) {
  for (uint32_t k = 0; k < groups->count; ++k) {
    groups->group[k].area = atom_group_sum(groups, &groups->group[k], area);
  }
}

void atom_groups_free(struct atom_groups *groups) {
  free(groups->group);
  free(groups->member);
  *groups = (struct atom_groups)ATOM_GROUPS_NONE;
}
