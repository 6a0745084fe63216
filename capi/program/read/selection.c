#include "read/selection.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/characters.h"
#include "read/growing_array.h"
#include "read/number.h"

enum key { KEY_CHAIN, KEY_RESIDUE, KEY_ELEMENT, KEY_ATOM, KEY_GROUP, KEY_WATER, KEY_HETATM, KEY_HYDROGEN };

static const char *const key_names[] = {"chain", "residue", "element", "atom", "group", "water", "hetatm", "hydrogen"};

struct selection_item {
  enum key key;
  struct field text;
  struct element_symbol symbol; /* of elements */
  bool numbers;                 /* of residues: low .. high */
  int64_t low;
  int64_t high;
  char low_code, high_code;        /* insertion codes that the range begins and ends with; '\0': any */
  const struct index_group *group; /* for a group, once it is found */
  bool ends_term;
  bool ends_selection;
  /* In the last item of a selection: */
  bool hides;         /* the selection's atoms are left out */
  const char *option; /* the option before the selection */
  const char *whole;  /* the whole text of the selection */
};

static bool add_item(struct selection *selection, const struct selection_item *item, struct failure *failure) {
  return array_append(&selection->items, &selection->count, &selection->capacity, item, sizeof *item) ||
         failure_of_memory(failure);
}

/* A whole number at the beginning of the text; its length, or 0. More than twelve digits are all the same number. */
static size_t whole_number(struct field text, int64_t *value) {
  size_t at = text.length > 0 && text.text[0] == '-' ? 1 : 0;
  const size_t begin = at;
  *value = 0;
  while (at < text.length && is_digit(text.text[at])) {
    *value = *value < INT64_C(100000000000) ? 10 * *value + (text.text[at] - '0') : INT64_C(1000000000000);
    ++at;
  }
  if (at == begin) return 0;
  if (begin == 1) *value = -*value;
  return at;
}

/* An insertion code, in capitals, that ends at the text's end or before a '-'; '\0' where there is none. */
static char code_at(struct field text, size_t *at) {
  const bool there = *at < text.length && is_letter(text.text[*at]);
  return there ? to_upper(text.text[(*at)++]) : '\0';
}

/* "40", "-5", "1-40", "-5--1", "52A-53". False: the text is no such thing, or "52A" alone. */
static bool parse_numbers(struct selection_item *item) {
  const struct field text = item->text;
  size_t first = whole_number(text, &item->low);
  item->high = item->low;
  item->low_code = item->high_code = '\0';
  if (first == 0) return false;
  if (first == text.length) return true;
  item->low_code = code_at(text, &first);
  if (first == text.length || text.text[first] != '-') return false;
  const struct field rest = {text.text + first + 1, text.length - first - 1};
  size_t second = whole_number(rest, &item->high);
  if (second == 0) return false;
  item->high_code = code_at(rest, &second);
  return second == rest.length;
}

/* Whether no residue is in the range. */
static bool range_is_empty(const struct selection_item *item) {
  if (item->low != item->high) return item->low > item->high;
  return item->high_code != '\0' && item->low_code > item->high_code;
}

static bool parse_item(struct selection_item *item, const char *option, struct failure *failure) {
  char shown[EXCERPT_BYTES];
  const char *key = key_names[item->key];
  if (item->text.length == 0) return failure_in_usage(failure, "%s: an item of '%s:' is empty", option, key);
  if (memchr(item->text.text, ':', item->text.length) != NULL) {
    return failure_in_usage(failure,
                            "%s: '%s' stands in a list of names: for atoms that have both write "
                            "\"chain:A&residue:1-40\", for atoms that have either the option twice",
                            option, excerpt(shown, item->text.text, item->text.length));
  }
  item->numbers = item->key == KEY_RESIDUE && parse_numbers(item);
  if (item->numbers && range_is_empty(item)) {
    return failure_in_usage(failure, "%s: the range '%s' is empty", option,
                            excerpt(shown, item->text.text, item->text.length));
  }
  if (item->key == KEY_ELEMENT && !element_symbol_parse(item->text.text, item->text.length, &item->symbol)) {
    return failure_in_usage(failure, "%s: '%s' is not an element symbol", option,
                            excerpt(shown, item->text.text, item->text.length));
  }
  return true;
}

/* Read the key of a term; items follow unless it is one of the last three. False: the failure says which keys there
 * are. */
static bool parse_key(struct field *term, enum key *key, const char *option, struct failure *failure) {
  char shown[EXCERPT_BYTES];
  const char *colon = term->length == 0 ? NULL : memchr(term->text, ':', term->length);
  const size_t length = colon == NULL ? term->length : (size_t)(colon - term->text);
  for (size_t i = 0; i < sizeof key_names / sizeof key_names[0]; ++i) {
    if (strlen(key_names[i]) != length || memcmp(term->text, key_names[i], length) != 0) continue;
    *key = (enum key)i;
    if ((*key < KEY_WATER) == (colon != NULL)) {
      const size_t before = colon == NULL ? length : length + 1;
      term->text += before;
      term->length -= before;
      return true;
    }
  }
  return failure_in_usage(
      failure,
      "%s: '%s' is none of chain:A, residue:HOH, residue:1-40, element:H, atom:CA, group:NAME, water, "
      "hetatm, hydrogen",
      option, excerpt(shown, term->text, term->length));
}

static bool parse_term(struct selection *selection, struct field term, const char *option, struct failure *failure) {
  struct selection_item item;
  memset(&item, 0, sizeof item);
  if (!parse_key(&term, &item.key, option, failure)) return false;
  if (item.key >= KEY_WATER) {
    item.ends_term = true;
    return add_item(selection, &item, failure);
  }
  for (;;) {
    const char *comma = term.length == 0 ? NULL : memchr(term.text, ',', term.length);
    item.text.text = term.text;
    item.text.length = comma == NULL ? term.length : (size_t)(comma - term.text);
    item.ends_term = comma == NULL;
    if (!parse_item(&item, option, failure) || !add_item(selection, &item, failure)) return false;
    if (item.ends_term) return true;
    term.text = comma + 1;
    term.length -= item.text.length + 1;
  }
}

/* How long the first term is: up to a '&', but not to one in the name of a group. */
static size_t term_length(const char *text) {
  const bool names = strncmp(text, "group:", strlen("group:")) == 0;
  size_t length = strcspn(text, "&");
  while (names && text[length] == '&' && text[length - 1] == '_' && text[length + 1] == '_') {
    length += 1 + strcspn(text + length + 1, "&");
  }
  return length;
}

bool selection_add(struct selection *selection, const char *option, const char *text, bool hide,
                   struct failure *failure) {
  const char *const whole = text;
  for (;;) {
    const struct field term = {text, term_length(text)};
    if (!parse_term(selection, term, option, failure)) return false;
    if (text[term.length] == '\0') break;
    text += term.length + 1;
  }
  struct selection_item *last = &selection->items[selection->count - 1];
  last->ends_selection = true;
  last->hides = hide;
  last->option = option;
  last->whole = whole;
  if (!hide) selection->only = true;
  return true;
}

static bool find_group(struct selection_item *item, const struct index_file *index, struct failure *failure) {
  char shown[EXCERPT_BYTES];
  excerpt(shown, item->text.text, item->text.length);
  if (index->count == 0) return failure_in_usage(failure, "group:%s is of an index file: it needs --index", shown);
  item->group = index_file_find(index, item->text);
  return item->group != NULL || failure_in_usage(failure, "the index file has no group '%s'", shown);
}

bool selection_suits(struct selection *selection, const struct file_format *format, const struct index_file *index,
                     struct failure *failure) {
  for (size_t i = 0; i < selection->count; ++i) {
    const enum key key = selection->items[i].key;
    if (key == KEY_GROUP) {
      if (!find_group(&selection->items[i], index, failure)) return false;
      continue;
    }
    const bool element = key == KEY_ELEMENT || key == KEY_HYDROGEN;
    if (key == KEY_HETATM && file_format_has(format, FILE_RESIDUES) && !file_format_has(format, FILE_HETATM)) {
      return failure_in_usage(failure, "a selection by hetatm has no use here: the file does not tell such atoms");
    }
    if (element ? file_format_has(format, FILE_ELEMENTS) : file_format_has(format, FILE_RESIDUES)) continue;
    return failure_in_usage(failure, "a selection by %s has no use here: the file does not name %s", key_names[key],
                            element ? "elements" : "residues");
  }
  return true;
}

static bool same_text(struct field item, const char *name) {
  size_t i = 0;
  while (i < item.length && to_upper(item.text[i]) == to_upper(name[i])) ++i;
  return i == item.length && name[i] == '\0';
}

static bool holds_of_residue(const struct selection_item *item, const struct residue_label *residue) {
  if (same_text(item->text, residue->name)) return true;
  const struct field written = {residue->number, strlen(residue->number)};
  if (item->numbers) {
    int64_t number;
    if (written.length == 0 || whole_number(written, &number) != written.length) return false;
    if (number < item->low || number > item->high) return false;
    const char code = to_upper(residue->insertion[0]);
    return (number > item->low || item->low_code <= code) &&
           (number < item->high || item->high_code == '\0' || code <= item->high_code);
  }
  char number[sizeof residue->number + sizeof residue->insertion];
  snprintf(number, sizeof number, "%s%s", residue->number, residue->insertion);
  return same_text(item->text, number);
}

static bool holds(const struct selection_item *item, const struct molecule *molecule, uint32_t atom) {
  const struct atom_label *const label = &molecule->label[atom];
  const char *const chain = label->residue->chain;
  switch (item->key) {
    case KEY_CHAIN:
      return chain_is_named(chain, item->text);
    case KEY_RESIDUE:
      return holds_of_residue(item, label->residue);
    case KEY_ELEMENT:
      return strcmp(item->symbol.text, label->element.text) == 0;
    case KEY_ATOM:
      return same_text(item->text, label->name);
    case KEY_GROUP:
      return item->group != NULL &&
             index_group_has(item->group, molecule->place == NULL ? atom : molecule->place[atom]);
    case KEY_WATER:
      return atom_is_water(label);
    case KEY_HETATM:
      return label->hetatm;
    case KEY_HYDROGEN:
      return atom_is_hydrogen(label);
  }
  return false;
}

bool selection_takes(const struct selection *selection, const struct molecule *molecule, uint32_t atom) {
  bool term = false;
  bool all_terms = true;
  bool named = !selection->only;
  for (size_t i = 0; i < selection->count; ++i) {
    const struct selection_item *item = &selection->items[i];
    term = term || holds(item, molecule, atom);
    if (!item->ends_term) continue;
    all_terms = all_terms && term;
    term = false;
    if (!item->ends_selection) continue;
    if (all_terms && item->hides) return false;
    named = named || all_terms;
    all_terms = true;
  }
  return named;
}

static bool any_holds(const struct selection_item *item, const struct molecule *molecule) {
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    if (holds(item, molecule, i)) return true;
  }
  return false;
}

/* Whether any atom is named by the one selection of the items first to last. */
static bool any_named(const struct selection_item *first, size_t count, const struct molecule *molecule) {
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    bool term = false;
    bool all_terms = true;
    for (size_t k = 0; k < count; ++k) {
      term = term || holds(&first[k], molecule, i);
      if (!first[k].ends_term) continue;
      all_terms = all_terms && term;
      term = false;
    }
    if (all_terms) return true;
  }
  return false;
}

void selection_list_unmatched(const struct selection *selection, const struct molecule *molecule,
                              struct text_buffer *out) {
  size_t first = 0;
  for (size_t last = 0; last < selection->count; ++last) {
    if (!selection->items[last].ends_selection) continue;
    const struct selection_item *end = &selection->items[last];
    const size_t before = out->length;
    bool several = false;
    for (size_t i = first; i <= last; ++i) {
      const struct selection_item *item = &selection->items[i];
      several = several || (item->ends_term && i < last);
      if (item->key >= KEY_WATER || any_holds(item, molecule)) continue;
      text_buffer_add(out, "%s%s %s:%.*s", out->length == 0 ? "" : ", ", end->option, key_names[item->key],
                      (int)item->text.length, item->text.text);
    }
    if (several && out->length == before && !any_named(&selection->items[first], last + 1 - first, molecule)) {
      text_buffer_add(out, "%s%s %s", out->length == 0 ? "" : ", ", end->option, end->whole);
    }
    first = last + 1;
  }
}

static void leave_out(struct left_out *left_out, const struct atom_label *label) {
  if (atom_is_water(label)) {
    ++left_out->water;
  } else if (label->hetatm) {
    ++left_out->hetatm;
  } else if (atom_is_hydrogen(label)) {
    ++left_out->hydrogen;
  } else {
    ++left_out->others;
  }
}

/* Atom i becomes the one that follows those taken before, or is left out. */
static void take_or_leave(struct molecule *molecule, uint32_t *taken, uint32_t i, bool takes) {
  if (!takes) {
    leave_out(&molecule->left_out, &molecule->label[i]);
    return;
  }
  molecule_move_atom(molecule, (*taken)++, i);
}

bool selection_apply(const struct selection *selection, struct molecule *molecule, struct failure *failure) {
  uint32_t taken = 0;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    take_or_leave(molecule, &taken, i, selection_takes(selection, molecule, i));
  }
  const uint32_t before = molecule->atoms;
  molecule->atoms = taken;
  if (taken > 0) return true;
  return failure_in_input(failure, 0, "no atoms are left: all %" PRIu32 " are left out by the selection", before);
}

void selection_hide_water(struct molecule *molecule) {
  uint32_t water = 0;
  for (uint32_t i = 0; i < molecule->atoms; ++i) water += atom_is_water(&molecule->label[i]) ? 1 : 0;
  if (water == molecule->atoms) return;
  uint32_t taken = 0;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    take_or_leave(molecule, &taken, i, !atom_is_water(&molecule->label[i]));
  }
  molecule->atoms = taken;
}

void selection_free(struct selection *selection) {
  free(selection->items);
  *selection = (struct selection)SELECTION_EVERYTHING;
}
