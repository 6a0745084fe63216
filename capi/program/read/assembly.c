#include "read/assembly.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read/characters.h"
#include "read/growing_array.h"
#include "read/molecule.h"
#include "read/number.h"

enum { MOST_PARTS = 10000, MOST_OPERATORS = 20000 };

/* Nobody writes more than one line of stderr has room for. */
enum { MOST_LISTED = 6 };

static void free_part(struct assembly_part *part) {
  text_buffer_free(&part->chains);
  text_buffer_free(&part->expression);
}

static struct assembly_part *add_part(struct assemblies *assemblies, struct field name) {
  if (assemblies->parts == MOST_PARTS) { /* more would take too long to compare */
    assemblies->unreadable = true;
    free_part(&assemblies->part[--assemblies->parts]);
  }
  struct assembly_part part = {.first = assemblies->count};
  label_copy(part.name, sizeof part.name, name);
  const bool added = array_append(&assemblies->part, &assemblies->parts, &assemblies->part_room, &part, sizeof part);
  return added ? &assemblies->part[assemblies->parts - 1] : NULL;
}

static struct assembly_operator *add_operator(struct assemblies *assemblies, struct field name) {
  struct assembly_operator one = {.name = ""};
  label_copy(one.name, sizeof one.name, name);
  const bool added = array_append(&assemblies->operators, &assemblies->count, &assemblies->room, &one, sizeof one);
  return added ? &assemblies->operators[assemblies->count - 1] : NULL;
}

static bool is_separator(char c) {
  return c == ',' || is_blank(c) || c == '\n' || c == '\r';
}

/* The next name of a list. *at steps behind it. Empty: there is none. */
static struct field next_name(const struct text_buffer *list, size_t *at) {
  while (*at < list->length && is_separator(list->text[*at])) ++*at;
  const size_t begin = *at;
  while (*at < list->length && !is_separator(list->text[*at])) ++*at;
  return (struct field){list->text == NULL ? "" : list->text + begin, *at - begin};
}

static bool give_up(struct assemblies *assemblies) {
  assemblies->unreadable = true;
  return true;
}

/* BIOMTr n a b c t: row r of operator n of the last part. */
static bool take_biomt(struct assemblies *assemblies, const struct field field[8], size_t fields,
                       struct failure *failure) {
  const size_t row = (size_t)(field[2].text[5] - '1');
  if (fields < 4 || assemblies->parts == 0 || row != assemblies->rows % 3) return give_up(assemblies);
  if (assemblies->part[assemblies->parts - 1].chains.length == 0) return give_up(assemblies);
  if (row == 0 && add_operator(assemblies, field[3]) == NULL) return failure_of_memory(failure);
  if (!symmetry_row(field, fields, row, &assemblies->operators[assemblies->count - 1].to)) return give_up(assemblies);
  assemblies->rows = row + 1;
  assemblies->part[assemblies->parts - 1].count = assemblies->count - assemblies->part[assemblies->parts - 1].first;
  return true;
}

/* The first words of a line that begins a part: APPLY, or IN ADDITION APPLY. */
static bool begins_part(const struct field *word, size_t words) {
  static const char *const addition[] = {"IN", "ADDITION", "APPLY"};
  if (field_is(word[0], "APPLY")) return true;
  for (size_t k = 0; k < 3; ++k) {
    if (k == words || !field_is(word[k], addition[k])) return false;
  }
  return true;
}

/* Whether operators for chains of its own are announced, in whatever words. */
static bool announces_operators(const struct field *word, size_t words) {
  for (size_t k = 0; k + 2 < words; ++k) {
    if (field_is(word[k], "THE") && field_is(word[k + 1], "FOLLOWING") && field_is(word[k + 2], "TO")) return true;
  }
  return false;
}

/* Whether a line without a colon leaves the chains of its operators to the next line. */
static bool breaks_off(const struct field *word, size_t words) {
  const struct field last = word[words - 1];
  return begins_part(word, words) && (field_is(last, "FOLLOWING") || field_is(last, "TO") || field_is(last, "CHAINS"));
}

/* Whether the line is "CHAINS: A" or "TO CHAINS: A". */
static bool names_chains(const struct field *word, size_t words) {
  const size_t at = field_is(word[0], "TO") && words > 1 ? 1 : 0;
  return field_is(word[at], "CHAINS:") || field_is(word[at], "CHAIN:");
}

/* Whether a line has nothing but names of chains, which have one or two letters. */
static bool are_chains(struct field line) {
  size_t letters = 0, longest = 0;
  for (size_t at = 0; at < line.length; ++at) {
    letters = is_separator(line.text[at]) ? 0 : letters + 1;
    longest = letters > longest ? letters : longest;
  }
  return longest == 1 || longest == 2;
}

static bool add_chains(struct assembly_part *part, struct field names, struct failure *failure) {
  text_buffer_append(&part->chains, ",", 1);
  text_buffer_append(&part->chains, names.text, names.length);
  return !part->chains.out_of_memory || failure_of_memory(failure);
}

/* A line without a colon, before the first operator of the last part: further chains, or a remark. */
static bool take_further_chains(struct assemblies *assemblies, struct field line, struct failure *failure) {
  struct assembly_part *const part = &assemblies->part[assemblies->parts - 1];
  const struct text_buffer *const list = &part->chains;
  if (are_chains(line)) return add_chains(part, line, failure);
  return (list->length > 0 && list->text[list->length - 1] != ',') || give_up(assemblies);
}

bool assemblies_take_pdb_record(struct assemblies *assemblies, const struct line_reader *reader,
                                struct failure *failure) {
  enum { MOST_FIELDS = 40 }; /* of 80 columns */
  static const char lead[] = "REMARK 350 ";
  if (reader->length < sizeof lead || memcmp(reader->text, lead, sizeof lead - 1) != 0) return true;
  struct field field[MOST_FIELDS];
  const size_t fields = fields_split(reader->text, reader->length, field, MOST_FIELDS);
  const char *const colon = memchr(reader->text, ':', reader->length);
  if (fields < 3) return true;
  if (field[2].length == 6 && memcmp(field[2].text, "BIOMT", 5) == 0 && field[2].text[5] >= '1' &&
      field[2].text[5] <= '3') {
    return take_biomt(assemblies, field, fields, failure);
  }
  const size_t words = (fields < MOST_FIELDS ? fields : MOST_FIELDS) - 2;
  const bool announced = announces_operators(field + 2, words), known = begins_part(field + 2, words);
  const bool broken_off = colon == NULL && breaks_off(field + 2, words);
  /* The list of chains goes on up to the first operator. */
  const bool open = assemblies->parts > 0 && assemblies->rows == 0;
  if (colon == NULL && !announced && !broken_off) {
    const size_t begin = (size_t)(field[2].text - reader->text) + 1;
    const struct field line = field_in_columns(reader->text, reader->length, begin, reader->length);
    return !open || take_further_chains(assemblies, line, failure);
  }
  /* Its operators must not go to the chains of the part before. */
  if (announced && ((colon == NULL && !broken_off) || !known)) assemblies->unreadable = true;
  const size_t behind = colon == NULL ? reader->length : (size_t)(colon + 1 - reader->text);
  const struct field value = field_in_columns(reader->text, reader->length, behind + 1, reader->length);
  if (field_is(field[2], "BIOMOLECULE:")) label_copy(assemblies->name, sizeof assemblies->name, value);
  const bool begins = announced || known;
  const bool goes_on = assemblies->parts > 0 && (field_is(field[2], "AND") || (open && names_chains(field + 2, words)));
  if (!begins && !goes_on) return true;
  const struct field name = {assemblies->name, strlen(assemblies->name)};
  struct assembly_part *const part = begins ? add_part(assemblies, name) : &assemblies->part[assemblies->parts - 1];
  if (part == NULL) return failure_of_memory(failure);
  if (begins) assemblies->rows = 0;
  return broken_off || add_chains(part, value, failure);
}

bool assemblies_add_part(struct assemblies *assemblies, struct field name, struct field expression, struct field chains,
                         struct failure *failure) {
  struct assembly_part *const part = add_part(assemblies, name);
  if (part == NULL) return failure_of_memory(failure);
  text_buffer_append(&part->chains, chains.text, chains.length);
  text_buffer_append(&part->expression, expression.text, expression.length);
  return !(part->chains.out_of_memory || part->expression.out_of_memory) || failure_of_memory(failure);
}

bool assemblies_add_operator(struct assemblies *assemblies, struct field name, const struct field number[12],
                             struct failure *failure) {
  struct assembly_operator *const own = add_operator(assemblies, name);
  if (own == NULL) return failure_of_memory(failure);
  for (size_t k = 0; k < 12; ++k) {
    double *const value = k < 9 ? &own->to.rotation[k] : &own->to.translation[k - 9];
    if (number_parse(number[k].text, number[k].length, value) != NUMBER_OK) return give_up(assemblies);
  }
  return true;
}

/* ---- operators of a part ---- */

struct operator_list {
  struct symmetry_operator *of;
  size_t count, room;
};

static bool list_add(struct operator_list *list, const struct symmetry_operator *added, struct failure *failure) {
  if (list->count == MOST_OPERATORS) {
    return failure_in_input(failure, 0, "an assembly of more than %d operators", (int)MOST_OPERATORS);
  }
  return array_append(&list->of, &list->count, &list->room, added, sizeof *added) || failure_of_memory(failure);
}

/* The operator that does what `first` does, and then `second`. */
static struct symmetry_operator product(const struct symmetry_operator *second, const struct symmetry_operator *first) {
  struct symmetry_operator out;
  for (int row = 0; row < 3; ++row) {
    const double *const r = second->rotation + 3 * row;
    for (int column = 0; column < 3; ++column) {
      out.rotation[3 * row + column] =
          r[0] * first->rotation[column] + r[1] * first->rotation[3 + column] + r[2] * first->rotation[6 + column];
    }
  }
  symmetry_apply(second, first->translation, out.translation);
  return out;
}

static const struct symmetry_operator *find_operator(const struct assemblies *assemblies, struct field name) {
  for (size_t k = 0; k < assemblies->count; ++k) {
    const char *const own = assemblies->operators[k].name;
    if (strlen(own) == name.length && memcmp(own, name.text, name.length) == 0) return &assemblies->operators[k].to;
  }
  return NULL;
}

static bool add_named(const struct assemblies *assemblies, struct field name, struct operator_list *list,
                      struct failure *failure) {
  const struct symmetry_operator *const found = find_operator(assemblies, name);
  char shown[EXCERPT_BYTES];
  if (found != NULL) return list_add(list, found, failure);
  return failure_in_input(failure, 0, "_pdbx_struct_assembly_gen: there is no operator '%s'",
                          excerpt(shown, name.text, name.length));
}

/* One item of a group: a name, or a range of numbers, 1-60. */
static bool add_item(const struct assemblies *assemblies, struct field item, struct operator_list *list,
                     struct failure *failure) {
  const char *const dash = item.length == 0 ? NULL : memchr(item.text, '-', item.length);
  uint64_t low = 0, high = 0;
  const size_t before = dash == NULL ? 0 : (size_t)(dash - item.text);
  if (dash == NULL || find_operator(assemblies, item) != NULL ||
      number_parse_count(item.text, before, &low) != NUMBER_OK ||
      number_parse_count(dash + 1, item.length - before - 1, &high) != NUMBER_OK || high < low) {
    return add_named(assemblies, item, list, failure);
  }
  for (uint64_t number = low; number <= high; ++number) {
    char name[24];
    const int length = snprintf(name, sizeof name, "%" PRIu64, number);
    if (!add_named(assemblies, (struct field){name, (size_t)length}, list, failure)) return false;
    if (number == UINT64_MAX) break;
  }
  return true;
}

/* The operators of an expression: groups in parentheses are applied from the right to the left, as the dictionary of
 * mmCIF has it. */
static bool expand_expression(const struct assemblies *assemblies, const struct text_buffer *text,
                              struct operator_list *list, struct failure *failure) {
  static const struct symmetry_operator identity = {{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
  bool done = list_add(list, &identity, failure);
  for (size_t at = 0; done && at < text->length;) {
    struct operator_list group = {NULL, 0, 0}, products = {NULL, 0, 0};
    const char *const begin = text->text + at;
    size_t length = strcspn(begin, "()");
    const size_t named = length;
    for (size_t from = 0; done && from <= named;) {
      const size_t size = strcspn(begin + from, ",()");
      struct field item = {begin + from, size};
      while (item.length > 0 && is_separator(item.text[0])) ++item.text, --item.length;
      while (item.length > 0 && is_separator(item.text[item.length - 1])) --item.length;
      if (item.length > 0) done = add_item(assemblies, item, &group, failure);
      from += size + 1;
    }
    at += length + 1;
    for (size_t a = 0; done && group.count > 0 && a < list->count; ++a) {
      for (size_t b = 0; done && b < group.count; ++b) {
        const struct symmetry_operator both = product(&list->of[a], &group.of[b]);
        done = list_add(&products, &both, failure);
      }
    }
    if (group.count > 0) {
      free(list->of);
      *list = products;
    }
    free(group.of);
  }
  return done;
}

static bool expand(const struct assemblies *assemblies, const struct assembly_part *part, struct operator_list *list,
                   struct failure *failure) {
  *list = (struct operator_list){NULL, 0, 0};
  if (assemblies->unreadable)
    return failure_in_input(failure, 0, "the operators of the file's assemblies cannot be read");
  if (part->expression.length > 0) return expand_expression(assemblies, &part->expression, list, failure);
  for (size_t k = 0; k < part->count; ++k) {
    if (!list_add(list, &assemblies->operators[part->first + k].to, failure)) return false;
  }
  return list->count > 0 || failure_in_input(failure, 0, "assembly '%s' has no operators", part->name);
}

/* ---- chains of a part ---- */

/* The search begins at *from, where the last one ended: chains come in the order of the list. */
static bool has_chain(const struct assembly_part *part, const char *chain, size_t *from) {
  const size_t length = strlen(chain), begin = *from;
  const bool nameless = chain_is_nameless(chain);
  bool wrapped = false;
  for (size_t at = begin; !wrapped || at < begin;) {
    const struct field name = next_name(&part->chains, &at);
    if (name.length == 0) {
      if (wrapped) return false;
      wrapped = true;
      at = 0;
      continue;
    }
    *from = at;
    if (length == name.length && memcmp(chain, name.text, length) == 0) return true;
    if (nameless && field_is(name, "NULL")) return true;
  }
  return false;
}

static const char *chain_of(const struct molecule *molecule, const struct residue_label *residue) {
  return residue->asym > 0 ? molecule->asyms.names[residue->asym - 1].text : residue->chain;
}

static bool same_chain(const struct residue_label *a, const struct residue_label *b) {
  return a == b || (a->asym == b->asym && strcmp(a->chain, b->chain) == 0);
}

/* ---- copies ---- */

/* Copies of the first `atoms` that are in the part by an operator. number[atoms]: how many copies there are before. */
static bool add_copy(struct molecule *molecule, uint32_t atoms, const uint8_t *in, const uint32_t *number,
                     uint32_t further, const struct symmetry_operator *to, struct failure *failure) {
  const struct residue_label *before = NULL; /* the residue that the last one is a copy of */
  for (uint32_t i = 0; i < atoms; ++i) {
    if (!in[i]) continue;
    double moved[3];
    symmetry_apply(to, molecule->xyz + 3 * (size_t)i, moved);
    for (int k = 0; k < 3; ++k) {
      if (!is_finite(moved[k])) return failure_in_input(failure, molecule->line[i], "a coordinate is too large");
    }
    struct atom_label label = molecule->label[i];
    struct residue_label residue = *label.residue;
    if (label.residue == before) {
      label.residue = molecule->label[molecule->atoms - 1].residue;
    } else {
      before = label.residue;
      label.residue = &residue;
      if (!chain_name_copy(&residue, (uint64_t)number[i] + further + 1, failure)) return false;
    }
    if (!molecule_add(molecule, moved, molecule->radius[i], &label, molecule->line[i], failure)) return false;
    if (molecule->place != NULL) molecule->place[molecule->atoms - 1] = molecule->place[i];
    if (molecule->extra != NULL) molecule->extra[molecule->atoms - 1] = molecule->extra[i];
  }
  return true;
}

/* Append all copies. */
static bool add_copies(struct molecule *molecule, uint32_t atoms, uint8_t *in, uint32_t *number,
                       struct failure *failure) {
  struct assemblies *const assemblies = &molecule->assemblies;
  bool done = true;
  for (size_t k = 0; done && k < assemblies->parts; ++k) {
    const struct assembly_part *const part = &assemblies->part[k];
    if (strcmp(part->name, molecule->choice.assembly) != 0) continue;
    struct operator_list list;
    size_t at = 0;
    for (uint32_t i = 0; i < atoms; ++i) {
      const struct residue_label *const own = molecule->label[i].residue;
      const bool as_before = i > 0 && same_chain(molecule->label[i - 1].residue, own);
      in[i] = as_before ? in[i - 1] : has_chain(part, chain_of(molecule, own), &at);
    }
    done = expand(assemblies, part, &list, failure);
    for (size_t op = 0; done && op < list.count; ++op) {
      done = add_copy(molecule, atoms, in, number, (uint32_t)op, &list.of[op], failure);
    }
    for (uint32_t i = 0; i < atoms; ++i) number[i] += in[i] ? (uint32_t)list.count : 0;
    assemblies->made += list.count;
    free(list.of);
  }
  return done;
}

static bool is_listed_before(const struct assemblies *assemblies, size_t part) {
  for (size_t k = 0; k < part; ++k) {
    if (strcmp(assemblies->part[k].name, assemblies->part[part].name) == 0) return true;
  }
  return false;
}

static void list_name(struct text_buffer *out, const char *name, size_t listed) {
  char shown[EXCERPT_BYTES];
  excerpt(shown, name, strlen(name));
  if (listed < MOST_LISTED) text_buffer_add(out, "%s%s", listed == 0 ? "" : ", ", shown);
  if (listed == MOST_LISTED) text_buffer_add(out, " and more");
}

static bool report_none(const struct molecule *molecule, struct failure *failure) {
  const struct assemblies *const assemblies = &molecule->assemblies;
  struct text_buffer list = TEXT_BUFFER_EMPTY;
  size_t listed = 0;
  char shown[EXCERPT_BYTES];
  if (assemblies->parts == 0) return failure_in_input(failure, 0, "the file states no assemblies: not with --assembly");
  for (size_t k = 0; k < assemblies->parts && listed <= MOST_LISTED; ++k) {
    if (!is_listed_before(assemblies, k)) list_name(&list, assemblies->part[k].name, listed++);
  }
  if (list.out_of_memory) {
    failure_of_memory(failure);
  } else {
    failure_in_input(failure, 0, "no assembly '%s': the file has %s",
                     excerpt(shown, molecule->choice.assembly, strlen(molecule->choice.assembly)), list.text);
  }
  text_buffer_free(&list);
  return false;
}

bool assembly_make(struct molecule *molecule, struct failure *failure) {
  const struct assemblies *const assemblies = &molecule->assemblies;
  const uint32_t atoms = molecule->atoms, read = molecule->read;
  bool any = false;
  for (size_t k = 0; k < assemblies->parts; ++k) {
    any = any || strcmp(assemblies->part[k].name, molecule->choice.assembly) == 0;
  }
  if (!any) return report_none(molecule, failure);
  uint8_t *const in = malloc((size_t)atoms + 1);
  uint32_t *const number = calloc((size_t)atoms + 1, sizeof *number);
  bool done = (in != NULL && number != NULL) || failure_of_memory(failure);
  done = done && add_copies(molecule, atoms, in, number, failure);
  for (uint32_t i = 0; done && i < atoms; ++i) {
    if (number[i] == 0) ++molecule->left_out.others;
  }
  free(in);
  free(number);
  if (!done) return false;
  /* The copies take the places of the atoms before them. */
  for (uint32_t i = atoms; i < molecule->atoms; ++i) molecule_move_atom(molecule, i - atoms, i);
  molecule->atoms -= atoms;
  molecule->read = read;
  return molecule->atoms > 0 ||
         failure_in_input(failure, 0, "assembly '%s' has none of the chains that are read", molecule->choice.assembly);
}

/* ---- whether they differ from what is read ---- */

static bool is_identity(const struct symmetry_operator *to) {
  static const double blur = 1e-4; /* of matrices with six decimals, and of angstrom */
  for (int k = 0; k < 9; ++k) {
    if (!(fabs(to->rotation[k] - (k % 4 == 0 ? 1.0 : 0.0)) <= blur)) return false;
  }
  return fabs(to->translation[0]) <= blur && fabs(to->translation[1]) <= blur && fabs(to->translation[2]) <= blur;
}

/* Whether the part leaves its chains as they are. */
static bool is_plain(const struct assemblies *assemblies, const struct assembly_part *part) {
  struct failure unused = FAILURE_NONE;
  struct operator_list list;
  const bool plain = expand(assemblies, part, &list, &unused) && list.count == 1 && is_identity(&list.of[0]);
  free(list.of);
  return plain;
}

/* Whether one part of the assembly has the chain. */
static bool is_in_one(struct assemblies *assemblies, const char *name, const char *chain) {
  size_t count = 0;
  for (size_t k = 0; k < assemblies->parts; ++k) {
    struct assembly_part *const part = &assemblies->part[k];
    if (strcmp(part->name, name) == 0 && has_chain(part, chain, &part->looked_at)) ++count;
  }
  return count == 1;
}

/* Whether the assembly has each chain that was read once. Atoms without a chain's name count for nothing: old files
 * have their water so. */
static bool has_all_once(struct molecule *molecule, const char *assembly) {
  struct assemblies *const assemblies = &molecule->assemblies;
  for (size_t k = 0; k < molecule->asyms.count; ++k) {
    if (!is_in_one(assemblies, assembly, molecule->asyms.names[k].text)) return false;
  }
  for (uint32_t i = 0; molecule->asyms.count == 0 && i < molecule->atoms; ++i) {
    const struct residue_label *const own = molecule->label[i].residue;
    if (i > 0 && same_chain(molecule->label[i - 1].residue, own)) continue;
    if (!chain_is_nameless(own->chain) && !is_in_one(assemblies, assembly, own->chain)) return false;
  }
  return true;
}

bool assemblies_list_others(struct molecule *molecule, struct text_buffer *out) {
  const struct assemblies *const assemblies = &molecule->assemblies;
  size_t listed = 0;
  for (size_t k = 0; k < assemblies->parts && listed <= MOST_LISTED; ++k) {
    const char *const name = assemblies->part[k].name;
    if (is_listed_before(assemblies, k)) continue;
    bool plain = true;
    for (size_t other = k; plain && other < assemblies->parts; ++other) {
      if (strcmp(assemblies->part[other].name, name) == 0) plain = is_plain(assemblies, &assemblies->part[other]);
    }
    if (!plain || !has_all_once(molecule, name)) list_name(out, name, listed++);
  }
  return !out->out_of_memory;
}

void assemblies_free(struct assemblies *assemblies) {
  for (size_t k = 0; k < assemblies->parts; ++k) free_part(&assemblies->part[k]);
  free(assemblies->part);
  free(assemblies->operators);
  memset(assemblies, 0, sizeof *assemblies);
}
