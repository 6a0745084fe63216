#include "commands/tunnel_exchange.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read/residue_kinds.h"
#include "read/residues.h"
#include "read/vectors.h"
#include "write/cif_output.h"
#include "write/output_file.h"

enum { MOST_NEAREST = 4, MILLION = 1000000 };

/* A residue that lines a tunnel with its backbone, or with other atoms. */
struct lining {
  const struct residue_label *residue;
  bool backbone;
};

/* A stretch with the same lining. */
struct layer {
  size_t first, end; /* steps */
  double least;      /* radius */
  double least_free;
};

struct tunnel_lining {
  const struct pores_found *found;
  const struct molecule *molecule;
  uint32_t *backbone; /* [backbones], atoms */
  uint32_t backbones;
  struct lining *lining; /* [linings] of this tunnel, in the order of the way */
  uint32_t linings;
  struct layer *layer;            /* [layers] */
  uint32_t (*near)[MOST_NEAREST]; /* [steps], ascending, then UINT32_MAX */
  size_t layers;
};

static bool is_backbone(const struct atom_label *label) {
  static const char *const names[] = {"N", "CA", "C", "O", "OXT"};
  if (residue_kind_of(label->residue->name) != RESIDUE_AMINO_ACID) return false;
  for (size_t k = 0; k < sizeof names / sizeof names[0]; ++k) {
    if (strcmp(label->name, names[k]) == 0) return true;
  }
  return false;
}

struct residue_scale {
  char name[5];
  int charge;
  double hydropathy; /* Kyte and Doolittle 1982 */
};

/* NULL for residues that have none. Behind the twenty come names of MD programs for states of protonation and bridges,
 * and selenomethionine. */
static const struct residue_scale *scale_of(const struct residue_label *residue) {
  static const struct residue_scale scales[] = {
      {"ALA", 0, 1.8},   {"ARG", 1, -4.5},  {"ASN", 0, -3.5},  {"ASP", -1, -3.5}, {"CYS", 0, 2.5},   {"GLN", 0, -3.5},
      {"GLU", -1, -3.5}, {"GLY", 0, -0.4},  {"HIS", 1, -3.2},  {"ILE", 0, 4.5},   {"LEU", 0, 3.8},   {"LYS", 1, -3.9},
      {"MET", 0, 1.9},   {"PHE", 0, 2.8},   {"PRO", 0, -1.6},  {"SER", 0, -0.8},  {"THR", 0, -0.7},  {"TRP", 0, -0.9},
      {"TYR", 0, -1.3},  {"VAL", 0, 4.2},   {"ARN", 0, -4.5},  {"ASH", 0, -3.5},  {"CYM", -1, 2.5},  {"CYX", 0, 2.5},
      {"GLH", 0, -3.5},  {"HID", 0, -3.2},  {"HIE", 0, -3.2},  {"HIP", 1, -3.2},  {"HSD", 0, -3.2},  {"HSE", 0, -3.2},
      {"HSP", 1, -3.2},  {"LYN", 0, -3.9},  {"MSE", 0, 1.9},   {"TYM", -1, -1.3}, {"ASPH", 0, -3.5}, {"CYSH", 0, 2.5},
      {"GLUH", 0, -3.5}, {"HISD", 0, -3.2}, {"HISE", 0, -3.2}, {"HISH", 1, -3.2}, {"LYSH", 1, -3.9}};
  for (size_t k = 0; k < sizeof scales / sizeof scales[0]; ++k) {
    if (strcmp(residue->name, scales[k].name) == 0) return &scales[k];
  }
  return NULL;
}

/* ---- the lining of a tunnel ---- */

/* Its place in the list, at whose end it is if it is new. The atoms of a residue may stand apart in the file. */
static uint32_t lining_of(struct tunnel_lining *tunnel, uint32_t ball) {
  const struct atom_label *const label = &tunnel->molecule->label[ball];
  const struct lining lining = {label->residue, is_backbone(label)};
  uint32_t k = 0;
  while (k < tunnel->linings && (!residue_label_same(tunnel->lining[k].residue, lining.residue) ||
                                 tunnel->lining[k].backbone != lining.backbone)) {
    ++k;
  }
  if (k == tunnel->linings) tunnel->lining[tunnel->linings++] = lining;
  return k;
}

/* Each once, ascending. */
static void find_near(struct tunnel_lining *tunnel, size_t step) {
  const hsp_tunnel_point *const point = &tunnel->found->steps[step].point;
  uint32_t *const near = tunnel->near[step];
  int count = 0;
  for (int k = 0; k < MOST_NEAREST; ++k) near[k] = UINT32_MAX;
  for (int k = 0; k < MOST_NEAREST && point->ball[k] != HSP_NONE; ++k) {
    const uint32_t lining = lining_of(tunnel, point->ball[k]);
    int at = count;
    while (at > 0 && near[at - 1] > lining) --at;
    if (at > 0 && near[at - 1] == lining) continue;
    memmove(near + at + 1, near + at, (size_t)(count - at) * sizeof *near);
    near[at] = lining;
    ++count;
  }
}

/* Infinite without a backbone. */
static double free_radius(const struct tunnel_lining *tunnel, const double xyz[3]) {
  double least = HUGE_VAL;
  for (uint32_t k = 0; k < tunnel->backbones; ++k) {
    const uint32_t atom = tunnel->backbone[k];
    const double *const centre = tunnel->molecule->xyz + 3 * (size_t)atom;
    least = fmin(least, distance_between(xyz, centre) - tunnel->molecule->radius[atom]);
  }
  return least;
}

/* The place of a step as a share of its tunnel's length, as the file has it. It is a key of the file's rows: of several
 * steps with the same one only the first counts. */
static long millionths_at(const struct tunnel_lining *tunnel, size_t step, size_t end) {
  const double length = tunnel->found->steps[end - 1].length;
  return length > 0.0 ? lround((double)MILLION * tunnel->found->steps[step].length / length) : 0;
}

static void find_layers(struct tunnel_lining *tunnel, size_t first, size_t end) {
  size_t before = first;
  tunnel->linings = 0;
  tunnel->layers = 0;
  for (size_t i = first; i < end; ++i) {
    const hsp_tunnel_point *const point = &tunnel->found->steps[i].point;
    if (i == first || millionths_at(tunnel, i, end) != millionths_at(tunnel, before, end)) {
      find_near(tunnel, i);
      if (i == first || memcmp(tunnel->near[i], tunnel->near[before], sizeof *tunnel->near) != 0) {
        tunnel->layer[tunnel->layers++] = (struct layer){i, i, HUGE_VAL, HUGE_VAL};
      }
      before = i;
    }
    struct layer *const layer = &tunnel->layer[tunnel->layers - 1];
    layer->end = i + 1;
    layer->least = fmin(layer->least, point->radius);
    layer->least_free = fmin(layer->least_free, free_radius(tunnel, point->xyz));
  }
}

/* ---- writing ---- */

static void add_number(struct text_buffer *out, double number) {
  if (isfinite(number)) {
    text_buffer_add(out, "%.4f ", number + 0.0);
  } else {
    text_buffer_add_text(out, "? ");
  }
}

static void add_whether(struct text_buffer *out, bool whether) {
  text_buffer_add(out, "%s ", whether ? "True" : "False");
}

static void add_sites(struct text_buffer *out, const struct molecule *molecule) {
  const bool has_factors = molecule->extra != NULL && file_format_has(molecule->format, FILE_TEMPERATURE_FACTORS);
  cif_sites_begin(out);
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const struct atom_label *const label = &molecule->label[i];
    const struct residue_label *const residue = label->residue;
    const double *const xyz = molecule->xyz + 3 * (size_t)i;
    const struct site site = {label->hetatm ? "HETATM" : "ATOM",
                              label->element.text,
                              label->name,
                              residue->name,
                              residue->chain,
                              residue->number,
                              residue->insertion,
                              xyz,
                              has_factors && molecule->extra[i].has_value ? molecule->extra[i].value : 0.0};
    cif_site(out, i + 1, &site);
  }
}

static void add_channels(struct text_buffer *out, const struct pores_found *found) {
  static const char *const items[] = {"id", "type", "method", "software", "auto", "cavity"};
  cif_loop(out, "sb_ncbr_channel", items, sizeof items / sizeof items[0]);
  for (uint32_t t = 0; t < found->tunnel_count; ++t) {
    text_buffer_add(out, "%" PRIu32 " Tunnel pores hardsphere False %" PRIu32 "\n", t + 1, found->counts.cavities);
  }
}

/* The sum of the charges of the residues, each once; *positive and *negative become how many have one, *hydropathy
 * their mean. */
static int add_up(const struct tunnel_lining *tunnel, const uint32_t near[MOST_NEAREST], int *positive, int *negative,
                  double *hydropathy) {
  int known = 0;
  double sum = 0.0;
  *positive = *negative = 0;
  for (int k = 0; k < MOST_NEAREST && near[k] != UINT32_MAX; ++k) {
    const struct residue_label *const residue = tunnel->lining[near[k]].residue;
    const struct residue_scale *const scale = scale_of(residue);
    bool again = false;
    for (int j = 0; j < k; ++j) again = again || residue_label_same(tunnel->lining[near[j]].residue, residue);
    if (scale == NULL || again) continue;
    ++known;
    sum += scale->hydropathy;
    *positive += scale->charge > 0;
    *negative += scale->charge < 0;
  }
  *hydropathy = known > 0 ? sum / known : HUGE_VAL;
  return *positive - *negative;
}

/* Rows of each category: they stand together in the file, tunnel after tunnel. */
enum { PROFILE, LAYER, RESIDUE, LAYER_RESIDUE, CATEGORIES };

static void add_profile(struct text_buffer *out, const struct tunnel_lining *tunnel, size_t first, size_t end) {
  const struct tunnel_step *const steps = tunnel->found->steps;
  long before = -1;
  for (size_t i = first; i < end; ++i) {
    const hsp_tunnel_point *const point = &steps[i].point;
    const long millionths = millionths_at(tunnel, i, end);
    int positive, negative;
    double hydropathy;
    if (millionths == before) continue;
    before = millionths;
    text_buffer_add(out, "%" PRIu32 " ", steps[i].tunnel);
    add_number(out, point->radius);
    add_number(out, free_radius(tunnel, point->xyz));
    add_number(out, steps[i].length);
    text_buffer_add(out, "%ld.%06ld ", millionths / MILLION, millionths % MILLION);
    for (int axis = 0; axis < 3; ++axis) add_number(out, point->xyz[axis]);
    text_buffer_add(out, "%d\n", add_up(tunnel, tunnel->near[i], &positive, &negative, &hydropathy));
  }
}

static void add_layers(struct text_buffer out[CATEGORIES], const struct tunnel_lining *tunnel, uint32_t number,
                       size_t end) {
  const struct tunnel_step *const steps = tunnel->found->steps;
  const struct layer *const layer = tunnel->layer;
  size_t tightest = 0;
  for (size_t k = 1; k < tunnel->layers; ++k) tightest = layer[k].least < layer[tightest].least ? k : tightest;
  for (size_t k = 0; k < tunnel->layers; ++k) {
    const uint32_t *const near = tunnel->near[layer[k].first];
    const bool inner = k > 0 && k + 1 < tunnel->layers;
    int positive, negative;
    double hydropathy;
    const int charge = add_up(tunnel, near, &positive, &negative, &hydropathy);
    text_buffer_add(&out[LAYER], "%" PRIu32 " %" PRIu32 " ", number, (uint32_t)k + 1);
    add_number(&out[LAYER], layer[k].least);
    add_number(&out[LAYER], layer[k].least_free);
    add_number(&out[LAYER], steps[layer[k].first].length);
    add_number(&out[LAYER], steps[layer[k].end < end ? layer[k].end : end - 1].length);
    add_whether(&out[LAYER], inner && layer[k].least < layer[k - 1].least && layer[k].least < layer[k + 1].least);
    add_whether(&out[LAYER], k == tightest);
    text_buffer_add(&out[LAYER], "%d %d %d ? ", charge, positive, negative);
    add_number(&out[LAYER], hydropathy);
    text_buffer_add_text(&out[LAYER], "? ?\n");
    for (int n = 0; n < MOST_NEAREST && near[n] != UINT32_MAX; ++n) {
      text_buffer_add(&out[LAYER_RESIDUE], "%" PRIu32 " %" PRIu32 " %d %" PRIu32 "\n", number, (uint32_t)k + 1, n + 1,
                      near[n] + 1);
    }
  }
}

static void add_residues(struct text_buffer *out, const struct tunnel_lining *tunnel, uint32_t number) {
  for (uint32_t k = 0; k < tunnel->linings; ++k) {
    text_buffer_add(out, "%" PRIu32 " %" PRIu32 " ", number, k + 1);
    cif_text(out, tunnel->lining[k].residue->number);
    cif_text(out, tunnel->lining[k].residue->chain);
    text_buffer_add(out, "%s\n", tunnel->lining[k].backbone ? "True" : "False");
  }
}

static void add_tunnels(struct text_buffer out[CATEGORIES], struct tunnel_lining *tunnel) {
  const struct pores_found *const found = tunnel->found;
  for (size_t first = 0, end; first < found->step_count; first = end) {
    const uint32_t number = found->steps[first].tunnel;
    for (end = first; end < found->step_count && found->steps[end].tunnel == number;) ++end;
    find_layers(tunnel, first, end);
    add_profile(&out[PROFILE], tunnel, first, end);
    add_layers(out, tunnel, number, end);
    add_residues(&out[RESIDUE], tunnel, number);
  }
}

struct category {
  const char *name;
  const char *items[16];
  size_t count;
};

static void add_categories(struct text_buffer *all, const struct text_buffer out[CATEGORIES]) {
  static const struct category categories[CATEGORIES] = {
      {"sb_ncbr_channel_profile", {"channel_id", "radius", "free_radius", "distance", "T", "x", "y", "z", "charge"}, 9},
      {"sb_ncbr_channel_layer",
       {"channel_id", "order", "min_radius", "min_free_radius", "start_distance", "end_distance", "local_minimum",
        "bottleneck", "charge", "numPositives", "numNegatives", "hydrophobicity", "hydropathy", "polarity",
        "mutability"},
       15},
      {"sb_ncbr_channel_residue", {"channel_id", "order", "sequence_number", "chain_id", "backbone"}, 5},
      {"sb_ncbr_channel_layer_residue", {"channel_id", "layer_id", "order", "residue_id"}, 4}};
  for (int c = 0; c < CATEGORIES; ++c) {
    all->out_of_memory = all->out_of_memory || out[c].out_of_memory;
    if (out[c].length == 0) continue;
    cif_loop(all, categories[c].name, categories[c].items, categories[c].count);
    text_buffer_append(all, out[c].text, out[c].length);
  }
}

bool tunnel_exchange_write(const struct pores_found *found, const struct molecule *molecule, const char *path,
                           struct failure *failure) {
  const size_t steps = found->step_count;
  struct text_buffer all = TEXT_BUFFER_EMPTY, rows[CATEGORIES] = {TEXT_BUFFER_EMPTY};
  struct tunnel_lining tunnel = {.found = found, .molecule = molecule};
  tunnel.backbone = calloc((size_t)molecule->atoms + 1, sizeof *tunnel.backbone);
  tunnel.lining = calloc(MOST_NEAREST * steps + 1, sizeof *tunnel.lining);
  tunnel.layer = calloc(steps + 1, sizeof *tunnel.layer);
  tunnel.near = calloc(steps + 1, sizeof *tunnel.near);
  bool done = tunnel.backbone != NULL && tunnel.lining != NULL && tunnel.layer != NULL && tunnel.near != NULL;
  if (done) {
    for (uint32_t i = 0; i < molecule->atoms; ++i) {
      if (is_backbone(&molecule->label[i])) tunnel.backbone[tunnel.backbones++] = i;
    }
    text_buffer_add_text(&all,
                         "data_tunnels\n_audit_conform.dict_name mmcif_tunnels_v10.dic\n"
                         "_audit_conform.dict_version 1.0\n_audit_conform.dict_location ?\n");
    if (molecule->atoms > 0) add_sites(&all, molecule);
    if (found->tunnel_count > 0) add_channels(&all, found);
    add_tunnels(rows, &tunnel);
    add_categories(&all, rows);
    done = output_file_write_text(path, &all, failure);
  } else {
    failure_of_memory(failure);
  }
  for (int c = 0; c < CATEGORIES; ++c) text_buffer_free(&rows[c]);
  text_buffer_free(&all);
  free(tunnel.backbone);
  free(tunnel.lining);
  free(tunnel.layer);
  free(tunnel.near);
  return done;
}
