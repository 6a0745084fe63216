#include "read/selection_groups.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "hardsphere.h"
#include "read/residues.h"

/* More groups would have no room in memory as a matrix. */
enum { MOST_GROUPS = 4096 };

static const char chain_key[] = "chain:";

/* Whether the text begins with a selection, or is `rest`, up to a separator. */
static bool begins_selection(const char *text) {
  static const char *const keys[] = {"chain:", "residue:", "element:", "atom:", "group:"};
  static const char *const words[] = {"water", "hetatm", "hydrogen", "rest"};
  const size_t length = strcspn(text, ",+&");
  for (size_t k = 0; k < sizeof keys / sizeof keys[0]; ++k) {
    if (strncmp(text, keys[k], strlen(keys[k])) == 0) return true;
  }
  for (size_t k = 0; k < sizeof words / sizeof words[0]; ++k) {
    if (strlen(words[k]) == length && memcmp(text, words[k], length) == 0) return true;
  }
  return false;
}

/* The length of a part: up to the separator behind which another one begins. */
static size_t part_length(const char *text) {
  bool list = false; /* of a selection, which goes on behind a comma */
  for (size_t at = 0;; ++at) {
    const bool separates = text[at] == ',' || text[at] == '+';
    if (text[at] == '\0' || (separates && (!list || begins_selection(text + at + 1)))) return at;
    if (text[at] == ':') list = true;
    if (text[at] == '&') list = false;
  }
}

static bool refuse(const char *option, const char *text, struct failure *failure) {
  char shown[EXCERPT_BYTES];
  return failure_in_usage(failure,
                          "%s: '%s' does not name two groups: they are A,B or A+B,C or chains, residue:HEM,rest or "
                          "residue:HEM,chain:A, where a chain behind a selection is chain:A",
                          option, excerpt(shown, text, strlen(text)));
}

/* Adds the part to the group, by a text of its own at *own, which is moved behind it. */
static bool add_part(struct selection_group *group, const char *option, const char *text, size_t length, char **own,
                     struct failure *failure) {
  char *const begin = *own;
  const bool plain = memchr(text, ':', length) == NULL && memchr(text, '&', length) == NULL;
  const bool named = plain && !begins_selection(text);
  group->rest = plain && length == strlen("rest") && memcmp(text, "rest", length) == 0;
  if (group->rest) return true;
  const size_t before = named ? strlen(chain_key) : 0;
  memcpy(begin, chain_key, before);
  memcpy(begin + before, text, length);
  begin[before + length] = '\0';
  *own = begin + before + length + 1;
  return selection_add(&group->selection, option, begin, false, failure);
}

/* Whether no other part of the text is the same. */
static bool is_new(const char *whole, const char *part, size_t length, const char *option, struct failure *failure) {
  for (const char *other = whole; other < part; other += part_length(other) + 1) {
    if (part_length(other) != length || memcmp(other, part, length) != 0) continue;
    char shown[EXCERPT_BYTES];
    return failure_in_usage(failure, "%s: '%s' is named twice", option, excerpt(shown, part, length));
  }
  return true;
}

bool selection_groups_parse(struct selection_groups *groups, const char *option, const char *text,
                            struct failure *failure) {
  const size_t length = strlen(text);
  groups->text = text;
  groups->chains = strcmp(text, "chains") == 0;
  if (groups->chains) return true;
  uint32_t parts = 1;
  for (size_t i = 0; i < length; ++i) parts += text[i] == ',' || text[i] == '+' ? 1 : 0;
  const size_t texts = (size_t)parts * (strlen(chain_key) + 1) + length + 1;
  groups->parts = malloc(2 * texts);
  groups->group = calloc(parts, sizeof *groups->group);
  if (groups->parts == NULL || groups->group == NULL) return failure_of_memory(failure);
  char *own = groups->parts;
  uint32_t rests = 0;
  groups->count = 1;
  for (const char *at = text, *begin = text;;) {
    struct selection_group *const group = &groups->group[groups->count - 1];
    const size_t part = part_length(at);
    const bool all = part == strlen("chains") && memcmp(at, "chains", part) == 0; /* which stands alone */
    if (part == 0 || all) return refuse(option, text, failure);
    if (!is_new(text, at, part, option, failure) || !add_part(group, option, at, part, &own, failure)) return false;
    const bool alone = at == begin && at[part] != '+';
    if (group->rest && (!alone || ++rests > 1)) return refuse(option, text, failure);
    at += part;
    if (*at != '+') {
      group->name = own;
      memcpy(own, begin, (size_t)(at - begin));
      own[at - begin] = '\0';
      own += at - begin + 1;
      begin = at + 1;
    }
    if (*at == '\0') break;
    groups->count += *at == ',' ? 1 : 0;
    ++at;
  }
  if (groups->count < 2) return refuse(option, text, failure);
  return groups->count <= MOST_GROUPS || failure_in_usage(failure, "%s: more than %d groups", option, MOST_GROUPS);
}

bool selection_groups_suit(const struct selection_groups *groups, const char *option, const struct file_format *format,
                           const struct index_file *index, struct failure *failure) {
  if (groups->text == NULL) return true;
  if (groups->chains && !file_format_has(format, FILE_RESIDUES)) {
    return failure_in_usage(failure, "%s chains has no use here: the file names no chains", option);
  }
  for (uint32_t g = 0; g < groups->count; ++g) {
    if (!selection_suits(&groups->group[g].selection, format, index, failure)) return false;
  }
  return true;
}

void selection_groups_list_unmatched(const struct selection_groups *groups, const struct molecule *molecule,
                                     struct text_buffer *out) {
  for (uint32_t g = 0; g < groups->count; ++g) {
    selection_list_unmatched(&groups->group[g].selection, molecule, out);
  }
}

void selection_groups_free(struct selection_groups *groups) {
  for (uint32_t g = 0; groups->group != NULL && g < groups->count; ++g) selection_free(&groups->group[g].selection);
  free(groups->group);
  free(groups->parts);
  *groups = (struct selection_groups){.text = NULL};
}

/* ---- of a molecule ---- */

static bool find_chains(const char *option, const struct molecule *molecule, struct found_groups *found,
                        struct failure *failure) {
  if (!chain_numbers_make(molecule, &found->of, failure)) return false;
  for (uint32_t i = 0; i < molecule->atoms; ++i) found->count += found->of[i] == found->count ? 1 : 0;
  if (found->count < 2) return failure_in_input(failure, 0, "%s chains: there is one chain alone", option);
  if (found->count > MOST_GROUPS) return failure_in_input(failure, 0, "%s: more than %d chains", option, MOST_GROUPS);
  found->group = calloc(found->count, sizeof *found->group);
  if (found->group == NULL) return failure_of_memory(failure);
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    struct found_group *const group = &found->group[found->of[i]];
    const char *const chain = molecule->label[i].residue->chain;
    if (group->atoms++ == 0) group->name = chain[0] == '\0' ? "." : chain;
  }
  return true;
}

bool selection_groups_find(const struct selection_groups *groups, const char *option, const struct molecule *molecule,
                           struct found_groups *found, struct failure *failure) {
  *found = (struct found_groups){.count = 0};
  if (groups->chains) return find_chains(option, molecule, found, failure);
  found->count = groups->count;
  found->group = calloc(found->count, sizeof *found->group);
  found->of = malloc(((size_t)molecule->atoms + 1) * sizeof *found->of);
  if (found->group == NULL || found->of == NULL) return failure_of_memory(failure);
  uint32_t rest = HSP_NONE;
  for (uint32_t g = 0; g < found->count; ++g) {
    found->group[g].name = groups->group[g].name;
    if (groups->group[g].rest) rest = g;
  }
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    found->of[i] = HSP_NONE;
    for (uint32_t g = 0; g < found->count; ++g) {
      if (g == rest || !selection_takes(&groups->group[g].selection, molecule, i)) continue;
      if (found->of[i] == HSP_NONE) {
        found->of[i] = g;
      } else {
        ++found->group[g].others;
      }
    }
    if (found->of[i] == HSP_NONE) found->of[i] = rest;
    if (found->of[i] != HSP_NONE) ++found->group[found->of[i]].atoms;
  }
  for (uint32_t g = 0; g < found->count; ++g) {
    const struct found_group *const group = &found->group[g];
    if (group->atoms > 0) continue;
    char shown[EXCERPT_BYTES];
    return failure_in_input(failure, 0, "%s: there are no atoms in '%s'%s", option,
                            excerpt(shown, group->name, strlen(group->name)),
                            group->others > 0 ? " but those of a group before it" : "");
  }
  return true;
}

void found_groups_free(struct found_groups *found) {
  free(found->group);
  free(found->of);
  *found = (struct found_groups){.count = 0};
}
