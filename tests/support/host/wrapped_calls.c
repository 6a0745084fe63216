/* Generated from include/hardsphere/: bash capi/interface/generate.sh */
/* clang-format off */
#include <hardsphere.h>

#include "host_calls.h"

uint32_t __real_hsp_version(void);
uint32_t __wrap_hsp_version(void);
uint32_t __wrap_hsp_version(void) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_version");
  result = __real_hsp_version();
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_abi(void);
uint32_t __wrap_hsp_abi(void);
uint32_t __wrap_hsp_abi(void) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_abi");
  result = __real_hsp_abi();
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_provisional(void);
uint32_t __wrap_hsp_provisional(void);
uint32_t __wrap_hsp_provisional(void) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_provisional");
  result = __real_hsp_provisional();
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_numerics(void);
uint32_t __wrap_hsp_numerics(void);
uint32_t __wrap_hsp_numerics(void) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_numerics");
  result = __real_hsp_numerics();
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_provisional_numerics(void);
uint32_t __wrap_hsp_provisional_numerics(void);
uint32_t __wrap_hsp_provisional_numerics(void) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_provisional_numerics");
  result = __real_hsp_provisional_numerics();
  host_call_ends(&call);
  return result;
}

const char *__real_hsp_status_text(int32_t status);
const char *__wrap_hsp_status_text(int32_t status);
const char *__wrap_hsp_status_text(int32_t status) {
  const char *result;
  host_call call;
  host_call_begins(&call, "hsp_status_text");
  result = __real_hsp_status_text(status);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_element_radius(uint32_t set, uint32_t atomic_number, double *radius, uint32_t *flags);
int32_t __wrap_hsp_element_radius(uint32_t set, uint32_t atomic_number, double *radius, uint32_t *flags);
int32_t __wrap_hsp_element_radius(uint32_t set, uint32_t atomic_number, double *radius, uint32_t *flags) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_element_radius");
  result = __real_hsp_element_radius(set, atomic_number, radius, flags);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_element_number(const char *symbol, uint32_t *atomic_number);
int32_t __wrap_hsp_element_number(const char *symbol, uint32_t *atomic_number);
int32_t __wrap_hsp_element_number(const char *symbol, uint32_t *atomic_number) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_element_number");
  result = __real_hsp_element_number(symbol, atomic_number);
  host_call_ends(&call);
  return result;
}

const char *__real_hsp_element_symbol(uint32_t atomic_number);
const char *__wrap_hsp_element_symbol(uint32_t atomic_number);
const char *__wrap_hsp_element_symbol(uint32_t atomic_number) {
  const char *result;
  host_call call;
  host_call_begins(&call, "hsp_element_symbol");
  result = __real_hsp_element_symbol(atomic_number);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_residue_radius(uint32_t set, const char *residue, const char *atom, double *radius);
int32_t __wrap_hsp_residue_radius(uint32_t set, const char *residue, const char *atom, double *radius);
int32_t __wrap_hsp_residue_radius(uint32_t set, const char *residue, const char *atom, double *radius) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_residue_radius");
  result = __real_hsp_residue_radius(set, residue, atom, radius);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_residue_get_atoms(uint32_t set, hsp_residue_atom *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_residue_get_atoms(uint32_t set, hsp_residue_atom *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_residue_get_atoms(uint32_t set, hsp_residue_atom *out, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_residue_get_atoms");
  result = __real_hsp_residue_get_atoms(set, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_model_max_balls(void);
uint32_t __wrap_hsp_model_max_balls(void);
uint32_t __wrap_hsp_model_max_balls(void) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_model_max_balls");
  result = __real_hsp_model_max_balls();
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_model_bytes(uint32_t balls, size_t *bytes);
int32_t __wrap_hsp_model_bytes(uint32_t balls, size_t *bytes);
int32_t __wrap_hsp_model_bytes(uint32_t balls, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_model_bytes");
  result = __real_hsp_model_bytes(balls, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_model_init(void *memory, size_t bytes, uint32_t balls, hsp_model **model);
int32_t __wrap_hsp_model_init(void *memory, size_t bytes, uint32_t balls, hsp_model **model);
int32_t __wrap_hsp_model_init(void *memory, size_t bytes, uint32_t balls, hsp_model **model) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_model_init");
  result = __real_hsp_model_init(memory, bytes, balls, model);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_model_options_init(hsp_model_options *options, uint32_t struct_size);
int32_t __wrap_hsp_model_options_init(hsp_model_options *options, uint32_t struct_size);
int32_t __wrap_hsp_model_options_init(hsp_model_options *options, uint32_t struct_size) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_model_options_init");
  result = __real_hsp_model_options_init(options, struct_size);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_model_set(hsp_model *model, uint32_t n, const double *xyz, const double *radius, const
    hsp_model_options *options, uint32_t *first_bad);
int32_t __wrap_hsp_model_set(hsp_model *model, uint32_t n, const double *xyz, const double *radius, const
    hsp_model_options *options, uint32_t *first_bad);
int32_t __wrap_hsp_model_set(hsp_model *model, uint32_t n, const double *xyz, const double *radius, const
    hsp_model_options *options, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_model_set");
  result = __real_hsp_model_set(model, n, xyz, radius, options, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_model_set_with(hsp_model *model, uint32_t n, const double *xyz, const double *radius, const
    hsp_model_request *request, uint32_t *first_bad);
int32_t __wrap_hsp_model_set_with(hsp_model *model, uint32_t n, const double *xyz, const double *radius, const
    hsp_model_request *request, uint32_t *first_bad);
int32_t __wrap_hsp_model_set_with(hsp_model *model, uint32_t n, const double *xyz, const double *radius, const
    hsp_model_request *request, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_model_set_with");
  result = __real_hsp_model_set_with(model, n, xyz, radius, request, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_model_get_info(const hsp_model *model, hsp_model_info *info);
int32_t __wrap_hsp_model_get_info(const hsp_model *model, hsp_model_info *info);
int32_t __wrap_hsp_model_get_info(const hsp_model *model, hsp_model_info *info) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_model_get_info");
  result = __real_hsp_model_get_info(model, info);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_model_get_balls(const hsp_model *model, double *xyz, double *radius, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_model_get_balls(const hsp_model *model, double *xyz, double *radius, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_model_get_balls(const hsp_model *model, double *xyz, double *radius, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_model_get_balls");
  result = __real_hsp_model_get_balls(model, xyz, radius, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_model_get_packing(hsp_model *model, hsp_packing *figures);
int32_t __wrap_hsp_model_get_packing(hsp_model *model, hsp_packing *figures);
int32_t __wrap_hsp_model_get_packing(hsp_model *model, hsp_packing *figures) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_model_get_packing");
  result = __real_hsp_model_get_packing(model, figures);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_query_point(const hsp_model *model, const double *xyz, uint32_t *ids, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_query_point(const hsp_model *model, const double *xyz, uint32_t *ids, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_query_point(const hsp_model *model, const double *xyz, uint32_t *ids, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_query_point");
  result = __real_hsp_query_point(model, xyz, ids, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_query_ball(const hsp_model *model, const double *xyz, double radius, uint32_t *ids, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_query_ball(const hsp_model *model, const double *xyz, double radius, uint32_t *ids, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_query_ball(const hsp_model *model, const double *xyz, double radius, uint32_t *ids, uint32_t
    capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_query_ball");
  result = __real_hsp_query_ball(model, xyz, radius, ids, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_query_meets(const hsp_model *model, const double *xyz, double radius, uint32_t *meets);
int32_t __wrap_hsp_query_meets(const hsp_model *model, const double *xyz, double radius, uint32_t *meets);
int32_t __wrap_hsp_query_meets(const hsp_model *model, const double *xyz, double radius, uint32_t *meets) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_query_meets");
  result = __real_hsp_query_meets(model, xyz, radius, meets);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_query_neighbours(const hsp_model *model, uint32_t ball, uint32_t *ids, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_query_neighbours(const hsp_model *model, uint32_t ball, uint32_t *ids, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_query_neighbours(const hsp_model *model, uint32_t ball, uint32_t *ids, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_query_neighbours");
  result = __real_hsp_query_neighbours(model, ball, ids, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_query_pairs(const hsp_model *model, uint32_t flags, uint32_t *first, uint32_t *ids, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_query_pairs(const hsp_model *model, uint32_t flags, uint32_t *first, uint32_t *ids, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_query_pairs(const hsp_model *model, uint32_t flags, uint32_t *first, uint32_t *ids, uint32_t
    capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_query_pairs");
  result = __real_hsp_query_pairs(model, flags, first, ids, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_query_pairs_with(const hsp_model *model, const hsp_pairs_request *request, uint32_t *first, uint32_t
    *ids, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_query_pairs_with(const hsp_model *model, const hsp_pairs_request *request, uint32_t *first, uint32_t
    *ids, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_query_pairs_with(const hsp_model *model, const hsp_pairs_request *request, uint32_t *first, uint32_t
    *ids, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_query_pairs_with");
  result = __real_hsp_query_pairs_with(model, request, first, ids, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_query_ray(const hsp_model *model, const double *origin, const double *direction, hsp_ray_hit *hit);
int32_t __wrap_hsp_query_ray(const hsp_model *model, const double *origin, const double *direction, hsp_ray_hit *hit);
int32_t __wrap_hsp_query_ray(const hsp_model *model, const double *origin, const double *direction, hsp_ray_hit *hit) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_query_ray");
  result = __real_hsp_query_ray(model, origin, direction, hit);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_body_bytes(uint32_t balls, size_t *bytes);
int32_t __wrap_hsp_body_bytes(uint32_t balls, size_t *bytes);
int32_t __wrap_hsp_body_bytes(uint32_t balls, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_body_bytes");
  result = __real_hsp_body_bytes(balls, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_body_init(void *memory, size_t bytes, uint32_t balls, hsp_body **body);
int32_t __wrap_hsp_body_init(void *memory, size_t bytes, uint32_t balls, hsp_body **body);
int32_t __wrap_hsp_body_init(void *memory, size_t bytes, uint32_t balls, hsp_body **body) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_body_init");
  result = __real_hsp_body_init(memory, bytes, balls, body);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_body_set(hsp_body *body, const hsp_model *model);
int32_t __wrap_hsp_body_set(hsp_body *body, const hsp_model *model);
int32_t __wrap_hsp_body_set(hsp_body *body, const hsp_model *model) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_body_set");
  result = __real_hsp_body_set(body, model);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_body_set_with(hsp_body *body, const hsp_model *model, const hsp_body_request *request);
int32_t __wrap_hsp_body_set_with(hsp_body *body, const hsp_model *model, const hsp_body_request *request);
int32_t __wrap_hsp_body_set_with(hsp_body *body, const hsp_model *model, const hsp_body_request *request) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_body_set_with");
  result = __real_hsp_body_set_with(body, model, request);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pose_from_matrix(const double *matrix, const double *translation, hsp_pose *pose);
int32_t __wrap_hsp_pose_from_matrix(const double *matrix, const double *translation, hsp_pose *pose);
int32_t __wrap_hsp_pose_from_matrix(const double *matrix, const double *translation, hsp_pose *pose) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pose_from_matrix");
  result = __real_hsp_pose_from_matrix(matrix, translation, pose);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_body_hits(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
    uint32_t *hit, uint32_t *first_bad);
int32_t __wrap_hsp_body_hits(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
    uint32_t *hit, uint32_t *first_bad);
int32_t __wrap_hsp_body_hits(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
    uint32_t *hit, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_body_hits");
  result = __real_hsp_body_hits(fixed, posed, poses, pose, hit, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_body_hits_along(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
    double margin, uint32_t *hit, uint32_t *first_bad);
int32_t __wrap_hsp_body_hits_along(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
    double margin, uint32_t *hit, uint32_t *first_bad);
int32_t __wrap_hsp_body_hits_along(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
    double margin, uint32_t *hit, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_body_hits_along");
  result = __real_hsp_body_hits_along(fixed, posed, poses, pose, margin, hit, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_body_gaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
    hsp_body_gap *gap, uint32_t *first_bad);
int32_t __wrap_hsp_body_gaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
    hsp_body_gap *gap, uint32_t *first_bad);
int32_t __wrap_hsp_body_gaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
    hsp_body_gap *gap, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_body_gaps");
  result = __real_hsp_body_gaps(fixed, posed, poses, pose, gap, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_body_overlaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
    hsp_body_overlap *overlap, uint32_t *first_bad);
int32_t __wrap_hsp_body_overlaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
    hsp_body_overlap *overlap, uint32_t *first_bad);
int32_t __wrap_hsp_body_overlaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
    hsp_body_overlap *overlap, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_body_overlaps");
  result = __real_hsp_body_overlaps(fixed, posed, poses, pose, overlap, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_body_pairs(const hsp_body *fixed, const hsp_body *posed, const hsp_pose *pose, uint32_t *pair,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_body_pairs(const hsp_body *fixed, const hsp_body *posed, const hsp_pose *pose, uint32_t *pair,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_body_pairs(const hsp_body *fixed, const hsp_body *posed, const hsp_pose *pose, uint32_t *pair,
    uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_body_pairs");
  result = __real_hsp_body_pairs(fixed, posed, pose, pair, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_body_rational_hits(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const
    hsp_rational_pose *pose, uint32_t *hit, uint32_t *first_bad);
int32_t __wrap_hsp_body_rational_hits(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const
    hsp_rational_pose *pose, uint32_t *hit, uint32_t *first_bad);
int32_t __wrap_hsp_body_rational_hits(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const
    hsp_rational_pose *pose, uint32_t *hit, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_body_rational_hits");
  result = __real_hsp_body_rational_hits(fixed, posed, poses, pose, hit, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_body_rational_hits_along(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const
    hsp_rational_pose *pose, double margin, uint32_t *hit, uint32_t *first_bad);
int32_t __wrap_hsp_body_rational_hits_along(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const
    hsp_rational_pose *pose, double margin, uint32_t *hit, uint32_t *first_bad);
int32_t __wrap_hsp_body_rational_hits_along(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const
    hsp_rational_pose *pose, double margin, uint32_t *hit, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_body_rational_hits_along");
  result = __real_hsp_body_rational_hits_along(fixed, posed, poses, pose, margin, hit, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_body_rational_gaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const
    hsp_rational_pose *pose, hsp_body_gap *gap, uint32_t *first_bad);
int32_t __wrap_hsp_body_rational_gaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const
    hsp_rational_pose *pose, hsp_body_gap *gap, uint32_t *first_bad);
int32_t __wrap_hsp_body_rational_gaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const
    hsp_rational_pose *pose, hsp_body_gap *gap, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_body_rational_gaps");
  result = __real_hsp_body_rational_gaps(fixed, posed, poses, pose, gap, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_body_rational_pairs(const hsp_body *fixed, const hsp_body *posed, const hsp_rational_pose *pose,
    uint32_t *pair, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_body_rational_pairs(const hsp_body *fixed, const hsp_body *posed, const hsp_rational_pose *pose,
    uint32_t *pair, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_body_rational_pairs(const hsp_body *fixed, const hsp_body *posed, const hsp_rational_pose *pose,
    uint32_t *pair, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_body_rational_pairs");
  result = __real_hsp_body_rational_pairs(fixed, posed, pose, pair, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_limits_init(hsp_boundary_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_boundary_limits_init(hsp_boundary_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_boundary_limits_init(hsp_boundary_limits *limits, uint32_t struct_size, uint32_t balls) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_limits_init");
  result = __real_hsp_boundary_limits_init(limits, struct_size, balls);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_bytes(const hsp_boundary_limits *limits, size_t *bytes);
int32_t __wrap_hsp_boundary_bytes(const hsp_boundary_limits *limits, size_t *bytes);
int32_t __wrap_hsp_boundary_bytes(const hsp_boundary_limits *limits, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_bytes");
  result = __real_hsp_boundary_bytes(limits, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_init(void *memory, size_t bytes, const hsp_boundary_limits *limits, hsp_boundary
    **boundary);
int32_t __wrap_hsp_boundary_init(void *memory, size_t bytes, const hsp_boundary_limits *limits, hsp_boundary
    **boundary);
int32_t __wrap_hsp_boundary_init(void *memory, size_t bytes, const hsp_boundary_limits *limits, hsp_boundary **boundary)
    {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_init");
  result = __real_hsp_boundary_init(memory, bytes, limits, boundary);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_compute(hsp_boundary *boundary, const hsp_model *model, hsp_boundary_limits *limits);
int32_t __wrap_hsp_boundary_compute(hsp_boundary *boundary, const hsp_model *model, hsp_boundary_limits *limits);
int32_t __wrap_hsp_boundary_compute(hsp_boundary *boundary, const hsp_model *model, hsp_boundary_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_compute");
  result = __real_hsp_boundary_compute(boundary, model, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_compute_with(hsp_boundary *boundary, const hsp_model *model, const hsp_boundary_request
    *request, hsp_boundary_limits *limits);
int32_t __wrap_hsp_boundary_compute_with(hsp_boundary *boundary, const hsp_model *model, const hsp_boundary_request
    *request, hsp_boundary_limits *limits);
int32_t __wrap_hsp_boundary_compute_with(hsp_boundary *boundary, const hsp_model *model, const hsp_boundary_request
    *request, hsp_boundary_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_compute_with");
  result = __real_hsp_boundary_compute_with(boundary, model, request, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_counts(const hsp_boundary *boundary, hsp_boundary_counts *counts);
int32_t __wrap_hsp_boundary_get_counts(const hsp_boundary *boundary, hsp_boundary_counts *counts);
int32_t __wrap_hsp_boundary_get_counts(const hsp_boundary *boundary, hsp_boundary_counts *counts) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_counts");
  result = __real_hsp_boundary_get_counts(boundary, counts);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_vertices(const hsp_boundary *boundary, hsp_vertex *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_boundary_get_vertices(const hsp_boundary *boundary, hsp_vertex *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_boundary_get_vertices(const hsp_boundary *boundary, hsp_vertex *out, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_vertices");
  result = __real_hsp_boundary_get_vertices(boundary, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_arcs(const hsp_boundary *boundary, hsp_arc *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_arcs(const hsp_boundary *boundary, hsp_arc *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_arcs(const hsp_boundary *boundary, hsp_arc *out, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_arcs");
  result = __real_hsp_boundary_get_arcs(boundary, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_circles(const hsp_boundary *boundary, hsp_circle *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_boundary_get_circles(const hsp_boundary *boundary, hsp_circle *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_boundary_get_circles(const hsp_boundary *boundary, hsp_circle *out, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_circles");
  result = __real_hsp_boundary_get_circles(boundary, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_faces(const hsp_boundary *boundary, hsp_face *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_faces(const hsp_boundary *boundary, hsp_face *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_faces(const hsp_boundary *boundary, hsp_face *out, uint32_t capacity, uint32_t *needed)
    {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_faces");
  result = __real_hsp_boundary_get_faces(boundary, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_loops(const hsp_boundary *boundary, hsp_loop *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_loops(const hsp_boundary *boundary, hsp_loop *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_loops(const hsp_boundary *boundary, hsp_loop *out, uint32_t capacity, uint32_t *needed)
    {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_loops");
  result = __real_hsp_boundary_get_loops(boundary, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_loop_arcs(const hsp_boundary *boundary, hsp_loop_arc *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_boundary_get_loop_arcs(const hsp_boundary *boundary, hsp_loop_arc *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_boundary_get_loop_arcs(const hsp_boundary *boundary, hsp_loop_arc *out, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_loop_arcs");
  result = __real_hsp_boundary_get_loop_arcs(boundary, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_balls(const hsp_boundary *boundary, hsp_ball *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_balls(const hsp_boundary *boundary, hsp_ball *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_balls(const hsp_boundary *boundary, hsp_ball *out, uint32_t capacity, uint32_t *needed)
    {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_balls");
  result = __real_hsp_boundary_get_balls(boundary, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_check(hsp_boundary *boundary, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_boundary_check(hsp_boundary *boundary, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_boundary_check(hsp_boundary *boundary, uint32_t *invariant, uint32_t *id) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_check");
  result = __real_hsp_boundary_check(boundary, invariant, id);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_areas_bytes(uint32_t n, size_t *bytes);
int32_t __wrap_hsp_areas_bytes(uint32_t n, size_t *bytes);
int32_t __wrap_hsp_areas_bytes(uint32_t n, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_areas_bytes");
  result = __real_hsp_areas_bytes(n, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_areas(uint32_t n, const double *xyz, const double *radius, double probe, void *memory, size_t *bytes,
    hsp_totals *totals, double *area);
int32_t __wrap_hsp_areas(uint32_t n, const double *xyz, const double *radius, double probe, void *memory, size_t *bytes,
    hsp_totals *totals, double *area);
int32_t __wrap_hsp_areas(uint32_t n, const double *xyz, const double *radius, double probe, void *memory, size_t *bytes,
    hsp_totals *totals, double *area) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_areas");
  result = __real_hsp_areas(n, xyz, radius, probe, memory, bytes, totals, area);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_measure(const hsp_boundary *boundary, const uint8_t *selected, hsp_totals *totals, double
    *area, double *volume_term, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_measure(const hsp_boundary *boundary, const uint8_t *selected, hsp_totals *totals, double
    *area, double *volume_term, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_measure(const hsp_boundary *boundary, const uint8_t *selected, hsp_totals *totals, double
    *area, double *volume_term, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_measure");
  result = __real_hsp_boundary_measure(boundary, selected, totals, area, volume_term, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_measures(const hsp_boundary *boundary, const hsp_measure_request *request,
    hsp_measure_outputs *outputs);
int32_t __wrap_hsp_boundary_get_measures(const hsp_boundary *boundary, const hsp_measure_request *request,
    hsp_measure_outputs *outputs);
int32_t __wrap_hsp_boundary_get_measures(const hsp_boundary *boundary, const hsp_measure_request *request,
    hsp_measure_outputs *outputs) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_measures");
  result = __real_hsp_boundary_get_measures(boundary, request, outputs);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_measure_faces(const hsp_boundary *boundary, double *area, double *volume_term, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_measure_faces(const hsp_boundary *boundary, double *area, double *volume_term, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_measure_faces(const hsp_boundary *boundary, double *area, double *volume_term, uint32_t
    capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_measure_faces");
  result = __real_hsp_boundary_measure_faces(boundary, area, volume_term, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_gradient_request_init(hsp_gradient_request *request, uint32_t struct_size);
int32_t __wrap_hsp_gradient_request_init(hsp_gradient_request *request, uint32_t struct_size);
int32_t __wrap_hsp_gradient_request_init(hsp_gradient_request *request, uint32_t struct_size) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_gradient_request_init");
  result = __real_hsp_gradient_request_init(request, struct_size);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_gradient(const hsp_boundary *boundary, const hsp_gradient_request *request,
    hsp_gradient_outputs *outputs);
int32_t __wrap_hsp_boundary_get_gradient(const hsp_boundary *boundary, const hsp_gradient_request *request,
    hsp_gradient_outputs *outputs);
int32_t __wrap_hsp_boundary_get_gradient(const hsp_boundary *boundary, const hsp_gradient_request *request,
    hsp_gradient_outputs *outputs) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_gradient");
  result = __real_hsp_boundary_get_gradient(boundary, request, outputs);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_derivatives(const hsp_boundary *boundary, const hsp_derivatives_request *request,
    hsp_derivatives_outputs *outputs);
int32_t __wrap_hsp_boundary_get_derivatives(const hsp_boundary *boundary, const hsp_derivatives_request *request,
    hsp_derivatives_outputs *outputs);
int32_t __wrap_hsp_boundary_get_derivatives(const hsp_boundary *boundary, const hsp_derivatives_request *request,
    hsp_derivatives_outputs *outputs) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_derivatives");
  result = __real_hsp_boundary_get_derivatives(boundary, request, outputs);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_area_row(const hsp_boundary *boundary, uint32_t ball, uint32_t tangency,
    hsp_area_derivative *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_area_row(const hsp_boundary *boundary, uint32_t ball, uint32_t tangency,
    hsp_area_derivative *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_area_row(const hsp_boundary *boundary, uint32_t ball, uint32_t tangency,
    hsp_area_derivative *out, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_area_row");
  result = __real_hsp_boundary_get_area_row(boundary, ball, tangency, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_area_rows(const hsp_boundary *boundary, const hsp_derivatives_request *request, uint32_t
    *first, uint32_t *ball, double *d_centre, double *d_radius, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_area_rows(const hsp_boundary *boundary, const hsp_derivatives_request *request, uint32_t
    *first, uint32_t *ball, double *d_centre, double *d_radius, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_area_rows(const hsp_boundary *boundary, const hsp_derivatives_request *request, uint32_t
    *first, uint32_t *ball, double *d_centre, double *d_radius, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_area_rows");
  result = __real_hsp_boundary_get_area_rows(boundary, request, first, ball, d_centre, d_radius, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_moving_limits_init(hsp_moving_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_moving_limits_init(hsp_moving_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_moving_limits_init(hsp_moving_limits *limits, uint32_t struct_size, uint32_t balls) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_moving_limits_init");
  result = __real_hsp_moving_limits_init(limits, struct_size, balls);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_moving_bytes(const hsp_moving_limits *limits, size_t *bytes);
int32_t __wrap_hsp_moving_bytes(const hsp_moving_limits *limits, size_t *bytes);
int32_t __wrap_hsp_moving_bytes(const hsp_moving_limits *limits, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_moving_bytes");
  result = __real_hsp_moving_bytes(limits, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_moving_init(void *memory, size_t bytes, const hsp_moving_limits *limits, hsp_moving **moving);
int32_t __wrap_hsp_moving_init(void *memory, size_t bytes, const hsp_moving_limits *limits, hsp_moving **moving);
int32_t __wrap_hsp_moving_init(void *memory, size_t bytes, const hsp_moving_limits *limits, hsp_moving **moving) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_moving_init");
  result = __real_hsp_moving_init(memory, bytes, limits, moving);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_moving_set(hsp_moving *moving, const hsp_model *model, const double *sigma, double tension, double
    pressure, uint32_t tangency, hsp_moving_limits *limits, uint32_t *first_bad);
int32_t __wrap_hsp_moving_set(hsp_moving *moving, const hsp_model *model, const double *sigma, double tension, double
    pressure, uint32_t tangency, hsp_moving_limits *limits, uint32_t *first_bad);
int32_t __wrap_hsp_moving_set(hsp_moving *moving, const hsp_model *model, const double *sigma, double tension, double
    pressure, uint32_t tangency, hsp_moving_limits *limits, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_moving_set");
  result = __real_hsp_moving_set(moving, model, sigma, tension, pressure, tangency, limits, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_moving_set_with(hsp_moving *moving, const hsp_model *model, const hsp_gradient_request *request,
    hsp_moving_limits *limits, uint32_t *first_bad);
int32_t __wrap_hsp_moving_set_with(hsp_moving *moving, const hsp_model *model, const hsp_gradient_request *request,
    hsp_moving_limits *limits, uint32_t *first_bad);
int32_t __wrap_hsp_moving_set_with(hsp_moving *moving, const hsp_model *model, const hsp_gradient_request *request,
    hsp_moving_limits *limits, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_moving_set_with");
  result = __real_hsp_moving_set_with(moving, model, request, limits, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_moving_move(hsp_moving *moving, uint32_t count, const uint32_t *ball, const double *xyz, const double
    *radius, hsp_moving_limits *limits, uint32_t *first_bad);
int32_t __wrap_hsp_moving_move(hsp_moving *moving, uint32_t count, const uint32_t *ball, const double *xyz, const double
    *radius, hsp_moving_limits *limits, uint32_t *first_bad);
int32_t __wrap_hsp_moving_move(hsp_moving *moving, uint32_t count, const uint32_t *ball, const double *xyz, const double
    *radius, hsp_moving_limits *limits, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_moving_move");
  result = __real_hsp_moving_move(moving, count, ball, xyz, radius, limits, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_moving_move_with(hsp_moving *moving, uint32_t count, const uint32_t *ball, const double *xyz, const
    double *radius, const hsp_moving_request *request, hsp_moving_limits *limits, uint32_t *first_bad);
int32_t __wrap_hsp_moving_move_with(hsp_moving *moving, uint32_t count, const uint32_t *ball, const double *xyz, const
    double *radius, const hsp_moving_request *request, hsp_moving_limits *limits, uint32_t *first_bad);
int32_t __wrap_hsp_moving_move_with(hsp_moving *moving, uint32_t count, const uint32_t *ball, const double *xyz, const
    double *radius, const hsp_moving_request *request, hsp_moving_limits *limits, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_moving_move_with");
  result = __real_hsp_moving_move_with(moving, count, ball, xyz, radius, request, limits, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_moving_undo(hsp_moving *moving);
int32_t __wrap_hsp_moving_undo(hsp_moving *moving);
int32_t __wrap_hsp_moving_undo(hsp_moving *moving) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_moving_undo");
  result = __real_hsp_moving_undo(moving);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_moving_get_info(const hsp_moving *moving, hsp_moving_info *info);
int32_t __wrap_hsp_moving_get_info(const hsp_moving *moving, hsp_moving_info *info);
int32_t __wrap_hsp_moving_get_info(const hsp_moving *moving, hsp_moving_info *info) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_moving_get_info");
  result = __real_hsp_moving_get_info(moving, info);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_moving_measure(const hsp_moving *moving, hsp_totals *totals, double *area, double *volume_term,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_moving_measure(const hsp_moving *moving, hsp_totals *totals, double *area, double *volume_term,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_moving_measure(const hsp_moving *moving, hsp_totals *totals, double *area, double *volume_term,
    uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_moving_measure");
  result = __real_hsp_moving_measure(moving, totals, area, volume_term, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_moving_gradient(const hsp_moving *moving, hsp_energy *energy, double *d_centre, double *d_radius,
    uint32_t *flags, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_moving_gradient(const hsp_moving *moving, hsp_energy *energy, double *d_centre, double *d_radius,
    uint32_t *flags, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_moving_gradient(const hsp_moving *moving, hsp_energy *energy, double *d_centre, double *d_radius,
    uint32_t *flags, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_moving_gradient");
  result = __real_hsp_moving_gradient(moving, energy, d_centre, d_radius, flags, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_moving_get_balls(const hsp_moving *moving, uint32_t count, const uint32_t *ball, hsp_moving_ball
    *out);
int32_t __wrap_hsp_moving_get_balls(const hsp_moving *moving, uint32_t count, const uint32_t *ball, hsp_moving_ball
    *out);
int32_t __wrap_hsp_moving_get_balls(const hsp_moving *moving, uint32_t count, const uint32_t *ball, hsp_moving_ball
    *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_moving_get_balls");
  result = __real_hsp_moving_get_balls(moving, count, ball, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_moving_get_changed(const hsp_moving *moving, uint32_t *balls, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_moving_get_changed(const hsp_moving *moving, uint32_t *balls, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_moving_get_changed(const hsp_moving *moving, uint32_t *balls, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_moving_get_changed");
  result = __real_hsp_moving_get_changed(moving, balls, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_moving_get_model(const hsp_moving *moving, hsp_model *model);
int32_t __wrap_hsp_moving_get_model(const hsp_moving *moving, hsp_model *model);
int32_t __wrap_hsp_moving_get_model(const hsp_moving *moving, hsp_model *model) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_moving_get_model");
  result = __real_hsp_moving_get_model(moving, model);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_curvature(const hsp_boundary *boundary, hsp_curvatures *totals, double *mean, int32_t
    *gauss_thirds, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_curvature(const hsp_boundary *boundary, hsp_curvatures *totals, double *mean, int32_t
    *gauss_thirds, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_curvature(const hsp_boundary *boundary, hsp_curvatures *totals, double *mean, int32_t
    *gauss_thirds, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_curvature");
  result = __real_hsp_boundary_curvature(boundary, totals, mean, gauss_thirds, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_curvature_with(const hsp_boundary *boundary, const hsp_curvature_request *request,
    hsp_curvatures *totals, double *mean, int32_t *gauss_thirds, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_curvature_with(const hsp_boundary *boundary, const hsp_curvature_request *request,
    hsp_curvatures *totals, double *mean, int32_t *gauss_thirds, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_curvature_with(const hsp_boundary *boundary, const hsp_curvature_request *request,
    hsp_curvatures *totals, double *mean, int32_t *gauss_thirds, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_curvature_with");
  result = __real_hsp_boundary_curvature_with(boundary, request, totals, mean, gauss_thirds, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_morphometry(const hsp_boundary *boundary, const hsp_morphometry_request *request,
    hsp_morphometry_outputs *outputs);
int32_t __wrap_hsp_boundary_get_morphometry(const hsp_boundary *boundary, const hsp_morphometry_request *request,
    hsp_morphometry_outputs *outputs);
int32_t __wrap_hsp_boundary_get_morphometry(const hsp_boundary *boundary, const hsp_morphometry_request *request,
    hsp_morphometry_outputs *outputs) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_morphometry");
  result = __real_hsp_boundary_get_morphometry(boundary, request, outputs);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_hessian_rows(const hsp_boundary *boundary, const hsp_gradient_request *request, uint32_t
    *first, uint32_t *ball, double *block, uint32_t *flags, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_hessian_rows(const hsp_boundary *boundary, const hsp_gradient_request *request, uint32_t
    *first, uint32_t *ball, double *block, uint32_t *flags, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_hessian_rows(const hsp_boundary *boundary, const hsp_gradient_request *request, uint32_t
    *first, uint32_t *ball, double *block, uint32_t *flags, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_hessian_rows");
  result = __real_hsp_boundary_get_hessian_rows(boundary, request, first, ball, block, flags, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_boundary_get_hessian_product(const hsp_boundary *boundary, const hsp_gradient_request *request, const
    double *direction, double *product, uint32_t *flags, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_hessian_product(const hsp_boundary *boundary, const hsp_gradient_request *request, const
    double *direction, double *product, uint32_t *flags, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_boundary_get_hessian_product(const hsp_boundary *boundary, const hsp_gradient_request *request, const
    double *direction, double *product, uint32_t *flags, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_boundary_get_hessian_product");
  result = __real_hsp_boundary_get_hessian_product(boundary, request, direction, product, flags, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_brick_summarise(const hsp_boundary *boundary, const hsp_brick_request *request, void *summary, size_t
    *bytes, uint32_t *first_bad);
int32_t __wrap_hsp_brick_summarise(const hsp_boundary *boundary, const hsp_brick_request *request, void *summary, size_t
    *bytes, uint32_t *first_bad);
int32_t __wrap_hsp_brick_summarise(const hsp_boundary *boundary, const hsp_brick_request *request, void *summary, size_t
    *bytes, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_brick_summarise");
  result = __real_hsp_brick_summarise(boundary, request, summary, bytes, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_brick_merge(const uint8_t *a, size_t a_bytes, const uint8_t *b, size_t b_bytes, const hsp_executor
    *executor, void *summary, size_t *bytes, uint32_t *brick);
int32_t __wrap_hsp_brick_merge(const uint8_t *a, size_t a_bytes, const uint8_t *b, size_t b_bytes, const hsp_executor
    *executor, void *summary, size_t *bytes, uint32_t *brick);
int32_t __wrap_hsp_brick_merge(const uint8_t *a, size_t a_bytes, const uint8_t *b, size_t b_bytes, const hsp_executor
    *executor, void *summary, size_t *bytes, uint32_t *brick) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_brick_merge");
  result = __real_hsp_brick_merge(a, a_bytes, b, b_bytes, executor, summary, bytes, brick);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_brick_get_totals(const uint8_t *summary, size_t bytes, hsp_brick_totals *totals, uint32_t *brick);
int32_t __wrap_hsp_brick_get_totals(const uint8_t *summary, size_t bytes, hsp_brick_totals *totals, uint32_t *brick);
int32_t __wrap_hsp_brick_get_totals(const uint8_t *summary, size_t bytes, hsp_brick_totals *totals, uint32_t *brick) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_brick_get_totals");
  result = __real_hsp_brick_get_totals(summary, bytes, totals, brick);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_brick_get_shells(const uint8_t *summary, size_t bytes, hsp_brick_shell *out, uint32_t capacity,
    uint32_t *needed, uint32_t *brick);
int32_t __wrap_hsp_brick_get_shells(const uint8_t *summary, size_t bytes, hsp_brick_shell *out, uint32_t capacity,
    uint32_t *needed, uint32_t *brick);
int32_t __wrap_hsp_brick_get_shells(const uint8_t *summary, size_t bytes, hsp_brick_shell *out, uint32_t capacity,
    uint32_t *needed, uint32_t *brick) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_brick_get_shells");
  result = __real_hsp_brick_get_shells(summary, bytes, out, capacity, needed, brick);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_contacts_limits_init(hsp_contacts_limits *limits, uint32_t struct_size, const hsp_boundary
    *boundary);
int32_t __wrap_hsp_contacts_limits_init(hsp_contacts_limits *limits, uint32_t struct_size, const hsp_boundary
    *boundary);
int32_t __wrap_hsp_contacts_limits_init(hsp_contacts_limits *limits, uint32_t struct_size, const hsp_boundary *boundary)
    {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_contacts_limits_init");
  result = __real_hsp_contacts_limits_init(limits, struct_size, boundary);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_contacts_bytes(const hsp_contacts_limits *limits, size_t *bytes);
int32_t __wrap_hsp_contacts_bytes(const hsp_contacts_limits *limits, size_t *bytes);
int32_t __wrap_hsp_contacts_bytes(const hsp_contacts_limits *limits, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_contacts_bytes");
  result = __real_hsp_contacts_bytes(limits, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_contacts_init(void *memory, size_t bytes, const hsp_contacts_limits *limits, hsp_contacts
    **contacts);
int32_t __wrap_hsp_contacts_init(void *memory, size_t bytes, const hsp_contacts_limits *limits, hsp_contacts
    **contacts);
int32_t __wrap_hsp_contacts_init(void *memory, size_t bytes, const hsp_contacts_limits *limits, hsp_contacts **contacts)
    {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_contacts_init");
  result = __real_hsp_contacts_init(memory, bytes, limits, contacts);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_contacts_compute(hsp_contacts *contacts, const hsp_boundary *boundary, hsp_contacts_limits *limits);
int32_t __wrap_hsp_contacts_compute(hsp_contacts *contacts, const hsp_boundary *boundary, hsp_contacts_limits *limits);
int32_t __wrap_hsp_contacts_compute(hsp_contacts *contacts, const hsp_boundary *boundary, hsp_contacts_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_contacts_compute");
  result = __real_hsp_contacts_compute(contacts, boundary, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_contacts_compute_with(hsp_contacts *contacts, const hsp_boundary *boundary, const
    hsp_contacts_request *request, hsp_contacts_limits *limits);
int32_t __wrap_hsp_contacts_compute_with(hsp_contacts *contacts, const hsp_boundary *boundary, const
    hsp_contacts_request *request, hsp_contacts_limits *limits);
int32_t __wrap_hsp_contacts_compute_with(hsp_contacts *contacts, const hsp_boundary *boundary, const
    hsp_contacts_request *request, hsp_contacts_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_contacts_compute_with");
  result = __real_hsp_contacts_compute_with(contacts, boundary, request, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_contacts_get_pairs(const hsp_contacts *contacts, hsp_contact *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_contacts_get_pairs(const hsp_contacts *contacts, hsp_contact *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_contacts_get_pairs(const hsp_contacts *contacts, hsp_contact *out, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_contacts_get_pairs");
  result = __real_hsp_contacts_get_pairs(contacts, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_contacts_get_row(const hsp_contacts *contacts, uint32_t ball, hsp_contact *out, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_contacts_get_row(const hsp_contacts *contacts, uint32_t ball, hsp_contact *out, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_contacts_get_row(const hsp_contacts *contacts, uint32_t ball, hsp_contact *out, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_contacts_get_row");
  result = __real_hsp_contacts_get_row(contacts, ball, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_contacts_measure(const hsp_contacts *contacts, hsp_totals *totals, double *share_volume, double
    *contact_area, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_contacts_measure(const hsp_contacts *contacts, hsp_totals *totals, double *share_volume, double
    *contact_area, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_contacts_measure(const hsp_contacts *contacts, hsp_totals *totals, double *share_volume, double
    *contact_area, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_contacts_measure");
  result = __real_hsp_contacts_measure(contacts, totals, share_volume, contact_area, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_contacts_group(hsp_contacts *contacts, const uint32_t *group, hsp_group_contact *out, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_contacts_group(hsp_contacts *contacts, const uint32_t *group, hsp_group_contact *out, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_contacts_group(hsp_contacts *contacts, const uint32_t *group, hsp_group_contact *out, uint32_t
    capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_contacts_group");
  result = __real_hsp_contacts_group(contacts, group, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_contacts_get_complex(const hsp_contacts *contacts, hsp_complex *counts);
int32_t __wrap_hsp_contacts_get_complex(const hsp_contacts *contacts, hsp_complex *counts);
int32_t __wrap_hsp_contacts_get_complex(const hsp_contacts *contacts, hsp_complex *counts) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_contacts_get_complex");
  result = __real_hsp_contacts_get_complex(contacts, counts);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_contacts_get_simplices(const hsp_contacts *contacts, uint32_t dimension, hsp_simplex *out, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_contacts_get_simplices(const hsp_contacts *contacts, uint32_t dimension, hsp_simplex *out, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_contacts_get_simplices(const hsp_contacts *contacts, uint32_t dimension, hsp_simplex *out, uint32_t
    capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_contacts_get_simplices");
  result = __real_hsp_contacts_get_simplices(contacts, dimension, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_contacts_check(hsp_contacts *contacts, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_contacts_check(hsp_contacts *contacts, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_contacts_check(hsp_contacts *contacts, uint32_t *invariant, uint32_t *id) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_contacts_check");
  result = __real_hsp_contacts_check(contacts, invariant, id);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_limits_init(hsp_periodic_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_periodic_limits_init(hsp_periodic_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_periodic_limits_init(hsp_periodic_limits *limits, uint32_t struct_size, uint32_t balls) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_limits_init");
  result = __real_hsp_periodic_limits_init(limits, struct_size, balls);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_bytes(const hsp_periodic_limits *limits, size_t *bytes);
int32_t __wrap_hsp_periodic_bytes(const hsp_periodic_limits *limits, size_t *bytes);
int32_t __wrap_hsp_periodic_bytes(const hsp_periodic_limits *limits, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_bytes");
  result = __real_hsp_periodic_bytes(limits, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_init(void *memory, size_t bytes, const hsp_periodic_limits *limits, hsp_periodic
    **periodic);
int32_t __wrap_hsp_periodic_init(void *memory, size_t bytes, const hsp_periodic_limits *limits, hsp_periodic
    **periodic);
int32_t __wrap_hsp_periodic_init(void *memory, size_t bytes, const hsp_periodic_limits *limits, hsp_periodic **periodic)
    {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_init");
  result = __real_hsp_periodic_init(memory, bytes, limits, periodic);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_compute(hsp_periodic *periodic, uint32_t n, const double *xyz, const double *radius, const
    double *box, const hsp_model_options *options, hsp_periodic_limits *limits, uint32_t *first_bad);
int32_t __wrap_hsp_periodic_compute(hsp_periodic *periodic, uint32_t n, const double *xyz, const double *radius, const
    double *box, const hsp_model_options *options, hsp_periodic_limits *limits, uint32_t *first_bad);
int32_t __wrap_hsp_periodic_compute(hsp_periodic *periodic, uint32_t n, const double *xyz, const double *radius, const
    double *box, const hsp_model_options *options, hsp_periodic_limits *limits, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_compute");
  result = __real_hsp_periodic_compute(periodic, n, xyz, radius, box, options, limits, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_compute_with(hsp_periodic *periodic, uint32_t n, const double *xyz, const double *radius,
    const double *box, const hsp_periodic_request *request, hsp_periodic_limits *limits, uint32_t *first_bad);
int32_t __wrap_hsp_periodic_compute_with(hsp_periodic *periodic, uint32_t n, const double *xyz, const double *radius,
    const double *box, const hsp_periodic_request *request, hsp_periodic_limits *limits, uint32_t *first_bad);
int32_t __wrap_hsp_periodic_compute_with(hsp_periodic *periodic, uint32_t n, const double *xyz, const double *radius,
    const double *box, const hsp_periodic_request *request, hsp_periodic_limits *limits, uint32_t *first_bad) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_compute_with");
  result = __real_hsp_periodic_compute_with(periodic, n, xyz, radius, box, request, limits, first_bad);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_get_counts(const hsp_periodic *periodic, hsp_periodic_counts *counts);
int32_t __wrap_hsp_periodic_get_counts(const hsp_periodic *periodic, hsp_periodic_counts *counts);
int32_t __wrap_hsp_periodic_get_counts(const hsp_periodic *periodic, hsp_periodic_counts *counts) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_get_counts");
  result = __real_hsp_periodic_get_counts(periodic, counts);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_measure(const hsp_periodic *periodic, hsp_periodic_totals *totals, double *area, double
    *share_volume, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_measure(const hsp_periodic *periodic, hsp_periodic_totals *totals, double *area, double
    *share_volume, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_measure(const hsp_periodic *periodic, hsp_periodic_totals *totals, double *area, double
    *share_volume, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_measure");
  result = __real_hsp_periodic_measure(periodic, totals, area, share_volume, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_curvature(const hsp_periodic *periodic, hsp_curvatures *totals, double *mean, int32_t
    *gauss_thirds, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_curvature(const hsp_periodic *periodic, hsp_curvatures *totals, double *mean, int32_t
    *gauss_thirds, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_curvature(const hsp_periodic *periodic, hsp_curvatures *totals, double *mean, int32_t
    *gauss_thirds, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_curvature");
  result = __real_hsp_periodic_curvature(periodic, totals, mean, gauss_thirds, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_get_morphometry(const hsp_periodic *periodic, const hsp_morphometry_request *request,
    hsp_periodic_morphometry_outputs *outputs);
int32_t __wrap_hsp_periodic_get_morphometry(const hsp_periodic *periodic, const hsp_morphometry_request *request,
    hsp_periodic_morphometry_outputs *outputs);
int32_t __wrap_hsp_periodic_get_morphometry(const hsp_periodic *periodic, const hsp_morphometry_request *request,
    hsp_periodic_morphometry_outputs *outputs) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_get_morphometry");
  result = __real_hsp_periodic_get_morphometry(periodic, request, outputs);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_get_contacts(const hsp_periodic *periodic, hsp_periodic_contact *out, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_periodic_get_contacts(const hsp_periodic *periodic, hsp_periodic_contact *out, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_periodic_get_contacts(const hsp_periodic *periodic, hsp_periodic_contact *out, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_get_contacts");
  result = __real_hsp_periodic_get_contacts(periodic, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_group_contacts(hsp_periodic *periodic, const uint32_t *group, hsp_group_contact *out,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_group_contacts(hsp_periodic *periodic, const uint32_t *group, hsp_group_contact *out,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_group_contacts(hsp_periodic *periodic, const uint32_t *group, hsp_group_contact *out,
    uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_group_contacts");
  result = __real_hsp_periodic_group_contacts(periodic, group, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_get_windings(const hsp_periodic *periodic, hsp_winding *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_periodic_get_windings(const hsp_periodic *periodic, hsp_winding *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_periodic_get_windings(const hsp_periodic *periodic, hsp_winding *out, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_get_windings");
  result = __real_hsp_periodic_get_windings(periodic, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_get_components(const hsp_periodic *periodic, uint32_t *component, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_periodic_get_components(const hsp_periodic *periodic, uint32_t *component, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_periodic_get_components(const hsp_periodic *periodic, uint32_t *component, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_get_components");
  result = __real_hsp_periodic_get_components(periodic, component, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_get_gradient(const hsp_periodic *periodic, const hsp_gradient_request *request,
    hsp_periodic_gradient_outputs *outputs);
int32_t __wrap_hsp_periodic_get_gradient(const hsp_periodic *periodic, const hsp_gradient_request *request,
    hsp_periodic_gradient_outputs *outputs);
int32_t __wrap_hsp_periodic_get_gradient(const hsp_periodic *periodic, const hsp_gradient_request *request,
    hsp_periodic_gradient_outputs *outputs) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_get_gradient");
  result = __real_hsp_periodic_get_gradient(periodic, request, outputs);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_get_hessian_rows(const hsp_periodic *periodic, const hsp_gradient_request *request, uint32_t
    *first, uint32_t *ball, double *block, uint32_t *flags, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_get_hessian_rows(const hsp_periodic *periodic, const hsp_gradient_request *request, uint32_t
    *first, uint32_t *ball, double *block, uint32_t *flags, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_get_hessian_rows(const hsp_periodic *periodic, const hsp_gradient_request *request, uint32_t
    *first, uint32_t *ball, double *block, uint32_t *flags, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_get_hessian_rows");
  result = __real_hsp_periodic_get_hessian_rows(periodic, request, first, ball, block, flags, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_query_point(const hsp_periodic *periodic, const double *xyz, hsp_image *out, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_query_point(const hsp_periodic *periodic, const double *xyz, hsp_image *out, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_query_point(const hsp_periodic *periodic, const double *xyz, hsp_image *out, uint32_t
    capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_query_point");
  result = __real_hsp_periodic_query_point(periodic, xyz, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_query_ball(const hsp_periodic *periodic, const double *xyz, double radius, hsp_image *out,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_query_ball(const hsp_periodic *periodic, const double *xyz, double radius, hsp_image *out,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_query_ball(const hsp_periodic *periodic, const double *xyz, double radius, hsp_image *out,
    uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_query_ball");
  result = __real_hsp_periodic_query_ball(periodic, xyz, radius, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_query_neighbours(const hsp_periodic *periodic, uint32_t ball, hsp_image *out, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_query_neighbours(const hsp_periodic *periodic, uint32_t ball, hsp_image *out, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_query_neighbours(const hsp_periodic *periodic, uint32_t ball, hsp_image *out, uint32_t
    capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_query_neighbours");
  result = __real_hsp_periodic_query_neighbours(periodic, ball, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_query_pairs(const hsp_periodic *periodic, uint32_t flags, uint32_t *first, hsp_image *out,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_query_pairs(const hsp_periodic *periodic, uint32_t flags, uint32_t *first, hsp_image *out,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_query_pairs(const hsp_periodic *periodic, uint32_t flags, uint32_t *first, hsp_image *out,
    uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_query_pairs");
  result = __real_hsp_periodic_query_pairs(periodic, flags, first, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_check(hsp_periodic *periodic, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_periodic_check(hsp_periodic *periodic, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_periodic_check(hsp_periodic *periodic, uint32_t *invariant, uint32_t *id) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_check");
  result = __real_hsp_periodic_check(periodic, invariant, id);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_get_vertices(const hsp_periodic *periodic, hsp_periodic_vertex *out, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_periodic_get_vertices(const hsp_periodic *periodic, hsp_periodic_vertex *out, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_periodic_get_vertices(const hsp_periodic *periodic, hsp_periodic_vertex *out, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_get_vertices");
  result = __real_hsp_periodic_get_vertices(periodic, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_get_arcs(const hsp_periodic *periodic, hsp_periodic_arc *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_periodic_get_arcs(const hsp_periodic *periodic, hsp_periodic_arc *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_periodic_get_arcs(const hsp_periodic *periodic, hsp_periodic_arc *out, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_get_arcs");
  result = __real_hsp_periodic_get_arcs(periodic, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_get_circles(const hsp_periodic *periodic, hsp_periodic_circle *out, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_periodic_get_circles(const hsp_periodic *periodic, hsp_periodic_circle *out, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_periodic_get_circles(const hsp_periodic *periodic, hsp_periodic_circle *out, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_get_circles");
  result = __real_hsp_periodic_get_circles(periodic, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_get_faces(const hsp_periodic *periodic, hsp_periodic_face *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_periodic_get_faces(const hsp_periodic *periodic, hsp_periodic_face *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_periodic_get_faces(const hsp_periodic *periodic, hsp_periodic_face *out, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_get_faces");
  result = __real_hsp_periodic_get_faces(periodic, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_get_loops(const hsp_periodic *periodic, hsp_periodic_loop *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_periodic_get_loops(const hsp_periodic *periodic, hsp_periodic_loop *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_periodic_get_loops(const hsp_periodic *periodic, hsp_periodic_loop *out, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_get_loops");
  result = __real_hsp_periodic_get_loops(periodic, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_get_loop_arcs(const hsp_periodic *periodic, hsp_periodic_loop_arc *out, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_periodic_get_loop_arcs(const hsp_periodic *periodic, hsp_periodic_loop_arc *out, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_periodic_get_loop_arcs(const hsp_periodic *periodic, hsp_periodic_loop_arc *out, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_get_loop_arcs");
  result = __real_hsp_periodic_get_loop_arcs(periodic, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_periodic_get_balls(const hsp_periodic *periodic, hsp_ball *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_get_balls(const hsp_periodic *periodic, hsp_ball *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_periodic_get_balls(const hsp_periodic *periodic, hsp_ball *out, uint32_t capacity, uint32_t *needed)
    {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_periodic_get_balls");
  result = __real_hsp_periodic_get_balls(periodic, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_limits_init(hsp_surface_limits *limits, uint32_t struct_size, const hsp_boundary *boundary);
int32_t __wrap_hsp_surface_limits_init(hsp_surface_limits *limits, uint32_t struct_size, const hsp_boundary *boundary);
int32_t __wrap_hsp_surface_limits_init(hsp_surface_limits *limits, uint32_t struct_size, const hsp_boundary *boundary) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_limits_init");
  result = __real_hsp_surface_limits_init(limits, struct_size, boundary);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_bytes(const hsp_surface_limits *limits, size_t *bytes);
int32_t __wrap_hsp_surface_bytes(const hsp_surface_limits *limits, size_t *bytes);
int32_t __wrap_hsp_surface_bytes(const hsp_surface_limits *limits, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_bytes");
  result = __real_hsp_surface_bytes(limits, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_init(void *memory, size_t bytes, const hsp_surface_limits *limits, hsp_surface **surface);
int32_t __wrap_hsp_surface_init(void *memory, size_t bytes, const hsp_surface_limits *limits, hsp_surface **surface);
int32_t __wrap_hsp_surface_init(void *memory, size_t bytes, const hsp_surface_limits *limits, hsp_surface **surface) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_init");
  result = __real_hsp_surface_init(memory, bytes, limits, surface);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_compute(hsp_surface *surface, const hsp_boundary *boundary, hsp_surface_limits *limits);
int32_t __wrap_hsp_surface_compute(hsp_surface *surface, const hsp_boundary *boundary, hsp_surface_limits *limits);
int32_t __wrap_hsp_surface_compute(hsp_surface *surface, const hsp_boundary *boundary, hsp_surface_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_compute");
  result = __real_hsp_surface_compute(surface, boundary, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_compute_shells(hsp_surface *surface, const hsp_boundary *boundary, const uint32_t *shells,
    uint32_t count, hsp_surface_limits *limits);
int32_t __wrap_hsp_surface_compute_shells(hsp_surface *surface, const hsp_boundary *boundary, const uint32_t *shells,
    uint32_t count, hsp_surface_limits *limits);
int32_t __wrap_hsp_surface_compute_shells(hsp_surface *surface, const hsp_boundary *boundary, const uint32_t *shells,
    uint32_t count, hsp_surface_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_compute_shells");
  result = __real_hsp_surface_compute_shells(surface, boundary, shells, count, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_compute_with(hsp_surface *surface, const hsp_boundary *boundary, const hsp_surface_request
    *request, hsp_surface_limits *limits);
int32_t __wrap_hsp_surface_compute_with(hsp_surface *surface, const hsp_boundary *boundary, const hsp_surface_request
    *request, hsp_surface_limits *limits);
int32_t __wrap_hsp_surface_compute_with(hsp_surface *surface, const hsp_boundary *boundary, const hsp_surface_request
    *request, hsp_surface_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_compute_with");
  result = __real_hsp_surface_compute_with(surface, boundary, request, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_get_counts(const hsp_surface *surface, hsp_surface_counts *counts);
int32_t __wrap_hsp_surface_get_counts(const hsp_surface *surface, hsp_surface_counts *counts);
int32_t __wrap_hsp_surface_get_counts(const hsp_surface *surface, hsp_surface_counts *counts) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_get_counts");
  result = __real_hsp_surface_get_counts(surface, counts);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_measure(const hsp_surface *surface, hsp_surface_totals *totals, hsp_surface_totals *balls,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_surface_measure(const hsp_surface *surface, hsp_surface_totals *totals, hsp_surface_totals *balls,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_surface_measure(const hsp_surface *surface, hsp_surface_totals *totals, hsp_surface_totals *balls,
    uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_measure");
  result = __real_hsp_surface_measure(surface, totals, balls, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_measure_with(const hsp_surface *surface, const hsp_surface_measure_request *request,
    hsp_surface_totals *totals, hsp_surface_totals *balls, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_surface_measure_with(const hsp_surface *surface, const hsp_surface_measure_request *request,
    hsp_surface_totals *totals, hsp_surface_totals *balls, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_surface_measure_with(const hsp_surface *surface, const hsp_surface_measure_request *request,
    hsp_surface_totals *totals, hsp_surface_totals *balls, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_measure_with");
  result = __real_hsp_surface_measure_with(surface, request, totals, balls, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_get_gradient(const hsp_surface *surface, const hsp_gradient_request *request,
    hsp_gradient_outputs *outputs);
int32_t __wrap_hsp_surface_get_gradient(const hsp_surface *surface, const hsp_gradient_request *request,
    hsp_gradient_outputs *outputs);
int32_t __wrap_hsp_surface_get_gradient(const hsp_surface *surface, const hsp_gradient_request *request,
    hsp_gradient_outputs *outputs) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_get_gradient");
  result = __real_hsp_surface_get_gradient(surface, request, outputs);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_get_part_counts(const hsp_surface *surface, hsp_surface_part_counts *counts);
int32_t __wrap_hsp_surface_get_part_counts(const hsp_surface *surface, hsp_surface_part_counts *counts);
int32_t __wrap_hsp_surface_get_part_counts(const hsp_surface *surface, hsp_surface_part_counts *counts) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_get_part_counts");
  result = __real_hsp_surface_get_part_counts(surface, counts);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_surface_next(const hsp_surface *surface, uint32_t h);
uint32_t __wrap_hsp_surface_next(const hsp_surface *surface, uint32_t h);
uint32_t __wrap_hsp_surface_next(const hsp_surface *surface, uint32_t h) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_next");
  result = __real_hsp_surface_next(surface, h);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_surface_previous(const hsp_surface *surface, uint32_t h);
uint32_t __wrap_hsp_surface_previous(const hsp_surface *surface, uint32_t h);
uint32_t __wrap_hsp_surface_previous(const hsp_surface *surface, uint32_t h) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_previous");
  result = __real_hsp_surface_previous(surface, h);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_surface_next_loop(const hsp_surface *surface, uint32_t h);
uint32_t __wrap_hsp_surface_next_loop(const hsp_surface *surface, uint32_t h);
uint32_t __wrap_hsp_surface_next_loop(const hsp_surface *surface, uint32_t h) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_next_loop");
  result = __real_hsp_surface_next_loop(surface, h);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_surface_origin(const hsp_surface *surface, uint32_t h);
uint32_t __wrap_hsp_surface_origin(const hsp_surface *surface, uint32_t h);
uint32_t __wrap_hsp_surface_origin(const hsp_surface *surface, uint32_t h) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_origin");
  result = __real_hsp_surface_origin(surface, h);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_surface_left(const hsp_surface *surface, uint32_t h);
uint32_t __wrap_hsp_surface_left(const hsp_surface *surface, uint32_t h);
uint32_t __wrap_hsp_surface_left(const hsp_surface *surface, uint32_t h) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_left");
  result = __real_hsp_surface_left(surface, h);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_get_patches(const hsp_surface *surface, uint32_t first, uint32_t count, hsp_surface_patch
    *out);
int32_t __wrap_hsp_surface_get_patches(const hsp_surface *surface, uint32_t first, uint32_t count, hsp_surface_patch
    *out);
int32_t __wrap_hsp_surface_get_patches(const hsp_surface *surface, uint32_t first, uint32_t count, hsp_surface_patch
    *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_get_patches");
  result = __real_hsp_surface_get_patches(surface, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_get_edges(const hsp_surface *surface, uint32_t first, uint32_t count, hsp_surface_edge *out);
int32_t __wrap_hsp_surface_get_edges(const hsp_surface *surface, uint32_t first, uint32_t count, hsp_surface_edge *out);
int32_t __wrap_hsp_surface_get_edges(const hsp_surface *surface, uint32_t first, uint32_t count, hsp_surface_edge *out)
    {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_get_edges");
  result = __real_hsp_surface_get_edges(surface, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_get_corners(const hsp_surface *surface, uint32_t first, uint32_t count, hsp_surface_corner
    *out);
int32_t __wrap_hsp_surface_get_corners(const hsp_surface *surface, uint32_t first, uint32_t count, hsp_surface_corner
    *out);
int32_t __wrap_hsp_surface_get_corners(const hsp_surface *surface, uint32_t first, uint32_t count, hsp_surface_corner
    *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_get_corners");
  result = __real_hsp_surface_get_corners(surface, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_get_shells(const hsp_surface *surface, hsp_surface_shell *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_surface_get_shells(const hsp_surface *surface, hsp_surface_shell *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_surface_get_shells(const hsp_surface *surface, hsp_surface_shell *out, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_get_shells");
  result = __real_hsp_surface_get_shells(surface, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_surface_check(hsp_surface *surface, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_surface_check(hsp_surface *surface, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_surface_check(hsp_surface *surface, uint32_t *invariant, uint32_t *id) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_surface_check");
  result = __real_hsp_surface_check(surface, invariant, id);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_mesh_limits_init(hsp_mesh_limits *limits, uint32_t struct_size, const hsp_boundary *boundary, double
    edge_length);
int32_t __wrap_hsp_mesh_limits_init(hsp_mesh_limits *limits, uint32_t struct_size, const hsp_boundary *boundary, double
    edge_length);
int32_t __wrap_hsp_mesh_limits_init(hsp_mesh_limits *limits, uint32_t struct_size, const hsp_boundary *boundary, double
    edge_length) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_mesh_limits_init");
  result = __real_hsp_mesh_limits_init(limits, struct_size, boundary, edge_length);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_mesh_limits_init_surface(hsp_mesh_limits *limits, uint32_t struct_size, const hsp_surface *surface,
    double edge_length);
int32_t __wrap_hsp_mesh_limits_init_surface(hsp_mesh_limits *limits, uint32_t struct_size, const hsp_surface *surface,
    double edge_length);
int32_t __wrap_hsp_mesh_limits_init_surface(hsp_mesh_limits *limits, uint32_t struct_size, const hsp_surface *surface,
    double edge_length) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_mesh_limits_init_surface");
  result = __real_hsp_mesh_limits_init_surface(limits, struct_size, surface, edge_length);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_mesh_bytes(const hsp_mesh_limits *limits, size_t *bytes);
int32_t __wrap_hsp_mesh_bytes(const hsp_mesh_limits *limits, size_t *bytes);
int32_t __wrap_hsp_mesh_bytes(const hsp_mesh_limits *limits, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_mesh_bytes");
  result = __real_hsp_mesh_bytes(limits, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_mesh_init(void *memory, size_t bytes, const hsp_mesh_limits *limits, hsp_mesh **mesh);
int32_t __wrap_hsp_mesh_init(void *memory, size_t bytes, const hsp_mesh_limits *limits, hsp_mesh **mesh);
int32_t __wrap_hsp_mesh_init(void *memory, size_t bytes, const hsp_mesh_limits *limits, hsp_mesh **mesh) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_mesh_init");
  result = __real_hsp_mesh_init(memory, bytes, limits, mesh);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_mesh_compute(hsp_mesh *mesh, const hsp_boundary *boundary, double edge_length, hsp_mesh_limits
    *limits);
int32_t __wrap_hsp_mesh_compute(hsp_mesh *mesh, const hsp_boundary *boundary, double edge_length, hsp_mesh_limits
    *limits);
int32_t __wrap_hsp_mesh_compute(hsp_mesh *mesh, const hsp_boundary *boundary, double edge_length, hsp_mesh_limits
    *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_mesh_compute");
  result = __real_hsp_mesh_compute(mesh, boundary, edge_length, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_mesh_compute_surface(hsp_mesh *mesh, const hsp_surface *surface, double edge_length, hsp_mesh_limits
    *limits);
int32_t __wrap_hsp_mesh_compute_surface(hsp_mesh *mesh, const hsp_surface *surface, double edge_length, hsp_mesh_limits
    *limits);
int32_t __wrap_hsp_mesh_compute_surface(hsp_mesh *mesh, const hsp_surface *surface, double edge_length, hsp_mesh_limits
    *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_mesh_compute_surface");
  result = __real_hsp_mesh_compute_surface(mesh, surface, edge_length, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_mesh_compute_with(hsp_mesh *mesh, const hsp_boundary *boundary, double edge_length, const
    hsp_mesh_request *request, hsp_mesh_limits *limits);
int32_t __wrap_hsp_mesh_compute_with(hsp_mesh *mesh, const hsp_boundary *boundary, double edge_length, const
    hsp_mesh_request *request, hsp_mesh_limits *limits);
int32_t __wrap_hsp_mesh_compute_with(hsp_mesh *mesh, const hsp_boundary *boundary, double edge_length, const
    hsp_mesh_request *request, hsp_mesh_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_mesh_compute_with");
  result = __real_hsp_mesh_compute_with(mesh, boundary, edge_length, request, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_mesh_compute_surface_with(hsp_mesh *mesh, const hsp_surface *surface, double edge_length, const
    hsp_mesh_request *request, hsp_mesh_limits *limits);
int32_t __wrap_hsp_mesh_compute_surface_with(hsp_mesh *mesh, const hsp_surface *surface, double edge_length, const
    hsp_mesh_request *request, hsp_mesh_limits *limits);
int32_t __wrap_hsp_mesh_compute_surface_with(hsp_mesh *mesh, const hsp_surface *surface, double edge_length, const
    hsp_mesh_request *request, hsp_mesh_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_mesh_compute_surface_with");
  result = __real_hsp_mesh_compute_surface_with(mesh, surface, edge_length, request, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_mesh_get_counts(const hsp_mesh *mesh, hsp_mesh_counts *counts);
int32_t __wrap_hsp_mesh_get_counts(const hsp_mesh *mesh, hsp_mesh_counts *counts);
int32_t __wrap_hsp_mesh_get_counts(const hsp_mesh *mesh, hsp_mesh_counts *counts) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_mesh_get_counts");
  result = __real_hsp_mesh_get_counts(mesh, counts);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_mesh_get_vertices(const hsp_mesh *mesh, double *xyz, double *normals, double *areas, uint32_t *balls,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_mesh_get_vertices(const hsp_mesh *mesh, double *xyz, double *normals, double *areas, uint32_t *balls,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_mesh_get_vertices(const hsp_mesh *mesh, double *xyz, double *normals, double *areas, uint32_t *balls,
    uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_mesh_get_vertices");
  result = __real_hsp_mesh_get_vertices(mesh, xyz, normals, areas, balls, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_mesh_get_weights(const hsp_mesh *mesh, const double *area, uint32_t patches, double *weights,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_mesh_get_weights(const hsp_mesh *mesh, const double *area, uint32_t patches, double *weights,
    uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_mesh_get_weights(const hsp_mesh *mesh, const double *area, uint32_t patches, double *weights,
    uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_mesh_get_weights");
  result = __real_hsp_mesh_get_weights(mesh, area, patches, weights, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_mesh_get_triangles(const hsp_mesh *mesh, uint32_t *corners, uint32_t *kinds, uint32_t *patches,
    uint32_t *balls, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_mesh_get_triangles(const hsp_mesh *mesh, uint32_t *corners, uint32_t *kinds, uint32_t *patches,
    uint32_t *balls, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_mesh_get_triangles(const hsp_mesh *mesh, uint32_t *corners, uint32_t *kinds, uint32_t *patches,
    uint32_t *balls, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_mesh_get_triangles");
  result = __real_hsp_mesh_get_triangles(mesh, corners, kinds, patches, balls, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_mesh_get_patch(const hsp_mesh *mesh, uint32_t patch, uint32_t *first, uint32_t *count);
int32_t __wrap_hsp_mesh_get_patch(const hsp_mesh *mesh, uint32_t patch, uint32_t *first, uint32_t *count);
int32_t __wrap_hsp_mesh_get_patch(const hsp_mesh *mesh, uint32_t patch, uint32_t *first, uint32_t *count) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_mesh_get_patch");
  result = __real_hsp_mesh_get_patch(mesh, patch, first, count);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_limits_init(hsp_topology_limits *limits, uint32_t struct_size, const hsp_boundary
    *boundary);
int32_t __wrap_hsp_topology_limits_init(hsp_topology_limits *limits, uint32_t struct_size, const hsp_boundary
    *boundary);
int32_t __wrap_hsp_topology_limits_init(hsp_topology_limits *limits, uint32_t struct_size, const hsp_boundary *boundary)
    {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_limits_init");
  result = __real_hsp_topology_limits_init(limits, struct_size, boundary);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_bytes(const hsp_topology_limits *limits, size_t *bytes);
int32_t __wrap_hsp_topology_bytes(const hsp_topology_limits *limits, size_t *bytes);
int32_t __wrap_hsp_topology_bytes(const hsp_topology_limits *limits, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_bytes");
  result = __real_hsp_topology_bytes(limits, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_init(void *memory, size_t bytes, const hsp_topology_limits *limits, hsp_topology
    **topology);
int32_t __wrap_hsp_topology_init(void *memory, size_t bytes, const hsp_topology_limits *limits, hsp_topology
    **topology);
int32_t __wrap_hsp_topology_init(void *memory, size_t bytes, const hsp_topology_limits *limits, hsp_topology **topology)
    {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_init");
  result = __real_hsp_topology_init(memory, bytes, limits, topology);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_compute(hsp_topology *topology, const hsp_boundary *boundary, hsp_topology_limits *limits);
int32_t __wrap_hsp_topology_compute(hsp_topology *topology, const hsp_boundary *boundary, hsp_topology_limits *limits);
int32_t __wrap_hsp_topology_compute(hsp_topology *topology, const hsp_boundary *boundary, hsp_topology_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_compute");
  result = __real_hsp_topology_compute(topology, boundary, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_compute_with(hsp_topology *topology, const hsp_boundary *boundary, const
    hsp_topology_request *request, hsp_topology_limits *limits);
int32_t __wrap_hsp_topology_compute_with(hsp_topology *topology, const hsp_boundary *boundary, const
    hsp_topology_request *request, hsp_topology_limits *limits);
int32_t __wrap_hsp_topology_compute_with(hsp_topology *topology, const hsp_boundary *boundary, const
    hsp_topology_request *request, hsp_topology_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_compute_with");
  result = __real_hsp_topology_compute_with(topology, boundary, request, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_get_counts(const hsp_topology *topology, hsp_topology_counts *counts);
int32_t __wrap_hsp_topology_get_counts(const hsp_topology *topology, hsp_topology_counts *counts);
int32_t __wrap_hsp_topology_get_counts(const hsp_topology *topology, hsp_topology_counts *counts) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_get_counts");
  result = __real_hsp_topology_get_counts(topology, counts);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_get_shells(const hsp_topology *topology, hsp_shell *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_topology_get_shells(const hsp_topology *topology, hsp_shell *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_topology_get_shells(const hsp_topology *topology, hsp_shell *out, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_get_shells");
  result = __real_hsp_topology_get_shells(topology, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_get_components(const hsp_topology *topology, hsp_component *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_topology_get_components(const hsp_topology *topology, hsp_component *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_topology_get_components(const hsp_topology *topology, hsp_component *out, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_get_components");
  result = __real_hsp_topology_get_components(topology, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_get_regions(const hsp_topology *topology, hsp_region *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_topology_get_regions(const hsp_topology *topology, hsp_region *out, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_topology_get_regions(const hsp_topology *topology, hsp_region *out, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_get_regions");
  result = __real_hsp_topology_get_regions(topology, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_get_region_shells(const hsp_topology *topology, uint32_t region, uint32_t *shells, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_topology_get_region_shells(const hsp_topology *topology, uint32_t region, uint32_t *shells, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_topology_get_region_shells(const hsp_topology *topology, uint32_t region, uint32_t *shells, uint32_t
    capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_get_region_shells");
  result = __real_hsp_topology_get_region_shells(topology, region, shells, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_get_region_balls(const hsp_topology *topology, uint32_t region, uint32_t *balls, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_topology_get_region_balls(const hsp_topology *topology, uint32_t region, uint32_t *balls, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_topology_get_region_balls(const hsp_topology *topology, uint32_t region, uint32_t *balls, uint32_t
    capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_get_region_balls");
  result = __real_hsp_topology_get_region_balls(topology, region, balls, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_locate(const hsp_topology *topology, const double *xyz, uint32_t *region);
int32_t __wrap_hsp_topology_locate(const hsp_topology *topology, const double *xyz, uint32_t *region);
int32_t __wrap_hsp_topology_locate(const hsp_topology *topology, const double *xyz, uint32_t *region) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_locate");
  result = __real_hsp_topology_locate(topology, xyz, region);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_topology_onext(const hsp_topology *topology, uint32_t q);
uint32_t __wrap_hsp_topology_onext(const hsp_topology *topology, uint32_t q);
uint32_t __wrap_hsp_topology_onext(const hsp_topology *topology, uint32_t q) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_onext");
  result = __real_hsp_topology_onext(topology, q);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_topology_lnext(const hsp_topology *topology, uint32_t q);
uint32_t __wrap_hsp_topology_lnext(const hsp_topology *topology, uint32_t q);
uint32_t __wrap_hsp_topology_lnext(const hsp_topology *topology, uint32_t q) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_lnext");
  result = __real_hsp_topology_lnext(topology, q);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_topology_origin(const hsp_topology *topology, uint32_t q);
uint32_t __wrap_hsp_topology_origin(const hsp_topology *topology, uint32_t q);
uint32_t __wrap_hsp_topology_origin(const hsp_topology *topology, uint32_t q) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_origin");
  result = __real_hsp_topology_origin(topology, q);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_topology_left(const hsp_topology *topology, uint32_t q);
uint32_t __wrap_hsp_topology_left(const hsp_topology *topology, uint32_t q);
uint32_t __wrap_hsp_topology_left(const hsp_topology *topology, uint32_t q) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_left");
  result = __real_hsp_topology_left(topology, q);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_get_quad_edges(const hsp_topology *topology, uint32_t first, uint32_t count, uint32_t
    *onext, uint32_t *origin);
int32_t __wrap_hsp_topology_get_quad_edges(const hsp_topology *topology, uint32_t first, uint32_t count, uint32_t
    *onext, uint32_t *origin);
int32_t __wrap_hsp_topology_get_quad_edges(const hsp_topology *topology, uint32_t first, uint32_t count, uint32_t
    *onext, uint32_t *origin) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_get_quad_edges");
  result = __real_hsp_topology_get_quad_edges(topology, first, count, onext, origin);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_get_vertices(const hsp_topology *topology, uint32_t first, uint32_t count,
    hsp_topology_vertex *out);
int32_t __wrap_hsp_topology_get_vertices(const hsp_topology *topology, uint32_t first, uint32_t count,
    hsp_topology_vertex *out);
int32_t __wrap_hsp_topology_get_vertices(const hsp_topology *topology, uint32_t first, uint32_t count,
    hsp_topology_vertex *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_get_vertices");
  result = __real_hsp_topology_get_vertices(topology, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_get_edges(const hsp_topology *topology, uint32_t first, uint32_t count, hsp_topology_edge
    *out);
int32_t __wrap_hsp_topology_get_edges(const hsp_topology *topology, uint32_t first, uint32_t count, hsp_topology_edge
    *out);
int32_t __wrap_hsp_topology_get_edges(const hsp_topology *topology, uint32_t first, uint32_t count, hsp_topology_edge
    *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_get_edges");
  result = __real_hsp_topology_get_edges(topology, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_get_simple_faces(const hsp_topology *topology, uint32_t first, uint32_t count,
    hsp_simple_face *out);
int32_t __wrap_hsp_topology_get_simple_faces(const hsp_topology *topology, uint32_t first, uint32_t count,
    hsp_simple_face *out);
int32_t __wrap_hsp_topology_get_simple_faces(const hsp_topology *topology, uint32_t first, uint32_t count,
    hsp_simple_face *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_get_simple_faces");
  result = __real_hsp_topology_get_simple_faces(topology, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_get_traversal(const hsp_topology *topology, uint32_t shell, uint32_t *faces, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_topology_get_traversal(const hsp_topology *topology, uint32_t shell, uint32_t *faces, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_topology_get_traversal(const hsp_topology *topology, uint32_t shell, uint32_t *faces, uint32_t
    capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_get_traversal");
  result = __real_hsp_topology_get_traversal(topology, shell, faces, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_topology_check(hsp_topology *topology, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_topology_check(hsp_topology *topology, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_topology_check(hsp_topology *topology, uint32_t *invariant, uint32_t *id) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_topology_check");
  result = __real_hsp_topology_check(topology, invariant, id);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_cells_limits_init(hsp_cells_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_cells_limits_init(hsp_cells_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_cells_limits_init(hsp_cells_limits *limits, uint32_t struct_size, uint32_t balls) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_cells_limits_init");
  result = __real_hsp_cells_limits_init(limits, struct_size, balls);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_cells_bytes(const hsp_cells_limits *limits, size_t *bytes);
int32_t __wrap_hsp_cells_bytes(const hsp_cells_limits *limits, size_t *bytes);
int32_t __wrap_hsp_cells_bytes(const hsp_cells_limits *limits, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_cells_bytes");
  result = __real_hsp_cells_bytes(limits, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_cells_init(void *memory, size_t bytes, const hsp_cells_limits *limits, hsp_cells **cells);
int32_t __wrap_hsp_cells_init(void *memory, size_t bytes, const hsp_cells_limits *limits, hsp_cells **cells);
int32_t __wrap_hsp_cells_init(void *memory, size_t bytes, const hsp_cells_limits *limits, hsp_cells **cells) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_cells_init");
  result = __real_hsp_cells_init(memory, bytes, limits, cells);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_cells_compute(hsp_cells *cells, const hsp_model *model, hsp_cells_limits *limits);
int32_t __wrap_hsp_cells_compute(hsp_cells *cells, const hsp_model *model, hsp_cells_limits *limits);
int32_t __wrap_hsp_cells_compute(hsp_cells *cells, const hsp_model *model, hsp_cells_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_cells_compute");
  result = __real_hsp_cells_compute(cells, model, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_cells_compute_with(hsp_cells *cells, const hsp_model *model, const hsp_cells_request *request,
    hsp_cells_limits *limits);
int32_t __wrap_hsp_cells_compute_with(hsp_cells *cells, const hsp_model *model, const hsp_cells_request *request,
    hsp_cells_limits *limits);
int32_t __wrap_hsp_cells_compute_with(hsp_cells *cells, const hsp_model *model, const hsp_cells_request *request,
    hsp_cells_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_cells_compute_with");
  result = __real_hsp_cells_compute_with(cells, model, request, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_cells_get_counts(const hsp_cells *cells, hsp_cells_counts *counts);
int32_t __wrap_hsp_cells_get_counts(const hsp_cells *cells, hsp_cells_counts *counts);
int32_t __wrap_hsp_cells_get_counts(const hsp_cells *cells, hsp_cells_counts *counts) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_cells_get_counts");
  result = __real_hsp_cells_get_counts(cells, counts);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_cells_get_cells(const hsp_cells *cells, uint32_t first, uint32_t count, hsp_free_cell *out);
int32_t __wrap_hsp_cells_get_cells(const hsp_cells *cells, uint32_t first, uint32_t count, hsp_free_cell *out);
int32_t __wrap_hsp_cells_get_cells(const hsp_cells *cells, uint32_t first, uint32_t count, hsp_free_cell *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_cells_get_cells");
  result = __real_hsp_cells_get_cells(cells, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_cells_get_neighbours(const hsp_cells *cells, uint32_t cell, uint32_t *neighbours, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_cells_get_neighbours(const hsp_cells *cells, uint32_t cell, uint32_t *neighbours, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_cells_get_neighbours(const hsp_cells *cells, uint32_t cell, uint32_t *neighbours, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_cells_get_neighbours");
  result = __real_hsp_cells_get_neighbours(cells, cell, neighbours, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_cells_get_pairs(const hsp_cells *cells, uint32_t first, uint32_t count, hsp_cell_pair *out);
int32_t __wrap_hsp_cells_get_pairs(const hsp_cells *cells, uint32_t first, uint32_t count, hsp_cell_pair *out);
int32_t __wrap_hsp_cells_get_pairs(const hsp_cells *cells, uint32_t first, uint32_t count, hsp_cell_pair *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_cells_get_pairs");
  result = __real_hsp_cells_get_pairs(cells, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_cells_locate(const hsp_cells *cells, const double *xyz, uint32_t *cell);
int32_t __wrap_hsp_cells_locate(const hsp_cells *cells, const double *xyz, uint32_t *cell);
int32_t __wrap_hsp_cells_locate(const hsp_cells *cells, const double *xyz, uint32_t *cell) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_cells_locate");
  result = __real_hsp_cells_locate(cells, xyz, cell);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_cells_check(hsp_cells *cells, const hsp_topology *topology, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_cells_check(hsp_cells *cells, const hsp_topology *topology, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_cells_check(hsp_cells *cells, const hsp_topology *topology, uint32_t *invariant, uint32_t *id) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_cells_check");
  result = __real_hsp_cells_check(cells, topology, invariant, id);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_model_arrangement(const hsp_model *model, hsp_arrangement *totals, hsp_arrangement *of_ball, uint32_t
    *scratch, uint32_t words, uint32_t *words_needed);
int32_t __wrap_hsp_model_arrangement(const hsp_model *model, hsp_arrangement *totals, hsp_arrangement *of_ball, uint32_t
    *scratch, uint32_t words, uint32_t *words_needed);
int32_t __wrap_hsp_model_arrangement(const hsp_model *model, hsp_arrangement *totals, hsp_arrangement *of_ball, uint32_t
    *scratch, uint32_t words, uint32_t *words_needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_model_arrangement");
  result = __real_hsp_model_arrangement(model, totals, of_ball, scratch, words, words_needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_paths_limits_init(hsp_paths_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_paths_limits_init(hsp_paths_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_paths_limits_init(hsp_paths_limits *limits, uint32_t struct_size, uint32_t balls) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_paths_limits_init");
  result = __real_hsp_paths_limits_init(limits, struct_size, balls);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_paths_bytes(const hsp_paths_limits *limits, size_t *bytes);
int32_t __wrap_hsp_paths_bytes(const hsp_paths_limits *limits, size_t *bytes);
int32_t __wrap_hsp_paths_bytes(const hsp_paths_limits *limits, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_paths_bytes");
  result = __real_hsp_paths_bytes(limits, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_paths_init(void *memory, size_t bytes, const hsp_paths_limits *limits, hsp_paths **paths);
int32_t __wrap_hsp_paths_init(void *memory, size_t bytes, const hsp_paths_limits *limits, hsp_paths **paths);
int32_t __wrap_hsp_paths_init(void *memory, size_t bytes, const hsp_paths_limits *limits, hsp_paths **paths) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_paths_init");
  result = __real_hsp_paths_init(memory, bytes, limits, paths);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_paths_compute(hsp_paths *paths, const hsp_model *model, hsp_paths_limits *limits);
int32_t __wrap_hsp_paths_compute(hsp_paths *paths, const hsp_model *model, hsp_paths_limits *limits);
int32_t __wrap_hsp_paths_compute(hsp_paths *paths, const hsp_model *model, hsp_paths_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_paths_compute");
  result = __real_hsp_paths_compute(paths, model, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_paths_compute_with(hsp_paths *paths, const hsp_model *model, const hsp_paths_request *request,
    hsp_paths_limits *limits);
int32_t __wrap_hsp_paths_compute_with(hsp_paths *paths, const hsp_model *model, const hsp_paths_request *request,
    hsp_paths_limits *limits);
int32_t __wrap_hsp_paths_compute_with(hsp_paths *paths, const hsp_model *model, const hsp_paths_request *request,
    hsp_paths_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_paths_compute_with");
  result = __real_hsp_paths_compute_with(paths, model, request, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_paths_find(hsp_paths *paths, const double *from, const double *to, hsp_path *path, hsp_paths_limits
    *limits);
int32_t __wrap_hsp_paths_find(hsp_paths *paths, const double *from, const double *to, hsp_path *path, hsp_paths_limits
    *limits);
int32_t __wrap_hsp_paths_find(hsp_paths *paths, const double *from, const double *to, hsp_path *path, hsp_paths_limits
    *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_paths_find");
  result = __real_hsp_paths_find(paths, from, to, path, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_paths_find_with(hsp_paths *paths, const double *from, const double *to, const hsp_paths_request
    *request, hsp_path *path, hsp_paths_limits *limits);
int32_t __wrap_hsp_paths_find_with(hsp_paths *paths, const double *from, const double *to, const hsp_paths_request
    *request, hsp_path *path, hsp_paths_limits *limits);
int32_t __wrap_hsp_paths_find_with(hsp_paths *paths, const double *from, const double *to, const hsp_paths_request
    *request, hsp_path *path, hsp_paths_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_paths_find_with");
  result = __real_hsp_paths_find_with(paths, from, to, request, path, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_paths_get_points(const hsp_paths *paths, double *points, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_paths_get_points(const hsp_paths *paths, double *points, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_paths_get_points(const hsp_paths *paths, double *points, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_paths_get_points");
  result = __real_hsp_paths_get_points(paths, points, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_limits_init(hsp_pores_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_pores_limits_init(hsp_pores_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_pores_limits_init(hsp_pores_limits *limits, uint32_t struct_size, uint32_t balls) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_limits_init");
  result = __real_hsp_pores_limits_init(limits, struct_size, balls);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_bytes(const hsp_pores_limits *limits, size_t *bytes);
int32_t __wrap_hsp_pores_bytes(const hsp_pores_limits *limits, size_t *bytes);
int32_t __wrap_hsp_pores_bytes(const hsp_pores_limits *limits, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_bytes");
  result = __real_hsp_pores_bytes(limits, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_init(void *memory, size_t bytes, const hsp_pores_limits *limits, hsp_pores **pores);
int32_t __wrap_hsp_pores_init(void *memory, size_t bytes, const hsp_pores_limits *limits, hsp_pores **pores);
int32_t __wrap_hsp_pores_init(void *memory, size_t bytes, const hsp_pores_limits *limits, hsp_pores **pores) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_init");
  result = __real_hsp_pores_init(memory, bytes, limits, pores);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_options_init(hsp_pores_options *options, uint32_t struct_size);
int32_t __wrap_hsp_pores_options_init(hsp_pores_options *options, uint32_t struct_size);
int32_t __wrap_hsp_pores_options_init(hsp_pores_options *options, uint32_t struct_size) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_options_init");
  result = __real_hsp_pores_options_init(options, struct_size);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_compute(hsp_pores *pores, const hsp_model *model, const hsp_pores_options *options,
    hsp_pores_limits *limits);
int32_t __wrap_hsp_pores_compute(hsp_pores *pores, const hsp_model *model, const hsp_pores_options *options,
    hsp_pores_limits *limits);
int32_t __wrap_hsp_pores_compute(hsp_pores *pores, const hsp_model *model, const hsp_pores_options *options,
    hsp_pores_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_compute");
  result = __real_hsp_pores_compute(pores, model, options, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_compute_periodic(hsp_pores *pores, const hsp_periodic *periodic, const hsp_pores_options
    *options, hsp_pores_limits *limits);
int32_t __wrap_hsp_pores_compute_periodic(hsp_pores *pores, const hsp_periodic *periodic, const hsp_pores_options
    *options, hsp_pores_limits *limits);
int32_t __wrap_hsp_pores_compute_periodic(hsp_pores *pores, const hsp_periodic *periodic, const hsp_pores_options
    *options, hsp_pores_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_compute_periodic");
  result = __real_hsp_pores_compute_periodic(pores, periodic, options, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_counts(const hsp_pores *pores, hsp_pores_counts *counts);
int32_t __wrap_hsp_pores_get_counts(const hsp_pores *pores, hsp_pores_counts *counts);
int32_t __wrap_hsp_pores_get_counts(const hsp_pores *pores, hsp_pores_counts *counts) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_counts");
  result = __real_hsp_pores_get_counts(pores, counts);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_maxima(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_maximum *out);
int32_t __wrap_hsp_pores_get_maxima(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_maximum *out);
int32_t __wrap_hsp_pores_get_maxima(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_maximum *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_maxima");
  result = __real_hsp_pores_get_maxima(pores, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_gates(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_gate *out);
int32_t __wrap_hsp_pores_get_gates(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_gate *out);
int32_t __wrap_hsp_pores_get_gates(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_gate *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_gates");
  result = __real_hsp_pores_get_gates(pores, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_gate_shifts(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_gate_shifts
    *out);
int32_t __wrap_hsp_pores_get_gate_shifts(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_gate_shifts
    *out);
int32_t __wrap_hsp_pores_get_gate_shifts(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_gate_shifts
    *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_gate_shifts");
  result = __real_hsp_pores_get_gate_shifts(pores, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_maximum_balls(const hsp_pores *pores, uint32_t maximum, uint32_t *balls, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_maximum_balls(const hsp_pores *pores, uint32_t maximum, uint32_t *balls, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_maximum_balls(const hsp_pores *pores, uint32_t maximum, uint32_t *balls, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_maximum_balls");
  result = __real_hsp_pores_get_maximum_balls(pores, maximum, balls, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_gate_balls(const hsp_pores *pores, uint32_t gate, uint32_t *balls, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_gate_balls(const hsp_pores *pores, uint32_t gate, uint32_t *balls, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_gate_balls(const hsp_pores *pores, uint32_t gate, uint32_t *balls, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_gate_balls");
  result = __real_hsp_pores_get_gate_balls(pores, gate, balls, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_maximum_images(const hsp_pores *pores, uint32_t maximum, hsp_image *images, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_pores_get_maximum_images(const hsp_pores *pores, uint32_t maximum, hsp_image *images, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_pores_get_maximum_images(const hsp_pores *pores, uint32_t maximum, hsp_image *images, uint32_t
    capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_maximum_images");
  result = __real_hsp_pores_get_maximum_images(pores, maximum, images, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_gate_images(const hsp_pores *pores, uint32_t gate, hsp_image *images, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_gate_images(const hsp_pores *pores, uint32_t gate, hsp_image *images, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_gate_images(const hsp_pores *pores, uint32_t gate, hsp_image *images, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_gate_images");
  result = __real_hsp_pores_get_gate_images(pores, gate, images, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_percolation(const hsp_pores *pores, hsp_pore_percolation *percolation);
int32_t __wrap_hsp_pores_get_percolation(const hsp_pores *pores, hsp_pore_percolation *percolation);
int32_t __wrap_hsp_pores_get_percolation(const hsp_pores *pores, hsp_pore_percolation *percolation) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_percolation");
  result = __real_hsp_pores_get_percolation(pores, percolation);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_channels(hsp_pores *pores, double radius, hsp_pore_channel *out, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_channels(hsp_pores *pores, double radius, hsp_pore_channel *out, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_channels(hsp_pores *pores, double radius, hsp_pore_channel *out, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_channels");
  result = __real_hsp_pores_get_channels(pores, radius, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_class_at(const hsp_pores *pores, uint32_t maximum, double radius, uint32_t *member);
int32_t __wrap_hsp_pores_class_at(const hsp_pores *pores, uint32_t maximum, double radius, uint32_t *member);
int32_t __wrap_hsp_pores_class_at(const hsp_pores *pores, uint32_t maximum, double radius, uint32_t *member) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_class_at");
  result = __real_hsp_pores_class_at(pores, maximum, radius, member);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_gate_between(const hsp_pores *pores, uint32_t maximum, uint32_t other, uint32_t *gate);
int32_t __wrap_hsp_pores_gate_between(const hsp_pores *pores, uint32_t maximum, uint32_t other, uint32_t *gate);
int32_t __wrap_hsp_pores_gate_between(const hsp_pores *pores, uint32_t maximum, uint32_t other, uint32_t *gate) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_gate_between");
  result = __real_hsp_pores_gate_between(pores, maximum, other, gate);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_locate(const hsp_pores *pores, const double *xyz, hsp_pore_place *place);
int32_t __wrap_hsp_pores_locate(const hsp_pores *pores, const double *xyz, hsp_pore_place *place);
int32_t __wrap_hsp_pores_locate(const hsp_pores *pores, const double *xyz, hsp_pore_place *place) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_locate");
  result = __real_hsp_pores_locate(pores, xyz, place);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_locate_with_shifts(const hsp_pores *pores, const double *xyz, hsp_pore_place *place,
    hsp_pore_place_shifts *shifts);
int32_t __wrap_hsp_pores_locate_with_shifts(const hsp_pores *pores, const double *xyz, hsp_pore_place *place,
    hsp_pore_place_shifts *shifts);
int32_t __wrap_hsp_pores_locate_with_shifts(const hsp_pores *pores, const double *xyz, hsp_pore_place *place,
    hsp_pore_place_shifts *shifts) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_locate_with_shifts");
  result = __real_hsp_pores_locate_with_shifts(pores, xyz, place, shifts);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_widest(const hsp_pores *pores, const double *from, const double *to, hsp_pore_passage
    *passage);
int32_t __wrap_hsp_pores_widest(const hsp_pores *pores, const double *from, const double *to, hsp_pore_passage
    *passage);
int32_t __wrap_hsp_pores_widest(const hsp_pores *pores, const double *from, const double *to, hsp_pore_passage *passage)
    {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_widest");
  result = __real_hsp_pores_widest(pores, from, to, passage);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_find_tunnel(hsp_pores *pores, const double *from, const double *to, const uint32_t *avoided,
    uint32_t count, hsp_tunnel *tunnel, hsp_pores_limits *limits);
int32_t __wrap_hsp_pores_find_tunnel(hsp_pores *pores, const double *from, const double *to, const uint32_t *avoided,
    uint32_t count, hsp_tunnel *tunnel, hsp_pores_limits *limits);
int32_t __wrap_hsp_pores_find_tunnel(hsp_pores *pores, const double *from, const double *to, const uint32_t *avoided,
    uint32_t count, hsp_tunnel *tunnel, hsp_pores_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_find_tunnel");
  result = __real_hsp_pores_find_tunnel(pores, from, to, avoided, count, tunnel, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_find_cheapest_tunnel(hsp_pores *pores, const double *from, const double *to, const uint32_t
    *avoided, uint32_t count, hsp_tunnel *tunnel, hsp_pores_limits *limits);
int32_t __wrap_hsp_pores_find_cheapest_tunnel(hsp_pores *pores, const double *from, const double *to, const uint32_t
    *avoided, uint32_t count, hsp_tunnel *tunnel, hsp_pores_limits *limits);
int32_t __wrap_hsp_pores_find_cheapest_tunnel(hsp_pores *pores, const double *from, const double *to, const uint32_t
    *avoided, uint32_t count, hsp_tunnel *tunnel, hsp_pores_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_find_cheapest_tunnel");
  result = __real_hsp_pores_find_cheapest_tunnel(pores, from, to, avoided, count, tunnel, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_find_tunnel_with(hsp_pores *pores, const double *from, const double *to, const uint32_t
    *avoided, uint32_t count, const hsp_tunnel_request *request, hsp_tunnel *tunnel, hsp_pores_limits *limits);
int32_t __wrap_hsp_pores_find_tunnel_with(hsp_pores *pores, const double *from, const double *to, const uint32_t
    *avoided, uint32_t count, const hsp_tunnel_request *request, hsp_tunnel *tunnel, hsp_pores_limits *limits);
int32_t __wrap_hsp_pores_find_tunnel_with(hsp_pores *pores, const double *from, const double *to, const uint32_t
    *avoided, uint32_t count, const hsp_tunnel_request *request, hsp_tunnel *tunnel, hsp_pores_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_find_tunnel_with");
  result = __real_hsp_pores_find_tunnel_with(pores, from, to, avoided, count, request, tunnel, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_tunnel_route(const hsp_pores *pores, hsp_tunnel_route *route);
int32_t __wrap_hsp_pores_get_tunnel_route(const hsp_pores *pores, hsp_tunnel_route *route);
int32_t __wrap_hsp_pores_get_tunnel_route(const hsp_pores *pores, hsp_tunnel_route *route) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_tunnel_route");
  result = __real_hsp_pores_get_tunnel_route(pores, route);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_tunnel_points(const hsp_pores *pores, hsp_tunnel_point *points, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_pores_get_tunnel_points(const hsp_pores *pores, hsp_tunnel_point *points, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_pores_get_tunnel_points(const hsp_pores *pores, hsp_tunnel_point *points, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_tunnel_points");
  result = __real_hsp_pores_get_tunnel_points(pores, points, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_tunnel_point_shifts(const hsp_pores *pores, hsp_tunnel_point_shifts *points, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_pores_get_tunnel_point_shifts(const hsp_pores *pores, hsp_tunnel_point_shifts *points, uint32_t
    capacity, uint32_t *needed);
int32_t __wrap_hsp_pores_get_tunnel_point_shifts(const hsp_pores *pores, hsp_tunnel_point_shifts *points, uint32_t
    capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_tunnel_point_shifts");
  result = __real_hsp_pores_get_tunnel_point_shifts(pores, points, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_find_pockets(hsp_pores *pores, double narrow, double wide, uint32_t *pockets);
int32_t __wrap_hsp_pores_find_pockets(hsp_pores *pores, double narrow, double wide, uint32_t *pockets);
int32_t __wrap_hsp_pores_find_pockets(hsp_pores *pores, double narrow, double wide, uint32_t *pockets) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_find_pockets");
  result = __real_hsp_pores_find_pockets(pores, narrow, wide, pockets);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_pockets(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_pocket *out);
int32_t __wrap_hsp_pores_get_pockets(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_pocket *out);
int32_t __wrap_hsp_pores_get_pockets(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_pocket *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_pockets");
  result = __real_hsp_pores_get_pockets(pores, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_pocket_maxima(const hsp_pores *pores, uint32_t pocket, uint32_t *maxima, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_pocket_maxima(const hsp_pores *pores, uint32_t pocket, uint32_t *maxima, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_pocket_maxima(const hsp_pores *pores, uint32_t pocket, uint32_t *maxima, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_pocket_maxima");
  result = __real_hsp_pores_get_pocket_maxima(pores, pocket, maxima, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_pocket_mouths(const hsp_pores *pores, uint32_t pocket, uint32_t *gates, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_pocket_mouths(const hsp_pores *pores, uint32_t pocket, uint32_t *gates, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_pocket_mouths(const hsp_pores *pores, uint32_t pocket, uint32_t *gates, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_pocket_mouths");
  result = __real_hsp_pores_get_pocket_mouths(pores, pocket, gates, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_pocket_balls(const hsp_pores *pores, uint32_t pocket, uint32_t *balls, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_pocket_balls(const hsp_pores *pores, uint32_t pocket, uint32_t *balls, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_pocket_balls(const hsp_pores *pores, uint32_t pocket, uint32_t *balls, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_pocket_balls");
  result = __real_hsp_pores_get_pocket_balls(pores, pocket, balls, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_plugged_balls(const hsp_pores *pores, double *xyz, double *radius, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_plugged_balls(const hsp_pores *pores, double *xyz, double *radius, uint32_t capacity,
    uint32_t *needed);
int32_t __wrap_hsp_pores_get_plugged_balls(const hsp_pores *pores, double *xyz, double *radius, uint32_t capacity,
    uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_plugged_balls");
  result = __real_hsp_pores_get_plugged_balls(pores, xyz, radius, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_find_regions(hsp_pores *pores, const hsp_boundary *boundary, hsp_pore_access *access, uint32_t
    *regions);
int32_t __wrap_hsp_pores_find_regions(hsp_pores *pores, const hsp_boundary *boundary, hsp_pore_access *access, uint32_t
    *regions);
int32_t __wrap_hsp_pores_find_regions(hsp_pores *pores, const hsp_boundary *boundary, hsp_pore_access *access, uint32_t
    *regions) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_find_regions");
  result = __real_hsp_pores_find_regions(pores, boundary, access, regions);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_find_regions_with(hsp_pores *pores, const hsp_boundary *boundary, const hsp_pores_request
    *request, hsp_pore_access *access, uint32_t *regions);
int32_t __wrap_hsp_pores_find_regions_with(hsp_pores *pores, const hsp_boundary *boundary, const hsp_pores_request
    *request, hsp_pore_access *access, uint32_t *regions);
int32_t __wrap_hsp_pores_find_regions_with(hsp_pores *pores, const hsp_boundary *boundary, const hsp_pores_request
    *request, hsp_pore_access *access, uint32_t *regions) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_find_regions_with");
  result = __real_hsp_pores_find_regions_with(pores, boundary, request, access, regions);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_get_regions(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_region *out);
int32_t __wrap_hsp_pores_get_regions(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_region *out);
int32_t __wrap_hsp_pores_get_regions(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_region *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_get_regions");
  result = __real_hsp_pores_get_regions(pores, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_measure_pockets(hsp_pores *pores, hsp_pores *plugged, const hsp_boundary *boundary,
    hsp_pore_pocket_size *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_pores_measure_pockets(hsp_pores *pores, hsp_pores *plugged, const hsp_boundary *boundary,
    hsp_pore_pocket_size *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_pores_measure_pockets(hsp_pores *pores, hsp_pores *plugged, const hsp_boundary *boundary,
    hsp_pore_pocket_size *out, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_measure_pockets");
  result = __real_hsp_pores_measure_pockets(pores, plugged, boundary, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_pores_measure_pockets_with(hsp_pores *pores, hsp_pores *plugged, const hsp_boundary *boundary, const
    hsp_pores_request *request, hsp_pore_pocket_size *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_pores_measure_pockets_with(hsp_pores *pores, hsp_pores *plugged, const hsp_boundary *boundary, const
    hsp_pores_request *request, hsp_pore_pocket_size *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_pores_measure_pockets_with(hsp_pores *pores, hsp_pores *plugged, const hsp_boundary *boundary, const
    hsp_pores_request *request, hsp_pore_pocket_size *out, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_pores_measure_pockets_with");
  result = __real_hsp_pores_measure_pockets_with(pores, plugged, boundary, request, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_view_limits_init(hsp_view_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_view_limits_init(hsp_view_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_view_limits_init(hsp_view_limits *limits, uint32_t struct_size, uint32_t balls) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_view_limits_init");
  result = __real_hsp_view_limits_init(limits, struct_size, balls);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_view_bytes(const hsp_view_limits *limits, size_t *bytes);
int32_t __wrap_hsp_view_bytes(const hsp_view_limits *limits, size_t *bytes);
int32_t __wrap_hsp_view_bytes(const hsp_view_limits *limits, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_view_bytes");
  result = __real_hsp_view_bytes(limits, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_view_init(void *memory, size_t bytes, const hsp_view_limits *limits, hsp_view **view);
int32_t __wrap_hsp_view_init(void *memory, size_t bytes, const hsp_view_limits *limits, hsp_view **view);
int32_t __wrap_hsp_view_init(void *memory, size_t bytes, const hsp_view_limits *limits, hsp_view **view) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_view_init");
  result = __real_hsp_view_init(memory, bytes, limits, view);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_view_options_init(hsp_view_options *options, uint32_t struct_size);
int32_t __wrap_hsp_view_options_init(hsp_view_options *options, uint32_t struct_size);
int32_t __wrap_hsp_view_options_init(hsp_view_options *options, uint32_t struct_size) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_view_options_init");
  result = __real_hsp_view_options_init(options, struct_size);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_view_options_turn(hsp_view_options *options, double x, double y, double z);
int32_t __wrap_hsp_view_options_turn(hsp_view_options *options, double x, double y, double z);
int32_t __wrap_hsp_view_options_turn(hsp_view_options *options, double x, double y, double z) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_view_options_turn");
  result = __real_hsp_view_options_turn(options, x, y, z);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_view_compute(hsp_view *view, const hsp_model *model, const hsp_boundary *boundary, const
    hsp_view_options *options, hsp_view_limits *limits);
int32_t __wrap_hsp_view_compute(hsp_view *view, const hsp_model *model, const hsp_boundary *boundary, const
    hsp_view_options *options, hsp_view_limits *limits);
int32_t __wrap_hsp_view_compute(hsp_view *view, const hsp_model *model, const hsp_boundary *boundary, const
    hsp_view_options *options, hsp_view_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_view_compute");
  result = __real_hsp_view_compute(view, model, boundary, options, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_view_get_info(const hsp_view *view, hsp_view_info *info);
int32_t __wrap_hsp_view_get_info(const hsp_view *view, hsp_view_info *info);
int32_t __wrap_hsp_view_get_info(const hsp_view *view, hsp_view_info *info) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_view_get_info");
  result = __real_hsp_view_get_info(view, info);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_view_get_pieces(const hsp_view *view, hsp_view_piece *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_view_get_pieces(const hsp_view *view, hsp_view_piece *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_view_get_pieces(const hsp_view *view, hsp_view_piece *out, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_view_get_pieces");
  result = __real_hsp_view_get_pieces(view, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_view_get_loops(const hsp_view *view, hsp_view_loop *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_view_get_loops(const hsp_view *view, hsp_view_loop *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_view_get_loops(const hsp_view *view, hsp_view_loop *out, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_view_get_loops");
  result = __real_hsp_view_get_loops(view, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_view_get_arcs(const hsp_view *view, hsp_view_arc *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_view_get_arcs(const hsp_view *view, hsp_view_arc *out, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_view_get_arcs(const hsp_view *view, hsp_view_arc *out, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_view_get_arcs");
  result = __real_hsp_view_get_arcs(view, out, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_map_limits_init(hsp_map_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_map_limits_init(hsp_map_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_map_limits_init(hsp_map_limits *limits, uint32_t struct_size, uint32_t balls) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_limits_init");
  result = __real_hsp_map_limits_init(limits, struct_size, balls);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_map_bytes(const hsp_map_limits *limits, size_t *bytes);
int32_t __wrap_hsp_map_bytes(const hsp_map_limits *limits, size_t *bytes);
int32_t __wrap_hsp_map_bytes(const hsp_map_limits *limits, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_bytes");
  result = __real_hsp_map_bytes(limits, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_map_init(void *memory, size_t bytes, const hsp_map_limits *limits, hsp_map **map);
int32_t __wrap_hsp_map_init(void *memory, size_t bytes, const hsp_map_limits *limits, hsp_map **map);
int32_t __wrap_hsp_map_init(void *memory, size_t bytes, const hsp_map_limits *limits, hsp_map **map) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_init");
  result = __real_hsp_map_init(memory, bytes, limits, map);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_map_compute(hsp_map *map, const hsp_model *model, const hsp_view_options *options, hsp_map_limits
    *limits);
int32_t __wrap_hsp_map_compute(hsp_map *map, const hsp_model *model, const hsp_view_options *options, hsp_map_limits
    *limits);
int32_t __wrap_hsp_map_compute(hsp_map *map, const hsp_model *model, const hsp_view_options *options, hsp_map_limits
    *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_compute");
  result = __real_hsp_map_compute(map, model, options, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_map_get_info(const hsp_map *map, hsp_map_info *info);
int32_t __wrap_hsp_map_get_info(const hsp_map *map, hsp_map_info *info);
int32_t __wrap_hsp_map_get_info(const hsp_map *map, hsp_map_info *info) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_get_info");
  result = __real_hsp_map_get_info(map, info);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_map_next(const hsp_map *map, uint32_t h);
uint32_t __wrap_hsp_map_next(const hsp_map *map, uint32_t h);
uint32_t __wrap_hsp_map_next(const hsp_map *map, uint32_t h) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_next");
  result = __real_hsp_map_next(map, h);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_map_previous(const hsp_map *map, uint32_t h);
uint32_t __wrap_hsp_map_previous(const hsp_map *map, uint32_t h);
uint32_t __wrap_hsp_map_previous(const hsp_map *map, uint32_t h) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_previous");
  result = __real_hsp_map_previous(map, h);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_map_next_loop(const hsp_map *map, uint32_t h);
uint32_t __wrap_hsp_map_next_loop(const hsp_map *map, uint32_t h);
uint32_t __wrap_hsp_map_next_loop(const hsp_map *map, uint32_t h) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_next_loop");
  result = __real_hsp_map_next_loop(map, h);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_map_origin(const hsp_map *map, uint32_t h);
uint32_t __wrap_hsp_map_origin(const hsp_map *map, uint32_t h);
uint32_t __wrap_hsp_map_origin(const hsp_map *map, uint32_t h) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_origin");
  result = __real_hsp_map_origin(map, h);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_map_left(const hsp_map *map, uint32_t h);
uint32_t __wrap_hsp_map_left(const hsp_map *map, uint32_t h);
uint32_t __wrap_hsp_map_left(const hsp_map *map, uint32_t h) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_left");
  result = __real_hsp_map_left(map, h);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_map_get_vertices(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_vertex *out);
int32_t __wrap_hsp_map_get_vertices(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_vertex *out);
int32_t __wrap_hsp_map_get_vertices(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_vertex *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_get_vertices");
  result = __real_hsp_map_get_vertices(map, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_map_get_edges(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_edge *out);
int32_t __wrap_hsp_map_get_edges(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_edge *out);
int32_t __wrap_hsp_map_get_edges(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_edge *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_get_edges");
  result = __real_hsp_map_get_edges(map, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_map_get_faces(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_face *out);
int32_t __wrap_hsp_map_get_faces(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_face *out);
int32_t __wrap_hsp_map_get_faces(const hsp_map *map, uint32_t first, uint32_t count, hsp_map_face *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_get_faces");
  result = __real_hsp_map_get_faces(map, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_map_get_areas(const hsp_map *map, double *area, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_map_get_areas(const hsp_map *map, double *area, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_map_get_areas(const hsp_map *map, double *area, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_get_areas");
  result = __real_hsp_map_get_areas(map, area, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_map_get_outline(const hsp_map *map, uint32_t ball, uint32_t *h, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_map_get_outline(const hsp_map *map, uint32_t ball, uint32_t *h, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_map_get_outline(const hsp_map *map, uint32_t ball, uint32_t *h, uint32_t capacity, uint32_t *needed)
    {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_get_outline");
  result = __real_hsp_map_get_outline(map, ball, h, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_map_pick(const hsp_map *map, double x, double y, hsp_map_sight *sight);
int32_t __wrap_hsp_map_pick(const hsp_map *map, double x, double y, hsp_map_sight *sight);
int32_t __wrap_hsp_map_pick(const hsp_map *map, double x, double y, hsp_map_sight *sight) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_pick");
  result = __real_hsp_map_pick(map, x, y, sight);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_map_get_point(const hsp_map *map, uint32_t edge, double t, hsp_map_point *point);
int32_t __wrap_hsp_map_get_point(const hsp_map *map, uint32_t edge, double t, hsp_map_point *point);
int32_t __wrap_hsp_map_get_point(const hsp_map *map, uint32_t edge, double t, hsp_map_point *point) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_get_point");
  result = __real_hsp_map_get_point(map, edge, t, point);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_map_get_pole(const hsp_map *map, uint32_t face, hsp_map_pole *pole);
int32_t __wrap_hsp_map_get_pole(const hsp_map *map, uint32_t face, hsp_map_pole *pole);
int32_t __wrap_hsp_map_get_pole(const hsp_map *map, uint32_t face, hsp_map_pole *pole) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_get_pole");
  result = __real_hsp_map_get_pole(map, face, pole);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_map_check(hsp_map *map, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_map_check(hsp_map *map, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_map_check(hsp_map *map, uint32_t *invariant, uint32_t *id) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_map_check");
  result = __real_hsp_map_check(map, invariant, id);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_limits_init(hsp_sticks_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_sticks_limits_init(hsp_sticks_limits *limits, uint32_t struct_size, uint32_t balls);
int32_t __wrap_hsp_sticks_limits_init(hsp_sticks_limits *limits, uint32_t struct_size, uint32_t balls) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_limits_init");
  result = __real_hsp_sticks_limits_init(limits, struct_size, balls);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_bytes(const hsp_sticks_limits *limits, size_t *bytes);
int32_t __wrap_hsp_sticks_bytes(const hsp_sticks_limits *limits, size_t *bytes);
int32_t __wrap_hsp_sticks_bytes(const hsp_sticks_limits *limits, size_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_bytes");
  result = __real_hsp_sticks_bytes(limits, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_init(void *memory, size_t bytes, const hsp_sticks_limits *limits, hsp_sticks **sticks);
int32_t __wrap_hsp_sticks_init(void *memory, size_t bytes, const hsp_sticks_limits *limits, hsp_sticks **sticks);
int32_t __wrap_hsp_sticks_init(void *memory, size_t bytes, const hsp_sticks_limits *limits, hsp_sticks **sticks) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_init");
  result = __real_hsp_sticks_init(memory, bytes, limits, sticks);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_compute(hsp_sticks *sticks, const hsp_model *model, const hsp_view_options *options, const
    hsp_stick *stick, uint32_t count, double radius, hsp_sticks_conflict *conflict, hsp_sticks_limits *limits);
int32_t __wrap_hsp_sticks_compute(hsp_sticks *sticks, const hsp_model *model, const hsp_view_options *options, const
    hsp_stick *stick, uint32_t count, double radius, hsp_sticks_conflict *conflict, hsp_sticks_limits *limits);
int32_t __wrap_hsp_sticks_compute(hsp_sticks *sticks, const hsp_model *model, const hsp_view_options *options, const
    hsp_stick *stick, uint32_t count, double radius, hsp_sticks_conflict *conflict, hsp_sticks_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_compute");
  result = __real_hsp_sticks_compute(sticks, model, options, stick, count, radius, conflict, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_compute_map(hsp_sticks *sticks, const hsp_model *model, const hsp_view_options *options, const
    hsp_stick *stick, uint32_t count, double radius, hsp_sticks_conflict *conflict, hsp_sticks_limits *limits);
int32_t __wrap_hsp_sticks_compute_map(hsp_sticks *sticks, const hsp_model *model, const hsp_view_options *options, const
    hsp_stick *stick, uint32_t count, double radius, hsp_sticks_conflict *conflict, hsp_sticks_limits *limits);
int32_t __wrap_hsp_sticks_compute_map(hsp_sticks *sticks, const hsp_model *model, const hsp_view_options *options, const
    hsp_stick *stick, uint32_t count, double radius, hsp_sticks_conflict *conflict, hsp_sticks_limits *limits) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_compute_map");
  result = __real_hsp_sticks_compute_map(sticks, model, options, stick, count, radius, conflict, limits);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_get_info(const hsp_sticks *sticks, hsp_sticks_info *info);
int32_t __wrap_hsp_sticks_get_info(const hsp_sticks *sticks, hsp_sticks_info *info);
int32_t __wrap_hsp_sticks_get_info(const hsp_sticks *sticks, hsp_sticks_info *info) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_get_info");
  result = __real_hsp_sticks_get_info(sticks, info);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_get_map_info(const hsp_sticks *sticks, hsp_map_info *info);
int32_t __wrap_hsp_sticks_get_map_info(const hsp_sticks *sticks, hsp_map_info *info);
int32_t __wrap_hsp_sticks_get_map_info(const hsp_sticks *sticks, hsp_map_info *info) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_get_map_info");
  result = __real_hsp_sticks_get_map_info(sticks, info);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_get_vertices(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_vertex *out);
int32_t __wrap_hsp_sticks_get_vertices(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_vertex *out);
int32_t __wrap_hsp_sticks_get_vertices(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_vertex *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_get_vertices");
  result = __real_hsp_sticks_get_vertices(sticks, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_get_edges(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_edge *out);
int32_t __wrap_hsp_sticks_get_edges(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_edge *out);
int32_t __wrap_hsp_sticks_get_edges(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_edge *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_get_edges");
  result = __real_hsp_sticks_get_edges(sticks, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_get_faces(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_face *out);
int32_t __wrap_hsp_sticks_get_faces(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_face *out);
int32_t __wrap_hsp_sticks_get_faces(const hsp_sticks *sticks, uint32_t first, uint32_t count, hsp_map_face *out) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_get_faces");
  result = __real_hsp_sticks_get_faces(sticks, first, count, out);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_get_areas(const hsp_sticks *sticks, double *area, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_sticks_get_areas(const hsp_sticks *sticks, double *area, uint32_t capacity, uint32_t *needed);
int32_t __wrap_hsp_sticks_get_areas(const hsp_sticks *sticks, double *area, uint32_t capacity, uint32_t *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_get_areas");
  result = __real_hsp_sticks_get_areas(sticks, area, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_pick(const hsp_sticks *sticks, double x, double y, hsp_map_sight *sight);
int32_t __wrap_hsp_sticks_pick(const hsp_sticks *sticks, double x, double y, hsp_map_sight *sight);
int32_t __wrap_hsp_sticks_pick(const hsp_sticks *sticks, double x, double y, hsp_map_sight *sight) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_pick");
  result = __real_hsp_sticks_pick(sticks, x, y, sight);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_get_outline(const hsp_sticks *sticks, uint32_t ball, uint32_t *h, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_sticks_get_outline(const hsp_sticks *sticks, uint32_t ball, uint32_t *h, uint32_t capacity, uint32_t
    *needed);
int32_t __wrap_hsp_sticks_get_outline(const hsp_sticks *sticks, uint32_t ball, uint32_t *h, uint32_t capacity, uint32_t
    *needed) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_get_outline");
  result = __real_hsp_sticks_get_outline(sticks, ball, h, capacity, needed);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_get_point(const hsp_sticks *sticks, uint32_t edge, double t, hsp_map_point *point);
int32_t __wrap_hsp_sticks_get_point(const hsp_sticks *sticks, uint32_t edge, double t, hsp_map_point *point);
int32_t __wrap_hsp_sticks_get_point(const hsp_sticks *sticks, uint32_t edge, double t, hsp_map_point *point) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_get_point");
  result = __real_hsp_sticks_get_point(sticks, edge, t, point);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_get_pole(const hsp_sticks *sticks, uint32_t face, hsp_map_pole *pole);
int32_t __wrap_hsp_sticks_get_pole(const hsp_sticks *sticks, uint32_t face, hsp_map_pole *pole);
int32_t __wrap_hsp_sticks_get_pole(const hsp_sticks *sticks, uint32_t face, hsp_map_pole *pole) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_get_pole");
  result = __real_hsp_sticks_get_pole(sticks, face, pole);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_sticks_check(hsp_sticks *sticks, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_sticks_check(hsp_sticks *sticks, uint32_t *invariant, uint32_t *id);
int32_t __wrap_hsp_sticks_check(hsp_sticks *sticks, uint32_t *invariant, uint32_t *id) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_sticks_check");
  result = __real_hsp_sticks_check(sticks, invariant, id);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_picture_ink_width(double full_width, double gap, double *width);
int32_t __wrap_hsp_picture_ink_width(double full_width, double gap, double *width);
int32_t __wrap_hsp_picture_ink_width(double full_width, double gap, double *width) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_picture_ink_width");
  result = __real_hsp_picture_ink_width(full_width, gap, width);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_picture_fog_share(double nearest, double farthest, double mean_radius, double depth, double *share);
int32_t __wrap_hsp_picture_fog_share(double nearest, double farthest, double mean_radius, double depth, double *share);
int32_t __wrap_hsp_picture_fog_share(double nearest, double farthest, double mean_radius, double depth, double *share) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_picture_fog_share");
  result = __real_hsp_picture_fog_share(nearest, farthest, mean_radius, depth, share);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_picture_options_init(hsp_picture_options *options, uint32_t struct_size);
int32_t __wrap_hsp_picture_options_init(hsp_picture_options *options, uint32_t struct_size);
int32_t __wrap_hsp_picture_options_init(hsp_picture_options *options, uint32_t struct_size) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_picture_options_init");
  result = __real_hsp_picture_options_init(options, struct_size);
  host_call_ends(&call);
  return result;
}

uint32_t __real_hsp_palette_colour(uint32_t palette, uint32_t atomic_number, uint32_t chain);
uint32_t __wrap_hsp_palette_colour(uint32_t palette, uint32_t atomic_number, uint32_t chain);
uint32_t __wrap_hsp_palette_colour(uint32_t palette, uint32_t atomic_number, uint32_t chain) {
  uint32_t result;
  host_call call;
  host_call_begins(&call, "hsp_palette_colour");
  result = __real_hsp_palette_colour(palette, atomic_number, chain);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_picture_write(hsp_view *view, const uint32_t *colour, const hsp_picture_options *options, const char
    *title, const char *description, hsp_sink sink, void *context, uint64_t *bytes);
int32_t __wrap_hsp_picture_write(hsp_view *view, const uint32_t *colour, const hsp_picture_options *options, const char
    *title, const char *description, hsp_sink sink, void *context, uint64_t *bytes);
int32_t __wrap_hsp_picture_write(hsp_view *view, const uint32_t *colour, const hsp_picture_options *options, const char
    *title, const char *description, hsp_sink sink, void *context, uint64_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_picture_write");
  result = __real_hsp_picture_write(view, colour, options, title, description, sink, context, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_picture_write_map(hsp_map *map, const uint32_t *colour, const hsp_picture_options *options, const
    char *title, const char *description, hsp_sink sink, void *context, uint64_t *bytes);
int32_t __wrap_hsp_picture_write_map(hsp_map *map, const uint32_t *colour, const hsp_picture_options *options, const
    char *title, const char *description, hsp_sink sink, void *context, uint64_t *bytes);
int32_t __wrap_hsp_picture_write_map(hsp_map *map, const uint32_t *colour, const hsp_picture_options *options, const
    char *title, const char *description, hsp_sink sink, void *context, uint64_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_picture_write_map");
  result = __real_hsp_picture_write_map(map, colour, options, title, description, sink, context, bytes);
  host_call_ends(&call);
  return result;
}

int32_t __real_hsp_picture_write_sticks(hsp_sticks *sticks, const uint32_t *colour, const hsp_picture_options *options,
    const char *title, const char *description, hsp_sink sink, void *context, uint64_t *bytes);
int32_t __wrap_hsp_picture_write_sticks(hsp_sticks *sticks, const uint32_t *colour, const hsp_picture_options *options,
    const char *title, const char *description, hsp_sink sink, void *context, uint64_t *bytes);
int32_t __wrap_hsp_picture_write_sticks(hsp_sticks *sticks, const uint32_t *colour, const hsp_picture_options *options,
    const char *title, const char *description, hsp_sink sink, void *context, uint64_t *bytes) {
  int32_t result;
  host_call call;
  host_call_begins(&call, "hsp_picture_write_sticks");
  result = __real_hsp_picture_write_sticks(sticks, colour, options, title, description, sink, context, bytes);
  host_call_ends(&call);
  return result;
}
